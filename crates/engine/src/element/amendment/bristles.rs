//! Friction with presliding deformation (bristles) and breakaway force.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// f' = k (e' - |e'| f / g) with g = F + F_b (1 - w) exp(-(v / v_s)²), isotropic in two directions.
///
/// The law of friction is that of Dahl (Aerospace Corporation TOR-0158(3107-18)-1, 1968). Stribeck's peak at low speed
/// is that of Canudas de Wit et al., IEEE Trans. Automat. Control 40 (1995), without the damping of the bristles.
///
/// Slip wears the breakaway force off, and time brings it back: w' = (1 - w) |e'| / L - w / τ, after Cochard and Madariaga,
/// Pure Appl. Geophys. 142 (1994). The face has rested before the first increment: w = 0.
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
    /// Slip L over which F_b is worn off; infinite for a breakaway force that stays.
    pub slip: f64,
    /// Time τ at rest in which F_b comes back; infinite where it does not.
    pub rest: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct BristlesState {
        /// Friction force f.
        force: [f64; 2],
        /// Worn share w of the breakaway force.
        worn: f64,
    }
}

impl Bristles {
    /// Worn share w after an increment of size s and duration dt, and its derivative by s. Exact at a constant speed.
    fn worn(&self, before: f64, s: f64, dt: f64) -> (f64, f64) {
        let (wear, healing) = (s / self.slip, dt / self.rest);
        let rate = wear + healing;
        if rate <= 0.0 {
            return (before, (1.0 - before) / self.slip);
        }
        let (limit, decay) = (wear / rate, (-rate).exp());
        let by_wear = healing / (rate * rate) * (1.0 - decay) + (limit - before) * decay;
        (limit + (before - limit) * decay, by_wear / self.slip)
    }

    /// Steady friction force g at a speed v and a worn share w, and its derivatives by both.
    fn steady(&self, v: f64, w: f64) -> (f64, f64, f64) {
        let x = v / self.speed;
        let peak = self.breakaway * (-x * x).exp();
        (self.force + peak * (1.0 - w), -2.0 * x / self.speed * peak * (1.0 - w), -peak)
    }
}

impl AmendmentLaw for Bristles {
    type State = BristlesState;
    const NAME: &'static str = "bristles";

    fn amend(&self, committed: &BristlesState, d: &DeformationState) -> ElementResult<(AmendedForce, BristlesState)> {
        let de = d.increment();
        let increment_size = de[0].hypot(de[1]);
        let mut v = AmendedForce::unchanged(d.q);
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let (worn, by_size) = self.worn(committed.worn, increment_size, d.dt);
        let (steady, by_speed, by_worn) = self.steady(if d.dt > 0.0 { increment_size / d.dt } else { 0.0 }, worn);
        if increment_size == 0.0 || steady <= 0.0 {
            let k = if steady > 0.0 { self.stiffness } else { 0.0 };
            // The stiffness of bent bristles depends on the direction of motion, which is unknown at rest: use that of
            // unbent bristles.
            for i in 0..2 {
                v.q[i] += committed.force[i];
                v.by_deformation[i] = std::array::from_fn(|j| k * unit(i, j));
            }
            return Ok((v, BristlesState { worn, ..*committed }));
        }
        // Exact for a straight increment: f tends to g n.
        let n: Pair = de.map(|x| x / increment_size);
        let a = self.stiffness * increment_size / steady;
        let decay = (-a).exp();
        let force: Pair = std::array::from_fn(|i| steady * n[i] + (committed.force[i] - steady * n[i]) * decay);
        let slope = by_worn * by_size + if d.dt > 0.0 { by_speed / d.dt } else { 0.0 };
        let dg: Pair = n.map(|n| slope * n);
        for i in 0..2 {
            v.q[i] += force[i];
            let deviation = committed.force[i] - steady * n[i];
            for j in 0..2 {
                let rotation = steady * (unit(i, j) - n[i] * n[j]) / increment_size * (1.0 - decay);
                let da = self.stiffness * n[j] / steady - a * dg[j] / steady;
                v.by_deformation[i][j] = dg[j] * n[i] * (1.0 - decay) + rotation - deviation * decay * da;
            }
        }
        Ok((v, BristlesState { force, worn }))
    }

    fn depends_on_time(&self) -> bool {
        self.breakaway > 0.0
    }
}
