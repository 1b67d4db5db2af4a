//! Smooth asymmetric hysteresis of exponential type.

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};

/// The exponential law of Vaiana, Sessa and Rosati (2021, <https://doi.org/10.1016/j.ymssp.2020.106984>). Every
/// branch approaches one of two limit curves by exp(-a |u - u_c|) from its first point u_c:
///
/// f = f_e(u) + exp(γ u) (k_b u ± f_0), f_e = exp(b₁ u) - exp(-b₂ u) - (b₁ + b₂) u,
///
/// The upper sign applies if u increases. The parameters k_a and k_b are stress over strain, f_0 is a stress, and b₁,
/// b₂ and γ are inverse strains.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticAsym {
    /// Stiffness k_a at the first point of a branch from a limit curve.
    pub ka: f64,
    /// Stiffness k_b of the limit curves at zero strain, less than k_a.
    pub kb: f64,
    /// Half the height f_0 of the loop.
    pub fo: f64,
    /// b₁ and b₂.
    pub b: [f64; 2],
    /// Growth rate γ of the loop.
    pub gamma: f64,
}

crate::state_struct! {
    /// History of laws whose branch depends on its first point alone.
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

    /// Response on the branch that begins at the committed point.
    pub(super) fn branch(&self, c: &History, u: f64) -> MaterialResult<(Stress, History)> {
        let d = u - c.strain;
        let s = if d >= 0.0 { 1.0 } else { -1.0 };
        let a = 0.5 * (self.ka - self.kb) / self.fo;
        let start = (self.elastic(c.strain).0 - c.stress) * (-self.gamma * c.strain).exp();
        // Remaining distance to the limit curve.
        let remaining = (start + self.kb * c.strain + s * self.fo) * (-a * d.abs()).exp();
        let (fe, slope) = self.elastic(u);
        let (loop_force, growth) = (self.kb * u + s * self.fo - remaining, (self.gamma * u).exp());
        let value = fe + growth * loop_force;
        let tangent = slope + growth * (self.gamma * loop_force + self.kb + s * a * remaining);
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!("{} has no stress at a strain of {u:.6e}", Self::NAME)));
        }
        Ok((Stress { value, tangent, damping: 0.0 }, History { strain: u, stress: value }))
    }
}

impl UniaxialLaw for HystereticAsym {
    type State = History;
    const NAME: &'static str = "HystereticAsym";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.branch(c, strain.value)
    }

    fn initial_tangent(&self) -> f64 {
        0.5 * (self.ka + self.kb)
    }
}
