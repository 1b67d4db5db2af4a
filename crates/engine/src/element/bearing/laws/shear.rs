//! Shear laws of bearings: the trait, and the common state variables.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use crate::element::bearing::elements::shear_bearing::end_masses;
use crate::element::{Class, ElementResult, Mass};
use crate::numeric::real::Real;
use crate::numeric::wide::{WIDTH, Wide};
use crate::state_struct::StateStruct;
use std::fmt;

/// State variables of a law with `S` shear directions, which recorders read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shear<const S: usize, T = f64> {
    /// Displacement.
    pub u: [T; S],
    /// Internal variable of the law: hysteretic parameter, plastic displacement.
    pub internal: [T; S],
    /// Force.
    pub q: [T; S],
    /// Consistent stiffness.
    pub k: [[T; S]; S],
}

impl<const S: usize> Default for Shear<S> {
    fn default() -> Self {
        Self { u: [0.0; S], internal: [0.0; S], q: [0.0; S], k: [[0.0; S]; S] }
    }
}

impl<const S: usize, T: Real> Shear<S, T> {
    /// Of the state variables of one bearing, or of several side by side.
    #[inline(always)]
    pub fn of_words(state: &[T]) -> Self {
        let state = &state[..Shear::<S>::LEN];
        let vector = |at: usize| std::array::from_fn(|i| state[at + i]);
        Self { u: vector(0), internal: vector(S), q: vector(2 * S), k: std::array::from_fn(|i| vector((3 + i) * S)) }
    }

    /// Write them.
    #[inline(always)]
    pub fn to_words(&self, state: &mut [T]) {
        let rows = [&self.u, &self.internal, &self.q].into_iter().chain(&self.k);
        for (to, from) in state[..Shear::<S>::LEN].chunks_exact_mut(S).zip(rows) {
            to.copy_from_slice(from);
        }
    }
}

impl<const S: usize> StateStruct for Shear<S> {
    const LEN: usize = 3 * S + S * S;

    #[inline]
    fn read(state: &[f64]) -> Self {
        Self::of_words(state)
    }

    #[inline]
    fn write(&self, state: &mut [f64]) {
        self.to_words(state);
    }
}

/// A shear law with `S` coupled directions: 1 in the plane, 2 in space.
pub trait ShearLaw<const S: usize>: Clone + fmt::Debug + Send + Sync {
    /// OpenSees' class names in the plane and in space.
    const CLASS: [Class; 2];
    /// True if recorders show the internal variable as the hysteretic parameter.
    const HYSTERETIC: bool;
    /// True if OpenSees subtracts the inertia of the bearing's mass under a uniform ground motion from the reported
    /// force.
    const REPORTS_INERTIA: bool = false;
    /// True if OpenSees updates the committed tangent of Rayleigh damping at the end of every step.
    const RENEWS_DAMPING: bool = true;

    /// Damping coefficient of a dashpot in parallel, in each direction.
    fn dashpot(&self) -> f64 {
        0.0
    }

    /// Virgin state, with the initial stiffness.
    fn virgin(&self) -> Shear<S>;

    /// Trial state at a displacement, from the committed state.
    ///
    /// # Errors
    /// The equation of the law has no solution for the step.
    fn step(&self, committed: &Shear<S>, u: [f64; S]) -> ElementResult<Shear<S>>;

    /// Copies into the trial state the variables of the last trial that OpenSees does not reset; used only to follow
    /// OpenSees.
    fn leave_trace(&self, _committed: &Shear<S>, _last: &Shear<S>, _next: &mut Shear<S>) {}

    /// The law of each of several bearings, side by side; `None` where it is not made for it.
    fn lockstep(_all: &[&Self; WIDTH]) -> Option<impl ShearLockstep<S> + 'static> {
        None::<NoLockstep>
    }

    /// Deformations of one direction from which the stiffness and the force of the backbone are negative; `None` where
    /// they are not.
    fn backbone_ends(&self) -> Option<(f64, f64)> {
        None
    }

    /// Mass of the bearing: half at each end.
    fn masses(&self, mass: f64) -> Mass {
        end_masses(mass, 3 * S, S + 1)
    }
}

/// Relative difference of displacements that is round-off.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// A shear law of several bearings side by side.
pub trait ShearLockstep<const S: usize>: fmt::Debug {
    /// Trial states at displacements, as [`ShearLaw::step`] has them one by one. A force is no number where there is none.
    /// The method must be inlined.
    fn step(&self, committed: &Shear<S, Wide>, u: [Wide; S]) -> Shear<S, Wide>;
}

/// The lack of such a law.
#[derive(Debug)]
pub(super) enum NoLockstep {}

impl<const S: usize> ShearLockstep<S> for NoLockstep {
    fn step(&self, _: &Shear<S, Wide>, _: [Wide; S]) -> Shear<S, Wide> {
        match *self {}
    }
}

/// Returns true if the increment is round-off. The tangent is then that of continued loading, as at the end of the last
/// step. Equilibrium corrections and rotations of axes by round-off are no unloading.
#[inline]
pub(in crate::element::bearing) fn at_rest<const S: usize>(u: &[f64; S], committed: &[f64; S]) -> bool {
    is_at_rest(u, committed) == 1.0
}

/// The same of one bearing or of several side by side: 1 where it is true, else 0.
#[inline(always)]
pub(in crate::element::bearing) fn is_at_rest<T: Real, const S: usize>(u: &[T; S], committed: &[T; S]) -> T {
    let (mut size, mut rests) = (T::ZERO, T::ONE);
    for u in u {
        size = u.abs().larger(size);
    }
    for i in 0..S {
        rests = (u[i] - committed[i]).abs().where_greater(size * ROUND_OFF, T::ZERO, rests);
    }
    rests
}

/// Deformations from which stiffness and force of the hardening springs are negative, by k₂ + k₃ μ u^(μ-1) = 0 and
/// k₂ + k₃ u^(μ-1) = 0.
pub(in crate::element::bearing) fn hardening_ends(k2: f64, k3: f64, mu: f64) -> Option<(f64, f64)> {
    let end = |share: f64| (k2 / (-k3 * share)).powf(1.0 / (mu - 1.0));
    (k2 > 0.0 && k3 < 0.0 && mu > 1.0).then(|| (end(mu), end(1.0)))
}

/// Force and stiffness of the hardening springs of one direction, k₂ u + k₃ sign(u) |u|^μ.
#[inline]
pub(in crate::element::bearing) fn hardening(k2: f64, k3: f64, mu: f64, u: f64) -> (f64, f64) {
    if k3 == 0.0 {
        return (k2 * u, k2);
    }
    let p = u.abs().powf(mu - 1.0);
    (k2 * u + k3 * p * u, k2 + k3 * mu * p)
}
