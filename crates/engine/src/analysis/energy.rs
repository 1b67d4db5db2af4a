//! The balance of energy of a model over its steps.
//!
//! Between two committed states a force does the work ½ (Fₙ + Fₙ₊₁) · (uₙ₊₁ − uₙ). With these works the average
//! acceleration of Newmark keeps the balance of any model whose forces are in equilibrium at both states (Hughes, *The
//! Finite Element Method*, 9.1, for linear ones). What is missing is a force out of balance, or numerical dissipation of
//! another integrator. The error of the steps themselves is not seen: that is what `refine` is for.
//!
//! Motions are relative to the ground under a uniform excitation, and so are the energies (Uang and Bertero 1990).

use super::engine::{Engine, Kind};
use super::failure::Failure;
use super::ground_inertia::mass_times;
use super::reactions::ReactionKind;
use crate::model::Model;
use crate::numeric::dot;

/// Energies of the elements of a class, in the unit force times length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClassEnergy {
    /// Work done on the elements, stored and dissipated.
    pub work: f64,
    /// Energy lost by their Rayleigh damping, of stiffness and of own mass.
    pub damping: f64,
}

/// Energies since the first step, in the unit force times length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Energies {
    /// Domain time.
    pub time: f64,
    /// Work of loads, of inertia forces of the ground, and of moving supports.
    pub input: f64,
    /// Kinetic energy of the motion relative to the ground.
    pub kinetic: f64,
    /// Energies by class of element, in the order in which the classes came up.
    pub classes: Vec<(&'static str, ClassEnergy)>,
    /// Energy lost by damping in proportion to nodal masses.
    pub nodal_damping: f64,
    /// Energy lost by damping of modes.
    pub modal_damping: f64,
}

impl Energies {
    /// Work done on all elements.
    pub fn work(&self) -> f64 {
        self.classes.iter().map(|(_, c)| c.work).sum()
    }

    /// Energy lost by all damping beside the forces of the elements.
    pub fn damping(&self) -> f64 {
        self.nodal_damping + self.modal_damping + self.classes.iter().map(|(_, c)| c.damping).sum::<f64>()
    }

    /// Number of a class, which is added where it is new.
    fn class(&mut self, name: &'static str) -> usize {
        self.classes.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
            self.classes.push((name, ClassEnergy::default()));
            self.classes.len() - 1
        })
    }

    /// Energy that has come in and is found nowhere.
    pub fn error(&self) -> f64 {
        self.input - self.kinetic - self.damping() - self.work()
    }
}

/// Forces and motion of one committed state.
#[derive(Clone, Debug, Default)]
struct Forces {
    disp: Vec<f64>,
    vel: Vec<f64>,
    kinetic: f64,
    /// On all degrees of freedom: loads, and reactions where the motion is imposed.
    external: Vec<f64>,
    nodal_damping: Vec<f64>,
    modal_damping: Vec<f64>,
    /// Of all elements, laid out as `State::force`.
    resisting: Vec<f64>,
    /// Of all elements, likewise.
    damping: Vec<f64>,
}

/// Work of a force between two states, over the displacements `du`.
fn work(before: &[f64], after: &[f64], du: impl Iterator<Item = f64>) -> f64 {
    before.iter().zip(after).zip(du).map(|((a, b), du)| 0.5 * (a + b) * du).sum()
}

/// Sum of the energies over the steps of an engine.
#[derive(Clone, Debug, Default)]
pub struct EnergyBalance {
    now: Energies,
    last: Forces,
    buffer: Forces,
    /// Revision of the model to which the forces belong.
    revision: Option<u64>,
    /// Degrees of freedom with an imposed motion.
    imposed: Vec<usize>,
    /// Number of each element's class in `Energies::classes`.
    class_of: Vec<usize>,
    reactions: Vec<f64>,
    /// Largest error so far over the largest energy so far.
    largest_error: f64,
    largest: f64,
}

impl EnergyBalance {
    /// Energies up to the last step.
    pub fn energies(&self) -> &Energies {
        &self.now
    }

    /// Largest error of the balance over all steps, as a part of the largest energy that was in the model.
    pub fn relative_error(&self) -> f64 {
        if self.largest > 0.0 { self.largest_error / self.largest } else { 0.0 }
    }

    /// An analysis starts from the committed state. Velocities that a script has given count as input.
    ///
    /// # Errors
    /// Constraints that make no sense.
    pub fn start(&mut self, engine: &mut Engine) -> Result<(), Failure> {
        let state = engine.state();
        let same_state = self.last.disp == state.disp && self.last.vel == state.vel;
        if same_state && self.revision == Some(engine.model().revision()) {
            return Ok(());
        }
        self.revision = Some(engine.model().revision());
        self.imposed = imposed_dofs(engine.model());
        self.class_of = engine.model().elements.iter().map(|e| self.now.class(e.element.class().name)).collect();
        engine.forces_of_state(&self.imposed, &mut self.reactions, &mut self.last)?;
        self.now.input += self.last.kinetic - self.now.kinetic;
        self.now.kinetic = self.last.kinetic;
        Ok(())
    }

    /// Add the works of the step that has led to the committed state.
    ///
    /// # Errors
    /// Constraints that make no sense.
    pub fn step(&mut self, engine: &mut Engine) -> Result<(), Failure> {
        if self.revision != Some(engine.model().revision()) {
            return self.start(engine);
        }
        let mut next = std::mem::take(&mut self.buffer);
        engine.forces_of_state(&self.imposed, &mut self.reactions, &mut next)?;
        self.add(engine.model(), &next);
        self.now.time = engine.state().time;
        self.buffer = std::mem::replace(&mut self.last, next);
        let total = self.now.input.abs().max(self.now.work().abs()).max(self.now.kinetic);
        self.largest = self.largest.max(total);
        self.largest_error = self.largest_error.max(self.now.error().abs());
        Ok(())
    }

    fn add(&mut self, model: &Model, next: &Forces) {
        let (last, now) = (&self.last, &mut self.now);
        let du = |d: usize| next.disp[d] - last.disp[d];
        let all = || (0..next.disp.len()).map(du);
        now.input += work(&last.external, &next.external, all());
        now.nodal_damping += work(&last.nodal_damping, &next.nodal_damping, all());
        now.modal_damping += work(&last.modal_damping, &next.modal_damping, all());
        now.kinetic = next.kinetic;
        for (e, class) in model.elements.iter().zip(&self.class_of) {
            let f = e.force.clone();
            let moved = || e.dofs.iter().map(|&d| du(d as usize));
            let class = &mut now.classes[*class].1;
            class.work += work(&last.resisting[f.clone()], &next.resisting[f.clone()], moved());
            class.damping += work(&last.damping[f.clone()], &next.damping[f], moved());
        }
    }
}

/// Degrees of freedom whose motion a pattern imposes.
fn imposed_dofs(model: &Model) -> Vec<usize> {
    let of_patterns = model.patterns.values().flat_map(|p| &p.motions);
    let mut dofs: Vec<usize> = of_patterns.map(|m| model.nodes[m.node.0].dofs().start + m.dof).collect();
    dofs.sort_unstable();
    dofs.dedup();
    dofs
}

impl Engine {
    /// Forces of the committed state.
    fn forces_of_state(
        &mut self,
        imposed: &[usize],
        reactions: &mut Vec<f64>,
        out: &mut Forces,
    ) -> Result<(), Failure> {
        let transient = self.setup().is_some_and(|s| s.kind == Kind::Transient);
        let kind = if transient { ReactionKind::Dynamic } else { ReactionKind::Static };
        self.reactions(kind, reactions)?;
        let (model, state, work) = self.parts();
        let Some(work) = work else { return Ok(()) };
        out.disp.clone_from(&state.disp);
        out.vel.clone_from(&state.vel);
        out.resisting.clone_from(&state.force);
        out.external.resize(state.disp.len(), 0.0);
        work.loads.of_model(&mut out.external);
        imposed.iter().for_each(|&d| out.external[d] += reactions[d]);
        for (buffer, length) in [
            (&mut out.nodal_damping, state.disp.len()),
            (&mut out.modal_damping, state.disp.len()),
            (&mut out.damping, state.force.len()),
        ] {
            buffer.clear();
            buffer.resize(length, 0.0);
        }
        out.kinetic = 0.0;
        if transient {
            out.kinetic = 0.5 * dot(&state.vel, &mass_times(model, &state.vel, false));
            work.full.fill(0.0);
            work.subtract_nodal_damping(state);
            out.nodal_damping.iter_mut().zip(&work.full).for_each(|(o, f)| *o = -f);
            work.full.fill(0.0);
            work.subtract_modal_damping(state);
            out.modal_damping.iter_mut().zip(&work.full).for_each(|(o, f)| *o = -f);
            work.damping_forces(model, state, &mut out.damping);
        }
        Ok(())
    }
}
