//! Analyses: the state of the motion, the integrators and algorithms that advance it, and what may go wrong.

pub mod algorithm;
mod convergence;
mod engine;
mod failure;
mod ground_inertia;
pub mod integrator;
mod loads;
mod matrices;
mod modal_damping;
mod modal_properties;
mod modes;
mod opensees;
mod plausibility;
mod reactions;
mod recovery;
mod saved_state;
mod state;
mod system;
mod two_end_residual;
mod work_counts;
mod workspace;

pub use convergence::{Measure, Norm, Test, TestOutcome};
pub use engine::{Engine, Imbalance, Kind, Observer, Options, Quiet, Setup};
pub use failure::{Cause, Failure};
pub use matrices::Equations;
pub use modal_properties::{ModalProperties, cumulative};
pub use plausibility::{ElementPower, LooseConstraint};
pub use modes::{Modes, ModesError, Problem, Wanted};
pub use reactions::ReactionKind;
pub use recovery::{RecoveryStep, RecoveryStrategy};
pub use saved_state::SavedState;
pub use state::State;
pub use system::{Coefficients, System};
pub use work_counts::WorkCounts;
pub use workspace::{PrepareOptions, TangentMix, Workspace};
