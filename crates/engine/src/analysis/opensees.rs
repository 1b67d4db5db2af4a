//! Number of updates of the elements, and motion of constrained nodes, under `--compat opensees`.
//!
//! It matters for elements whose force depends on the number of calls in a step
//! ([`CallDependent`](crate::element::CallDependent)); the forces of all others are the same after any number of calls.

mod transformed_nodes;

use super::engine::Kind;
use crate::assembly::Handler;
use crate::model::Model;

pub use transformed_nodes::Parts;
pub(super) use transformed_nodes::{Phase, TransformedNodes};

/// Number of updates that OpenSees makes of the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Updates {
    /// Of elements with a node that is held or follows others, before the updates of all.
    pub constrained: u32,
    /// Of all elements.
    pub all: u32,
}

/// Stage of a step between two evaluations of the elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// The integrator is prepared, and forms its reference load.
    Preparation,
    /// The step has begun.
    Begin,
    /// A correction has been added.
    Correction,
    /// The step is committed: integrators that solve at another time than the end of the step update once more.
    End,
    /// No update belongs to the evaluation.
    Outside,
}

/// An element that depends on the number of calls.
#[derive(Clone, Copy, Debug)]
pub(super) struct CountedElement {
    /// Place in the model.
    pub index: usize,
    /// It is the last element of its class in the model.
    pub last_of_class: bool,
    /// A node of it is held, or follows others.
    pub constrained: bool,
}

/// Elements that depend on the number of calls, and the number of calls in each stage of a step.
#[derive(Debug, Default)]
pub(super) struct UpdateCounts {
    /// The elements.
    pub elements: Vec<CountedElement>,
    /// Updates that the next evaluation makes.
    pub due: Updates,
    preparation: Updates,
    begin: Updates,
    correction: Updates,
}

impl UpdateCounts {
    /// For a model, in which these degrees of freedom are held or follow others.
    pub(super) fn new(model: &Model, constrained: &[bool]) -> Self {
        let elements = model.elements.iter().enumerate().filter(|(_, e)| e.element.opensees().calls.is_some());
        let elements = elements.map(|(index, e)| CountedElement {
            index,
            last_of_class: !model.elements[index + 1..].iter().any(|later| later.shared == e.shared),
            constrained: e.dofs.iter().any(|&d| constrained[d as usize]),
        });
        Self { elements: elements.collect(), ..Self::default() }
    }

    /// Set the numbers for the parts of an analysis. Elements are updated once with the motion, except at the begin of a step
    /// of `LoadControl`. Those at constrained nodes are updated once more where the Transformation handler applies the loads.
    pub(super) fn set_schedule(&mut self, kind: Kind, integrator: &str, handler: Handler) {
        let loads = u32::from(handler == Handler::Transformation);
        let (motion, follows) = match (kind, integrator) {
            (Kind::Transient, _) => (1, 0),
            (Kind::Static, "LoadControl") => (0, 0),
            // The others determine the load factor, and so apply the loads with each correction.
            (Kind::Static, _) => (1, loads),
        };
        self.preparation = Updates { constrained: follows, all: 0 };
        self.begin = Updates { constrained: loads, all: motion };
        self.correction = Updates { constrained: follows, all: 1 };
    }

    /// Set the updates of the next evaluation.
    pub(super) fn enter(&mut self, stage: Stage) {
        self.due = match stage {
            Stage::Preparation => self.preparation,
            Stage::Begin => self.begin,
            Stage::Correction => self.correction,
            Stage::End => Updates { constrained: 0, all: 1 },
            Stage::Outside => Updates::default(),
        };
    }
}
