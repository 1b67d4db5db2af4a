//! Envelope of a deteriorating hinge.

use super::{FLAT, NOTHING};
use crate::material::BilinSide;

/// Slopes and strengths of an envelope, with positive deformations and forces.
#[derive(Clone, Copy)]
pub(super) struct Envelope {
    pub(super) stiffness: f64,
    pub(super) strength: f64,
    pub(super) hardening: f64,
    pub(super) softening: f64,
    pub(super) cap: f64,
}

impl Envelope {
    /// Force and slope.
    pub(super) fn at(&self, rule: &BilinSide, x: f64) -> (f64, f64) {
        let (k, yields) = (self.stiffness, self.strength / self.stiffness);
        if x >= rule.ultimate {
            return (NOTHING, FLAT);
        } else if x < 0.0 {
            return (0.0, FLAT);
        }
        let hardens = yields <= self.cap;
        let peak = if hardens { self.strength + self.hardening * k * (self.cap - yields) } else { k * self.cap };
        let residual = rule.residual * if hardens { rule.strength } else { peak };
        let end = self.cap + (residual - peak) / (self.softening * k);
        if x <= yields.min(self.cap) {
            (k * x, k)
        } else if x <= self.cap {
            (self.strength + self.hardening * k * (x - yields), self.hardening * k)
        } else if x <= end {
            (peak + self.softening * k * (x - self.cap), self.softening * k)
        } else {
            (residual + x * FLAT, FLAT)
        }
    }

    /// Deformation at the cap for a force at zero deformation on the line beyond it.
    pub(super) fn cap_for(&self, intercept: f64) -> f64 {
        let (k, hardening) = (self.stiffness, self.hardening * self.stiffness);
        let elastic = intercept / (k - self.softening * k);
        let hard = (intercept + hardening * self.strength / k - self.strength) / (hardening - self.softening * k);
        elastic.max(hard)
    }
}
