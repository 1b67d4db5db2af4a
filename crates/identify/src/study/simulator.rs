//! What a calibration knows of a model: numbers in, numbers out.

use std::fmt;

/// A model of the runs of a study.
pub trait Simulator {
    /// The observed channels of a run, in the order of the study, at the times of its recording; NaN after the end of
    /// the analysis. `values` are those of all parameters, in the order of the study.
    ///
    /// # Errors
    /// Why there is no answer.
    fn simulate(&mut self, run: usize, values: &[f64]) -> Result<Vec<Vec<f64>>, Mishap>;
}

/// Why the model has no answer for some values of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum Mishap {
    /// The analysis failed.
    Failed(String),
    /// The script rejected the values: what it said.
    Rejected(String),
    /// The script ended with an error of its own.
    Raised(String),
    /// The script ended itself with a status other than 0.
    Exit(i32),
    /// It took too long: what was used up.
    TooLong(&'static str),
    /// An observed output was not written, or has not the column.
    NoOutput(String),
    /// An observed output has numbers that are not finite.
    NotFinite(String),
    /// A tied parameter is outside of its range.
    Outside(String),
    /// The user interrupted.
    Interrupted,
    /// A defect of this program.
    Defect,
}

impl Mishap {
    /// What kind of mishap it is, to count them.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Failed(_) => "the analysis failed",
            Self::Rejected(_) => "a command was rejected",
            Self::Raised(_) => "the script raised an error",
            Self::Exit(_) => "the script ended itself",
            Self::TooLong(_) => "it took too long",
            Self::NoOutput(_) => "an output is missing",
            Self::NotFinite(_) => "an output is not finite",
            Self::Outside(_) => "a tied parameter was outside of its range",
            Self::Interrupted => "interrupted",
            Self::Defect => "a defect of this program",
        }
    }
}

impl fmt::Display for Mishap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Failed(why) | Self::Rejected(why) | Self::Raised(why) => write!(f, "{}: {why}", self.kind()),
            Self::NoOutput(which) | Self::NotFinite(which) | Self::Outside(which) => {
                write!(f, "{}: {which}", self.kind())
            }
            Self::Exit(status) => write!(f, "the script ended itself with status {status}"),
            Self::TooLong(what) => write!(f, "it took too long: more than {what}"),
            Self::Interrupted | Self::Defect => f.write_str(self.kind()),
        }
    }
}

impl std::error::Error for Mishap {}
