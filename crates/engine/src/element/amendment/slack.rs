//! Slack in series with an element: the part of a deformation that it does not get.

use super::Pair;
use crate::element::ElementError;

/// Slack s(z) = ½ size tanh(z / width) in each direction, where z = q(e - s) - k (e - s) is what the element answers to the
/// rest, without its elastic part. The flexibility ds/dz is a bump about z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slack {
    /// Deformation from end to end.
    pub size: f64,
    /// Force within which it is run through.
    pub width: f64,
    /// Stiffness k of the elastic part.
    pub stiffness: f64,
    /// What was taken of it in the committed state: where the search begins.
    pub taken: Pair,
}

/// What slack takes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlackShare {
    /// Deformation s.
    pub by: Pair,
    /// dz by that which it would be without slack, (I + (K - k) ds/dz)⁻¹.
    pub follows: [Pair; 2],
    /// ds/dz.
    pub flexibility: Pair,
}

/// What an element answers to a deformation: its forces, and their derivatives by the deformations.
pub(super) type ForceAndTangent = (Pair, [Pair; 2]);

/// Trials of the search, how near it comes to the end, as a part of the slack, and the shortest part of a step.
const TRIALS: usize = 200;
const NEAR: f64 = 1e-12;
const SHORTEST: f64 = 1e-4;

impl Slack {
    fn at(&self, z: f64) -> (f64, f64) {
        let t = (z / self.width).tanh();
        (0.5 * self.size * t, 0.5 * self.size / self.width * (1.0 - t * t))
    }

    /// Find what it takes of the deformation `e`, by Newton's method with steps that lead nearer.
    ///
    /// # Errors
    /// Those of the element; no end found.
    pub(super) fn settle(
        &self,
        e: Pair,
        mut ask: impl FnMut(Pair) -> Result<ForceAndTangent, ElementError>,
    ) -> Result<SlackShare, ElementError> {
        let half = 0.5 * self.size;
        let size = self.size.max(f64::MIN_POSITIVE);
        let mut s = self.taken.map(|s| s.clamp(-half, half));
        // Where the last step began, its direction and its length.
        let mut last: Option<(Pair, Pair, f64, f64)> = None;
        for _ in 0..TRIALS {
            let (q, tangent) = ask(s)?;
            let (mut missing, mut flexibility) = ([0.0; 2], [0.0; 2]);
            for i in 0..2 {
                let (taken, slope) = self.at(q[i] - self.stiffness * (e[i] - s[i]));
                missing[i] = taken - s[i];
                flexibility[i] = slope;
            }
            let error = missing[0].hypot(missing[1]);
            if error <= NEAR * size {
                return Ok(SlackShare { by: s, follows: self.follows(&tangent, flexibility), flexibility });
            }
            match last {
                // Too long a step: the same way, half as far.
                Some((from, way, length, before)) if error >= before && length > SHORTEST => {
                    let length = 0.5 * length;
                    last = Some((from, way, length, before));
                    s = std::array::from_fn(|i| (from[i] + length * way[i]).clamp(-half, half));
                }
                _ => {
                    // (I + D (K - k))⁻¹ is the transpose of `follows` of the transposed tangent.
                    let turned = [[tangent[0][0], tangent[1][0]], [tangent[0][1], tangent[1][1]]];
                    let by = self.follows(&turned, flexibility);
                    let way = std::array::from_fn(|i| by[0][i] * missing[0] + by[1][i] * missing[1]);
                    last = Some((s, way, 1.0, error));
                    s = std::array::from_fn(|i| (s[i] + way[i]).clamp(-half, half));
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
        // A softening element may have no way back: then the search halves.
        let det = if det.abs() < 1e-6 { 1e-6 } else { det };
        [[d / det, -b / det], [-c / det, a / det]]
    }

    /// At rest, by the stiffness of the virgin element.
    pub(super) fn at_rest(&self, tangent: &[Pair; 2]) -> SlackShare {
        let flexibility = [self.at(0.0).1; 2];
        SlackShare { by: [0.0; 2], follows: self.follows(tangent, flexibility), flexibility }
    }
}
