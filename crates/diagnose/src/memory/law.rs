//! A law with memory, and its fit.

use super::data::Data;
use super::family::Family;
use super::least_squares::weights;
use super::operators::{bouc_wen, maxwell, speed, stop};
use super::slow_variables::SlowVariable;
use nalgebra::{DMatrix, DVector};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Form of the hysteretic part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Shape {
    /// A stop.
    Bilinear,
    /// Bouc and Wen's, of exponent one.
    BoucWen,
    /// The force of the user's fitted law.
    User,
}

/// Columns that enter together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Group {
    /// Elastic pieces, alike on both sides.
    Hinges,
    /// Stops of ten levels.
    Stops,
    /// Elastic pieces of each side.
    Sides,
    /// Another strength of the positive side.
    Unequal,
    /// Maxwell elements.
    Maxwell,
    /// Dashpots of several powers.
    Dashpots,
    /// Friction smoothed over the speed.
    Viscous,
}

impl Group {
    /// All groups with their families.
    pub(super) const ALL: [(Self, Family); 7] = [
        (Self::Hinges, Family::Shape),
        (Self::Stops, Family::Shape),
        (Self::Viscous, Family::Shape),
        (Self::Sides, Family::Side),
        (Self::Unequal, Family::Side),
        (Self::Maxwell, Family::Rate),
        (Self::Dashpots, Family::Rate),
    ];

    /// Returns true for elastic pieces.
    fn is_elastic(self) -> bool {
        matches!(self, Self::Hinges | Self::Sides)
    }
}

/// Part of the force on which a factor acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    Elastic,
    Hysteretic,
    Whole,
    Strength,
}

impl Target {
    pub(super) const ALL: [Self; 4] = [Self::Elastic, Self::Hysteretic, Self::Whole, Self::Strength];

    /// Returns true if a factor of the family keeps the energy of the law bounded, and the shape has the target.
    pub(super) fn takes(self, family: Family, shape: Shape) -> bool {
        match self {
            Self::Strength => shape != Shape::User,
            _ if shape == Shape::User => true,
            Self::Elastic => !matches!(family, Family::Rate | Family::Rest),
            _ => !family.is_fast() && !matches!(family, Family::Largest | Family::Shape),
        }
    }
}

/// A law: its parts and the slow variables of its factors.
#[derive(Clone)]
pub(super) struct Law {
    pub(super) shape: Shape,
    pub(super) level: f64,
    pub(super) groups: Vec<Group>,
    pub(super) factors: Vec<(Target, Rc<SlowVariable>)>,
    pub(super) forces: Vec<Rc<SlowVariable>>,
}

impl Law {
    /// Number of terms that have entered.
    pub(super) fn terms(&self) -> usize {
        self.groups.len() + self.factors.len() + self.forces.len()
    }
}

/// Values of a law's coefficients: weights of the columns, and factors.
#[derive(Clone, Default)]
pub(super) struct Coefficients {
    weights: Vec<f64>,
    pub(super) factors: Vec<f64>,
}

/// Columns of a law at given factors.
pub(super) struct Columns {
    /// Columns in the order elastic, hysteretic, viscous, forces; before their factors.
    raw: Vec<Rc<Vec<f64>>>,
    /// Numbers of columns of each kind.
    counts: [usize; 4],
    /// The same with their factors.
    pub(super) all: Vec<Vec<f64>>,
}

/// Number of stops of their group.
const STOP_LEVELS: usize = 10;

/// Level of a stop of the group over the largest deformation: geometric from 0.004 to 0.8.
fn stop_level(k: usize) -> f64 {
    0.004 * 200f64.powf(k as f64 / (STOP_LEVELS - 1) as f64)
}

/// Least and largest factor.
const FACTOR_RANGE: [f64; 2] = [0.05, 5.0];
/// Largest coefficient of a slow variable, and its largest change in a step.
const MAX_COEFFICIENT: f64 = 3.0;
const MAX_STEP: f64 = 0.5;
/// Step of the derivative by a factor on the strength.
pub(super) const STRENGTH_STEP: f64 = 0.02;

/// Columns that do not depend on factors, by name and level.
type Cache = RefCell<BTreeMap<(String, u64), Rc<Vec<f64>>>>;

/// Fits of laws to the samples.
pub(super) struct Fitter<'a> {
    pub(super) data: &'a Data,
    cache: Cache,
}

impl<'a> Fitter<'a> {
    pub(super) fn new(data: &'a Data) -> Self {
        Self { data, cache: Cache::default() }
    }

    fn cached(&self, name: &str, level: f64, make: impl FnOnce() -> Vec<f64>) -> Rc<Vec<f64>> {
        let key = (name.to_owned(), level.to_bits());
        if let Some(known) = self.cache.borrow().get(&key) {
            return known.clone();
        }
        let made = Rc::new(make());
        self.cache.borrow_mut().insert(key, made.clone());
        made
    }

    /// Columns of a group beside the hysteretic ones.
    fn group_columns(&self, group: Group) -> Vec<Rc<Vec<f64>>> {
        let (d, s) = (self.data, &self.data.scales);
        let hinge = |x: f64, side: f64, at: f64| side * (side * x - at).max(0.0);
        let of_deformation = |name: String, f: &dyn Fn(f64) -> f64| {
            self.cached(&name, 0.0, || d.at_samples(|r| r.deformation.iter().map(|u| f(u / s.deformation)).collect()))
        };
        let of_speed = |name: String, f: &dyn Fn(f64) -> f64| {
            self.cached(&name, 0.0, || {
                d.at_samples(|r| speed(&r.deformation, &r.times).iter().map(|v| f(v / s.speed)).collect())
            })
        };
        match group {
            Group::Hinges => [0.35, 0.6, 0.8]
                .map(|at| of_deformation(format!("hinge {at}"), &|x| hinge(x, 1.0, at) + hinge(x, -1.0, at)))
                .to_vec(),
            Group::Sides => [(1.0, 0.0), (1.0, 0.35), (-1.0, 0.35), (1.0, 0.7), (-1.0, 0.7)]
                .map(|(side, at)| of_deformation(format!("side {side} {at}"), &|x| hinge(x, side, at)))
                .to_vec(),
            Group::Maxwell => s.constants[..6]
                .iter()
                .map(|t| {
                    let of_run = |r: &super::data::DeviceRun| {
                        maxwell(&r.deformation, &r.times, *t).into_iter().map(|h| h / s.deformation).collect()
                    };
                    self.cached("maxwell", *t, || d.at_samples(of_run))
                })
                .collect(),
            Group::Dashpots => [1.0, 0.5, 0.25, 0.12]
                .map(|p| of_speed(format!("dashpot {p}"), &|v| v.signum() * v.abs().powf(p)))
                .to_vec(),
            Group::Viscous => {
                [0.01, 0.03, 0.1, 0.3].map(|e| of_speed(format!("viscous {e}"), &|v| (v / e).tanh())).to_vec()
            }
            Group::Stops | Group::Unequal => vec![],
        }
    }

    /// Hysteretic columns of a law at factors of its strength.
    fn hysteretic(&self, law: &Law, factors: &[f64]) -> Vec<Rc<Vec<f64>>> {
        let d = self.data;
        if law.shape == Shape::User {
            let user = self.cached("user", 0.0, || {
                d.at_samples(|r| r.modelled.iter().map(|q| q / d.scales.force.max(f64::MIN_POSITIVE)).collect())
            });
            return self.with_further(law, vec![user], None);
        }
        let on_strength: Vec<(f64, &SlowVariable)> = factors
            .iter()
            .zip(&law.factors)
            .filter(|(a, (t, _))| *t == Target::Strength && **a != 0.0)
            .map(|(a, (_, v))| (*a, &**v))
            .collect();
        let is_plain = on_strength.is_empty();
        let strength: Vec<Vec<f64>> = (0..d.runs.len())
            .map(|k| {
                let at = |j: usize| {
                    let sum: f64 = on_strength.iter().map(|(a, v)| a * v.runs[k][j]).sum();
                    (1.0 + sum).clamp(FACTOR_RANGE[0], FACTOR_RANGE[1])
                };
                (0..d.runs[k].times.len()).map(at).collect()
            })
            .collect();
        let operator = if law.shape == Shape::BoucWen { bouc_wen } else { stop };
        let of = |operator: fn(&[f64], f64, &[f64]) -> Vec<f64>, level: f64| {
            let runs: Vec<Vec<f64>> =
                d.runs.iter().zip(&strength).map(|(r, g)| operator(&r.deformation, level, g)).collect();
            d.sampled(&runs)
        };
        let name = if law.shape == Shape::BoucWen { "bouc_wen" } else { "stop" };
        let first = if is_plain {
            self.cached(name, law.level, || of(operator, law.level))
        } else {
            Rc::new(of(operator, law.level))
        };
        let stops = law.groups.contains(&Group::Stops).then(|| {
            let levels = (0..STOP_LEVELS).map(|k| d.scales.deformation * stop_level(k));
            let column = |level: f64| {
                if is_plain { self.cached("stop", level, || of(stop, level)) } else { Rc::new(of(stop, level)) }
            };
            levels.map(column).collect()
        });
        self.with_further(law, vec![first], stops)
    }

    /// Adds stops and the positive side of the first column.
    fn with_further(
        &self,
        law: &Law,
        mut columns: Vec<Rc<Vec<f64>>>,
        stops: Option<Vec<Rc<Vec<f64>>>>,
    ) -> Vec<Rc<Vec<f64>>> {
        columns.extend(stops.unwrap_or_else(|| {
            let asked = law.groups.contains(&Group::Stops);
            let of = |k: usize| {
                let level = self.data.scales.deformation * stop_level(k);
                self.cached("stop", level, || {
                    self.data.at_samples(|r| stop(&r.deformation, level, &vec![1.0; r.times.len()]))
                })
            };
            (0..STOP_LEVELS).filter(|_| asked).map(of).collect()
        }));
        if law.groups.contains(&Group::Unequal) {
            columns.push(Rc::new(columns[0].iter().map(|x| x.max(0.0)).collect()));
        }
        columns
    }

    /// Columns of a law at factors.
    pub(super) fn columns(&self, law: &Law, factors: &[f64]) -> Columns {
        let (d, s) = (self.data, &self.data.scales);
        let mut elastic =
            vec![self.cached("u", 0.0, || d.at_samples(|r| r.deformation.iter().map(|u| u / s.deformation).collect()))];
        let mut viscous = vec![];
        for g in &law.groups {
            let target = if g.is_elastic() { &mut elastic } else { &mut viscous };
            target.extend(self.group_columns(*g));
        }
        let hysteretic = self.hysteretic(law, factors);
        let counts = [elastic.len(), hysteretic.len(), viscous.len(), law.forces.len()];
        let forces = law.forces.iter().map(|f| Rc::new(f.at_samples.clone()));
        let raw: Vec<Rc<Vec<f64>>> = elastic.into_iter().chain(hysteretic).chain(viscous).chain(forces).collect();
        let n = d.samples.len();
        let factor_of = |kind: usize| -> Vec<f64> {
            let mut g = vec![1.0; n];
            for (a, (target, v)) in factors.iter().zip(&law.factors) {
                let acts = match target {
                    Target::Elastic => kind == 0,
                    Target::Hysteretic => kind == 1,
                    Target::Whole => kind < 3,
                    Target::Strength => false,
                };
                if acts {
                    g.iter_mut().zip(&v.at_samples).for_each(|(g, x)| *g += a * x);
                }
            }
            g.iter_mut().for_each(|g| *g = g.clamp(FACTOR_RANGE[0], FACTOR_RANGE[1]));
            g
        };
        let gains: Vec<Vec<f64>> = (0..4).map(factor_of).collect();
        let kind_of: Vec<usize> = (0..4).flat_map(|k| std::iter::repeat_n(k, counts[k])).collect();
        let all =
            raw.iter().zip(&kind_of).map(|(c, k)| c.iter().zip(&gains[*k]).map(|(c, g)| c * g).collect()).collect();
        Columns { raw, counts, all }
    }

    /// Columns whose weights may not be negative.
    fn positive(&self, law: &Law, counts: [usize; 4]) -> Vec<bool> {
        let [e, h, x, f] = counts;
        let elastic = (0..e).map(|k| k == 0);
        let unequal = law.groups.contains(&Group::Unequal);
        let hysteretic = (0..h).map(|k| !(unequal && k + 1 == h));
        elastic.chain(hysteretic).chain((0..x).map(|_| true)).chain((0..f).map(|_| false)).collect()
    }

    /// Derivative of the force by the coefficient of each factor.
    pub(super) fn derivatives(&self, law: &Law, c: &Coefficients, columns: &Columns) -> Vec<Vec<f64>> {
        (0..law.factors.len()).map(|i| self.derivative(law, c, columns, i)).collect()
    }

    fn derivative(&self, law: &Law, c: &Coefficients, columns: &Columns, i: usize) -> Vec<f64> {
        let (target, v) = &law.factors[i];
        let [e, h, x, _] = columns.counts;
        let n = self.data.samples.len();
        let sum = |range: std::ops::Range<usize>, of: &[Rc<Vec<f64>>]| -> Vec<f64> {
            let mut out = vec![0.0; n];
            for k in range {
                out.iter_mut().zip(of[k].iter()).for_each(|(o, x)| *o += c.weights[k] * x);
            }
            out
        };
        match target {
            Target::Strength => {
                let mut moved = c.factors.clone();
                moved[i] += STRENGTH_STEP;
                let there = self.hysteretic(law, &moved);
                let mut out = vec![0.0; n];
                for (k, there) in there.iter().enumerate().take(h) {
                    let (w, before) = (c.weights[e + k], &columns.raw[e + k]);
                    let change = there.iter().zip(before.iter()).map(|(a, b)| (a - b) / STRENGTH_STEP);
                    out.iter_mut().zip(change).for_each(|(o, x)| *o += w * x);
                }
                out
            }
            _ => {
                let range = match target {
                    Target::Elastic => 0..e,
                    Target::Hysteretic => e..e + h,
                    _ => 0..e + h + x,
                };
                sum(range, &columns.raw).iter().zip(&v.at_samples).map(|(f, x)| f * x).collect()
            }
        }
    }

    /// Fit to the samples of `rows`, from factors of an earlier fit.
    pub(super) fn fit(&self, law: &Law, rows: &[bool], steps: usize, start: &[f64]) -> Coefficients {
        let count = law.factors.len();
        let mut c = Coefficients {
            weights: vec![],
            factors: (0..count).map(|i| start.get(i).copied().unwrap_or(0.0)).collect(),
        };
        let kept: Vec<usize> = (0..rows.len()).filter(|i| rows[*i]).collect();
        let steps = if count > 0 { steps } else { 0 };
        for step in 0..=steps {
            let columns = self.columns(law, &c.factors);
            let positive = self.positive(law, columns.counts);
            let (normal, right) = self.normal(&columns.all, &self.data.recorded, &kept);
            c.weights = weights(&normal, &right, &positive);
            if step == steps {
                break;
            }
            let value = self.value_of(&columns, &c);
            let rest: Vec<f64> = self.data.recorded.iter().zip(&value).map(|(y, v)| y - v).collect();
            let all: Vec<Vec<f64>> = columns.all.iter().cloned().chain(self.derivatives(law, &c, &columns)).collect();
            let (normal, right) = self.normal(&all, &rest, &kept);
            let n = right.len();
            let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].sqrt() + 1e-9).collect();
            let scaled =
                DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / scale[i] / scale[j] + if i == j { 1e-4 } else { 0.0 });
            let Some(factored) = scaled.cholesky() else { break };
            let moved = factored.solve(&DVector::from_fn(n, |i, _| right[i] / scale[i]));
            for i in 0..count {
                let k = n - count + i;
                let change = (moved[k] / scale[k]).clamp(-MAX_STEP, MAX_STEP);
                c.factors[i] = (c.factors[i] + change).clamp(-MAX_COEFFICIENT, MAX_COEFFICIENT);
            }
        }
        c
    }

    /// Weighted normal matrix and right side over some samples.
    fn normal(&self, columns: &[Vec<f64>], target: &[f64], kept: &[usize]) -> (DMatrix<f64>, DVector<f64>) {
        let w = &self.data.weight;
        let gathered: Vec<Vec<f64>> = columns.iter().map(|c| kept.iter().map(|i| c[*i] * w[*i]).collect()).collect();
        let right: Vec<f64> = kept.iter().map(|i| target[*i] * w[*i]).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let n = columns.len();
        let mut normal = DMatrix::zeros(n, n);
        for i in 0..n {
            for j in 0..=i {
                let x = dot(&gathered[i], &gathered[j]);
                (normal[(i, j)], normal[(j, i)]) = (x, x);
            }
        }
        (normal, DVector::from_fn(n, |i, _| dot(&gathered[i], &right)))
    }

    fn value_of(&self, columns: &Columns, c: &Coefficients) -> Vec<f64> {
        let mut out = vec![0.0; self.data.samples.len()];
        for (column, w) in columns.all.iter().zip(&c.weights) {
            out.iter_mut().zip(column).for_each(|(o, x)| *o += w * x);
        }
        out
    }

    /// Force of a law at all samples.
    pub(super) fn value(&self, law: &Law, c: &Coefficients) -> Vec<f64> {
        self.value_of(&self.columns(law, &c.factors), c)
    }
}
