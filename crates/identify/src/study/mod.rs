//! Studies: a script, the recordings that it is to follow, and the parameters that are to be found.
//!
//! [`Study::load`] reads `study.toml` and its recordings. A [`Simulator`] gives what the model says at the times of a
//! recording; [`ScriptSimulator`] is the one that runs the script, in this process and without touching the disk, and a
//! [`WorkerPool`] runs several of them at a time. [`score`] compares the two.

mod file;
mod files;
mod load;
mod parameter;
mod recording;
mod run;
mod score;
mod script;
mod simulator;
mod trace;
mod worker_pool;

pub use load::{Calibration, Rejected, Rig, Study};
pub use parameter::{Outside, Parameter, Range, Scale, Source, Space};
pub use recording::{Column, Recording};
pub use run::{Observe, Role, Run, Setting};
pub use score::{Fit, Score, fit, objective, score};
pub use script::{Blueprint, Limits, Opening, ScriptSimulator};
pub use simulator::{Mishap, Simulator};
pub use trace::Trace;
pub use worker_pool::WorkerPool;
