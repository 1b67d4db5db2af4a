//! Isotropic elasticity of continua.

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
