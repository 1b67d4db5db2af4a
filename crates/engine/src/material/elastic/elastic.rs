//! Linear elasticity, with an optional second modulus in compression and an optional dashpot in parallel.

use crate::material::{MaterialResult, Strain, Strains, Stress, Stresses, UniaxialLaw};

/// σ = E ε + η ε̇, with E = `e_pos` for ε ≥ 0 and `e_neg` for ε < 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Elastic {
    /// Modulus in tension, stress.
    pub e_pos: f64,
    /// Damping modulus, stress x time.
    pub eta: f64,
    /// Modulus in compression, stress.
    pub e_neg: f64,
}

impl Elastic {
    /// Linear elasticity with one modulus and no damping.
    pub fn new(e: f64) -> Self {
        Self { e_pos: e, eta: 0.0, e_neg: e }
    }
}

impl UniaxialLaw for Elastic {
    type State = ();
    const NAME: &'static str = "Elastic";

    #[inline]
    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let e = if strain.value >= 0.0 { self.e_pos } else { self.e_neg };
        Ok((Stress { value: e * strain.value + self.eta * strain.rate, tangent: e, damping: self.eta }, ()))
    }

    fn update_points(
        &self,
        _: &[f64],
        strains: &Strains<'_>,
        _: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let n = strains.value.len();
        let (e_pos, e_neg, eta) = (self.e_pos, self.e_neg, self.eta);
        for (tangent, x) in stresses.tangent[..n].iter_mut().zip(strains.value) {
            *tangent = if *x >= 0.0 { e_pos } else { e_neg };
        }
        let points = strains.value.iter().zip(strains.rate).zip(&stresses.tangent[..n]);
        for (value, ((x, rate), e)) in stresses.value[..n].iter_mut().zip(points) {
            *value = e * x + eta * rate;
        }
        stresses.damping[..n].fill(eta);
        Ok(())
    }

    fn initial_tangent(&self) -> f64 {
        self.e_pos
    }

    fn is_viscous(&self) -> bool {
        self.eta != 0.0
    }

    fn is_linear(&self) -> bool {
        self.e_pos == self.e_neg
    }
}
