//! Smooth hysteresis of algebraic type.

use crate::material::smooth::hysteretic_asym::History;
use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};

/// The algebraic law of Vaiana, Sessa, Marmo and Rosati (2019, <https://doi.org/10.1007/s11071-019-05022-5>). A
/// branch that begins at u_c approaches the limit curve
///
/// f = β₁ u³ + β₂ u⁵ + k_b u ± f̄
///
/// by (x_c + |u - u_c|)^(1-a), where x_c follows from the force at u_c. The tolerance is the stiffness minus k_b at
/// the end of a branch; it determines f̄.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticPoly {
    /// Stiffness k_a at the first point of a branch from a limit curve.
    pub ka: f64,
    /// Stiffness k_b of the limit curves at zero displacement, less than k_a.
    pub kb: f64,
    /// Exponent a, not 1.
    pub a: f64,
    /// β₁ and β₂.
    pub b: [f64; 2],
    /// Stiffness minus k_b at which a branch has reached the limit curve.
    pub tolerance: f64,
    /// As in OpenSees, the origin of the branch carries the round-off of its whole length, and the initial stiffness
    /// is k_a.
    pub compat: bool,
}

impl HystereticPoly {
    /// OpenSees' tolerance.
    pub const TOLERANCE: f64 = 1e-20;

    /// Returns u_0, (1 + 2 u_0)^(1-a) and f̄. The length of a branch between the limit curves is 2 u_0; f̄ is half
    /// the height of the loop.
    fn range(&self) -> [f64; 3] {
        let k = self.ka - self.kb;
        let uo = 0.5 * ((k / self.tolerance).powf(1.0 / self.a) - 1.0);
        let far = (1.0 + 2.0 * uo).powf(1.0 - self.a);
        [uo, far, 0.5 * k * (far - 1.0) / (1.0 - self.a)]
    }

    /// β₁ u³ + β₂ u⁵ + k_b u and its derivative.
    fn elastic(&self, u: f64) -> (f64, f64) {
        let ([b1, b2], square) = (self.b, u * u);
        (u * (self.kb + square * (b1 + square * b2)), self.kb + square * (3.0 * b1 + 5.0 * square * b2))
    }
}

impl UniaxialLaw for HystereticPoly {
    type State = History;
    const NAME: &'static str = "HystereticPoly";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (u, k, power) = (strain.value, self.ka - self.kb, 1.0 - self.a);
        let s = if u >= c.strain { 1.0 } else { -1.0 };
        let [uo, far, height] = self.range();
        let start = power / k * (s * (c.stress - self.elastic(c.strain).0) - height) + far;
        // Round-off may put a point beyond the limit curve; the branch ends there.
        let x = start.max(0.0).powf(1.0 / power);
        let x = if self.compat {
            let origin = c.strain + s * (1.0 + 2.0 * uo) - s * x;
            1.0 + s * u - s * origin + 2.0 * uo
        } else {
            x + (u - c.strain).abs()
        };
        let (elastic, slope) = self.elastic(u);
        let value = elastic + s * (k / power * (x.powf(power) - far) + height);
        let tangent = slope + k * x.powf(-self.a);
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!("HystereticPoly has no stress at a strain of {u:.6e}")));
        }
        Ok((Stress { value, tangent, damping: 0.0 }, History { strain: u, stress: value }))
    }

    fn initial_tangent(&self) -> f64 {
        if self.compat {
            return self.ka;
        }
        let x = (0.5 * (self.range()[1] + 1.0)).powf(1.0 / (1.0 - self.a));
        self.kb + (self.ka - self.kb) * x.powf(-self.a)
    }
}
