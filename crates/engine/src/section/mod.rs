//! Cross-sections of beams: stress resultants and tangent for section deformations, as pure functions of the
//! committed state.
//!
//! A section is a struct of constants that implements [`Section`]. Its owner (an integration point of a beam, a
//! hinge) stores the history through a [`SectionSlot`].

mod aggregator;
mod axial;
mod bidirectional;
mod elastic;
mod elliptical;
mod fiber;
mod nd_fiber;
mod nearest;
mod parallel;
mod plain_methods;
pub mod plate;
mod shared;
mod slot;
mod two_spring_isolator;

use crate::material::{CHARACTERISTIC_LENGTH, MaterialResult, WatchesColumns};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use std::fmt;
use std::sync::Arc;

pub use aggregator::Aggregator;
pub use axial::Axial;
pub use bidirectional::Bidirectional;
pub use elastic::{Elastic, ElasticSection};
pub use elliptical::Elliptical;
pub use fiber::{Fiber, FiberBending, FiberSection};
pub use nd_fiber::{NdFiber, NdFiberSection};
pub use parallel::ParallelSections;
pub use slot::SectionSlot;
pub use two_spring_isolator::TwoSpringIsolator;

/// Maximum number of resultants of a section; sizes the buffers.
pub const MAX_ORDER: usize = 8;

/// A stress resultant and its work-conjugate deformation.
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
    /// All resultants.
    pub const ALL: [Self; 6] = [Self::P, Self::Mz, Self::Vy, Self::My, Self::Vz, Self::T];

    /// Name in scripts and records.
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

    /// Name of the work-conjugate deformation.
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

    /// Number in OpenSees' `code` response.
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

/// A step of a section of n resultants from a committed state to trial deformations, and the places of its answer.
#[derive(Debug)]
pub struct SectionStep<'a> {
    /// The committed state.
    pub committed: &'a [f64],
    /// Deformations, of length n.
    pub e: &'a [f64],
    /// Domain time since the committed state.
    pub dt: f64,
    /// The trial state, every variable of which is written.
    pub next: &'a mut [f64],
    /// Resultants, of length n; zero before.
    pub s: &'a mut [f64],
    /// Tangent, n x n by rows; zero before.
    pub k: &'a mut [f64],
}

/// A cross-section. No method has a default: a section around others decides on every one of them.
pub trait Section: WatchesColumns + fmt::Debug + Send + Sync {
    /// Class name in OpenSees.
    fn class(&self) -> &'static str;
    /// Resultants in the order of the deformations, at most [`MAX_ORDER`].
    fn resultants(&self) -> &[Resultant];
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Writes the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Returns true if the resultants are proportional to the deformations for every history.
    fn is_linear(&self) -> bool;
    /// Returns true if the resultants depend on the elapsed time.
    fn depends_on_time(&self) -> bool;

    /// Writes resultants, tangent and every variable of `next`.
    ///
    /// # Errors
    /// A material has no response at these deformations.
    fn update(&self, step: SectionStep<'_>) -> MaterialResult;

    /// Writes the tangent of the virgin section (n x n by rows) to a zero matrix.
    fn initial_stiffness(&self, k: &mut [f64]);

    /// The elastic section, or `None` for another kind.
    fn elastic(&self) -> Option<ElasticSection>;

    /// The section as one that is worth being evaluated at several places together, or `None`.
    fn joined(&self) -> Option<&FiberSection>;

    /// Returns the section with a new value of a parameter, named by the words of a `parameter` command, and the
    /// previous value. The layout of the history does not change.
    ///
    /// # Errors
    /// The section has no such parameter, or refuses the value.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedSection>;

    /// Response specific to this section, by the words of a recorder command.
    fn probe(&self, words: &[&str]) -> Option<Probe>;
    /// Value of a probe from the state.
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]);
}

/// A section as elements hold it: the parameters are shared, the state is stored by the element.
pub type SharedSection = Arc<dyn Section>;

/// The section for a part of a beam of a length.
pub fn of_length(section: SharedSection, length: f64) -> SharedSection {
    section.with_parameter(&[CHARACTERISTIC_LENGTH], NewValue::Is(length)).map_or(section, |(made, _)| made)
}
