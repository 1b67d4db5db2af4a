//! Kinds of things that commands define, in the words of messages.
//!
//! The engine declares those that its registries hold.

pub use hysteron_engine::model::kinds::{
    BACKBONE, DAMPING, FRICTION, INTEGRATION, LIMIT_CURVE, MATERIAL, ND_MATERIAL, PLATE, SECTION, SERIES, TRANSFORM,
};

/// A node.
pub const NODE: &str = "node";
/// An element.
pub const ELEMENT: &str = "element";
/// A region.
pub const REGION: &str = "region";
/// A load pattern.
pub const PATTERN: &str = "load pattern";
/// A ground motion of a pattern MultipleSupport.
pub const GROUND_MOTION: &str = "ground motion";
/// A parameter.
pub const PARAMETER: &str = "parameter";
/// A recorder.
pub const RECORDER: &str = "recorder";
/// A mode that `eigen` finds, by its number; without one, the modes.
pub const MODE: &str = "mode";
/// The analysis.
pub const ANALYSIS: &str = "analysis";
/// The model.
pub const MODEL: &str = "model";
/// A degree of freedom.
pub const DOF: &str = "degree of freedom";
