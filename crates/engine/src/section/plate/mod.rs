//! Cross-sections of plates and shells: stress resultants for deformations of the middle surface.
//!
//! Deformations are the membrane strains ε11, ε22, γ12, the curvatures κ11, κ22, 2κ12 and the shear angles γ13, γ23. The
//! strain at height z is ε - z κ. Resultants are the forces p11, p22, p12 and moments m11, m22, m12 per length with
//! m = ∫ z σ dz, and the shear forces q1, q2. The work per area is therefore p ε - m κ + q γ.

mod layered;
mod response;

use crate::material::{LAYER, MultiaxialResult, WatchesColumns};
use std::fmt;
use std::sync::Arc;

pub use layered::{Layer, LayeredPlate, PlateFromPlaneStress, PlateRebar};
pub(crate) use response::{PlateState, probe};

/// Number of resultants.
pub const PLATE_ORDER: usize = 8;
/// Names of the resultants.
pub const PLATE_RESULTANTS: [&str; PLATE_ORDER] = ["p11", "p22", "p12", "m11", "m22", "m12", "q1", "q2"];
/// Names of the deformations.
pub const PLATE_DEFORMATIONS: [&str; PLATE_ORDER] =
    ["eps11", "eps22", "gamma12", "theta11", "theta22", "theta33", "gamma13", "gamma23"];
/// Ratio of the shear rigidity to that of uniform shear stress (Reissner, 1945).
const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Derivatives of the resultants by the deformations.
pub type PlateTangent = [[f64; PLATE_ORDER]; PLATE_ORDER];

/// A section of a plate.
pub trait PlateSection: WatchesColumns + fmt::Debug + Send + Sync {
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Writes the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Returns true if the resultants are proportional to the deformations for every history.
    fn is_linear(&self) -> bool;
    /// Returns true if every tangent is that of symmetric laws.
    fn is_symmetric(&self) -> bool;
    /// Returns true if the resultants depend on the elapsed time.
    fn depends_on_time(&self) -> bool;
    /// Mass per area.
    fn mass(&self) -> f64;

    /// Resultants for the deformations `e`, and their derivatives; writes every variable of `next`. `dt` is the domain time
    /// since the committed state.
    ///
    /// # Errors
    /// A material has no response at these deformations.
    fn update(
        &self,
        committed: &[f64],
        e: &[f64; PLATE_ORDER],
        dt: f64,
        next: &mut [f64],
    ) -> MultiaxialResult<PLATE_ORDER>;

    /// Tangent of the virgin section.
    fn initial_stiffness(&self) -> PlateTangent;

    /// Number of layers, or of points across the thickness, that have a law of their own.
    fn layers(&self) -> usize;

    /// Strains and stresses 11, 22, 12, 23, 31 of a layer from 0 in a state that was reached with the deformations `e`;
    /// `None` where there is no such layer, or its law has no response.
    fn layer(&self, layer: usize, state: &[f64], e: &[f64; PLATE_ORDER]) -> Option<[[f64; LAYER]; 2]>;
}

/// A section as elements hold it.
pub type SharedPlateSection = Arc<dyn PlateSection>;

/// An isotropic elastic plate with shear deformation (Reissner, 1945; Mindlin, 1951).
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticPlate {
    /// Modulus of elasticity of the membrane.
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Thickness.
    pub thickness: f64,
    /// Mass per volume.
    pub rho: f64,
    /// Modulus of elasticity in bending and transverse shear, divided by that of the membrane.
    pub bending_ratio: f64,
}

crate::watches_columns!(ElasticPlate => nothing);

impl PlateSection for ElasticPlate {
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn is_linear(&self) -> bool {
        true
    }
    fn is_symmetric(&self) -> bool {
        true
    }
    fn depends_on_time(&self) -> bool {
        false
    }
    fn mass(&self) -> f64 {
        self.rho * self.thickness
    }

    fn update(&self, _: &[f64], e: &[f64; PLATE_ORDER], _: f64, _: &mut [f64]) -> MultiaxialResult<PLATE_ORDER> {
        let (mut s, mut k) = ([0.0; PLATE_ORDER], [[0.0; PLATE_ORDER]; PLATE_ORDER]);
        for ((s, row), k) in s.iter_mut().zip(&self.initial_stiffness()).zip(&mut k) {
            *s += row.iter().zip(e).map(|(k, e)| k * e).sum::<f64>();
            k.iter_mut().zip(row).for_each(|(k, added)| *k += added);
        }
        Ok((s, k))
    }

    fn layers(&self) -> usize {
        0
    }
    fn layer(&self, _: usize, _: &[f64], _: &[f64; PLATE_ORDER]) -> Option<[[f64; LAYER]; 2]> {
        None
    }

    fn initial_stiffness(&self) -> PlateTangent {
        let (nu, h) = (self.nu, self.thickness);
        let membrane = self.e * h / (1.0 - nu * nu);
        let shear = 0.5 * self.e * h / (1.0 + nu);
        let bending = self.bending_ratio * membrane * h * h / 12.0;
        let mut k = [[0.0; PLATE_ORDER]; PLATE_ORDER];
        for (at, d) in [(0, membrane), (3, -bending)] {
            (k[at][at], k[at + 1][at + 1]) = (d, d);
            (k[at][at + 1], k[at + 1][at]) = (nu * d, nu * d);
        }
        (k[2][2], k[5][5]) = (shear, -0.5 * bending * (1.0 - nu));
        for row in [6, 7] {
            k[row][row] = SHEAR_FACTOR * self.bending_ratio * shear;
        }
        k
    }
}
