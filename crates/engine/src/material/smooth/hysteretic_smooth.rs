//! Smooth symmetric hysteresis of exponential type.

use crate::material::smooth::hysteretic_asym::{History, HystereticAsym};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// The exponential law of Vaiana, Sessa, Marmo and Rosati (2018, <https://doi.org/10.1007/s11071-018-4282-2>): [`HystereticAsym`] with
/// b₁ = b₂ = β and γ = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticSmooth {
    law: HystereticAsym,
}

impl HystereticSmooth {
    /// From the stiffnesses k_a (first point of a branch) and k_b (limit curves), half the height of the loop
    /// (stress), and β (inverse strain).
    pub fn new(ka: f64, kb: f64, fbar: f64, beta: f64) -> Self {
        Self { law: HystereticAsym { ka, kb, fo: fbar, b: [beta; 2], gamma: 0.0 } }
    }
}

impl UniaxialLaw for HystereticSmooth {
    type State = History;
    const NAME: &'static str = "HystereticSmooth";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.law.branch(c, strain.value)
    }

    fn initial_tangent(&self) -> f64 {
        UniaxialLaw::initial_tangent(&self.law)
    }
}
