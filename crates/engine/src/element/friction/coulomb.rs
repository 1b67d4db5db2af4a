//! `frictionModel Coulomb`.

use super::{Coefficient, FrictionLaw};

/// A constant coefficient of friction μ.
#[derive(Clone, Debug, PartialEq)]
pub struct Coulomb {
    /// Coefficient of friction μ.
    pub mu: f64,
}

impl FrictionLaw for Coulomb {
    fn name(&self) -> &'static str {
        "Coulomb"
    }
    fn coefficient(&self, _: f64, _: f64) -> Coefficient {
        Coefficient { mu: self.mu, ..Coefficient::default() }
    }
    fn depends_on_speed(&self) -> bool {
        false
    }
}
