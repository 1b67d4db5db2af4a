//! Friction smoothed over speed.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// Coulomb friction f = F v / √(|v|² + v₀²), isotropic in two directions; 0 at zero speed. This is a usual
/// regularisation of the sign function, and the drag of lubricated guides. The velocity is Δe over the increment of
/// domain time, in static analyses too; the force is 0 if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliding {
    /// Friction force F of a fast motion.
    pub force: f64,
    /// Speed v₀ at which the force is F/√2.
    pub speed: f64,
}

impl AmendmentLaw for Sliding {
    type State = ();
    const NAME: &'static str = "sliding";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        let mut out = AmendedForce::unchanged(d.q);
        if d.dt <= 0.0 {
            return Ok((out, ()));
        }
        let v: Pair = d.increment().map(|de| de / d.dt);
        let size = v[0].hypot(v[1]).hypot(self.speed);
        for i in 0..2 {
            out.q[i] += self.force * v[i] / size;
            for j in 0..2 {
                let unit = f64::from(u8::from(i == j));
                out.by_deformation[i][j] = self.force / (size * d.dt) * (unit - v[i] * v[j] / (size * size));
            }
        }
        Ok((out, ()))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}
