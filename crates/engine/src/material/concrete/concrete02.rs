//! Concrete with tension softening: Yassin.

use crate::material::lanes::{PointLaw, PointResponse, updates_blocks};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;

/// The envelope of Kent, Scott and Park in compression, and linear softening in tension. The unloading and reloading
/// branches are linear and intersect in one point (Yassin, 1994, section 2.3).
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete02 {
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strength, not positive.
    pub fcu: f64,
    /// Strain at the crushing strength, negative.
    pub epscu: f64,
    /// Unloading slope at the crushing strain divided by the initial modulus.
    pub ratio: f64,
    /// Tensile strength.
    pub ft: f64,
    /// Tension softening modulus.
    pub ets: f64,
}

/// Tangent of the branches with constant stress; a positive value keeps the stiffness matrix regular.
pub(super) const FLAT_TANGENT: f64 = 1.0e-10;

crate::state_struct! {
    /// History of [`Concrete02`].
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

impl Concrete02 {
    /// Strain at which all reloading branches intersect, from the initial modulus.
    #[inline(always)]
    pub(super) fn intersection_from(&self, modulus: f64) -> f64 {
        (self.fcu - self.ratio * modulus * self.epscu) / (modulus * (1.0 - self.ratio))
    }

    /// Stress and slope of the envelope beyond the strength.
    #[inline(always)]
    pub(super) fn crushing(&self, eps: f64) -> (f64, f64) {
        let slope = (self.fcu - self.fc) / (self.epscu - self.epsc0);
        let falling = eps > self.epscu;
        let stress = select(falling, self.fc + slope * (eps - self.epsc0), self.fcu);
        (stress, select(falling, slope, FLAT_TANGENT))
    }

    /// Stress and slope of the envelope in tension, from the initial modulus and the stress of open cracks.
    #[inline(always)]
    pub(super) fn tension_from(&self, modulus: f64, open: f64, eps: f64) -> (f64, f64) {
        let peak = self.ft / modulus;
        let (elastic, softening) = (eps <= peak, eps <= self.ft * (1.0 / self.ets + 1.0 / modulus));
        let after = select(softening, self.ft - self.ets * (eps - peak), open);
        let slope = select(softening, -self.ets, FLAT_TANGENT);
        (select(elastic, modulus * eps, after), select(elastic, modulus, slope))
    }
}

/// Envelope of a concrete that unloads and reloads by Yassin's rules.
pub(super) trait Envelope {
    /// Initial modulus.
    fn modulus(&self) -> f64;
    /// Strain at which all reloading branches intersect (Yassin, 1994, equations 2.31 and 2.32).
    fn intersection(&self) -> f64;
    /// Stress and slope of the envelope in compression.
    fn compression(&self, eps: f64) -> (f64, f64);
    /// Stress and slope of the envelope in tension.
    fn tension(&self, eps: f64) -> (f64, f64);

    /// The history after a strain, its stress and its tangent.
    #[inline(always)]
    fn cycle(&self, c: [f64; History::LEN], eps: f64) -> PointResponse<{ History::LEN }> {
        let [strain, stress, softening, min, tension] = c;
        let modulus = self.modulus();
        let step = eps - strain;
        let on_envelope = eps < min;
        let (crushing, crushing_slope) = self.compression(eps);
        // Slope 2.35, end of unloading 2.36.
        let eps_r = self.intersection();
        let (sig_min, _) = self.compression(min);
        let slope = select(min == 0.0, modulus, (sig_min - modulus * eps_r) / (min - eps_r));
        let end = min - sig_min / slope;
        let (lower, upper) = (sig_min + slope * (eps - min), 0.5 * slope * (eps - end));
        let elastic = stress + modulus * step;
        let (above, below) = (select(elastic > lower, elastic, lower) >= upper, elastic <= lower);
        let closed = select(above, upper, select(below, lower, elastic));
        let closed_slope = select(above, 0.5 * slope, select(below, slope, modulus));
        // Reloading to the largest tensile strain is linear, because the path is not stored (equation 2.43).
        let reloading = select(tension == 0.0, modulus, self.tension(tension).0 / tension);
        let (open, open_slope) = self.tension(eps - end);
        let (is_closed, is_reloading) = (eps <= end, eps <= end + tension);
        let value = select(is_closed, closed, select(is_reloading, reloading * (eps - end), open));
        let tangent = select(is_closed, closed_slope, select(is_reloading, reloading, open_slope));
        let (value, tangent) = (select(on_envelope, crushing, value), select(on_envelope, crushing_slope, tangent));
        let widens = !on_envelope & !is_closed & !is_reloading;
        // A strain that has not changed.
        let same = step.abs() < f64::EPSILON;
        let keep = |old, new| select(same, old, new);
        let words = [
            keep(strain, eps),
            keep(stress, value),
            keep(softening, modulus - tangent),
            keep(min, select(on_envelope, eps, min)),
            keep(tension, select(widens, eps - end, tension)),
        ];
        PointResponse { words, value: words[1], tangent: keep(modulus - softening, tangent) }
    }
}

impl Envelope for Concrete02 {
    #[inline(always)]
    fn modulus(&self) -> f64 {
        2.0 * self.fc / self.epsc0
    }
    #[inline(always)]
    fn intersection(&self) -> f64 {
        self.intersection_from(self.modulus())
    }
    #[inline(always)]
    fn compression(&self, eps: f64) -> (f64, f64) {
        let eta = eps / self.epsc0;
        let (after, slope) = self.crushing(eps);
        let (rising, modulus) = (eps >= self.epsc0, self.modulus());
        (select(rising, self.fc * eta * (2.0 - eta), after), select(rising, modulus * (1.0 - eta), slope))
    }
    #[inline(always)]
    fn tension(&self, eps: f64) -> (f64, f64) {
        self.tension_from(self.modulus(), 0.0, eps)
    }
}

impl PointLaw<{ History::LEN }> for Concrete02 {
    #[inline(always)]
    fn response(&self, c: [f64; History::LEN], eps: f64) -> PointResponse<{ History::LEN }> {
        self.cycle(c, eps)
    }
}

impl UniaxialLaw for Concrete02 {
    type State = History;
    const NAME: &'static str = "Concrete02";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        Ok(self.respond_to(c, strain.value))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}
