//! A law of the engine from runs of a device.

use super::competition::{Competition, HeldBack};
use super::data::{Data, DeviceRun, Mode};
use super::family::Family;
use super::law::{Fitter, Law, Shape};
use super::learned_law::{engine_law, used_conditions};
use super::slow_variables::{Kind, with_variable};
use crate::prior::{
    CLOCK_LEAD, ENTERING_FAMILY, ENTERING_SLOPES, MAX_LEARNED_SHAPE_RATIO, MAX_LEARNED_TERMS, SECOND_FAMILY_TERMS,
};
use hysteron_engine::element::amendment::learned::LearnedLaw;

/// A law of the engine with its errors.
#[derive(Clone, Debug)]
pub struct Learned {
    /// The law.
    pub law: LearnedLaw,
    /// Its kinds of memory, the first one that of most effect; names of recorded channels where it follows some.
    pub families: Vec<(Family, String)>,
    /// Mean NMSE on blocks held back, and on fitted runs held back as a whole.
    pub blocks: f64,
    /// Mean NMSE on fitted runs held back as a whole, or on the end of a single one.
    pub whole_runs: f64,
    /// Mean NMSE of the fitted runs.
    pub fitted: f64,
    /// Mean NMSE of the runs held out; none without such runs.
    pub held_out: Option<f64>,
    /// The same if slow variables go on beyond the range of the fitted runs.
    pub held_out_beyond: Option<f64>,
    /// Mean NMSE of the user's fitted law on the fitted runs.
    pub user_fitted: f64,
    /// Mean NMSE of the user's fitted law on the runs held out.
    pub user_held_out: Option<f64>,
    /// Share of the steps of the runs held out that lie outside the range of the law.
    pub outside: f64,
    /// Change of the logarithm of the error held back of the law of each other kind of memory over this one, nats.
    pub rivals: Vec<(Family, String, f64)>,
}

/// Steps of Gauss and Newton in the last fit.
const LAST_STEPS: usize = 12;
/// Ratios by which constants and levels are refined in turn.
const RATIOS: [f64; 3] = [1.5, 1.15, 1.04];
/// Changes of the slopes of hysteresis in turn.
const SLOPE_STEPS: [f64; 3] = [0.3, 0.1, 0.03];

type Families = Vec<(Family, Option<usize>)>;

/// A law with its errors on what was held back.
#[derive(Clone)]
struct Candidate {
    families: Families,
    law: Law,
    errors: HeldBack,
}

impl Candidate {
    fn change_from(&self, other: &Self) -> f64 {
        self.errors.change_from(&other.errors)
    }

    fn has_clock(&self) -> bool {
        self.families.iter().any(|f| f.0 == Family::Clock)
    }
}

/// The law that leaves least on blocks and runs held back; `None` if the runs do not suffice.
pub(crate) fn learn(runs: Vec<DeviceRun>, has_clock: bool) -> Option<Learned> {
    let all_runs = Data { mode: Mode::Engine, ..Data::new(runs, has_clock)? };
    // The competition does not see what is held out.
    let fitted: Vec<DeviceRun> = all_runs.runs.iter().filter(|r| !r.held_out).cloned().collect();
    let data = Data { mode: Mode::Engine, ..Data::new(fitted, has_clock)? };
    let c = Competition { data: &data, fitter: Fitter::new(&data) };
    let all = data.families();
    let mut found: Vec<Candidate> = vec![];
    for base in bases(&c) {
        let errors = c.held_back(&base);
        for family in &all {
            let (law, errors) = c.learn(&[*family], MAX_LEARNED_TERMS, base.clone(), errors.clone());
            found.push(Candidate { families: vec![*family], law, errors });
        }
    }
    let reference = found.first()?.clone();
    found.sort_by(|a, b| a.change_from(&reference).total_cmp(&b.change_from(&reference)));
    let best = first_but_the_clock(&found);
    let pair = best_pair(&c, &found, &best, &all);
    // A law that the rules of energy refuse gives way to the next one.
    let (chosen, best, last, law) = std::iter::once(&pair).chain(&found).find_map(|f| {
        let best = refined(&c, f.clone());
        let last = c.fitter.fit(&best.law, &data.fitted, LAST_STEPS, &[]);
        let law = engine_law(&c.fitter, &best.law, &last)?;
        Some((f, best, last, law))
    })?;
    let channel =
        |f: &(Family, Option<usize>)| (f.0, f.1.map_or_else(String::new, |i| data.runs[0].conditions[i].name.clone()));
    let rivals = rivals(&found, chosen).iter().map(|(f, behind)| (channel(f).0, channel(f).1, *behind)).collect();
    let mean = |held_out: bool, of_run: &dyn Fn(usize) -> f64| {
        let own: Vec<usize> = (0..all_runs.runs.len()).filter(|k| all_runs.runs[*k].held_out == held_out).collect();
        (!own.is_empty()).then(|| own.iter().map(|k| of_run(*k)).sum::<f64>() / own.len() as f64)
    };
    let errors = RunErrors { data: &all_runs, used: &used_conditions(&best.law) };
    let of_user = errors.of_user();
    let (of_law, outside) = errors.of_law(&law);
    let (beyond, _) = errors.of_law(&LearnedLaw { goes_on: true, ..law.clone() });
    let (blocks, whole) = best.errors.folds.split_at(data.block_folds);
    Some(Learned {
        law,
        families: best.families.iter().map(channel).collect(),
        blocks: blocks.iter().sum(),
        whole_runs: data.whole_factor * whole.iter().sum::<f64>(),
        fitted: c.error(&best.law, &last, &data.fitted),
        held_out: mean(true, &|k| of_law[k]),
        held_out_beyond: mean(true, &|k| beyond[k]),
        user_fitted: mean(false, &|k| of_user[k])?,
        user_held_out: mean(true, &|k| of_user[k]),
        outside: mean(true, &|k| outside[k]).unwrap_or(0.0),
        rivals,
    })
}

/// Laws without a memory on which others are built: the best plain shape, and the user's law.
fn bases(c: &Competition<'_>) -> Vec<Law> {
    let best = c.base();
    let (plain, user) = c.plain_and_user();
    let limit = MAX_LEARNED_SHAPE_RATIO * c.held_back(&user).pooled;
    let mut out = vec![best];
    for law in [plain, Some(user)].into_iter().flatten() {
        let is_known = out.iter().any(|l| l.shape == law.shape);
        if !is_known && (law.shape == Shape::User || c.held_back(&law).pooled <= limit) {
            out.push(law);
        }
    }
    out
}

/// Kinds of memory that a law does not have, the best first, with the change of the logarithm of the error of their own law.
fn rivals(found: &[Candidate], best: &Candidate) -> Vec<((Family, Option<usize>), f64)> {
    let mut known = best.families.clone();
    let mut out = vec![];
    for f in found {
        if !known.contains(&f.families[0]) {
            known.push(f.families[0]);
            out.push((f.families[0], f.change_from(best)));
        }
    }
    out
}

/// The first law, or the first one without a clock if the clock leads by little.
fn first_but_the_clock(found: &[Candidate]) -> Candidate {
    let other = found.iter().find(|c| !c.has_clock()).filter(|c| c.change_from(&found[0]) < CLOCK_LEAD);
    other.filter(|_| found[0].has_clock()).unwrap_or(&found[0]).clone()
}

/// The best law with a second kind of memory. Where one of both is elapsed time, a pair is built on the next kind as well: of two
/// kinds that act together, neither need be the best alone, and a clock stands for both.
fn best_pair(c: &Competition<'_>, found: &[Candidate], best: &Candidate, all: &Families) -> Candidate {
    let of_best = with_second_family(c, best, all);
    let next = found.iter().find(|f| of_best.has_clock() && !f.has_clock() && f.families[0] != best.families[0]);
    let of_next = next.map(|f| with_second_family(c, f, all));
    of_next.filter(|f| !f.has_clock() && f.change_from(&of_best) < CLOCK_LEAD).unwrap_or(of_best)
}

/// A second kind of memory, where it takes enough of what the first leaves.
fn with_second_family(c: &Competition<'_>, best: &Candidate, all: &Families) -> Candidate {
    let first = best.families[0];
    let second = |family: &(Family, Option<usize>)| {
        let families = vec![first, *family];
        let terms = best.law.terms() + SECOND_FAMILY_TERMS;
        let (law, errors) = c.learn(&families, terms, best.law.clone(), best.errors.clone());
        Candidate { families, law, errors }
    };
    let others = all.iter().filter(|f| **f != first && f.0 != Family::Shape).map(second);
    let found = others.min_by(|a, b| a.change_from(best).total_cmp(&b.change_from(best)));
    found.filter(|f| f.change_from(best) < -ENTERING_FAMILY).unwrap_or_else(|| best.clone())
}

/// Time constants, widths, the slip level and the slopes of hysteresis, refined in turn.
fn refined(c: &Competition<'_>, best: Candidate) -> Candidate {
    let mut best = best;
    let with_law = |best: &Candidate, law: Law| {
        let errors = c.held_back(&law);
        Candidate { families: best.families.clone(), law, errors }
    };
    let take = |best: &mut Candidate, laws: Vec<Law>, least: f64| {
        let tried = laws.into_iter().map(|l| with_law(best, l));
        let found = tried.min_by(|a, b| a.change_from(best).total_cmp(&b.change_from(best)));
        if let Some(f) = found.filter(|f| f.change_from(best) < -least) {
            *best = f;
        }
    };
    for step in RATIOS {
        for k in 0..best.law.factors.len() {
            let (_, v) = &best.law.factors[k];
            let Kind::Variable(variable) = v.kind else { continue };
            let others = [step, 1.0 / step].into_iter().flat_map(|r| variable.with_constants_times(r));
            let laws = others.map(|variable| {
                let mut law = best.law.clone();
                law.factors[k].1 = with_variable(c.data, v, variable, law.level);
                law
            });
            let laws: Vec<Law> = laws.collect();
            take(&mut best, laws, 0.0);
        }
        if best.law.shape != Shape::User {
            let laws = [step, 1.0 / step].map(|r| c.at_level(&best.law, r * best.law.level));
            take(&mut best, laws.to_vec(), 0.0);
        }
    }
    if best.law.shape == Shape::BoucWen {
        let mut curved = with_law(&best, Law { shape: Shape::Curve([1.0, 1.0, 0.5, 0.0]), ..best.law.clone() });
        // A factor on the strength needs one slope of unloading.
        let takes_strength = best.law.factors.iter().any(|(t, _)| t.word() == "strength");
        for step in SLOPE_STEPS {
            for i in usize::from(takes_strength) * 2..4 {
                let Shape::Curve(slopes) = curved.law.shape else { continue };
                let changed = [step, -step].map(|by| {
                    let mut s = slopes;
                    s[i] = (s[i] + by).max(if i < 2 { 0.1 } else { 0.0 });
                    // Loading is at most as steep as unloading.
                    (s[2], s[3]) = (s[2].min(s[1]), s[3].min(s[0]));
                    Law { shape: Shape::Curve(s), ..curved.law.clone() }
                });
                take(&mut curved, changed.to_vec(), 0.0);
            }
        }
        if curved.change_from(&best) < -ENTERING_SLOPES {
            best = curved;
        }
    }
    best
}

/// Errors of a law and of the user's by run.
struct RunErrors<'a> {
    data: &'a Data,
    /// Conditions that the law follows.
    used: &'a [usize],
}

impl RunErrors<'_> {
    fn by_run(&self, value: &[f64]) -> Vec<f64> {
        let d = self.data;
        let mut out = vec![0.0; d.runs.len()];
        let fitted_runs = d.runs.iter().filter(|r| !r.held_out).count() as f64;
        for (i, (run, _)) in d.samples.iter().enumerate() {
            let share = if d.fitted[i] { fitted_runs } else { 1.0 };
            out[*run] += share * ((value[i] - d.recorded[i]) * d.weight[i]).powi(2);
        }
        out
    }

    /// Errors of a law of the engine, and shares of the steps outside its range, by run.
    fn of_law(&self, law: &LearnedLaw) -> (Vec<f64>, Vec<f64>) {
        let along = |r: &DeviceRun| {
            let channels = self.used.iter().map(|i| {
                let mean = self.data.scales.conditions[*i].0;
                r.conditions[*i].values.iter().map(|x| if x.is_finite() { *x } else { mean }).collect::<Vec<f64>>()
            });
            let channels: Vec<Vec<f64>> = channels.collect();
            let channels: Vec<&[f64]> = channels.iter().map(Vec::as_slice).collect();
            law.along(&r.deformation, &r.times, &r.modelled, &channels)
        };
        let (forces, shares): (Vec<Vec<f64>>, Vec<f64>) = self.data.runs.iter().map(along).unzip();
        (self.by_run(&self.data.sampled(&forces)), shares)
    }

    fn of_user(&self) -> Vec<f64> {
        self.by_run(&self.data.at_samples(|r| r.modelled.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::learn;
    use crate::memory::data::DeviceRun;
    use crate::memory::family::Family;
    use crate::test_support::{slider_runs as runs, white_noise};
    use hysteron_engine::element::amendment::learned::{Factor, LearnedLaw, Variable};

    /// Mean NMSE of a law along the fitted runs.
    fn error(law: &LearnedLaw, runs: &[DeviceRun]) -> f64 {
        let of_run = |r: &DeviceRun| {
            let (force, _) = law.along(&r.deformation, &r.times, &[], &[]);
            // The fit takes every second sample.
            let both: Vec<(f64, f64)> = force.into_iter().zip(r.recorded.iter().copied()).step_by(2).collect();
            let mean = both.iter().map(|(_, y)| y).sum::<f64>() / both.len() as f64;
            let left: f64 = both.iter().map(|(f, y)| (f - y).powi(2)).sum();
            left / both.iter().map(|(_, y)| (y - mean).powi(2)).sum::<f64>()
        };
        let fitted: Vec<f64> = runs.iter().filter(|r| !r.held_out).map(of_run).collect();
        fitted.iter().sum::<f64>() / fitted.len() as f64
    }

    /// Friction that ages at rest: the law of the engine predicts the run held out down to the noise, with the errors of the
    /// fit, and the user's law does not.
    #[test]
    fn a_law_of_the_engine_is_the_fitted_one() {
        let runs = runs(|_, _, aged| 1.0 + 0.3 * aged);
        let l = learn(runs.clone(), true).expect("a law");
        assert_eq!(l.families[0].0, Family::Rest, "{l:#?}");
        assert!(l.law.refusal().is_none());
        let (after, before) = (l.held_out.unwrap_or(1.0), l.user_held_out.unwrap_or(0.0));
        // The noise of 0.01 over a force of about 0.8.
        let noise = 1e-4 / 0.6;
        assert!(after < 3.0 * noise && after < 0.3 * before, "{after} {before}");
        let of_engine = error(&l.law, &runs);
        assert!((of_engine / l.fitted - 1.0).abs() < 0.05, "{of_engine} {}", l.fitted);
    }

    /// A contact that ages only while the device stands still, with other constants than those of the candidates: the law has
    /// that time, though the contact sticks at each turn as well.
    #[test]
    fn rest_is_told_from_sticking() {
        let noise = white_noise(9, 1200);
        let mut runs = runs(|_, _, _| 1.0);
        for r in &mut runs {
            let (motion, mut at) = (r.deformation.clone(), 0);
            let (mut s, mut plain, mut aged) = (0.0f64, 0.0f64, 0.0f64);
            for (j, noise) in noise.iter().enumerate().take(r.times.len()).skip(1) {
                // Each run stops for some seconds.
                at += usize::from(r.times[j] % 9.0 > 3.5);
                r.deformation[j] = motion[at];
                let du = motion[at] - r.deformation[j - 1];
                let level = 0.05 * (1.0 + 0.3 * aged);
                let trial = s + du;
                s = trial.clamp(-level, level);
                aged = if du == 0.0 { (aged.exp() + 0.03 / 0.5).ln() } else { aged * (-(trial - s).abs() / 0.2).exp() };
                plain = (plain + du).clamp(-0.05, 0.05);
                r.modelled[j] = motion[at] + 20.0 * plain;
                r.recorded[j] = motion[at] + 20.0 * s + 0.01 * noise;
            }
        }
        let l = learn(runs, true).expect("a law");
        assert_eq!(l.families[0].0, Family::Rest, "{l:#?}");
        let is_still = |f: &Factor| matches!(f.variable, Variable::Still { .. });
        assert!(l.law.factors.iter().any(is_still), "{:?}", l.law.factors);
        let (after, before) = (l.held_out.unwrap_or(1.0), l.user_held_out.unwrap_or(0.0));
        assert!(after < 0.3 * before, "{after} {before} {:?}", l.law.factors);
    }

    /// Without a memory nothing is gained over the noise, and the law stays short.
    #[test]
    fn a_law_without_memory_stays_plain() {
        let l = learn(runs(|_, _, _| 1.0), true).expect("a law");
        assert!(l.held_out.unwrap_or(1.0) < 2e-4 / 0.6, "{l:?}");
        assert!(l.law.factors.len() <= 1, "{l:?}");
        assert!(learn(vec![], true).is_none());
    }
}
