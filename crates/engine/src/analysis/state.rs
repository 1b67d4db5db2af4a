//! Everything that changes from step to step, as flat data.

use crate::model::{ElementEntry, Model};

/// The motion of a model and the history of its elements at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Domain time (the load factor of static analyses).
    pub time: f64,
    /// Displacements of all degrees of freedom, node after node.
    pub disp: Vec<f64>,
    /// Velocities, likewise.
    pub vel: Vec<f64>,
    /// Accelerations, likewise; relative to the ground under a uniform excitation.
    pub accel: Vec<f64>,
    /// State variables of all elements.
    pub history: Vec<f64>,
    /// Resisting forces of all elements.
    pub force: Vec<f64>,
    /// Load variables of all elements.
    pub element_load: Vec<f64>,
    /// Forces of the constraints under the Lagrange handler.
    pub multipliers: Vec<f64>,
    /// State variables that elements of a class share under `--compat opensees`. As static members of a class in OpenSees, they
    /// keep the values of a step that has failed.
    pub shared: Vec<f64>,
}

/// State at the begin of the last step. The tangent at its end belongs to the step: evaluated from the end, a sliding
/// bearing may as well go back.
#[derive(Debug, Default)]
pub(super) struct StepStart {
    history: Vec<f64>,
    /// Time of the step, zero where the domain time is no time.
    duration: f64,
    holds: bool,
}

impl StepStart {
    /// A step is going to be committed: keep the history of the committed state, which is going to be written over.
    pub(super) fn keep(&mut self, committed: &mut State, duration: f64) {
        if self.history.len() == committed.history.len() {
            std::mem::swap(&mut self.history, &mut committed.history);
        } else {
            self.history.clone_from(&committed.history);
        }
        (self.duration, self.holds) = (duration, true);
    }

    /// The committed state is another one than a step has come to.
    pub(super) fn forget(&mut self) {
        self.holds = false;
    }

    /// A state from which the elements have the forces of the end of the last step at the committed motion. `None` if the
    /// committed state is not that end.
    pub(super) fn state(&self, committed: &State) -> Option<State> {
        let holds = self.holds && self.history.len() == committed.history.len();
        holds.then(|| State {
            history: self.history.clone(),
            time: committed.time - self.duration,
            ..committed.clone()
        })
    }
}

impl State {
    /// Take over another state of the same model without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.time = other.time;
        self.disp.copy_from_slice(&other.disp);
        self.vel.copy_from_slice(&other.vel);
        self.accel.copy_from_slice(&other.accel);
        self.history.copy_from_slice(&other.history);
        self.force.copy_from_slice(&other.force);
        self.element_load.copy_from_slice(&other.element_load);
        self.multipliers.copy_from_slice(&other.multipliers);
        self.shared.copy_from_slice(&other.shared);
    }

    /// Take over the state before a step that has failed, all but the shared state variables.
    pub(super) fn revert_to(&mut self, start: &Self) {
        let shared = std::mem::take(&mut self.shared);
        self.clone_from(start);
        self.shared = shared;
    }

    /// Take over a trial state: as [`State::copy_from`], but for unused state variables, and for the rates of a model that
    /// stands still.
    #[inline]
    pub fn commit(&mut self, trial: &Self, model: &Model, still: bool) {
        self.time = trial.time;
        self.disp.copy_from_slice(&trial.disp);
        if !still {
            self.vel.copy_from_slice(&trial.vel);
            self.accel.copy_from_slice(&trial.accel);
        }
        for e in &model.elements {
            e.element.commit(&trial.history[e.state.clone()], &mut self.history[e.state.clone()]);
        }
        self.force.copy_from_slice(&trial.force);
        // Most models have none of them, and to copy nothing takes time too.
        for (own, other) in [
            (&mut self.element_load, &trial.element_load),
            (&mut self.multipliers, &trial.multipliers),
            (&mut self.shared, &trial.shared),
        ] {
            if !other.is_empty() {
                own.copy_from_slice(other);
            }
        }
        if model.elements.iter().any(|e| !e.limit_curves.is_empty()) {
            self.watch(model);
        }
    }

    /// Returns true if the state has a place for all nodes and elements, and no more.
    fn has_room(&self, model: &Model) -> bool {
        self.disp.len() == model.dofs()
            && self.force.len() == model.force_len()
            && self.history.len() == model.state_len()
            && self.element_load.len() == model.load_len()
            && self.shared.len() == model.shared_len()
    }

    /// Make room for nodes and elements that have been added behind the others; new elements are virgin.
    pub fn grow(&mut self, model: &Model) {
        // Most changes of a model add neither.
        if self.has_room(model) {
            return;
        }
        for v in [&mut self.disp, &mut self.vel, &mut self.accel] {
            v.resize(model.dofs(), 0.0);
        }
        self.shared.resize(model.shared_len(), 0.0);
        let known = self.history.len();
        let known_force = self.force.len();
        self.history.resize(model.state_len(), 0.0);
        self.force.resize(model.force_len(), 0.0);
        self.element_load.resize(model.load_len(), 0.0);
        // An element without history has a force all the same.
        let is_new = |e: &&ElementEntry| e.state.start >= known && e.force.start >= known_force;
        for e in model.elements.iter().rev().take_while(is_new) {
            e.element.init(&mut self.history[e.state.clone()]);
        }
    }

    /// The state of a model after nodes or elements have been removed: each thing keeps what it had.
    pub fn rearranged(&self, before: &Model, after: &Model) -> Self {
        let mut next = Self { time: self.time, ..Self::default() };
        next.grow(after);
        for node in &after.nodes {
            if let Some(old) = before.node(node.tag).map(|id| &before.nodes[id.0]).filter(|o| o.ndf == node.ndf) {
                for (to, from) in
                    [(&mut next.disp, &self.disp), (&mut next.vel, &self.vel), (&mut next.accel, &self.accel)]
                {
                    to[node.dofs()].copy_from_slice(&from[old.dofs()]);
                }
            }
        }
        for e in &after.elements {
            if let Some(old) = before.element(e.tag).map(|id| &before.elements[id.0]) {
                // An element inside a new wrapper keeps its history: its state variables come first.
                let n = e.state.len().min(old.state.len());
                let from = &self.history[old.state.clone()];
                next.history[e.state.clone()][..n].copy_from_slice(&from[..n]);
                next.force[e.force.clone()].copy_from_slice(&self.force[old.force.clone()]);
                next.element_load[e.load.clone()].copy_from_slice(&self.element_load[old.load.clone()]);
                if e.shared.len() == old.shared.len() {
                    next.shared[e.shared.clone()].copy_from_slice(&self.shared[old.shared.clone()]);
                }
            }
        }
        next
    }
}
