//! Cycles between two envelopes, which the laws of this kind share.

use crate::material::{MaterialError, MaterialResult, Strain, Stress};
use crate::state_struct::StateStruct;

/// Largest strain of an envelope, which no analysis reaches.
pub(in crate::material) const MAX_STRAIN: f64 = 1.0e16;
/// Slope of a horizontal branch divided by the elastic slope; a positive value keeps the stiffness matrix regular.
pub(in crate::material) const FLAT_SLOPE_RATIO: f64 = 1.0e-9;

crate::state_struct! {
    /// Common history of hysteresis between two envelopes.
    pub struct Cycle {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial tangent.
        softening: f64,
        /// Largest strain in tension and in compression, both positive, enlarged by damage.
        extreme: [f64; 2],
        /// Strain of zero stress after the last unloading from tension and from compression.
        unloaded: [f64; 2],
        /// Dissipated and stored energy per volume.
        energy: f64,
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
    }
}

/// A law whose stress follows an envelope beyond the largest strains and lines between them.
pub(in crate::material) trait Enveloped {
    /// History with a [`Cycle`] in it.
    type History: StateStruct;
    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;

    fn cycle(history: &Self::History) -> &Cycle;
    fn cycle_mut(history: &mut Self::History) -> &mut Cycle;
    /// Tangent of the virgin material.
    fn initial(&self) -> f64;
    /// Stress and slope of the envelope of a side, both counted from zero outwards.
    fn envelope(&self, c: &Self::History, side: usize, x: f64) -> (f64, f64);
    /// Response between the largest strains towards tension (`s` = 1) or, mirrored, towards compression (`s` = -1).
    fn advance(&self, c: &Self::History, d: f64, t: &mut Self::History, s: f64) -> (f64, f64);
    /// Returns false if a step that ends beyond the largest strain keeps the direction of loading.
    fn turns_beyond(&self) -> bool {
        true
    }

    /// Stress and next state.
    ///
    /// # Errors
    /// Damage has left no number.
    fn step(&self, c: &Self::History, strain: Strain) -> MaterialResult<(Stress, Self::History)> {
        let (was, initial) = (*Self::cycle(c), self.initial());
        let d = strain.value - was.strain;
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: was.stress, tangent: initial + was.softening, damping: 0.0 }, *c));
        }
        let mut t = *c;
        let now = Self::cycle_mut(&mut t);
        now.strain = strain.value;
        if now.loading == 0.0 {
            now.loading = d.signum();
        }
        let beyond = [(1.0, strain.value >= was.extreme[0]), (-1.0, strain.value <= -was.extreme[1])];
        let (value, tangent) = match beyond.into_iter().position(|b| b.1) {
            Some(side) => {
                let s = beyond[side].0;
                now.extreme[side] = s * strain.value;
                if self.turns_beyond() {
                    now.loading = s;
                }
                let (stress, slope) = self.envelope(c, side, s * strain.value);
                (s * stress, slope)
            }
            None => {
                let s = d.signum();
                let (stress, slope) = self.advance(c, d, &mut t, s);
                (s * stress, slope)
            }
        };
        if !(value.is_finite() && tangent.is_finite()) {
            let message = format!("{} has no stress at a strain of {:.6e}: too much damage", Self::NAME, strain.value);
            return Err(MaterialError(message));
        }
        let now = Self::cycle_mut(&mut t);
        now.energy = was.energy + 0.5 * (was.stress + value) * d;
        (now.stress, now.softening) = (value, tangent - initial);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }
}

/// Path from unloading to the largest strain ahead, by a point of pinching. All counts towards the side ahead.
pub(in crate::material) struct Reloading {
    /// Strains where unloading ends, where reloading begins, and of pinching.
    pub(in crate::material) zero: f64,
    pub(in crate::material) release: f64,
    pub(in crate::material) pinch: f64,
    /// Strain and stress of the largest strain ahead.
    pub(in crate::material) target: [f64; 2],
    /// Stress at the point of pinching divided by that of the target.
    pub(in crate::material) share: f64,
    /// Slopes of unloading behind and ahead, degraded.
    pub(in crate::material) slopes: [f64; 2],
    /// The same without degradation.
    pub(in crate::material) elastic: [f64; 2],
}

impl Reloading {
    /// Stress and slope at a strain `x`, which is `d` more than the committed one.
    pub(in crate::material) fn at(&self, x: f64, d: f64, stress: f64) -> (f64, f64) {
        let [k_rear, k_front] = self.slopes;
        let [target, peak] = self.target;
        let unloading = (stress + k_front * d, k_front);
        let lower = |line: (f64, f64)| if unloading.0 < line.0 { unloading } else { line };
        if x < self.zero {
            let sig = stress + k_rear * d;
            if sig >= 0.0 { (0.0, FLAT_SLOPE_RATIO * self.elastic[0]) } else { (sig, k_rear) }
        } else if x < self.pinch {
            if x <= self.release {
                (0.0, FLAT_SLOPE_RATIO * self.elastic[1])
            } else {
                let k = peak * self.share / (self.pinch - self.release);
                lower(((x - self.release) * k, k))
            }
        } else {
            let k = (1.0 - self.share) * peak / (target - self.pinch);
            lower((self.share * peak + (x - self.pinch) * k, k))
        }
    }
}
