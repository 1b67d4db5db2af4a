//! Elastic law of powers of the strain.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// σ = Σ cᵢ sgn(ε) |ε|^eᵢ + η ε̇.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticPower {
    /// Coefficients cᵢ and exponents eᵢ.
    pub terms: Vec<[f64; 2]>,
    /// Damping modulus η.
    pub eta: f64,
}

impl ElasticPower {
    fn at(&self, e: f64) -> (f64, f64) {
        let (x, mut stress, mut slope) = (e.abs(), 0.0, 0.0);
        for &[c, n] in &self.terms {
            if e != 0.0 {
                stress += c * e.signum() * x.powf(n);
            }
            // At rest an infinite slope is that at the smallest strain.
            slope += if n >= 1.0 || e != 0.0 { c * n * x.powf(n - 1.0) } else { c * f64::EPSILON.powf(n - 1.0) };
        }
        (stress, slope)
    }
}

impl UniaxialLaw for ElasticPower {
    type State = ();
    const NAME: &'static str = "ElasticPowerFunc";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let (stress, tangent) = self.at(strain.value);
        Ok((Stress { value: stress + self.eta * strain.rate, tangent, damping: self.eta }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        self.at(0.0).1
    }

    fn is_viscous(&self) -> bool {
        self.eta != 0.0
    }
}
