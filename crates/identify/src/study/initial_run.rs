//! The first run of a script, with its own values of the parameters.

use super::simulator::SimulationError;
use hysteron_tcl::diagnostic::Diagnostic;
use std::time::Duration;

/// Limits of one run of a script. Commands and steps give the same limit on any machine; the time is the last resort.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunLimits {
    /// Commands of the script.
    pub commands: u64,
    /// Steps of its analyses.
    pub steps: u64,
    /// Wall-clock time.
    pub time: Duration,
}

impl RunLimits {
    /// Limits of a script that has not run yet.
    pub const UNKNOWN: Self = Self { commands: 2_000_000_000, steps: 200_000_000, time: Duration::from_secs(600) };

    /// Least limit of time.
    const MIN_TIME: Duration = Duration::from_secs(60);

    /// Commands, and steps, of a run over those of the first run.
    const MARGIN: u64 = 50;
    /// Steps that a run may take beyond those.
    const MORE_STEPS: u64 = 1_000;

    /// Limits from the commands and steps of the first run. Values that converge badly take more of both, but not 50 times.
    pub(super) fn from_first_run(commands: u64, steps: u64, time: Duration) -> Self {
        let (commands, steps) = (Self::MARGIN * commands + 10_000, Self::MARGIN * steps + Self::MORE_STEPS);
        Self { commands, steps, time: time.max(Self::MIN_TIME) }
    }

    /// Steps of the first run.
    pub(crate) fn first_steps(&self) -> u64 {
        self.steps.saturating_sub(Self::MORE_STEPS) / Self::MARGIN
    }
}

/// Results of the first run of a script.
#[derive(Debug)]
pub struct InitialRun {
    /// Values of the script itself for the parameters of the study, in its order; NaN where it gives none.
    pub values: Vec<f64>,
    /// Byte ranges of these values in the script; `None` where another file, or none, gives the value.
    pub value_spans: Vec<Option<(usize, usize)>>,
    /// Warnings of the script, each once. Their texts are in the source map of the run.
    pub warnings: Vec<Diagnostic>,
    /// The error of the script with its own values, if it fails.
    pub failure: Option<SimulationError>,
    /// Limits of the runs that follow, by run of the study.
    pub limits: Vec<RunLimits>,
}
