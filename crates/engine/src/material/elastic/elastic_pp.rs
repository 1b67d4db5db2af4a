//! Elastic-perfectly plastic law.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Elastic-perfectly plastic law with different yield strains in tension and compression and an initial strain.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticPP {
    e: f64,
    /// Yield stress in tension, not negative.
    fyp: f64,
    /// Yield stress in compression, not positive.
    fyn: f64,
    /// Initial strain ε₀.
    ezero: f64,
}

impl ElasticPP {
    /// From the modulus, the yield strains in tension and in compression (absolute values, as in OpenSees), and the
    /// initial strain.
    pub fn new(e: f64, eps_yp: f64, eps_yn: f64, eps_0: f64) -> Self {
        Self { e, fyp: e * eps_yp.abs(), fyn: -e * eps_yn.abs(), ezero: eps_0 }
    }
}

crate::state_struct! {
    /// History of [`ElasticPP`].
    pub struct PlasticStrain {
        /// Plastic strain.
        ep: f64,
    }
}

impl UniaxialLaw for ElasticPP {
    type State = PlasticStrain;
    const NAME: &'static str = "ElasticPP";

    #[inline]
    fn update(&self, committed: &PlasticStrain, strain: Strain) -> MaterialResult<(Stress, PlasticStrain)> {
        let elastic = self.e * (strain.value - self.ezero - committed.ep);
        let (excess, limit, sign) =
            if elastic >= 0.0 { (elastic - self.fyp, self.fyp, 1.0) } else { (self.fyn - elastic, self.fyn, -1.0) };
        // A point on the yield surface is plastic, regardless of round-off.
        if excess <= -self.e * f64::EPSILON {
            return Ok((Stress { value: elastic, tangent: self.e, damping: 0.0 }, *committed));
        }
        let next = PlasticStrain { ep: committed.ep + sign * excess / self.e };
        Ok((Stress { value: limit, tangent: 0.0, damping: 0.0 }, next))
    }

    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        let place = match name {
            "sigmaY" | "fy" | "Fy" => {
                self.fyn = -value;
                &mut self.fyp
            }
            "sigmaYp" | "fyp" | "Fyp" => &mut self.fyp,
            "sigmaYn" | "fyn" | "Fyn" => &mut self.fyn,
            "E" => &mut self.e,
            "epsZero" | "ezero" => &mut self.ezero,
            _ => return None,
        };
        Some(std::mem::replace(place, value))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
