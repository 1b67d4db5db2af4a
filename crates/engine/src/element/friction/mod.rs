//! Friction models: the coefficient of friction of a sliding surface under a normal force, at a speed.
//!
//! To add one: a [`FrictionLaw`] in a file of its own.

mod coulomb;
mod vel_dep_multi_linear;
mod vel_dependent;
mod vel_normal_frc_dep;
mod vel_pressure_dep;

use crate::probe::Probe;
use crate::state_struct;
use std::fmt;
use std::sync::Arc;

pub use coulomb::Coulomb;
pub use vel_dep_multi_linear::VelDepMultiLinear;
pub use vel_dependent::VelDependent;
pub use vel_normal_frc_dep::VelNormalFrcDep;
pub use vel_pressure_dep::VelPressureDep;

/// A coefficient of friction with its derivatives.
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
    /// A coefficient that changes with the speed v between a slow and a fast one:
    /// μ = μ_fast - (μ_fast - μ_slow) exp(-r |v|), each given with its derivative by the normal force. Constantinou,
    /// Mokha and Reinhorn (1990).
    fn between(slow: [f64; 2], fast: [f64; 2], rate: [f64; 2], speed: f64) -> Self {
        let v = speed.abs();
        let left = (-rate[0] * v).exp();
        let gap = (fast[0] - slow[0]) * left;
        Self {
            mu: fast[0] - gap,
            by_normal: fast[1] - (fast[1] - slow[1]) * left + rate[1] * v * gap,
            by_speed: rate[0] * gap,
        }
    }
}

/// A friction model.
pub trait FrictionLaw: fmt::Debug + Send + Sync {
    /// OpenSees' name.
    fn name(&self) -> &'static str;

    /// Coefficient under a normal force greater than 0 (pressure is positive) at a speed not less than 0.
    fn coefficient(&self, normal: f64, speed: f64) -> Coefficient;

    /// Whether the coefficient changes with the speed.
    fn depends_on_speed(&self) -> bool {
        true
    }
}

/// A friction model as elements hold it.
pub type Friction = Arc<dyn FrictionLaw>;

state_struct! {
    /// What a sliding surface last saw, for recorders.
    pub struct Contact {
        /// Normal force, positive in pressure.
        normal: f64,
        /// Speed.
        speed: f64,
        /// Coefficient of friction.
        mu: f64,
    }
}

impl Contact {
    /// The response of a friction model by the words after `frictionModel`.
    pub fn probe(words: &[&str]) -> Option<Probe> {
        Some(match *words.first()? {
            "normalForce" | "N" | "normalFrc" => Probe::new(1, ["N"]),
            "velocity" | "vel" => Probe::new(2, ["vel"]),
            "frictionForce" | "Ff" | "frnForce" | "frnFrc" => Probe::new(3, ["frnFrc"]),
            "frictionCoeff" | "mu" | "frnCoeff" | "COF" => Probe::new(4, ["COF"]),
            _ => return None,
        })
    }

    /// Value of a probe.
    pub fn value(&self, id: u32) -> f64 {
        match id {
            1 => self.normal,
            2 => self.speed,
            3 => self.mu * self.normal.max(0.0),
            _ => self.mu,
        }
    }
}
