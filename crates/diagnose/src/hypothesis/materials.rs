//! Materials whose devices can have an effect.

use hysteron_identify::study::DeviceMaterial;
use hysteron_identify::study::DeviceMaterial::{LeadRubber, Rubber};

/// Rubber, with or without lead.
pub(super) const RUBBERS: &[DeviceMaterial] = &[Rubber, LeadRubber];

#[cfg(test)]
mod tests {
    use crate::hypothesis;
    use hysteron_identify::study::DeviceMaterial;

    #[test]
    fn a_material_excludes_what_others_have() {
        let suits = |cause: &str, material| hypothesis::of(cause).is_some_and(|h| h.suits(material));
        assert!(
            !suits("mullins_softening", DeviceMaterial::Concrete) && suits("mullins_softening", DeviceMaterial::Rubber)
        );
        assert!(!suits("pinching", DeviceMaterial::LeadRubber) && suits("pinching", DeviceMaterial::Timber));
        assert!(DeviceMaterial::ALL.into_iter().all(|m| suits("gap_impact", m)));
    }
}
