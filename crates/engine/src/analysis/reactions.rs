//! Reactions of the supports.

use super::engine::Engine;
use super::failure::Failure;
use super::state::State;
use crate::element::Snapshot;
use crate::model::ElementId;

/// Forces that count in a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionKind {
    /// Resisting forces of the elements less the loads; and, as in OpenSees, mass-proportional damping of the nodes.
    Static,
    /// Inertia and damping forces too.
    Dynamic,
    /// Rayleigh damping forces only.
    Rayleigh,
}

impl Engine {
    /// Reactions of all degrees of freedom in the committed state, into `out` (its length becomes that of the
    /// degrees of freedom): what the rest of the world exerts on each node.
    ///
    /// # Errors
    /// Constraints that make no sense.
    pub fn reactions(&mut self, kind: ReactionKind, out: &mut Vec<f64>) -> Result<(), Failure> {
        let handler = self.handler();
        self.prepare(handler)?;
        // The state is read while the work vectors are written.
        let mut words = std::mem::take(&mut self.results.reaction_words);
        words.clone_from(&self.state().element_load);
        let result = self.sum_reactions(kind, &mut words, out);
        self.results.reaction_words = words;
        result
    }

    /// Keep reactions that have been worked out, as OpenSees keeps them at its nodes.
    pub fn keep_reactions(&mut self, reactions: &[f64]) {
        self.results.kept_reactions.clear();
        self.results.kept_reactions.extend_from_slice(reactions);
    }

    /// The reactions kept last at all degrees of freedom; zero where there are none.
    pub fn kept_reactions(&self) -> Vec<f64> {
        let mut all = self.results.kept_reactions.clone();
        all.resize(self.model().dofs(), 0.0);
        all
    }

    /// Loads on all degrees of freedom at the committed time, into `out`; less inertia and mass-proportional damping
    /// of the nodes if `inertia`.
    ///
    /// # Errors
    /// Constraints that make no sense.
    pub fn unbalanced(&mut self, inertia: bool, out: &mut Vec<f64>) -> Result<(), Failure> {
        self.reactions(ReactionKind::Static, out)?;
        let (_, state, work) = self.parts();
        let Some(work) = work else { return Ok(()) };
        work.loads.of_nodes(&mut work.full);
        if inertia {
            work.subtract_nodal_inertia(state, 1.0);
        }
        out.clone_from(&work.full);
        Ok(())
    }

    /// Force of an element in the committed state with its damping and inertia, added to `out`.
    ///
    /// # Errors
    /// Constraints that make no sense.
    pub fn dynamic_element_force(&mut self, id: ElementId, out: &mut Vec<f64>) -> Result<(), Failure> {
        let handler = self.handler();
        self.prepare(handler)?;
        let start = out.len();
        self.element_force(id, out);
        let (model, state, work) = self.parts();
        if let Some(work) = work {
            let more = work.dynamic_force(model, id, state);
            // Where OpenSees counts the inertia of the ground twice, it reports it once beside the resisting force.
            let times = model.elements[id.0].element.opensees().ground_inertia.unwrap_or(1.0) as usize;
            (1..times).for_each(|_| work.loads.report(id, &mut out[start..]));
            out[start..].iter_mut().zip(more).for_each(|(f, d)| *f += d);
        }
        Ok(())
    }

    fn sum_reactions(&mut self, kind: ReactionKind, words: &mut [f64], out: &mut Vec<f64>) -> Result<(), Failure> {
        let (model, state, work) = self.parts();
        let Some(work) = work else { return Ok(()) };
        if kind != ReactionKind::Rayleigh {
            work.loads.apply(model, state.time, words).map_err(|(element, message)| {
                Failure::new(super::failure::Cause::Element { element, message }, state.time, -3)
            })?;
            // The trial state does not have these loads on elements.
            if *words != state.element_load {
                work.loads.invalidate();
            }
        }
        work.sum_forces(model, state, kind);
        out.clear();
        out.extend(work.full.iter().map(|f| -f));
        Ok(())
    }
}

impl super::workspace::Workspace {
    /// Take the damping of single elements off their forces again.
    fn add_own_damping(&mut self, model: &crate::model::Model, state: &State) {
        for e in &model.elements {
            let Some(damping) = e.element.roles().own_damping else { continue };
            let disp: Vec<f64> = e.dofs.iter().map(|&d| state.disp[d as usize]).collect();
            let snapshot = Snapshot {
                disp: &disp,
                state: &state.history[e.state.clone()],
                force: &state.force[e.force.clone()],
                load: &state.element_load[e.load.clone()],
            };
            let mut force = vec![0.0; disp.len()];
            damping.add_own_damping(&snapshot, 1.0, &mut force);
            e.dofs.iter().zip(&force).for_each(|(&d, f)| self.full[d as usize] += f);
        }
    }

    /// Loads less forces of elements and nodes, into `full`.
    fn sum_forces(&mut self, model: &crate::model::Model, state: &State, kind: ReactionKind) {
        match kind {
            ReactionKind::Static => {
                self.loads.of_model(&mut self.full);
                self.subtract_elements(model, state, false);
                self.add_own_damping(model, state);
                self.subtract_nodal_damping(state);
            }
            ReactionKind::Dynamic => {
                self.full.copy_from_slice(&self.loads.nodal);
                self.subtract_elements(model, state, true);
                self.subtract_nodal_inertia(state, 1.0);
            }
            ReactionKind::Rayleigh => {
                self.full.fill(0.0);
                self.subtract_damping(model, state);
                self.subtract_nodal_damping(state);
            }
        }
    }
}
