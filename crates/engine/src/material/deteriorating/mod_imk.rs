//! Deteriorating plastic hinges: the modified Ibarra-Medina-Krawinkler laws with peak-oriented and pinched hysteresis (Ibarra, Medina
//! and Krawinkler, 2005, <https://doi.org/10.1002/eqe.495>; Lignos and Krawinkler, 2012).

use super::hinge::{Envelope, FLAT, no_force, of_hinge, of_member, sign};
use crate::material::{BilinSide, Deterioration, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Deformations and forces that are closer than this are equal.
const CLOSE: f64 = 1e-10;
/// Deformation of zero force that is not zero, for a hinge that comes back to zero.
const OFF_ZERO: f64 = 1e-9;
/// Change of deformation below which a step does not move.
const LEAST_STEP: f64 = 1e-18;

/// Plastic hinge with peak-oriented hysteresis. A hinge in series with an elastic member is (1 + n) times as stiff as the member.
#[derive(Clone, Debug, PartialEq)]
pub struct ModImkPeakOriented<R = Consistent> {
    /// Elastic stiffness of the member.
    pub ke: f64,
    /// Backbones for positive and negative deformations.
    pub sides: [BilinSide; 2],
    /// Deterioration of yield strength and hardening.
    pub strength: Deterioration,
    /// Deterioration of the strength beyond the cap.
    pub capping: Deterioration,
    /// Deterioration of the reloading stiffness.
    pub reloading: Deterioration,
    /// Deterioration of the unloading stiffness.
    pub stiffness: Deterioration,
    /// Stiffness of the hinge divided by that of the member, minus one: n.
    pub n: f64,
    /// Rules of deterioration.
    pub rules: R,
}

/// Point where a pinched branch ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinchingPoint {
    /// Force divided by the largest force, on either side.
    pub force: [f64; 2],
    /// Deformation divided by the permanent deformation.
    pub deformation: f64,
}

/// Plastic hinge with pinched hysteresis.
#[derive(Clone, Debug, PartialEq)]
pub struct ModImkPinching<R = Consistent> {
    /// The same hinge without pinching.
    pub hinge: ModImkPeakOriented<R>,
    /// End of a pinched branch.
    pub pinching: PinchingPoint,
}

/// Rules of the laws that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// The tangent is that of the damping too, which has no force.
    const DAMPS: bool = false;

    /// Returns true if the energy exhausts the capacity of the strength beyond the cap.
    fn has_no_cap(energy: f64, capacity: f64) -> bool {
        energy >= capacity && capacity != 0.0
    }

    /// Returns true if the unloading stiffness of a pinched hinge deteriorates in a reversal to a side.
    fn softens(_positive: bool, _positive_yield: bool) -> bool {
        true
    }
}

impl Rules for Consistent {}

/// The tangent is counted as one of damping too. Without a capacity of the strength beyond the cap the cap is lost. A pinched hinge that has not yielded on the positive side keeps its
/// unloading stiffness in reversals to the negative side.
impl Rules for OpenSees {
    const DAMPS: bool = true;

    fn has_no_cap(energy: f64, capacity: f64) -> bool {
        energy >= capacity && capacity == 0.0
    }

    fn softens(positive: bool, positive_yield: bool) -> bool {
        positive || positive_yield
    }
}

crate::state_struct! {
    /// Backbone of one side, with positive deformations and forces.
    pub struct Backbone {
        /// Yield strength.
        strength: f64,
        /// Hardening ratio.
        hardening: f64,
        /// Slope beyond the cap divided by the stiffness.
        softening: f64,
        /// Deformation at the cap.
        cap: f64,
        /// Force at zero deformation on the line beyond the cap.
        intercept: f64,
        /// Largest deformation and its force.
        reach: [f64; 2],
        /// Last peak and its force.
        last: [f64; 2],
        /// Deformation of zero force on the way to this side.
        zero: f64,
    }
}

crate::state_struct! {
    /// History of [`ModImkPeakOriented`] and [`ModImkPinching`].
    pub struct History {
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// 1 going up, -1 going down, 0 virgin.
        direction: f64,
        /// 1 after a reversal.
        reversed: f64,
        /// 1 without strength.
        stopped: f64,
        /// Unloading stiffness.
        unloading: f64,
        /// Product of (1 - β) over the deteriorations of the unloading stiffness.
        stiffness_left: f64,
        /// Dissipated and stored energy.
        energy: f64,
        /// Dissipated and stored energy of the present excursion.
        excursion: f64,
        /// Backbones.
        sides: [Backbone; 2],
    }
}

impl ModImkPeakOriented {
    /// The same hinge by other rules.
    pub fn with<R>(self, rules: R) -> ModImkPeakOriented<R> {
        let Self { ke, sides, strength, capping, reloading, stiffness, n, .. } = self;
        ModImkPeakOriented { ke, sides, strength, capping, reloading, stiffness, n, rules }
    }
}

impl<R: Rules> ModImkPeakOriented<R> {
    /// Stiffness of the hinge.
    fn k(&self) -> f64 {
        self.ke * (1.0 + self.n)
    }

    // A point needs it once: it stays out of the code of a step.
    #[cold]
    fn virgin(&self) -> History {
        let k = self.k();
        let sides = self.sides.map(|s| {
            let (Envelope { strength, hardening, softening, cap, .. }, _, intercept) =
                Envelope::virgin(&s, self.ke, self.n);
            let yielded = [strength / k, strength];
            Backbone { strength, hardening, softening, cap, intercept, reach: yielded, last: yielded, zero: 0.0 }
        });
        History { tangent: k, unloading: k, stiffness_left: 1.0, sides, ..History::default() }
    }

    fn envelope(&self, b: &Backbone) -> Envelope {
        let Backbone { strength, hardening, softening, cap, .. } = *b;
        Envelope { stiffness: self.k(), strength, hardening, softening, cap }
    }

    /// Force and slope on the envelope of a side; at the ultimate deformation the hinge stops.
    fn on_envelope(&self, side: usize, x: f64, t: &mut History) -> (f64, f64) {
        if x >= self.sides[side].ultimate {
            t.stopped = 1.0;
        }
        self.envelope(&t.sides[side]).at(&self.sides[side], x)
    }

    /// Reversal to a side.
    fn turn(&self, pinched: bool, side: usize, c: &History, t: &mut History) {
        let (k, s) = (self.k(), sign(side));
        (t.direction, t.reversed) = (s, 1.0);
        let capacity = 2.0 * self.stiffness.capacity * self.sides[0].strength;
        let stored = 0.5 * c.stress * c.stress / t.unloading;
        let spent = t.energy - stored;
        if spent > capacity && capacity != 0.0 {
            t.stopped = 1.0;
        }
        let positive_yield = t.sides[0].reach[0] > self.sides[0].strength / k;
        if capacity != 0.0 && (!pinched || R::softens(side == 0, positive_yield)) {
            let beta =
                if spent >= capacity { 1.0 } else { self.stiffness.beta(t.excursion - stored, capacity - spent) };
            t.stiffness_left *= 1.0 - beta;
            t.unloading = k * of_hinge(self.n, t.stiffness_left);
            if pinched {
                let [a, b] = [t.sides[0].reach, t.sides[1].reach];
                t.unloading = t.unloading.max((a[1] + b[1]) / (a[0] + b[0]));
            }
            if t.unloading <= t.sides[1 - side].hardening * k {
                t.stopped = 1.0;
            }
        }
        if pinched && t.unloading <= FLAT {
            t.stopped = 1.0;
        }
        let force = s * c.stress;
        if force < 0.0 || (pinched && side == 0 && force == 0.0) {
            let zero = s * (c.strain - c.stress / t.unloading);
            let yielded = (t.sides[side].reach[0] - self.sides[side].strength / k).abs() >= CLOSE;
            t.sides[side].zero = if yielded && zero.abs() <= CLOSE { OFF_ZERO } else { zero };
        }
        if (t.sides[1 - side].reach[0] + s * c.strain).abs() <= CLOSE {
            t.sides[1 - side].zero = -t.sides[side].zero - CLOSE;
        }
    }

    /// Force and slope on the way to the largest deformation, with the signs of the side.
    fn reload(&self, side: usize, x: f64, c: &History, t: &mut History) -> (f64, f64) {
        let s = sign(side);
        let [reach, force] = t.sides[side].reach;
        let Backbone { zero, last, .. } = t.sides[side];
        let elastic = s * c.stress + t.unloading * (x - s * c.strain);
        if x <= zero {
            let behind = &mut t.sides[1 - side];
            if t.reversed == 1.0 && (t.unloading - c.tangent).abs() > CLOSE && -s * c.strain != behind.reach[0] {
                behind.last = [-s * c.strain, -s * c.stress];
            }
            return (elastic, t.unloading);
        }
        let mut slope = force / (reach - zero);
        let mut line = slope * (x - zero);
        if last[0] > zero && last[0] < reach {
            let to_last = last[1] / (last[0] - zero);
            if to_last > slope && last[1] < force {
                if x < last[0] {
                    (slope, line) = (to_last, to_last * (x - zero));
                } else {
                    slope = (force - last[1]) / (reach - last[0]);
                    line = last[1] + slope * (x - last[0]);
                }
            }
        }
        nearer(elastic, line, t.unloading, slope)
    }

    /// As `reload`, by way of the end of pinching.
    fn reload_pinched(&self, p: &PinchingPoint, side: usize, x: f64, c: &History, t: &mut History) -> (f64, f64) {
        let s = sign(side);
        let [reach, force] = t.sides[side].reach;
        let zero = t.sides[side].zero;
        let elastic = s * c.stress + t.unloading * (x - s * c.strain);
        if x <= zero {
            return (elastic, t.unloading);
        }
        let pinched = force * p.force[side];
        let (end, end_force, to_end) = if self.n > 0.0 {
            let member = reach + force / self.ke;
            let permanent = member - force / (t.stiffness_left * self.ke);
            let end_force = pinched / (member - zero) * (p.deformation * permanent - zero);
            let slope = pinched / (member - pinched / self.ke - zero);
            (p.deformation * permanent - end_force / self.ke, end_force, slope)
        } else {
            let end = p.deformation * (reach - force / t.unloading);
            let slope = pinched / (reach - zero);
            (end, slope * (end - zero), slope)
        };
        let (line, slope) = if zero > end {
            let slope = force / (reach - zero);
            (slope * (x - zero), slope)
        } else if x < end {
            (to_end * (x - zero), to_end)
        } else {
            let slope = (force - end_force) / (reach - end);
            (end_force + slope * (x - end), slope)
        };
        if t.unloading < slope {
            t.stopped = 1.0;
        }
        nearer(elastic, line, t.unloading, slope)
    }

    /// Deterioration of the backbone of a side after a change of sign of the force.
    fn deteriorate(&self, pinched: bool, side: usize, t: &mut History) {
        let modes = [&self.strength, &self.reloading, &self.capping];
        let capacity = modes.map(|m| m.capacity * self.sides[0].strength);
        let gone = |i: usize| t.energy >= capacity[i] && capacity[i] != 0.0;
        let [by_strength, by_reloading, by_capping] = if gone(0) {
            [1.0, 0.0, 0.0]
        } else if gone(1) {
            [0.0, 1.0, 0.0]
        } else if R::has_no_cap(t.energy, capacity[2]) {
            [0.0, 0.0, 1.0]
        } else {
            [0, 1, 2].map(|i| {
                let beta = modes[i].beta(t.excursion, capacity[i] - t.energy);
                if pinched && beta.abs() >= 1.0 {
                    t.stopped = 1.0;
                }
                if beta.abs() >= 1.0 { 1.0 } else { beta }
            })
        };
        t.excursion = 0.0;
        let rule = &self.sides[side];
        let mut b = t.sides[side];
        b.strength *= 1.0 - by_strength * rule.rate;
        b.hardening = of_hinge(self.n, of_member(self.n, b.hardening) * (1.0 - by_strength * rule.rate));
        b.intercept *= 1.0 - by_capping * rule.rate;
        if self.n > 0.0 {
            // The largest deformation of member and hinge together grows.
            let (hardening, softening) = (of_member(self.n, b.hardening), of_member(self.n, b.softening));
            let mut member = Envelope { stiffness: self.ke, strength: b.strength, hardening, softening, cap: 0.0 };
            member.cap = member.cap_for(b.intercept);
            let total = (b.reach[0] + b.reach[1] / self.ke) * (1.0 + by_reloading);
            if total >= rule.ultimate {
                t.stopped = 1.0;
            }
            b.reach[0] = total.min(rule.ultimate) - member.at(rule, total).0 / self.ke;
        } else {
            b.reach[0] *= 1.0 + by_reloading;
        }
        b.cap = self.envelope(&b).cap_for(b.intercept);
        t.sides[side] = b;
    }

    /// Moves to a trial deformation. Returns force and slope.
    fn advance(&self, pinching: Option<&PinchingPoint>, c: &History, t: &mut History) -> (f64, f64) {
        let d = t.strain - c.strain;
        let side = usize::from(d < 0.0);
        let s = sign(side);
        if t.direction == 0.0 {
            t.direction = s;
        } else if t.direction != s {
            self.turn(pinching.is_some(), side, c, t);
        }
        let x = s * t.strain;
        let (force, slope) = if x >= t.sides[side].reach[0] {
            let (force, slope) = self.on_envelope(side, x, t);
            let reach = x.min(self.sides[side].ultimate);
            t.sides[side].reach = [reach, force];
            t.sides[side].last = [reach + CLOSE, force];
            (s * force, slope)
        } else if t.sides[side].zero.abs() > CLOSE {
            let reach = t.sides[side].reach[0];
            let force = self.on_envelope(side, reach, t).0;
            t.sides[side].reach = [reach.min(self.sides[side].ultimate), force];
            let (force, slope) = match pinching {
                Some(p) => self.reload_pinched(p, side, x, c, t),
                None => self.reload(side, x, c, t),
            };
            (s * force, slope)
        } else {
            let at = usize::from(t.strain <= 0.0);
            let (force, slope) = self.on_envelope(at, sign(at) * t.strain, t);
            (sign(at) * force, slope)
        };
        let work = 0.5 * (force + c.stress) * d;
        t.excursion += work;
        t.energy += work;
        let from = &t.sides[usize::from(c.stress < 0.0)];
        if force * c.stress < 0.0 && from.reach[0] > from.strength / self.k() {
            self.deteriorate(pinching.is_some(), side, t);
        }
        (force, slope)
    }

    fn step(&self, pinching: Option<&PinchingPoint>, c: &History, strain: f64) -> Option<(Stress, History)> {
        let c = if c.direction == 0.0 { self.virgin() } else { *c };
        let mut t = History { strain, ..c };
        let moved = (strain - c.strain).abs() >= LEAST_STEP || strain == 0.0 || c.direction == 0.0;
        if c.stopped == 1.0 && moved {
            (t.stress, t.tangent) = (0.0, 0.0);
        } else if moved {
            (t.stress, t.tangent) = self.advance(pinching, &c, &mut t);
        }
        let finite = t.stress.is_finite() && t.tangent.is_finite();
        let damping = if R::DAMPS { t.tangent } else { 0.0 };
        finite.then_some((Stress { value: t.stress, tangent: t.tangent, damping }, t))
    }
}

/// The lower of an elastic line and a branch, with its slope.
fn nearer(elastic: f64, line: f64, unloading: f64, slope: f64) -> (f64, f64) {
    let force = elastic.min(line);
    (force, if (force - elastic).abs() < CLOSE { unloading } else { slope })
}

impl<R: Rules> UniaxialLaw for ModImkPeakOriented<R> {
    type State = History;
    const NAME: &'static str = "ModIMKPeakOriented";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.step(None, c, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.k()
    }

    fn is_viscous(&self) -> bool {
        R::DAMPS
    }
}

impl<R: Rules> UniaxialLaw for ModImkPinching<R> {
    type State = History;
    const NAME: &'static str = "ModIMKPinching";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.hinge.step(Some(&self.pinching), c, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.hinge.k()
    }

    fn is_viscous(&self) -> bool {
        R::DAMPS
    }
}
