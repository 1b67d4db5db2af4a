//! Lines of unloading of concrete after Karsan and Jirsa (1969), and the cycles of concrete without tension by them.

use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;

crate::state_struct! {
    /// History of concrete without tension.
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

/// Permanent strain after the smallest strain `min`, from the strains at the strength and at crushing.
#[inline(always)]
pub(super) fn permanent_strain(min: f64, epsc0: f64, epscu: f64) -> f64 {
    let eta = select(min > epscu, min, epscu) / epsc0;
    let ratio = select(eta < 2.0, 0.145 * eta * eta + 0.13 * eta, 0.707 * (eta - 2.0) + 0.834);
    ratio * epsc0
}

/// Strain of zero stress and slope of the unloading line from a point of the envelope to the permanent strain. The line
/// is not steeper than the initial modulus.
#[inline(always)]
pub(super) fn unloading_line([min, stress]: [f64; 2], permanent: f64, modulus: f64) -> (f64, f64) {
    let (length, elastic) = (min - permanent, stress / modulus);
    let (none, long) = (length > -f64::EPSILON, length <= elastic);
    let end = select(none, permanent, min - select(long, length, elastic));
    (end, select(!none & long, stress / length, modulus))
}

/// Concrete without tension: an envelope, and straight lines of unloading and reloading.
pub(super) trait KarsanJirsa {
    /// Slope of unloading that a step has which leaves the envelope: that of its end, or that of its start.
    const UNLOADS_AS_AT_END: bool;

    /// Initial modulus.
    fn modulus(&self) -> f64;
    /// Stress and slope of the envelope.
    fn envelope(&self, eps: f64) -> (f64, f64);
    /// Strain of zero stress and slope of the unloading line from a point of the envelope.
    fn unload(&self, min: f64, stress: f64) -> (f64, f64);

    /// Returns true for a point that reaches the envelope from its committed strain and smallest strain.
    #[inline(always)]
    fn is_on_envelope(eps: f64, strain: f64, min: f64) -> bool {
        (eps <= min) & (eps < strain) & (eps <= 0.0)
    }

    /// Trial state, stress and tangent from the committed state and the trial strain. Without `ENVELOPE` the point must
    /// not be on the envelope.
    #[inline(always)]
    fn response<const ENVELOPE: bool>(&self, c: [f64; History::LEN], eps: f64) -> ([f64; History::LEN], f64, f64) {
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
        let leaving = if Self::UNLOADS_AS_AT_END { modulus - next_unloading } else { slope };
        let along = straight > loaded;
        let (loading_stress, loading_slope) = (select(along, straight, loaded), select(along, leaving, loaded_slope));
        let (opening, closed) = (eps >= strain, straight <= 0.0);
        let value = select(opening, select(closed, straight, 0.0), loading_stress);
        let tangent = select(opening, select(closed, slope, 0.0), loading_slope);
        let (value, tangent) = (select(eps > 0.0, 0.0, value), select(eps > 0.0, 0.0, tangent));
        // A strain that has not changed.
        let same = (eps - strain).abs() < f64::EPSILON;
        let keep = |old, new| select(same, old, new);
        let next = [
            keep(strain, eps),
            keep(stress, value),
            keep(softening, modulus - tangent),
            keep(min, select(on_envelope, eps, min)),
            keep(end, select(on_envelope, new_end, end)),
            keep(unloading, next_unloading),
        ];
        (next, next[1], keep(modulus - softening, tangent))
    }
}
