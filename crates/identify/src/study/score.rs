//! How well a model follows a recording.

use super::load::Study;
use super::run::{Observe, Role};
use super::simulator::{Mishap, Simulator};

/// How well a channel is followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Mean squared error over the variance of the recorded channel (Eq 7 of the paper), a fraction.
    pub nmse: f64,
    /// Samples compared.
    pub samples: usize,
    /// Samples left out because the analysis had ended.
    pub dropped: usize,
}

/// A run as the model has it, and how well it follows the recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Simulated channels at the times of the recording; NaN where the analysis had ended.
    pub channels: Vec<Vec<f64>>,
    /// Their scores.
    pub scores: Vec<Score>,
}

impl Fit {
    /// Mean over the channels of the NMSE of each, times its weight.
    pub fn nmse(&self, observed: &[Observe]) -> f64 {
        let sum: f64 = self.scores.iter().zip(observed).map(|(s, o)| o.weight * s.nmse).sum();
        sum / self.scores.len() as f64
    }
}

/// Compare a simulated channel with the recorded one. Missing samples are left out.
pub fn score(simulated: &[f64], observed: &Observe) -> Score {
    let (mut sum, mut samples, mut dropped) = (0.0, 0usize, 0);
    for (num, exp) in simulated.iter().zip(&observed.values).filter(|(_, exp)| !exp.is_nan()) {
        if num.is_nan() {
            dropped += 1;
        } else {
            sum += (num - exp) * (num - exp);
            samples += 1;
        }
    }
    Score { nmse: sum / samples as f64 / observed.variance, samples, dropped }
}

/// Simulate a run and compare it with its recording.
///
/// # Errors
/// The model has no answer, or none that can be compared.
pub fn fit(simulator: &mut dyn Simulator, study: &Study, run: usize, values: &[f64]) -> Result<Fit, Mishap> {
    let channels = simulator.simulate(run, values)?;
    let run = &study.runs[run];
    let scores: Vec<Score> = channels.iter().zip(&run.observe).map(|(c, o)| score(c, o)).collect();
    for (s, o) in scores.iter().zip(&run.observe) {
        if s.samples == 0 {
            let message = format!("the analysis ends before the first sample of {} in {}", o.channel, run.name);
            return Err(Mishap::NoOutput(message));
        }
        if !s.nmse.is_finite() {
            return Err(Mishap::NotFinite(format!("{} in {}", o.channel, run.name)));
        }
    }
    Ok(Fit { channels, scores })
}

/// Mean over all channels of all runs of the role `fit`, of the NMSE of each times its weight. `fits` are those of these
/// runs, in the order of the study.
pub fn objective(study: &Study, fits: &[&Fit]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let (mut sum, mut count) = (0.0, 0);
    for (run, fit) in runs.zip(fits) {
        for (o, s) in run.observe.iter().zip(&fit.scores) {
            sum += o.weight * s.nmse;
            count += 1;
        }
    }
    sum / f64::from(count)
}
