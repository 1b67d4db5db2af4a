//! Bilinear hysteresis.

use super::{Curve, ImkDeterioration, ImkSide, Motion, Rules};
use crate::material::deteriorating::hinge::{no_force, sign};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
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
    /// History of [`ImkBilin`].
    pub struct History {
        /// Motion and energy.
        motion: Motion,
        /// 1 on the backbone.
        on_backbone: f64,
        /// Stage of the loss of strength.
        stage: f64,
        /// Backbones.
        sides: [Curve; 2],
    }
}

impl<R: Rules> ImkBilin<R> {
    fn virgin(&self) -> History {
        let sides = self.sides.map(|s| Curve::virgin(&s, self.ke));
        History { motion: Motion::virgin(self.ke), sides, ..History::default() }
    }

    /// Deterioration of the backbone ahead at the start of an excursion. Returns true if no strength is left.
    fn deteriorate(&self, side: usize, c: &History, t: &mut History) -> bool {
        let fy = self.sides[0].strength;
        let excursion = c.motion.excursion();
        let (by_strength, no_strength) = self.strength.beta(fy, excursion, c.motion.energy);
        let (by_capping, no_cap) = self.capping.beta(fy, excursion, c.motion.energy);
        t.motion.spent = c.motion.energy;
        let (rule, s) = (&self.sides[side], sign(side));
        let (residual, u, f) = (rule.residual_strength(), s * c.motion.strain, s * c.motion.stress);
        let b = &mut t.sides[side];
        let softening = rule.peak * rule.strength / rule.post_capping;
        b.deteriorate(self.ke, [by_strength, by_capping].map(|beta| 1.0 - beta * rule.rate), |b| {
            if b.strength < residual { 0.0 } else { -softening * (b.strength - residual) / (rule.strength - residual) }
        });
        // Slope from the unloading line at the residual strength to the cap.
        let least = (b.cap[1] - residual) / (b.cap[0] - u - (residual - f) / t.motion.unloading);
        if b.cap[1] < residual {
            *b = Curve { strength: residual, cap: [0.0, residual], ..Curve::default() };
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
        let slope = if x < b.cap[0] { b.hardening } else { b.softening };
        let force = b.cap[1] + (x - b.cap[0]) * slope;
        if force < residual || t.stage == lost(1 - side) { (residual, 0.0) } else { (force, slope) }
    }

    /// Returns true if a side is at its residual strength.
    fn is_residual(&self, side: usize, t: &History) -> bool {
        let (b, residual, s) = (&t.sides[side], self.sides[side].residual_strength(), sign(side));
        if b.softening == 0.0 {
            return s * t.motion.stress == residual;
        }
        s * t.motion.strain >= (residual - b.cap[1] + b.softening * b.cap[0]) / b.softening
    }

    /// Moves to a trial deformation. Returns the slope of the branch.
    fn advance(&self, du: f64, c: &History, t: &mut History) -> f64 {
        let side = usize::from(du < 0.0);
        let s = sign(side);
        let mut exhausted = false;
        if c.on_backbone == 1.0 && c.motion.reverses(du) {
            t.on_backbone = 0.0;
            let (beta, fails) = self.stiffness.beta_of_unloading(self.sides[0].strength, &c.motion);
            t.motion.unloading *= 1.0 - beta;
            if c.stage > YIELDED {
                t.motion.unloading = UNLOADING_AT_RESIDUAL * self.ke;
            }
            exhausted = fails;
        }
        t.motion.stress = c.motion.stress + t.motion.unloading * du;
        let mut slope = t.motion.unloading;
        if t.on_backbone == 0.0 && c.motion.stress * t.motion.stress <= 0.0 && c.stage > 0.0 {
            exhausted |= self.deteriorate(side, c, t);
        }
        let (force, on) = self.backbone(side, s * t.motion.strain, t);
        if s * t.motion.stress > force {
            (t.motion.stress, slope) = (s * force, on);
            t.on_backbone = 1.0;
        }
        let residual = self.is_residual(0, t) || self.is_residual(1, t);
        let breaks =
            s * t.motion.strain >= self.sides[side].ultimate || (t.on_backbone == 1.0 && s * t.motion.stress <= 0.0);
        if exhausted || breaks {
            (t.motion.stress, slope) = (0.0, 0.0);
            t.stage = if exhausted || t.stage == lost(1 - side) { LOST } else { lost(side) };
        } else if t.stage < RESIDUAL && residual {
            t.stage = RESIDUAL;
        } else if t.stage == 0.0 && t.on_backbone == 1.0 {
            t.stage = YIELDED;
        }
        t.motion.energy += 0.5 * (t.motion.stress + c.motion.stress) * du;
        slope
    }
}

impl<R: Rules> UniaxialLaw for ImkBilin<R> {
    type State = History;
    const NAME: &'static str = "IMKBilin";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let begun = |h: &History| if h.motion.started == 0.0 { self.virgin() } else { *h };
        let (c, last) = (begun(c), begun(last));
        let (mut t, failed, du) = (c, c.stage == LOST, strain.value - c.motion.strain);
        t.motion.strain = strain.value;
        let slope = (!failed && du != 0.0).then(|| self.advance(du, &c, &mut t));
        if failed {
            t.motion.stress = 0.0;
        }
        let answer = t.motion.finish::<R>(&c.motion, &last.motion, slope);
        answer.map(|stress| (stress, t)).ok_or_else(|| no_force(Self::NAME, strain.value))
    }

    fn initial_tangent(&self) -> f64 {
        self.ke
    }
}
