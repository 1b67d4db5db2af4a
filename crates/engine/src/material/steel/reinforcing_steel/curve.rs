//! The envelope, and the curve of Menegotto and Pinto between two points with given slopes.

use super::ReinforcingSteel;

/// Strain over which the slope changes at the begin of strain hardening.
const TRANSITION: f64 = 0.0002;

crate::state_struct! {
    /// A curve from one point to another.
    pub struct Curve {
        /// Exponent.
        r: f64,
        /// Stress where the asymptotes meet.
        fch: f64,
        /// Slope of the second asymptote, as a share of that of the first.
        q: f64,
        /// Strain where it begins.
        ea: f64,
        /// Stress there.
        fa: f64,
        /// Slope there.
        ka: f64,
        /// Strain where it ends.
        eb: f64,
        /// Stress there.
        fb: f64,
        /// Slope there.
        kb: f64,
    }
}

impl Curve {
    /// The same with tension and compression exchanged.
    pub(super) fn mirrored(self) -> Self {
        Self { fch: -self.fch, ea: -self.ea, fa: -self.fa, eb: -self.eb, fb: -self.fb, ..self }
    }

    /// Stress at a strain.
    pub(super) fn stress(&self, e: f64) -> f64 {
        let x = self.ka * (e - self.ea);
        let bend = ((x / (self.fch - self.fa)).abs().powf(self.r) + 1.0).powf(1.0 / self.r);
        self.fa + x * (self.q - (self.q - 1.0) / bend)
    }

    /// Slope at a strain.
    pub(super) fn slope(&self, e: f64) -> f64 {
        /// Exponent of a curve that is its first asymptote.
        const STRAIGHT: f64 = 100.0;
        if self.r > STRAIGHT || e == self.ea {
            return self.ka;
        }
        let secant = (self.stress(e) - self.fa) / (e - self.ea);
        let x = (self.ka * (e - self.ea) / (self.fch - self.fa)).abs();
        secant - (secant - self.q * self.ka) / (x.powf(-self.r) + 1.0)
    }

    /// Slopes on either side of the secant, where the ends are too far apart for a curve.
    pub(super) fn with_sound_slopes(mut self) -> Self {
        let secant = self.secant();
        if secant < self.kb {
            self.kb = secant * 0.999;
        }
        if secant > self.ka {
            self.ka = secant * 1.001;
        }
        self.fitted(secant)
    }

    fn secant(&self) -> f64 {
        (self.fb - self.fa) / (self.eb - self.ea)
    }

    /// The curve through both points with both slopes.
    pub(super) fn through(self) -> Self {
        let secant = self.secant();
        self.fitted(secant)
    }

    /// Finds the asymptotes. The iteration stops at a coarse tolerance, which is part of the law (Chang and Mander, 1994).
    fn fitted(mut self, secant: f64) -> Self {
        if self.kb == secant {
            (self.q, self.fch) = (1.0, self.fb);
        } else {
            let at = if secant == self.ka { 0.999_999_99 } else { self.root(secant) };
            self.q = (secant / self.ka - at) / (1.0 - at);
            let b = (1.0 - at.powf(self.r)).powf(1.0 / self.r) / at;
            self.fch = self.fa + self.ka / b * (self.eb - self.ea);
        }
        if (self.eb - self.ea).abs() < 1e-7 {
            self.q = 1.0;
        }
        self
    }

    /// Slope at the end that a trial `a` gives, less the wanted one; the exponent becomes large enough for a solution.
    fn root(&mut self, secant: f64) -> f64 {
        const MAX_ITERATIONS: usize = 50;
        const NEARLY_ONE: f64 = 0.999_999;
        let least = ((self.kb - secant) / (secant - self.ka)).max(0.0);
        if self.r <= least {
            self.r = least + 0.01;
        }
        let (r, ka, kb) = (self.r, self.ka, self.kb);
        let gap = |a: f64| kb - secant * (1.0 - a.powf(r + 1.0)) / (1.0 - a) + ka * a * (1.0 - a.powf(r)) / (1.0 - a);
        let mut low = 0.01;
        for _ in 0..MAX_ITERATIONS {
            if low <= f64::EPSILON || gap(low) * gap(1.0 - low) <= 0.0 {
                break;
            }
            low /= 2.0;
        }
        let mut a = (least / r).min(NEARLY_ONE);
        for _ in 0..MAX_ITERATIONS {
            if a > NEARLY_ONE || low <= f64::EPSILON || gap(a) * gap(1.0 - low) >= 0.0 {
                break;
            }
            a = a.sqrt();
        }
        a = if a >= 1.0 { NEARLY_ONE } else { a };
        for _ in 0..MAX_ITERATIONS {
            let last = a;
            let mut d = (0.49 * (1.0 - a)).min(a / 10.0);
            if a + d >= 1.0 {
                d = (1.0 - a) / 10.0;
            }
            let change = gap(a + d) - gap(a - d);
            if change != 0.0 {
                a = (a - 2.0 * gap(a) * d / change).min(0.999_999_999_99);
                if a < 0.0 {
                    a = 0.0;
                    break;
                }
            }
            if (last - a).abs() < 1e-4 {
                break;
            }
        }
        a.min(0.999_999_99)
    }
}

/// The envelope in natural strain and stress: elastic, yield plateau, strain hardening.
#[derive(Clone, Copy, Debug)]
pub(super) struct Backbone {
    /// Yield strain, stress and modulus.
    pub(super) ey: f64,
    pub(super) fy: f64,
    pub(super) modulus: f64,
    /// Begin of strain hardening.
    pub(super) esh: f64,
    pub(super) fsh: f64,
    pub(super) ksh: f64,
    /// Ultimate stress.
    pub(super) fu: f64,
    eu: f64,
    /// Slope beyond the ultimate stress: constant engineering stress.
    beyond: f64,
    /// Slope of the plateau, and its stress at zero strain.
    plateau: f64,
    intercept: f64,
    exponent: f64,
    /// Begin of the transition to strain hardening, and the slope at its end.
    bend: f64,
    bend_slope: f64,
}

impl Backbone {
    /// Envelope of a bar whose yield plateau is shortened by a share.
    pub(super) fn new(bar: &ReinforcingSteel, shortened: f64) -> Self {
        let (ey, fy, modulus) = bar.yields();
        let engineering = ey.exp_m1();
        let begin = (1.0 - shortened) * (bar.eps_sh - engineering) + engineering;
        let (esh, fsh) = (begin.ln_1p(), fy / (1.0 + engineering) * (1.0 + begin));
        let (eu, beyond) = (bar.eps_ult.ln_1p(), bar.fu * (1.0 + bar.eps_ult));
        let fu = beyond - (eu - esh) * beyond;
        let ksh = bar.esh * (1.0 + begin).powi(2) + fsh - beyond;
        let plateau = (fsh - fy) / (esh - ey);
        let exponent = ksh * (eu - esh) / (fu - fsh);
        let mut made = Self {
            ey,
            fy,
            modulus,
            esh,
            fsh,
            ksh,
            fu,
            eu,
            beyond,
            plateau,
            intercept: fy - plateau * ey,
            exponent,
            bend: 0.0,
            bend_slope: 0.0,
        };
        let after = made.hardening(esh + TRANSITION);
        made.bend_slope = ksh * ((fu - after) / (fu - fsh)).powf(1.0 - 1.0 / exponent);
        made.bend = esh + TRANSITION - 2.0 * (after - fsh) / made.bend_slope;
        made
    }

    fn hardening(&self, e: f64) -> f64 {
        let left = ((self.eu - e) / (self.eu - self.esh)).powf(self.exponent);
        self.fsh + (e - self.esh) * self.beyond + (self.fu - self.fsh) * (1.0 - left)
    }

    /// Stress at a strain of either sign.
    pub(super) fn stress(&self, strain: f64) -> f64 {
        let e = strain.abs();
        let f = if e <= self.bend {
            let slope = self.modulus - self.plateau;
            e * (slope / (1.0 + (slope * e / self.intercept).powi(10)).powf(0.1) + self.plateau)
        } else if e > self.eu {
            self.fu + (e - self.esh) * self.beyond
        } else if e < self.esh + TRANSITION {
            let change = (self.bend_slope - self.plateau) / (2.0 * (self.esh + TRANSITION - self.bend));
            change * (e - self.bend).powi(2) + e * self.plateau + self.intercept
        } else {
            self.hardening(e)
        };
        if strain < 0.0 { -f } else { f }
    }

    /// Slope at a strain of either sign.
    pub(super) fn slope(&self, strain: f64) -> f64 {
        let e = strain.abs();
        if e <= self.bend {
            let slope = self.modulus - self.plateau;
            slope / (1.0 + (slope * e / self.intercept).powi(10)).powf(1.1) + self.plateau
        } else if e > self.eu {
            self.beyond
        } else if e < self.esh + TRANSITION {
            (self.bend_slope - self.plateau) * (e - self.bend) / (self.esh + TRANSITION - self.bend) + self.plateau
        } else {
            let left = ((self.eu - e) / (self.eu - self.esh)).powf(self.exponent);
            self.ksh * left.powf(1.0 - 1.0 / self.exponent) + self.beyond
        }
    }
}
