//! Pounding: a bilinear approximation of Hertz contact.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Contact in compression behind a gap, with energy dissipation. The stiffness is K₁ up to the yield displacement δ_y
/// and K₂ beyond. Unloading follows K₁ to the line of slope K₂ through the contact point, then that line. Source:
/// Muthukumar and DesRoches, 2006, <https://doi.org/10.1002/eqe.557>.
#[derive(Clone, Debug, PartialEq)]
pub struct Impact {
    /// Initial stiffness K₁.
    pub k1: f64,
    /// Secondary stiffness K₂, at most K₁.
    pub k2: f64,
    /// Yield displacement δ_y behind the contact, negative.
    pub delta_y: f64,
    /// Displacement at contact, negative or zero.
    pub gap: f64,
    /// As in OpenSees, the elastic increment of the closing step includes the gap, and the initial tangent is K₁ for
    /// an open gap.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`Impact`].
    pub struct History {
        /// Displacement.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent.
        tangent: f64,
    }
}

impl UniaxialLaw for Impact {
    type State = History;
    const NAME: &'static str = "ImpactMaterial";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let u = strain.value;
        let (stress, tangent) = if u >= self.gap {
            (0.0, 0.0)
        } else if u == c.strain {
            (c.stress, c.tangent)
        } else {
            let loading = u < c.strain;
            let from = if self.compat { c.strain } else { c.strain.min(self.gap) };
            let stiff = c.stress + self.k1 * (u - from);
            let soft = if loading {
                self.k1 * self.delta_y + self.k2 * (u - self.gap - self.delta_y)
            } else {
                self.k2 * (u - self.gap)
            };
            let yields = if loading { stiff < soft } else { stiff > soft };
            if yields { (soft, self.k2) } else { (stiff, self.k1) }
        };
        Ok((Stress { value: stress, tangent, damping: 0.0 }, History { strain: u, stress, tangent }))
    }

    fn initial_tangent(&self) -> f64 {
        if self.gap < 0.0 && !self.compat { 0.0 } else { self.k1 }
    }
}
