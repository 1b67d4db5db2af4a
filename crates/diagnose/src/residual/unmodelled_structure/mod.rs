//! Structure that a fit leaves in the residuals of all channels.

use super::bursts::burst_share;
use super::motion_regressors::motion_regressors;
use super::recurrence::StrokeCells;
use super::regression::explained_share;
use super::spectral_lines::line_share;
use super::surrogates::{follows_motion, recurs_along, silent_share, unsteady_share};
use crate::inspect::response::ResponseRanges;
use crate::prior::{
    BURST_NOISE_ORDER, CHANNEL_SHIFTS, MIN_CONSTANT_VARIANCE, MIN_SHARED_STRUCTURE, NEGLIGIBLE_RESIDUAL,
    REGRESSION_DEVICES, RESIDUAL_SHIFTS, SAMPLES_PER_REGRESSOR, SINGULAR_VARIANCE_FIT, STRUCTURE_BLOCKS,
    STRUCTURE_NOISE_ORDER, STRUCTURE_POINTS, VARIANCE_FIT_STEPS,
};
use crate::series::{averaged, power};
use hysteron_identify::autoregressive::{burg, whiten};
use hysteron_identify::study::{ObservedChannel, Role, Run, ScoredRun, Study};
use std::collections::BTreeMap;

/// Structure of a residual that no steady noise has.
#[derive(Clone, Debug, Default)]
pub(crate) struct UnmodelledStructure {
    /// Largest structured share of the residual power of a channel; 0 without structure.
    pub(crate) share: f64,
    /// Kind of structure and channel, in words.
    pub(crate) description: String,
    /// Largest share of each kind over the channels; kinds without structure are left out.
    pub(crate) by_kind: BTreeMap<&'static str, f64>,
    /// Channels whose residual is louder at some times than at others, and neither follows the motion, nor comes again, nor is
    /// shared by other channels. That is noise of the sensor, and no physics.
    pub(crate) unsteady_channels: Vec<String>,
}

impl UnmodelledStructure {
    /// Adds other structure of the same residuals.
    pub(crate) fn join(&mut self, other: Self) {
        for (kind, share) in other.by_kind {
            self.consider(kind, share, other.description.clone());
        }
        let new =
            other.unsteady_channels.into_iter().filter(|c| !self.unsteady_channels.contains(c)).collect::<Vec<_>>();
        self.unsteady_channels.extend(new);
    }

    /// Keeps the larger share; of equal ones the first.
    fn consider(&mut self, kind: &'static str, share: f64, description: String) {
        if share > 0.0 {
            let largest = self.by_kind.entry(kind).or_default();
            *largest = largest.max(share);
        }
        if share > self.share {
            self.share = share;
            self.description = description;
        }
    }
}

/// Differences of samples over their range that are round-off.
const ROUND_OFF: f64 = 1e-9;
/// Difference from a whole number of steps that counts as none.
const STEP_TOLERANCE: f64 = 0.01;

/// Kinds of structure that are loudness alone.
const LOUDNESS_KINDS: [&str; 3] = ["silence", "bursts", "unsteady"];

/// A run with its residuals and the motion of its devices.
struct RunResiduals<'a> {
    run: &'a Run,
    fit: &'a ScoredRun,
    /// Residuals of the channels at all samples.
    residuals: Vec<Vec<f64>>,
    /// The same, averaged to at most [`STRUCTURE_POINTS`] points.
    averaged: Vec<Vec<f64>>,
    motion: Vec<Vec<f64>>,
    strokes: Vec<StrokeCells>,
}

/// Structure that a model leaves in the fitted runs. `fits` are these runs, in their order.
///
/// A law of another form leaves a residual that recurs along the stroke, and silence where nothing moves. Both count only for
/// the `complete_model`, which should leave noise alone.
pub(crate) fn unmodelled_structure(
    study: &Study,
    responses: &ResponseRanges,
    fits: &[ScoredRun],
    complete_model: bool,
) -> UnmodelledStructure {
    let mut found = UnmodelledStructure::default();
    for ((number, run), fit) in study.runs_of(Role::Fit).zip(fits) {
        let residuals = residuals(run, fit);
        let averaged = residuals.iter().map(|r| averaged(r, STRUCTURE_POINTS)).collect();
        let motion = motion_regressors(responses, number);
        let run = RunResiduals { run, fit, residuals, averaged, motion, strokes: strokes(responses, number) };
        for channel in 0..run.run.observe.len().min(fit.channels.len()) {
            run.channel_structure(channel, complete_model, &mut found);
        }
    }
    found
}

impl RunResiduals<'_> {
    /// Adds the structure of one channel.
    fn channel_structure(&self, channel: usize, complete_model: bool, found: &mut UnmodelledStructure) {
        let (observe, residual) = (&self.run.observe[channel], &self.residuals[channel]);
        let simulated: Vec<f64> = self.fit.channels[channel].iter().map(|y| finite_or_zero(*y)).collect();
        let points = &self.averaged[channel];
        let noise = burg(points, STRUCTURE_NOISE_ORDER);
        let weight = significance(residual, observe);
        let name = &observe.channel;
        let motion = self.motion_share(&simulated, points, &noise);
        let recurrence =
            if complete_model { StrokeCells::recurrence_along_stroke } else { StrokeCells::recurrence_within_stroke };
        let recurrence = recurs_along(points, &self.strokes, recurrence);
        let common = common_share(&self.averaged, channel, &noise);
        // The loudness of a residual alone is no physics: a machine nearby or a bad plug has it too.
        let is_physics = motion.max(recurrence).max(common) > MIN_SHARED_STRUCTURE;
        let mut is_unsteady = false;
        let mut consider = |kind, share: f64, description: String| {
            let of_loudness = LOUDNESS_KINDS.contains(&kind);
            is_unsteady |= of_loudness && !is_physics && weight * share > MIN_SHARED_STRUCTURE;
            if is_physics || !of_loudness {
                found.consider(kind, weight * share, description);
            }
        };
        consider("motion", motion, format!("part of the residual of {name} follows the motion"));
        consider("recurrence", recurrence, recurrence_description(observe));
        // Sensor noise may grow with the reading, which is neither silence nor unsteadiness nor a burst.
        let steady = if complete_model {
            variance_normalised(points, &averaged(&simulated, STRUCTURE_POINTS))
        } else {
            points.clone()
        };
        if complete_model {
            consider(
                "silence",
                silent_share(&steady),
                format!("the residual of {name} is silent at some times, as no steady noise"),
            );
        }
        let (line, frequency) = line_share(residual, &simulated);
        let times = &self.run.recording.times;
        let rate = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
        consider("line", line, format!("the residual of {name} has a line at {:.3} Hz", frequency * rate));
        let loud = if complete_model { variance_normalised(residual, &simulated) } else { residual.clone() };
        let burst = burst_share(&innovations(&loud), &innovations(&simulated));
        consider("bursts", burst, format!("the residual of {name} comes in bursts"));
        consider(
            "unsteady",
            unsteady_share(&steady),
            format!("the residual of {name} is louder at some times than steady noise"),
        );
        consider("common", common, format!("the residual of {name} moves with those of other channels"));
        if is_unsteady && !found.unsteady_channels.contains(name) {
            found.unsteady_channels.push(name.clone());
        }
    }

    /// Share of a residual that the motion and the channel itself predict, in innovations or beyond surrogates.
    fn motion_share(&self, simulated: &[f64], points: &[f64], noise: &[f64]) -> f64 {
        let channel = averaged(simulated, STRUCTURE_POINTS);
        let columns: Vec<Vec<f64>> = CHANNEL_SHIFTS
            .iter()
            .map(|s| shifted(&channel, *s))
            .chain(self.motion.iter().map(|m| averaged(m, STRUCTURE_POINTS)))
            .take(points.len() / SAMPLES_PER_REGRESSOR)
            .collect();
        // Slow noise correlates with every slow regressor, so that both sides are whitened. Whitening hides smooth effects in
        // white noise, so that surrogates of the plain residual are compared as well.
        let whitened: Vec<Vec<f64>> = columns.iter().map(|c| whiten(c, noise)).collect();
        let predicted = explained_share(&whiten(points, noise), &whitened, STRUCTURE_BLOCKS);
        predicted.max(follows_motion(points, columns, STRUCTURE_BLOCKS))
    }
}

/// A residual divided by the standard deviation of noise with the variance a + b y² at a channel reading y.
///
/// Reweighted least squares on the squared residual give the most likely a and b that are not negative.
fn variance_normalised(residual: &[f64], channel: &[f64]) -> Vec<f64> {
    let (mean, size) = (power(residual), power(channel));
    if mean <= 0.0 || size <= 0.0 {
        return residual.to_vec();
    }
    let squares: Vec<f64> = channel.iter().map(|y| y * y / size).collect();
    let (mut a, mut b) = (mean, 0.0);
    for _ in 0..VARIANCE_FIT_STEPS {
        let (mut normal, mut gradient) = ([[0.0; 2]; 2], [0.0; 2]);
        for (r, g) in residual.iter().zip(&squares) {
            let w = (a + b * g).powi(-2);
            normal = [[normal[0][0] + w, normal[0][1] + w * g], [normal[1][0] + w * g, normal[1][1] + w * g * g]];
            gradient = [gradient[0] + w * r * r, gradient[1] + w * g * r * r];
        }
        let [[aa, ab], [_, bb]] = normal;
        let determinant = aa * bb - ab * ab;
        if determinant <= SINGULAR_VARIANCE_FIT * aa * bb {
            break;
        }
        a = (bb * gradient[0] - ab * gradient[1]) / determinant;
        b = (aa * gradient[1] - ab * gradient[0]) / determinant;
        if b < 0.0 {
            (a, b) = (gradient[0] / aa, 0.0);
        } else if a < MIN_CONSTANT_VARIANCE * mean {
            a = MIN_CONSTANT_VARIANCE * mean;
            b = ((gradient[1] - ab * a) / bb).max(0.0);
        }
    }
    residual.iter().zip(&squares).map(|(r, g)| r / (a + b * g).sqrt()).collect()
}

/// Residual that recurs along the stroke, however slowly it changes there.
pub(crate) fn recurring_structure(
    study: &Study,
    responses: &ResponseRanges,
    fits: &[ScoredRun],
) -> UnmodelledStructure {
    let mut found = UnmodelledStructure::default();
    for ((number, run), fit) in study.runs_of(Role::Fit).zip(fits) {
        let strokes = strokes(responses, number);
        for (r, o) in residuals(run, fit).iter().zip(&run.observe) {
            let points = averaged(r, STRUCTURE_POINTS);
            let share = recurs_along(&points, &strokes, StrokeCells::recurrence_along_stroke);
            found.consider("recurrence", significance(r, o) * share, recurrence_description(o));
        }
    }
    found
}

fn recurrence_description(channel: &ObservedChannel) -> String {
    format!("the residual of {} comes again wherever the deformation does", channel.channel)
}

/// Residuals of the channels of a run; missing samples are 0.
fn residuals(run: &Run, fit: &ScoredRun) -> Vec<Vec<f64>> {
    let of =
        |(o, y): (&ObservedChannel, &Vec<f64>)| y.iter().zip(&o.values).map(|(y, v)| finite_or_zero(y - v)).collect();
    run.observe.iter().zip(&fit.channels).map(of).collect()
}

/// Cells along the strokes of the devices in a run.
fn strokes(responses: &ResponseRanges, run: usize) -> Vec<StrokeCells> {
    let moving = responses.histories.iter().filter(|((r, _, _), _)| *r == run).take(REGRESSION_DEVICES);
    moving.map(|(_, h)| StrokeCells::new(&averaged(&h.deformation, STRUCTURE_POINTS), STRUCTURE_BLOCKS)).collect()
}

/// Weight of a channel, at most 1: small where the residual is negligible against the channel, or due to the step of its samples.
fn significance(residual: &[f64], channel: &ObservedChannel) -> f64 {
    let size = power(residual);
    // Rounding to whole steps q leaves a variance of q²/12, which recurs wherever the channel does.
    let rounded = (sample_step(&channel.values).powi(2) / 12.0 / size.max(f64::MIN_POSITIVE)).min(1.0);
    (size / channel.variance / NEGLIGIBLE_RESIDUAL).min(1.0) * (1.0 - rounded)
}

/// Step of which all samples are multiples, beside one of them: the least difference of two samples. 0 without such a step.
fn sample_step(samples: &[f64]) -> f64 {
    let mut sorted: Vec<f64> = samples.iter().copied().filter(|x| x.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (Some(low), Some(high)) = (sorted.first().copied(), sorted.last().copied()) else { return 0.0 };
    let differences = sorted.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > ROUND_OFF * (high - low));
    let step = differences.fold(f64::INFINITY, f64::min);
    let is_multiple = |x: &f64| {
        let steps = (x - low) / step;
        (steps - steps.round()).abs() < STEP_TOLERANCE
    };
    if step.is_finite() && sorted.iter().all(is_multiple) { step } else { 0.0 }
}

fn finite_or_zero(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

/// Innovations of a series under noise of order [`BURST_NOISE_ORDER`].
fn innovations(x: &[f64]) -> Vec<f64> {
    whiten(x, &burg(x, BURST_NOISE_ORDER))
}

/// Share of a channel's residual that the residuals of the other channels predict, as an amplitude.
///
/// Sensors have independent noise, while a missing force moves all channels. Noise hides part of a common effect, and the
/// square root compensates for it; independent noise predicts nothing in any block.
fn common_share(residuals: &[Vec<f64>], channel: usize, noise: &[f64]) -> f64 {
    let target = &residuals[channel];
    let others = || residuals.iter().enumerate().filter(|(c, x)| *c != channel && x.len() == target.len());
    // As many as the samples allow, the smallest shifts first.
    let columns: Vec<Vec<f64>> = RESIDUAL_SHIFTS
        .iter()
        .flat_map(|by| others().map(|(_, x)| whiten(&shifted(x, *by), noise)))
        .take(target.len() / SAMPLES_PER_REGRESSOR)
        .collect();
    explained_share(&whiten(target, noise), &columns, STRUCTURE_BLOCKS).sqrt()
}

/// A series shifted by some samples and divided by its largest absolute value; its ends repeat.
fn shifted(x: &[f64], by: isize) -> Vec<f64> {
    let top = x.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    let n = x.len() as isize;
    (0..n).map(|t| x[(t + by).clamp(0, n - 1) as usize] / top).collect()
}

#[cfg(test)]
mod tests;
