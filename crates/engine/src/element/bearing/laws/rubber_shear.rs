//! Shear laws of layered rubber bearings: what a law is told, and what it must say.

use crate::element::bearing::laws::axial::{Axial, AxialStep};
use crate::element::bearing::laws::shear::Shear;
use crate::probe::Probe;
use crate::state_struct::StateStruct;
use std::fmt;

/// What a shear law is told of a trial state.
#[derive(Clone, Copy, Debug)]
pub struct Shearing<'a> {
    /// Displacement.
    pub u: [f64; 2],
    /// Length of the displacement.
    pub size: f64,
    /// Its rate.
    pub rate: [f64; 2],
    /// Domain time since the committed state.
    pub dt: f64,
    /// Domain time.
    pub time: f64,
    /// What the axial law answers.
    pub axial: &'a AxialStep,
    /// The committed words of history behind the memory.
    pub tail: &'a [f64],
}

/// What a shear law answers: stiffness and force of the step are in `shear`.
#[derive(Clone, Copy, Debug)]
pub struct ShearStep<M> {
    /// The next history, with force and stiffness.
    pub shear: Shear<2>,
    /// The rest of the next history.
    pub memory: M,
    /// ∂q by the axial displacement.
    pub k_axial: [f64; 2],
    /// ∂q by the rate, the same in all directions.
    pub damping: f64,
}

/// A law of shear in two directions that an axial law stands beside.
pub trait RubberShear: Clone + fmt::Debug + Send + Sync {
    /// History beside [`Shear`].
    type Memory: StateStruct;

    /// OpenSees' name of the bearing.
    fn class(&self) -> &'static str;
    /// Whether the force depends on the rate.
    fn is_viscous(&self) -> bool {
        false
    }
    /// Whether the history depends on the time that passes.
    fn ages(&self) -> bool {
        false
    }
    /// Number of words of history behind the memory, where their number depends on the bearing. They begin at zero.
    fn tail_len(&self) -> usize {
        0
    }
    /// Carry these words over a time, from a memory to the next.
    fn advance(&self, _from: &Self::Memory, _to: &Self::Memory, _dt: f64, _tail: &mut [f64]) {}
    /// History at rest, with the initial stiffness.
    fn virgin(&self) -> (Shear<2>, Self::Memory);
    /// Response to a trial state from the committed history `c`, `m`. `last` is the memory of the trial before, which
    /// nothing depends on but what OpenSees' laws forget to reset.
    fn step(&self, c: &Shear<2>, m: &Self::Memory, last: &Self::Memory, at: &Shearing<'_>) -> ShearStep<Self::Memory>;
    /// Responses of its own; the numbers of their paths begin at 100.
    fn probe(&self, words: &[&str]) -> Option<Probe>;
    /// Names of the responses, those of the bearing included.
    fn probe_names(&self) -> &'static [&'static str];
    /// Value of a response of its own; `tail` are the words behind the memory.
    fn read(&self, id: u32, shear: &Shear<2>, memory: &Self::Memory, tail: &[f64], axial: &Axial, out: &mut [f64]);
}

/// First number that is free for the responses of a law; those of the bearing are below.
pub(in crate::element::bearing) const OWN: u32 = 100;
