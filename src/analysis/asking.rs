//! How often elements are asked at a trial state, for those whose answer depends on it.

use super::engine::Kind;
use crate::assembly::Handler;

/// How often OpenSees updates its elements. It matters for elements that follow a scheme of OpenSees' which goes on with
/// every call ([`counts_calls`](crate::element::Element::counts_calls)); the answers of all others are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Asking {
    /// At the begin of a step.
    pub begin: u32,
    /// After each correction.
    pub update: u32,
}

impl Asking {
    /// For the parts of an analysis: elements are updated once with the motion, except at the begin of a step of
    /// `LoadControl`, and once more where the Transformation handler applies the loads.
    pub(super) fn new(kind: Kind, integrator: &str, handler: Handler) -> Self {
        let loads = u32::from(handler == Handler::Transformation);
        let (motion, follows) = match (kind, integrator) {
            (Kind::Transient, _) => (1, 0),
            (Kind::Static, "LoadControl") => (0, 0),
            // The others apply the loads again with each correction, as they rule the load factor.
            (Kind::Static, _) => (1, loads),
        };
        Self { begin: loads + motion, update: 1 + follows }
    }
}
