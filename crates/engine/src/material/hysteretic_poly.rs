//! Smooth hysteresis of algebraic type.

use super::hysteretic_asym::History;
use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// The algebraic law of Vaiana, Sessa, Marmo and Rosati (2019, <https://doi.org/10.1007/s11071-019-05022-5>): a branch that begins at
/// u_c comes to the limit curve
///
/// f = β₁ u³ + β₂ u⁵ + k_b u ± f̄
///
/// by a power of its length, (x_c + |u - u_c|)^(1-a), where x_c follows from the force at u_c. The stiffness at the end of a branch, less
/// k_b, is the tolerance; it determines f̄.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticPoly {
    /// Stiffness at the beginning of a branch that leaves a limit curve k_a.
    pub ka: f64,
    /// Stiffness of the limit curves at zero k_b, less than k_a.
    pub kb: f64,
    /// Exponent a, not 1.
    pub a: f64,
    /// β₁ and β₂.
    pub b: [f64; 2],
    /// Stiffness, less k_b, at which a branch has come to the limit curve.
    pub tolerance: f64,
    /// As in OpenSees, the branch goes through a point that is found with the round-off of its whole length, and the initial stiffness is
    /// k_a.
    pub compat: bool,
}

impl HystereticPoly {
    /// OpenSees' tolerance.
    pub const TOLERANCE: f64 = 1e-20;

    /// Half the length of a branch from one limit curve to the other u_0; its whole length, with that at its beginning, to the power 1 - a;
    /// half the height of the loop.
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

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let (u, k, power) = (strain.value, self.ka - self.kb, 1.0 - self.a);
        let s = if u >= c.strain { 1.0 } else { -1.0 };
        let [uo, far, height] = self.range();
        let start = power / k * (s * (c.stress - self.elastic(c.strain).0) - height) + far;
        // On the limit curve or, by round-off, beyond it the branch has come to its end.
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
