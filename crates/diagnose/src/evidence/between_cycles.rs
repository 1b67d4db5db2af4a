//! Evidence of what differs between the cycles of a steady motion.
//!
//! An error that every cycle repeats says nothing of a parameter that changed on the way: the model lacks as much before the
//! change as after it. The mean over cycles is therefore taken out of the residual of each run whose motion is steady, and
//! hypotheses are compared by the rest. Other values of a parameter for a part of a run take the log evidence of this comparison
//! where no other cause explains the differences as well.

use super::likelihood::NoiseModel;
use super::ranking::prior_log_odds;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::ChannelResiduals;
use crate::prior::{BETWEEN_CYCLES_LOG_ODDS, MAX_UNSTEADY_SHARE, MIN_CYCLE_SAMPLES, MIN_CYCLES, MIN_TAKEN_SHARE};
use crate::series::power;
use hysteron_identify::study::{ObservedChannel, Role, Study};
use std::ops::Range;

/// Part of a run in which one cycle follows the other.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SteadyMotion {
    /// Length of a cycle, samples.
    length: f64,
    /// Its samples.
    samples: Range<usize>,
}

impl SteadyMotion {
    /// That of a displacement with evenly spaced samples; `None` where no part is steady for long enough. Motions begin and end
    /// with other cycles.
    pub(crate) fn of(displacement: &[f64]) -> Option<Self> {
        let n = displacement.len();
        let mean = displacement.iter().sum::<f64>() / n.max(1) as f64;
        let u: Vec<f64> = displacement.iter().map(|x| x - mean).collect();
        let longest = n / MIN_CYCLES;
        let correlation = |lag: usize| -> f64 {
            let products = u.iter().zip(&u[lag..]).map(|(a, b)| a * b).sum::<f64>();
            products / (n - lag).max(1) as f64
        };
        // The first lag at which the motion is against itself; its cycle ends behind that.
        let against = (1..longest).find(|lag| correlation(*lag) < 0.0)?;
        let cycle = (against..longest).max_by(|a, b| correlation(*a).total_cmp(&correlation(*b)))?;
        let samples = Some(steady_samples(&u, cycle)).filter(|s| s.len() >= MIN_CYCLES * cycle)?;
        // A fraction of a sample adds up over the cycles.
        let parts = (-10..=10).map(|k| Self { length: cycle as f64 + 0.1 * f64::from(k), samples: samples.clone() });
        let unsteady = |motion: &Self| power(&motion.differences(&u));
        let best = parts.min_by(|a, b| unsteady(a).total_cmp(&unsteady(b)))?;
        let is_steady = unsteady(&best) <= MAX_UNSTEADY_SHARE * power(&u[samples]);
        (is_steady && cycle >= MIN_CYCLE_SAMPLES).then_some(best)
    }

    /// Number of phases, one for each whole sample.
    fn phases(&self) -> usize {
        (self.length.floor() as usize).max(1)
    }

    fn phase(&self, sample: usize) -> usize {
        let part = (sample as f64 / self.length).fract();
        ((part * self.phases() as f64) as usize).min(self.phases() - 1)
    }

    /// The steady part of a series without its mean over the cycles.
    fn differences(&self, x: &[f64]) -> Vec<f64> {
        let mut sums = vec![(0.0, 0.0f64); self.phases()];
        for i in self.samples.clone() {
            let (sum, count) = &mut sums[self.phase(i)];
            (*sum, *count) = (*sum + x[i], *count + 1.0);
        }
        let mean = |i: usize| sums[self.phase(i)].0 / sums[self.phase(i)].1.max(1.0);
        self.samples.clone().map(|i| x[i] - mean(i)).collect()
    }
}

/// The most cycles in a row of which each is like the one before it, as a range of samples.
fn steady_samples(u: &[f64], cycle: usize) -> Range<usize> {
    let blocks: Vec<&[f64]> = u.chunks_exact(cycle.max(1)).collect();
    let is_like = |a: &[f64], b: &[f64]| {
        let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        power(&difference) <= MAX_UNSTEADY_SHARE * (power(a) + power(b)) && power(a) > 0.0
    };
    let (mut longest, mut first) = (0..0, 0);
    for k in 0..blocks.len() {
        if k > 0 && !is_like(blocks[k - 1], blocks[k]) {
            first = k;
        }
        if k + 1 - first > longest.len() {
            longest = first..k + 1;
        }
    }
    longest.start * cycle..longest.end * cycle
}

/// Raises other values of a parameter for a part of a run to their evidence from what differs between cycles, over the user's
/// model, and sorts the hypotheses again. `motions` are those of the runs of the study.
pub(crate) fn compare_cycles(study: &Study, all: &mut [FittedHypothesis], motions: &[Option<SteadyMotion>]) {
    all.iter_mut().for_each(|e| e.told_between_cycles = false);
    let between: Vec<Option<ChannelResiduals>> =
        all.iter().map(|e| between_cycles(study, e.held_out.as_ref()?, motions)).collect();
    let square = |r: &ChannelResiduals| r.iter().map(|x| power(x)).sum::<f64>();
    let Some(least) = between.iter().flatten().min_by(|a, b| square(a).total_cmp(&square(b))) else { return };
    let noise = NoiseModel::of(least);
    let evidence = |(e, r): (&FittedHypothesis, &Option<ChannelResiduals>)| {
        r.as_ref()
            .map_or(f64::NEG_INFINITY, |r| prior_log_odds(e) + noise.log_evidence(r, e.variant.counted_parameters()))
    };
    let evidence: Vec<f64> = all.iter().zip(&between).map(evidence).collect();
    let Some(none) = all.iter().position(|e| e.cause() == "none") else { return };
    let is_in_time = |e: &FittedHypothesis| !e.variant.change_point_coordinates().is_empty();
    let most = |of_time: bool| {
        let of = all.iter().zip(&evidence).filter(|(e, _)| is_in_time(e) == of_time && e.second_cause().is_none());
        of.map(|(_, x)| *x).fold(f64::NEG_INFINITY, f64::max)
    };
    if most(true) < most(false) + BETWEEN_CYCLES_LOG_ODDS {
        return;
    }
    let of_none = all[none].log_evidence;
    let Some(before) = between[none].as_ref().map(square) else { return };
    for ((e, own), after) in all.iter_mut().zip(&evidence).zip(&between).filter(|((e, _), _)| is_in_time(e)) {
        e.log_evidence = e.log_evidence.max(of_none + own - evidence[none]);
        e.told_between_cycles = after.as_ref().is_some_and(|r| square(r) <= (1.0 - MIN_TAKEN_SHARE) * before);
    }
    all.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
}

/// Residuals of the channels in runs of steady motion, without what every cycle repeats; `None` without such a run.
fn between_cycles(
    study: &Study,
    residuals: &ChannelResiduals,
    motions: &[Option<SteadyMotion>],
) -> Option<ChannelResiduals> {
    let channels = study.runs_of(Role::Fit).flat_map(|(i, run)| run.observe.iter().map(move |o| (i, o)));
    let of = |((i, o), r): ((usize, &ObservedChannel), &Vec<f64>)| {
        let motion = motions.get(i)?.as_ref().filter(|_| r.len() == o.values.len())?;
        Some(motion.differences(r))
    };
    let out: ChannelResiduals = channels.zip(residuals).filter_map(of).collect();
    (!out.is_empty()).then_some(out)
}

#[cfg(test)]
mod tests {
    use super::{SteadyMotion, compare_cycles};
    use crate::candidate::proposal::{ChangedCondition, Proposal};
    use crate::fit::fitted::FittedHypothesis;
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, fitted_at, script_edit, white_noise};
    use hysteron_identify::study::Role;
    use std::f64::consts::TAU;

    fn series(n: usize, of: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..n).map(|i| of(i as f64)).collect()
    }

    #[test]
    fn a_steady_part_of_a_motion_has_cycles() {
        let steady = |u: &[f64]| SteadyMotion::of(u).map(|m| (m.length, m.samples));
        let wave = |i: f64| (TAU * i / 128.3).sin() + 0.2 * (3.0 * TAU * i / 128.3).sin();
        // The motion grows for a cycle, and fades at the end.
        let with_ends = series(1024, |i| (i / 128.0).min((1024.0 - i) / 128.0).min(1.0) * wave(i));
        let (length, samples) = steady(&with_ends).expect("a steady part");
        assert!((length - 128.3).abs() < 0.3 && samples == (128..896), "{length} {samples:?}");
        // Growing amplitudes, an earthquake's two periods, and three cycles.
        assert_eq!(steady(&series(900, |i| i * (TAU * i / 128.0).sin())), None);
        assert_eq!(steady(&series(900, |i| (TAU * i / 128.0).sin() + (TAU * i / 90.1).sin())), None);
        assert_eq!(steady(&series(380, |i| (TAU * i / 128.0).sin())), None);
    }

    /// Another value for a time takes what differs between cycles, beside a large error that every cycle repeats. A rival that
    /// takes it as well leaves it where it was.
    #[test]
    fn a_change_in_time_has_the_evidence_of_what_differs_between_cycles() {
        let own = baseline();
        let study = own.variant.study.clone();
        let run = study.runs.iter().position(|r| r.role == Role::Fit).expect("a fitted run");
        let lengths: Vec<usize> =
            study.runs_of(Role::Fit).flat_map(|(_, r)| r.observe.iter().map(|o| o.values.len())).collect();
        let motion = SteadyMotion { length: 40.0, samples: 0..lengths[0] / 40 * 40 };
        let mut motions = vec![None; study.runs.len()];
        motions[run] = Some(motion);
        let residuals = |changed: f64, seed: u64| -> Option<Vec<Vec<f64>>> {
            let of = |n: &usize| {
                let noise = white_noise(seed, *n);
                let at = |i: usize| (TAU * i as f64 / 40.0).sin();
                let step = |i: usize| if (n / 3..n / 2).contains(&i) { changed * at(i).signum() } else { 0.0 };
                (0..*n).map(|i| 3.0 * at(i).powi(3) + step(i) + 0.05 * noise[i]).collect()
            };
            Some(lengths.iter().map(of).collect())
        };
        let in_time = Proposal {
            condition: Some(ChangedCondition { from: Some("hy_from".into()), ..ChangedCondition::default() }),
            ..script_edit("changed_condition", &["factor", "from"])
        };
        let of = |proposal: &Proposal, added: &[f64]| {
            fitted_at(own.variant.with_proposal(&InsertionPoint::At(0), proposal).expect("a variant"), added)
        };
        let told = |rival: f64| {
            let mut all: Vec<FittedHypothesis> =
                vec![own.clone(), of(&in_time, &[0.5, 0.5]), of(&script_edit("friction", &["x"]), &[0.5])];
            let left = [1.0, 0.0, rival];
            for (k, (e, changed)) in all.iter_mut().zip(left).enumerate() {
                (e.held_out, e.log_evidence) = (residuals(changed, k as u64), 10.0 - k as f64);
            }
            compare_cycles(&study, &mut all, &motions);
            (all[0].cause(), all.iter().any(|e| e.told_between_cycles))
        };
        assert_eq!(told(1.0), ("changed_condition", true));
        assert_eq!(told(0.0), ("none", false));
    }

    #[test]
    fn what_every_cycle_repeats_is_no_difference() {
        let motion = SteadyMotion { length: 128.0, samples: 0..896 };
        let repeated = series(896, |i| (TAU * i / 128.0).sin().powi(5));
        assert!(motion.differences(&repeated).iter().all(|x| x.abs() < 1e-12));
        let changed: Vec<f64> = repeated.iter().enumerate().map(|(i, x)| if i < 384 { *x } else { 1.5 * x }).collect();
        let most = |x: &[f64]| x.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        assert!(most(&motion.differences(&changed)) > 0.2);
    }
}
