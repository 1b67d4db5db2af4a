//! Cycles of concrete with tension softening: linear unloading and reloading, whose branches intersect in one point
//! (Yassin, 1994, section 2.3).

use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;

crate::state_struct! {
    /// History of concrete with tension softening.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// Smallest strain.
        min: f64,
        /// Largest tensile strain, measured from the end of unloading.
        tension: f64,
    }
}

/// Crushing, and unloading from it.
#[derive(Clone, Copy)]
pub(super) struct Crushing {
    /// Crushing strength, not positive.
    pub(super) fcu: f64,
    /// Strain at the crushing strength, negative.
    pub(super) epscu: f64,
    /// Unloading slope at the crushing strain divided by the initial modulus.
    pub(super) ratio: f64,
}

/// Branch at a trial strain.
pub(super) struct Branch {
    /// Stress.
    pub(super) value: f64,
    /// Tangent.
    pub(super) tangent: f64,
    /// Smallest strain after the step.
    min: f64,
    /// Largest tensile strain after the step.
    tension: f64,
}

impl Branch {
    /// One of two branches, without a branch of the program.
    #[inline(always)]
    pub(super) fn select(condition: bool, a: &Self, b: &Self) -> Self {
        Self {
            value: select(condition, a.value, b.value),
            tangent: select(condition, a.tangent, b.tangent),
            min: select(condition, a.min, b.min),
            tension: select(condition, a.tension, b.tension),
        }
    }
}

/// Concrete between an envelope in compression and one in tension.
pub(super) trait Yassin {
    /// Initial modulus.
    fn modulus(&self) -> f64;
    /// Crushing, and unloading from it.
    fn crushing(&self) -> Crushing;
    /// Stress and slope of the envelope in compression.
    fn compression(&self, eps: f64) -> (f64, f64);
    /// Stress and slope of the envelope in tension.
    fn tension(&self, eps: f64) -> (f64, f64);
    /// Slope of unloading from the smallest strain `min`, of the line that `through` gives.
    fn unloading(&self, min: f64, through: f64) -> f64;

    /// The envelope in compression, which strains below the smallest are on.
    #[inline(always)]
    fn crushes(&self, c: [f64; History::LEN], eps: f64) -> Branch {
        let [.., tension] = c;
        let (value, tangent) = self.compression(eps);
        Branch { value, tangent, min: eps, tension }
    }

    /// The branch between the envelopes, or the envelope in tension.
    #[inline(always)]
    fn inside(&self, c: [f64; History::LEN], eps: f64) -> Branch {
        let [strain, stress, _, min, tension] = c;
        let (modulus, Crushing { fcu, epscu, ratio }) = (self.modulus(), self.crushing());
        // All reloading branches intersect in R (equations 2.31 and 2.32); slope 2.35, end of unloading 2.36.
        let eps_r = (fcu - ratio * modulus * epscu) / (modulus * (1.0 - ratio));
        let (sig_min, _) = self.compression(min);
        let slope = self.unloading(min, (sig_min - modulus * eps_r) / (min - eps_r));
        let end = min - sig_min / slope;
        let (lower, upper) = (sig_min + slope * (eps - min), 0.5 * slope * (eps - end));
        let elastic = stress + modulus * (eps - strain);
        let (above, below) = (select(elastic > lower, elastic, lower) >= upper, elastic <= lower);
        let closed = select(above, upper, select(below, lower, elastic));
        let closed_slope = select(above, 0.5 * slope, select(below, slope, modulus));
        // Reloading to the largest tensile strain is linear, because the path is not stored (equation 2.43).
        let reloading = select(tension == 0.0, modulus, self.tension(tension).0 / tension);
        let (open, open_slope) = self.tension(eps - end);
        let (is_closed, is_reloading) = (eps <= end, eps <= end + tension);
        Branch {
            value: select(is_closed, closed, select(is_reloading, reloading * (eps - end), open)),
            tangent: select(is_closed, closed_slope, select(is_reloading, reloading, open_slope)),
            min,
            tension: select(!is_closed & !is_reloading, eps - end, tension),
        }
    }

    /// Trial state, stress and tangent on a branch.
    #[inline(always)]
    fn step(&self, c: [f64; History::LEN], eps: f64, on: &Branch) -> ([f64; History::LEN], f64, f64) {
        let [strain, stress, softening, min, tension] = c;
        let modulus = self.modulus();
        // A strain that has not changed.
        let same = (eps - strain).abs() < f64::EPSILON;
        let keep = |old, new| select(same, old, new);
        let next = [
            keep(strain, eps),
            keep(stress, on.value),
            keep(softening, modulus - on.tangent),
            keep(min, on.min),
            keep(tension, on.tension),
        ];
        (next, next[1], keep(modulus - softening, on.tangent))
    }
}
