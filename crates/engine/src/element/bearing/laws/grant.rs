//! Shear law of `HDR`.

mod lockstep;
mod opensees;

use crate::element::Class;
use crate::element::bearing::laws::axial::Axial;
use crate::element::bearing::laws::rubber_shear::{OWN, RubberShear, RubberShearLockstep, ShearInput, ShearStep};
use crate::element::bearing::laws::shear::{Shear, at_rest};
use crate::numeric::wide::WIDTH;
use crate::probe::Probe;
use crate::rules::Consistent;
use lockstep::GrantLockstep;
use std::fmt;

/// Bidirectional shear law of high damping rubber.
///
/// Source: D. N. Grant, G. L. Fenves and A. S. Whittaker, "Bidirectional modelling of high-damping rubber bearings",
/// Journal of Earthquake Engineering 8 (2004) 161-185. The force is F₁ + F₂. F₁ = K_S1 K_M (a₁ + a₂ U² + a₃ U⁴) u is
/// elastic. F₂ = R n - δ μ with δ' = -b₃ δ |u'| tends to a bounding circle in the direction n of the increment. Its
/// radius is R = b₁ + K_S2 b₂ U².
///
/// Scragging, the long-term damage D_S, lowers K_S = e^(-c D_S³). The Mullins damage D_M lowers K_M = c₃ + (1 - c₃)
/// e^(-c₄ D_M³).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrantShear<R = Consistent> {
    /// Coefficients a₁, a₂, a₃ of the elastic part.
    pub a: [f64; 3],
    /// Coefficients b₁, b₂, b₃ of the hysteretic part.
    pub b: [f64; 3],
    /// Coefficients of the damage: c₁, c₂ of scragging, c₃, c₄ of the Mullins effect.
    pub c: [f64; 4],
    /// Rules of the damage and of the tangent.
    pub rules: R,
}

/// Rules of [`GrantShear`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync {
    /// Bearings of several models can go side by side.
    const SIDE_BY_SIDE: bool = true;

    /// Damage of which a trial state changes what grows: the committed one, or that of the trial before.
    fn begin(committed: &Damage, _last: &Damage) -> Damage {
        *committed
    }

    /// Initial stiffness of the elastic and of the hysteretic part.
    fn initial(elastic: f64, hysteretic: f64) -> f64 {
        elastic + hysteretic
    }

    /// Factor of the derivative of K_M, of c₃ and c₄.
    fn mullins_slope(c3: f64, _c4: f64) -> f64 {
        1.0 - c3
    }

    /// The bearing has moved from the committed displacement `from` to `to`, by the length `way`.
    fn moved(_way: f64, to: &[f64; 2], from: &[f64; 2]) -> bool {
        !at_rest(to, from)
    }

    /// The gap to the bounding circle depends on the direction of the step.
    fn turns(gap: f64) -> bool {
        gap > 0.0
    }
}

impl Rules for Consistent {}

crate::state_struct! {
    /// State variables of high damping rubber.
    pub struct Damage<T> {
        /// Outer bound of the displacement D_S⁺.
        outer: T,
        /// Inner bound of the displacement D_S⁻.
        inner: T,
        /// Scragging D_S.
        scragging: T,
        /// Mullins damage D_M.
        mullins: T,
        /// Factors of scragging on elastic stiffness and growth of the radius: e^(-c₁ D_S³), e^(-c₂ D_S³).
        scragging_factors: [T; 2],
        /// Factor e^(-c₄ D_M³) of the Mullins damage.
        mullins_factor: T,
        /// Distance δ of the force from the bounding circle.
        distance: T,
        /// Radius R of the bounding circle.
        radius: T,
    }
}

/// State variables at a displacement, and whether each damage grows for a displacement towards the centre.
struct Growth {
    damage: Damage,
    scragging: bool,
    mullins: bool,
}

impl<R> GrantShear<R> {
    /// The same by other rules.
    pub fn with<T>(self, rules: T) -> GrantShear<T> {
        GrantShear { a: self.a, b: self.b, c: self.c, rules }
    }
}

impl<R: Rules> GrantShear<R> {
    fn growth(&self, c: &Damage, last: &Damage, size: f64, before: f64) -> Growth {
        let mut damage = R::begin(c, last);
        if size > c.outer {
            damage.outer = size;
            damage.inner = c.inner + (size - c.outer);
            (damage.scragging, damage.scragging_factors) = (c.scragging, c.scragging_factors);
        }
        let scragging = size < c.inner;
        if scragging {
            damage.outer = c.outer;
            damage.inner = size;
            damage.scragging = c.scragging + (c.inner - size);
            let cube = damage.scragging * damage.scragging * damage.scragging;
            damage.scragging_factors = [decay(self.c[0], cube), decay(self.c[1], cube)];
        }
        let mullins = size < before;
        if mullins {
            damage.mullins = c.mullins + (before - size);
            damage.mullins_factor = decay(self.c[3], damage.mullins * damage.mullins * damage.mullins);
        }
        Growth { damage, scragging, mullins }
    }
}

impl<R: Rules> RubberShear for GrantShear<R> {
    type Memory = Damage;

    fn class(&self) -> Class {
        Class::new("HDR", 151)
    }

    fn lockstep(all: &[&Self; WIDTH]) -> Option<impl RubberShearLockstep + 'static> {
        GrantLockstep::new(all)
    }

    fn virgin(&self) -> (Shear<2>, Damage) {
        let [a1, ..] = self.a;
        let [b1, _, b3] = self.b;
        let k = R::initial(a1, b1 * b3);
        (
            Shear { k: [[k, 0.0], [0.0, k]], ..Shear::default() },
            Damage { radius: b1, scragging_factors: [1.0; 2], mullins_factor: 1.0, ..Damage::default() },
        )
    }

    fn step(&self, c: &Shear<2>, m: &Damage, last: &Damage, at: &ShearInput<'_>) -> ShearStep<Damage> {
        let (u, size) = (at.u, at.size);
        let size2 = size * size;
        let before = length(c.u);
        let [a1, a2, a3] = self.a;
        let [b1, b2, b3] = self.b;
        let [c1, c2, c3, c4] = self.c;
        let Growth { damage: mut d, scragging, mullins } = self.growth(m, last, size, before);

        // Direction of growing damage.
        let towards_centre = if size > 0.0 { [-u[0] / size, -u[1] / size] } else { [0.0; 2] };
        let ([ks1, ks2], mullins_decay) = (d.scragging_factors, d.mullins_factor);
        let km = c3 + (1.0 - c3) * mullins_decay;
        let per_scragging = if scragging { -3.0 * d.scragging * d.scragging } else { 0.0 };
        let per_mullins = if mullins { -3.0 * d.mullins * d.mullins } else { 0.0 };

        // Elastic part.
        let (elastic_factor, secant) = (ks1 * km, a1 + size2 * (a2 + size2 * a3));
        let share = R::mullins_slope(c3, c4);
        let loss = secant * (per_scragging * c1 * elastic_factor + per_mullins * c4 * share * mullins_decay * ks1);
        let stiffening = 2.0 * elastic_factor * (a2 + 2.0 * a3 * size2);
        let mut k = [[0.0; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                k[i][j] = u[i] * (stiffening * u[j] + loss * towards_centre[j]);
            }
            k[i][i] += elastic_factor * secant;
        }

        // Hysteretic part.
        d.radius = b1 + ks2 * b2 * size2;
        let step = [u[0] - c.u[0], u[1] - c.u[1]];
        let way = length(step);
        let moved = R::moved(way, &u, &c.u);
        let n = if moved { step.map(|s| s / way) } else { [0.0; 2] };
        let toward = |radius: f64| [radius * n[0] - c.internal[0], radius * n[1] - c.internal[1]];
        let (old, new) = (toward(m.radius), toward(d.radius));
        let (gap, gap_now) = (length(old), length(new));
        let decayed = 1.0 / (1.0 + b3 * way);
        d.distance = gap * decayed;
        let mu = if gap_now > f64::EPSILON { new.map(|x| x / gap_now) } else { [0.0; 2] };
        let internal: [f64; 2] = std::array::from_fn(|i| d.radius * n[i] - d.distance * mu[i]);
        let q = std::array::from_fn(|i| elastic_factor * secant * u[i] + internal[i]);
        if !moved {
            let shear = Shear { u, internal: c.internal, q, k: c.k };
            return ShearStep { shear, memory: d, k_axial: [0.0; 2], damping: 0.0 };
        }
        let d_radius: [f64; 2] =
            std::array::from_fn(|j| b2 * (2.0 * ks2 * u[j] + size2 * per_scragging * c2 * ks2 * towards_centre[j]));
        let turn = d.radius / way;
        let hat: [[f64; 2]; 2] = std::array::from_fn(|i| {
            std::array::from_fn(|j| n[i] * d_radius[j] + turn * (f64::from(u8::from(i == j)) - n[i] * n[j]))
        });
        // δ depends on the direction of the step.
        let mut d_distance = n.map(|n| -d.distance * decayed * b3 * n);
        if R::turns(gap) {
            let along = (old[0] * n[0] + old[1] * n[1]) / gap;
            for j in 0..2 {
                d_distance[j] += decayed * m.radius / way * (old[j] / gap - along * n[j]);
            }
        }
        let rotation = if gap_now > f64::EPSILON { d.distance / gap_now } else { 0.0 };
        for j in 0..2 {
            let across = mu[0] * hat[0][j] + mu[1] * hat[1][j];
            for i in 0..2 {
                k[i][j] += hat[i][j] - rotation * (hat[i][j] - mu[i] * across) - mu[i] * d_distance[j];
            }
        }
        ShearStep { shear: Shear { u, internal, q, k }, memory: d, k_axial: [0.0; 2], damping: 0.0 }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "Evolution" | "evolution" | "EvolutionParameter" | "evolutionparameter" | "z" => {
                Some(Probe::new(OWN, ["DSplus", "DSminus", "DS", "DM", "Delta"]))
            }
            "param" | "Param" | "parameters" | "Parameters" => Some(Probe::new(OWN + 1, ["Fcn", "Fcrn", "Kv"])),
            _ => None,
        }
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &[
            "EvolutionParameter",
            "parameters",
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "basicStiffness",
        ]
    }

    fn read(&self, id: u32, _: &Shear<2>, d: &Damage, _: &[f64], axial: &Axial, out: &mut [f64]) {
        if id == OWN {
            out.copy_from_slice(&[d.outer, d.inner, d.scragging, d.mullins, d.distance]);
        } else {
            out.copy_from_slice(&[axial.fcn, axial.fcrn, axial.kv]);
        }
    }
}

#[inline]
fn length(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// e^(-c x); 1 without evaluation for c = 0 or x = 0.
#[inline]
fn decay(c: f64, x: f64) -> f64 {
    let power = c * x;
    if power == 0.0 { 1.0 } else { (-power).exp() }
}
