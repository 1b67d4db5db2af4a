//! Axial law of layered rubber bearings: cavitation with damage in tension, buckling in compression, both as functions
//! of the shear displacement.

mod carried;
mod lockstep;

use crate::element::bearing::laws::rubber::{PI, Rubber};

use carried::{Effects, Numbers, Sheared};
pub(in crate::element::bearing) use lockstep::AxialLockstep;

/// Ratio of the axial stiffness after buckling to the initial one.
const BUCKLED_STIFFNESS_RATIO: f64 = 1e-4;

/// Axial law of `HDR`, `ElastomericX` and `LeadRubberX`.
///
/// Source: Kumar, Whittaker and Constantinou (2014). At the shear displacement u_h the stiffness is K_v = K_v0 / (1 +
/// 3/π² (u_h/r)²). The critical load is P_cr times the overlap of the ends, at least 0.2 P_cr. Beyond cavitation at u_c
/// = F_c/K_v the tensile force is F_c (1 + (1 - e^(-k_c (u-u_c))) / (T_r k_c)).
///
/// After a largest displacement u_max the strength is F_c (1 - Φ_max (1 - e^(-a_c (u_max-u_c)/u_c))). Reloading is
/// linear from that strength to the force at u_max.
///
/// OpenSees uses the shear displacement of the last step for K_v, u_c and P_cr. Without `compat` it is that of the step
/// itself, so that the response is independent of the step size.
///
/// The force depends on the shear displacement, but the shear force does not depend on the axial one. A cycle that
/// compresses a sheared bearing, straightens and unloads it gains energy. Cycles at constant shear displacement or
/// constant axial force do not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialLaw {
    /// Properties of the bearing.
    pub rubber: Rubber,
    /// Cavitation parameter k_c.
    pub kc: f64,
    /// Largest damage Φ_max.
    pub phi: f64,
    /// Rate a_c of the damage.
    pub ac: f64,
    /// Cavitation is active.
    pub cavitates: bool,
    /// Buckling is active, at a load that depends on the shear displacement.
    pub buckles: bool,
    /// The stiffness depends on the shear displacement.
    pub softens: bool,
    /// OpenSees' scheme.
    pub compat: bool,
}

crate::state_struct! {
    /// Committed axial state.
    pub struct Axial<T> {
        /// Force, tension positive.
        force: T,
        /// Stiffness K_v.
        kv: T,
        /// Displacement u_c at first cavitation.
        uc: T,
        /// Current cavitation strength.
        fcn: T,
        /// Largest tensile displacement u_max.
        umax: T,
        /// Critical load, negative.
        fcrn: T,
        /// Critical load of smallest size so far, negative.
        fcrmin: T,
    }
}

/// Axial response to a displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialStep<T = f64> {
    /// Trial state.
    pub next: Axial<T>,
    /// ∂N/∂u.
    pub k: T,
    /// ∂N/∂u_h.
    pub k_shear: T,
    /// Critical load of the step, negative.
    pub critical: T,
    /// Derivative of the critical load by u_h.
    pub d_critical: T,
}

impl AxialLaw {
    /// Virgin state.
    pub fn virgin(&self) -> Axial {
        let Rubber { axial, cavitation, critical, .. } = self.rubber;
        let uc = cavitation / axial;
        Axial { force: 0.0, kv: axial, uc, fcn: cavitation, umax: uc, fcrn: -critical, fcrmin: -critical }
    }

    fn numbers(&self) -> Numbers {
        let Rubber { axial, critical, cavitation, diameter, gyration, .. } = self.rubber;
        Numbers { axial, critical, cavitation, diameter, softening: 3.0 / (PI * PI) / (gyration * gyration) }
    }

    fn effects(&self) -> Effects {
        Effects { cavitates: self.cavitates, buckles: self.buckles, softens: self.softens, area: 1.0 }
    }

    /// Force at first loading beyond cavitation, and its slope.
    #[inline]
    fn backbone(&self, beyond: f64) -> (f64, f64) {
        let Rubber { cavitation, thickness, .. } = self.rubber;
        let e = (-self.kc * beyond).exp();
        (cavitation * (1.0 + (1.0 - e) / (thickness * self.kc)), cavitation / thickness * e)
    }

    /// Cavitation strength after a largest displacement `umax`.
    fn strength(&self, umax: f64, uc: f64) -> f64 {
        self.rubber.cavitation * (1.0 - self.phi * (1.0 - (-self.ac * (umax - uc) / uc).exp()))
    }

    /// Response to the axial displacement `u` (tension positive) at the shear displacement `uh`.
    #[inline]
    pub fn step(&self, c: &Axial, u: f64, uh: f64) -> AxialStep {
        if self.compat { self.lagging_step(c, u, uh) } else { self.consistent_step(c, u, uh) }
    }

    fn consistent_step(&self, c: &Axial, u: f64, uh: f64) -> AxialStep {
        let (numbers, effects) = (self.numbers(), self.effects());
        let s = numbers.sheared(&effects, uh);
        let (mut step, beyond) = numbers.step(&effects, &s, c, u);
        if beyond {
            self.cavitate(&s, c, u, &mut step);
        }
        step
    }

    /// Sets the step of a bearing beyond cavitation.
    fn cavitate(&self, s: &Sheared, c: &Axial, u: f64, step: &mut AxialStep) {
        let uc = step.next.uc;
        let next = &mut step.next;
        let duc = -uc * s.dkv / s.kv;
        if u < c.umax.max(uc) {
            // After cavitation at another shear displacement, the target of reloading is at least u_c.
            let (target, dtarget) = if c.umax > uc { (c.umax, 0.0) } else { (uc, duc) };
            let (top, slope) = self.backbone(target - uc);
            let (start, dstart) = (c.fcn / s.kv, -c.fcn / s.kv * s.dkv / s.kv);
            step.k = (top - c.fcn) / (target - start);
            next.force = c.fcn + step.k * (u - start);
            let dk = (slope * (dtarget - duc) - step.k * (dtarget - dstart)) / (target - start);
            step.k_shear = dk * (u - start) - step.k * dstart;
        } else {
            (next.force, step.k) = self.backbone(u - uc);
            step.k_shear = -step.k * duc;
            next.umax = u;
            next.fcn = c.fcn.min(self.strength(u, uc));
        }
    }

    fn lagging_step(&self, c: &Axial, u: f64, uh: f64) -> AxialStep {
        let start = c.fcn / c.kv;
        let (force, k);
        if self.buckles && u <= c.fcrn / c.kv {
            k = self.rubber.axial * BUCKLED_STIFFNESS_RATIO;
            force = c.fcrmin + k * (u - c.fcrn / c.kv);
        } else if !self.cavitates || u <= start {
            k = c.kv;
            force = k * u;
        } else if u < c.umax {
            k = (self.backbone(c.umax - c.uc).0 - c.fcn) / (c.umax - start);
            force = c.fcn + k * (u - start);
        } else {
            (force, k) = self.backbone(u - c.uc);
        }
        // OpenSees' area contains its rounded π.
        let effects = Effects { area: std::f64::consts::PI / PI, ..self.effects() };
        let s = self.numbers().sheared(&effects, uh);
        let mut next = Axial { force, kv: s.kv, fcrn: s.fcrn, fcrmin: c.fcrmin.max(s.fcrn), ..*c };
        if self.softens && uh > f64::EPSILON {
            next.uc = self.rubber.cavitation / s.kv;
        }
        if self.cavitates && u > c.umax {
            next.umax = u;
            next.fcn = self.strength(u, next.uc);
        }
        AxialStep { next, k, k_shear: 0.0, critical: c.fcrn, d_critical: 0.0 }
    }
}
