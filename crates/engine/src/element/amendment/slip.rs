//! Slip in series with the hysteretic part.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair, Share, Slack, SlackCurve};
use crate::element::ElementResult;

/// The hysteretic part z = q - k e has slack s(z) in series: q' = q(e - s) + k s. The slip-lock element in series is
/// that of Baber and Noori, J. Eng. Mech. 111 (1985). The slack is `size` plus `growth` times the largest deformation;
/// `width` is its force scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Slack deformation of the virgin element.
    pub size: f64,
    /// Increase of the slack per unit of the largest deformation.
    pub growth: f64,
    /// Hysteretic force within which slip occurs.
    pub width: f64,
    /// Split of the force; the elastic part has no slip.
    pub share: Share,
}

crate::state_struct! {
    /// State variables.
    pub struct SlipState {
        /// Largest deformation so far.
        largest: f64,
        /// Slack deformation in each direction.
        slip: [f64; 2],
    }
}

impl AmendmentLaw for Slip {
    type State = SlipState;
    const NAME: &'static str = "slip";

    fn slack(&self, committed: &SlipState, _: f64) -> Option<Slack> {
        let size = self.size + self.growth * committed.largest;
        let curve = SlackCurve::Bounded { size, width: self.width };
        Some(Slack { curve, stiffness: self.share.stiffness, committed: committed.slip })
    }

    fn amend(&self, committed: &SlipState, d: &DeformationState) -> ElementResult<(AmendedForce, SlipState)> {
        let k = self.share.stiffness;
        let slip = d.slack.by;
        let m = d.slack.follows;
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let v = AmendedForce {
            q: std::array::from_fn(|i| d.q[i] + k * slip[i]),
            by_force: m,
            by_deformation: std::array::from_fn(|i| -> Pair { std::array::from_fn(|j| k * (unit(i, j) - m[i][j])) }),
            ..AmendedForce::default()
        };
        Ok((v, SlipState { largest: committed.largest.max(d.amplitude()), slip }))
    }
}
