//! Checks of the channels of a study before anything is fitted.
//!
//! A channel with the wrong sign, unit or clock spoils each fit, and a diagnosis takes it for physics. [`preflight`] runs
//! the script with its own values and at points spread over the ranges of the parameters. A fault is found if it explains
//! a channel at one of these points, and nothing explains the channel without it. A factor that the parameters can make
//! within their ranges is none, and a delay must be the only one that explains the channel.

mod alternatives;
mod compare;
mod lag;
mod motions;
mod points;
mod repeated_runs;
mod text;
mod unit_ratio;

pub use text::section;

use crate::report::html;
use crate::study::{InitialRun, ScriptSimulator, SimulatorFactory};
use alternatives::ChannelFaults;
use points::{PointSettings, SimulatedPoints};
use serde::Serialize;

/// Comparison of a recorded channel with the simulated one. The script has its own values.
#[derive(Clone, Debug, Serialize)]
pub struct ChannelCheck {
    /// Name of the run.
    pub run: String,
    /// Column of the recording.
    pub channel: String,
    /// Number of samples compared.
    pub samples: usize,
    /// Number of missing samples.
    pub missing: usize,
    /// Number of samples after the end of the analysis.
    pub dropped: usize,
    /// Mean squared error over the variance of the recorded channel.
    pub nmse: f64,
    /// Correlation coefficient of the recorded and the simulated channel.
    pub correlation: f64,
    /// Least-squares factor: recorded ≈ factor × simulated + offset.
    pub factor: f64,
    /// Least-squares offset, in the unit of the channel.
    pub offset: f64,
    /// Delay of the recorded channel with the largest correlation, s.
    pub lag_s: f64,
    /// Work of the recorded and of the simulated force over the displacement of the run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub work: Option<[f64; 2]>,
}

/// A kind of mistake in a channel or a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FindingKind {
    /// The channel has the other sign.
    Sign,
    /// The channel is in another unit than the model.
    Unit,
    /// The channel is late or early.
    Lag,
    /// Two channels are exchanged.
    Swapped,
    /// One of the recorded and the simulated acceleration is absolute, the other relative to the ground.
    Acceleration,
    /// The loops of the recorded force supply energy.
    Energy,
    /// The recorded motion of the input is not the imposed one.
    Input,
    /// A recorded motion of the input is not imposed at all.
    UnseenInput,
    /// Two channels have the same samples.
    Duplicate,
    /// Samples lie after the end of the analysis.
    AfterAnalysis,
    /// The model explains less of the channel than its mean does.
    Unexplained,
}

/// A finding about a channel or a recording.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// Kind of mistake.
    pub kind: FindingKind,
    /// A diagnosis would take the mistake for physics, and does not begin.
    pub is_hard: bool,
    /// Column of the recording.
    pub channel: String,
    /// Names of the runs.
    pub runs: Vec<String>,
    /// Factor of the recorded on the simulated channel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// Delay of the recorded channel, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lag_s: Option<f64>,
    /// The finding in words, with its numbers.
    pub message: String,
    /// A change of the study that removes the mistake.
    pub help: String,
}

/// A run without a response.
#[derive(Clone, Debug, Serialize)]
pub struct RunFailure {
    /// Name of the run.
    pub run: String,
    /// The error.
    pub message: String,
}

/// Result of the checks of a study.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Preflight {
    /// Comparisons, by run and channel. A run whose script fails with its own values has none.
    pub channels: Vec<ChannelCheck>,
    /// Runs in which the script fails with its own values.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failures: Vec<RunFailure>,
    /// Findings, the hard ones first.
    pub findings: Vec<Finding>,
}

impl Preflight {
    /// Returns true if a finding is hard.
    pub fn has_hard_findings(&self) -> bool {
        self.findings.iter().any(|f| f.is_hard)
    }

    /// A section of a report; empty without findings.
    pub fn html(&self) -> String {
        if self.findings.is_empty() {
            return String::new();
        }
        let lines = self
            .findings
            .iter()
            .map(|f| format!("<li>{} {}</li>\n", html::escaped(&f.message), html::escaped(&f.help)));
        format!("<h2>Before the fit</h2>\n<ul>\n{}</ul>\n", lines.collect::<String>())
    }
}

/// Check the channels of a study whose script has made its initial run.
///
/// # Errors
/// The threads could not be started.
pub fn preflight(simulator: &ScriptSimulator, initial_run: &InitialRun, threads: usize) -> std::io::Result<Preflight> {
    let factory: SimulatorFactory = simulator.factory();
    let study = simulator.study();
    let motions: Vec<_> = (0..study.runs.len()).map(|r| motions::imposed(simulator, r, initial_run)).collect();
    let points =
        SimulatedPoints::new(study, &factory, initial_run, PointSettings::of(study, initial_run, &motions), threads)?;
    let mut result = Preflight::default();
    let mut simulated = vec![];
    for (number, run) in study.runs.iter().enumerate() {
        let own = points.own(number);
        if let Err(error) = own {
            result.failures.push(RunFailure { run: run.name.clone(), message: error.to_string() });
        }
        if let Ok(simulated) = own {
            let displacement = simulator.displacement(number, &points.own_values);
            let u = displacement.as_ref().map(|(_, u)| u.as_slice());
            result.channels.extend(run.observe.iter().zip(simulated).map(|(o, y)| compare::channel(run, o, y, u)));
        }
        let sizes = points.reachable_sizes(number);
        result.findings.extend(ChannelFaults::new(run, &points.of_run(number), &sizes, &motions[number]).findings());
        result.findings.extend(motions::findings(run, &motions[number]));
        simulated.push(own.ok());
    }
    let of_pairs = repeated_runs::findings(study, &simulated, &mut result.findings);
    result.findings.extend(of_pairs);
    result.findings.extend(compare::findings(study, &result.channels, &result.findings));
    result.findings = text::merged(result.findings, study);
    Ok(result)
}
