//! Shear laws of layered rubber bearings: input, response and trait.

use crate::element::Class;
use crate::element::Stretch;
use crate::element::bearing::laws::axial::{Axial, AxialStep};
use crate::element::bearing::laws::shear::{NoLockstep, Shear};
use crate::numeric::wide::{WIDTH, Wide};
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::fmt;

/// Input of a shear law at a trial state.
#[derive(Clone, Copy, Debug)]
pub struct ShearInput<'a> {
    /// Displacement.
    pub u: [f64; 2],
    /// Size of the displacement.
    pub size: f64,
    /// Velocity.
    pub rate: [f64; 2],
    /// Domain time since the committed state.
    pub dt: f64,
    /// Domain time.
    pub time: f64,
    /// Response of the axial law.
    pub axial: &'a AxialStep,
    /// Committed state variables after the memory.
    pub tail: &'a [f64],
}

/// Response of a shear law; force and stiffness are in `shear`.
#[derive(Clone, Copy, Debug)]
pub struct ShearStep<M> {
    /// Trial state, with force and stiffness.
    pub shear: Shear<2>,
    /// Trial state of the memory.
    pub memory: M,
    /// ∂q/∂(axial displacement).
    pub k_axial: [f64; 2],
    /// ∂q/∂u̇, equal in all directions.
    pub damping: f64,
}

/// A shear law in two directions beside an axial law.
pub trait RubberShear: Clone + fmt::Debug + Send + Sync {
    /// State variables besides [`Shear`].
    type Memory: StateStruct;

    /// OpenSees' name of the bearing.
    fn class(&self) -> Class;
    /// Returns true if the force or the state variables depend on the velocity.
    fn is_viscous(&self) -> bool {
        false
    }
    /// Returns true if the state variables depend on the increment of time.
    fn depends_on_time(&self) -> bool {
        false
    }
    /// Number of state variables after the memory, if it depends on the bearing. Their initial value is 0.
    fn tail_len(&self) -> usize {
        0
    }
    /// Updates these state variables over a time increment, between two states of the memory.
    fn advance(&self, _from: &Self::Memory, _to: &Self::Memory, _dt: f64, _tail: &mut [f64]) {}
    /// Virgin state, with the initial stiffness.
    fn virgin(&self) -> (Shear<2>, Self::Memory);
    /// Response to a trial state from the committed state `c`, `m`. `last` is the memory of the last trial, used only
    /// to follow OpenSees.
    fn step(&self, c: &Shear<2>, m: &Self::Memory, last: &Self::Memory, at: &ShearInput<'_>)
    -> ShearStep<Self::Memory>;
    /// The law of each of several bearings, side by side; `None` where it is not made for it.
    fn lockstep(_all: &[&Self; WIDTH]) -> Option<impl RubberShearLockstep + 'static> {
        None::<NoLockstep>
    }
    /// Own responses of the law; path numbers start at 100.
    fn probe(&self, words: &[&str]) -> Option<Probe>;
    /// Names of all responses, those of the bearing included.
    fn probe_names(&self) -> &'static [&'static str];
    /// Value of an own response; `tail` are the state variables after the memory.
    fn read(&self, id: u32, shear: &Shear<2>, memory: &Self::Memory, tail: &[f64], axial: &Axial, out: &mut [f64]);
}

/// The shear displacement of layered rubber against the thickness of its layers. The tests that laws are fitted to end at shear
/// strains of about 4 (those of `KikuchiAikenLRB` at 4.1).
pub(in crate::element::bearing) fn shear_of_rubber(deformation: f64, thickness: f64) -> Stretch {
    let what = "the thickness of rubber";
    Stretch { deformation, size: thickness, what, suspect: 6.0, refused: 12.0 }
}

/// First path number of the responses of a law; smaller ones are those of the bearing.
pub(in crate::element::bearing) const OWN: u32 = 100;

/// A shear law of several bearings side by side. It depends on neither velocity, time nor axial force.
pub trait RubberShearLockstep: fmt::Debug {
    /// Trial states at displacements of a size, as [`RubberShear::step`] has them one by one, from the committed state and
    /// memory; the trial memory goes to `next`. The method must be inlined.
    fn step(&self, c: &Shear<2, Wide>, memory: &[Wide], next: &mut [Wide], u: [Wide; 2], size: Wide) -> Shear<2, Wide>;
}

impl RubberShearLockstep for NoLockstep {
    fn step(&self, _: &Shear<2, Wide>, _: &[Wide], _: &mut [Wide], _: [Wide; 2], _: Wide) -> Shear<2, Wide> {
        match *self {}
    }
}
