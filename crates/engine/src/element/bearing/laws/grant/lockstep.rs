//! The law of several bearings side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::{Damage, GrantShear, Rules};
use crate::element::bearing::laws::rubber_shear::RubberShearLockstep;
use crate::element::bearing::laws::shear::{Shear, is_at_rest};
use crate::numeric::wide::{Flags, WIDTH, Wide};

/// Laws with the rules of their source.
#[derive(Debug)]
pub(super) struct GrantLockstep {
    a: [Wide; 3],
    b: [Wide; 3],
    c: [Wide; 4],
}

/// As [`Growth`](super::Growth), with the rates of the damage for a displacement towards the centre.
struct GrowthLockstep {
    damage: Damage<Wide>,
    per_scragging: Wide,
    per_mullins: Wide,
}

/// Vector products and sums of two numbers, in the order of the law.
#[inline(always)]
fn length(v: [Wide; 2]) -> Wide {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// As [`decay`](super::decay), in models that want it.
#[inline(always)]
fn decay(c: Wide, x: Wide, wanted: Flags) -> Wide {
    let power = c * x;
    let exponential = (-power).one_by_one(wanted, f64::exp);
    power.where_equal(Wide::all(0.0), Wide::all(1.0), exponential)
}

impl GrantLockstep {
    /// `None` where the rules are others.
    pub(super) fn new<R: Rules>(all: &[&GrantShear<R>; WIDTH]) -> Option<Self> {
        R::SIDE_BY_SIDE.then(|| Self {
            a: std::array::from_fn(|i| Wide(all.map(|law| law.a[i]))),
            b: std::array::from_fn(|i| Wide(all.map(|law| law.b[i]))),
            c: std::array::from_fn(|i| Wide(all.map(|law| law.c[i]))),
        })
    }

    /// As [`GrantShear::growth`].
    #[inline(always)]
    fn growth(&self, c: &Damage<Wide>, size: Wide, before: Wide) -> GrowthLockstep {
        let zero = Wide::all(0.0);
        let mut d = *c;
        d.outer = size.where_greater(c.outer, size, c.outer);
        d.inner = size.where_greater(c.outer, c.inner + (size - c.outer), c.inner);
        let mut per_scragging = zero;
        let scragging = !c.inner.at_most(size);
        if scragging != 0 {
            d.outer = c.inner.where_greater(size, c.outer, d.outer);
            d.inner = c.inner.where_greater(size, size, d.inner);
            let new = c.scragging + (c.inner - size);
            let cube = new * new * new;
            for i in 0..2 {
                let factor = decay(self.c[i], cube, scragging);
                d.scragging_factors[i] = c.inner.where_greater(size, factor, c.scragging_factors[i]);
            }
            d.scragging = c.inner.where_greater(size, new, c.scragging);
            per_scragging = c.inner.where_greater(size, new * -3.0 * new, zero);
        }
        let mut per_mullins = zero;
        let mullins = !before.at_most(size);
        if mullins != 0 {
            let new = c.mullins + (before - size);
            let factor = decay(self.c[3], new * new * new, mullins);
            d.mullins_factor = before.where_greater(size, factor, c.mullins_factor);
            d.mullins = before.where_greater(size, new, c.mullins);
            per_mullins = before.where_greater(size, new * -3.0 * new, zero);
        }
        GrowthLockstep { damage: d, per_scragging, per_mullins }
    }
}

impl RubberShearLockstep for GrantLockstep {
    #[inline(always)]
    fn step(&self, c: &Shear<2, Wide>, memory: &[Wide], next: &mut [Wide], u: [Wide; 2], size: Wide) -> Shear<2, Wide> {
        let (zero, one) = (Wide::all(0.0), Wide::all(1.0));
        let m = Damage::of_words(memory);
        let size2 = size * size;
        let before = length(c.u);
        let [a1, a2, a3] = self.a;
        let [b1, b2, b3] = self.b;
        let [c1, c2, c3, c4] = self.c;
        let GrowthLockstep { damage: mut d, per_scragging, per_mullins } = self.growth(&m, size, before);

        // Direction of growing damage.
        let mut towards_centre = [zero; 2];
        for i in 0..2 {
            towards_centre[i] = size.where_greater(zero, -u[i] / size, zero);
        }
        let ([ks1, ks2], mullins_decay) = (d.scragging_factors, d.mullins_factor);
        let share = one - c3;
        let km = c3 + share * mullins_decay;

        // Elastic part.
        let (elastic_factor, secant) = (ks1 * km, a1 + size2 * (a2 + size2 * a3));
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
        let rests = is_at_rest(&u, &c.u);
        let (mut n, mut old, mut new) = ([zero; 2], [zero; 2], [zero; 2]);
        for i in 0..2 {
            n[i] = rests.where_equal(one, zero, step[i] / way);
            old[i] = m.radius * n[i] - c.internal[i];
            new[i] = d.radius * n[i] - c.internal[i];
        }
        let (gap, gap_now) = (length(old), length(new));
        let decayed = one / (one + b3 * way);
        d.distance = gap * decayed;
        d.to_words(next);
        let epsilon = Wide::all(f64::EPSILON);
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
            d_distance[i] = gap.where_greater(zero, shrinks + turns, shrinks);
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
        out
    }
}
