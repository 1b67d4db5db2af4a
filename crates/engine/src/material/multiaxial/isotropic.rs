//! Elasticity of continua.

use super::plain_methods::plain_methods;
use super::simplified_j2::isotropic_stiffness;
use super::{LAYER, Multiaxial, NdMaterial, SOLID, Tangent, linear};
use crate::material::MultiaxialResult;
use nalgebra::Matrix3;
use std::sync::Arc;

/// Isotropic linear elasticity (`nDMaterial ElasticIsotropic`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    /// Modulus of elasticity, stress.
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Mass per volume.
    pub rho: f64,
}

/// Plane stress or plane strain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// Plane strain.
    Strain,
    /// Plane stress.
    Stress,
}

impl Isotropic {
    /// Elasticity matrix, 3 x 3: stresses xx, yy, xy for strains xx, yy and shear angle.
    pub fn plane(&self, plane: Plane) -> [[f64; 3]; 3] {
        let (e, nu) = (self.e, self.nu);
        // Plane strain is plane stress of a material with other constants (Timoshenko and Goodier, 1970, section 17).
        let (e, nu) = match plane {
            Plane::Stress => (e, nu),
            Plane::Strain => (e / (1.0 - nu * nu), nu / (1.0 - nu)),
        };
        let d = e / (1.0 - nu * nu);
        [[d, d * nu, 0.0], [d * nu, d, 0.0], [0.0, 0.0, 0.5 * e / (1.0 + nu)]]
    }
}

impl Isotropic {
    /// Elasticity matrix in space.
    fn solid(&self) -> Tangent<SOLID> {
        let (shear, bulk) = (0.5 * self.e / (1.0 + self.nu), self.e / 3.0 / (1.0 - 2.0 * self.nu));
        isotropic_stiffness(bulk, shear)
    }

    /// Elasticity matrix of a layer without stress across it.
    fn layer(&self) -> Tangent<LAYER> {
        let plane = self.plane(Plane::Stress);
        let mut k = [[0.0; LAYER]; LAYER];
        for (k, row) in k.iter_mut().zip(&plane) {
            k[..3].copy_from_slice(row);
        }
        (k[3][3], k[4][4]) = (plane[2][2], plane[2][2]);
        k
    }

    /// Elasticity matrix of a fibre of a beam.
    fn beam<const N: usize>(&self) -> Tangent<N> {
        let mut k = [[0.0; N]; N];
        for (i, row) in k.iter_mut().enumerate() {
            row[i] = if i == 0 { self.e } else { 0.5 * self.e / (1.0 + self.nu) };
        }
        k
    }

    /// The material in every form. There is none without volume change (`nu` = 0.5) in space and in plane strain.
    pub fn family(self) -> NdMaterial {
        let rho = self.rho;
        let compressible = self.nu != 0.5;
        NdMaterial {
            class: "ElasticIsotropicMaterial",
            solid: compressible.then(|| Arc::new(Elastic { stiffness: self.solid(), rho }) as _),
            plane_strain: compressible.then(|| Arc::new(Elastic { stiffness: self.plane(Plane::Strain), rho }) as _),
            plane_stress: Some(Arc::new(Elastic { stiffness: self.plane(Plane::Stress), rho })),
            layer: Some(Arc::new(Elastic { stiffness: self.layer(), rho })),
            beam: Some(Arc::new(Elastic { stiffness: self.beam(), rho })),
            plane_beam: Some(Arc::new(Elastic { stiffness: self.beam(), rho })),
        }
    }
}

/// Orthotropic linear elasticity (Lekhnitskii, 1981, section 10).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthotropic {
    /// Moduli of elasticity along x, y and z.
    pub e: [f64; 3],
    /// Poisson's ratios xy, yz and zx: contraction along the second axis in tension along the first.
    pub nu: [f64; 3],
    /// Shear moduli xy, yz and zx.
    pub shear: [f64; 3],
    /// Mass per volume.
    pub rho: f64,
}

impl Orthotropic {
    /// The law in space. `None` if the flexibility is not positive definite.
    pub fn solid(&self) -> Option<Elastic<SOLID>> {
        let ([ex, ey, ez], [xy, yz, zx]) = (self.e, self.nu);
        let (xy, yz, zx) = (-xy / ex, -yz / ey, -zx / ez);
        let flexibility = Matrix3::new(1.0 / ex, xy, zx, xy, 1.0 / ey, yz, zx, yz, 1.0 / ez);
        let inverse = flexibility.cholesky()?.inverse();
        let mut stiffness = [[0.0; SOLID]; SOLID];
        for i in 0..3 {
            (0..3).for_each(|j| stiffness[i][j] = inverse[(i, j)]);
            stiffness[3 + i][3 + i] = self.shear[i];
        }
        Some(Elastic { stiffness, rho: self.rho })
    }
}

/// Linear elasticity with any stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct Elastic<const N: usize> {
    /// Derivatives of the stresses by the strains.
    pub stiffness: Tangent<N>,
    /// Mass per volume.
    pub rho: f64,
}

crate::watches_columns!([const N: usize] Elastic<N> => nothing);

impl<const N: usize> Multiaxial<N> for Elastic<N> {
    plain_methods! { N: is_symmetric depends_on_time reinforcement shown_stress of_length probe }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn is_linear(&self) -> bool {
        true
    }
    fn density(&self) -> f64 {
        self.rho
    }
    fn update(&self, _: &[f64], e: &[f64; N], _: f64, _: &mut [f64]) -> MultiaxialResult<N> {
        Ok((linear(&self.stiffness, e), self.stiffness))
    }
    fn initial_tangent(&self) -> Tangent<N> {
        self.stiffness
    }
}
