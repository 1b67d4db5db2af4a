//! Plasticity with linear isotropic and kinematic hardening.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// One-dimensional rate-independent plasticity by return mapping (Simo and Hughes, 1998, chapter 1).
#[derive(Clone, Debug, PartialEq)]
pub struct Hardening {
    /// Elastic modulus.
    pub e: f64,
    /// Yield stress.
    pub sigma_y: f64,
    /// Isotropic hardening modulus.
    pub h_iso: f64,
    /// Kinematic hardening modulus.
    pub h_kin: f64,
    /// As in OpenSees, an elastic trial keeps the plastic strain of the previous trial.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`Hardening`].
    pub struct History {
        /// Plastic strain.
        plastic: f64,
        /// Accumulated plastic strain.
        accumulated: f64,
        /// Number of steps; identifies the trial states of the current step.
        steps: f64,
    }
}

impl UniaxialLaw for Hardening {
    type State = History;
    const NAME: &'static str = "Hardening";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let steps = c.steps + 1.0;
        let elastic = self.e * (strain.value - c.plastic);
        let relative = elastic - self.h_kin * c.plastic;
        let excess = relative.abs() - (self.sigma_y + self.h_iso * c.accumulated);
        // A point on the yield surface is plastic, regardless of round-off.
        if excess <= -f64::EPSILON * self.e {
            let next = if self.compat && last.steps == steps { *last } else { History { steps, ..*c } };
            return Ok((Stress { value: elastic, tangent: self.e, damping: 0.0 }, next));
        }
        let hardening = self.h_iso + self.h_kin;
        let flow = excess / (self.e + hardening);
        let s = if relative < 0.0 { -1.0 } else { 1.0 };
        let next = History { plastic: c.plastic + s * flow, accumulated: c.accumulated + flow, steps };
        let tangent = self.e * hardening / (self.e + hardening);
        Ok((Stress { value: elastic - s * flow * self.e, tangent, damping: 0.0 }, next))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
