//! Kinds of things that commands define, in the words of messages.
//!
//! The engine has registries for some of them, with the same words; a test compares them.

/// A node.
pub(crate) const NODE: &str = "node";
/// An element.
pub(crate) const ELEMENT: &str = "element";
/// A region.
pub(crate) const REGION: &str = "region";
/// A load pattern.
pub(crate) const PATTERN: &str = "load pattern";
/// A ground motion of a pattern MultipleSupport.
pub(crate) const GROUND_MOTION: &str = "ground motion";
/// A parameter.
pub(crate) const PARAMETER: &str = "parameter";
/// A recorder.
pub(crate) const RECORDER: &str = "recorder";
/// A mode that `eigen` finds, by its number; without one, the modes.
pub(crate) const MODE: &str = "mode";
/// The analysis.
pub(crate) const ANALYSIS: &str = "analysis";
/// The model.
pub(crate) const MODEL: &str = "model";
/// A degree of freedom.
pub(crate) const DOF: &str = "degree of freedom";
/// A uniaxial material.
pub(crate) const MATERIAL: &str = "uniaxial material";
/// A material of continua.
pub(crate) const ND_MATERIAL: &str = "material of continua";
/// A friction model.
pub(crate) const FRICTION: &str = "friction model";
/// A section.
pub(crate) const SECTION: &str = "section";
/// A section of plates.
pub(crate) const PLATE: &str = "section of plates";
/// A beam integration.
pub(crate) const INTEGRATION: &str = "beam integration";
/// A geometric transformation.
pub(crate) const TRANSFORM: &str = "geometric transformation";
/// A time series.
pub(crate) const SERIES: &str = "time series";
/// A backbone.
pub(crate) const BACKBONE: &str = "backbone";
/// A limit curve.
pub(crate) const LIMIT_CURVE: &str = "limit curve";
/// A damping of elements.
pub(crate) const DAMPING: &str = "damping";

#[cfg(test)]
mod tests {
    use super::*;
    use hysteron_engine::model::Definitions;

    #[test]
    fn things_of_registries_have_their_words() {
        let d = Definitions::default();
        let kinds = [
            (MATERIAL, d.materials.kind),
            (ND_MATERIAL, d.nd_materials.kind),
            (FRICTION, d.frictions.kind),
            (SERIES, d.series.kind),
            (SECTION, d.sections.kind),
            (PLATE, d.plates.kind),
            (INTEGRATION, d.integrations.kind),
            (TRANSFORM, d.transforms.kind),
            (BACKBONE, d.backbones.kind),
            (LIMIT_CURVE, d.limit_curves.kind),
            (DAMPING, d.dampings.kind),
        ];
        assert!(kinds.iter().all(|(here, there)| here == there), "{kinds:?}");
    }
}
