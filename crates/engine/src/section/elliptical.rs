//! Coupled plasticity of two resultants with an elliptical yield surface, isotropic and kinematic hardening (Simo and
//! Hughes, 1998, section 3.3, for a metric of the yield surface).

use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep};
use crate::material::{MaterialError, MaterialResult};
use crate::state_struct::StateStruct as _;

/// Two resultants that yield together, each with a stiffness and a strength of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Elliptical {
    /// Elastic stiffness of each, resultant over deformation.
    pub e: [f64; 2],
    /// Half axes of the yield surface, resultants.
    pub yield_force: [f64; 2],
    /// Isotropic hardening: growth of the surface, as a part of its size, with the plastic multiplier.
    pub isotropic: f64,
    /// Kinematic hardening modulus of each, as the stiffness.
    pub kinematic: [f64; 2],
    /// The resultants.
    pub resultants: [Resultant; 2],
}

crate::state_struct! {
    /// History of [`Elliptical`].
    struct History {
        /// Plastic deformations.
        plastic: [f64; 2],
        /// Sum of the plastic multipliers.
        accumulated: f64,
    }
}

/// Iterations of the plastic multiplier at most.
const MAX_ITERATIONS: usize = 60;
/// Yield function, of the order of one, below which a step is solved.
const TOLERANCE: f64 = 1e-15;

/// A point on the yield surface.
struct Yielding {
    /// Force from the centre of the surface.
    xi: [f64; 2],
    /// Its size in the metric of the surface.
    size: f64,
    /// Plastic multiplier over that size.
    ratio: f64,
}

impl Elliptical {
    /// Metric of the yield surface.
    fn metric(&self, i: usize) -> f64 {
        1.0 / (self.yield_force[i] * self.yield_force[i])
    }

    /// Growth of the yielding force's divisor with the ratio.
    fn rate(&self, i: usize) -> f64 {
        (self.e[i] + self.kinematic[i]) * self.metric(i)
    }

    /// The point that a trial force outside of the surface returns to. With c the multiplier over the size q, each force is
    /// ξ = ξ_trial/(1 + c (E + H) Q), so that q (1 - H_iso c) = 1 + H_iso α is an equation for c alone. It is convex and falls:
    /// Newton's method comes to its root from the left.
    fn return_from(&self, trial: [f64; 2], accumulated: f64) -> Option<Yielding> {
        let target = 1.0 + self.isotropic * accumulated;
        let mut ratio = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let xi = [0, 1].map(|i| trial[i] / (1.0 + ratio * self.rate(i)));
            let size = (0..2).map(|i| self.metric(i) * xi[i] * xi[i]).sum::<f64>().sqrt();
            let over = size * (1.0 - self.isotropic * ratio) - target;
            let fall: f64 =
                (0..2).map(|i| self.metric(i) * xi[i] * xi[i] * self.rate(i) / (1.0 + ratio * self.rate(i))).sum();
            let slope = -fall / size * (1.0 - self.isotropic * ratio) - self.isotropic * size;
            let step = over / slope;
            if over.abs() <= TOLERANCE * target || step.abs() <= f64::EPSILON * ratio {
                return Some(Yielding { xi, size, ratio });
            }
            ratio -= step;
            if !ratio.is_finite() {
                return None;
            }
        }
        None
    }

    /// Consistent tangent at a point on the surface.
    fn tangent(&self, at: &Yielding) -> [f64; 4] {
        let Yielding { xi, size, ratio } = *at;
        let hardening = 1.0 - self.isotropic * ratio;
        let divisor = [0, 1].map(|i| 1.0 + ratio * self.rate(i));
        let normal = [0, 1].map(|i| self.metric(i) * xi[i] / size);
        let along: f64 = (0..2).map(|i| normal[i] * self.rate(i) * xi[i] / divisor[i]).sum();
        let below = self.isotropic * size + hardening * along;
        let mut k = [0.0; 4];
        for j in 0..2 {
            // Derivatives by deformation j: of the ratio, of the forces from the centre, of the plastic deformations.
            let of_ratio = hardening * normal[j] * self.e[j] / divisor[j] / below;
            for i in 0..2 {
                let own = if i == j { self.e[j] } else { 0.0 };
                let of_xi = (own - self.rate(i) * xi[i] * of_ratio) / divisor[i];
                let of_plastic = self.metric(i) * (ratio * of_xi + xi[i] * of_ratio);
                k[2 * i + j] = own - self.e[i] * of_plastic;
            }
        }
        k
    }
}

crate::watches_columns!(Elliptical => nothing);

impl Section for Elliptical {
    plain_methods! { init is_linear depends_on_time elastic joined with_parameter probe }
    fn class(&self) -> &'static str {
        "Elliptical"
    }
    fn resultants(&self) -> &[Resultant] {
        &self.resultants
    }
    fn state_len(&self) -> usize {
        History::LEN
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, next, s, k, .. } = step;
        let mut h = History::read(committed);
        let force = |plastic: &[f64; 2]| [0, 1].map(|i| self.e[i] * (e[i] - plastic[i]));
        let elastic = force(&h.plastic);
        let trial = [0, 1].map(|i| elastic[i] - self.kinematic[i] * h.plastic[i]);
        let size = (0..2).map(|i| self.metric(i) * trial[i] * trial[i]).sum::<f64>().sqrt();
        if size < 1.0 + self.isotropic * h.accumulated {
            s.copy_from_slice(&elastic);
            k.copy_from_slice(&[self.e[0], 0.0, 0.0, self.e[1]]);
        } else {
            let at = self.return_from(trial, h.accumulated).ok_or_else(|| {
                MaterialError(format!("Elliptical has no force at deformations of {:.6e} and {:.6e}", e[0], e[1]))
            })?;
            for i in 0..2 {
                h.plastic[i] += at.ratio * self.metric(i) * at.xi[i];
            }
            h.accumulated += at.ratio * at.size;
            s.copy_from_slice(&force(&h.plastic));
            k.copy_from_slice(&self.tangent(&at));
        }
        h.write(next);
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        k.copy_from_slice(&[self.e[0], 0.0, 0.0, self.e[1]]);
    }
}
