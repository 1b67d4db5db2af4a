//! One yield surface for two directions.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementResult;
use crate::element::bearing::{BoucWenShear, Shear, ShearLaw};

/// The law of `elastomericBearingBoucWen` in both directions, in place of two uncoupled springs. The force of the
/// element is not used. Source: Park, Wen and Ang, Earthquake Eng. Struct. Dyn. 14 (1986).
#[derive(Clone, Debug, PartialEq)]
pub struct Coupling {
    /// The Bouc-Wen law.
    pub law: BoucWenShear,
}

impl AmendmentLaw for Coupling {
    type State = Shear<2>;
    const NAME: &'static str = "coupling";

    fn amend(&self, committed: &Shear<2>, d: &DeformationState) -> ElementResult<(AmendedForce, Shear<2>)> {
        let virgin = *committed == Shear::default();
        let next = if virgin { self.law.step(&self.law.virgin(), d.e) } else { self.law.step(committed, d.e) }?;
        Ok((AmendedForce { q: next.q, by_deformation: next.k, ..AmendedForce::default() }, next))
    }
}
