//! Calibration: the parameters of a model that follow recordings best, their uncertainty, and the error that is left.
//!
//! A [`Problem`] evaluates the objective at points of the unit cube; [`StudyProblem`] is that of a study. [`search`] looks
//! for the least objective with the method of the [`SearchSettings`]. [`Uncertainty`], [`Profile`] and [`Posterior`] are
//! three estimates of the uncertainty of the parameters.

mod amplitude_groups;
mod judgement;
mod method;
mod page;
mod posterior;
mod problem;
mod profile;
mod result;
mod result_file;
mod search;
mod settings;
mod structure;
mod uncertainty;

pub use crate::report::{significant, with_half_width};
pub use amplitude_groups::{AmplitudeGroup, amplitude_groups};
pub use judgement::{HoldoutRatio, Judgement, NoiseComparison, StructuredChannel};
pub use method::{
    CmaEs, Crossover, DifferentialEvolution, EvolutionSettings, LevenbergMarquardt, Method, MethodState, Shade,
    ShadeVariant, StepSearch, Trial,
};
pub use page::page;
pub use posterior::{Posterior, Quantiles, posterior};
pub use problem::{Evaluation, Problem, StudyProblem};
pub use profile::{Profile, profiles};
pub use result::{CalibrationResult, Displacements, RepeatStatistics};
pub use search::{
    Checkpoint, NoObserver, Repeat, SearchObserver, SearchResult, SearchStatus, Stage, StopReason, search,
};
pub use settings::{SearchMethod, SearchSettings};
pub use uncertainty::{Interval, RunUncertainty, Uncertainty, autocorrelation_time, uncertainty};
