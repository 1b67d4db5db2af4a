//! Slip in series with the hysteretic part.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair, Share, Slack};
use crate::element::ElementError;

/// The hysteretic part z = q - k e runs through slack where it passes zero: beside its own deformation it takes s(z), the
/// slip-lock element in series of Baber and Noori, J. Eng. Mech. 111 (1985), so that q' = q(e - s) + k s. Slack is
/// `size` and a part of the largest deformation so far; `width` is the force within which it is run through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Deformation between the two ends of the slack.
    pub size: f64,
    /// More of it for each deformation that has been reached.
    pub growth: f64,
    /// Hysteretic force within which it slips.
    pub width: f64,
    /// The elastic part, which does not slip.
    pub share: Share,
}

crate::state_struct! {
    /// History.
    pub struct Slipped {
        /// Largest deformation so far.
        largest: f64,
        /// Slack that is taken up in each direction.
        taken: [f64; 2],
    }
}

impl AmendmentLaw for Slip {
    type State = Slipped;
    const NAME: &'static str = "slip";

    fn slack(&self, committed: &Slipped) -> Option<Slack> {
        let size = self.size + self.growth * committed.largest;
        Some(Slack { size, width: self.width, stiffness: self.share.stiffness, taken: committed.taken })
    }

    fn amend(&self, committed: &Slipped, d: &DeformationState) -> Result<(AmendedForce, Slipped), ElementError> {
        let k = self.share.stiffness;
        let taken = d.slack.by;
        let m = d.slack.follows;
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let v = AmendedForce {
            q: std::array::from_fn(|i| d.q[i] + k * taken[i]),
            by_force: m,
            by_deformation: std::array::from_fn(|i| -> Pair { std::array::from_fn(|j| k * (unit(i, j) - m[i][j])) }),
            ..AmendedForce::default()
        };
        Ok((v, Slipped { largest: committed.largest.max(d.amplitude()), taken }))
    }
}
