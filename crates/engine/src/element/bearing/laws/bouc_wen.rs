//! Shear law of `elastomericBearingBoucWen`.

mod lockstep;

use crate::element::Class;
use crate::element::bearing::laws::shear::{Shear, ShearLaw, ShearLockstep, at_rest, hardening, hardening_ends};
use crate::element::{ElementError, ElementResult};
use crate::numeric::sign;
use crate::numeric::wide::WIDTH;
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
    /// Hysteretic parameters z at the end of a step (backward Euler), and ∂z/∂d by rows. `d` is the increment of
    /// displacement over the yield displacement q_d/k₀, in `N` directions.
    ///
    /// The equation is z = z_c + d - z |z|^(η-2) (z·d) (γ + β sign(z·d)), so z is parallel to w = z_c + d. With z = t w
    /// it is scalar: t + a t^η = 1, with a = |w|^(η-2) (w·d) (γ + β sign(w·d)). The solution is the root next to t = 1,
    /// which is continuous with the committed state.
    #[inline]
    fn hysteresis<const N: usize>(&self, zc: [f64; N], d: [f64; N]) -> ElementResult<([f64; N], [[f64; N]; N])> {
        let w: [f64; N] = std::array::from_fn(|i| zc[i] + d[i]);
        let work: f64 = w.iter().zip(&d).map(|(w, d)| w * d).sum();
        let norm2: f64 = w.iter().map(|w| w * w).sum();
        let shape = self.gamma + self.beta * sign(work);
        let power = self.power(norm2);
        let a = power * work * shape;
        let t = self.relax(a).ok_or_else(|| self.no_root())?;
        let slope = match self.eta {
            1.0 => 1.0,
            2.0 => t,
            eta => t.powf(eta - 1.0),
        };
        // ∂t/∂d = -t^η / (1 + η a t^(η-1)) ∂a/∂d
        let factor = -t * slope / (1.0 + self.eta * a * slope) * power * shape;
        let radial = if norm2 > 0.0 { (self.eta - 2.0) * work / norm2 } else { 0.0 };
        let dt: [f64; N] = std::array::from_fn(|i| factor * (radial * w[i] + d[i] + w[i]));
        let z = w.map(|w| t * w);
        let dz = std::array::from_fn(|i| std::array::from_fn(|j| w[i] * dt[j] + if i == j { t } else { 0.0 }));
        Ok((z, dz))
    }

    /// |w|^(η-2) from |w|², finite at w = 0 since z vanishes there.
    #[inline]
    fn power(&self, norm2: f64) -> f64 {
        let finite = norm2.max(f64::MIN_POSITIVE);
        match self.eta {
            1.0 => 1.0 / finite.sqrt(),
            2.0 => 1.0,
            eta => finite.powf(0.5 * eta - 1.0),
        }
    }

    /// OpenSees' ∂z/∂d, from the rate at the end of the step. In two directions the ratio of the increments is taken as
    /// constant. Entries are at most 1.
    fn rate_tangent<const N: usize>(&self, z: [f64; N], d: [f64; N]) -> [[f64; N]; N] {
        let work: f64 = z.iter().zip(&d).map(|(z, d)| z * d).sum();
        let norm2: f64 = z.iter().map(|z| z * z).sum();
        let share = self.power(norm2) * (self.gamma + self.beta * sign(work));
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

    /// The root of t + a t^η = 1 next to 1; `None` if the step is too large for a root.
    #[inline]
    fn relax(&self, a: f64) -> Option<f64> {
        if self.eta == 1.0 {
            return Some(1.0 / (1.0 + a)).filter(|t| *t > 0.0);
        }
        if self.eta == 2.0 {
            let root = 1.0 + 4.0 * a;
            return (root >= 0.0).then(|| 2.0 / (1.0 + root.sqrt()));
        }
        // Newton's method from 1 converges from one side for η > 1, where the function is convex for a > 0 and concave
        // for a < 0. For η < 1 the steps keep t positive.
        let mut t = 1.0f64;
        for _ in 0..200 {
            let slope = a * t.powf(self.eta - 1.0);
            let step = (t + slope * t - 1.0) / (1.0 + self.eta * slope);
            let next = if t - step > 0.0 { t - step } else { 0.5 * t };
            if !next.is_finite() || next > 1e6 {
                return None;
            }
            if (next - t).abs() <= 2e-16 * t {
                return Some(next);
            }
            t = next;
        }
        ((t + a * t.powf(self.eta) - 1.0).abs() < 1e-13 * t.max(1.0)).then_some(t)
    }

    fn no_root(&self) -> ElementError {
        ElementError("the step is too large: no hysteretic parameter z belongs to it".into())
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
