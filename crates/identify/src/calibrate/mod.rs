//! Calibration: the parameters of a model that follow recordings best, how sure they are, and how good that is.
//!
//! A [`Problem`] gives the score of points of the unit cube; that of a study is [`StudyProblem`]. [`search`] looks for
//! the best point with the method that a [`Plan`] names; [`Uncertainty`] says what the data determine.

mod amplitude;
mod method;
mod page;
mod plan;
mod posterior;
mod problem;
mod profile;
mod result;
mod search;
mod uncertainty;

pub use amplitude::{Amplitude, amplitudes};
pub use method::{
    CmaEs, Crossover, Differential, Evolution, LevenbergMarquardt, Method, Search, Shade, Trial, Variant,
};
pub use page::page;
pub use plan::{Plan, Strategy};
pub use posterior::{Posterior, Quantiles, posterior};
pub use problem::{Evaluated, Problem, StudyProblem};
pub use profile::{Profile, profiles};
pub use result::{Calibrated, Displacements, Spread};
pub use search::{Checkpoint, Outcome, Repeat, Silent, Status, Watch, search};
pub use uncertainty::{Alone, Interval, Uncertainty, autocorrelation_time, uncertainty};
