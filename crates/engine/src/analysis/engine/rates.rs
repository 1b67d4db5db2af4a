//! Velocities that a static analysis imposes, and elements that depend on velocities.

use super::{Engine, Kind};
use crate::analysis::state::State;
use crate::model::{Model, Tag};
use std::collections::BTreeMap;

/// Elements whose forces depend on velocities, and whether they have had one in a step.
#[derive(Debug, Default)]
pub(super) struct Speeds {
    /// By tag and class, over all models of a script.
    seen: BTreeMap<(Tag, &'static str), bool>,
    /// Elements of the model that have had none so far.
    pending: Vec<usize>,
}

impl Speeds {
    /// Begin with a model that is new or has changed.
    pub(super) fn prepare(&mut self, model: &Model) {
        let elements = model.elements.iter().enumerate();
        let pending = elements.filter(|(_, e)| {
            let key = (e.tag, e.element.class().name);
            e.element.traits().viscous && !self.seen.get(&key).is_some_and(|seen| *seen)
        });
        self.pending = pending.map(|(i, _)| i).collect();
    }

    /// A step has been made, in which elements have had a velocity.
    pub(super) fn note(&mut self, model: &Model, has_velocity: impl Fn(usize) -> bool) {
        let seen = &mut self.seen;
        self.pending.retain(|&i| {
            let (e, moves) = (&model.elements[i], has_velocity(i));
            *seen.entry((e.tag, e.element.class().name)).or_insert(false) |= moves;
            !moves
        });
    }

    /// A step has been made to a state.
    pub(super) fn note_step(&mut self, model: &Model, state: &State) {
        if !self.pending.is_empty() {
            self.note(model, |i| model.elements[i].dofs.iter().any(|&d| state.vel[d as usize] != 0.0));
        }
    }
}

impl Engine {
    /// Class and tag of the elements whose forces depend on velocities and that had none in any step of any analysis.
    pub fn speedless(&self) -> impl Iterator<Item = (&'static str, Tag)> {
        self.speeds.seen.iter().filter(|(_, seen)| !**seen).map(|((tag, class), _)| (*class, *tag))
    }

    /// Let the degrees of freedom rest that a static analysis moved and a pattern moves no longer: a release from an imposed
    /// displacement starts at rest, however fast the displacement came.
    pub(super) fn stop_led(&mut self, still_led: &[bool]) {
        for (dof, led) in self.led.iter_mut().enumerate().filter(|(_, led)| **led) {
            *led = still_led.get(dof).is_some_and(|led| *led);
            if !*led {
                (self.committed.vel[dof], self.committed.accel[dof]) = (0.0, 0.0);
            }
        }
    }

    /// Note the degrees of freedom whose velocity the static analysis imposes that has led to a state.
    pub(in crate::analysis) fn note_led(&mut self) {
        let is_static = self.setup.as_ref().is_some_and(|s| s.kind == Kind::Static);
        self.led.clear();
        if is_static && let Ok(work) = self.prepare(self.handler()) {
            self.led = work.led.clone();
        }
    }

    /// Forget what is remembered of earlier steps, so that the next one depends on the committed state alone.
    pub fn forget_work(&mut self) {
        self.step_start.forget();
        self.setup.iter_mut().for_each(|s| s.algorithm.forget());
        if let Some((_, _, work)) = &mut self.prepared {
            work.forget();
        }
        self.fresh = true;
    }
}
