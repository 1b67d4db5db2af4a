//! Peak-oriented and pinched hysteresis.

use super::{ImkDeterioration, ImkSide, Rules, not_flat, sign};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw};
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
        /// Yield strength.
        strength: f64,
        /// Deformation and force at the cap.
        cap: [f64; 2],
        /// Deformation and force at the last peak.
        local: [f64; 2],
        /// Deformation and force at the largest peak.
        global: [f64; 2],
        /// Deformation at which the residual strength is reached.
        residual: f64,
        /// Slope before the cap.
        hardening: f64,
        /// Slope beyond the cap.
        softening: f64,
    }
}

crate::state_struct! {
    /// History of [`ImkPeakOriented`] and [`ImkPinching`].
    pub struct History {
        /// 1 after the first step.
        started: f64,
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// Reloading stiffness.
        reloading: f64,
        /// Unloading stiffness.
        unloading: f64,
        /// Dissipated and stored energy.
        energy: f64,
        /// The same at the start of the excursion.
        spent: f64,
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
            let (yields, force) = (s.strength / self.ke, s.peak * s.strength);
            let (cap, softening) = (yields + s.plastic, -force / s.post_capping);
            Backbone {
                strength: s.strength,
                cap: [cap, force],
                local: [yields, s.strength],
                global: [yields, s.strength],
                residual: (s.residual_strength() - force) / softening + cap,
                hardening: (force - s.strength) / s.plastic,
                softening,
            }
        });
        let ke = self.ke;
        History { started: 1.0, tangent: ke, reloading: ke, unloading: ke, sides, ..History::default() }
    }

    /// Peaks and unloading stiffness at a reversal. Returns true if no strength is left.
    fn unload(&self, c: &History, t: &mut History) -> bool {
        t.branch = UNLOADING;
        let side = usize::from(c.stress <= 0.0);
        let peak = mirrored(sign(side), [c.strain, c.stress]);
        let b = &mut t.sides[side];
        b.local = peak;
        if peak[0] > b.global[0] {
            b.global = peak;
        }
        let stored = 0.5 * (c.stress / c.unloading) * c.stress;
        let fy = self.sides[0].strength;
        let (beta, fails) = self.stiffness.beta(fy, c.energy - c.spent - stored, c.energy - stored);
        t.unloading *= 1.0 - beta;
        fails
    }

    /// Deterioration of the backbone ahead at the start of an excursion. Returns true if no strength is left.
    fn deteriorate(&self, side: usize, c: &History, t: &mut History) -> bool {
        let fy = self.sides[0].strength;
        let excursion = (c.energy - c.spent).max(0.0);
        let modes = [&self.strength, &self.capping, &self.reloading].map(|m| m.beta(fy, excursion, c.energy));
        let [by_strength, by_capping, by_reloading] = modes.map(|m| m.0);
        t.spent = c.energy;
        let rule = &self.sides[side];
        let (b, residual) = (&mut t.sides[side], rule.residual_strength());
        let intercept = (b.cap[1] - b.softening * b.cap[0]) * (1.0 - by_capping * rule.rate);
        b.strength *= 1.0 - by_strength * rule.rate;
        b.hardening *= 1.0 - by_strength * rule.rate;
        b.global[0] *= 1.0 + by_reloading * rule.rate;
        let yields = b.strength / self.ke;
        let hardening_intercept = b.strength - b.hardening * yields;
        b.cap[0] = if b.hardening <= b.softening {
            0.0
        } else {
            (intercept - hardening_intercept) / (b.hardening - b.softening)
        };
        b.cap[1] = hardening_intercept + b.hardening * b.cap[0];
        let x = b.global[0];
        let force = if x < yields {
            self.ke * x
        } else if x < b.cap[0] {
            b.strength + b.hardening * (x - yields)
        } else {
            b.cap[1] + b.softening * (x - b.cap[0])
        };
        b.global[1] = if force < residual { residual } else { force };
        b.residual = (residual - b.cap[1] + b.softening * b.cap[0]) / b.softening;
        modes.iter().any(|m| m.1)
    }

    /// Chooses the branch at the start of an excursion.
    fn reload(&self, side: usize, pinching: Option<&Pinching>, c: &History, t: &mut History) {
        let (s, b) = (sign(side), t.sides[side]);
        let zero = [s * (c.strain - c.stress / t.unloading), 0.0];
        let (to_global, to_local) = (slope(zero, b.global), slope(zero, b.local));
        if let Some(p) = pinching {
            let permanent = b.global[0] - b.global[1] / t.unloading;
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
                if sign(side) * t.strain > t.sides[side].strength / self.ke {
                    t.branch = sign(side) * HARDENING;
                }
            }
        } else if t.branch == UNLOADING && c.stress != 0.0 {
            let side = usize::from(c.stress < 0.0);
            let (s, b) = (sign(side), t.sides[side]);
            if s * t.strain <= b.local[0] {
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
        let (x, pinch, b) = (s * t.strain, mirrored(s, t.pinch), t.sides[usize::from(s < 0.0)]);
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
        for (from, end) in [(TO_GLOBAL, b.global[0]), (HARDENING, b.cap[0]), (SOFTENING, b.residual)] {
            if branch == from && x > end {
                branch = from + 1.0;
            }
        }
        t.branch = s * branch;
    }

    /// Force and slope on the branch.
    fn respond(&self, c: &History, t: &History) -> (f64, f64) {
        if t.branch == ELASTIC {
            return (self.ke * t.strain, self.ke);
        } else if t.branch == UNLOADING {
            return (c.stress + t.unloading * (t.strain - c.strain), t.unloading);
        }
        let s = t.branch.signum();
        let side = usize::from(s < 0.0);
        let (x, b) = (s * t.strain, &t.sides[side]);
        let (point, slope) = match t.branch.abs() {
            PINCHED => (mirrored(s, t.pinch), t.reloading),
            TO_LOCAL => (b.local, t.reloading),
            TO_GLOBAL => (b.global, t.reloading),
            HARDENING => (b.cap, b.hardening),
            SOFTENING => (b.cap, b.softening),
            _ => return (s * self.sides[side].residual_strength(), 0.0),
        };
        (s * (point[1] + slope * (x - point[0])), slope)
    }

    /// Moves to a trial deformation. Returns the slope of the branch.
    fn advance(&self, pinching: Option<&Pinching>, du: f64, c: &History, t: &mut History) -> f64 {
        let side = usize::from(du < 0.0);
        let mut exhausted = false;
        let on_path = c.branch != ELASTIC && c.branch != UNLOADING;
        if on_path && (c.stress * du < 0.0 || (c.stress == 0.0 && c.strain * du <= 0.0)) {
            exhausted = self.unload(c, t);
        }
        if t.branch == UNLOADING && c.stress * (c.stress + t.unloading * du) <= 0.0 {
            exhausted |= self.deteriorate(side, c, t);
            self.reload(side, pinching, c, t);
        }
        self.leave(pinching.is_some(), c, t);
        Self::shift(t);
        let (force, mut slope) = self.respond(c, t);
        t.stress = force;
        let gone = t.sides.iter().any(|b| b.global[1] == 0.0);
        let breaks = sign(side) * t.strain >= self.sides[side].ultimate;
        let no_residual = t.branch.abs() == RESIDUAL && t.branch.signum() * t.stress <= 0.0;
        if exhausted || gone || breaks || no_residual {
            (t.stress, slope, t.failed) = (0.0, 0.0, 1.0);
        }
        t.energy += 0.5 * (t.stress + c.stress) * du;
        slope
    }

    fn step(&self, pinching: Option<&Pinching>, c: &History, last: &History, strain: f64) -> Option<(Stress, History)> {
        let begun = |h: &History| if h.started == 0.0 { self.virgin() } else { *h };
        let (c, last) = (begun(c), begun(last));
        let mut t = History { strain, ..c };
        let du = strain - c.strain;
        if c.failed != 0.0 || du == 0.0 {
            t.stress = if c.failed != 0.0 { 0.0 } else { c.stress };
            t.tangent = R::tangent_at_rest(c.tangent, last.tangent);
        } else {
            let slope = self.advance(pinching, du, &c, &mut t);
            t.tangent = R::tangent(slope, (t.stress - c.stress) / du);
        }
        t.tangent = not_flat(t.tangent);
        let finite = t.stress.is_finite() && t.tangent.is_finite();
        finite.then_some((Stress { value: t.stress, tangent: t.tangent, damping: 0.0 }, t))
    }
}

fn no_force(name: &str, strain: f64) -> MaterialError {
    MaterialError(format!("{name} has no force at a deformation of {strain:.6e}"))
}

impl<R: Rules> UniaxialLaw for ImkPeakOriented<R> {
    type State = History;
    const NAME: &'static str = "IMKPeakOriented";

    fn update(&self, committed: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.step(None, c, last, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.ke
    }
}

impl<R: Rules> UniaxialLaw for ImkPinching<R> {
    type State = History;
    const NAME: &'static str = "IMKPinching";

    fn update(&self, committed: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.hinge.step(Some(&self.pinching), c, last, strain.value).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.hinge.ke
    }
}
