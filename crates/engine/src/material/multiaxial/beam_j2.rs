//! Plasticity of von Mises in a fibre of a beam: `J2BeamFiber`.

use super::plain_methods::plain_methods;
use super::{Multiaxial, Tangent};
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};

/// Largest number of Newton's iterations for the plastic multiplier.
const MAX_ITERATIONS: usize = 50;
/// Residual over the yield stress.
const TOLERANCE: f64 = 1e-15;

/// Plasticity of von Mises with linear hardening where only the stresses 11, 12 and 13 are not zero (Simo and Hughes, 1998,
/// Computational Inelasticity, section 3.4). In a plane the stress 13 is missing.
///
/// State variables: plastic strains, and the accumulated one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamJ2 {
    /// Modulus of elasticity.
    pub e: f64,
    /// Shear modulus.
    pub shear: f64,
    /// First yield stress.
    pub yield_stress: f64,
    /// Modulus of isotropic hardening.
    pub isotropic: f64,
    /// Modulus of kinematic hardening.
    pub kinematic: f64,
    /// Mass per volume.
    pub rho: f64,
}

/// Of the axial stress, or of a shear stress.
fn of<const N: usize>(axial: f64, shear: f64) -> [f64; N] {
    std::array::from_fn(|i| if i == 0 { axial } else { shear })
}

impl BeamJ2 {
    /// The plastic multiplier λ, at which ξ / (1 + c λ) is on the yield surface; and these relative stresses, with their norm.
    fn project<const N: usize>(
        &self,
        xi: &[f64; N],
        resistance: &[f64; N],
        limit: f64,
    ) -> MaterialResult<(f64, [f64; N], f64)> {
        let weight: [f64; N] = of(2.0 / 3.0, 2.0);
        let hardening = 2.0 / 3.0 * self.isotropic;
        let mut multiplier = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let x: [f64; N] = std::array::from_fn(|i| xi[i] / (1.0 + resistance[i] * multiplier));
            let q = (0..N).map(|i| weight[i] * x[i] * x[i]).sum::<f64>().sqrt();
            let residual = q * (1.0 - hardening * multiplier) - limit;
            let falls: f64 =
                (0..N).map(|i| weight[i] * x[i] * x[i] * resistance[i] / (1.0 + resistance[i] * multiplier)).sum();
            let step = residual / ((1.0 - hardening * multiplier) * falls / q + hardening * q);
            if residual.abs() <= TOLERANCE * self.yield_stress || step.abs() <= f64::EPSILON * multiplier {
                return Ok((multiplier, x, q));
            }
            multiplier += step;
            if !multiplier.is_finite() {
                break;
            }
        }
        Err(MaterialError("plasticity of a fibre finds no stress: its parameters are out of range".into()))
    }
}

crate::watches_columns!(BeamJ2 => nothing);

impl<const N: usize> Multiaxial<N> for BeamJ2 {
    plain_methods! { N: is_symmetric depends_on_time reinforcement shown_stress of_length probe }
    fn state_len(&self) -> usize {
        N + 1
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn density(&self) -> f64 {
        self.rho
    }

    fn update(&self, committed: &[f64], e: &[f64; N], _: f64, next: &mut [f64]) -> MultiaxialResult<N> {
        let stiffness: [f64; N] = of(self.e, self.shear);
        let back: [f64; N] = of(self.kinematic, self.kinematic / 3.0);
        let root = (2.0f64 / 3.0).sqrt();
        next.copy_from_slice(committed);
        let mut stress: [f64; N] = std::array::from_fn(|i| stiffness[i] * (e[i] - committed[i]));
        let xi: [f64; N] = std::array::from_fn(|i| stress[i] - back[i] * committed[i]);
        let weight: [f64; N] = of(2.0 / 3.0, 2.0);
        let size = (0..N).map(|i| weight[i] * xi[i] * xi[i]).sum::<f64>().sqrt();
        let limit = root * (self.yield_stress + self.isotropic * committed[N]);
        if !size.is_finite() {
            return Err(MaterialError("plasticity of a fibre has no stress at these strains".into()));
        }
        if size <= limit {
            return Ok((stress, Multiaxial::<N>::initial_tangent(self)));
        }
        // Stress and relative stress fall by these times λ x.
        let fall: [f64; N] = of(2.0 / 3.0 * self.e, 2.0 * self.shear);
        let resistance = fall.map(|f| f + 2.0 / 3.0 * self.kinematic);
        let (multiplier, x, q) = self.project(&xi, &resistance, limit)?;
        for i in 0..N {
            stress[i] -= multiplier * fall[i] * x[i];
            next[i] += multiplier * weight[i] * x[i];
        }
        next[N] += multiplier * root * q;
        let hardening = 2.0 / 3.0 * self.isotropic;
        let scale = resistance.map(|r| (1.0 + r * multiplier).recip());
        let left = 1.0 - hardening * multiplier;
        let sum: f64 = (0..N).map(|i| weight[i] * x[i] * x[i] * resistance[i] * scale[i]).sum();
        let by_strain: [f64; N] = std::array::from_fn(|j| {
            left * weight[j] * x[j] * scale[j] * stiffness[j] / (left * sum + hardening * q * q)
        });
        let tangent = std::array::from_fn(|i| {
            let own = stiffness[i] * (1.0 - fall[i] * multiplier * scale[i]);
            let by_multiplier = fall[i] * x[i] * (1.0 - resistance[i] * multiplier * scale[i]);
            std::array::from_fn(|j| if i == j { own } else { 0.0 } - by_multiplier * by_strain[j])
        });
        Ok((stress, tangent))
    }

    fn initial_tangent(&self) -> Tangent<N> {
        let stiffness: [f64; N] = of(self.e, self.shear);
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { stiffness[i] } else { 0.0 }))
    }
}
