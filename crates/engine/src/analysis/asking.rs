//! How often elements are asked at a trial state, for those whose answer depends on it.

use super::engine::Kind;
use crate::assembly::Handler;

/// How often OpenSees updates its elements. It matters for elements that follow a scheme of OpenSees' which goes on with
/// every call ([`CallDependent`](crate::element::CallDependent)); the answers of all others are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Asking {
    /// Where the integrator looks for the reference load.
    pub prepare: Calls,
    /// At the begin of a step.
    pub begin: Calls,
    /// After each correction.
    pub update: Calls,
}

/// How often elements are asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Calls {
    /// Those with a node that is held or follows others, before all.
    pub constrained: u32,
    /// All of them.
    pub all: u32,
}

impl Calls {
    /// None of them.
    pub(super) const NONE: Self = Self { constrained: 0, all: 0 };
    /// All of them, once.
    pub(super) const ONCE: Self = Self { constrained: 0, all: 1 };
}

impl Asking {
    /// For the parts of an analysis: elements are updated once with the motion, except at the begin of a step of
    /// `LoadControl`, and those at constrained nodes once more where the Transformation handler applies the loads.
    pub(super) fn new(kind: Kind, integrator: &str, handler: Handler) -> Self {
        let loads = u32::from(handler == Handler::Transformation);
        let (motion, follows) = match (kind, integrator) {
            (Kind::Transient, _) => (1, 0),
            (Kind::Static, "LoadControl") => (0, 0),
            // The others apply the loads again with each correction, as they rule the load factor.
            (Kind::Static, _) => (1, loads),
        };
        Self {
            prepare: Calls { constrained: follows, all: 0 },
            begin: Calls { constrained: loads, all: motion },
            update: Calls { constrained: follows, all: 1 },
        }
    }
}
