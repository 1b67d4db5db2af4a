//! Diagnosis: why a model and its recordings differ.
//!
//! [`diagnose`] fits the user's model and proposes missing effects ([`hypothesis`]). It fits every proposal as an edit of the
//! script or as a fault of a channel. It ranks them by their predictions for blocks of time that they were not fitted to. The
//! verdict names the cause, or says that the model is complete or that the cause is unknown. Runs held out judge the repair at the end.
//!
//! Rooms, each of which uses only those before it:
//!
//! - `prior`: every number that the verdict depends on
//! - `series`: elementary statistics
//! - `inspect`: the model and its recordings before any fit
//! - `memory`: competition of laws that differ in what they remember
//! - `candidate`: edits of the script and faults of channels
//! - [`hypothesis`]: proposals, one cause a file
//! - `residual`: structure of residuals
//! - `fit`: fits, from many starts to few
//! - `evidence`: likelihood, ranking, bootstrap and probabilities
//! - `verdict`: verdict, repair and files

#![forbid(unsafe_code)]

mod candidate;
mod evidence;
mod fit;
pub mod hypothesis;
mod inspect;
mod memory;
mod prior;
mod residual;
mod series;
#[cfg(test)]
mod test_support;
mod verdict;

pub use candidate::channel_fault::ChannelFault;
pub use evidence::holdout::HeldOutErrors;
pub use evidence::memory_evidence::RecordedEvidence;
pub use evidence::parametric_bootstrap::{BootstrapResult, EqualGain};
pub use evidence::verdict_evidence::{HypothesisEvidence, RepairEvidence, VerdictEvidence};
pub use evidence::verdict_model;
pub use fit::checkpoint::{CheckpointEntry, identity};
pub use fit::scheduler::ProgressMonitor;
pub use memory::competition::FamilyResult;
pub use memory::family::Family;
pub use memory::learning::Learned;
pub use prior::PriorNumber;
pub use verdict::condition_in_words::TimeSpan;
pub use verdict::device_loop::DeviceLoop;
pub use verdict::diagnosis::{Diagnosis, RankedHypothesis, Settings, diagnose};
pub use verdict::discriminating_test::DiscriminatingTest;
pub use verdict::learned::LearnedModel;
pub use verdict::learned_study::{LearnedStudy, learn_law};
pub use verdict::place::{NodePlace, Place};
pub use verdict::quantity::EffectSize;
pub use verdict::report::report;
pub use verdict::residual_force::{ResidualForce, ResidualPart};
pub use verdict::result_file::{Baseline, Candidate, Mismatch, Outcome, RepairedModel, UnmovedChannel, Verdict};
pub use verdict::summary::Summary;
