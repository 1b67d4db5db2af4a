//! Friction whose bristles bend before they slip, and that may be larger at rest.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementError;

/// Friction by the law of Dahl (Aerospace Corporation TOR-0158(3107-18)-1, 1968), with Stribeck's peak at low speed as in
/// Canudas de Wit et al., IEEE Trans. Automat. Control 40 (1995), without the damping of the bristles:
/// f' = k (e' - |e'| f / g), g = F + F_b exp(-(v / v_s)²), isotropic in two directions.
///
/// The speed is that of the step over domain time; where no time passes it is that of rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bristles {
    /// Friction force F of a fast motion.
    pub force: f64,
    /// Stiffness k of the bristles at rest.
    pub stiffness: f64,
    /// What the friction of a slow motion has more, F_b.
    pub breakaway: f64,
    /// Speed v_s by which that has gone; infinite where it stays.
    pub speed: f64,
}

crate::state_struct! {
    /// History.
    pub struct Bent {
        /// Friction force f.
        force: [f64; 2],
    }
}

impl Bristles {
    /// Friction force g of a steady motion, and its derivative by the speed.
    fn steady(&self, v: f64) -> (f64, f64) {
        let x = v / self.speed;
        let peak = self.breakaway * (-x * x).exp();
        (self.force + peak, -2.0 * x / self.speed * peak)
    }
}

impl AmendmentLaw for Bristles {
    type State = Bent;
    const NAME: &'static str = "bristles";

    fn amend(&self, committed: &Bent, d: &DeformationState) -> Result<(AmendedForce, Bent), ElementError> {
        let de = d.increment();
        let way = de[0].hypot(de[1]);
        let mut v = AmendedForce::unchanged(d.q);
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let (steady, falls) = self.steady(if d.dt > 0.0 { way / d.dt } else { 0.0 });
        if way == 0.0 || steady <= 0.0 {
            let k = if steady > 0.0 { self.stiffness } else { 0.0 };
            // How soft bent bristles are depends on the way that they will go: at rest they answer as unbent ones.
            for i in 0..2 {
                v.q[i] += committed.force[i];
                v.by_deformation[i] = std::array::from_fn(|j| k * unit(i, j));
            }
            return Ok((v, *committed));
        }
        // Exact on the straight way of a step: f tends to g n.
        let n: Pair = de.map(|x| x / way);
        let a = self.stiffness * way / steady;
        let left = (-a).exp();
        let force: Pair = std::array::from_fn(|i| steady * n[i] + (committed.force[i] - steady * n[i]) * left);
        let dg: Pair = n.map(|n| if d.dt > 0.0 { falls * n / d.dt } else { 0.0 });
        for i in 0..2 {
            v.q[i] += force[i];
            let off = committed.force[i] - steady * n[i];
            for j in 0..2 {
                let turns = steady * (unit(i, j) - n[i] * n[j]) / way * (1.0 - left);
                let da = self.stiffness * n[j] / steady - a * dg[j] / steady;
                v.by_deformation[i][j] = dg[j] * n[i] * (1.0 - left) + turns - off * left * da;
            }
        }
        Ok((v, Bent { force }))
    }

    fn depends_on_time(&self) -> bool {
        self.breakaway > 0.0
    }
}
