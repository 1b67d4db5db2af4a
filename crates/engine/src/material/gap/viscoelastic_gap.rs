//! Contact with a spring and a dashpot side by side, which carries compression alone (Hughes and Mosqueda, 2020).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Spring and dashpot behind a gap.
#[derive(Clone, Debug, PartialEq)]
pub struct ViscoelasticGap {
    /// Stiffness.
    pub k: f64,
    /// Damping coefficient.
    pub c: f64,
    /// Deformation at which contact begins, not positive.
    pub gap: f64,
}

impl UniaxialLaw for ViscoelasticGap {
    type State = ();
    const NAME: &'static str = "ViscoelasticGap";

    /// The dashpot pulls at the end of a contact, as in the source.
    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        if strain.value >= self.gap {
            return Ok((Stress::default(), ()));
        }
        let value = self.k * (strain.value - self.gap) + self.c * strain.rate;
        Ok((Stress { value, tangent: self.k, damping: self.c }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }

    fn is_viscous(&self) -> bool {
        true
    }
}
