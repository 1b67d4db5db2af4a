//! Steel of Giuffrè, Menegotto and Pinto that breaks when a damage index comes to its limit.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Exponent of isotropic hardening.
const HARDENING: f64 = 0.8;
/// Sharpness of the transitions of a broken flange in contact.
const CONTACT_SHARPNESS: f64 = 14.0;
/// Share of the stress at yield, beyond which unloading from contact leaves a plastic strain.
const LINEAR_SHARE: f64 = 0.7;
/// Increment of the strain at which the virgin steel is at rest.
const REST: f64 = 10.0 * f64::EPSILON;

/// A flange with a weld that breaks in tension. The steel is `Steel02` with two strengths. The index is
///
/// DI = (Σ Δσ of tension - m Σ Δσ of compression) / σ_cr, counted beyond σ_min.
///
/// Once it comes to its limit, the flange carries compression alone, after the gap of its plastic strain has closed. The law is that of
/// Galvis and Yen (2021), as OpenSees has it.
#[derive(Clone, Debug, PartialEq)]
pub struct SteelFractureDi {
    /// Yield strength in compression and in tension.
    pub fy: [f64; 2],
    /// Initial modulus.
    pub e0: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Sharpness of the transition R₀.
    pub r0: f64,
    /// Loss of sharpness with the plastic strain: cR₁ and cR₂.
    pub c_r: [f64; 2],
    /// Isotropic hardening: a1, a2 in compression, a3, a4 in tension.
    pub a: [f64; 4],
    /// Critical sum of stresses σ_cr.
    pub critical: f64,
    /// Share of compression that heals, m.
    pub healing: f64,
    /// Stress σ_min up to which nothing counts.
    pub threshold: f64,
    /// Index at which the flange breaks.
    pub limit: f64,
}

crate::state_struct! {
    /// History of [`SteelFractureDi`].
    pub struct History {
        /// 1 towards tension, -1 towards compression, 0 virgin.
        loading: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Smallest and largest strain at a reversal.
        extreme: [f64; 2],
        /// Reference strain of the branch's curvature.
        plastic: f64,
        /// Strain and stress where the asymptotes meet.
        meet: [f64; 2],
        /// Strain and stress at the last reversal.
        turn: [f64; 2],
        /// Damage index.
        index: f64,
        /// 1 once a stress has been counted.
        started: f64,
        /// Last stress that was counted.
        counted: f64,
        /// Last increment of it.
        slope: f64,
        /// Sums of the increments of compression and of tension.
        sums: [f64; 2],
        /// 1 for a broken flange.
        broken: f64,
        /// Strain at which the flange touches, and that at which its force ends.
        contact: [f64; 2],
        /// Strain without force of the branch of contact.
        origin: f64,
        /// Strain and stress of its yield point.
        yielding: [f64; 2],
        /// 1 while the strain of the broken flange grows, -1 while it falls.
        sense: f64,
        /// 1 in contact.
        touches: f64,
    }
}

/// Value and derivative of the curve between two asymptotes of slope 1 and b that meet at a ratio of 1.
pub(super) fn transition(ratio: f64, b: f64, sharpness: f64) -> (f64, f64) {
    let sum = 1.0 + ratio.abs().powf(sharpness);
    let root = sum.powf(1.0 / sharpness);
    (b * ratio + (1.0 - b) * ratio / root, b + (1.0 - b) / (sum * root))
}

impl SteelFractureDi {
    /// Place of the side of a direction among pairs.
    fn side(direction: f64) -> usize {
        usize::from(direction > 0.0)
    }

    /// Begin a branch in a direction at the committed point, or leave the virgin state.
    fn reverse(&self, c: &History, t: &mut History, direction: f64) {
        let side = Self::side(direction);
        let (fy, eps_y, esh) = (self.fy[side], self.fy[side] / self.e0, self.b * self.e0);
        t.loading = direction;
        if c.loading == 0.0 {
            t.extreme = [-self.fy[0] / self.e0, self.fy[1] / self.e0];
            t.meet = [direction * eps_y, direction * fy];
        } else {
            t.extreme[0] = t.extreme[0].min(c.strain);
            t.extreme[1] = t.extreme[1].max(c.strain);
            t.turn = [c.strain, c.stress];
            let [growth, scale] = [self.a[2 * side], self.a[2 * side + 1]];
            let span = (t.extreme[1] - t.extreme[0]) / (2.0 * scale * eps_y);
            let shift = 1.0 + growth * span.powf(HARDENING);
            let intercept = direction * shift * (fy - esh * eps_y);
            let strain = (intercept - c.stress + self.e0 * c.strain) / (self.e0 - esh);
            t.meet = [strain, intercept + esh * strain];
        }
        t.plastic = t.extreme[side];
    }

    /// Stress and tangent of the unbroken steel.
    fn whole(&self, t: &History) -> (f64, f64) {
        let eps_y = self.fy[Self::side(t.loading)] / self.e0;
        let xi = ((t.plastic - t.meet[0]) / eps_y).abs();
        let sharpness = self.r0 * (1.0 - self.c_r[0] * xi / (self.c_r[1] + xi));
        let (length, rise) = (t.meet[0] - t.turn[0], t.meet[1] - t.turn[1]);
        let (share, slope) = transition((t.strain - t.turn[0]) / length, self.b, sharpness);
        (share * rise + t.turn[1], slope * rise / length)
    }

    /// Count a stress into the damage index.
    fn count(&self, t: &mut History, stress: f64) {
        if t.started == 0.0 {
            (t.started, t.counted) = (1.0, stress);
            return;
        }
        let slope = stress - t.counted;
        let direction = if slope == 0.0 { t.slope } else { slope };
        if stress.abs() > self.threshold {
            if direction > 0.0 && stress > self.threshold {
                t.sums[1] += slope.abs();
            } else if t.sums[0] + slope.abs() < t.sums[1] {
                // Compression heals no more than there is.
                t.sums[0] += slope.abs();
            }
        }
        t.index = ((t.sums[1] - self.healing * t.sums[0]) / self.critical).max(0.0);
        (t.counted, t.slope) = (stress, slope);
    }

    /// Yield point of contact from an origin: where the elastic line through it meets the hardening in compression.
    fn yield_point(&self, origin: f64) -> [f64; 2] {
        let (fy, esh) = (self.fy[0], self.b * self.e0);
        let intercept = -fy + esh * fy / self.e0;
        let strain = (intercept + self.e0 * origin) / (self.e0 - esh);
        [strain, intercept + esh * strain]
    }

    /// The flange breaks in this step.
    fn break_off(&self, c: &History, t: &mut History) {
        t.origin = c.strain - c.stress / self.e0;
        t.yielding = self.yield_point(t.origin);
        t.contact = [2.0 * t.origin - t.yielding[0]; 2];
        (t.broken, t.sense, t.touches) = (1.0, 1.0, 1.0);
    }

    /// Stress and tangent of the broken flange.
    fn broken(&self, c: &History, t: &mut History) -> (f64, f64) {
        let step = t.strain - c.strain;
        if t.strain >= t.contact[0] {
            // A flange that opens is about to close next: its sense is that of compression.
            (t.sense, t.touches) = (if step > 0.0 { -1.0 } else { 1.0 }, 0.0);
            return (0.0, 0.0);
        }
        if t.touches == 0.0 {
            (t.touches, t.sense) = (1.0, -1.0);
        }
        if t.sense < 0.0 && step > 0.0 {
            t.sense = 1.0;
            if c.stress < LINEAR_SHARE * t.yielding[1] {
                t.origin = c.strain - c.stress / self.e0;
                t.yielding = self.yield_point(t.origin);
                t.contact[1] = 2.0 * t.origin - t.yielding[0];
            }
        } else if t.sense > 0.0 && step < 0.0 {
            t.sense = -1.0;
        }
        let ([yield_strain, yield_stress], length) = (t.yielding, t.yielding[0] - t.origin);
        if t.sense > 0.0 || t.strain >= 0.5 * (t.origin + yield_strain) {
            if t.strain > t.contact[1] {
                return (0.0, 0.0);
            }
            let (share, slope) = transition((t.strain - yield_strain) / length, 0.0, CONTACT_SHARPNESS);
            return (yield_stress * (share + 1.0), yield_stress / length * slope);
        }
        let (share, slope) = transition((t.strain - t.origin) / length, self.b, CONTACT_SHARPNESS);
        (yield_stress * share, yield_stress / length * slope)
    }
}

impl UniaxialLaw for SteelFractureDi {
    type State = History;
    const NAME: &'static str = "SteelFractureDI";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let mut t = *c;
        t.strain = strain.value;
        let step = t.strain - c.strain;
        let (stress, tangent) = if c.broken != 0.0 {
            self.broken(c, &mut t)
        } else if c.loading == 0.0 && step.abs() < REST {
            (0.0, self.e0)
        } else {
            if c.loading == 0.0 || c.loading * step < 0.0 {
                self.reverse(c, &mut t, if step < 0.0 { -1.0 } else { 1.0 });
            }
            let (stress, tangent) = self.whole(&t);
            self.count(&mut t, stress);
            if t.index >= self.limit {
                self.break_off(c, &mut t);
                (0.0, 0.0)
            } else {
                (stress, tangent)
            }
        };
        t.stress = stress;
        finite(Self::NAME, strain.value, stress, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}
