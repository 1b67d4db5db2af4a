//! Elastic material with a gap on either side.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Linear elastic beyond a gap in either sense.
#[derive(Clone, Debug, PartialEq)]
pub struct HookGap {
    /// Elastic modulus beyond the gaps.
    pub e: f64,
    /// Gaps in compression, negative, and in tension.
    pub gap: [f64; 2],
}

impl UniaxialLaw for HookGap {
    type State = ();
    const NAME: &'static str = "HookGap";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let x = strain.value;
        let past = (x - self.gap[1]).max(0.0) + (x - self.gap[0]).min(0.0);
        let tangent = if self.gap[0] < x && x < self.gap[1] { 0.0 } else { self.e };
        Ok((Stress { value: self.e * past, tangent, damping: 0.0 }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }
}
