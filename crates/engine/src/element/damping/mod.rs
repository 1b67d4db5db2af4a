//! Damping of single elements (`damping`): a force besides that of the element, from the history of its basic forces.

mod fit;
mod law;

use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, MatrixMask,
    Snapshot,
};
use crate::element::inner::Inner;
use crate::element::roles::{ElementParameters, OwnDamping, Roles};
use crate::parameter::{Changed, NewValue, ParameterError, exchange};
use crate::probe::Probe;
use std::fmt;
use std::sync::Arc;

pub use fit::{Filters, user_defined};
pub use law::{DampingLaw, DampingTime, ElementDamping};

/// Largest number of basic forces of an element that can be damped.
pub const MAX_BASIC_FORCES: usize = 72;

/// Basic forces of an element, in which a damping is worked out.
pub trait BasicForces: fmt::Debug {
    /// Number of basic forces, at most [`MAX_BASIC_FORCES`].
    fn len(&self) -> usize;

    /// Returns true if there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns true if OpenSees counts the damping in the resisting force that recorders and static reactions show.
    fn in_resisting_force(&self) -> bool {
        false
    }

    /// Writes the basic forces of a trial state.
    fn basic_forces(&self, disp: &[f64], state: &[f64], load: &[f64], out: &mut [f64]);

    /// Adds the global forces of some basic forces.
    fn add_global(&self, disp: &[f64], state: &[f64], q: &[f64], force: &mut [f64]);

    /// Adds the tangent of the basic forces, times a factor, to the tangent of the element, n x n by rows.
    fn scale_stiffness(&self, disp: &[f64], state: &[f64], factor: f64, tangent: &mut [f64]);
}

/// An element with a damping of its own.
#[derive(Clone, Debug)]
pub struct Damped {
    inner: Inner,
    damping: Arc<ElementDamping>,
    /// Number of basic forces.
    len: usize,
}

impl Damped {
    /// Makes the element from the one without damping, or with another one.
    ///
    /// # Errors
    /// The element has no basic forces that could be damped.
    pub fn new(inner: Arc<dyn Element>, damping: Arc<ElementDamping>) -> ElementResult<Self> {
        let inner = inner.undamped().unwrap_or(inner);
        let Some(basic) = inner.roles().basic_forces else {
            return Err(ElementError(format!("{} takes no damping of its own", inner.class().name).into()));
        };
        let len = basic.len();
        Ok(Self { damping, len, inner: Inner::new(inner) })
    }

    fn basic(&self) -> &dyn BasicForces {
        Element::roles(&**self.inner).basic_forces.unwrap_or(&NoForces)
    }
}

/// Basic forces of an element without any.
#[derive(Debug)]
struct NoForces;

impl BasicForces for NoForces {
    fn len(&self) -> usize {
        0
    }
    fn basic_forces(&self, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
    fn add_global(&self, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
    fn scale_stiffness(&self, _: &[f64], _: &[f64], _: f64, _: &mut [f64]) {}
}

const GLOBAL: u32 = 900;
const BASIC: u32 = 901;

crate::watches_columns!(Damped => |s| at [(0..s.inner.len(), &**s.inner)]);

#[deny(clippy::missing_trait_methods)]
impl Element for Damped {
    fn class(&self) -> Class {
        self.inner.class()
    }
    fn dofs(&self) -> usize {
        self.inner.dofs()
    }
    fn state_len(&self) -> usize {
        self.inner.len() + self.damping.state_len(self.len)
    }
    fn init(&self, state: &mut [f64]) {
        let (own, filters) = state.split_at_mut(self.inner.len());
        self.inner.init(own);
        filters.fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, elapses: true, ..self.inner.traits() }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, mut out: ElementOutput<'_>) -> ElementResult {
        let (mut own, mut filters) = h.split_at(self.inner.len());
        let inner = ElementOutput {
            force: &mut *out.force,
            tangent: out.tangent.as_deref_mut(),
            damping: out.damping,
            part: MatrixMask::ALL,
        };
        self.inner.respond(motion, &mut own, inner)?;
        let (basic, mut q) = (self.basic(), [0.0; MAX_BASIC_FORCES]);
        let q = &mut q[..self.len];
        basic.basic_forces(motion.disp, own.trial, motion.load, q);
        let at = DampingTime { time: motion.time, dt: motion.dt, dynamic: motion.dynamic };
        let factor = self.damping.update(q, at, &mut filters);
        basic.add_global(motion.disp, own.trial, self.damping.forces(self.len, filters.trial), out.force);
        if let Some(tangent) = out.tangent.filter(|_| factor != 0.0) {
            basic.scale_stiffness(motion.disp, own.trial, factor, tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.inner.initial_tangent(tangent);
    }
    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        self.inner.commit(trial, committed);
    }
    fn roles(&self) -> Roles<'_> {
        // The element is evaluated like any other, whatever the number of calls.
        Roles { parameters: Some(self), own_damping: Some(self), ..self.inner.roles(self) }
    }

    fn probe_names(&self) -> Vec<&'static str> {
        let mut names = self.inner.probe_names();
        names.extend(["globalDampingForce", "basicDampingForce"]);
        names
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["globalDampingForce" | "globalDampingForces"] => Some(Probe::new(GLOBAL, self.inner.force_labels())),
            ["basicDampingForce" | "basicDampingForces"] => {
                Some(Probe::new(BASIC, (1..=self.len).map(|i| format!("qd{i}"))))
            }
            words => self.inner.probe(words),
        }
    }
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let (state, filters) = s.state.split_at(self.inner.len());
        let forces = self.damping.forces(self.len, filters);
        match path {
            [GLOBAL] => {
                out.fill(0.0);
                self.basic().add_global(s.disp, state, forces, out);
            }
            [BASIC] => out.copy_from_slice(forces),
            _ => self.inner.read(path, &Snapshot { state, ..*s }, out),
        }
    }
}

impl ElementParameters for Damped {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let mut new = self.clone();
        let old = match words {
            ["damping", name] => {
                let damping = Arc::make_mut(&mut new.damping);
                match (&mut damping.law, *name) {
                    (DampingLaw::Filters { loss: Some(loss), .. }, "dampingRatio") => {
                        0.5 * exchange(loss, value.times(2.0))
                    }
                    (DampingLaw::SecantStiffness { beta }, "dampingFactor") => exchange(beta, value),
                    _ => return Err(ParameterError::Unknown),
                }
            }
            _ => {
                let (inner, old) = self.inner.with_parameter(words, value)?;
                new.inner = Inner::new(inner);
                old
            }
        };
        Ok((Arc::new(new), old))
    }
}

impl OwnDamping for Damped {
    fn undamped(&self) -> Option<Arc<dyn Element>> {
        Some(Arc::clone(&self.inner))
    }
    fn add_own_damping(&self, s: &Snapshot<'_>, factor: f64, force: &mut [f64]) {
        let basic = self.basic();
        if basic.in_resisting_force() {
            return;
        }
        let (own, filters) = s.state.split_at(self.inner.len());
        let mut q = [0.0; MAX_BASIC_FORCES];
        q.iter_mut().zip(self.damping.forces(self.len, filters)).for_each(|(q, f)| *q = factor * f);
        basic.add_global(s.disp, own, &q[..self.len], force);
    }
}
