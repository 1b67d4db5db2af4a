//! Studies: a script, its parameters, and the recordings that the model is compared with.
//!
//! [`Study::load`] reads `study.toml` and its recordings. A [`Simulator`] gives the response of the model at the times of
//! a recording. [`ScriptSimulator`] runs the script in this process without writing to the disk. [`score`] compares
//! simulated and recorded channels. A [`WorkerPool`] runs several simulations at a time.
//!
//! # Parameters
//! A [`Parameter`] has the name and the range of its `[[parameter]]` in `study.toml`. The free parameters of a
//! [`ParameterSpace`] span a unit cube. Two representations are used throughout, each with one name:
//! - `values`: physical values of all parameters, in the order of the study;
//! - `unit_point`: coordinates of the free parameters in the unit cube, in the order of the study.
//!
//! [`ParameterSpace::values_at`] and [`ParameterSpace::unit_point`] convert between them.

mod cached_files;
mod channel;
mod checks;
mod draft;
mod initial_run;
mod load;
mod loop_measure;
mod material;
mod parameter;
mod run;
mod score;
mod script_errors;
mod script_simulator;
mod side_by_side;
mod simulator;
mod standalone;
mod study_file;
mod trace;
mod unknown_key;
mod worker_pool;

pub use draft::draft_study;
pub use hysteron_recordings::unit;
pub use hysteron_recordings::{Column, Recording};
pub use initial_run::{InitialRun, RunLimits};
pub use load::{CalibrationOptions, Rig, Study, StudyError};
pub use loop_measure::{LoopMeasure, LoopQuantity};
pub use material::DeviceMaterial;
pub use parameter::{OutOfRange, Parameter, ParameterKind, ParameterRange, ParameterSpace, Scale};
pub use run::{ObservedChannel, Role, Run, Setting};
pub use score::{Score, ScoredRun, objective, score, simulate_and_score, simulate_and_score_all};
pub use script_simulator::{ScriptSimulator, SimulatorFactory};
pub use simulator::{SimulationError, Simulator};
pub use standalone::standalone_script;
pub use trace::Trace;
pub use unknown_key::UnknownKey;
pub use worker_pool::WorkerPool;
