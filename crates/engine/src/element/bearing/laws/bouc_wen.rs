//! Shear law of `elastomericBearingBoucWen`.

mod hysteresis;
mod lockstep;

use crate::element::Class;
use crate::element::bearing::laws::shear::{Shear, ShearLaw, ShearLockstep, at_rest, hardening, hardening_ends};
use crate::element::{ElementError, ElementResult};
use crate::numeric::wide::WIDTH;
use hysteresis::{Any, Exponent, One, Two, hysteresis, not_zero, shape};
use lockstep::BoucWenLockstep;

/// Shear law of `elastomericBearingBoucWen`: q = q_d z + k₂ u + k₃ sign(u) |u|^μ, with ż = (k₀/q_d) [A u̇ - z |z|^(η-2)
/// (z·u̇) (γ + β sign(z·u̇))], A = 1.
///
/// Sources: Casciati (1989); Nagarajaiah, Reinhorn and Constantinou (1991), as in OpenSees. Backward Euler over a step,
/// solved to round-off.
#[derive(Clone, Debug, PartialEq)]
pub struct BoucWenShear {
    /// Elastic stiffness of the hysteretic part k₀ = (1-α₁) k_init.
    pub k0: f64,
    /// Characteristic strength q_d.
    pub qd: f64,
    /// Post-yield stiffness of the linear hardening part k₂ = α₁ k_init.
    pub k2: f64,
    /// Post-yield stiffness of the nonlinear hardening part k₃ = α₂ k_init.
    pub k3: f64,
    /// Exponent of the nonlinear hardening μ.
    pub mu: f64,
    /// Yielding exponent η.
    pub eta: f64,
    /// First loop shape parameter β.
    pub beta: f64,
    /// Second loop shape parameter γ.
    pub gamma: f64,
    /// OpenSees' tangent: the derivative of the rate equation, not of the step.
    pub compat: bool,
}

impl BoucWenShear {
    /// As [`hysteresis()`] has them.
    ///
    /// # Errors
    /// The step is too large.
    #[inline]
    fn hysteresis<const N: usize>(&self, zc: [f64; N], d: [f64; N]) -> ElementResult<([f64; N], [[f64; N]; N])> {
        let loop_shape = [self.beta, self.gamma];
        let (z, dz) = match self.eta {
            1.0 => hysteresis(One, loop_shape, zc, d),
            2.0 => hysteresis(Two, loop_shape, zc, d),
            eta => hysteresis(Any(eta), loop_shape, zc, d),
        };
        if z.iter().any(|z| z.is_nan()) {
            let why = "the step is too large: no hysteretic parameter z belongs to it";
            return Err(ElementError(why.into()));
        }
        Ok((z, dz))
    }

    /// |z|^(η-2) from |z|², finite at z = 0.
    fn power(&self, norm2: f64) -> f64 {
        let norm2 = not_zero(norm2);
        match self.eta {
            1.0 => One.power(norm2),
            2.0 => Two.power(norm2),
            eta => Any(eta).power(norm2),
        }
    }

    /// OpenSees' ∂z/∂d, from the rate at the end of the step. In two directions the ratio of the increments is taken as
    /// constant. Entries are at most 1.
    fn rate_tangent<const N: usize>(&self, z: [f64; N], d: [f64; N]) -> [[f64; N]; N] {
        let work: f64 = z.iter().zip(&d).map(|(z, d)| z * d).sum();
        let norm2: f64 = z.iter().map(|z| z * z).sum();
        let share = self.power(norm2) * shape([self.beta, self.gamma], work);
        // Ratio of the increment of one direction to the other.
        let ratio = |i: usize, j: usize| match d.iter().product::<f64>() {
            _ if i == j => 1.0,
            0.0 => 0.0,
            _ => d[i] / d[j],
        };
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let drag: f64 = (0..N).map(|k| z[k] * ratio(k, j)).sum();
                let slope = ratio(i, j) - z[i] * share * drag;
                match slope {
                    _ if N == 1 || slope.abs() <= 1.0 => slope,
                    _ if i == j => 1.0,
                    _ => slope.signum(),
                }
            })
        })
    }
}

impl<const S: usize> ShearLaw<S> for BoucWenShear {
    const CLASS: [Class; 2] =
        [Class::new("ElastomericBearingBoucWen2d", 90), Class::new("ElastomericBearingBoucWen3d", 91)];
    const HYSTERETIC: bool = true;

    fn lockstep(all: &[&Self; WIDTH]) -> Option<impl ShearLockstep<S> + 'static> {
        BoucWenLockstep::new(all)
    }

    fn backbone_ends(&self) -> Option<(f64, f64)> {
        hardening_ends(self.k2, self.k3, self.mu)
    }

    fn virgin(&self) -> Shear<S> {
        let mut virgin = Shear::default();
        for i in 0..S {
            virgin.k[i][i] = self.k0 + self.k2;
        }
        virgin
    }

    #[inline]
    fn step(&self, c: &Shear<S>, u: [f64; S]) -> ElementResult<Shear<S>> {
        let hardening = u.map(|u| hardening(self.k2, self.k3, self.mu, u));
        let scale = self.k0 / self.qd;
        let d: [f64; S] = std::array::from_fn(|i| (u[i] - c.u[i]) * scale);
        let q = |z: &[f64; S]| std::array::from_fn(|i| self.qd * z[i] + hardening[i].0);
        if at_rest(&u, &c.u) {
            return Ok(Shear { u, q: q(&c.internal), ..*c });
        }
        let (z, mut k) = self.hysteresis(c.internal, d)?;
        if self.compat {
            k = self.rate_tangent(z, d);
        }
        for (i, row) in k.iter_mut().enumerate() {
            row.iter_mut().for_each(|k| *k *= self.k0);
            row[i] += hardening[i].1;
        }
        Ok(Shear { u, internal: z, q: q(&z), k })
    }
}
