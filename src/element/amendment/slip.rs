//! Slip where the hysteretic force passes zero.

use super::{AmendmentLaw, Demand, Share, Verdict};
use crate::element::ElementError;

/// The hysteretic part z = q - k e grows slowly about zero, as slack is run through:
/// z' = z (1 - depth exp(-(z / (width z_max))²)) with the largest z so far, the slip-lock function of Baber and Noori,
/// J. Eng. Mech. 111 (1985), in terms of the force instead of its rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Part of the hysteretic force that is missing where it passes zero, 0 to 1.
    pub depth: f64,
    /// Width of that, as a part of the largest hysteretic force so far.
    pub width: f64,
    /// The elastic part, which does not slip.
    pub share: Share,
}

crate::words! {
    /// History.
    pub struct Reached {
        /// Largest hysteretic force so far.
        largest: f64,
    }
}

impl AmendmentLaw for Slip {
    type State = Reached;
    const NAME: &'static str = "slip";

    fn amend(&self, committed: &Reached, d: &Demand) -> Result<(Verdict, Reached), ElementError> {
        let k = self.share.stiffness;
        let mut v = Verdict::unchanged(d.q);
        let mut largest = committed.largest;
        for i in 0..2 {
            let z = d.q[i] - k * d.e[i];
            largest = largest.max(z.abs());
            if committed.largest <= 0.0 {
                continue;
            }
            let x = z / (self.width * committed.largest);
            let missing = self.depth * (-x * x).exp();
            // d z'/d z
            let slope = 1.0 - missing * (1.0 - 2.0 * x * x);
            v.q[i] = d.q[i] - missing * z;
            v.by_force[i][i] = slope;
            v.by_deformation[i][i] = k * (1.0 - slope);
        }
        Ok((v, Reached { largest }))
    }
}
