//! The law of several bearings side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::BoucWenShear;
use super::hysteresis::{One, Two, hysteresis};
use crate::element::bearing::laws::shear::{Shear, ShearLockstep, hardening, is_at_rest};
use crate::numeric::real::Real;
use crate::numeric::wide::{WIDTH, Wide};

/// Laws with one yielding exponent.
#[derive(Debug)]
pub(super) struct BoucWenLockstep {
    k0: Wide,
    qd: Wide,
    k2: Wide,
    /// β and γ.
    loop_shape: [Wide; 2],
    eta: f64,
    /// The laws one by one, where one hardens with a power of the displacement.
    hardening: Option<[BoucWenShear; WIDTH]>,
}

impl BoucWenLockstep {
    /// `None` where the yielding exponents differ, or are not the common ones, whose equation has a formula for its root.
    pub(super) fn new(all: &[&BoucWenShear; WIDTH]) -> Option<Self> {
        let eta = all[0].eta;
        let usual = matches!(eta, 1.0 | 2.0) && all.iter().all(|law| law.eta == eta && !law.compat);
        let hardens = all.iter().any(|law| law.k3 != 0.0);
        usual.then(|| Self {
            k0: Wide(all.map(|law| law.k0)),
            qd: Wide(all.map(|law| law.qd)),
            k2: Wide(all.map(|law| law.k2)),
            loop_shape: [Wide(all.map(|law| law.beta)), Wide(all.map(|law| law.gamma))],
            eta,
            hardening: hardens.then(|| all.map(Clone::clone)),
        })
    }

    /// Force and stiffness of the hardening springs of a direction.
    #[inline(always)]
    fn hardening(&self, u: Wide) -> (Wide, Wide) {
        let Some(laws) = &self.hardening else { return (self.k2 * u, self.k2) };
        let (mut force, mut stiffness) = ([0.0; WIDTH], [0.0; WIDTH]);
        for (i, law) in laws.iter().enumerate() {
            (force[i], stiffness[i]) = hardening(law.k2, law.k3, law.mu, u.0[i]);
        }
        (Wide(force), Wide(stiffness))
    }
}

impl<const S: usize> ShearLockstep<S> for BoucWenLockstep {
    #[inline(always)]
    fn step(&self, c: &Shear<S, Wide>, u: [Wide; S]) -> Shear<S, Wide> {
        let scale = self.k0 / self.qd;
        let mut d = u;
        for i in 0..S {
            d[i] = (u[i] - c.u[i]) * scale;
        }
        let (z, mut k) = match self.eta {
            1.0 => hysteresis(One, self.loop_shape, c.internal, d),
            _ => hysteresis(Two, self.loop_shape, c.internal, d),
        };
        let rests = is_at_rest(&u, &c.u);
        let one = Wide::all(1.0);
        let mut next = Shear { u, internal: z, q: z, k };
        for i in 0..S {
            let (force, stiffness) = self.hardening(u[i]);
            next.internal[i] = rests.where_equal(one, c.internal[i], z[i]);
            next.q[i] = self.qd * next.internal[i] + force;
            for j in 0..S {
                k[i][j] = k[i][j] * self.k0;
                if i == j {
                    k[i][j] += stiffness;
                }
                next.k[i][j] = rests.where_equal(one, c.k[i][j], k[i][j]);
            }
        }
        next
    }
}
