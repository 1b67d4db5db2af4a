//! Slack in series with an element.

use super::Pair;
use crate::element::{ElementError, ElementResult};

/// Slack s(z) in each direction. The force z = q(e - s) - k (e - s) is that of the element at e - s without its elastic
/// part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slack {
    /// The function s(z).
    pub curve: SlackCurve,
    /// Stiffness k of the elastic part.
    pub stiffness: f64,
    /// Committed slack deformation, the start of the iteration.
    pub committed: Pair,
}

/// Slack deformation over the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlackCurve {
    /// ½ size tanh(z / width). The flexibility ds/dz has its maximum at z = 0 and vanishes for large |z|.
    Bounded {
        /// Total slack deformation, from z → -∞ to z → ∞.
        size: f64,
        /// Force scale of the slack.
        width: f64,
    },
    /// s₀ + flexibility z.
    Linear {
        /// Slack s₀ without force.
        unloaded: Pair,
        /// Flexibility ds/dz.
        flexibility: f64,
    },
}

/// Slack deformation with derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlackShare {
    /// Deformation s.
    pub by: Pair,
    /// ∂z/∂z₀ for the force z₀ without slack: (I + (K - k) ds/dz)⁻¹.
    pub follows: [Pair; 2],
    /// ds/dz.
    pub flexibility: Pair,
}

/// Forces of an element, and their derivatives with respect to the deformations.
pub(super) type ForceAndTangent = (Pair, [Pair; 2]);

/// Largest number of iterations; tolerance, as a part of the slack's scale; smallest line search factor.
const MAX_ITERATIONS: usize = 200;
const RELATIVE_TOLERANCE: f64 = 1e-12;
const MIN_STEP: f64 = 1e-4;
/// Smallest size of the determinant in the step, so that a singular tangent gives a finite step.
const MIN_DETERMINANT: f64 = 1e-6;

impl Slack {
    /// Slack of a direction and its flexibility.
    fn slack_at(&self, direction: usize, z: f64) -> (f64, f64) {
        match self.curve {
            SlackCurve::Bounded { size, width } => {
                let t = (z / width).tanh();
                (0.5 * size * t, 0.5 * size / width * (1.0 - t * t))
            }
            SlackCurve::Linear { unloaded, flexibility } => (unloaded[direction] + flexibility * z, flexibility),
        }
    }

    /// Largest slack, and the deformation that its tolerance is a part of.
    fn bounds(&self, e: Pair) -> (f64, f64) {
        match self.curve {
            SlackCurve::Bounded { size, .. } => (0.5 * size, size),
            SlackCurve::Linear { unloaded, .. } => {
                (f64::INFINITY, e[0].hypot(e[1]).max(unloaded[0].hypot(unloaded[1])))
            }
        }
    }

    /// Slack deformation at the total deformation `e`, by Newton's method with a line search.
    ///
    /// # Errors
    /// Errors of `evaluate`; no convergence.
    pub(super) fn solve(
        &self,
        e: Pair,
        mut evaluate: impl FnMut(Pair) -> ElementResult<ForceAndTangent>,
    ) -> ElementResult<SlackShare> {
        let (most, scale) = self.bounds(e);
        let tolerance = RELATIVE_TOLERANCE * scale.max(f64::MIN_POSITIVE);
        let mut s = self.committed.map(|s| s.clamp(-most, most));
        // Start of the last step, its direction, its length and the error before it.
        let mut last: Option<(Pair, Pair, f64, f64)> = None;
        for _ in 0..MAX_ITERATIONS {
            let (q, tangent) = evaluate(s)?;
            let (mut residual, mut flexibility) = ([0.0; 2], [0.0; 2]);
            for i in 0..2 {
                let (target, slope) = self.slack_at(i, q[i] - self.stiffness * (e[i] - s[i]));
                residual[i] = target - s[i];
                flexibility[i] = slope;
            }
            let error = residual[0].hypot(residual[1]);
            if error <= tolerance {
                return Ok(SlackShare { by: s, follows: self.follows(&tangent, flexibility), flexibility });
            }
            match last {
                // The error grew: halve the step.
                Some((from, direction, length, before)) if error >= before && length > MIN_STEP => {
                    let length = 0.5 * length;
                    last = Some((from, direction, length, before));
                    s = std::array::from_fn(|i| (from[i] + length * direction[i]).clamp(-most, most));
                }
                _ => {
                    // (I + D (K - k))⁻¹ is the transpose of `follows` for the transposed tangent.
                    let transposed = [[tangent[0][0], tangent[1][0]], [tangent[0][1], tangent[1][1]]];
                    let by = self.follows(&transposed, flexibility);
                    let direction = std::array::from_fn(|i| by[0][i] * residual[0] + by[1][i] * residual[1]);
                    last = Some((s, direction, 1.0, error));
                    s = std::array::from_fn(|i| (s[i] + direction[i]).clamp(-most, most));
                }
            }
        }
        Err(ElementError("the slack in series with the element does not settle".into()))
    }

    /// (I + (K - k) D)⁻¹ with D = ds/dz.
    pub(super) fn follows(&self, tangent: &[Pair; 2], flexibility: Pair) -> [Pair; 2] {
        let entry = |i: usize, j: usize| {
            let unit = f64::from(u8::from(i == j));
            unit + (tangent[i][j] - self.stiffness * unit) * flexibility[j]
        };
        let [[a, b], [c, d]] = [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]];
        let det = a * d - b * c;
        // A softening element can be singular here; the line search then shortens the step.
        let det = if det.abs() < MIN_DETERMINANT { MIN_DETERMINANT } else { det };
        [[d / det, -b / det], [-c / det, a / det]]
    }

    /// Slack deformation 0 with the derivatives for the stiffness of the virgin element.
    pub(super) fn at_rest(&self, tangent: &[Pair; 2]) -> SlackShare {
        let flexibility = [self.slack_at(0, 0.0).1; 2];
        SlackShare { by: [0.0; 2], follows: self.follows(tangent, flexibility), flexibility }
    }
}
