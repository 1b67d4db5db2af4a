//! What a program that runs scripts asks of a run, and is told of it.

use crate::Tcl;
use hysteron_engine::analysis::Engine;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};

/// Purpose of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Run: compute the results.
    Run,
    /// Check: find mistakes; analyses are passed over.
    Check,
}

/// Receiver of the progress of an analysis.
pub trait Progress {
    /// A step has been committed at this time; `end` is the time at which the excitation ends, where that is known.
    fn step(&mut self, time: f64, end: Option<f64>);
}

/// Receiver of the motion of a model, for programs that show it.
pub trait MotionObserver {
    /// An analysis begins with the committed state.
    fn start(&mut self, engine: &Engine);
    /// A step has been committed.
    fn step(&mut self, engine: &Engine);
    /// The script is about to forget the model.
    fn wipe(&mut self, engine: &mut Engine);
}

/// Is called before the first step of the first transient analysis of a script.
pub type BeforeTransient = Box<dyn FnOnce(&mut Tcl) -> Result<(), Exception>>;

/// Is called with each warning when it comes up.
pub type OnWarning = Box<dyn FnMut(&Diagnostic, &SourceMap)>;
