//! Shear hysteresis of rubber bearings by Kikuchi and Aiken.

mod opensees;

use crate::material::roles::{PartialCommit, ShownStrain, TrialTrace, UniaxialRoles};
use crate::material::{MaterialError, MaterialResult, Strain, Stress, Uniaxial, UniaxialTraits, updates_each_point};
use crate::numeric::{bracketed_root, sign};
use crate::rules::Consistent;
use crate::state_struct::StateStruct;
pub use opensees::ElasticRange;
use opensees::short_decay;
use std::fmt;

/// Elastic limit of the shear strain, as in OpenSees.
pub(super) const ELASTIC_STRAIN: f64 = 0.05;

/// Shape of the hysteresis loops at one shear strain amplitude.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shape {
    /// Hysteretic share u of the force at the amplitude.
    pub u: f64,
    /// Stiffening share p of the elastic force.
    pub p: f64,
    /// Exponent n of the stiffening share.
    pub n: f64,
    /// Decay a of the hysteretic curves after a reversal.
    pub a: f64,
}

/// End of the first curve of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loops {
    /// At the opposite point of the skeleton; the factor α of the first curve ensures it.
    Closed,
    /// As in OpenSees: the first curve has α = 1 and ends short of the skeleton. The force jumps there by 2 u F_m
    /// exp(-2 a).
    Short,
}

/// Intersection of the formulas `below` and `above` within 2 % of `limit`, or `limit` if they do not intersect there.
pub(super) fn intersection(limit: f64, below: impl Fn(f64) -> f64, above: impl Fn(f64) -> f64) -> f64 {
    let difference = |x: f64| above(x) - below(x);
    let (mut low, mut high) = (0.98 * limit, 1.02 * limit);
    let first = difference(low);
    if first * difference(high) >= 0.0 {
        return limit;
    }
    while high - low > 2.0 * f64::EPSILON * limit {
        let middle = 0.5 * (low + high);
        if first * difference(middle) > 0.0 { low = middle } else { high = middle }
    }
    high
}

/// Loop parameters of a kind of bearing, as functions of the shear strain amplitude γ.
pub trait Device: fmt::Debug + Clone + Send + Sync + 'static {
    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;

    /// Moves the limits between the skeleton's formulas to their intersections. OpenSees changes formulas at round
    /// numbers near them, where the force jumps by up to 3e-4 of its value.
    fn joined(self) -> Self;

    /// Total thickness H_r of the rubber.
    fn height(&self) -> f64;

    /// Displacement increment below which the state is kept.
    fn min_increment(&self) -> f64;

    /// Force F_m at an amplitude, and its derivative with respect to the displacement.
    fn skeleton(&self, gamma: f64) -> (f64, f64);

    /// Shape of the loops at an amplitude.
    fn shape(&self, gamma: f64, loops: Loops) -> Shape;

    /// Parameter b of a curve from a reversal at γ, for loops with the given a.
    fn bump(&self, gamma: f64, a: f64) -> f64;

    /// Parameter c of the curves with a nonzero b.
    fn decay(&self) -> f64;
}

/// The law of Kikuchi and Aiken. Within the largest displacement X so far the force is F₁ + F₂, with x = d / X:
///
/// F₁ = (1 - u) F_m [(1 - p) x + p xⁿ],
///
/// F₂ = F_2r ± α u F_m [2 - 2 exp(-a t) + b t exp(-c t)], t = |x - x_r|.
///
/// F₂ follows a curve from the last reversal (x_r, F_2r). The factor α leads the curve to the previous reversal,
/// where the interrupted curve continues. The first curve leads to the opposite point of the skeleton. Beyond X the
/// force is that of the skeleton.
///
/// Source: Kikuchi and Aiken (1997),
/// <https://doi.org/10.1002/(SICI)1096-9845(199702)26:2%3C215::AID-EQE640%3E3.0.CO;2-9>. The parameters and their
/// functions of the amplitude are those of OpenSees.
#[derive(Clone, Debug)]
pub struct KikuchiAiken<D, R = Consistent> {
    device: D,
    /// Factors of one of several parallel springs: R_s for displacement (times 1 / R_f) and R_f for force.
    rs: f64,
    rf: f64,
    /// Stiffness in the elastic range.
    elastic: f64,
    /// Rules of the tangent and of the end of the loops.
    rules: R,
}

/// Rules of [`KikuchiAiken`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// End of the first curve of a loop.
    const LOOPS: Loops = Loops::Closed;

    /// Returns true if a force of the skeleton, or a part of it, is valid.
    fn accepts(x: f64) -> bool {
        x > 0.0
    }

    /// Force and stiffness in the elastic range of stiffness `k`.
    fn elastic(&self, k: f64, t: &Head) -> (f64, f64) {
        (k * t.d, k)
    }

    /// Stiffness on the skeleton at the shear strain γ, of which `slope` is the derivative of the force.
    fn on_skeleton<D: Device>(_device: &D, _gamma: f64, _t: &Head, _force: f64, slope: f64) -> f64 {
        slope
    }

    /// Exponent n of the stiffening share.
    fn exponent(n: f64) -> f64 {
        n.max(1.0)
    }

    /// Returns true for an open loop, by the product of the distances from its ends.
    fn is_open(past: f64) -> bool {
        past < 0.0
    }

    /// Changes of the committed state by a trial state.
    fn leave_trace(_tried: &[f64], _committed: &mut [f64]) {}

    /// Initial tangent of a spring of stiffness `k` with the factor R_s.
    fn initial_tangent(k: f64, rs: f64) -> f64 {
        k * rs
    }

    /// Displacement that recorders show, with the factors R_s and R_f.
    fn shown_strain(strain: f64, _factors: [f64; 2]) -> f64 {
        strain
    }
}

impl Rules for Consistent {}

/// Maximum number of nested reversals. A further reversal closes the loop that differs least from the enclosing one.
const LEVELS: usize = 48;

crate::state_struct! {
    /// History without the reversals.
    pub struct Head {
        /// Displacement times R_s / R_f.
        d: f64,
        /// Force.
        force: f64,
        /// Stiffness.
        stiffness: f64,
        /// Hysteretic force F₂.
        q2: f64,
        /// Sign of the last increment.
        sign: f64,
        /// Largest displacement X.
        max: f64,
        /// Force F_m of the skeleton at X.
        fm: f64,
        /// Number of open reversals.
        depth: f64,
        u: f64,
        p: f64,
        n: f64,
        a: f64,
        /// 1 after a displacement beyond the elastic range.
        sheared: f64,
    }
}

crate::state_struct! {
    /// A reversal, and the curve that begins there.
    struct Reversal {
        /// x_r.
        x: f64,
        /// F_2r.
        q2: f64,
        /// b.
        b: f64,
        /// α.
        alpha: f64,
    }
}

impl Head {
    fn depth(&self) -> usize {
        self.depth as u32 as usize
    }
}

/// Offset of a reversal, counted from 1.
fn offset(level: usize) -> usize {
    Head::LEN + (level - 1) * Reversal::LEN
}

fn reversal(words: &[f64], level: usize) -> Reversal {
    Reversal::read(&words[offset(level)..])
}

/// Removes the pair of reversals with the smallest difference to the enclosing loop.
fn drop_closest_pair(words: &mut [f64]) {
    let difference = |level: usize| (reversal(words, level + 1).x - reversal(words, level - 1).x).abs();
    let least = (2..LEVELS).min_by(|a, b| difference(*a).total_cmp(&difference(*b))).unwrap_or(2);
    words.copy_within(offset(least + 2)..offset(LEVELS + 1), offset(least));
}

/// Parameter a of a loop with equivalent damping h_eq, at most `limit`; equal to `limit` if no a gives this damping.
/// `range` is the upper end of OpenSees' bisection.
pub(super) fn decay_of_damping(heq: f64, u: f64, range: f64, limit: f64, loops: Loops) -> f64 {
    let share = std::f64::consts::PI * heq / (2.0 * u);
    match loops {
        Loops::Closed => closed_decay(share, limit),
        Loops::Short => short_decay(1.0 - share, range, limit),
    }
}

/// Parameter a of a closed loop: coth a - 1 / a = π h_eq / (2u).
fn closed_decay(share: f64, limit: f64) -> f64 {
    if !(share > 0.0 && share < 1.0) {
        return limit;
    }
    let rises = |a: f64| (1.0 / a.tanh() - 1.0 / a - share, 1.0 / (a * a) - a.sinh().powi(-2));
    bracketed_root(rises, (0.0, f64::INFINITY), 1.0 / (1.0 - share), 1.0, 100).map_or(limit, |a| a.min(limit))
}

/// Parameter b of a curve with the dissipation of h_eq: b = c² [π h_eq / u - (2 + 2 / a (exp(-2a) - 1))].
pub(super) fn bump_of_damping(heq: f64, u: f64, a: f64, c: f64) -> f64 {
    c * c * (std::f64::consts::PI * heq / u - (2.0 + 2.0 / a * ((-2.0 * a).exp() - 1.0)))
}

/// Stiffness in the elastic range.
fn elastic_stiffness<D: Device>(device: &D) -> f64 {
    device.skeleton(ELASTIC_STRAIN).0 / (ELASTIC_STRAIN * device.height())
}

impl<D: Device> KikuchiAiken<D> {
    /// A whole bearing (R_s = R_f = 1), or one of several parallel springs with the factors R_s and R_f.
    pub fn new(device: D, [rs, rf]: [f64; 2]) -> Self {
        let device = device.joined();
        let elastic = elastic_stiffness(&device);
        Self { device, rs, rf, elastic, rules: Consistent }
    }
}

impl<D: Device> KikuchiAiken<D, ElasticRange> {
    /// As `new`, by the rules of OpenSees.
    pub fn as_opensees(device: D, [rs, rf]: [f64; 2]) -> Self {
        let elastic = elastic_stiffness(&device);
        let rules = ElasticRange::of(&device, elastic);
        Self { device, rs, rf, elastic, rules }
    }
}

impl<D: Device, R: Rules> KikuchiAiken<D, R> {
    /// Rejects values of the fitted functions outside their range of validity; OpenSees continues with them.
    ///
    /// # Errors
    /// The value is not positive, or by OpenSees' rules not finite.
    fn check(&self, x: f64, gamma: f64) -> MaterialResult {
        if R::accepts(x) {
            return Ok(());
        }
        let name = D::NAME;
        Err(MaterialError(format!("{name}: the shear strain {gamma:.3} is far beyond what the law was fitted to, 4.1")))
    }

    /// Force and stiffness on the skeleton.
    fn skeleton(&self, t: &mut Head) -> MaterialResult<(f64, f64)> {
        let gamma = t.max / self.device.height();
        let (fm, k) = self.device.skeleton(gamma);
        self.check(fm, gamma)?;
        let k = R::on_skeleton(&self.device, gamma, t, fm, k);
        t.fm = fm;
        Ok((fm * sign(t.d), k))
    }

    /// The bracketed term of a hysteretic curve, and its derivative.
    fn curve(&self, a: f64, b: f64, t: f64) -> (f64, f64) {
        let e = (-a * t).exp();
        let (value, slope) = (2.0 - 2.0 * e, 2.0 * a * e);
        if b == 0.0 {
            return (value, slope);
        }
        let c = self.device.decay();
        let be = b * (-c * t).exp();
        (value + t * be, slope + be * (1.0 - c * t))
    }

    /// Adds a reversal at the committed state; `next` holds the committed reversals.
    fn reverse(&self, c: &Head, t: &mut Head, next: &mut [f64]) -> MaterialResult {
        let gamma = c.d.abs() / self.device.height();
        if c.depth == 0.0 {
            let shape = self.device.shape(gamma, R::LOOPS);
            self.check(shape.u, gamma)?;
            (t.u, t.p, t.n, t.a) = (shape.u, shape.p, R::exponent(shape.n), shape.a);
            let b = self.device.bump(gamma, t.a);
            let alpha = if R::LOOPS == Loops::Closed { 2.0 / self.curve(t.a, b, 2.0).0 } else { 1.0 };
            t.depth = 1.0;
            Reversal { x: sign(c.d), q2: sign(c.d) * t.u * t.fm, b, alpha }.write(&mut next[offset(1)..]);
            return Ok(());
        }
        if c.depth() == LEVELS {
            drop_closest_pair(next);
            t.depth -= 2.0;
        }
        let before = reversal(next, t.depth());
        let x = c.d / c.max;
        let same_side = before.x * x > 0.0;
        let b = if before.b == 0.0 || same_side { 0.0 } else { self.device.bump(gamma, t.a) };
        let length = (before.x - x) * t.sign;
        let ratio =
            if b == before.b { 1.0 } else { self.curve(t.a, before.b, length).0 / self.curve(t.a, b, length).0 };
        t.depth += 1.0;
        Reversal { x, q2: c.q2, b, alpha: before.alpha * ratio }.write(&mut next[offset(t.depth())..]);
        Ok(())
    }

    /// Removes the loops that are closed at x.
    fn close(&self, t: &mut Head, x: f64, next: &[f64]) {
        while t.depth >= 2.0 {
            let (begin, end) = (reversal(next, t.depth()).x, reversal(next, t.depth() - 1).x);
            let past = (x - begin) * (x - end);
            if R::is_open(past) {
                break;
            }
            t.depth -= 1.0;
        }
    }

    /// Force and stiffness inside the skeleton.
    fn inside(&self, c: &Head, t: &mut Head, next: &mut [f64]) -> MaterialResult<(f64, f64)> {
        if t.sign * c.sign < 0.0 || c.depth == 0.0 {
            self.reverse(c, t, next)?;
        }
        let x = t.d / t.max;
        self.close(t, x, next);
        let from = reversal(next, t.depth());
        let (value, slope) = self.curve(t.a, from.b, t.sign * (x - from.x));
        let hysteretic = from.alpha * t.u;
        t.q2 = from.q2 + t.sign * hysteretic * t.fm * value;
        let (mut stiffening, mut stiffer) = (x.abs(), 1.0);
        if t.p != 0.0 && t.n != 1.0 {
            let power = x.abs().powf(t.n - 1.0);
            stiffening *= 1.0 - t.p + t.p * power;
            stiffer += t.p * (t.n * power - 1.0);
        }
        let q1 = (1.0 - t.u) * t.fm * stiffening * sign(x);
        Ok((q1 + t.q2, t.fm / t.max * ((1.0 - t.u) * stiffer + hysteretic * slope)))
    }
}

impl<D: Device, R: Rules> Uniaxial for KikuchiAiken<D, R> {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        D::NAME
    }
    fn state_len(&self) -> usize {
        offset(LEVELS + 1)
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        Head { stiffness: self.initial_tangent(), ..Head::default() }.write(state);
    }

    /// Closed reversals keep stale values, because nothing reads them.
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let c = Head::read(committed);
        let used = offset(c.depth() + 1);
        next[Head::LEN..used].copy_from_slice(&committed[Head::LEN..used]);
        let d = strain.value * self.rs / self.rf;
        let step = d - c.d;
        if step.abs() < self.device.min_increment() {
            c.write(next);
            return Ok(Stress { value: c.force, tangent: c.stiffness, damping: 0.0 });
        }
        let mut t = Head { d, sign: sign(step), max: c.max.max(d.abs()), ..c };
        let (force, stiffness) = if t.max <= ELASTIC_STRAIN * self.device.height() {
            self.rules.elastic(self.elastic, &t)
        } else if d.abs() == t.max {
            (t.depth, t.sheared) = (0.0, 1.0);
            self.skeleton(&mut t)?
        } else {
            self.inside(&c, &mut t, next)?
        };
        (t.force, t.stiffness) = (force * self.rf, stiffness * self.rs);
        t.write(next);
        Ok(Stress { value: t.force, tangent: t.stiffness, damping: 0.0 })
    }

    fn initial_tangent(&self) -> f64 {
        R::initial_tangent(self.elastic, self.rs)
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits::default()
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles { commit: Some(self), trace: Some(self), shown_strain: Some(self), ..UniaxialRoles::default() }
    }
}

impl<D: Device, R: Rules> PartialCommit for KikuchiAiken<D, R> {
    fn commit_all(&self, trial: &[f64], committed: &mut [f64]) {
        let points = trial.chunks_exact(self.state_len()).zip(committed.chunks_exact_mut(self.state_len()));
        for (trial, committed) in points {
            let used = offset(Head::read(trial).depth() + 1);
            committed[..used].copy_from_slice(&trial[..used]);
        }
    }
}

impl<D: Device, R: Rules> TrialTrace for KikuchiAiken<D, R> {
    fn leave_trace(&self, tried: &[f64], committed: &mut [f64]) {
        R::leave_trace(tried, committed);
    }
}

impl<D: Device, R: Rules> ShownStrain for KikuchiAiken<D, R> {
    fn shown_strain(&self, strain: f64, _: &[f64]) -> f64 {
        R::shown_strain(strain, [self.rs, self.rf])
    }
}
