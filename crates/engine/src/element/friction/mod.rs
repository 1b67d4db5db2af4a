//! Friction models: coefficient of friction of a sliding surface as a function of normal force and speed.
//!
//! A new model is a [`FrictionLaw`] in a file of its own.

mod coulomb;
mod vel_dep_multi_linear;
mod vel_dependent;
mod vel_normal_frc_dep;
mod vel_pressure_dep;

use crate::probe::{Probe, Response};
use crate::state_struct;
use std::fmt;
use std::sync::Arc;

pub use coulomb::Coulomb;
pub use vel_dep_multi_linear::VelDepMultiLinear;
pub use vel_dependent::VelDependent;
pub use vel_normal_frc_dep::VelNormalFrcDep;
pub use vel_pressure_dep::VelPressureDep;

/// Coefficient of friction with derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficient {
    /// Coefficient of friction μ.
    pub mu: f64,
    /// ∂μ/∂N, in 1/force.
    pub by_normal: f64,
    /// ∂μ/∂v, in time/length.
    pub by_speed: f64,
}

impl Coefficient {
    /// μ = μ_fast - (μ_fast - μ_slow) exp(-r |v|) for the speed v. `slow`, `fast` and `rate` are a value and its
    /// derivative by the normal force. Source: Constantinou, Mokha and Reinhorn (1990).
    fn between(slow: [f64; 2], fast: [f64; 2], rate: [f64; 2], speed: f64) -> Self {
        let v = speed.abs();
        let decay = (-rate[0] * v).exp();
        let speed_term = (fast[0] - slow[0]) * decay;
        Self {
            mu: fast[0] - speed_term,
            by_normal: fast[1] - (fast[1] - slow[1]) * decay + rate[1] * v * speed_term,
            by_speed: rate[0] * speed_term,
        }
    }
}

/// A friction model.
pub trait FrictionLaw: fmt::Debug + Send + Sync {
    /// OpenSees' name of the model.
    fn name(&self) -> &'static str;

    /// Coefficient for a normal force > 0 (positive in compression) and a speed ≥ 0.
    fn coefficient(&self, normal: f64, speed: f64) -> Coefficient;

    /// Returns true if the coefficient depends on the speed.
    fn depends_on_speed(&self) -> bool {
        true
    }
}

/// Shared friction model of an element.
pub type Friction = Arc<dyn FrictionLaw>;

state_struct! {
    /// Last contact state of a sliding surface, for recorders.
    pub struct Contact {
        /// Normal force, positive in compression.
        normal: f64,
        /// Speed, length/time.
        speed: f64,
        /// Coefficient of friction.
        mu: f64,
    }
}

/// Responses by the word after `frictionModel`.
const RESPONSES: [Response<Contact, ()>; 4] = [
    Response::new(&["normalForce", "N", "normalFrc"], &["N"], |c, (), out| out[0] = c.normal),
    Response::new(&["velocity", "vel"], &["vel"], |c, (), out| out[0] = c.speed),
    Response::new(&["frictionForce", "Ff", "frnForce", "frnFrc"], &["frnFrc"], |c, (), out| {
        out[0] = c.mu * c.normal.max(0.0);
    }),
    Response::new(&["frictionCoeff", "mu", "frnCoeff", "COF"], &["COF"], |c, (), out| out[0] = c.mu),
];

impl Contact {
    /// The response for the arguments after `frictionModel`; `None` for an unknown name.
    pub fn probe(words: &[&str]) -> Option<Probe> {
        Response::find(&RESPONSES, words.first()?)
    }

    /// Value of the response `id`.
    pub fn value(&self, id: u32) -> f64 {
        let mut value = [0.0];
        Response::read(&RESPONSES, id, self, &(), &mut value);
        value[0]
    }
}
