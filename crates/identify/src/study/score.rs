//! Comparison of a simulated run with its recording.

use super::load::Study;
use super::run::{ObservedChannel, Role, Run};
use super::simulator::{SimulationError, Simulator};

/// Error of a simulated channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Normalised mean squared error: mean squared error over the variance of the recorded channel (Eq 7 of the paper).
    pub nmse: f64,
    /// Number of samples compared.
    pub samples: usize,
    /// Number of samples left out because the analysis had ended.
    pub dropped: usize,
}

/// A simulated run with the scores of its channels.
#[derive(Clone, Debug, PartialEq)]
pub struct ScoredRun {
    /// Simulated channels at the times of the recording; NaN after the end of the analysis.
    pub channels: Vec<Vec<f64>>,
    /// Scores of the channels, in the same order.
    pub scores: Vec<Score>,
}

impl ScoredRun {
    /// Weighted mean of the NMSE: Σ weight × NMSE over the number of channels.
    pub fn nmse(&self, observed: &[ObservedChannel]) -> f64 {
        let sum: f64 = self.scores.iter().zip(observed).map(|(s, o)| o.weight * s.nmse).sum();
        sum / self.scores.len() as f64
    }
}

/// Compare a simulated channel with the recorded one. Missing samples are left out.
pub fn score(simulated: &[f64], observed: &ObservedChannel) -> Score {
    let (mut sum, mut samples, mut dropped) = (0.0, 0usize, 0);
    for (y, v) in simulated.iter().zip(&observed.values).filter(|(_, v)| !v.is_nan()) {
        if y.is_nan() {
            dropped += 1;
        } else {
            sum += (y - v) * (y - v);
            samples += 1;
        }
    }
    Score { nmse: sum / samples as f64 / observed.variance, samples, dropped }
}

/// Simulate a run and compare it with its recording.
///
/// # Errors
/// The simulation fails, ends before the first sample of a channel, or has a score that is not finite.
pub fn simulate_and_score(
    simulator: &mut dyn Simulator,
    study: &Study,
    run: usize,
    values: &[f64],
) -> Result<ScoredRun, SimulationError> {
    score_channels(simulator.simulate(run, values)?, &study.runs[run])
}

/// Simulate a run for several candidates and compare each with the recording.
/// The errors are those of [`simulate_and_score`].
pub fn simulate_and_score_all(
    simulator: &mut dyn Simulator,
    study: &Study,
    run: usize,
    values: &[&[f64]],
) -> Vec<Result<ScoredRun, SimulationError>> {
    let all = simulator.simulate_all(run, values);
    all.into_iter().map(|channels| score_channels(channels?, &study.runs[run])).collect()
}

/// Compare the simulated channels of a run with its recording.
fn score_channels(channels: Vec<Vec<f64>>, run: &Run) -> Result<ScoredRun, SimulationError> {
    let scores: Vec<Score> = channels.iter().zip(&run.observe).map(|(c, o)| score(c, o)).collect();
    for (s, o) in scores.iter().zip(&run.observe) {
        if s.samples == 0 {
            let message = format!("the analysis ends before the first sample of {} in {}", o.channel, run.name);
            return Err(SimulationError::NoOutput(message));
        }
        if !s.nmse.is_finite() {
            return Err(SimulationError::NotFinite(format!("{} in {}", o.channel, run.name)));
        }
    }
    Ok(ScoredRun { channels, scores })
}

/// Objective of the calibration: mean of weight × NMSE over all channels of all runs with the role `fit`.
/// `scored` are these runs in the order of the study.
pub fn objective(study: &Study, scored: &[&ScoredRun]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let (mut sum, mut count) = (0.0, 0);
    for (run, scored_run) in runs.zip(scored) {
        for (o, s) in run.observe.iter().zip(&scored_run.scores) {
            sum += o.weight * s.nmse;
            count += 1;
        }
    }
    sum / f64::from(count)
}
