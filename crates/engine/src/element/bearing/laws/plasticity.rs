//! Shear law of `elastomericBearingPlasticity`.

use crate::element::Class;
use crate::element::ElementResult;
use crate::element::bearing::laws::shear::{Shear, ShearLaw, at_rest, hardening, hardening_ends};

/// Shear law: an elastic, perfectly plastic part with stiffness k₀ and a circular yield surface of radius q_d. In
/// parallel each direction has the hardening springs k₂ u + k₃ sign(u) |u|^μ. Return mapping is exact (Simo and Hughes,
/// 1998, section 3.3).
#[derive(Clone, Debug, PartialEq)]
pub struct PlasticShear {
    /// Elastic stiffness of the hysteretic part k₀ = (1-α₁) k_init.
    pub k0: f64,
    /// Characteristic strength q_d.
    pub qd: f64,
    /// Stiffness of the linear hardening k₂ = α₁ k_init.
    pub k2: f64,
    /// Stiffness of the nonlinear hardening k₃ = α₂ k_init.
    pub k3: f64,
    /// Exponent of the nonlinear hardening μ.
    pub mu: f64,
    /// OpenSees' scheme: a trial that yields leaves its plastic displacement if the step ends elastic.
    pub compat: bool,
}

impl<const S: usize> ShearLaw<S> for PlasticShear {
    const CLASS: [Class; 2] =
        [Class::new("ElastomericBearingPlasticity2d", 85), Class::new("ElastomericBearingPlasticity3d", 84)];
    const HYSTERETIC: bool = false;

    fn backbone_ends(&self) -> Option<(f64, f64)> {
        hardening_ends(self.k2, self.k3, self.mu)
    }

    fn virgin(&self) -> Shear<S> {
        self.at(&Shear::default(), [0.0; S])
    }

    #[inline]
    fn step(&self, c: &Shear<S>, u: [f64; S]) -> ElementResult<Shear<S>> {
        if at_rest(&u, &c.u) {
            return Ok(Shear { u, ..*c });
        }
        Ok(self.at(c, u))
    }

    fn leave_trace(&self, committed: &Shear<S>, last: &Shear<S>, next: &mut Shear<S>) {
        if self.compat && next.internal == committed.internal {
            next.internal = last.internal;
        }
    }
}

impl PlasticShear {
    /// State at a displacement `u`; the internal variable is the plastic displacement.
    #[inline]
    fn at<const S: usize>(&self, c: &Shear<S>, u: [f64; S]) -> Shear<S> {
        let hardening = u.map(|u| hardening(self.k2, self.k3, self.mu, u));
        let mut next = Shear { u, internal: c.internal, ..Shear::default() };
        let trial: [f64; S] = std::array::from_fn(|i| self.k0 * (u[i] - c.internal[i]));
        let size = trial.iter().fold(0.0f64, |sum, q| sum.hypot(*q));
        let elastic = size <= self.qd;
        let n = trial.map(|q| if elastic { 0.0 } else { q / size });
        let slip = if elastic { 0.0 } else { (size - self.qd) / self.k0 };
        // On the yield surface the stiffness is that normal to the force.
        let k = if elastic { self.k0 } else { self.k0 * self.qd / size };
        for i in 0..S {
            next.internal[i] += slip * n[i];
            next.q[i] = hardening[i].0 + if elastic { trial[i] } else { self.qd * n[i] };
            for j in 0..S {
                next.k[i][j] = if i == j { k * (1.0 - n[i] * n[i]) + hardening[i].1 } else { -k * n[i] * n[j] };
            }
        }
        next
    }
}
