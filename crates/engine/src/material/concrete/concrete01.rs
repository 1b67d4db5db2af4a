//! Concrete without tension: Kent, Scott and Park.

use crate::material::concrete::karsan_jirsa::{permanent_strain, unloading_line};
use crate::material::lanes::{BlockLaw, LaneInput, PointResponse, Response, updates_blocks, words_of};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
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

crate::state_struct! {
    /// History of [`Concrete01`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// Smallest strain.
        min: f64,
        /// Strain of zero stress on the unloading line from the smallest strain.
        end: f64,
        /// Initial modulus minus the unloading slope.
        unloading: f64,
    }
}

impl Concrete01 {
    pub(super) fn modulus(&self) -> f64 {
        2.0 * self.fpc / self.epsc0
    }

    /// Stress and slope of the envelope.
    #[inline(always)]
    pub(super) fn envelope(&self, eps: f64) -> (f64, f64) {
        let eta = eps / self.epsc0;
        let slope = (self.fpc - self.fpcu) / (self.epsc0 - self.epscu);
        let (rising, falling) = (eps > self.epsc0, eps > self.epscu);
        let after = select(falling, self.fpc + slope * (eps - self.epsc0), self.fpcu);
        let stress = select(rising, self.fpc * (2.0 * eta - eta * eta), after);
        (stress, select(rising, self.modulus() * (1.0 - eta), select(falling, slope, 0.0)))
    }

    /// Strain of zero stress and slope of the unloading line from a point of the envelope.
    #[inline(always)]
    pub(super) fn unload(&self, min: f64, stress: f64) -> (f64, f64) {
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

impl Concrete01 {
    /// Returns true for a point that reaches the envelope from its committed strain and smallest strain.
    #[inline(always)]
    fn is_on_envelope(eps: f64, strain: f64, min: f64) -> bool {
        (eps <= min) & (eps < strain) & (eps <= 0.0)
    }

    /// Trial state, stress and tangent from the committed state and the trial strain. Without `ENVELOPE` the point must
    /// not be on the envelope.
    #[inline(always)]
    fn response<const ENVELOPE: bool>(&self, c: [f64; History::LEN], eps: f64) -> PointResponse<{ History::LEN }> {
        let [strain, stress, softening, min, end, unloading] = c;
        let modulus = self.modulus();
        let slope = modulus - unloading;
        let straight = stress + slope * (eps - strain);
        let on_envelope = ENVELOPE && Self::is_on_envelope(eps, strain, min);
        let ((peak, peak_slope), (new_end, new_slope)) = if ENVELOPE {
            let (peak, peak_slope) = self.envelope(eps);
            ((peak, peak_slope), self.unload(eps, peak))
        } else {
            Default::default()
        };
        let before_end = eps <= end;
        let loaded = select(on_envelope, peak, select(before_end, slope * (eps - end), 0.0));
        let loaded_slope = select(on_envelope, peak_slope, select(before_end, slope, 0.0));
        let next_unloading = select(on_envelope, modulus - new_slope, unloading);
        // The unloading slope of the present step applies if unloading begins on the envelope.
        let along = straight > loaded;
        let (loading_stress, loading_slope) =
            (select(along, straight, loaded), select(along, modulus - next_unloading, loaded_slope));
        let (opening, closed) = (eps >= strain, straight <= 0.0);
        let value = select(opening, select(closed, straight, 0.0), loading_stress);
        let tangent = select(opening, select(closed, slope, 0.0), loading_slope);
        let (value, tangent) = (select(eps > 0.0, 0.0, value), select(eps > 0.0, 0.0, tangent));
        // A strain that has not changed.
        let same = (eps - strain).abs() < f64::EPSILON;
        let keep = |old, new| select(same, old, new);
        let words = [
            keep(strain, eps),
            keep(stress, value),
            keep(softening, modulus - tangent),
            keep(min, select(on_envelope, eps, min)),
            keep(end, select(on_envelope, new_end, end)),
            keep(unloading, next_unloading),
        ];
        PointResponse { words, value: words[1], tangent: keep(modulus - softening, tangent) }
    }
}

impl UniaxialLaw for Concrete01 {
    type State = History;
    const NAME: &'static str = "Concrete01";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        Ok(self.response::<true>(words_of(c), strain.value).read())
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}
