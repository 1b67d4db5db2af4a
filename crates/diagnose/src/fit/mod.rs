//! Fits of variants to the fitted runs, from many starts to few and precise ones.
//!
//! - [`search_settings`]: every number that only steers the search
//! - [`job`]: tasks for a variant, and their results
//! - [`evaluator`], [`evaluator_pool`]: their execution on several threads
//! - [`checkpoint`]: cache of results, from which an interrupted diagnosis resumes
//! - [`scheduler`]: batches of jobs with progress, cancellation and the cache
//! - [`fitted`]: hypotheses after screening and after fitting
//! - [`halton_points`]: start points
//! - [`projection`]: parameters that follow by their derivatives
//! - [`linearized`]: a fit near its optimum
//! - [`baseline`]: the user's model
//! - [`screening`]: the first round over all proposals
//! - [`alternative_forms`]: neighbouring and extended forms of the leading causes
//! - [`global_search`]: searches from the whole range
//! - [`refit_competitors`]: repeated searches for look-alikes of the best hypothesis
//! - [`two_effect_search`]: pairs of effects
//! - [`step_error`]: error of the time steps
//! - [`unmoved_channels`]: channels that no proposal changes
//! - [`unread_parameters`]: the user's parameters that a whole law does not read
//! - [`phenomena`]: phenomena of a whole law, switched off one at a time

pub(crate) mod alternative_forms;
pub(crate) mod baseline;
pub(crate) mod checkpoint;
pub(crate) mod evaluator;
pub(crate) mod evaluator_pool;
pub(crate) mod fitted;
pub(crate) mod global_search;
pub(crate) mod halton_points;
pub(crate) mod job;
pub(crate) mod linearized;
pub(crate) mod phenomena;
pub(crate) mod projection;
pub(crate) mod refit_competitors;
pub(crate) mod scheduler;
pub(crate) mod screening;
pub(crate) mod search_settings;
pub(crate) mod step_error;
pub(crate) mod two_effect_search;
pub(crate) mod unmoved_channels;
pub(crate) mod unread_parameters;
