//! Cross-sections of beams: stress resultants and their tangent for the deformations of a section, as pure functions of
//! the committed state.
//!
//! A section is a struct of constants that implements [`Section`]; whoever uses one (a point of a beam, a hinge) keeps
//! its history through a [`SectionSlot`].

mod aggregator;
mod axial;
mod elastic;
mod fiber;
mod slot;

use crate::material::MaterialError;
use crate::probe::Probe;
use std::fmt;
use std::sync::Arc;

pub use aggregator::Aggregator;
pub use axial::Axial;
pub use elastic::{Elastic, ElasticSection};
pub use fiber::{Fiber, FiberSection};
pub use slot::SectionSlot;

/// Largest number of resultants that buffers are made for.
pub const MAX_ORDER: usize = 8;

/// A stress resultant, which works on a deformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resultant {
    /// Axial force.
    P,
    /// Moment about z.
    Mz,
    /// Shear force along y.
    Vy,
    /// Moment about y.
    My,
    /// Shear force along z.
    Vz,
    /// Torque.
    T,
}

impl Resultant {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::P, Self::Mz, Self::Vy, Self::My, Self::Vz, Self::T];

    /// Its name in scripts and records.
    pub fn name(self) -> &'static str {
        match self {
            Self::P => "P",
            Self::Mz => "Mz",
            Self::Vy => "Vy",
            Self::My => "My",
            Self::Vz => "Vz",
            Self::T => "T",
        }
    }

    /// Name of the deformation that it works on.
    pub fn deformation(self) -> &'static str {
        match self {
            Self::P => "eps",
            Self::Mz => "kappaZ",
            Self::Vy => "gammaY",
            Self::My => "kappaY",
            Self::Vz => "gammaZ",
            Self::T => "theta",
        }
    }

    /// OpenSees' number for it.
    pub fn code(self) -> f64 {
        match self {
            Self::Mz => 1.0,
            Self::P => 2.0,
            Self::Vy => 3.0,
            Self::My => 4.0,
            Self::Vz => 5.0,
            Self::T => 6.0,
        }
    }
}

/// A cross-section.
pub trait Section: fmt::Debug + Send + Sync {
    /// OpenSees' name of the class.
    fn class(&self) -> &'static str;
    /// Its resultants, in the order of its deformations; [`MAX_ORDER`] at most.
    fn resultants(&self) -> &[Resultant];
    /// Number of words of history.
    fn state_len(&self) -> usize;
    /// Write the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Whether resultants are proportional to deformations, whatever the history.
    fn is_linear(&self) -> bool;
    /// Whether they depend on the time that passes.
    fn depends_on_time(&self) -> bool;

    /// Resultants `s` and tangent `k` (by rows) for the deformations `e` from the committed history; writes every word of
    /// `next`. `s` and `k` have been set to zero.
    fn update(
        &self,
        committed: &[f64],
        e: &[f64],
        dt: f64,
        next: &mut [f64],
        s: &mut [f64],
        k: &mut [f64],
    ) -> Result<(), MaterialError>;

    /// Tangent of the virgin section by rows, added to a zero matrix.
    fn initial_stiffness(&self, k: &mut [f64]);

    /// The section as an elastic one, where it is.
    fn elastic(&self) -> Option<ElasticSection> {
        None
    }

    /// The section with another value of a parameter, by the words of a `parameter` command, and the value it had;
    /// `None` where it has none of that name. The history has the same words.
    fn with_parameter(&self, _words: &[&str], _value: f64) -> Option<(SharedSection, f64)> {
        None
    }

    /// A response of the section's own, by the words of a recorder command.
    fn probe(&self, _words: &[&str]) -> Option<Probe> {
        None
    }
    /// Value of a probe from the state.
    fn read(&self, _path: &[u32], _state: &[f64], _out: &mut [f64]) {}
}

/// A section as elements hold it: the parameters are shared, the state lies elsewhere.
pub type SharedSection = Arc<dyn Section>;
