//! Runs of a device, their scales, weights and folds.

use super::family::Family;
use super::operators::speed;

/// A recorded channel or condition of a run beside its motion and force.
#[derive(Clone, Debug)]
pub(crate) struct Condition {
    /// Name of the column or variable.
    pub(crate) name: String,
    /// Samples.
    pub(crate) values: Vec<f64>,
}

/// A run of a device; all series have one length.
#[derive(Clone, Debug)]
pub(crate) struct DeviceRun {
    /// Times.
    pub(crate) times: Vec<f64>,
    /// Deformation.
    pub(crate) deformation: Vec<f64>,
    /// Force of the user's fitted law.
    pub(crate) modelled: Vec<f64>,
    /// Recorded force; NaN where it is missing.
    pub(crate) recorded: Vec<f64>,
    /// Further channels and conditions; the same in all runs.
    pub(crate) conditions: Vec<Condition>,
    /// True if the run is held out.
    pub(crate) held_out: bool,
}

/// Scales of the fitted runs.
#[derive(Clone, Debug)]
pub(super) struct Scales {
    /// Largest absolute deformation, and that of the side that goes less far.
    pub(super) deformation: f64,
    pub(super) lesser_side: f64,
    /// The 98 % quantile of the speed where it moves.
    pub(super) speed: f64,
    /// Length of the longest run.
    pub(super) duration: f64,
    /// Largest absolute force of the user's law.
    pub(super) force: f64,
    /// Time constants, geometric.
    pub(super) constants: [f64; 7],
    /// Mean and standard deviation of each condition.
    pub(super) conditions: Vec<(f64, f64)>,
}

/// State at which slow variables are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Of the moment, with weights of any sign: kinds of memory are compared.
    Comparison,
    /// The committed one, with weights that make no energy: the law is one of the engine.
    Engine,
}

/// Samples of all runs, with weights and folds.
pub(super) struct Data {
    pub(super) mode: Mode,
    pub(super) runs: Vec<DeviceRun>,
    pub(super) scales: Scales,
    /// True if the times are those of a clock.
    pub(super) has_clock: bool,
    /// Run and index of each sample.
    pub(super) samples: Vec<(usize, usize)>,
    /// Recorded force of each sample.
    pub(super) recorded: Vec<f64>,
    /// Square root of the weight of each sample: the squares of a fitted run add up to its NMSE over the number of runs.
    pub(super) weight: Vec<f64>,
    /// True for samples of fitted runs.
    pub(super) fitted: Vec<bool>,
    /// Samples held back by each fold: blocks first, then whole runs; no fold is empty.
    pub(super) folds: Vec<Vec<bool>>,
    /// Number of the folds of blocks.
    pub(super) block_folds: usize,
    /// Factor of the errors of whole runs.
    pub(super) whole_factor: f64,
}

/// Samples of the fitted runs to which a fit is thinned.
const SAMPLES: usize = 2000;
/// Blocks of a run, and folds to which they belong in turn.
const BLOCKS: usize = 8;
const BLOCK_FOLDS: usize = 4;
/// Folds of blocks that have samples, at least.
const MIN_BLOCK_FOLDS: usize = 2;
/// First block of the end of a single run that is held back as a whole.
const END_BLOCK: usize = 5;

impl Data {
    /// Data of runs; `None` without a fitted run that moves.
    pub(super) fn new(runs: Vec<DeviceRun>, has_clock: bool) -> Option<Self> {
        let scales = Scales::of(&runs)?;
        let fitted_samples: usize = runs.iter().filter(|r| !r.held_out).map(|r| r.times.len()).sum();
        let stride = fitted_samples.div_ceil(SAMPLES).max(1);
        let fitted_runs = runs.iter().filter(|r| !r.held_out).count();
        let (mut samples, mut recorded, mut weight, mut fitted, mut block) = (vec![], vec![], vec![], vec![], vec![]);
        for (k, run) in runs.iter().enumerate() {
            let kept: Vec<usize> =
                (0..run.times.len()).step_by(stride).filter(|i| run.recorded[*i].is_finite()).collect();
            let values: Vec<f64> = kept.iter().map(|i| run.recorded[*i]).collect();
            let deviation = deviation(&values);
            if kept.is_empty() || deviation <= 0.0 {
                continue;
            }
            let share = if run.held_out { 1.0 } else { fitted_runs as f64 };
            for i in &kept {
                samples.push((k, *i));
                recorded.push(run.recorded[*i]);
                weight.push(1.0 / (deviation * (kept.len() as f64 * share).sqrt()));
                fitted.push(!run.held_out);
                block.push(*i * BLOCKS / run.times.len());
            }
        }
        let of =
            |held: &dyn Fn(usize) -> bool| -> Vec<bool> { (0..samples.len()).map(|i| fitted[i] && held(i)).collect() };
        let has_samples = |f: &Vec<bool>| f.iter().any(|x| *x);
        let of_blocks = (0..BLOCK_FOLDS).map(|f| of(&|i| block[i] % BLOCK_FOLDS == f));
        let mut folds: Vec<Vec<bool>> = of_blocks.filter(has_samples).collect();
        let block_folds = folds.len();
        if fitted_runs > 1 {
            folds.extend((0..runs.len()).filter(|k| !runs[*k].held_out).map(|k| of(&|i| samples[i].0 == k)));
        } else {
            folds.push(of(&|i| block[i] >= END_BLOCK));
        }
        folds.retain(has_samples);
        let whole_factor = if fitted_runs > 1 { 1.0 } else { BLOCKS as f64 / (BLOCKS - END_BLOCK) as f64 };
        (block_folds >= MIN_BLOCK_FOLDS && folds.len() > block_folds).then_some(Self {
            mode: Mode::Comparison,
            runs,
            scales,
            has_clock,
            samples,
            recorded,
            weight,
            fitted,
            folds,
            block_folds,
            whole_factor,
        })
    }

    /// Series of each run at the samples.
    pub(super) fn at_samples(&self, of_run: impl Fn(&DeviceRun) -> Vec<f64>) -> Vec<f64> {
        self.sampled(&self.runs.iter().map(of_run).collect::<Vec<_>>())
    }

    /// Series of the runs at the samples.
    pub(super) fn sampled(&self, runs: &[Vec<f64>]) -> Vec<f64> {
        self.samples.iter().map(|(k, i)| runs[*k][*i]).collect()
    }

    /// Conditions of a run at a sample, each less its mean over three standard deviations.
    pub(super) fn scaled_conditions(&self, run: &DeviceRun, sample: usize) -> Vec<f64> {
        let all = run.conditions.iter().zip(&self.scales.conditions);
        let scaled = all.map(|(c, (mean, deviation))| (c.values[sample] - mean) / (3.0 * deviation));
        scaled.map(|x| if x.is_finite() { x } else { 0.0 }).collect()
    }

    /// Families that can be told from these runs, with the index of their condition. A place is one of learned laws alone.
    pub(super) fn families(&self) -> Vec<(Family, Option<usize>)> {
        let is_known = |f: &Family| self.mode == Mode::Engine || *f != Family::Place;
        let has_times = |f: &Family| self.has_clock || !f.needs_clock();
        let of_motion = Family::OF_MOTION.into_iter().filter(|f| is_known(f) && has_times(f)).map(|f| (f, None));
        let conditions = self.runs[0].conditions.iter().enumerate();
        of_motion.chain(conditions.map(|(i, c)| (Family::of_column(&c.name), Some(i)))).collect()
    }
}

impl Scales {
    fn of(runs: &[DeviceRun]) -> Option<Self> {
        let fitted = || runs.iter().filter(|r| !r.held_out);
        let largest = |of: fn(&DeviceRun) -> &[f64]| {
            fitted().flat_map(of).filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()))
        };
        let deformation = largest(|r| &r.deformation);
        let of_side = |side: f64| fitted().flat_map(|r| &r.deformation).fold(0.0f64, |m, u| m.max(side * u));
        let mut speeds: Vec<f64> =
            fitted().flat_map(|r| speed(&r.deformation, &r.times)).map(f64::abs).filter(|v| *v > 0.0).collect();
        speeds.sort_by(f64::total_cmp);
        let speed = *speeds.get(speeds.len() * 98 / 100)?;
        let duration = fitted().filter_map(|r| Some(r.times.last()? - r.times.first()?)).fold(0.0, f64::max);
        let interval = fitted().map(|r| (r.times[r.times.len() - 1] - r.times[0]) / (r.times.len() - 1) as f64);
        let least = (3.0 * interval.fold(f64::INFINITY, f64::min)).max(duration / 3000.0);
        let ratio = (0.5 * duration / least).powf(1.0 / 6.0);
        let condition = |i: usize| {
            let values: Vec<f64> =
                fitted().flat_map(|r| &r.conditions[i].values).copied().filter(|x| x.is_finite()).collect();
            (values.iter().sum::<f64>() / values.len().max(1) as f64, deviation(&values))
        };
        let count = fitted().next()?.conditions.len();
        (deformation > 0.0 && duration > 0.0).then(|| Self {
            deformation,
            lesser_side: of_side(1.0).min(of_side(-1.0)),
            speed,
            duration,
            force: largest(|r| &r.modelled),
            constants: std::array::from_fn(|k| least * ratio.powi(k as i32)),
            conditions: (0..count).map(condition).collect(),
        })
    }
}

/// Standard deviation.
fn deviation(x: &[f64]) -> f64 {
    let mean = x.iter().sum::<f64>() / x.len().max(1) as f64;
    (x.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / x.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Data, DeviceRun};

    /// A fold of blocks without a sample is left out, and the next one is none of the whole runs.
    #[test]
    fn a_gap_in_the_recording_leaves_the_other_folds_where_they_are() {
        // Of eight blocks of 100 samples the second and the sixth belong to one fold.
        let run = |has_gap: bool| {
            let times: Vec<f64> = (0..800).map(|i| 0.01 * f64::from(i)).collect();
            let deformation: Vec<f64> = times.iter().map(|t| (3.0 * t).sin()).collect();
            let is_lost = |i: usize| has_gap && matches!(i / 100, 1 | 5);
            let recorded = (0..800).map(|i| if is_lost(i) { f64::NAN } else { deformation[i] }).collect();
            DeviceRun {
                modelled: deformation.clone(),
                times,
                deformation,
                recorded,
                conditions: vec![],
                held_out: false,
            }
        };
        let data = |has_gap| Data::new(vec![run(has_gap), run(has_gap)], true).expect("samples");
        let whole = data(false);
        assert_eq!((whole.block_folds, whole.folds.len()), (4, 6));
        let with_gap = data(true);
        assert_eq!((with_gap.block_folds, with_gap.folds.len()), (3, 5));
        let of_runs =
            |fold: &Vec<bool>| (0..fold.len()).filter(|i| fold[*i]).map(|i| with_gap.samples[i].0).collect::<Vec<_>>();
        assert!(with_gap.folds[3..].iter().all(|f| of_runs(f).windows(2).all(|w| w[0] == w[1])));
        assert!(with_gap.folds[..3].iter().all(|f| of_runs(f).windows(2).any(|w| w[0] != w[1])));
    }
}
