//! Shear law of `HDR`.

mod lockstep;
mod opensees;
mod response;

use crate::element::Class;
use crate::element::bearing::laws::axial::Axial;
use crate::element::bearing::laws::rubber_shear::{OWN, RubberShear, RubberShearLockstep, ShearInput, ShearStep};
use crate::element::bearing::laws::shear::{Shear, is_at_rest};
use crate::numeric::real::Real;
use crate::numeric::wide::WIDTH;
use crate::probe::Probe;
use crate::rules::Consistent;
use lockstep::GrantLockstep;
use response::Coefficients;
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
    /// The tangent follows the direction of the step, on which the gap to the bounding circle depends.
    const TURNS: bool = true;

    /// Damage of which a trial state changes what grows: the committed one, or that of the trial before.
    fn begin<T: Real>(committed: &Damage<T>, _last: &Damage<T>) -> Damage<T> {
        *committed
    }

    /// Initial stiffness of the elastic and of the hysteretic part.
    fn initial(elastic: f64, hysteretic: f64) -> f64 {
        elastic + hysteretic
    }

    /// Factor of the derivative of K_M, of c₃ and c₄.
    fn mullins_slope<T: Real>(c3: T, _c4: T) -> T {
        T::ONE - c3
    }

    /// 1 where the bearing has not moved from the committed displacement `from` to `to`, by the length `way`, else 0.
    fn rests<T: Real>(_way: T, to: &[T; 2], from: &[T; 2]) -> T {
        is_at_rest(to, from)
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

impl<R> GrantShear<R> {
    /// The same by other rules.
    pub fn with<T>(self, rules: T) -> GrantShear<T> {
        GrantShear { a: self.a, b: self.b, c: self.c, rules }
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
        let coefficients = Coefficients { a: self.a, b: self.b, c: self.c };
        let (shear, memory) = coefficients.step::<R>(c, [m, last], at.u, at.size);
        ShearStep { shear, memory, k_axial: [0.0; 2], damping: 0.0 }
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
