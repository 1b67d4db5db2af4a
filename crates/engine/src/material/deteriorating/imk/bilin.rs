//! Bilinear hysteresis.

use super::{ImkDeterioration, ImkSide, Rules, not_flat, sign};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::rules::Consistent;

/// Unloading stiffness after the residual strength was reached, divided by the elastic stiffness.
const UNLOADING_AT_RESIDUAL: f64 = 0.5;

/// Stages of the loss of strength; each includes those before it.
const YIELDED: f64 = 1.0;
const RESIDUAL: f64 = 2.0;
/// The positive side has no strength, the negative one the residual strength.
const POSITIVE_LOST: f64 = 3.0;
const NEGATIVE_LOST: f64 = 4.0;
const LOST: f64 = 5.0;

/// Stage at which a side has no strength.
fn lost(side: usize) -> f64 {
    if side == 0 { POSITIVE_LOST } else { NEGATIVE_LOST }
}

/// Plastic hinge with bilinear hysteresis and deterioration.
#[derive(Clone, Debug, PartialEq)]
pub struct ImkBilin<R = Consistent> {
    /// Elastic stiffness.
    pub ke: f64,
    /// Backbones for positive and negative deformations.
    pub sides: [ImkSide; 2],
    /// Deterioration of yield strength and hardening.
    pub strength: ImkDeterioration,
    /// Deterioration of the strength beyond the cap.
    pub capping: ImkDeterioration,
    /// Deterioration of the unloading stiffness.
    pub stiffness: ImkDeterioration,
    /// Rules of the tangent.
    pub rules: R,
}

crate::state_struct! {
    /// Backbone of one side, with positive deformations and forces.
    pub struct Backbone {
        /// Yield strength.
        strength: f64,
        /// Deformation at the cap.
        cap: f64,
        /// Force at the cap.
        cap_force: f64,
        /// Slope before the cap.
        hardening: f64,
        /// Slope beyond the cap.
        softening: f64,
    }
}

crate::state_struct! {
    /// History of [`ImkBilin`].
    pub struct History {
        /// 1 after the first step.
        started: f64,
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// Unloading stiffness.
        unloading: f64,
        /// Dissipated and stored energy.
        energy: f64,
        /// The same at the start of the excursion.
        spent: f64,
        /// 1 on the backbone.
        on_backbone: f64,
        /// Stage of the loss of strength.
        stage: f64,
        /// Backbones.
        sides: [Backbone; 2],
    }
}

impl<R: Rules> ImkBilin<R> {
    fn virgin(&self) -> History {
        let sides = self.sides.map(|s| {
            let cap_force = s.peak * s.strength;
            Backbone {
                strength: s.strength,
                cap: s.strength / self.ke + s.plastic,
                cap_force,
                hardening: (cap_force - s.strength) / s.plastic,
                softening: -cap_force / s.post_capping,
            }
        });
        History { started: 1.0, tangent: self.ke, unloading: self.ke, sides, ..History::default() }
    }

    /// Deterioration of the backbone ahead at the start of an excursion. Returns true if no strength is left.
    fn deteriorate(&self, side: usize, c: &History, t: &mut History) -> bool {
        let fy = self.sides[0].strength;
        let excursion = (c.energy - c.spent).max(0.0);
        let (by_strength, no_strength) = self.strength.beta(fy, excursion, c.energy);
        let (by_capping, no_cap) = self.capping.beta(fy, excursion, c.energy);
        t.spent = c.energy;
        let (rule, s) = (&self.sides[side], sign(side));
        let (residual, u, f) = (rule.residual_strength(), s * c.strain, s * c.stress);
        let b = &mut t.sides[side];
        let intercept = (b.cap_force - b.softening * b.cap) * (1.0 - by_capping * rule.rate);
        b.strength *= 1.0 - by_strength * rule.rate;
        b.hardening *= 1.0 - by_strength * rule.rate;
        let softening = rule.peak * rule.strength / rule.post_capping;
        b.softening =
            if b.strength < residual { 0.0 } else { -softening * (b.strength - residual) / (rule.strength - residual) };
        let hardening_intercept = b.strength - b.hardening * (b.strength / self.ke);
        b.cap = if b.hardening <= b.softening {
            0.0
        } else {
            (intercept - hardening_intercept) / (b.hardening - b.softening)
        };
        b.cap_force = hardening_intercept + b.hardening * b.cap;
        // Slope from the unloading line at the residual strength to the cap.
        let least = (b.cap_force - residual) / (b.cap - u - (residual - f) / t.unloading);
        if b.cap_force < residual {
            *b = Backbone { strength: residual, cap_force: residual, ..Backbone::default() };
        } else if least > 0.0 && b.hardening > least {
            b.hardening = least;
        }
        no_strength || no_cap
    }

    /// Force on the backbone ahead, and its slope.
    fn backbone(&self, side: usize, x: f64, t: &History) -> (f64, f64) {
        let (b, residual) = (&t.sides[side], self.sides[side].residual_strength());
        if t.stage == lost(side) {
            return (0.0, 0.0);
        }
        let slope = if x < b.cap { b.hardening } else { b.softening };
        let force = b.cap_force + (x - b.cap) * slope;
        if force < residual || t.stage == lost(1 - side) { (residual, 0.0) } else { (force, slope) }
    }

    /// Returns true if a side is at its residual strength.
    fn is_residual(&self, side: usize, t: &History) -> bool {
        let (b, residual, s) = (&t.sides[side], self.sides[side].residual_strength(), sign(side));
        if b.softening == 0.0 {
            return s * t.stress == residual;
        }
        s * t.strain >= (residual - b.cap_force + b.softening * b.cap) / b.softening
    }

    /// Moves to a trial deformation. Returns the slope of the branch.
    fn advance(&self, du: f64, c: &History, t: &mut History) -> f64 {
        let side = usize::from(du < 0.0);
        let s = sign(side);
        let mut exhausted = false;
        let on_backbone = c.on_backbone == 1.0;
        if on_backbone && (c.stress * du < 0.0 || (c.stress == 0.0 && c.strain * du <= 0.0)) {
            t.on_backbone = 0.0;
            let stored = 0.5 * (c.stress / c.unloading) * c.stress;
            let (beta, fails) =
                self.stiffness.beta(self.sides[0].strength, c.energy - c.spent - stored, c.energy - stored);
            t.unloading *= 1.0 - beta;
            if c.stage > YIELDED {
                t.unloading = UNLOADING_AT_RESIDUAL * self.ke;
            }
            exhausted = fails;
        }
        t.stress = c.stress + t.unloading * du;
        let mut slope = t.unloading;
        if t.on_backbone == 0.0 && c.stress * t.stress <= 0.0 && c.stage > 0.0 {
            exhausted |= self.deteriorate(side, c, t);
        }
        let (force, on) = self.backbone(side, s * t.strain, t);
        if s * t.stress > force {
            (t.stress, slope) = (s * force, on);
            t.on_backbone = 1.0;
        }
        let residual = self.is_residual(0, t) || self.is_residual(1, t);
        let breaks = s * t.strain >= self.sides[side].ultimate || (t.on_backbone == 1.0 && s * t.stress <= 0.0);
        if exhausted || breaks {
            (t.stress, slope) = (0.0, 0.0);
            t.stage = if exhausted || t.stage == lost(1 - side) { LOST } else { lost(side) };
        } else if t.stage < RESIDUAL && residual {
            t.stage = RESIDUAL;
        } else if t.stage == 0.0 && t.on_backbone == 1.0 {
            t.stage = YIELDED;
        }
        t.energy += 0.5 * (t.stress + c.stress) * du;
        slope
    }
}

impl<R: Rules> UniaxialLaw for ImkBilin<R> {
    type State = History;
    const NAME: &'static str = "IMKBilin";

    fn update(&self, committed: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let begun = |h: &History| if h.started == 0.0 { self.virgin() } else { *h };
        let (c, last) = (begun(c), begun(last));
        let mut t = History { strain: strain.value, ..c };
        let du = strain.value - c.strain;
        if c.stage == LOST || du == 0.0 {
            t.stress = if c.stage == LOST { 0.0 } else { c.stress };
            t.tangent = R::tangent_at_rest(c.tangent, last.tangent);
        } else {
            let slope = self.advance(du, &c, &mut t);
            t.tangent = R::tangent(slope, (t.stress - c.stress) / du);
        }
        t.tangent = not_flat(t.tangent);
        if !(t.stress.is_finite() && t.tangent.is_finite()) {
            return Err(MaterialError(format!("IMKBilin has no force at a deformation of {:.6e}", strain.value)));
        }
        Ok((Stress { value: t.stress, tangent: t.tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.ke
    }
}
