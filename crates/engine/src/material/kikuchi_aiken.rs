//! Shear hysteresis of rubber bearings by Kikuchi and Aiken.

use super::{MaterialError, Strain, Stress, Uniaxial};
use crate::numeric::{bracketed_root, sign};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
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
pub(super) fn meeting(limit: f64, below: impl Fn(f64) -> f64, above: impl Fn(f64) -> f64) -> f64 {
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
    fn rest(&self) -> f64;

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
pub struct KikuchiAiken<D> {
    device: D,
    /// Factors of one of several parallel springs: R_s for displacement (times 1 / R_f) and R_f for force.
    rs: f64,
    rf: f64,
    /// Stiffness in the elastic range.
    elastic: f64,
    /// As in OpenSees: the tangent on the skeleton, a softer return through the elastic range, and force jumps where
    /// loops or formulas meet the skeleton. Further, a has a coarse tolerance, a loop closed to the last bit stays
    /// open, and the initial tangent omits R_s.
    compat: Option<Compat>,
}

/// Constants that reproduce OpenSees' numbers.
#[derive(Clone, Copy, Debug)]
struct Compat {
    /// Force of the return divided by that of the outward path, in the elastic range.
    back: f64,
    /// Reported stiffness in the elastic range after a trial beyond it.
    tried: f64,
}

/// Maximum number of nested reversals. A further reversal closes the loop that differs least from the enclosing one.
const LEVELS: usize = 48;

crate::state_struct! {
    /// History without the reversals.
    struct Head {
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
fn place(level: usize) -> usize {
    Head::LEN + (level - 1) * Reversal::LEN
}

fn reversal(words: &[f64], level: usize) -> Reversal {
    Reversal::read(&words[place(level)..])
}

/// Removes the pair of reversals with the smallest difference to the enclosing loop.
fn forget(words: &mut [f64]) {
    let difference = |level: usize| (reversal(words, level + 1).x - reversal(words, level - 1).x).abs();
    let least = (2..LEVELS).min_by(|a, b| difference(*a).total_cmp(&difference(*b))).unwrap_or(2);
    words.copy_within(place(least + 2)..place(LEVELS + 1), place(least));
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

/// Parameter a of a loop that ends short of the skeleton: (1 - exp(-2a)) / a = 1 - π h_eq / (2u). Returns the end of
/// OpenSees' bisection from `range`.
fn short_decay(target: f64, range: f64, limit: f64) -> f64 {
    const TOLERANCE: f64 = 1e-6;
    if !(target > 0.0 && target < 2.0) {
        return limit;
    }
    // Left side and its derivative.
    let side = |a: f64| {
        let e = (-2.0 * a).exp();
        ((1.0 - e) / a, ((2.0 * a + 1.0) * e - 1.0) / (a * a))
    };
    let falls = |a: f64| {
        let (value, slope) = side(a);
        (target - value, -slope)
    };
    let Some(root) = bracketed_root(falls, (0.0, f64::INFINITY), 1.0 / target, 1.0, 100) else { return limit };
    let slope = side(root).1;
    // The root determines the path of the bisection and its end, without evaluating it at every step.
    let (mut low, mut high) = (0.0, range);
    for _ in 0..100 {
        let a = 0.5 * (low + high);
        let near = (slope * (a - root)).abs() < 2.0 * TOLERANCE * target;
        if near && ((side(a).0 - target) / target).abs() < TOLERANCE {
            return a.min(limit);
        }
        if a > root {
            high = a;
        } else {
            low = a;
            if low > limit {
                return limit;
            }
        }
    }
    low.min(limit)
}

/// Parameter b of a curve with the dissipation of h_eq: b = c² [π h_eq / u - (2 + 2 / a (exp(-2a) - 1))].
pub(super) fn bump_of_damping(heq: f64, u: f64, a: f64, c: f64) -> f64 {
    c * c * (std::f64::consts::PI * heq / u - (2.0 + 2.0 / a * ((-2.0 * a).exp() - 1.0)))
}

impl<D: Device> KikuchiAiken<D> {
    /// A whole bearing (R_s = R_f = 1), or one of several parallel springs with the factors R_s and R_f.
    pub fn new(device: D, [rs, rf]: [f64; 2], compat: bool) -> Self {
        let device = if compat { device } else { device.joined() };
        let elastic = device.skeleton(ELASTIC_STRAIN).0 / (ELASTIC_STRAIN * device.height());
        let compat = compat.then(|| {
            let Shape { u, a, .. } = device.shape(ELASTIC_STRAIN, Loops::Short);
            let end = (-2.0 * a).exp();
            Compat { back: 1.0 - 2.0 * u * end, tried: elastic * (1.0 - u + u * 2.0 * a * end) }
        });
        Self { device, rs, rf, elastic, compat }
    }

    /// Rejects values of the fitted functions outside their range of validity; OpenSees continues with them.
    ///
    /// # Errors
    /// The value is not positive, or with `compat` not finite.
    fn check(&self, x: f64, gamma: f64) -> Result<(), MaterialError> {
        if x > 0.0 || (self.compat.is_some() && x.is_finite()) {
            return Ok(());
        }
        let name = D::NAME;
        Err(MaterialError(format!("{name}: the shear strain {gamma:.3} is far beyond what the law was fitted to, 4.1")))
    }

    /// Force and stiffness in the elastic range.
    fn elastic(&self, t: &Head) -> (f64, f64) {
        let Some(compat) = self.compat else { return (self.elastic * t.d, self.elastic) };
        let back = if t.d * t.sign < 0.0 { compat.back } else { 1.0 };
        (self.elastic * t.d * back, if t.sheared == 0.0 { self.elastic } else { compat.tried })
    }

    /// Force and stiffness on the skeleton.
    fn skeleton(&self, t: &mut Head) -> Result<(f64, f64), MaterialError> {
        let gamma = t.max / self.device.height();
        let (fm, mut k) = self.device.skeleton(gamma);
        self.check(fm, gamma)?;
        if self.compat.is_some() {
            let Shape { u, p, n, a } = self.device.shape(gamma, Loops::Short);
            k = fm / t.max * ((1.0 - u) * (1.0 - p + p * n) + u * 2.0 * a * (-2.0 * a).exp());
        }
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
    fn reverse(&self, c: &Head, t: &mut Head, next: &mut [f64]) -> Result<(), MaterialError> {
        let gamma = c.d.abs() / self.device.height();
        if c.depth == 0.0 {
            let loops = if self.compat.is_some() { Loops::Short } else { Loops::Closed };
            let shape = self.device.shape(gamma, loops);
            self.check(shape.u, gamma)?;
            (t.u, t.p, t.n, t.a) = (shape.u, shape.p, shape.n, shape.a);
            if self.compat.is_none() {
                t.n = t.n.max(1.0);
            }
            let b = self.device.bump(gamma, t.a);
            let alpha = if loops == Loops::Closed { 2.0 / self.curve(t.a, b, 2.0).0 } else { 1.0 };
            t.depth = 1.0;
            Reversal { x: sign(c.d), q2: sign(c.d) * t.u * t.fm, b, alpha }.write(&mut next[place(1)..]);
            return Ok(());
        }
        if c.depth() == LEVELS {
            forget(next);
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
        Reversal { x, q2: c.q2, b, alpha: before.alpha * ratio }.write(&mut next[place(t.depth())..]);
        Ok(())
    }

    /// Removes the loops that are closed at x.
    fn close(&self, t: &mut Head, x: f64, next: &[f64]) {
        while t.depth >= 2.0 {
            let (begin, end) = (reversal(next, t.depth()).x, reversal(next, t.depth() - 1).x);
            let past = (x - begin) * (x - end);
            if past < 0.0 || (past == 0.0 && self.compat.is_some()) {
                break;
            }
            t.depth -= 1.0;
        }
    }

    /// Force and stiffness inside the skeleton.
    fn inside(&self, c: &Head, t: &mut Head, next: &mut [f64]) -> Result<(f64, f64), MaterialError> {
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

impl<D: Device> Uniaxial for KikuchiAiken<D> {
    fn name(&self) -> &'static str {
        D::NAME
    }
    fn state_len(&self) -> usize {
        place(LEVELS + 1)
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        Head { stiffness: self.initial_tangent(), ..Head::default() }.write(state);
    }

    /// Closed reversals keep stale values, because nothing reads them.
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let c = Head::read(committed);
        let used = place(c.depth() + 1);
        next[Head::LEN..used].copy_from_slice(&committed[Head::LEN..used]);
        let d = strain.value * self.rs / self.rf;
        let step = d - c.d;
        if step.abs() < self.device.rest() {
            c.write(next);
            return Ok(Stress { value: c.force, tangent: c.stiffness, damping: 0.0 });
        }
        let mut t = Head { d, sign: sign(step), max: c.max.max(d.abs()), ..c };
        let (force, stiffness) = if t.max <= ELASTIC_STRAIN * self.device.height() {
            self.elastic(&t)
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

    fn commit_all(&self, trial: &[f64], committed: &mut [f64]) {
        let points = trial.chunks_exact(self.state_len()).zip(committed.chunks_exact_mut(self.state_len()));
        for (trial, committed) in points {
            let used = place(Head::read(trial).depth() + 1);
            committed[..used].copy_from_slice(&trial[..used]);
        }
    }

    fn leave_trace(&self, tried: &[f64], committed: &mut [f64]) {
        if self.compat.is_some() {
            Head { sheared: Head::read(tried).sheared, ..Head::read(committed) }.write(committed);
        }
    }

    fn initial_tangent(&self) -> f64 {
        if self.compat.is_some() { self.elastic } else { self.elastic * self.rs }
    }
    fn is_viscous(&self) -> bool {
        false
    }
    fn depends_on_time(&self) -> bool {
        false
    }
    fn is_linear(&self) -> bool {
        false
    }
    /// OpenSees reports the displacement with the factor R_s / R_f.
    fn shown_strain(&self, strain: f64, _: &[f64]) -> f64 {
        if self.compat.is_some() { strain * self.rs / self.rf } else { strain }
    }
    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn read(&self, _: &[u32], _: &[f64], _: &mut [f64]) {}
}
