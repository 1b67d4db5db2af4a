//! The interface between a model and its calibration: values of parameters in, channels out.

use std::fmt;

/// A model of the runs of a study.
pub trait Simulator {
    /// The observed channels of a run, in the order of the study, at the times of its recording; NaN after the end of
    /// the analysis. `values` are the values of all parameters.
    ///
    /// # Errors
    /// The model has no response for these values.
    fn simulate(&mut self, run: usize, values: &[f64]) -> Channels;

    /// The same for several candidates at once.
    fn simulate_all(&mut self, run: usize, values: &[&[f64]]) -> Vec<Channels> {
        values.iter().map(|v| self.simulate(run, v)).collect()
    }
}

/// Simulated channels of a run, or why there are none.
pub(super) type Channels = Result<Vec<Vec<f64>>, SimulationError>;

/// The cause of a failed simulation.
#[derive(Clone, Debug, PartialEq)]
pub enum SimulationError {
    /// The analysis failed.
    Failed(String),
    /// A command of the script was rejected: its message.
    Rejected(String),
    /// The script raised an error of its own: its message.
    Raised(String),
    /// The script exited with a status other than 0.
    Exit(i32),
    /// The run reached a limit: its name.
    TooLong(&'static str),
    /// An observed output was not written, or lacks the column.
    NoOutput(String),
    /// An observed output has numbers that are not finite.
    NotFinite(String),
    /// A tied parameter is outside of its range.
    OutOfRange(String),
    /// The user interrupted.
    Interrupted,
    /// A panic in this program.
    Defect,
}

impl SimulationError {
    /// A text for the kind of error, to count errors by.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Failed(_) => "the analysis failed",
            Self::Rejected(_) => "a command was rejected",
            Self::Raised(_) => "the script raised an error",
            Self::Exit(_) => "the script ended itself",
            Self::TooLong(_) => "it took too long",
            Self::NoOutput(_) => "an output is missing",
            Self::NotFinite(_) => "an output is not finite",
            Self::OutOfRange(_) => "a tied parameter was outside of its range",
            Self::Interrupted => "interrupted",
            Self::Defect => "a defect of this program",
        }
    }
}

impl fmt::Display for SimulationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Failed(why) | Self::Rejected(why) | Self::Raised(why) => write!(f, "{}: {why}", self.kind()),
            Self::NoOutput(which) | Self::NotFinite(which) | Self::OutOfRange(which) => {
                write!(f, "{}: {which}", self.kind())
            }
            Self::Exit(status) => write!(f, "the script ended itself with status {status}"),
            Self::TooLong(what) => write!(f, "it took too long: more than {what}"),
            Self::Interrupted | Self::Defect => f.write_str(self.kind()),
        }
    }
}

impl std::error::Error for SimulationError {}
