//! The verdict: most probable cause, repaired model, and the files that present them.
//!
//! - [`diagnosis`]: the way from a study to its diagnosis
//! - [`conclusion`]: from ranked hypotheses to the verdict and the repair
//! - [`explanation`], `verdict_in_words`: the verdict in words
//! - [`summary`]: the verdict for readers without statistics, from place, sizes and advice
//! - `changed_parameter`: a parameter of the user with another value in one run
//! - `device_loop`: the loop of the device that a verdict is about
//! - `fault_in_words`: faults of channels with their corrections
//! - `gain`: errors before and after a repair, beside the noise of the recordings
//! - `gates`: limits of the probability of a cause by physics, bounds and channels
//! - `held_out_condition`: the condition of a run held out, where fitted runs differ in it
//! - `like_motion`: fitted runs between which neither amplitude nor rate differs
//! - `levels`: storeys, and the elements between them
//! - `learned`, `learned_study`: a learned law where no effect of the library explains the recordings, and without a diagnosis
//! - `plausibility`: balances and published ranges
//! - `presentation`: words, files, loop and drawing of a decision
//! - `recorded_quantities`: what needs no recording any more
//! - `residual_force`: the force that an unknown cause adds, by place and time
//! - [`mismatch`]: windows of time in which the model differs
//! - [`discriminating_test`]: the test that best separates the verdict from its strongest competitor
//! - `structure_drawing`: errors on the structure
//! - `time_of_change`: times at which a parameter changed
//! - `error_conditions`: errors over amplitude, rate and temperature
//! - `result_file`: `diagnosis.json`
//! - `repair`: a repaired model, and the effect that runs held out may refute
//! - `report`: `report.html`

mod advice;
mod all_runs;
mod changed_parameter;
pub(crate) mod conclusion;
pub(crate) mod condition_in_words;
pub(crate) mod device_loop;
pub(crate) mod diagnosis;
pub(crate) mod discriminating_test;
mod error_conditions;
pub(crate) mod explanation;
mod fault_in_words;
mod gain;
mod gates;
mod held_out_condition;
pub(crate) mod learned;
pub(crate) mod learned_study;
mod levels;
mod like_motion;
mod limits_of_none;
pub(crate) mod mismatch;
mod nearest;
pub(crate) mod place;
mod plausibility;
mod presentation;
pub(crate) mod quantity;
mod recorded_quantities;
mod repair;
pub(crate) mod report;
pub(crate) mod residual_force;
pub(crate) mod result_file;
pub(crate) mod structure_drawing;
pub(crate) mod summary;
mod time_of_change;
mod unmoved;
mod verdict_in_words;
