//! A law with memory, and its fit.

use super::data::{Data, Mode};
use super::family::Family;
use super::least_squares::{dot, weights};
use super::operators::{bouc_wen, curve, stop};
use super::slow_variables::{Kind, SlowVariable};
use hysteron_engine::element::amendment::learned::{self, Admitted, FACTOR_RANGE, Target, admitted};
use hysteron_engine::numeric::axpy;
use nalgebra::{DMatrix, DVector};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Form of the hysteretic part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// A stop.
    Bilinear,
    /// Bouc and Wen's, of exponent one.
    BoucWen,
    /// Slopes of unloading at the level and at half of it, and of loading at half of the level and at the level, over the
    /// initial one.
    Curve([f64; 4]),
    /// The force of the user's fitted law.
    User,
}

impl Shape {
    /// Slopes of [`Shape::Curve`] from unloading to loading.
    pub(super) fn knots([unloading, half_unloading, half_loading, loading]: [f64; 4]) -> [f64; 5] {
        [unloading, half_unloading, 1.0, half_loading, loading]
    }

    /// The same in the engine.
    pub(super) fn of_engine(self) -> learned::Shape {
        match self {
            Self::Bilinear => learned::Shape::Bilinear,
            Self::BoucWen => learned::Shape::BoucWen,
            Self::Curve(k) => learned::Shape::Curve(Self::knots(k).to_vec()),
            Self::User => learned::Shape::Own,
        }
    }
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
    /// Maxwell elements of long times.
    Creep,
}

impl Group {
    /// All groups with their families.
    pub(super) const ALL: [(Self, Family); 8] = [
        (Self::Hinges, Family::Shape),
        (Self::Stops, Family::Shape),
        (Self::Viscous, Family::Shape),
        (Self::Sides, Family::Side),
        (Self::Unequal, Family::Side),
        (Self::Maxwell, Family::Rate),
        (Self::Dashpots, Family::Rate),
        (Self::Creep, Family::Set),
    ];

    /// Returns true if it needs times of a clock.
    pub(super) fn needs_clock(self) -> bool {
        matches!(self, Self::Maxwell | Self::Dashpots | Self::Viscous | Self::Creep)
    }

    /// Returns true if a mode has it. A comparison has forces of its own in place of creep.
    pub(super) fn is_of(self, mode: Mode) -> bool {
        mode == Mode::Engine || self != Self::Creep
    }

    /// Returns true for elastic pieces.
    pub(super) fn is_elastic(self) -> bool {
        matches!(self, Self::Hinges | Self::Sides)
    }
}

/// Parts on which a factor may act.
pub(super) const TARGETS: [Target; 5] =
    [Target::Elastic, Target::Hysteretic, Target::Viscous, Target::Whole, Target::Strength];

/// Signs of the coefficient of a variable on a part: in a comparison any where a family keeps the energy bounded, in a law of
/// the engine those with which it makes none.
pub(super) fn signs(mode: Mode, target: Target, v: &SlowVariable, law: &Law) -> Admitted {
    let (family, is_user) = (v.family, law.shape == Shape::User);
    let takes = match target {
        Target::Strength => !is_user,
        _ if is_user => true,
        Target::Elastic => !matches!(family, Family::Rate | Family::Rest),
        _ => !family.is_fast() && !matches!(family, Family::Largest | Family::Shape),
    };
    // Causes of the library change no viscous part alone, and a channel changes the other parts with it. Heat that a viscous
    // part loses must be paid by what the others dissipate, which is not known before the fit.
    let changes_more = matches!(family, Family::Heat | Family::Temperature | Family::AxialForce | Family::Channel);
    if target == Target::Viscous && (mode == Mode::Comparison || changes_more) {
        return Admitted::None;
    }
    match (mode, v.kind) {
        (Mode::Engine, Kind::Variable(variable)) => admitted(target, variable, &law.shape.of_engine(), law.relaxes()),
        _ if takes => Admitted::Both,
        _ => Admitted::None,
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

    /// Returns true if it has Maxwell elements.
    fn relaxes(&self) -> bool {
        self.groups.iter().any(|g| matches!(g, Group::Maxwell | Group::Creep))
    }

    /// Returns true if each factor may act on its part beside all groups of the law.
    pub(super) fn is_admitted(&self, mode: Mode) -> bool {
        self.factors.iter().all(|(t, v)| signs(mode, *t, v, self) != Admitted::None)
    }
}

/// Values of a law's coefficients: weights of the columns, and factors.
#[derive(Clone, Default)]
pub(super) struct Coefficients {
    pub(super) weights: Vec<f64>,
    pub(super) factors: Vec<f64>,
}

/// Columns of a law at given factors.
pub(super) struct Columns {
    /// Columns in the order elastic, hysteretic, viscous, forces; before their factors.
    raw: Vec<Rc<Vec<f64>>>,
    /// Numbers of columns of each kind.
    pub(super) counts: [usize; 4],
    /// The same with their factors.
    pub(super) all: Vec<Vec<f64>>,
}

/// Number of stops of their group.
pub(super) const STOP_LEVELS: usize = 10;

/// Level of a stop of the group over the largest deformation: geometric from 0.004 to 0.8.
pub(super) fn stop_level(k: usize) -> f64 {
    0.004 * 200f64.powf(k as f64 / (STOP_LEVELS - 1) as f64)
}

/// Powers of dashpots, and widths of smoothed friction over the speed.
pub(super) const POWERS: [f64; 4] = [1.0, 0.5, 0.25, 0.12];
pub(super) const WIDTHS: [f64; 4] = [0.01, 0.03, 0.1, 0.3];
/// Ends of the segments of a spring of either side over the largest deformation, alike on both sides and by side. In a law of
/// the engine each segment has its stiffness, which is not negative; a comparison has signed pieces beyond the ends.
pub(super) const HINGES: [f64; 3] = [0.35, 0.6, 0.8];
pub(super) const SIDE_HINGES: [f64; 2] = [0.35, 0.7];

/// Largest coefficient of a slow variable, and its largest change in a step.
const MAX_COEFFICIENT: f64 = 3.0;
const MAX_STEP: f64 = 0.5;
/// Largest change of a coefficient in a step with which they are found.
const SETTLED: f64 = 1e-3;
/// Step of the derivative by a factor on the strength.
pub(super) const STRENGTH_STEP: f64 = 0.02;

/// Series of hysteresis along deformations, for a level and factors of it.
type Operator<'a> = &'a dyn Fn(&[f64], f64, &[f64]) -> Vec<f64>;

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

    pub(super) fn cached(&self, name: &str, level: f64, make: impl FnOnce() -> Vec<f64>) -> Rc<Vec<f64>> {
        let key = (name.to_owned(), level.to_bits());
        if let Some(known) = self.cache.borrow().get(&key) {
            return known.clone();
        }
        let made = Rc::new(make());
        self.cache.borrow_mut().insert(key, made.clone());
        made
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
                let mut g = vec![1.0; d.runs[k].times.len()];
                on_strength.iter().for_each(|(a, v)| axpy(*a, &v.runs[k], &mut g));
                g.iter_mut().for_each(|g| *g = g.clamp(FACTOR_RANGE[0], FACTOR_RANGE[1]));
                g
            })
            .collect();
        let of = |operator: Operator<'_>, level: f64| {
            let runs: Vec<Vec<f64>> =
                d.runs.iter().zip(&strength).map(|(r, g)| operator(&r.deformation, level, g)).collect();
            d.sampled(&runs)
        };
        let first = || match law.shape {
            Shape::BoucWen => of(&bouc_wen, law.level),
            Shape::Curve(k) => of(&|u, level, g| curve(u, level, g, &Shape::knots(k)), law.level),
            _ => of(&stop, law.level),
        };
        let name = match law.shape {
            Shape::BoucWen => "bouc_wen".to_owned(),
            Shape::Curve(k) => format!("curve {k:?}"),
            _ => "stop".to_owned(),
        };
        let first = if is_plain { self.cached(&name, law.level, first) } else { Rc::new(first()) };
        let stops = law.groups.contains(&Group::Stops).then(|| {
            let levels = (0..STOP_LEVELS).map(|k| d.scales.deformation * stop_level(k));
            let column = |level: f64| {
                if is_plain { self.cached("stop", level, || of(&stop, level)) } else { Rc::new(of(&stop, level)) }
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
            // Each side has a strength of its own, which is not negative.
            if self.data.mode == Mode::Engine {
                columns[0] = Rc::new(columns[0].iter().map(|x| x.min(0.0)).collect());
            }
        }
        columns
    }

    /// Columns of a law at factors.
    pub(super) fn columns(&self, law: &Law, factors: &[f64]) -> Columns {
        let d = self.data;
        let elastic = self.elastic(law);
        let viscous: Vec<Rc<Vec<f64>>> = law.groups.iter().flat_map(|g| self.viscous(*g)).collect();
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
                    Target::Viscous => kind == 2,
                    Target::Whole => kind < 3,
                    Target::Strength => false,
                };
                if acts {
                    let values = if *target == Target::Elastic { &v.on_spring } else { &v.at_samples };
                    g.iter_mut().zip(values).for_each(|(g, x)| *g += a * x);
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
    pub(super) fn positive(&self, law: &Law, counts: [usize; 4]) -> Vec<bool> {
        let [e, h, x, _] = counts;
        let is_engine = self.data.mode == Mode::Engine;
        let elastic = (0..e).map(|k| k == 0 || is_engine);
        let unequal = law.groups.contains(&Group::Unequal);
        let hysteretic = (0..h).map(|k| is_engine || !(unequal && k + 1 == h));
        let forces = law.forces.iter().map(|f| f.kind == Kind::Moving);
        elastic.chain(hysteretic).chain((0..x).map(|_| true)).chain(forces).collect()
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
                    Target::Viscous => e + h..e + h + x,
                    _ => 0..e + h + x,
                };
                let values = if *target == Target::Elastic { &v.on_spring } else { &v.at_samples };
                sum(range, &columns.raw).iter().zip(values).map(|(f, x)| f * x).collect()
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
        let recorded = self.weighted(&self.data.recorded, &kept);
        let mut settled = false;
        for step in 0..=steps {
            let columns = self.columns(law, &c.factors);
            let positive = self.positive(law, columns.counts);
            let mut at_samples = self.gathered(&columns.all, &kept);
            let of_columns = gram(&DMatrix::zeros(0, 0), &at_samples);
            c.weights = weights(&of_columns, &products(&at_samples, &recorded), &positive);
            if step == steps || settled {
                break;
            }
            let value = self.value_of(&columns, &c);
            let rest: Vec<f64> = self.data.recorded.iter().zip(&value).map(|(y, v)| y - v).collect();
            at_samples.extend(self.gathered(&self.derivatives(law, &c, &columns), &kept));
            let (normal, right) = (gram(&of_columns, &at_samples), products(&at_samples, &self.weighted(&rest, &kept)));
            let n = right.len();
            let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].sqrt() + 1e-9).collect();
            let scaled =
                DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / scale[i] / scale[j] + if i == j { 1e-4 } else { 0.0 });
            let Some(factored) = scaled.cholesky() else { break };
            let moved = factored.solve(&DVector::from_fn(n, |i, _| right[i] / scale[i]));
            let mut largest = 0.0f64;
            for i in 0..count {
                let k = n - count + i;
                let change = (moved[k] / scale[k]).clamp(-MAX_STEP, MAX_STEP);
                let (target, v) = &law.factors[i];
                let [least, most] = match signs(self.data.mode, *target, v, law) {
                    Admitted::NotPositive => [-MAX_COEFFICIENT, 0.0],
                    Admitted::NotNegative => [0.0, MAX_COEFFICIENT],
                    _ => [-MAX_COEFFICIENT, MAX_COEFFICIENT],
                };
                let next = (c.factors[i] + change).clamp(least, most);
                largest = largest.max((next - c.factors[i]).abs());
                c.factors[i] = next;
            }
            // The next pass finds the weights of the factors that stand.
            settled = self.data.mode == Mode::Engine && largest < SETTLED;
        }
        c
    }

    /// Weighted normal matrix and right side over some samples.
    pub(super) fn normal(&self, columns: &[Vec<f64>], target: &[f64], kept: &[usize]) -> (DMatrix<f64>, DVector<f64>) {
        let at_samples = self.gathered(columns, kept);
        (gram(&DMatrix::zeros(0, 0), &at_samples), products(&at_samples, &self.weighted(target, kept)))
    }

    /// A series at some samples, times the root of their weight.
    fn weighted(&self, series: &[f64], kept: &[usize]) -> Vec<f64> {
        kept.iter().map(|i| series[*i] * self.data.weight[*i]).collect()
    }

    fn gathered(&self, columns: &[Vec<f64>], kept: &[usize]) -> Vec<Vec<f64>> {
        columns.iter().map(|c| self.weighted(c, kept)).collect()
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

/// Products of columns with each other, of which those of the first ones are known.
fn gram(known: &DMatrix<f64>, columns: &[Vec<f64>]) -> DMatrix<f64> {
    let n = columns.len();
    let mut out = known.clone().resize(n, n, 0.0);
    for i in known.nrows()..n {
        for j in 0..=i {
            let x = dot(&columns[i], &columns[j]);
            (out[(i, j)], out[(j, i)]) = (x, x);
        }
    }
    out
}

fn products(columns: &[Vec<f64>], target: &[f64]) -> DVector<f64> {
    DVector::from_fn(columns.len(), |i, _| dot(&columns[i], target))
}
