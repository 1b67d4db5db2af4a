//! Maxwell model: a spring and a linear dashpot in series.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Spring and dashpot in series (Kasai, Oohara and Sekiguchi, 2001). The stress relaxes with the time constant C /
/// (Lᵅ K). The integration is exact for half of the strain increment at the start of a step and half at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Maxwell {
    /// Stiffness of the spring.
    pub k: f64,
    /// Damping coefficient.
    pub c: f64,
    /// Velocity exponent, applied to the length only.
    pub alpha: f64,
    /// Length of the damper.
    pub length: f64,
    /// `-returnD`: see `compat`.
    pub secant_damping: bool,
    /// As in OpenSees, the tangent is the stiffness of the spring. With `-returnD` the damping is stress over strain.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`Maxwell`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
    }
}

impl UniaxialLaw for Maxwell {
    type State = History;
    const NAME: &'static str = "Maxwell";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let relaxation = self.c / self.length.powf(self.alpha) / self.k;
        let rest = (-strain.dt / relaxation).exp();
        let slope = 0.5 * self.k * (1.0 + rest);
        let value = c.stress * rest + slope * (strain.value - c.strain);
        let secant = UniaxialLaw::is_viscous(self) && strain.value != 0.0;
        let damping = if secant { value / strain.value } else { 0.0 };
        let tangent = if self.compat { self.k } else { slope };
        Ok((Stress { value, tangent, damping }, History { strain: strain.value, stress: value }))
    }

    fn initial_tangent(&self) -> f64 {
        self.k
    }

    fn is_viscous(&self) -> bool {
        self.secant_damping && self.compat
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}
