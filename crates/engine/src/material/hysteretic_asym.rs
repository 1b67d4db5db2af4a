//! Smooth hysteresis of exponential type, not the same in both directions.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// The exponential law of Vaiana, Sessa and Rosati (2021, <https://doi.org/10.1016/j.ymssp.2020.106984>): between two limit curves, to
/// which every branch comes closer by exp(-a |u - u_c|) from where it began, u_c,
///
/// f = f_e(u) + exp(γ u) (k_b u ± f_0), f_e = exp(b₁ u) - exp(-b₂ u) - (b₁ + b₂) u,
///
/// with the upper sign where u grows. k_a and k_b are stress over strain, f_0 a stress, b₁, b₂ and γ numbers over strain.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticAsym {
    /// Stiffness at the beginning of a branch that leaves a limit curve k_a.
    pub ka: f64,
    /// Stiffness of the limit curves at zero k_b, less than k_a.
    pub kb: f64,
    /// Half the height of the loop f_0.
    pub fo: f64,
    /// b₁ and b₂.
    pub b: [f64; 2],
    /// Growth of the loop γ.
    pub gamma: f64,
}

crate::state_struct! {
    /// History of laws whose branch is known from the point where it begins.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
    }
}

impl HystereticAsym {
    /// f_e and its derivative.
    fn elastic(&self, u: f64) -> (f64, f64) {
        let [b1, b2] = self.b;
        let (grow, decay) = ((b1 * u).exp(), (-b2 * u).exp());
        (grow - decay - (b1 + b2) * u, b1 * grow + b2 * decay - (b1 + b2))
    }

    /// Stress on the branch that begins at the committed point.
    pub(super) fn branch(&self, c: &History, u: f64) -> Result<(Stress, History), MaterialError> {
        let d = u - c.strain;
        let s = if d >= 0.0 { 1.0 } else { -1.0 };
        let a = 0.5 * (self.ka - self.kb) / self.fo;
        let start = (self.elastic(c.strain).0 - c.stress) * (-self.gamma * c.strain).exp();
        // What is left of the distance to the limit curve.
        let left = (start + self.kb * c.strain + s * self.fo) * (-a * d.abs()).exp();
        let (fe, slope) = self.elastic(u);
        let (loop_force, growth) = (self.kb * u + s * self.fo - left, (self.gamma * u).exp());
        let value = fe + growth * loop_force;
        let tangent = slope + growth * (self.gamma * loop_force + self.kb + s * a * left);
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!("{} has no stress at a strain of {u:.6e}", Self::NAME)));
        }
        Ok((Stress { value, tangent, damping: 0.0 }, History { strain: u, stress: value }))
    }
}

impl UniaxialLaw for HystereticAsym {
    type State = History;
    const NAME: &'static str = "HystereticAsym";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.branch(c, strain.value)
    }

    fn initial_tangent(&self) -> f64 {
        0.5 * (self.ka + self.kb)
    }
}
