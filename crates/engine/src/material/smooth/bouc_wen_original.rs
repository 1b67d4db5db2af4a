//! Bouc-Wen hysteresis with an elastic part that hardens, in the terms of a yield strength.

use super::BoucWen;
use super::bouc_wen::History;
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// σ = q z + α_L E ε + α_NL E sgn(ε) |ε|^μ with ż = [1 - |z|^η (γ + β sign(ε̇ z))] ε̇/ε_y, the yield strain ε_y = f_y/E and q = f_y
/// - α_L E ε_y - α_NL E ε_y^μ (Bouc, 1971; Wen, 1976). Backward Euler integrates z, as in [`BoucWen`].
#[derive(Clone, Debug, PartialEq)]
pub struct BoucWenOriginal {
    /// q z, as a law whose hysteretic displacement is ε_y z.
    hysteresis: BoucWen,
    /// Stiffness of the linear part, α_L E.
    linear: f64,
    /// Coefficient of the part that hardens, α_NL E, and its exponent μ.
    hardening: (f64, f64),
}

impl BoucWenOriginal {
    /// From the elastic modulus, the yield strength, the ratios α_L and α_NL with the exponent μ, and the shape η, β and γ of the loop.
    pub fn new([e, fy]: [f64; 2], [alpha_l, alpha_nl, mu]: [f64; 3], [eta, beta, gamma]: [f64; 3]) -> Self {
        let yield_strain = fy / e;
        let (linear, hardening) = (alpha_l * e, alpha_nl * e);
        let strength = fy - linear * yield_strain - hardening * yield_strain.powf(mu);
        let shape = yield_strain.powf(-eta);
        let hysteresis = BoucWen {
            alpha: 0.0,
            ko: strength / yield_strain,
            n: eta,
            gamma: gamma * shape,
            beta: beta * shape,
            ao: 1.0,
            delta_a: 0.0,
            delta_nu: 0.0,
            delta_eta: 0.0,
        };
        Self { hysteresis, linear, hardening: (hardening, mu) }
    }

    /// Stress and slope of the elastic part.
    fn elastic(&self, strain: f64) -> (f64, f64) {
        let (hardening, mu) = self.hardening;
        if hardening == 0.0 {
            return (self.linear * strain, self.linear);
        }
        let size = strain.abs();
        let stress = self.linear * strain + hardening * size.powf(mu).copysign(strain);
        (stress, self.linear + hardening * mu * size.powf(mu - 1.0))
    }
}

impl UniaxialLaw for BoucWenOriginal {
    type State = History;
    const NAME: &'static str = "BoucWenOriginal";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (mut stress, next) = self.hysteresis.update(c, strain)?;
        let (value, slope) = self.elastic(strain.value);
        stress.value += value;
        stress.tangent += slope;
        Ok((stress, next))
    }

    fn initial_tangent(&self) -> f64 {
        UniaxialLaw::initial_tangent(&self.hysteresis) + self.elastic(0.0).1
    }
}
