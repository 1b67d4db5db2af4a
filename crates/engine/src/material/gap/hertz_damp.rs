//! Pounding: Hertz contact with a damping force.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Force K_h δⁿ (1 + ξ δ̇ / v₀) in compression, with the contact depth δ and the approach speed v₀ at first contact.
/// There is no damping without nodal velocities. Sources: Lankarani and Nikravesh; Muthukumar and DesRoches, 2006,
/// <https://doi.org/10.1002/eqe.557>; Ye, Li and Zhu, 2009, <https://doi.org/10.1002/eqe.883>.
#[derive(Clone, Debug, PartialEq)]
pub struct HertzDamp {
    /// Contact stiffness K_h, force over displacement to the power of n.
    pub kh: f64,
    /// Normalised damping coefficient ξ.
    pub xi: f64,
    /// Displacement at contact, negative or zero.
    pub gap: f64,
    /// Exponent n.
    pub n: f64,
    /// As in OpenSees, the tangent has the wrong sign and there is no damping tangent.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`HertzDamp`].
    pub struct Contact {
        /// Damping coefficient divided by δⁿ, from the approach speed at first contact.
        xi: f64,
        /// 1 in contact, 0 otherwise.
        closed: f64,
    }
}

impl UniaxialLaw for HertzDamp {
    type State = Contact;
    const NAME: &'static str = "HertzDamp";

    fn update(&self, c: &Contact, strain: Strain) -> MaterialResult<(Stress, Contact)> {
        let depth = self.gap - strain.value;
        if depth <= 0.0 {
            return Ok(Default::default());
        }
        let begins = c.closed == 0.0 && strain.rate < 0.0;
        // At first contact the rate is the approach speed v₀ itself.
        let xi = if begins { self.xi * self.kh / -strain.rate } else { c.xi };
        let k = self.kh - xi * strain.rate;
        let power = depth.powf(self.n - 1.0);
        let tangent = self.n * k * power;
        let mut s =
            Stress { value: -k * power * depth, tangent, damping: if begins { 0.0 } else { xi * power * depth } };
        if self.compat {
            (s.tangent, s.damping) = (-tangent, 0.0);
        }
        Ok((s, Contact { xi, closed: 1.0 }))
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }

    fn is_viscous(&self) -> bool {
        true
    }
}
