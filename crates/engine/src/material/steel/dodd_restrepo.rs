//! Reinforcing steel with a yield plateau, in true stresses and natural strains (Dodd and Restrepo, 1995).

mod bauschinger;
mod opensees;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};
pub(super) use bauschinger::Bauschinger;

/// Steel of Dodd and Restrepo. A reversal follows a Bauschinger curve to the strength or to a former reversal.
#[derive(Clone, Debug, PartialEq)]
pub struct DoddRestrepo {
    /// Yield stress.
    fy: f64,
    /// Elastic modulus.
    e0: f64,
    /// Natural strain where hardening begins, and that of the strength.
    hardening: [f64; 2],
    /// True stress of the strength.
    strength: f64,
    /// Exponent of the hardening curve.
    power: f64,
    /// Factor of the area of a Bauschinger curve.
    omega: f64,
    /// Bauschinger curves have the round-off of OpenSees' iteration.
    compat: bool,
}

crate::state_struct! {
    /// A reversal.
    pub struct Reversal {
        /// Natural strain and true stress.
        at: [f64; 2],
        /// Natural strain and true stress at the end of the straight line after it.
        end: [f64; 2],
    }
}

crate::state_struct! {
    /// History of [`DoddRestrepo`]. Pairs are for the directions of tension and of compression.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the elastic modulus.
        softening: f64,
        /// Natural strain, and that of the step before.
        natural: [f64; 2],
        /// True stress.
        true_stress: f64,
        /// Tangent of true stress minus the elastic modulus.
        true_softening: f64,
        /// Last reversals.
        last: [Reversal; 2],
        /// Last major reversals.
        major: [Reversal; 2],
        /// Slopes of true stress at the major reversals.
        major_slope: [f64; 2],
        /// Exponents of the curves from the last and from the major reversals.
        exponent: [f64; 2],
        /// The same of the major curves.
        major_exponent: [f64; 2],
        /// Shifts of the skeleton.
        shift: [f64; 2],
        /// Largest shift.
        max_shift: f64,
        /// 1 where a Bauschinger curve stands for the skeleton.
        no_plateau: [f64; 2],
        /// Direction after the last reversal, 0 before the first.
        direction: f64,
        /// 1 after fracture.
        broken: f64,
    }
}

/// Exponent of curves to a former reversal.
const MINOR_EXPONENT: f64 = 0.35;
/// Bounds of the area of a Bauschinger curve (Restrepo, 2011).
const OMEGA: [f64; 2] = [0.05, 0.085];
/// Natural strain by which a reversal's distance to the ultimate strain is divided.
const REFERENCE_STRAIN: f64 = 0.2;
/// Strain before the skeleton where it is taken already.
const MARGIN: f64 = 1e-5;

impl DoddRestrepo {
    /// Of the engineering values yield stress, strength, strains where hardening begins and of the strength, modulus, a
    /// strain and stress on the hardening curve, the factor of the Bauschinger curves, and the unit of the strains.
    ///
    /// # Errors
    /// No hardening curve goes through the three points.
    pub fn new(
        stress: [f64; 2],
        strain: [f64; 2],
        e0: f64,
        inner: [f64; 2],
        omega: f64,
        unit: f64,
    ) -> Result<Self, String> {
        let ([fy, fsu], [esh, esu], [eshi, fshi]) = (stress, strain.map(|e| e / unit), [inner[0] / unit, inner[1]]);
        let (start, end, middle) = (esh.ln_1p(), esu.ln_1p(), eshi.ln_1p());
        let strength = fsu * (1.0 + esu);
        let rise = fy * (1.0 + esh) - strength + strength * (end - start);
        let share = (fshi * (1.0 + eshi) + strength * (end - middle) - strength) / rise;
        let power = share.ln() / ((end - middle) / (end - start)).ln();
        if !(power.is_finite() && end > start && strength > 0.0) {
            return Err("no hardening curve goes through (ESH, Fy), (ESHI, FSHI) and (ESU, Fsu)".into());
        }
        Ok(Self { fy, e0, hardening: [start, end], strength, power, omega: omega.clamp(0.65, 1.15), compat: false })
    }

    /// The same with the iteration of OpenSees.
    pub fn compat(self, compat: bool) -> Self {
        Self { compat, ..self }
    }

    fn unloading(&self, t: &History) -> f64 {
        if t.max_shift == 0.0 {
            return self.e0;
        }
        self.e0 * (self.constant(0.82) + 1.0 / (self.constant(5.55) + 1000.0 * t.max_shift))
    }

    /// Exponent of a major Bauschinger curve in direction `k`.
    fn major_exponent(&self, t: &History, s: f64, k: usize) -> f64 {
        let [_, ultimate] = self.hardening;
        let end = t.last[1 - k].end;
        let whole = self.strength * (2.0 - (ultimate + t.shift[0]) + (t.shift[1] - ultimate));
        let part = self.strength * (s - (s * ultimate + t.shift[k]) + end[0]) - end[1];
        let c = |x| self.constant(x);
        let reference = c(REFERENCE_STRAIN);
        let distance = ((reference * s + t.shift[k] - end[0]) / reference).abs();
        let slope = (c(0.001) + c(1.08e-3) / (c(1.043) - distance)) / c(0.18);
        let area = slope * ((part / whole).abs() - c(0.69)) + c(0.085);
        let omega = area.clamp(c(OMEGA[0]), c(OMEGA[1])) * self.omega - c(0.077);
        c(56.689) * omega * omega - c(4.921) * omega + c(0.1)
    }

    /// Changes the history by a reversal to direction `s`; `k` is the index of that direction.
    fn reverse(&self, c: &History, t: &mut History, s: f64, k: usize) {
        let m = 1 - k;
        let (e, f) = (c.natural[0], c.true_stress);
        let elastic = t.shift == [0.0, 0.0] && e.abs() < self.fy / self.e0;
        let on_line = t.direction * s == -1.0 && (e - t.last[k].end[0]) * s >= 0.0
            || t.direction * s == 1.0 && (e - t.last[m].at[0]) * s >= 0.0;
        if elastic || on_line {
            return;
        }
        let permanent = e - f / self.unloading(t);
        let farther = s * t.shift[k] > s * permanent;
        if farther {
            t.shift[k] = permanent;
            t.max_shift = t.max_shift.max(permanent.abs());
        }
        t.direction = s;
        t.last[m] = Reversal { at: [e, f], end: [e + s * self.fy / self.unloading(t), f + s * self.fy] };
        let (major, other) = (t.major[m], t.major[k]);
        let from_skeleton = (t.no_plateau[k] == 0.0 || t.no_plateau[m] == 0.0) && farther;
        let far = s * (other.at[1] - f) > 2.0 * self.fy;
        let passed = t.no_plateau[k] == 1.0 && (e - other.end[0]) / (major.at[0] - other.end[0]) > 1.0;
        t.exponent[k] = self.constant(MINOR_EXPONENT);
        if from_skeleton || far || passed {
            t.major[m] = t.last[m];
            t.major_slope[m] = self.e0 + c.true_softening;
            (t.last[k].at[0], t.major[k].at[0]) = (e, e);
            if t.shift[1] - t.shift[0] >= self.hardening[0] - self.fy / self.e0 {
                t.no_plateau[k] = 1.0;
                t.exponent[k] = self.major_exponent(t, s, k);
            }
            t.major_exponent[k] = t.exponent[k];
        } else if (e - major.at[0]) * s < 0.0 {
            t.major[m].at = [e, f];
            t.major_slope[m] = self.e0 + c.true_softening;
        }
    }

    /// True stress and its slope.
    fn skeleton(&self, t: &History, e: f64, s: f64, k: usize) -> (f64, f64) {
        let [start, ultimate] = self.hardening;
        let x = s * (e - t.shift[k]);
        if x - self.fy / self.e0 <= start - self.fy / self.e0 {
            let f = self.fy * (s * e).exp();
            return (s * f, f);
        }
        let rise = self.fy * start.exp() - self.strength + self.strength * (ultimate - start);
        let (rest, length) = (ultimate - x, ultimate - start);
        let curve = rise * (rest / length).powf(self.power);
        let slope = -self.power * (rise / length) * (rest / length).powf(self.power - 1.0) + self.strength;
        (s * (curve - self.strength * rest + self.strength), slope)
    }

    /// True stress and its slope at a natural strain in direction `s`.
    fn respond(&self, t: &mut History, e: f64, s: f64, k: usize) -> (f64, f64) {
        let (m, unloading, yielding) = (1 - k, self.unloading(t), self.fy / self.e0);
        let opposite = t.direction * s == -1.0;
        let curved = opposite && e * s > t.last[k].at[0] * s || t.direction * s == 1.0 && e * s > t.last[m].end[0] * s;
        let beyond = s * (e - t.major[k].at[0]) > 0.0;
        let toward_skeleton = s * (e - t.shift[m] - s * self.fy / unloading) >= -self.constant(MARGIN);
        if t.no_plateau[k] != 1.0 {
            if t.shift == [0.0, 0.0] && e.abs() <= yielding {
                return (e * self.e0, self.e0);
            }
            if toward_skeleton {
                return self.skeleton(t, e, s, k);
            }
        }
        if !curved {
            let from = if opposite { t.last[k].at } else { t.last[m].at };
            return (from[1] + (e - from[0]) * unloading, unloading);
        }
        let mut curve = Bauschinger {
            from: t.last[m].end,
            to: t.major[k].at,
            slopes: [unloading, t.major_slope[k]],
            power: t.exponent[k],
        };
        let hardens = t.no_plateau[k] != 1.0 && (t.major[k].at[0] - t.shift[k]) * s >= self.hardening[0];
        let mut moving = 0.0;
        if !beyond || hardens {
            t.major_slope[k] = curve.final_slope();
        } else if t.no_plateau[k] == 1.0 {
            curve.from = t.major[m].end;
            curve.to = [s * self.hardening[1] + t.shift[k], s * self.strength];
            (curve.slopes[1], curve.power) = (self.strength, t.major_exponent[k]);
        } else {
            // The end of the curve moves with the strain, as its stress is an engineering one.
            moving = self.fy * s * e.exp();
            curve.from = t.major[m].end;
            curve.to = [t.shift[m] + s * self.fy / unloading, moving];
            curve.slopes[1] = self.fy;
        }
        self.on_curve(&curve, e, moving)
    }
}

impl UniaxialLaw for DoddRestrepo {
    type State = History;
    const NAME: &'static str = "Dodd_Restrepo";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        if (strain.value - c.strain).abs() <= f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.e0 + c.softening, damping: 0.0 }, *c));
        }
        let mut t = *c;
        let e = strain.value.ln_1p();
        let delta = e - c.natural[0];
        let (s, k) = if delta > 0.0 { (1.0, 0) } else { (-1.0, 1) };
        (t.strain, t.natural) = (strain.value, [e, c.natural[0]]);
        if c.broken == 1.0 || e * s > self.hardening[1] + s * t.shift[k] {
            t.broken = 1.0;
            (t.stress, t.true_stress, t.softening, t.true_softening) = (0.0, 0.0, -self.e0, -self.e0);
            return Ok((Stress::default(), t));
        }
        if (c.natural[0] - c.natural[1]) * delta < 0.0 {
            self.reverse(c, &mut t, s, k);
        }
        let (true_stress, slope) = self.respond(&mut t, e, s, k);
        let stretch = 1.0 + strain.value;
        let (value, tangent) = (true_stress / stretch, (slope - true_stress) / (stretch * stretch));
        (t.true_stress, t.true_softening) = (true_stress, slope - self.e0);
        (t.stress, t.softening) = (value, tangent - self.e0);
        finite(Self::NAME, strain.value, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}
