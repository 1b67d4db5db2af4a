//! Structure that a fit leaves in the residuals of all channels.

use super::bursts::burst_share;
use super::motion_regressors::motion_regressors;
use super::recurrence::StrokeCells;
use super::regression::explained_share;
use super::sensor_noise::{sample_step, variance_normalised};
use super::spectral_lines::line_share;
use super::surrogates::{follows_motion, recurs_along, silent_share, unsteady_share};
use crate::inspect::response::ResponseRanges;
use crate::prior::{
    BURST_NOISE_ORDER, CHANNEL_SHIFTS, MIN_SHARED_STRUCTURE, NEGLIGIBLE_RESIDUAL, REGRESSION_DEVICES, RESIDUAL_SHIFTS,
    SAMPLES_PER_REGRESSOR, STRUCTURE_BLOCKS, STRUCTURE_NOISE_ORDER, STRUCTURE_POINTS,
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
mod tests {
    use super::{UnmodelledStructure, common_share, unmodelled_structure};
    use crate::inspect::response::{ResponseHistory, ResponseRanges};
    use crate::prior::MIN_SHARED_STRUCTURE;
    use crate::test_support::{pad_study, white_noise};
    use hysteron_identify::study::{Role, Score, ScoredRun};

    #[test]
    fn independent_sensor_noise_has_no_common_share() {
        let own: Vec<Vec<f64>> = (1..4).map(|seed| white_noise(seed, 900)).collect();
        assert!((0..3).all(|c| common_share(&own, c, &[]) < 0.05));
        // A force that moves all channels, each a sample later.
        let force = white_noise(9, 910);
        let moved: Vec<Vec<f64>> =
            (0..3).map(|c| own[c].iter().zip(&force[c..]).map(|(o, f)| o + f).collect()).collect();
        assert!((0..3).all(|c| common_share(&moved, c, &[]) > 0.5));
        assert!(common_share(&moved[..1], 0, &[]) == 0.0);
    }

    const SAMPLES: usize = 1500;

    fn times() -> Vec<f64> {
        (0..SAMPLES).map(|i| 0.01 * i as f64).collect()
    }

    /// A motion of several tones.
    fn motion() -> Vec<f64> {
        times().iter().map(|t| (2.0 * t).sin() + 0.6 * (4.7 * t + 1.0).sin() + 0.4 * (7.3 * t + 2.0).sin()).collect()
    }

    /// Force of a pad under that motion: a spring, and a part that follows the sense of the motion.
    fn force() -> Vec<f64> {
        let u = motion();
        (0..SAMPLES).map(|i| 10.0 * u[i] + 3.0 * ((u[i] - u[i.saturating_sub(1)]) / 0.005).tanh()).collect()
    }

    /// Structure that a model leaves which lacks the `error` of one channel.
    fn left(error: &[f64]) -> UnmodelledStructure {
        let recorded: Vec<f64> = force().iter().zip(error).map(|(f, e)| f + e).collect();
        left_of(recorded)
    }

    fn left_of(recorded: Vec<f64>) -> UnmodelledStructure {
        let mut study = pad_study();
        study.runs.retain(|r| r.role == Role::Fit);
        study.runs.truncate(1);
        let run = &mut study.runs[0];
        run.recording.times = times();
        run.observe.truncate(1);
        let mean = recorded.iter().sum::<f64>() / SAMPLES as f64;
        run.observe[0].variance = recorded.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / SAMPLES as f64;
        run.observe[0].values = recorded;
        let history = ResponseHistory { times: times(), deformation: motion(), force: force() };
        let responses = ResponseRanges { histories: [((0, 1, 1), history)].into(), ..ResponseRanges::default() };
        let scores = vec![Score { nmse: 0.0, samples: SAMPLES, dropped: 0 }];
        unmodelled_structure(&study, &responses, &[ScoredRun { channels: vec![force()], scores }], true)
    }

    /// Number of seeds of which an error is structure, and of those with a remark on the sensor.
    fn counted(error: impl Fn(u64) -> Vec<f64>) -> [usize; 2] {
        let all: Vec<UnmodelledStructure> = (1..13).map(|seed| left(&error(seed))).collect();
        let is_physics = |s: &&UnmodelledStructure| s.share > MIN_SHARED_STRUCTURE;
        [all.iter().filter(is_physics).count(), all.iter().filter(|s| !s.unsteady_channels.is_empty()).count()]
    }

    fn is_burst(t: usize) -> bool {
        (300..360).contains(&t) || (820..850).contains(&t) || (1200..1290).contains(&t)
    }

    /// Steady noise has neither structure nor a remark.
    #[test]
    fn steady_noise_is_nothing() {
        let [physics, remarks] = counted(|seed| white_noise(seed, SAMPLES));
        assert!(physics == 0 && remarks == 0, "{physics} {remarks}");
    }

    /// Bursts that do not follow the motion are noise of the sensor, whatever their colour.
    #[test]
    fn bursts_alone_are_noise_with_a_remark() {
        let bursts = |seed, colour: f64| {
            let mut x = white_noise(seed, SAMPLES);
            (1..SAMPLES).for_each(|t| x[t] += colour * x[t - 1]);
            (0..SAMPLES).map(|t| 0.2 * x[t] * if is_burst(t) { 8.0 } else { 1.0 }).collect::<Vec<f64>>()
        };
        for colour in [0.0, 0.6] {
            let [physics, remarks] = counted(|seed| bursts(seed, colour));
            assert!(physics <= 1 && remarks >= 11, "{colour}: {physics} {remarks}");
        }
    }

    /// A force that the device has in some stretches alone follows the motion, and its loudness is physics.
    #[test]
    fn bursts_of_the_motion_are_physics() {
        let u = motion();
        let sticks = |t: usize| 2.0 * ((u[t] - u[t.saturating_sub(1)]) / 0.005).tanh();
        let [physics, remarks] = counted(|seed| {
            let noise = white_noise(seed, SAMPLES);
            (0..SAMPLES).map(|t| 0.2 * noise[t] + if t % 500 < 250 { sticks(t) } else { 0.0 }).collect()
        });
        assert!(physics == 12 && remarks == 0, "{physics} {remarks}");
    }

    /// Noise that grows with the reading is neither.
    #[test]
    fn proportional_noise_is_nothing() {
        let f = force();
        let [physics, remarks] = counted(|seed| {
            let noise = white_noise(seed, SAMPLES);
            (0..SAMPLES).map(|t| noise[t] * (0.05 + 0.05 * f[t].abs())).collect()
        });
        assert!(physics <= 1 && remarks <= 1, "{physics} {remarks}");
    }

    /// A hum comes again all the time: it is no noise.
    #[test]
    fn a_hum_is_a_line() {
        for seed in 1..6 {
            let noise = white_noise(seed, SAMPLES);
            let hum: Vec<f64> = (0..SAMPLES).map(|t| 0.2 * noise[t] + 0.6 * (1.3 * t as f64).sin()).collect();
            let found = left(&hum);
            assert!(found.by_kind.get("line").is_some_and(|s| *s > 0.3), "{:?}", found.by_kind);
        }
    }

    /// Rounding recurs along the stroke with the force, and is no physics; a force of the same size beside it is.
    #[test]
    fn rounded_samples_are_no_structure() {
        for step in [0.2, 0.5, 1.0] {
            let round = |x: &f64| step * (x / step).round();
            let rounded: Vec<f64> = force().iter().map(round).collect();
            let found = left_of(rounded);
            assert!(found.share < MIN_SHARED_STRUCTURE && found.unsteady_channels.is_empty(), "{step}: {found:?}");
            let ripples: Vec<f64> =
                force().iter().zip(motion()).map(|(f, u)| round(&(f + 1.5 * step * (9.0 * u).sin()))).collect();
            assert!(left_of(ripples).share > 0.5, "{step}");
        }
    }
}
