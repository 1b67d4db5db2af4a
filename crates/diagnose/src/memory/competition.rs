//! Choice of the terms of a law, and of the family of memory.

use super::data::{Data, DeviceRun, Mode};
use super::family::Family;
use super::law::{Coefficients, Fitter, Group, Law, STRENGTH_STEP, Shape, TARGETS, signs};
use super::least_squares::dot;
use super::slow_variables::{SlowVariable, factors, forces, with_level};
use crate::prior::{ENTERING_TERM, MAX_COMPARED_SHAPE_RATIO, MAX_COMPARED_TERMS};
use hysteron_engine::element::amendment::learned::{Admitted, Target};
use hysteron_engine::numeric::axpy;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Result of a family: the best law that remembers this alone.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct FamilyResult {
    /// Name of the family.
    pub family: String,
    /// Name of the recorded channel that it follows; empty for others.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub channel: String,
    /// Mean NMSE on blocks that were held back.
    pub blocks: f64,
    /// Mean NMSE on fitted runs held back as a whole.
    pub whole_runs: f64,
    /// Logarithm of the error on blocks and whole runs over that of the best law of all families, nats; 0 for the best.
    pub behind: f64,
    /// Mean NMSE of the runs held out of the study; none without such runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_out: Option<f64>,
    /// Terms of the law, in words.
    pub terms: Vec<String>,
}

/// Candidates of the score test that are cross-validated.
const CROSS_VALIDATED: usize = 5;
/// Steps of Gauss and Newton in a fold, and in a fit of all samples.
const FOLD_STEPS: usize = 3;
const FIT_STEPS: usize = 8;
/// Slip levels over that of a law that are tried when a term enters, and when it has entered.
const COARSE_LEVELS: [f64; 3] = [0.75, 1.15, 1.35];
const FINE_LEVELS: [f64; 4] = [0.9, 0.95, 1.05, 1.1];
/// Slip levels that are tried, and again around the best.
const LEVELS: usize = 16;

/// Errors on what was held back.
#[derive(Clone, Debug)]
pub(super) struct HeldBack {
    pub(super) pooled: f64,
    pub(super) folds: Vec<f64>,
}

impl HeldBack {
    /// Change of the logarithm of the error: half of the pooled one, half of the mean over the folds.
    pub(super) fn change_from(&self, old: &Self) -> f64 {
        let ratio = |new: f64, old: f64| (new.max(f64::MIN_POSITIVE) / old.max(f64::MIN_POSITIVE)).ln();
        let folds: f64 = self.folds.iter().zip(&old.folds).map(|(a, b)| ratio(*a, *b)).sum();
        0.5 * ratio(self.pooled, old.pooled) + 0.5 * folds / old.folds.len() as f64
    }
}

/// Competition over the samples of one device.
pub(super) struct Competition<'a> {
    pub(super) data: &'a Data,
    pub(super) fitter: Fitter<'a>,
}

/// Results of all families, the best first; empty if the runs do not suffice.
pub(crate) fn compete(runs: Vec<DeviceRun>, has_clock: bool) -> Vec<FamilyResult> {
    let Some(data) = Data::new(runs, has_clock) else { return vec![] };
    let competition = Competition { data: &data, fitter: Fitter::new(&data) };
    let base = competition.base();
    let start = competition.held_back(&base);
    let mut all: Vec<(f64, FamilyResult)> = vec![];
    for (family, condition) in data.families() {
        let (law, errors) = competition.learn(&[(family, condition)], MAX_COMPARED_TERMS, base.clone(), start.clone());
        let channel = condition.map_or_else(String::new, |i| data.runs[0].conditions[i].name.clone());
        all.push((errors.change_from(&start), competition.result(family, channel, &law, &errors)));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let best = all.first().map_or(0.0, |x| x.0);
    all.into_iter().map(|(change, r)| FamilyResult { behind: change - best, ..r }).collect()
}

impl Competition<'_> {
    /// Spring and slip without a memory: the best shape and level.
    pub(super) fn base(&self) -> Law {
        let (shapes, user) = self.shapes();
        let of_user = self.held_back(&user).pooled;
        let near = shapes
            .iter()
            .map(|l| (self.held_back(l).pooled, l))
            .filter(|(e, _)| *e <= MAX_COMPARED_SHAPE_RATIO * of_user);
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(user, |x| x.1.clone())
    }

    /// The best plain shape, and the user's law.
    pub(super) fn plain_and_user(&self) -> (Option<Law>, Law) {
        let (shapes, user) = self.shapes();
        let with_errors = shapes.into_iter().map(|l| (self.held_back(&l).pooled, l));
        (with_errors.min_by(|a, b| a.0.total_cmp(&b.0)).map(|x| x.1), user)
    }

    /// Each plain shape at its best level, and the user's law.
    fn shapes(&self) -> (Vec<Law>, Law) {
        let law = |shape, level| Law { shape, level, groups: vec![], factors: vec![], forces: vec![] };
        let u = self.data.scales.deformation;
        let error = |l: &Law| self.error(l, &self.fitter.fit(l, &self.data.fitted, 0, &[]), &self.data.fitted);
        let best = |shape: Shape, levels: &mut dyn Iterator<Item = f64>| -> Option<Law> {
            let all = levels.map(|level| law(shape, level)).map(|l| (error(&l), l));
            all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|x| x.1)
        };
        let of_shape = |shape: Shape| {
            let last = (LEVELS - 1) as f64;
            let coarse = best(shape, &mut (0..LEVELS).map(|k| u * 0.003 * 300f64.powf(k as f64 / last)))?;
            let near =
                |level: f64, ratio: f64| (0..LEVELS).map(move |k| level * ratio.powf(2.0 * k as f64 / last - 1.0));
            let fine = best(shape, &mut near(coarse.level, 1.45))?;
            best(shape, &mut near(fine.level, 1.05))
        };
        let shapes: Vec<Law> = [Shape::Bilinear, Shape::BoucWen].into_iter().filter_map(of_shape).collect();
        // Work and slip of the user's law are those of the best stop.
        let level = shapes.first().map_or(u, |l| l.level);
        (shapes, law(Shape::User, level))
    }

    /// Sum of the weighted squares over some samples.
    pub(super) fn error(&self, law: &Law, c: &Coefficients, rows: &[bool]) -> f64 {
        let value = self.fitter.value(law, c);
        let d = self.data;
        (0..rows.len()).filter(|i| rows[*i]).map(|i| ((value[i] - d.recorded[i]) * d.weight[i]).powi(2)).sum()
    }

    /// Errors on blocks and whole runs that are held back in turn.
    pub(super) fn held_back(&self, law: &Law) -> HeldBack {
        let d = self.data;
        if d.mode == Mode::Engine {
            return self.linear_held_back(law);
        }
        let start = self.fitter.fit(law, &d.fitted, FIT_STEPS, &[]).factors;
        let of_fold = |held: &Vec<bool>| {
            let kept: Vec<bool> = d.fitted.iter().zip(held).map(|(f, h)| *f && !*h).collect();
            self.error(law, &self.fitter.fit(law, &kept, FOLD_STEPS, &start), held)
        };
        let folds: Vec<f64> = d.folds.iter().map(of_fold).collect();
        let (blocks, whole) = folds.split_at(d.block_folds);
        HeldBack { pooled: 0.5 * (blocks.iter().sum::<f64>() + d.whole_factor * whole.iter().sum::<f64>()), folds }
    }

    /// Adds terms of some families one at a time while the errors fall, and takes out those that they do not need.
    pub(super) fn learn(
        &self,
        families: &[(Family, Option<usize>)],
        max_terms: usize,
        base: Law,
        start: HeldBack,
    ) -> (Law, HeldBack) {
        let shape = [(Family::Shape, None)];
        let all = || families.iter().chain(shape.iter().filter(|s| !families.contains(s)));
        let of_level = |level: f64| -> Vec<Rc<SlowVariable>> {
            all().flat_map(|(f, c)| factors(self.data, *f, *c, level)).map(Rc::new).collect()
        };
        let mut variables = of_level(base.level);
        let forces: Vec<Rc<SlowVariable>> =
            families.iter().flat_map(|(f, c)| forces(self.data, *f, *c)).map(Rc::new).collect();
        let (mut law, mut errors) = (base, start);
        while law.terms() < max_terms {
            let tried = self.candidates(&law, families, &variables, &forces);
            let weighed = tried.into_iter().map(|l| self.at_best_level(l, &COARSE_LEVELS));
            let best = weighed.min_by(|a, b| a.0.change_from(&errors).total_cmp(&b.0.change_from(&errors)));
            let Some((_, l)) = best.filter(|(e, _)| e.change_from(&errors) < -ENTERING_TERM) else { break };
            let (e, l) = self.at_best_level(l, &FINE_LEVELS);
            // A law of the engine has one level.
            if self.data.mode == Mode::Engine && l.level != law.level {
                variables = of_level(l.level);
            }
            (law, errors) = (l, e);
        }
        self.without_needless(law, errors)
    }

    /// A law at another slip level.
    pub(super) fn at_level(&self, law: &Law, level: f64) -> Law {
        let mut other = Law { level, ..law.clone() };
        if self.data.mode == Mode::Engine {
            for (_, v) in &mut other.factors {
                *v = with_level(self.data, v, level);
            }
        }
        other
    }

    /// A law at the best of some slip levels over its own, where a factor acts on its strength: such a factor is one where
    /// nothing is remembered yet, so that the level of the law without it is too low or too high.
    pub(super) fn at_best_level(&self, law: Law, ratios: &[f64]) -> (HeldBack, Law) {
        if law.shape == Shape::User || law.factors.iter().all(|(t, _)| *t != Target::Strength) {
            return (self.held_back(&law), law);
        }
        if self.data.mode == Mode::Engine {
            let error =
                |l: &Law| self.error(l, &self.fitter.fit(l, &self.data.fitted, FOLD_STEPS, &[]), &self.data.fitted);
            let all = ratios.iter().map(|r| self.at_level(&law, r * law.level)).chain([law.clone()]);
            let best = all.map(|l| (error(&l), l)).min_by(|a, b| a.0.total_cmp(&b.0)).map_or(law, |x| x.1);
            return (self.held_back(&best), best);
        }
        let own = self.held_back(&law);
        let others = ratios.iter().map(|r| self.at_level(&law, r * law.level)).map(|l| (self.held_back(&l), l));
        let best = others.min_by(|a, b| a.0.pooled.total_cmp(&b.0.pooled));
        best.filter(|(e, _)| e.pooled < own.pooled).unwrap_or((own, law))
    }

    /// Takes out terms without which the error hardly grows.
    pub(super) fn without_needless(&self, mut law: Law, mut errors: HeldBack) -> (Law, HeldBack) {
        loop {
            let shorter = |k: usize| {
                let mut l = law.clone();
                let (g, f) = (l.groups.len(), l.factors.len());
                if k < g {
                    l.groups.remove(k);
                } else if k < g + f {
                    l.factors.remove(k - g);
                } else {
                    l.forces.remove(k - g - f);
                }
                (self.held_back(&l), l)
            };
            let found = (0..law.terms()).map(shorter).find(|(e, _)| e.change_from(&errors) < 0.5 * ENTERING_TERM);
            let Some((e, l)) = found.filter(|_| law.terms() > 1) else { return (law, errors) };
            (law, errors) = (l, e);
        }
    }

    /// Laws with one more term: the best factors and forces by a score test, and all groups of the family.
    fn candidates(
        &self,
        law: &Law,
        families: &[(Family, Option<usize>)],
        variables: &[Rc<SlowVariable>],
        forces: &[Rc<SlowVariable>],
    ) -> Vec<Law> {
        let d = self.data;
        let c = self.fitter.fit(law, &d.fitted, FOLD_STEPS, &[]);
        let columns = self.fitter.columns(law, &c.factors);
        let value = self.fitter.value(law, &c);
        let scaled = |x: &[f64]| -> Vec<f64> {
            (0..x.len()).map(|i| if d.fitted[i] { x[i] * d.weight[i] } else { 0.0 }).collect()
        };
        let rest: Vec<f64> = d.recorded.iter().zip(&value).map(|(y, v)| y - v).collect();
        let rest = scaled(&rest);
        let known = columns.all.iter().cloned().chain(self.fitter.derivatives(law, &c, &columns));
        let basis = orthonormal(known.map(|x| scaled(&x)));
        // What a column takes from the residual beside those that the law has.
        let score = |x: &[f64]| {
            let mut x = scaled(x);
            let before = dot(&x, &x);
            project_out(&basis, &mut x);
            let left = dot(&x, &x);
            if left > 1e-8 * before { dot(&x, &rest).powi(2) / left } else { 0.0 }
        };
        let mut scored: Vec<(f64, Law)> = vec![];
        for v in variables {
            let takes = |t: &Target| signs(d.mode, *t, v, law) != Admitted::None;
            for target in TARGETS.into_iter().filter(takes) {
                if law.factors.iter().any(|(t, w)| *t == target && w.name == v.name && w.family == v.family) {
                    continue;
                }
                let mut longer = law.clone();
                longer.factors.push((target, v.clone()));
                let mut at = c.clone();
                at.factors.push(0.0);
                let derivative = self.fitter.derivatives(&longer, &at, &columns).pop().unwrap_or_default();
                scored.push((score(&derivative), longer));
            }
        }
        for f in forces.iter().filter(|f| law.forces.iter().all(|g| !Rc::ptr_eq(f, g))) {
            let mut longer = law.clone();
            longer.forces.push(f.clone());
            scored.push((score(&f.at_samples), longer));
        }
        scored.sort_by(|a, b| b.0.total_cmp(&a.0));
        let of_group = |(group, of): &(Group, Family)| {
            let is_asked = *of == Family::Shape || families.iter().any(|(f, _)| f == of);
            let fits = is_asked && !law.groups.contains(group) && group.is_of(d.mode);
            let has_clock = d.has_clock || !group.needs_clock();
            let mut longer = law.clone();
            longer.groups.push(*group);
            (fits && has_clock && longer.is_admitted(d.mode)).then_some(longer)
        };
        let best = scored.into_iter().take(CROSS_VALIDATED).map(|x| x.1);
        best.chain(Group::ALL.iter().filter_map(of_group)).collect()
    }

    fn result(&self, family: Family, channel: String, law: &Law, errors: &HeldBack) -> FamilyResult {
        let d = self.data;
        let c = self.fitter.fit(law, &d.fitted, FIT_STEPS, &[]);
        let value = self.fitter.value(law, &c);
        let held: Vec<usize> = (0..d.runs.len()).filter(|k| d.runs[*k].held_out).collect();
        let of_run = |k: &usize| -> f64 {
            let own = (0..d.samples.len()).filter(|i| d.samples[*i].0 == *k);
            own.map(|i| ((value[i] - d.recorded[i]) * d.weight[i]).powi(2)).sum()
        };
        let held_out = (!held.is_empty()).then(|| held.iter().map(of_run).sum::<f64>() / held.len() as f64);
        let mut terms: Vec<String> = law.groups.iter().map(|g| format!("{g:?}").to_lowercase()).collect();
        for ((target, v), a) in law.factors.iter().zip(&c.factors) {
            terms.push(format!("{} x (1 {a:+.3} {})", target.in_words(), v.name));
        }
        terms.extend(law.forces.iter().map(|f| format!("force by {}", f.name)));
        let (blocks, whole) = errors.folds.split_at(d.block_folds);
        FamilyResult {
            family: family.name().into(),
            channel,
            blocks: blocks.iter().sum(),
            whole_runs: d.whole_factor * whole.iter().sum::<f64>(),
            behind: 0.0,
            held_out,
            terms,
        }
    }
}

/// Takes the components along an orthonormal basis out of a vector.
fn project_out(basis: &[Vec<f64>], x: &mut [f64]) {
    for q in basis {
        axpy(-dot(q, x), q, x);
    }
}

/// Orthonormal basis of some vectors; those that depend on others are left out.
fn orthonormal(vectors: impl Iterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = vec![];
    for mut x in vectors {
        let before = dot(&x, &x).sqrt();
        // Twice, against round-off.
        project_out(&basis, &mut x);
        project_out(&basis, &mut x);
        let left = dot(&x, &x).sqrt();
        if left > STRENGTH_STEP * 1e-4 * before && left > 0.0 {
            x.iter_mut().for_each(|x| *x /= left);
            basis.push(x);
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use super::compete;
    use crate::test_support::slider_runs as runs;

    #[test]
    fn the_family_of_a_memory_is_found() {
        let found = |family: &str, factor: &dyn Fn(f64, f64, f64) -> f64| {
            let all = compete(runs(factor), true);
            assert_eq!(all[0].family, family, "{all:#?}");
        };
        found("work", &|_, work, _| 1.0 - 0.4 * (1.0 - (-work / 15.0).exp()));
        found("clock", &|t, _, _| 1.0 - 0.35 * t / 36.0);
        found("rest", &|_, _, aged| 1.0 + 0.3 * aged);
    }

    /// Without a memory no family gains over another shape, and the error is that of the noise.
    #[test]
    fn nothing_is_remembered_where_nothing_is() {
        let all = compete(runs(|_, _, _| 1.0), true);
        assert!(all.iter().all(|f| f.behind < 0.08), "{all:?}");
        let signal = 0.6f64;
        assert!(all.iter().all(|f| f.blocks < 3.0 * 1e-4 / signal), "{all:?}");
        assert!(compete(vec![], true).is_empty());
    }

    #[test]
    fn without_a_clock_no_family_needs_one() {
        let all = compete(runs(|_, work, _| 1.0 - 0.01 * work), false);
        assert!(all.iter().all(|f| !["clock", "heat", "rate", "rest"].contains(&f.family.as_str())));
        assert_eq!(all[0].family, "work");
    }
}
