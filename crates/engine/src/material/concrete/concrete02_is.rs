//! Concrete as by Yassin (1994), with a modulus of its own: Popovics' curve up to the strength.

use crate::material::concrete::concrete02::{Envelope, FLAT_TANGENT, History};
use crate::material::concrete::popovics;
use crate::material::lanes::words_of;
use crate::material::{Concrete02, MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// [`Concrete02`] with an initial modulus.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete02Is {
    /// Initial modulus.
    pub e0: f64,
    /// The other parameters.
    pub concrete: Concrete02,
}

impl Envelope for Concrete02Is {
    fn modulus(&self) -> f64 {
        self.e0
    }
    fn intersection(&self) -> f64 {
        self.concrete.intersection_from(self.e0)
    }
    fn compression(&self, eps: f64) -> (f64, f64) {
        let Concrete02 { fc, epsc0, .. } = self.concrete;
        if eps >= epsc0 { popovics::compression([fc, epsc0], self.e0, eps) } else { self.concrete.crushing(eps) }
    }
    fn tension(&self, eps: f64) -> (f64, f64) {
        self.concrete.tension_from(self.e0, FLAT_TANGENT, eps)
    }
}

impl UniaxialLaw for Concrete02Is {
    type State = History;
    const NAME: &'static str = "Concrete02IS";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (stress, next) = self.cycle(words_of(c), strain.value).read();
        finite(Self::NAME, strain.value, stress.value, stress.tangent, next)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}
