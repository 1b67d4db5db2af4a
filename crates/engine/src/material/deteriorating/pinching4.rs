//! Pinched hysteresis between four-point envelopes with three modes of damage (Lowes, Mitra and Altoontash, 2003).

mod path;

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use path::{Ends, FLAT, Path, Target};
use std::fmt;

/// Smallest change of strain that counts as a movement.
const LEAST_STEP: f64 = 1e-12;
/// Strain of the first point of an envelope divided by the larger first strain given.
const FIRST_POINT: f64 = 1e-4;
/// Strain of the last point of an envelope divided by the last strain given.
const LAST_POINT: f64 = 1e6;

/// Envelope and pinching on one side, positive on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinching4Side {
    /// Stresses of the four points.
    pub stress: [f64; 4],
    /// Strains of the four points.
    pub strain: [f64; 4],
    /// Strain at which reloading begins, divided by the largest strain.
    pub reloading_strain: f64,
    /// Stress at which reloading begins, divided by the stress at the largest strain.
    pub reloading_stress: f64,
    /// Stress at the end of unloading from the other side, divided by the strength of this side.
    pub unloading_stress: f64,
}

/// Growth of a damage index: δ = γ₁ u^γ₃ + γ₂ w^γ₄, at most a limit. u is the largest strain divided by that of the last point,
/// w the dissipated energy divided by its capacity, or the number of cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damage {
    /// Coefficients γ₁ and γ₂.
    pub rate: [f64; 2],
    /// Exponents γ₃ and γ₄.
    pub exponent: [f64; 2],
    /// Largest index.
    pub limit: f64,
}

/// A damage index that grows linearly with the largest strain from a strain on; below it the index stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearDamage {
    /// Largest strain at which it begins.
    pub begin: f64,
    /// Index per largest strain, as a part of that of the last point.
    pub rate: f64,
    /// Index at no strain.
    pub offset: f64,
}

impl Damage {
    /// The index for a largest strain, and for the energy or the cycles, without its limit.
    fn index(&self, strain: f64, work: Option<f64>) -> f64 {
        self.rate[0] * strain.powf(self.exponent[0]) + work.map_or(0.0, |w| self.rate[1] * w.powf(self.exponent[1]))
    }
}

/// Parameters of [`Pinching4`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinching4Parameters {
    /// Positive and negative side.
    pub sides: [Pinching4Side; 2],
    /// Damage of the unloading stiffness.
    pub stiffness: Damage,
    /// Damage of the reloading strain.
    pub reloading: Damage,
    /// Damage of the strength.
    pub strength: Damage,
    /// Damage of the strength in proportion to the largest strain, in place of that by `strength`.
    pub linear_strength: Option<LinearDamage>,
    /// Energy capacity divided by the energy under monotonic loading.
    pub energy: f64,
    /// Damage grows with the cycles in place of the energy.
    pub by_cycles: bool,
}

/// Six points of an envelope: the four given, one near zero and one far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Envelope {
    pub(super) strain: [f64; 6],
    pub(super) stress: [f64; 6],
}

impl Envelope {
    fn new(side: &Pinching4Side, [first, stress]: [f64; 2]) -> Self {
        let ([s1, s2, s3, s4], [e1, e2, e3, e4]) = (side.stress, side.strain);
        let slope = (s4 - s3) / (e4 - e3);
        let far = LAST_POINT * e4;
        let end = if slope > 0.0 { s4 + slope * (far - e4) } else { 1.1 * s4 };
        Self { strain: [first, e1, e2, e3, e4, far], stress: [stress, s1, s2, s3, s4, end] }
    }

    /// Slope of the segment between points `i` and `i + 1`.
    pub(super) fn slope(&self, i: usize) -> f64 {
        (self.stress[i + 1] - self.stress[i]) / (self.strain[i + 1] - self.strain[i])
    }

    /// Stress and slope on the line of segment `i`, from its start.
    pub(super) fn on_segment(&self, i: usize, x: f64) -> (f64, f64) {
        let k = self.slope(i);
        (self.stress[i] + (x - self.strain[i]) * k, k)
    }

    /// Area under the five points up to the last one given.
    fn energy(&self) -> f64 {
        let (e, s) = (&self.strain, &self.stress);
        (0..4).fold(0.5 * e[0] * s[0], |sum, i| sum + 0.5 * (s[i] + s[i + 1]) * (e[i + 1] - e[i]))
    }
}

/// Rules of [`Pinching4`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Takes over what the last trial of a step leaves to the next one.
    fn begin(_last: &History, _t: &mut History) {}

    /// Stress and slope on an envelope.
    fn envelope(e: &Envelope, x: f64, _positive: bool) -> (f64, f64) {
        e.on_segment((0..4).find(|i| x <= e.strain[i + 1]).unwrap_or(4), x)
    }

    /// Stress and slope on a path towards a side.
    fn along(path: &Path, x: f64, _positive: bool) -> (f64, f64) {
        path.on_segment((1..3).rev().find(|&i| x >= path.strain[i]).unwrap_or(0), x)
    }

    /// Without a stress at the end of unloading, reloading begins at its share of the target stress.
    fn reloads_at_its_share(_positive: bool) -> bool {
        true
    }

    /// Path that replaces a straight one softer than the secant of its start.
    fn through_zero(path: &mut Path, slope: f64, _positive: bool) {
        if slope > FLAT && slope < path.stress[0] / path.strain[0] {
            path.bend(1);
        }
    }
}

impl Rules for Consistent {}

/// The damage that a trial state applies to an envelope or a stiffness stays for the later trial states of the step and is committed
/// with them. A segment without slope takes the line of another segment. The two sides differ in two rules: a reloading point without
/// stress at the end of unloading, and the bend of a path that is softer than a secant.
impl Rules for OpenSees {
    fn begin(last: &History, t: &mut History) {
        if last.steps == t.steps {
            (t.used, t.softened, t.weakened) = (last.used, last.softened, last.weakened);
        }
    }

    // Small exponents of the damage magnify round-off, so that the order of the operations is that of OpenSees.
    fn envelope(e: &Envelope, x: f64, positive: bool) -> (f64, f64) {
        let sloped = (0..5).find(|&i| x <= e.strain[i + 1] && e.slope(i) != 0.0);
        let (i, from) = sloped.map_or((4, 5), |i| (i, if positive { i } else { i + 1 }));
        let k = e.slope(i);
        (e.stress[from] + (x - e.strain[from]) * k, k)
    }

    fn along(path: &Path, x: f64, positive: bool) -> (f64, f64) {
        let at = if positive {
            (0..3).rev().find(|&i| x >= path.strain[i]).unwrap_or(0)
        } else {
            (0..3).find(|&i| x <= path.strain[i + 1]).unwrap_or(2)
        };
        let before = if positive { x < path.strain[0] } else { x > path.strain[3] };
        let level = if before == positive { 0 } else { 2 };
        let segment = if path.slope(at) == 0.0 { level } else { at };
        let (k, from) = (path.slope(segment), if positive { segment } else { segment + 1 });
        (path.stress[from] + (x - path.strain[from]) * k, k)
    }

    fn reloads_at_its_share(positive: bool) -> bool {
        positive
    }

    fn through_zero(path: &mut Path, slope: f64, positive: bool) {
        let end = if positive { 0 } else { 3 };
        if slope > FLAT && slope < path.stress[end] / path.strain[end] {
            path.bend(if positive { 1 } else { 2 });
        }
    }
}

/// Uniaxial law with pinching and damage (Lowes, Mitra and Altoontash, 2003, PEER report 2003/10).
#[derive(Clone, Debug, PartialEq)]
pub struct Pinching4<R = Consistent> {
    given: Pinching4Parameters,
    envelopes: [Envelope; 2],
    /// Secant stiffness of the first point on either side.
    elastic: [f64; 2],
    /// Energy at which damage reaches its limits.
    capacity: f64,
    rules: R,
}

crate::state_struct! {
    /// History of [`Pinching4`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// Path as a number: 0 virgin, ±1 on an envelope, ±2 between the envelopes towards a side.
        path: f64,
        /// Strain and stress at the start of a path between the envelopes.
        start: [f64; 2],
        /// Strain and stress at its end.
        target: [f64; 2],
        /// Largest strain on either side, positive.
        demand: [f64; 2],
        /// Dissipated and stored energy.
        energy: f64,
        /// Number of cycles, by the length of the strain path.
        cycles: f64,
        /// Damage of stiffness, reloading strain and strength.
        damage: [f64; 3],
        /// Damage of stiffness and strength at the last reversal.
        used: [f64; 2],
        /// Damage of the stiffness on either side within a step.
        softened: [f64; 2],
        /// Damage of the strength on either side within a step.
        weakened: [f64; 2],
        /// Number of steps; zero for the virgin state.
        steps: f64,
    }
}

impl Pinching4 {
    /// The law by the rules of its source.
    pub fn new(given: Pinching4Parameters) -> Self {
        Self::of(given, Consistent)
    }
}

impl Pinching4<OpenSees> {
    /// The law by the rules of OpenSees.
    pub fn as_opensees(given: Pinching4Parameters) -> Self {
        Self::of(given, OpenSees)
    }
}

/// Sign of a side by its index.
fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

impl<R: Rules> Pinching4<R> {
    fn of(given: Pinching4Parameters, rules: R) -> Self {
        let elastic = given.sides.map(|s| s.stress[0] / s.strain[0]);
        let first = FIRST_POINT * given.sides[0].strain[0].max(given.sides[1].strain[0]);
        let near = [first, first * elastic[0].max(elastic[1])];
        let envelopes = given.sides.map(|s| Envelope::new(&s, near));
        let capacity = given.energy * envelopes[0].energy().max(envelopes[1].energy());
        Self { given, envelopes, elastic, capacity, rules }
    }

    /// Stress and slope on the envelope of a side, with the damage of its strength.
    fn envelope(&self, side: usize, x: f64, weakened: f64) -> (f64, f64) {
        let mut damaged = self.envelopes[side];
        damaged.stress = damaged.stress.map(|s| s * (1.0 - weakened));
        R::envelope(&damaged, x, side == 0)
    }

    /// Sets the end of a path towards a side.
    fn aim(&self, side: usize, c: &History, t: &mut History) {
        (t.used[1], t.weakened[side]) = (c.damage[2], c.damage[2]);
        let far = c.demand[side] * (1.0 + c.damage[1]);
        t.start = [c.strain, c.stress];
        t.target = [sign(side) * far, sign(side) * self.envelope(side, far, t.weakened[side]).0];
        t.path = 2.0 * sign(side);
    }

    /// Path of a trial strain.
    fn choose(&self, c: &History, d: f64, t: &mut History) {
        let u = t.strain;
        let reach = |side: usize| c.demand[side] * (1.0 + c.damage[1]);
        if t.path == 0.0 {
            let first = self.envelopes[0].strain[0];
            t.path = if u > first {
                1.0
            } else if u < -first {
                -1.0
            } else {
                0.0
            };
            return;
        }
        let side = usize::from(t.path < 0.0);
        let other = 1 - side;
        let (s, back) = (sign(side), sign(side) * d < 0.0);
        if t.path.abs() == 1.0 {
            if back {
                t.demand[side] = t.demand[side].max(s * c.strain).max(reach(side));
                if -s * u > reach(other) {
                    t.path = -s;
                    (t.used[1], t.weakened[other]) = (c.damage[2], c.damage[2]);
                } else {
                    self.aim(other, c, t);
                }
                (t.used[0], t.softened[side]) = (c.damage[0], c.damage[0]);
            }
        } else if s * u > s * t.target[0] {
            t.path = s;
        } else if back && -s * u > reach(other) {
            t.path = -s;
        } else if back {
            self.aim(other, c, t);
            (t.used[0], t.softened[side]) = (c.damage[0], c.damage[0]);
        }
    }

    /// Stress and tangent on the path of a trial state.
    fn respond(&self, t: &History) -> (f64, f64) {
        let u = t.strain;
        if t.path == 0.0 {
            let k = UniaxialLaw::initial_tangent(self);
            return (k * u, k);
        }
        let side = usize::from(t.path < 0.0);
        let s = sign(side);
        let (y, slope) = if t.path.abs() == 1.0 {
            self.envelope(side, s * u, t.weakened[side])
        } else {
            let kept = 1.0 - t.weakened[side];
            let stiffness = [0, 1].map(|i| self.elastic[i] * (1.0 - t.softened[i]));
            let ends = Ends { start: t.start.map(|x| s * x), target: t.target.map(|x| s * x) };
            let rule = &self.given.sides[side];
            let target = Target {
                positive: side == 0,
                rule,
                beyond: t.demand[side] > rule.strain[2],
                strength: [kept * rule.stress[2], kept * rule.stress[3]],
                loading: stiffness[side],
                unloading: stiffness[usize::from(t.start[0] < 0.0)],
            };
            R::along(&Path::between::<R>(&ends, &target), s * u, side == 0)
        };
        (s * y, slope)
    }

    /// Damage indices at the end of a step.
    fn deteriorate(&self, d: f64, c: &History, t: &mut History) {
        let given = &self.given;
        let largest = t.demand[0].max(t.demand[1]);
        let ultimate = given.sides[0].strain[3].max(given.sides[1].strain[3]);
        t.cycles = c.cycles + d.abs() / (4.0 * largest);
        if t.strain.abs() >= ultimate {
            return;
        }
        // The stiffness does not fall below the secant to the envelope.
        let secant = [0, 1].map(|i| self.envelope(i, t.demand[i], t.weakened[i]).0 / t.demand[i] / self.elastic[i]);
        let most = (1.0 - secant[0].max(secant[1])).max(0.0);
        let modes = [&given.stiffness, &given.reloading, &given.strength];
        t.damage = if t.energy < self.capacity {
            let side = usize::from(t.strain <= 0.0);
            let stored = 0.5 * t.stress / (self.elastic[side] * (1.0 - t.softened[side])) * t.stress;
            let work = if given.by_cycles {
                Some(t.cycles)
            } else {
                (t.energy > stored).then(|| (t.energy - stored) / self.capacity)
            };
            let mut damage = modes.map(|m| m.index(largest / ultimate, work));
            if let Some(linear) = &given.linear_strength {
                let index = linear.rate * (largest / ultimate) + linear.offset;
                damage[2] = if largest >= linear.begin { index } else { c.damage[2] };
            }
            std::array::from_fn(|i| damage[i].min(modes[i].limit))
        } else {
            modes.map(|m| m.limit)
        };
        t.damage[0] = t.damage[0].min(most);
    }

    /// The virgin state.
    fn virgin(&self) -> History {
        History { demand: self.given.sides.map(|s| s.strain[0]), ..History::default() }
    }
}

impl<R: Rules> UniaxialLaw for Pinching4<R> {
    type State = History;
    const NAME: &'static str = "Pinching4";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let c = if c.steps == 0.0 { self.virgin() } else { *c };
        let mut t = History { strain: strain.value, steps: c.steps + 1.0, ..c };
        (t.softened, t.weakened) = ([c.used[0]; 2], [c.used[1]; 2]);
        R::begin(last, &mut t);
        let step = strain.value - c.strain;
        let d = if step.abs() < LEAST_STEP { 0.0 } else { step };
        self.choose(&c, d, &mut t);
        (t.stress, t.tangent) = self.respond(&t);
        t.energy = c.energy + 0.5 * (t.stress + c.stress) * d;
        self.deteriorate(d, &c, &mut t);
        if !(t.stress.is_finite() && t.tangent.is_finite()) {
            let message = format!("Pinching4 has no stress at a strain of {:.6e}: check the envelope", strain.value);
            return Err(MaterialError(message));
        }
        Ok((Stress { value: t.stress, tangent: t.tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.envelopes[0].stress[0] / self.envelopes[0].strain[0]
    }
}
