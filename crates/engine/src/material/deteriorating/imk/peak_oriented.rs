//! Peak-oriented and pinched hysteresis.

use super::{Curve, ImkDeterioration, ImkSide, Motion, Rules};
use crate::material::deteriorating::hinge::{no_force, sign};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::Consistent;

/// Branches; those after `UNLOADING` have the sign of their side.
const ELASTIC: f64 = 0.0;
const UNLOADING: f64 = 1.0;
/// Towards the pinching point.
const PINCHED: f64 = 2.0;
/// Towards the last peak.
const TO_LOCAL: f64 = 3.0;
/// Towards the largest peak.
const TO_GLOBAL: f64 = 4.0;
const HARDENING: f64 = 5.0;
const SOFTENING: f64 = 6.0;
const RESIDUAL: f64 = 7.0;

/// Shares that give the point where a pinched branch ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinching {
    /// Force divided by that on the line to the largest peak, κF.
    pub force: f64,
    /// Distance from the permanent deformation divided by the latter, κD.
    pub deformation: f64,
}

/// Plastic hinge with peak-oriented hysteresis and deterioration.
#[derive(Clone, Debug, PartialEq)]
pub struct ImkPeakOriented<R = Consistent> {
    /// Elastic stiffness.
    pub ke: f64,
    /// Backbones for positive and negative deformations.
    pub sides: [ImkSide; 2],
    /// Deterioration of yield strength and hardening.
    pub strength: ImkDeterioration,
    /// Deterioration of the strength beyond the cap.
    pub capping: ImkDeterioration,
    /// Deterioration of the reloading stiffness.
    pub reloading: ImkDeterioration,
    /// Deterioration of the unloading stiffness.
    pub stiffness: ImkDeterioration,
    /// Rules of the tangent.
    pub rules: R,
}

/// Plastic hinge with pinched hysteresis and deterioration.
#[derive(Clone, Debug, PartialEq)]
pub struct ImkPinching<R = Consistent> {
    /// The same hinge without pinching.
    pub hinge: ImkPeakOriented<R>,
    /// The pinching point.
    pub pinching: Pinching,
}

crate::state_struct! {
    /// Backbone and peaks of one side, with positive deformations and forces.
    pub struct Backbone {
        /// Curve.
        curve: Curve,
        /// Deformation and force at the last peak.
        local: [f64; 2],
        /// Deformation and force at the largest peak.
        global: [f64; 2],
        /// Deformation at which the residual strength is reached.
        residual: f64,
    }
}

crate::state_struct! {
    /// History of [`ImkPeakOriented`] and [`ImkPinching`].
    pub struct History {
        /// Motion and energy.
        motion: Motion,
        /// Reloading stiffness.
        reloading: f64,
        /// Branch, with the sign of its side.
        branch: f64,
        /// 1 without strength.
        failed: f64,
        /// Deformation and force at the end of a pinched branch.
        pinch: [f64; 2],
        /// Backbones.
        sides: [Backbone; 2],
    }
}

impl ImkPeakOriented {
    /// The same hinge by other rules.
    pub fn with<R>(self, rules: R) -> ImkPeakOriented<R> {
        let Self { ke, sides, strength, capping, reloading, stiffness, .. } = self;
        ImkPeakOriented { ke, sides, strength, capping, reloading, stiffness, rules }
    }
}

/// Slope between two points.
fn slope(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]) / (to[0] - from[0])
}

/// A point with the signs of a side.
fn mirrored(s: f64, point: [f64; 2]) -> [f64; 2] {
    point.map(|x| s * x)
}

impl<R: Rules> ImkPeakOriented<R> {
    fn virgin(&self) -> History {
        let sides = self.sides.map(|s| {
            let (curve, yields) = (Curve::virgin(&s, self.ke), [s.strength / self.ke, s.strength]);
            let residual = (s.residual_strength() - curve.cap[1]) / curve.softening + curve.cap[0];
            Backbone { curve, local: yields, global: yields, residual }
        });
        History { motion: Motion::virgin(self.ke), reloading: self.ke, sides, ..History::default() }
    }

    /// Peaks and unloading stiffness at a reversal. Returns true if no strength is left.
    fn unload(&self, c: &History, t: &mut History) -> bool {
        t.branch = UNLOADING;
        let side = usize::from(c.motion.stress <= 0.0);
        let peak = mirrored(sign(side), [c.motion.strain, c.motion.stress]);
        let b = &mut t.sides[side];
        b.local = peak;
        if peak[0] > b.global[0] {
            b.global = peak;
        }
        let (beta, fails) = self.stiffness.beta_of_unloading(self.sides[0].strength, &c.motion);
        t.motion.unloading *= 1.0 - beta;
        fails
    }

    /// Deterioration of the backbone ahead at the start of an excursion. Returns true if no strength is left.
    fn deteriorate(&self, side: usize, c: &History, t: &mut History) -> bool {
        let fy = self.sides[0].strength;
        let excursion = c.motion.excursion();
        let modes = [&self.strength, &self.capping, &self.reloading].map(|m| m.beta(fy, excursion, c.motion.energy));
        let [by_strength, by_capping, by_reloading] = modes.map(|m| m.0);
        t.motion.spent = c.motion.energy;
        let rule = &self.sides[side];
        let (b, residual) = (&mut t.sides[side], rule.residual_strength());
        let kept = [by_strength, by_capping].map(|beta| 1.0 - beta * rule.rate);
        b.curve.deteriorate(self.ke, kept, |curve| curve.softening);
        b.global[0] *= 1.0 + by_reloading * rule.rate;
        let yields = b.curve.strength / self.ke;
        let x = b.global[0];
        let force = if x < yields {
            self.ke * x
        } else if x < b.curve.cap[0] {
            b.curve.strength + b.curve.hardening * (x - yields)
        } else {
            b.curve.cap[1] + b.curve.softening * (x - b.curve.cap[0])
        };
        b.global[1] = if force < residual { residual } else { force };
        b.residual = (residual - b.curve.cap[1] + b.curve.softening * b.curve.cap[0]) / b.curve.softening;
        modes.iter().any(|m| m.1)
    }

    /// Chooses the branch at the start of an excursion.
    fn reload(&self, side: usize, pinching: Option<&Pinching>, c: &History, t: &mut History) {
        let (s, b) = (sign(side), t.sides[side]);
        let zero = [s * (c.motion.strain - c.motion.stress / t.motion.unloading), 0.0];
        let (to_global, to_local) = (slope(zero, b.global), slope(zero, b.local));
        if let Some(p) = pinching {
            let permanent = b.global[0] - b.global[1] / t.motion.unloading;
            let x = (1.0 - p.deformation) * permanent;
            let pinch = [x, p.force * b.global[1] * (x - zero[0]) / (b.global[0] - zero[0])];
            t.pinch = mirrored(s, pinch);
            if zero[0] < x {
                (t.branch, t.reloading) = (s * PINCHED, slope(zero, pinch));
                return;
            }
        }
        (t.branch, t.reloading) = if zero[0] < b.local[0] && b.local[1] < b.global[1] && to_local > to_global {
            (s * TO_LOCAL, to_local)
        } else {
            (s * TO_GLOBAL, to_global)
        };
    }

    /// Leaves the elastic branch or an unloading branch that has come back to its peak.
    fn leave(&self, pinches: bool, c: &History, t: &mut History) {
        if t.branch == ELASTIC {
            for side in [0, 1] {
                if sign(side) * t.motion.strain > t.sides[side].curve.strength / self.ke {
                    t.branch = sign(side) * HARDENING;
                }
            }
        } else if t.branch == UNLOADING && c.motion.stress != 0.0 {
            let side = usize::from(c.motion.stress < 0.0);
            let (s, b) = (sign(side), t.sides[side]);
            if s * t.motion.strain <= b.local[0] {
                return;
            }
            let (pinch, to_global) = (mirrored(s, t.pinch), slope(b.local, b.global));
            let ordered = |i: usize| b.local[i] < pinch[i] && pinch[i] < b.global[i];
            let to_pinch = slope(b.local, pinch);
            (t.branch, t.reloading) = if pinches && ordered(0) && ordered(1) && to_pinch < to_global {
                (s * PINCHED, to_pinch)
            } else {
                (s * TO_GLOBAL, to_global)
            };
        }
    }

    /// Goes on from branch to branch up to that of the trial deformation.
    fn shift(t: &mut History) {
        if t.branch.abs() < PINCHED {
            return;
        }
        let s = t.branch.signum();
        let (x, pinch, b) = (s * t.motion.strain, mirrored(s, t.pinch), t.sides[usize::from(s < 0.0)]);
        let mut branch = t.branch.abs();
        if branch == PINCHED && x > pinch[0] {
            let (to_global, to_local) = (slope(pinch, b.global), slope(pinch, b.local));
            let before = pinch[0] < b.local[0] && pinch[1] < b.local[1] && b.local[1] < b.global[1];
            (branch, t.reloading) =
                if before && to_local > to_global { (TO_LOCAL, to_local) } else { (TO_GLOBAL, to_global) };
        }
        if branch == TO_LOCAL && x > b.local[0] {
            (branch, t.reloading) = (TO_GLOBAL, slope(b.local, b.global));
        }
        for (from, end) in [(TO_GLOBAL, b.global[0]), (HARDENING, b.curve.cap[0]), (SOFTENING, b.residual)] {
            if branch == from && x > end {
                branch = from + 1.0;
            }
        }
        t.branch = s * branch;
    }

    /// Force and slope on the branch.
    fn respond(&self, c: &History, t: &History) -> (f64, f64) {
        if t.branch == ELASTIC {
            return (self.ke * t.motion.strain, self.ke);
        } else if t.branch == UNLOADING {
            return (c.motion.stress + t.motion.unloading * (t.motion.strain - c.motion.strain), t.motion.unloading);
        }
        let s = t.branch.signum();
        let side = usize::from(s < 0.0);
        let (x, b) = (s * t.motion.strain, &t.sides[side]);
        let (point, slope) = match t.branch.abs() {
            PINCHED => (mirrored(s, t.pinch), t.reloading),
            TO_LOCAL => (b.local, t.reloading),
            TO_GLOBAL => (b.global, t.reloading),
            HARDENING => (b.curve.cap, b.curve.hardening),
            SOFTENING => (b.curve.cap, b.curve.softening),
            _ => return (s * self.sides[side].residual_strength(), 0.0),
        };
        (s * (point[1] + slope * (x - point[0])), slope)
    }

    /// Moves to a trial deformation. Returns the slope of the branch.
    fn advance(&self, pinching: Option<&Pinching>, du: f64, c: &History, t: &mut History) -> f64 {
        let side = usize::from(du < 0.0);
        let mut exhausted = false;
        let on_path = c.branch != ELASTIC && c.branch != UNLOADING;
        if on_path && c.motion.reverses(du) {
            exhausted = self.unload(c, t);
        }
        if t.branch == UNLOADING && c.motion.stress * (c.motion.stress + t.motion.unloading * du) <= 0.0 {
            exhausted |= self.deteriorate(side, c, t);
            self.reload(side, pinching, c, t);
        }
        self.leave(pinching.is_some(), c, t);
        Self::shift(t);
        let (force, mut slope) = self.respond(c, t);
        t.motion.stress = force;
        let gone = t.sides.iter().any(|b| b.global[1] == 0.0);
        let breaks = sign(side) * t.motion.strain >= self.sides[side].ultimate;
        let no_residual = t.branch.abs() == RESIDUAL && t.branch.signum() * t.motion.stress <= 0.0;
        if exhausted || gone || breaks || no_residual {
            (t.motion.stress, slope, t.failed) = (0.0, 0.0, 1.0);
        }
        t.motion.energy += 0.5 * (t.motion.stress + c.motion.stress) * du;
        slope
    }

    fn step(&self, pinching: Option<&Pinching>, c: &History, last: &History, strain: f64) -> Option<(Stress, History)> {
        let begun = |h: &History| if h.motion.started == 0.0 { self.virgin() } else { *h };
        let (c, last) = (begun(c), begun(last));
        let (mut t, failed, du) = (c, c.failed != 0.0, strain - c.motion.strain);
        t.motion.strain = strain;
        let slope = (!failed && du != 0.0).then(|| self.advance(pinching, du, &c, &mut t));
        if failed {
            t.motion.stress = 0.0;
        }
        t.motion.finish::<R>(&c.motion, &last.motion, slope).map(|stress| (stress, t))
    }
}

impl<R: Rules> UniaxialLaw for ImkPeakOriented<R> {
    type State = History;
    const NAME: &'static str = "IMKPeakOriented";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.step(None, c, last, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.ke
    }
}

impl<R: Rules> UniaxialLaw for ImkPinching<R> {
    type State = History;
    const NAME: &'static str = "IMKPinching";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.hinge.step(Some(&self.pinching), c, last, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.hinge.ke
    }
}
