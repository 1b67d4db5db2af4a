//! Concrete confined by stirrups and jackets (Braga, Gigliotti and Laterza, 2006), unloading of Karsan and Jirsa (1969).

mod confinement;

use crate::material::concrete::karsan_jirsa::{History, KarsanJirsa, permanent_strain, unloading_line};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw, finite};
use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;
pub use confinement::{Confinement, ConfinementSection, Dilation, Hoop, UltimateStrain};

/// Concrete without tension along a given envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct ConfinedConcrete01 {
    /// Strain and stress of the points of the envelope, negative, beginning at zero.
    envelope: Vec<[f64; 2]>,
    /// Strain at the strength, negative.
    peak: f64,
    /// Ultimate strain, negative.
    ultimate: f64,
    /// Initial modulus.
    modulus: f64,
}

impl ConfinedConcrete01 {
    /// Number of points of the envelope.
    pub fn points(&self) -> usize {
        self.envelope.len()
    }
}

impl KarsanJirsa for ConfinedConcrete01 {
    const UNLOADS_AS_AT_END: bool = false;

    fn modulus(&self) -> f64 {
        self.modulus
    }

    /// Stress and slope of the envelope. The stress of its last point goes on to the ultimate strain.
    fn envelope(&self, e: f64) -> (f64, f64) {
        if e > 0.0 || e < self.ultimate {
            return (0.0, 0.0);
        }
        let after = self.envelope.partition_point(|p| p[0] >= e);
        match (after, self.envelope.get(after)) {
            (0, _) | (_, None) => (self.envelope[self.envelope.len() - 1][1], 0.0),
            (i, Some(to)) => {
                let from = self.envelope[i - 1];
                let slope = (to[1] - from[1]) / (to[0] - from[0]);
                (from[1] + slope * (e - from[0]), slope)
            }
        }
    }

    fn unload(&self, min: f64, stress: f64) -> (f64, f64) {
        let permanent = permanent_strain(min, self.peak, self.ultimate);
        let (end, slope) = unloading_line([min, stress], permanent, self.modulus);
        (select(min - permanent <= stress / self.modulus, permanent, end), slope)
    }
}

impl UniaxialLaw for ConfinedConcrete01 {
    type State = History;
    const NAME: &'static str = "ConfinedConcrete01";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let e = strain.value;
        let mut words = [0.0; History::LEN];
        c.write(&mut words);
        let (next, value, tangent) = if Self::is_on_envelope(e, c.strain, c.min) {
            self.response::<true>(words, e)
        } else {
            self.response::<false>(words, e)
        };
        finite(Self::NAME, e, value, tangent, History::read(&next))
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus
    }
}
