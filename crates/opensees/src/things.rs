//! Kinds of things that commands define, in the words of messages.
//!
//! The engine declares those that its registries hold.

pub(crate) use hysteron_engine::model::kinds::{
    BACKBONE, DAMPING, FRICTION, INTEGRATION, LIMIT_CURVE, MATERIAL, ND_MATERIAL, PLATE, SECTION, SERIES, TRANSFORM,
};

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
