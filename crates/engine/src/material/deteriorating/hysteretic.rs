//! Trilinear hysteresis with pinching, damage and degraded unloading (Scott and Filippou, 2000).

pub(super) mod cycle;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use cycle::{Cycle, Enveloped, FLAT_SLOPE_RATIO, MAX_STRAIN, Reloading};

/// The envelope on one side: stresses and strains of its three points, positive on both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    pub(super) stress: [f64; 3],
    pub(super) strain: [f64; 3],
    pub(super) slope: [f64; 3],
    /// Unloading slope, equal to the steepest slope of the envelope.
    unloading: f64,
}

impl Envelope {
    /// An envelope through three points with increasing strains.
    pub fn new(stress: [f64; 3], strain: [f64; 3]) -> Self {
        let slope = [
            stress[0] / strain[0],
            (stress[1] - stress[0]) / (strain[1] - strain[0]),
            (stress[2] - stress[1]) / (strain[2] - strain[1]),
        ];
        Self { stress, strain, slope, unloading: slope[0].max(slope[1]).max(slope[2]) }
    }

    /// An envelope through two points; the additional point is their midpoint.
    pub fn bilinear(stress: [f64; 2], strain: [f64; 2]) -> Self {
        let mid = |x: [f64; 2]| [x[0], 0.5 * (x[0] + x[1]), x[1]];
        Self::new(mid(stress), mid(strain))
    }

    /// Stress and slope at a strain.
    pub(super) fn at(&self, x: f64) -> (f64, f64) {
        let (m, r, e) = (&self.stress, &self.strain, &self.slope);
        if x < 0.0 {
            (0.0, FLAT_SLOPE_RATIO * e[0])
        } else if x <= r[0] {
            (e[0] * x, e[0])
        } else if x <= r[1] {
            (m[0] + e[1] * (x - r[0]), e[1])
        } else if x <= r[2] || e[2] > 0.0 {
            (m[1] + e[2] * (x - r[1]), e[2])
        } else {
            (m[2], FLAT_SLOPE_RATIO * e[0])
        }
    }

    /// Strain of zero stress on the descending branch that contains the largest strain.
    pub(super) fn exhausted(&self, largest: f64) -> Option<f64> {
        let (m, r, e) = (&self.stress, &self.strain, &self.slope);
        let limit = if largest <= r[0] {
            return None;
        } else if largest <= r[1] {
            (e[1] < 0.0).then(|| r[0] - m[0] / e[1])
        } else {
            (e[2] < 0.0).then(|| r[1] - m[1] / e[2])
        };
        limit.filter(|&x| self.at(x).0 <= 0.0)
    }

    /// Area under the envelope up to its last point.
    pub(super) fn energy(&self) -> f64 {
        let (m, r) = (&self.stress, &self.strain);
        0.5 * (r[0] * m[0] + (r[1] - r[0]) * (m[1] + m[0]) + (r[2] - r[1]) * (m[2] + m[1]))
    }

    /// Degradation factor of the unloading slope after a largest strain.
    pub(super) fn degraded(&self, largest: f64, beta: f64) -> f64 {
        let k = (largest / self.strain[0]).powf(beta);
        if k < 1.0 { 1.0 } else { 1.0 / k }
    }
}

/// Hysteresis between two envelopes.
#[derive(Clone, Debug, PartialEq)]
pub struct Hysteretic {
    sides: [Envelope; 2],
    pinch_x: f64,
    pinch_y: f64,
    /// Damage factors for ductility and for energy.
    damage: [f64; 2],
    /// Exponent of the degraded unloading stiffness.
    beta: f64,
    energy: f64,
}

impl Hysteretic {
    /// From the envelopes in tension and compression. The other arguments are the pinching factors of strain and
    /// stress, the damage factors for ductility and energy, and the exponent of the unloading stiffness.
    pub fn new(tension: Envelope, compression: Envelope, pinch: [f64; 2], damage: [f64; 2], beta: f64) -> Self {
        let energy = tension.energy() + compression.energy();
        Self { sides: [tension, compression], pinch_x: pinch[0], pinch_y: pinch[1], damage, beta, energy }
    }
}

impl Enveloped for Hysteretic {
    type History = Cycle;
    const NAME: &'static str = "Hysteretic";

    fn cycle(history: &Cycle) -> &Cycle {
        history
    }
    fn cycle_mut(history: &mut Cycle) -> &mut Cycle {
        history
    }
    fn initial(&self) -> f64 {
        self.sides[0].slope[0]
    }
    fn envelope(&self, _: &Cycle, side: usize, x: f64) -> (f64, f64) {
        self.sides[side].at(x)
    }

    fn advance(&self, c: &Cycle, d: f64, t: &mut Cycle, s: f64) -> (f64, f64) {
        let (ahead, behind) = if s > 0.0 { (0, 1) } else { (1, 0) };
        let (front, rear) = (&self.sides[ahead], &self.sides[behind]);
        let k_rear = rear.unloading * rear.degraded(c.extreme[behind], self.beta);
        let k_front = front.unloading * front.degraded(c.extreme[ahead], self.beta);
        let (x, x_c, sig_c, d) = (s * t.strain, s * c.strain, s * c.stress, s * d);
        if t.loading == -s && sig_c <= 0.0 {
            t.unloaded[behind] = s * (x_c - sig_c / k_rear);
            let energy = c.energy - 0.5 * sig_c / k_rear * sig_c;
            let (reached, first) = (c.extreme[behind], rear.strain[0]);
            if reached > first {
                let harm = self.damage[1] * energy / self.energy + self.damage[0] * (reached - first) / first;
                t.extreme[ahead] = c.extreme[ahead] * (1.0 + harm);
            }
        }
        t.loading = s;
        t.extreme[ahead] = t.extreme[ahead].min(MAX_STRAIN).max(front.strain[0]);
        let target = t.extreme[ahead];
        let (peak, _) = front.at(target);
        let zero = s * t.unloaded[behind];
        let release = rear.exhausted(c.extreme[behind]).map_or(zero, |limit| zero.max(-limit));
        let full = target - (1.0 - self.pinch_y) * peak / k_front;
        let reloading = Reloading {
            zero,
            release,
            pinch: release + (full - release) * self.pinch_x,
            target: [target, peak],
            share: self.pinch_y,
            slopes: [k_rear, k_front],
            elastic: [rear.unloading, front.unloading],
        };
        reloading.at(x, d, sig_c)
    }
}

impl UniaxialLaw for Hysteretic {
    type State = Cycle;
    const NAME: &'static str = "Hysteretic";

    fn update(&self, c: &Cycle, strain: Strain) -> MaterialResult<(Stress, Cycle)> {
        self.step(c, strain)
    }

    fn initial_tangent(&self) -> f64 {
        self.initial()
    }
}
