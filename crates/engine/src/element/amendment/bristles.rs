//! Friction with presliding deformation (bristles) and breakaway force.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementError;

/// f' = k (e' - |e'| f / g) with g = F + F_b exp(-(v / v_s)²), isotropic in two directions.
///
/// The law of friction is that of Dahl (Aerospace Corporation TOR-0158(3107-18)-1, 1968). Stribeck's peak at low speed
/// is that of Canudas de Wit et al., IEEE Trans. Automat. Control 40 (1995), without the damping of the bristles.
///
/// The speed v is |Δe| over the increment of domain time; 0 if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bristles {
    /// Friction force F at high speed.
    pub force: f64,
    /// Stiffness k of the bristles at zero force.
    pub stiffness: f64,
    /// Increase F_b of the friction force at low speed.
    pub breakaway: f64,
    /// Stribeck speed v_s; infinite for a constant friction force.
    pub speed: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct BristlesState {
        /// Friction force f.
        force: [f64; 2],
    }
}

impl Bristles {
    /// Steady friction force g, and its derivative with respect to the speed.
    fn steady(&self, v: f64) -> (f64, f64) {
        let x = v / self.speed;
        let peak = self.breakaway * (-x * x).exp();
        (self.force + peak, -2.0 * x / self.speed * peak)
    }
}

impl AmendmentLaw for Bristles {
    type State = BristlesState;
    const NAME: &'static str = "bristles";

    fn amend(
        &self,
        committed: &BristlesState,
        d: &DeformationState,
    ) -> Result<(AmendedForce, BristlesState), ElementError> {
        let de = d.increment();
        let increment_size = de[0].hypot(de[1]);
        let mut v = AmendedForce::unchanged(d.q);
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let (steady, steady_slope) = self.steady(if d.dt > 0.0 { increment_size / d.dt } else { 0.0 });
        if increment_size == 0.0 || steady <= 0.0 {
            let k = if steady > 0.0 { self.stiffness } else { 0.0 };
            // The stiffness of bent bristles depends on the direction of motion, which is unknown at rest: use that of
            // unbent bristles.
            for i in 0..2 {
                v.q[i] += committed.force[i];
                v.by_deformation[i] = std::array::from_fn(|j| k * unit(i, j));
            }
            return Ok((v, *committed));
        }
        // Exact for a straight increment: f tends to g n.
        let n: Pair = de.map(|x| x / increment_size);
        let a = self.stiffness * increment_size / steady;
        let decay = (-a).exp();
        let force: Pair = std::array::from_fn(|i| steady * n[i] + (committed.force[i] - steady * n[i]) * decay);
        let dg: Pair = n.map(|n| if d.dt > 0.0 { steady_slope * n / d.dt } else { 0.0 });
        for i in 0..2 {
            v.q[i] += force[i];
            let deviation = committed.force[i] - steady * n[i];
            for j in 0..2 {
                let rotation = steady * (unit(i, j) - n[i] * n[j]) / increment_size * (1.0 - decay);
                let da = self.stiffness * n[j] / steady - a * dg[j] / steady;
                v.by_deformation[i][j] = dg[j] * n[i] * (1.0 - decay) + rotation - deviation * decay * da;
            }
        }
        Ok((v, BristlesState { force }))
    }

    fn depends_on_time(&self) -> bool {
        self.breakaway > 0.0
    }
}
