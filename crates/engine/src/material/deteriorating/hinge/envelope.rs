//! Envelope of a deteriorating hinge.

use super::{FLAT, NOTHING, of_hinge};
use crate::material::deteriorating::bilin::BilinSide;

/// Slopes and strengths of an envelope, with positive deformations and forces.
#[derive(Clone, Copy)]
pub(in crate::material::deteriorating) struct Envelope {
    pub(in crate::material::deteriorating) stiffness: f64,
    pub(in crate::material::deteriorating) strength: f64,
    pub(in crate::material::deteriorating) hardening: f64,
    pub(in crate::material::deteriorating) softening: f64,
    pub(in crate::material::deteriorating) cap: f64,
}

impl Envelope {
    /// The envelope before any deterioration, with the force at the cap and that at zero deformation on the line beyond.
    /// The hinge is (1 + n) times as stiff as its member.
    pub(in crate::material::deteriorating) fn virgin(rule: &BilinSide, ke: f64, n: f64) -> (Self, f64, f64) {
        let (k, hardening) = (ke * (1.0 + n), of_hinge(n, rule.hardening));
        let peak = rule.strength + k * hardening * rule.plastic;
        let softening = of_hinge(n, -peak / (rule.post_capping * ke));
        let cap = rule.plastic + rule.strength / k;
        let intercept = peak - softening * k * cap;
        (Self { stiffness: k, strength: rule.strength, hardening, softening, cap }, peak, intercept)
    }

    /// Force and slope.
    #[inline]
    pub(in crate::material::deteriorating) fn at(&self, rule: &BilinSide, x: f64) -> (f64, f64) {
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
    #[inline]
    pub(in crate::material::deteriorating) fn cap_for(&self, intercept: f64) -> f64 {
        let (k, hardening) = (self.stiffness, self.hardening * self.stiffness);
        let elastic = intercept / (k - self.softening * k);
        let hard = (intercept + hardening * self.strength / k - self.strength) / (hardening - self.softening * k);
        elastic.max(hard)
    }
}
