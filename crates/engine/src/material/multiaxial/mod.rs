//! Laws of more than one stress, as pure functions of the committed state and the trial strains.
//!
//! Strains of a law of N stresses stand in the order of its form: 11, 22, 33, 12, 23, 31 in space; 11, 22, 12 in a plane;
//! 11, 22, 12, 23, 31 in a layer of a plate. Shears are angles.

mod asd_concrete;
mod beam_j2;
mod condensed;
mod family;
mod fsam;
mod isotropic;
mod j2;
pub(crate) mod plain_methods;
mod series;
mod simplified_j2;
mod wall_strip;
mod weighted;
mod wrapped;

use super::{MaterialResult, WatchesColumns};
use crate::probe::Probe;
use std::fmt;
use std::sync::Arc;

pub use asd_concrete::{AsdConcrete, Extrapolation, HardeningCurve};
pub(super) use asd_concrete::{RESPONSES as CONCRETE_RESPONSES, ReachedPoints};
pub use beam_j2::BeamJ2;
pub use condensed::Condensed;
pub use family::NdMaterial;
pub use fsam::{Fsam, FsamParameters};
pub use isotropic::{Elastic, Isotropic, Orthotropic, Plane};
pub use j2::J2Plasticity;
pub use series::{SeriesSolids, SeriesTolerance};
pub use simplified_j2::SimplifiedJ2;
pub use wall_strip::WallStrip;
pub use weighted::WeightedLaws;
pub use wrapped::{InitialStrain, ParallelSolids, strain_of_stress};

/// Number of stresses in space.
pub const SOLID: usize = 6;
/// Number of stresses in a plane.
pub const PLANE: usize = 3;
/// Number of stresses in a layer of a plate. The stress 33 is zero.
pub const LAYER: usize = 5;

/// Number of stresses of a plane with a stress across it: 11, 22, 33, 12.
pub const THICK_PLANE: usize = 4;
/// Number of stresses of a fibre of a beam in space: 11, 12, 13. The other ones are zero.
pub const BEAM_FIBRE: usize = 3;
/// Number of stresses of a fibre of a beam in a plane: 11, 12.
pub const PLANE_BEAM_FIBRE: usize = 2;

/// Number of stresses in a vertical strip of a wall: 22, 12.
pub const STRIP: usize = 2;

/// Derivatives of the stresses by the strains, row by row.
pub type Tangent<const N: usize> = [[f64; N]; N];

/// Stresses of a law that may have none, and their derivatives by the strains.
pub type MultiaxialResult<const N: usize> = MaterialResult<([f64; N], Tangent<N>)>;

/// A law of N stresses. No method has a default: a law around others decides on every one of them.
pub trait Multiaxial<const N: usize>: WatchesColumns + fmt::Debug + Send + Sync {
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Writes the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Returns true if stresses are proportional to strains for every history.
    fn is_linear(&self) -> bool;
    /// Returns true if every tangent is symmetric.
    fn is_symmetric(&self) -> bool;
    /// Returns true if the stresses depend on the elapsed time.
    fn depends_on_time(&self) -> bool;
    /// Mass per volume.
    fn density(&self) -> f64;
    /// Area of the bars along axis 1 as a share of the whole.
    fn reinforcement(&self) -> f64;

    /// Stresses and their derivatives by the strains `e`; writes every variable of `next`. `dt` is the domain time since
    /// the committed state.
    ///
    /// # Errors
    /// There is no stress at these strains.
    fn update(&self, committed: &[f64], e: &[f64; N], dt: f64, next: &mut [f64]) -> MultiaxialResult<N>;

    /// Derivatives of the stresses in the virgin state.
    fn initial_tangent(&self) -> Tangent<N>;

    /// Stress that records show for the state `next` after a step with the stress `stress`.
    fn shown_stress(&self, next: &[f64], stress: [f64; N]) -> [f64; N];
    /// The law for an element of a size, if it depends on the size.
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<N>>;

    /// Response specific to this law, by the words of a recorder command.
    fn probe(&self, words: &[&str]) -> Option<Probe>;
    /// Value of a probe from the state.
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]);
}

/// A law as elements and sections hold it: the parameters are shared, the state is stored by the owner.
pub type SharedMultiaxial<const N: usize> = Arc<dyn Multiaxial<N>>;

/// Stresses of a linear law.
pub(crate) fn linear<const N: usize>(tangent: &Tangent<N>, e: &[f64; N]) -> [f64; N] {
    tangent.each_ref().map(|row| row.iter().zip(e).map(|(k, e)| k * e).sum())
}
