//! Concrete without tension: Kent, Scott and Park.

use crate::material::concrete::karsan_jirsa::{History, KarsanJirsa, permanent_strain, unloading_line};
use crate::material::lanes::{BlockLaw, LaneInput, Response, updates_blocks};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::numeric::lanes::{any, flag, select};
use crate::state_struct::StateStruct;

/// Parabola up to the strength, a straight line to the crushing strength, and constant stress beyond; no tension.
/// Unloading is linear, with a slope that degrades with the largest compressive strain (Kent and Park, 1971; Karsan
/// and Jirsa, 1969).
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete01 {
    /// Compressive strength, negative.
    pub fpc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strength, not positive.
    pub fpcu: f64,
    /// Strain at the crushing strength, negative.
    pub epscu: f64,
}

impl KarsanJirsa for Concrete01 {
    const UNLOADS_AS_AT_END: bool = true;

    fn modulus(&self) -> f64 {
        2.0 * self.fpc / self.epsc0
    }

    #[inline(always)]
    fn envelope(&self, eps: f64) -> (f64, f64) {
        let eta = eps / self.epsc0;
        let slope = (self.fpc - self.fpcu) / (self.epsc0 - self.epscu);
        let (rising, falling) = (eps > self.epsc0, eps > self.epscu);
        let after = select(falling, self.fpc + slope * (eps - self.epsc0), self.fpcu);
        let stress = select(rising, self.fpc * (2.0 * eta - eta * eta), after);
        (stress, select(rising, self.modulus() * (1.0 - eta), select(falling, slope, 0.0)))
    }

    #[inline(always)]
    fn unload(&self, min: f64, stress: f64) -> (f64, f64) {
        unloading_line([min, stress], permanent_strain(min, self.epsc0, self.epscu), self.modulus())
    }
}

/// Columns of a block, as in [`History`].
const STRAIN: usize = 0;
const MIN: usize = 3;

impl BlockLaw<{ History::LEN }> for Concrete01 {
    #[inline(always)]
    fn respond<const W: usize>(
        &self,
        given: &LaneInput<'_, { History::LEN }, W>,
        out: &mut Response<{ History::LEN }, W>,
    ) {
        let law = self.clone();
        let mut on_envelope = [0; W];
        for (i, on_envelope) in on_envelope.iter_mut().enumerate() {
            let (strain, min) = (given.words[STRAIN][i], given.words[MIN][i]);
            *on_envelope = flag(Self::is_on_envelope(given.strain[i], strain, min));
        }
        // Few blocks reach the envelope: the others are spared its divisions.
        if any(&on_envelope) {
            for i in 0..W {
                out.set(i, law.response::<true>(given.point(i), given.strain[i]));
            }
        } else {
            for i in 0..W {
                out.set(i, law.response::<false>(given.point(i), given.strain[i]));
            }
        }
    }
}

impl UniaxialLaw for Concrete01 {
    type State = History;
    const NAME: &'static str = "Concrete01";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let mut words = [0.0; History::LEN];
        c.write(&mut words);
        let (next, value, tangent) = self.response::<true>(words, strain.value);
        Ok((Stress { value, tangent, damping: 0.0 }, History::read(&next)))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}
