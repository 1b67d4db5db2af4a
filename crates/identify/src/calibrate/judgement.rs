//! Judgement of a fit: can the residual be noise, and are held-out runs predicted as well as fitted ones?
//!
//! A model explains its recordings if four things hold: no residual follows the motion; the error of the fitted runs is
//! within the noise of the recordings; the held-out runs are no worse; and no parameter is at a bound. `calibrate` and
//! `diagnose` have this one judgement.
//!
//! If not, physics is missing or a channel is wrong, and intervals from noise alone are too narrow. They are widened by the
//! discrepancy, with a simple form of the prior of Kennedy and O'Hagan (2001): see [`Discrepancy`].

use super::result::at_bounds;
use super::structure::{ComparedChannel, structured_share, without};
use super::uncertainty::autocorrelation_time;
use crate::noise::{NoiseEvidence, recorded_noise};
use crate::report::significant;
use crate::study::{Role, Run, ScoredRun, Study};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::Serialize;

/// A channel whose residual follows the motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StructuredChannel {
    /// Name of the run.
    pub run: String,
    /// Name of the channel.
    pub channel: String,
    /// Share of its squared error that follows the motion.
    pub share: f64,
}

/// Error of the held-out runs over that of the fitted ones.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HoldoutRatio {
    /// Ratio of the mean square errors, or that of the NMSEs if it is smaller. What the uncertain parameters explain is left
    /// out.
    pub ratio: f64,
    /// Lower end of its 95 % interval.
    pub lower: f64,
    /// Upper end of its 95 % interval.
    pub upper: f64,
    /// The residual of a held-out channel follows the motion. Without that a larger error is larger noise.
    pub structured: bool,
    /// The error of the held-out runs is within twice the noise of their own recordings.
    pub within_noise: bool,
}

impl HoldoutRatio {
    /// Returns true if held-out runs are worse than fitted ones, and not for larger noise in them.
    pub fn is_worse(&self) -> bool {
        self.lower > 1.0 && (self.structured || !self.within_noise)
    }

    /// Returns true if they are worse, and their residual follows the motion.
    pub fn is_structured(&self) -> bool {
        self.is_worse() && self.structured
    }
}

/// Error of the fitted runs beside the noise of their recordings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct NoiseComparison {
    /// Mean NMSE of the fitted channels with a known noise.
    pub nmse: f64,
    /// Mean noise of these channels, over their variances.
    pub noise: f64,
    /// The same of the runs held out; none without such runs.
    pub holdout_noise: Option<f64>,
    /// The weakest evidence among those of the channels.
    pub evidence: NoiseEvidence,
}

impl NoiseComparison {
    /// Returns true if the error can be noise.
    pub fn is_within_noise(&self) -> bool {
        let limit = if self.evidence == NoiseEvidence::Innovations { MAX_INNOVATION_RATIO } else { MAX_NOISE_RATIO };
        self.nmse <= (limit * self.noise).max(MIN_NMSE)
    }
}

/// Judgement of a calibration.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judgement {
    /// The model explains the recordings as far as can be told: the residual is noise, held-out runs are no worse, and no
    /// parameter is at a bound.
    pub explained: bool,
    /// Error of the fitted runs beside the noise of the recordings; none if no channel is long enough.
    pub noise: Option<NoiseComparison>,
    /// Names of free parameters at a bound of their range.
    pub at_bounds: Vec<String>,
    /// Channels whose residual follows the motion, the largest part of the squared error first.
    pub structured: Vec<StructuredChannel>,
    /// Share of the squared error of all fitted channels that follows the motion.
    pub structured_share: f64,
    /// Comparison of held-out with fitted runs, where there are both.
    pub holdout: Option<HoldoutRatio>,
    /// Greatest factor by which a standard error was widened.
    pub widening: f64,
    /// The judgement in words.
    pub sentences: Vec<String>,
}

/// A discrepancy between model and truth, as the covariance takes it.
///
/// With the residuals r of the objective, their derivatives J and H = JᵀJ, a discrepancy δ moves the estimate by H⁻¹Jᵀδ.
/// The part of δ along J cannot be seen. A priori it is as large in each direction as all that is seen, s² = Σ δ²: then
///
/// Cov = q C + s² H⁻¹
///
/// with the covariance C from noise, and the ratio q ≥ 1 of held-out to fitted errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Discrepancy {
    /// Squared sum s² of the scaled residuals that follows the motion.
    pub(super) energy: f64,
    /// Factor q.
    pub(super) factor: f64,
}

/// Influence of the uncertain parameters on a channel of a held-out run.
#[derive(Clone, Debug, Default)]
pub(super) struct Influence {
    /// Mean square error of the prediction that comes of the parameters.
    pub(super) mean_square: f64,
    /// Derivatives by the parameters at the times of the recording.
    pub(super) columns: Vec<Vec<f64>>,
}

impl Discrepancy {
    /// No discrepancy.
    pub(super) const NONE: Self = Self { energy: 0.0, factor: 1.0 };
}

/// Squared errors of a prediction from uncertain parameters are at most so many times their mean: the 95 % point of χ² with
/// one degree of freedom.
const PREDICTION_LIMIT: f64 = 3.84;
/// A smaller NMSE is that of rounded numbers: no recording is as good.
const MIN_NMSE: f64 = 1e-6;
/// Error over the noise above which it is no noise. The estimate of the noise is within a factor of two of it.
const MAX_NOISE_RATIO: f64 = 2.0;
/// The same where only innovations tell the noise. Those of noise that is correlated over twenty samples are a tenth of it.
const MAX_INNOVATION_RATIO: f64 = 10.0;
/// Draws of the block bootstrap.
const DRAWS: usize = 400;
/// Length of its blocks in autocorrelation times.
const BLOCK_TIMES: f64 = 3.0;

/// Judge the residuals of a calibration. `residuals` and their derivatives `columns` are those of the objective, `scored`
/// the runs of the study with the calibrated values, `None` for one without a response. `influences` are those of the
/// uncertain parameters by run and channel.
pub(super) fn judge(
    study: &Study,
    scored: &[Option<ScoredRun>],
    residuals: &[f64],
    columns: &[Vec<f64>],
    influences: &[Vec<Influence>],
    unit_point: &[f64],
) -> (Judgement, Discrepancy) {
    let mut energies: Vec<(f64, StructuredChannel)> = vec![];
    let mut start = 0;
    for (i, run) in study.runs_of(Role::Fit) {
        let Some(scored) = &scored[i] else { continue };
        for (c, (o, s)) in run.observe.iter().zip(&scored.scores).enumerate() {
            let range = start..start + s.samples;
            start = range.end;
            let derivatives: Vec<&[f64]> = columns.iter().map(|c| &c[range.clone()]).collect();
            let share = share(run, scored, c, &derivatives, &Influence::default());
            if share > 0.0 {
                let energy = share * residuals[range].iter().map(|r| r * r).sum::<f64>();
                let channel = StructuredChannel { run: run.name.clone(), channel: o.channel.clone(), share };
                energies.push((energy, channel));
            }
        }
    }
    energies.sort_by(|a, b| b.0.total_cmp(&a.0));
    let energy = energies.iter().fold(0.0, |sum, e| sum + e.0);
    let total: f64 = residuals.iter().map(|r| r * r).sum();
    let held_out = noise_comparison(study, scored, Role::Holdout);
    let is_noise = held_out.is_some_and(|h| h.nmse <= MAX_NOISE_RATIO * h.noise);
    let holdout = holdout_ratio(study, scored, influences).map(|h| HoldoutRatio { within_noise: is_noise, ..h });
    let factor = holdout.filter(HoldoutRatio::is_structured).map_or(1.0, |h| h.ratio);
    let noise = noise_comparison(study, scored, Role::Fit);
    let noise = noise.map(|n| NoiseComparison { holdout_noise: held_out.map(|h| h.noise), ..n });
    let at_bounds: Vec<String> = at_bounds(&study.space, unit_point).map(str::to_owned).collect();
    let is_worse = holdout.is_some_and(|h| h.is_worse());
    let is_within_noise = noise.is_none_or(|n| n.is_within_noise());
    let judgement = Judgement {
        explained: energy == 0.0 && !is_worse && is_within_noise && at_bounds.is_empty(),
        noise,
        at_bounds,
        structured: energies.into_iter().map(|e| e.1).collect(),
        structured_share: if energy > 0.0 { energy / total } else { 0.0 },
        holdout,
        widening: 1.0,
        sentences: vec![],
    };
    (judgement, Discrepancy { energy, factor })
}

/// Error of the channels of the runs of a role beside the noise of their recordings.
fn noise_comparison(study: &Study, scored: &[Option<ScoredRun>], role: Role) -> Option<NoiseComparison> {
    let (mut nmse, mut sum, mut weight) = (0.0, 0.0, 0.0);
    let mut weakest = NoiseEvidence::RepeatedRuns;
    for (i, run) in study.runs_of(role) {
        let Some(scored) = &scored[i] else { continue };
        let noises = recorded_noise(study, i, &scored.channels);
        for ((o, s), noise) in run.observe.iter().zip(&scored.scores).zip(noises) {
            let Some(noise) = noise.filter(|_| s.nmse.is_finite()) else { continue };
            nmse += o.weight * s.nmse;
            sum += o.weight * noise.nmse;
            weight += o.weight;
            weakest = weakest.max(noise.evidence);
        }
    }
    let (nmse, noise) = (nmse / weight, sum / weight);
    (weight > 0.0).then_some(NoiseComparison { nmse, noise, holdout_noise: None, evidence: weakest })
}

/// Share of the squared error of a channel that follows the motion. What the uncertain parameters explain is taken out of the
/// residual before.
fn share(run: &Run, scored: &ScoredRun, channel: usize, derivatives: &[&[f64]], influence: &Influence) -> f64 {
    let (o, simulated) = (&run.observe[channel], &scored.channels[channel]);
    if scored.scores[channel].nmse <= MIN_NMSE {
        return 0.0;
    }
    let kept = |k: &usize| !simulated[*k].is_nan() && !o.values[*k].is_nan();
    let kept: Vec<usize> = (0..simulated.len()).filter(kept).collect();
    let at_kept = |x: &dyn Fn(usize) -> f64| -> Vec<f64> { kept.iter().map(|k| x(*k)).collect() };
    let columns = influence.columns.iter().map(|x| at_kept(&|k| x[k])).collect();
    structured_share(&ComparedChannel {
        times: &at_kept(&|k| run.recording.times[k]),
        simulated: &at_kept(&|k| simulated[k]),
        residual: &without(at_kept(&|k| simulated[k] - o.values[k]), columns),
        derivatives,
    })
}

impl Judgement {
    /// What speaks against the model, in words; empty if nothing does. The last sentence of the judgement concludes from it.
    pub fn reasons(&self) -> &[String] {
        self.sentences.split_last().map_or(&[], |(_, reasons)| reasons)
    }

    /// Set the greatest factor by which a standard error was widened, and put the judgement into words.
    pub(super) fn conclude(&mut self, widening: f64) {
        self.widening = widening;
        let percent = |x: f64| format!("{:.0} %", 100.0 * x);
        if let Some(first) = self.structured.first() {
            let others = match self.structured.len() - 1 {
                0 => String::new(),
                n => format!(" ({n} more channel{} likewise)", if n == 1 { "" } else { "s" }),
            };
            self.sentences.push(format!(
                "the residual is no noise: {} of the squared error of {} in {} follows the motion{others}",
                percent(first.share),
                first.channel,
                first.run
            ));
        }
        if let Some(h) = self.holdout.filter(HoldoutRatio::is_worse) {
            self.sentences.push(format!(
                "held-out runs are predicted worse than the uncertain parameters explain: {} times the mean square error of \
                 the fitted ones (95 %: {} to {})",
                significant(h.ratio, 2),
                significant(h.lower, 2),
                significant(h.upper, 2)
            ));
        }
        let noise = self.noise.map(|n| (significant(n.nmse, 2), significant(n.noise, 2), n));
        if let Some((error, noise, _)) = noise.as_ref().filter(|n| !n.2.is_within_noise()) {
            self.sentences.push(format!(
                "the error of the fitted runs, NMSE {error}, is above the noise of the recordings, {noise}"
            ));
        }
        if !self.at_bounds.is_empty() {
            let verb =
                if self.at_bounds.len() == 1 { "is at a bound of its range" } else { "are at bounds of their ranges" };
            self.sentences.push(format!("{} {verb}: a better fit may lie beyond", self.at_bounds.join(", ")));
        }
        let is_structured = !self.structured.is_empty() || self.holdout.is_some_and(|h| h.is_structured());
        self.sentences.push(match noise {
            Some((error, noise, _)) if self.explained => format!(
                "nothing speaks against the model within an NMSE of {error}: the residual looks like noise, and that of the \
                 recordings is {noise}"
            ),
            None if self.explained => "nothing speaks against the model: the residual looks like noise".into(),
            _ if is_structured => format!(
                "physics is missing or a channel is wrong; from noise alone the intervals would be too narrow, and are \
                 widened up to {} times; \"hysteron diagnose\" looks for the cause",
                significant(widening, 2)
            ),
            _ => "the recordings do not show that the model is complete; \"hysteron diagnose\" looks for what it lacks".into(),
        });
    }
}

/// Squared errors of a channel in blocks of which each is about independent: sum and number of samples.
struct Blocks {
    role: Role,
    channel: String,
    variance: f64,
    blocks: Vec<(f64, f64)>,
    /// Part of the mean square error that the uncertain parameters explain.
    allowance: f64,
}

impl Blocks {
    /// Mean square error of some of the blocks, less the allowance.
    fn mean_of(&self, blocks: impl Iterator<Item = usize>) -> f64 {
        let (sum, count) = blocks.map(|k| self.blocks[k]).fold((0.0, 0.0), |(s, c), b| (s + b.0, c + b.1));
        (sum / count - self.allowance).max(0.0)
    }
}

/// The squared errors of all channels of all runs.
fn squared_errors(study: &Study, scored: &[Option<ScoredRun>], influences: &[Vec<Influence>]) -> Vec<Blocks> {
    let mut all = vec![];
    for ((run, scored), influences) in study.runs.iter().zip(scored).zip(influences) {
        let simulated = scored.iter().flat_map(|s| &s.channels);
        for ((o, simulated), influence) in run.observe.iter().zip(simulated).zip(influences) {
            let errors: Vec<f64> =
                simulated.iter().zip(&o.values).map(|(y, v)| y - v).filter(|e| !e.is_nan()).collect();
            let n = errors.len();
            let length = (BLOCK_TIMES * autocorrelation_time(&errors)).clamp(4.0, (n / 10).max(4) as f64) as usize;
            let sum = |b: &[f64]| (b.iter().map(|e| e * e).sum(), b.len() as f64);
            let blocks = errors.chunks(length).map(sum).collect();
            let (channel, variance, allowance) =
                (o.channel.clone(), o.variance, PREDICTION_LIMIT * influence.mean_square);
            all.push(Blocks { role: run.role, channel, variance, blocks, allowance });
        }
    }
    all
}

/// Error of held-out over that of fitted runs, with a 95 % interval by a bootstrap of blocks (Künsch, 1989). `None` without
/// held-out runs, or if the error is nothing.
fn holdout_ratio(study: &Study, scored: &[Option<ScoredRun>], influences: &[Vec<Influence>]) -> Option<HoldoutRatio> {
    let all = squared_errors(study, scored, influences);
    let has = |role| all.iter().any(|b| b.role == role);
    if !has(Role::Fit) || !has(Role::Holdout) || all.iter().any(|b| b.blocks.is_empty()) {
        return None;
    }
    let found = ratio(&all, &all.iter().map(|b| b.mean_of(0..b.blocks.len())).collect::<Vec<_>>());
    let mut rng = Pcg32::seed_from_u64(1);
    let mut draws: Vec<f64> = vec![];
    for _ in 0..DRAWS {
        let drawn = all.iter().map(|b| {
            let n = b.blocks.len();
            b.mean_of((0..n).map(|_| rng.random_range(0..n)))
        });
        draws.push(ratio(&all, &drawn.collect::<Vec<_>>()));
    }
    draws.sort_by(f64::total_cmp);
    let quantile = |p: f64| draws[(p * (DRAWS - 1) as f64).round() as usize];
    let held_out = study.runs_of(Role::Holdout).filter_map(|(i, run)| Some((i, run, scored[i].as_ref()?)));
    let structured = held_out
        .into_iter()
        .any(|(i, run, s)| (0..run.observe.len()).any(|c| share(run, s, c, &[], &influences[i][c]) > 0.0));
    let (lower, upper) = (quantile(0.025), quantile(0.975));
    let result = HoldoutRatio { ratio: found, lower, upper, structured, within_noise: false };
    [result.ratio, result.lower, result.upper].iter().all(|x| x.is_finite()).then_some(result)
}

/// Ratio of held-out to fitted errors, given the mean square error of each channel of each run.
///
/// The NMSE of weak motions is larger for the same noise, and noise that grows with the motion has a larger mean square error
/// in strong ones. What is worse by both measures is worse.
fn ratio(all: &[Blocks], means: &[f64]) -> f64 {
    let mean = |role: Role, f: &dyn Fn(usize) -> Option<f64>| {
        let values: Vec<f64> = (0..all.len()).filter(|i| all[*i].role == role).filter_map(f).collect();
        values.iter().sum::<f64>() / values.len() as f64
    };
    let nmse = |i: usize| Some(means[i] / all[i].variance);
    let by_nmse = mean(Role::Holdout, &nmse) / mean(Role::Fit, &nmse);
    // Mean square errors are compared among channels of one name.
    let of_fitted = |name: &str| mean(Role::Fit, &|k| (all[k].channel == name).then(|| means[k]));
    let relative = |i: usize| Some(means[i] / of_fitted(&all[i].channel)).filter(|x| x.is_finite());
    let by_mean_square = mean(Role::Holdout, &relative);
    if by_mean_square.is_finite() { by_nmse.min(by_mean_square) } else { by_nmse }
}
