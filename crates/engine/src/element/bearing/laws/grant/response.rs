//! The response of one bearing, or of several side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::{Damage, Rules};
use crate::element::bearing::laws::shear::Shear;
use crate::numeric::real::Real;

/// Coefficients of the law, as [`GrantShear`](super::GrantShear) has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficients<T = f64> {
    pub(super) a: [T; 3],
    pub(super) b: [T; 3],
    pub(super) c: [T; 4],
}

/// State variables at a displacement, with the rates of the damage for a displacement towards the centre.
struct Growth<T> {
    damage: Damage<T>,
    per_scragging: T,
    per_mullins: T,
}

#[inline(always)]
fn length<T: Real>(v: [T; 2]) -> T {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// e^(-c x), in models that want it; 1 for c = 0 or x = 0.
#[inline(always)]
fn decay<T: Real>(c: T, x: T, wanted: T::Flags) -> T {
    let power = c * x;
    let exponential = (-power).one_by_one(wanted, f64::exp);
    power.where_equal(T::ZERO, T::ONE, exponential)
}

impl<T: Real> Coefficients<T> {
    #[inline(always)]
    fn growth<R: Rules>(&self, c: &Damage<T>, last: &Damage<T>, size: T, before: T) -> Growth<T> {
        let mut d = R::begin(c, last);
        d.inner = size.where_greater(c.outer, c.inner + (size - c.outer), d.inner);
        d.scragging = size.where_greater(c.outer, c.scragging, d.scragging);
        for i in 0..2 {
            d.scragging_factors[i] = size.where_greater(c.outer, c.scragging_factors[i], d.scragging_factors[i]);
        }
        d.outer = size.where_greater(c.outer, size, d.outer);
        let mut per_scragging = T::ZERO;
        let scragging = c.inner.exceeds(size);
        if scragging != T::NONE {
            d.outer = c.inner.where_greater(size, c.outer, d.outer);
            d.inner = c.inner.where_greater(size, size, d.inner);
            let new = c.scragging + (c.inner - size);
            let cube = new * new * new;
            for i in 0..2 {
                let factor = decay(self.c[i], cube, scragging);
                d.scragging_factors[i] = c.inner.where_greater(size, factor, d.scragging_factors[i]);
            }
            d.scragging = c.inner.where_greater(size, new, d.scragging);
            per_scragging = c.inner.where_greater(size, new * -3.0 * new, T::ZERO);
        }
        let mut per_mullins = T::ZERO;
        let mullins = before.exceeds(size);
        if mullins != T::NONE {
            let new = c.mullins + (before - size);
            let factor = decay(self.c[3], new * new * new, mullins);
            d.mullins_factor = before.where_greater(size, factor, d.mullins_factor);
            d.mullins = before.where_greater(size, new, d.mullins);
            per_mullins = before.where_greater(size, new * -3.0 * new, T::ZERO);
        }
        Growth { damage: d, per_scragging, per_mullins }
    }

    /// Trial state and memory at a displacement of a size, from the committed state and memory. `last` is the memory of the last
    /// trial.
    #[inline(always)]
    pub(super) fn step<R: Rules>(
        &self,
        c: &Shear<2, T>,
        [m, last]: [&Damage<T>; 2],
        u: [T; 2],
        size: T,
    ) -> (Shear<2, T>, Damage<T>) {
        let (zero, one) = (T::ZERO, T::ONE);
        let size2 = size * size;
        let before = length(c.u);
        let [a1, a2, a3] = self.a;
        let [b1, b2, b3] = self.b;
        let [c1, c2, c3, c4] = self.c;
        let Growth { damage: mut d, per_scragging, per_mullins } = self.growth::<R>(m, last, size, before);

        // Direction of growing damage.
        let mut towards_centre = [zero; 2];
        for i in 0..2 {
            towards_centre[i] = size.where_greater(zero, -u[i] / size, zero);
        }
        let ([ks1, ks2], mullins_decay) = (d.scragging_factors, d.mullins_factor);
        let km = c3 + (one - c3) * mullins_decay;

        // Elastic part.
        let (elastic_factor, secant) = (ks1 * km, a1 + size2 * (a2 + size2 * a3));
        let share = R::mullins_slope(c3, c4);
        let loss = secant * (per_scragging * c1 * elastic_factor + per_mullins * c4 * share * mullins_decay * ks1);
        let stiffening = elastic_factor * 2.0 * (a2 + a3 * 2.0 * size2);
        let elastic = elastic_factor * secant;
        let mut k = [[zero; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                k[i][j] = u[i] * (stiffening * u[j] + loss * towards_centre[j]);
            }
            k[i][i] += elastic;
        }

        // Hysteretic part.
        d.radius = b1 + ks2 * b2 * size2;
        let step = [u[0] - c.u[0], u[1] - c.u[1]];
        let way = length(step);
        let rests = R::rests(way, &u, &c.u);
        let (mut n, mut old, mut new) = ([zero; 2], [zero; 2], [zero; 2]);
        for i in 0..2 {
            n[i] = rests.where_equal(one, zero, step[i] / way);
            old[i] = m.radius * n[i] - c.internal[i];
            new[i] = d.radius * n[i] - c.internal[i];
        }
        let (gap, gap_now) = (length(old), length(new));
        let decayed = one / (one + b3 * way);
        d.distance = gap * decayed;
        let epsilon = T::of(f64::EPSILON);
        let rotation = gap_now.where_greater(epsilon, d.distance / gap_now, zero);
        let along = (old[0] * n[0] + old[1] * n[1]) / gap;
        let turn = d.radius / way;
        let (mut mu, mut d_radius, mut d_distance) = ([zero; 2], [zero; 2], [zero; 2]);
        let mut out = Shear { u, internal: c.internal, q: u, k: c.k };
        for i in 0..2 {
            mu[i] = gap_now.where_greater(epsilon, new[i] / gap_now, zero);
            let internal = d.radius * n[i] - d.distance * mu[i];
            out.q[i] = elastic * u[i] + internal;
            out.internal[i] = rests.where_equal(one, c.internal[i], internal);
            d_radius[i] = b2 * (ks2 * 2.0 * u[i] + size2 * per_scragging * c2 * ks2 * towards_centre[i]);
            // δ depends on the direction of the step.
            let shrinks = -d.distance * decayed * b3 * n[i];
            let turns = decayed * m.radius / way * (old[i] / gap - along * n[i]);
            d_distance[i] = if R::TURNS { gap.where_greater(zero, shrinks + turns, shrinks) } else { shrinks };
        }
        let mut hat = [[zero; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                let unit = if i == j { one } else { zero };
                hat[i][j] = n[i] * d_radius[j] + turn * (unit - n[i] * n[j]);
            }
        }
        for j in 0..2 {
            let across = mu[0] * hat[0][j] + mu[1] * hat[1][j];
            for i in 0..2 {
                let part = hat[i][j] - rotation * (hat[i][j] - mu[i] * across) - mu[i] * d_distance[j];
                out.k[i][j] = rests.where_equal(one, c.k[i][j], k[i][j] + part);
            }
        }
        (out, d)
    }
}
