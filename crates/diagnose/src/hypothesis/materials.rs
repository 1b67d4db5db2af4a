//! Causes that devices of some materials alone can have.

use hysteron_identify::study::DeviceMaterial;
use hysteron_identify::study::DeviceMaterial::{Concrete, LeadRubber, Rubber, Steel, Timber};

/// Rubber, with or without lead.
pub(super) const RUBBERS: &[DeviceMaterial] = &[Rubber, LeadRubber];

/// Causes with the materials whose devices can have them; the others know no material.
///
/// Fillers of rubber let go of its chains once (Mullins), and rubber tears inside under tension. Cracks that close, and holes
/// that nails have widened, pinch loops.
const CAUSES: &[(&str, &[DeviceMaterial])] =
    &[("mullins_softening", RUBBERS), ("cavitation", RUBBERS), ("pinching", &[Steel, Concrete, Timber])];

/// Returns true if devices of a material can have a cause.
pub(super) fn suits(cause: &str, material: DeviceMaterial) -> bool {
    CAUSES.iter().find(|(of, _)| *of == cause).is_none_or(|(_, materials)| materials.contains(&material))
}

#[cfg(test)]
mod tests {
    use super::{CAUSES, suits};
    use crate::hypothesis;
    use hysteron_identify::study::DeviceMaterial;

    #[test]
    fn a_material_excludes_what_others_have() {
        assert!(
            !suits("mullins_softening", DeviceMaterial::Concrete) && suits("mullins_softening", DeviceMaterial::Rubber)
        );
        assert!(!suits("pinching", DeviceMaterial::LeadRubber) && suits("pinching", DeviceMaterial::Timber));
        assert!(DeviceMaterial::ALL.into_iter().all(|m| suits("gap_impact", m)));
        assert!(CAUSES.iter().all(|(cause, _)| hypothesis::of(cause).is_some()));
    }
}
