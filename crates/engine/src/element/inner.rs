//! The element inside another one.

use super::roles::{Backbone, CriticalLoad, ElementParameters, LawRange, OwnDamping, Roles, SectionCapacity};
use super::{Element, OpenSeesTraits, OutsideRange, Overload, Snapshot, Softening};
use std::ops::Deref;
use std::sync::Arc;

/// An element inside another one, whose first state variables are those of this element.
///
/// Roles that read the history are those of the element inside, with its part of the history of the outer element.
#[derive(Clone, Debug)]
pub(super) struct Inner {
    element: Arc<dyn Element>,
    /// Number of its state variables.
    len: usize,
}

impl Deref for Inner {
    type Target = Arc<dyn Element>;

    fn deref(&self) -> &Arc<dyn Element> {
        &self.element
    }
}

impl Inner {
    pub(super) fn new(element: Arc<dyn Element>) -> Self {
        Self { len: element.state_len(), element }
    }

    /// Number of its state variables.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Takes over the history of a trial state, and the rest of the outer element as it stands.
    pub(super) fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let (own, rest) = committed.split_at_mut(self.len);
        self.element.commit(&trial[..self.len], own);
        rest.copy_from_slice(&trial[self.len..]);
    }

    /// The roles of an element around this one, which has its parameters and makes itself anew with them.
    ///
    /// Not forwarded are roles that would go past the wrapper: it is evaluated by itself, its basic forces are not those of
    /// the element inside, and it is called like any other element.
    pub(super) fn roles<'a>(&'a self, parameters: &'a dyn ElementParameters) -> Roles<'a> {
        let Roles {
            bearing,
            mass,
            inertance,
            loads,
            parameters: own_parameters,
            basic_rows,
            basic_forces: _,
            own_damping,
            overload,
            softening,
            stretch,
            exhausted,
            outside_range,
            euler_load,
            small_beam: _,
            kept_tangent: _,
            lockstep: _,
            renews_tangent,
            force_labels,
            opensees,
        } = self.element.roles();
        Roles {
            bearing,
            mass,
            inertance,
            loads,
            parameters: own_parameters.map(|_| parameters),
            basic_rows,
            basic_forces: None,
            own_damping: own_damping.map(|_| self as &dyn OwnDamping),
            overload: overload.map(|_| self as &dyn CriticalLoad),
            softening: softening.map(|_| self as &dyn Backbone),
            stretch,
            exhausted: exhausted.map(|_| self as &dyn SectionCapacity),
            outside_range: outside_range.map(|_| self as &dyn LawRange),
            euler_load,
            small_beam: None,
            kept_tangent: None,
            lockstep: None,
            renews_tangent,
            force_labels,
            opensees: OpenSeesTraits { calls: None, ..opensees },
        }
    }
}

impl OwnDamping for Inner {
    /// The wrapper has no form without the damping of the element inside.
    fn undamped(&self) -> Option<Arc<dyn Element>> {
        None
    }
    fn add_own_damping(&self, s: &Snapshot<'_>, factor: f64, force: &mut [f64]) {
        if let Some(damping) = self.element.roles().own_damping {
            damping.add_own_damping(&Snapshot { state: &s.state[..self.len], ..*s }, factor, force);
        }
    }
}

impl CriticalLoad for Inner {
    fn overload(&self, history: &[f64]) -> Option<Overload> {
        self.element.overload(&history[..self.len])
    }
}

impl Backbone for Inner {
    fn softening(&self, history: &[f64]) -> Option<Softening> {
        self.element.softening(&history[..self.len])
    }
}

impl SectionCapacity for Inner {
    fn exhausted(&self, history: &[f64]) -> Option<String> {
        self.element.exhausted(&history[..self.len])
    }
}

impl LawRange for Inner {
    fn outside_range(&self, history: &[f64]) -> Option<OutsideRange> {
        self.element.outside_range(&history[..self.len])
    }
}
