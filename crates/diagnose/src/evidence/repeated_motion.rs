//! Evidence of what differs where a motion repeats: between the cycles of a steady motion, and between runs of one motion.
//!
//! An error that every cycle repeats says nothing of a parameter that changed on the way: the model lacks as much before the
//! change as after it. The mean over cycles is therefore taken out of the residual of each run whose motion is steady, and
//! hypotheses are compared by the rest. Of runs whose motions are one, sample by sample, the differences of the residuals are
//! compared. Other values of a parameter take the log evidence of this comparison where no other cause explains the differences
//! as well.

use super::likelihood::NoiseModel;
use super::ranking::prior_log_odds;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::ChannelResiduals;
use crate::hypothesis::changed_condition;
use crate::prior::{MAX_UNSTEADY_SHARE, MIN_CYCLE_SAMPLES, MIN_CYCLES, MIN_TAKEN_SHARE, REPEATED_MOTION_LOG_ODDS};
use crate::series::{centred, power};
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
        let u = centred(displacement.to_vec());
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

/// Motions of the runs of a study that repeat: in cycles, or from run to run.
#[derive(Default)]
pub(crate) struct RepeatedMotions {
    steady: Vec<Option<SteadyMotion>>,
    /// First run with the motion of each run, sample by sample.
    first_alike: Vec<usize>,
}

impl RepeatedMotions {
    /// From a displacement of each run.
    pub(crate) fn of(displacements: &[Option<Vec<f64>>]) -> Self {
        let is_alike = |a: &Option<Vec<f64>>, b: &Option<Vec<f64>>| match (a, b) {
            (Some(a), Some(b)) if a.len() == b.len() => {
                let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
                power(&difference) <= MAX_UNSTEADY_SHARE * power(a)
            }
            _ => false,
        };
        let first = |i: usize| (0..i).find(|k| is_alike(&displacements[*k], &displacements[i])).unwrap_or(i);
        Self {
            steady: displacements.iter().map(|u| SteadyMotion::of(u.as_ref()?)).collect(),
            first_alike: (0..displacements.len()).map(first).collect(),
        }
    }

    /// Residuals of the channels in runs of steady motion, without what every cycle repeats; `None` without such a run.
    fn between_cycles(&self, study: &Study, residuals: &ChannelResiduals) -> Option<ChannelResiduals> {
        let of = |((i, o), r): ((usize, &ObservedChannel), &Vec<f64>)| {
            let motion = self.steady.get(i)?.as_ref().filter(|_| r.len() == o.values.len())?;
            Some(motion.differences(r))
        };
        some(fitted_channels(study).zip(residuals).filter_map(of).collect())
    }

    /// Differences of the residuals of a channel in fitted runs of one motion from those in the first of them; `None` without
    /// two such runs.
    fn between_runs(&self, study: &Study, residuals: &ChannelResiduals) -> Option<ChannelResiduals> {
        let all: Vec<((usize, &ObservedChannel), &Vec<f64>)> = fitted_channels(study).zip(residuals).collect();
        let of = |((i, o), r): &((usize, &ObservedChannel), &Vec<f64>)| {
            let group = self.first_alike.get(*i)?;
            let is_first = |((k, other), x): &&((usize, &ObservedChannel), &Vec<f64>)| {
                self.first_alike.get(*k) == Some(group) && other.channel == o.channel && x.len() == r.len()
            };
            let ((first, _), x) = all.iter().find(is_first)?;
            let whole = first != i && r.len() == o.values.len();
            whole.then(|| r.iter().zip(*x).map(|(a, b)| a - b).collect())
        };
        some(all.iter().filter_map(of).collect())
    }
}

fn fitted_channels(study: &Study) -> impl Iterator<Item = (usize, &ObservedChannel)> {
    study.runs_of(Role::Fit).flat_map(|(i, run)| run.observe.iter().map(move |o| (i, o)))
}

fn some(residuals: ChannelResiduals) -> Option<ChannelResiduals> {
    (!residuals.is_empty()).then_some(residuals)
}

/// Raises a changed condition to its evidence from what differs where a motion repeats, over the user's model, and sorts the
/// hypotheses again. Cycles tell one for a part of a run, and runs of one motion tell one of a run.
pub(crate) fn compare_repeated(study: &Study, all: &mut [FittedHypothesis], motions: &RepeatedMotions) {
    all.iter_mut().for_each(|e| e.repeated_share = None);
    let is_in_time = |e: &FittedHypothesis| !e.variant.change_point_coordinates().is_empty();
    let is_condition = |e: &FittedHypothesis| e.cause() == changed_condition::CAUSE;
    raise(all, |e| is_condition(e) && is_in_time(e), |r| motions.between_cycles(study, r));
    let is_of_run = |e: &FittedHypothesis| is_condition(e) && e.variant.is_condition_of_one_run() && !is_in_time(e);
    raise(all, is_of_run, |r| motions.between_runs(study, r));
    all.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
}

/// Raises conditions to their evidence from a part of the residuals, if that leads every other cause there. A wrong range in one
/// run is another value of a parameter, if that explains as much.
fn raise(
    all: &mut [FittedHypothesis],
    is_raised: impl Fn(&FittedHypothesis) -> bool,
    part: impl Fn(&ChannelResiduals) -> Option<ChannelResiduals>,
) {
    let parts: Vec<Option<ChannelResiduals>> = all.iter().map(|e| part(e.held_out.as_ref()?)).collect();
    let square = |r: &ChannelResiduals| r.iter().map(|x| power(x)).sum::<f64>();
    let Some(least) = parts.iter().flatten().min_by(|a, b| square(a).total_cmp(&square(b))) else { return };
    let noise = NoiseModel::of(least);
    let evidence = |(e, r): (&FittedHypothesis, &Option<ChannelResiduals>)| {
        let of = |r| prior_log_odds(e) + noise.log_evidence(r, e.variant.counted_parameters());
        r.as_ref().map_or(f64::NEG_INFINITY, of)
    };
    let evidence: Vec<f64> = all.iter().zip(&parts).map(evidence).collect();
    let Some(none) = all.iter().position(|e| e.cause() == "none") else { return };
    let most = |raised: bool| {
        let is_single = |e: &FittedHypothesis| e.second_cause().is_none() && !e.variant.has_range_fault_in_one_run();
        let of = all.iter().zip(&evidence).filter(|(e, _)| is_raised(e) == raised && is_single(e));
        of.map(|(_, x)| *x).fold(f64::NEG_INFINITY, f64::max)
    };
    if most(true) < most(false) + REPEATED_MOTION_LOG_ODDS {
        return;
    }
    let of_none = all[none].log_evidence;
    let Some(before) = parts[none].as_ref().map(square) else { return };
    for ((e, own), after) in all.iter_mut().zip(&evidence).zip(&parts).filter(|((e, _), _)| is_raised(e)) {
        e.log_evidence = e.log_evidence.max(of_none + own - evidence[none]);
        let share = after.as_ref().map(|r| 1.0 - square(r) / before);
        e.repeated_share = share.filter(|share| *share >= MIN_TAKEN_SHARE);
    }
}

#[cfg(test)]
mod tests {
    use super::{RepeatedMotions, SteadyMotion, compare_repeated};
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
        let mut steady = vec![None; study.runs.len()];
        steady[run] = Some(motion);
        let motions = RepeatedMotions { steady, first_alike: (0..study.runs.len()).collect() };
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
            compare_repeated(&study, &mut all, &motions);
            (all[0].cause(), all.iter().any(|e| e.repeated_share.is_some()))
        };
        assert_eq!(told(1.0), ("changed_condition", true));
        assert_eq!(told(0.0), ("none", false));
    }

    /// Of three runs two have one motion. What both lack is no difference between them.
    #[test]
    fn runs_of_one_motion_differ_by_what_changed() {
        let wave = |phase: f64| Some(series(400, |i| (TAU * i / 50.0 + phase).sin()));
        let motions = RepeatedMotions::of(&[wave(0.0), wave(1.0), wave(0.01), None]);
        assert_eq!(motions.first_alike, [0, 1, 0, 3]);
        let mut study = (*baseline().variant.study).clone();
        let first = study.runs.iter().find(|r| r.role == Role::Fit).expect("a fitted run").clone();
        study.runs = vec![first; 3];
        let (n, channels) = (study.runs[0].observe[0].values.len(), study.runs[0].observe.len());
        let lacked = series(n, |i| (TAU * i / 25.0).sin());
        let of_run = |more: f64| vec![lacked.iter().map(|x| x + more).collect::<Vec<f64>>(); channels];
        let residuals = [of_run(0.0), of_run(5.0), of_run(2.0)].concat();
        let found = motions.between_runs(&study, &residuals).expect("two runs of one motion");
        assert_eq!(found.len(), channels);
        assert!(found.iter().flatten().all(|x| (x - 2.0).abs() < 1e-12));
        let apart = RepeatedMotions::of(&[wave(0.0), wave(1.0), wave(2.0)]);
        assert!(apart.between_runs(&study, &residuals).is_none());
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
