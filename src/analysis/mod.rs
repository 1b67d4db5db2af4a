//! Analyses: the state of the motion, the integrators and algorithms that advance it, and what may go wrong.

pub mod algorithm;
mod asking;
mod convergence;
mod engine;
mod failure;
mod ground_inertia;
pub mod integrator;
mod ladder;
mod loads;
mod matrices;
mod modal_damping;
mod modal_properties;
mod modes;
mod prepared;
mod reactions;
mod state;
mod system;
mod trapezoid;
mod work_counts;

pub use convergence::{Measure, Norm, Test, Verdict};
pub use engine::{Engine, Imbalance, Kind, Observer, Options, Quiet, Setup};
pub use failure::{Cause, Failure};
pub use ladder::{Ladder, Remedy};
pub use matrices::Equations;
pub use modal_properties::{ModalProperties, cumulative};
pub use modes::{Modes, ModesError, Problem, Wanted};
pub use prepared::{PrepareOptions, Prepared, TangentMix};
pub use reactions::ReactionKind;
pub use state::State;
pub use system::{Coefficients, System};
pub use work_counts::WorkCounts;
