//! Concrete confined by fibre-reinforced polymer (Lam and Teng, 2003 and 2009, Teng, Jiang, Lam and Luo, 2009).
//!
//! Stresses and strains of the equations are positive in compression.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Tangent of a material that has failed.
const NO_STIFFNESS: f64 = 1e-15;
/// Strain increments without an effect.
const MIN_INCREMENT: f64 = 1e-15;
/// Stiffness in tension below which the concrete is cracked for good, in the units of the script.
const MIN_TENSION_STIFFNESS: f64 = 1.0;
/// Strains between which deterioration begins, and that from which the plastic strain is linear.
const STRAINS: [f64; 3] = [0.001, 0.002, 0.0035];

/// Confined concrete: strengths and strains positive.
#[derive(Clone, Debug, PartialEq)]
pub struct FrpConfinedConcrete02 {
    /// Strength without confinement.
    pub fc0: f64,
    /// Initial modulus.
    pub ec: f64,
    /// Strength with confinement.
    pub fcc: f64,
    /// Ultimate strain.
    pub epscu: f64,
    /// Tensile strength.
    pub ft: f64,
    /// Softening modulus in tension.
    pub ets: f64,
    /// Megapascal per unit of stress, in the plastic strain.
    pub mpa: f64,
}

/// A jacket of fibre-reinforced polymer around a circular column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacket {
    /// Thickness.
    pub thickness: f64,
    /// Elastic modulus.
    pub modulus: f64,
    /// Hoop strain at rupture.
    pub rupture: f64,
    /// Radius of the concrete.
    pub radius: f64,
}

impl Jacket {
    /// Confined strength and ultimate strain of a concrete of given strength and its strain (Teng and others, 2009).
    pub fn confined(&self, fc0: f64, epsc0: f64) -> (f64, f64) {
        let pressure = self.modulus * self.thickness * self.rupture / self.radius;
        let fcc = fc0 * (1.0 + 3.5 * pressure / fc0 - 0.035 * self.rupture / epsc0);
        let epscu = epsc0 * (1.75 + 6.5 * (pressure / fc0).powf(0.8) * (self.rupture / epsc0).powf(0.65));
        (fcc, epscu)
    }
}

crate::state_struct! {
    /// History of [`FrpConfinedConcrete02`].
    pub struct History {
        /// 1 once the variables below hold; the virgin state is all zeros.
        begun: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// 1 if the concrete is loaded, 0 if it is unloaded.
        loads: f64,
        /// 1 if it has failed.
        failed: f64,
        /// Number of unloadings since the envelope, and of those that count.
        cycles: [f64; 2],
        /// Strain and stress where the envelope was left.
        envelope: [f64; 2],
        /// Strain and stress at the last begin of unloading.
        unloading: [f64; 2],
        /// Strain and stress at the last begin of reloading.
        reloading: [f64; 2],
        /// Strain and stress that reloading aims at, and the deteriorated stress there.
        reference: [f64; 3],
        /// Strain at which reloading returns to the envelope.
        back: f64,
        /// 1 if reloading goes straight back to the envelope.
        straight: f64,
        /// Slope of reloading.
        slope: f64,
        /// Plastic strain.
        plastic: f64,
        /// Partial unloading and reloading factors, and the factor of the stress at reloading.
        partial: [f64; 2],
        /// Factor of the strain recovery.
        deterioration: f64,
        /// Strains in tension at the strength and without stress, relative to the plastic strain.
        tension: [f64; 2],
        /// Slopes of unloading and of reloading in tension.
        tension_slope: [f64; 2],
        /// Slope of unloading at zero stress.
        last_slope: f64,
    }
}

impl FrpConfinedConcrete02 {
    fn e2(&self) -> f64 {
        (self.fcc - self.fc0) / self.epscu
    }

    fn epst(&self) -> f64 {
        2.0 * self.fc0 / (self.ec - self.e2())
    }

    fn begin(&self) -> History {
        let first = -self.ft / self.ec;
        History {
            begun: 1.0,
            tangent: self.ec,
            loads: 1.0,
            cycles: [0.0, 1.0],
            deterioration: 1.0,
            tension: [first, first - self.ft / self.ets],
            tension_slope: [self.ec; 2],
            last_slope: self.ec,
            ..History::default()
        }
    }

    fn on_envelope(&self, e: f64) -> (f64, f64) {
        let (ec, e2, fc0) = (self.ec, self.e2(), self.fc0);
        if e <= self.epst() {
            let d = ec - e2;
            (ec * e - (d * e).powi(2) / 4.0 / fc0, ec - d.powi(2) * e / 2.0 / fc0)
        } else if e <= self.epscu {
            (fc0 + e2 * e, e2)
        } else {
            (0.0, NO_STIFFNESS)
        }
    }

    /// Full factor of a deterioration: `at` the counted cycles beyond the second strain, less before it.
    fn full(t: &History, at: f64, rate: f64, end: f64) -> f64 {
        let (count, e) = (t.cycles[1], t.envelope[0]);
        if !(2.0..=5.0).contains(&count) || e <= STRAINS[0] {
            1.0
        } else if e < end {
            1.0 + rate * (e - STRAINS[0])
        } else {
            at
        }
    }

    /// Turn to unloading: reference point and plastic strain.
    fn begin_unloading(&self, c: &History, t: &mut History) {
        t.cycles[0] = if c.stress > c.envelope[1] { 1.0 } else { c.cycles[0] + 1.0 };
        t.unloading = [c.strain, c.stress];
        let e = t.unloading[0];
        if t.cycles[0] == 1.0 {
            t.envelope = t.unloading;
            (t.reference[0], t.reference[1]) = (e, t.unloading[1]);
            let e = t.envelope[0];
            let rate = 0.87 - 0.004 * self.fc0 * self.mpa;
            if e > 0.0 && e <= STRAINS[0] {
                t.plastic = 0.0;
            } else if (STRAINS[0]..STRAINS[2]).contains(&e) {
                t.plastic = (1.4 * rate - 0.64) * (e - STRAINS[0]);
            } else if (STRAINS[2]..=self.epscu).contains(&e) {
                t.plastic = rate * e - 0.0016;
            }
            return;
        }
        if e <= c.reference[0] {
            t.reference[1] = c.reference[2];
        } else {
            (t.reference[0], t.reference[1]) = (e, t.unloading[1]);
        }
        if t.reference[0] - c.plastic != 0.0 {
            t.partial[0] = (e - c.plastic) / (t.reference[0] - c.plastic);
            if t.partial[0] > 0.7 && t.partial[1] > 0.7 {
                t.cycles[1] += 1.0;
            }
        }
        let count = t.cycles[1];
        let rate = 400.0 * (0.0212 * count - 0.12);
        let recovered = Self::full(t, 0.0212 * count + 0.88, rate, STRAINS[2]) - 0.25 * (t.partial[0] - 1.0);
        let omega = recovered.min(1.0);
        t.plastic = (1.0 - omega) * e + omega * c.plastic;
    }

    /// Turn to reloading: deteriorated stress at the reference point.
    fn begin_reloading(&self, c: &History, t: &mut History) {
        t.reloading = if c.strain < c.plastic { [c.plastic, 0.0] } else { [c.strain, c.stress] };
        let n = t.cycles[0];
        if n == 1.0 && t.envelope[1] != 0.0 {
            t.partial[1] = (t.envelope[1] - t.reloading[1]) / t.envelope[1];
        } else if n >= 2.0 && c.reference[2] != 0.0 {
            t.partial[1] = (t.unloading[1] - t.reloading[1]) / c.reference[2];
        }
        let e = t.envelope[0];
        if n == 1.0 {
            t.deterioration = if (0.0..=STRAINS[0]).contains(&e) {
                1.0
            } else if e > STRAINS[0] && e < STRAINS[1] {
                1.0 - 80.0 * (e - STRAINS[0])
            } else {
                0.92
            };
        } else if n >= 2.0 {
            let count = t.cycles[1];
            let rate = 1000.0 * (0.013 * count - 0.075);
            let full = Self::full(t, 0.013 * count + 0.925, rate, STRAINS[1]);
            t.deterioration = (full - 0.2 * (t.partial[1] - 1.0)).min(1.0);
        }
        t.reference[2] = t.deterioration * t.reference[1];
    }

    /// Response of unloading in compression.
    fn unload(&self, t: &mut History, e: f64) -> (f64, f64) {
        let ([top, stress], p) = (t.unloading, t.plastic);
        let power = 350.0 * top + 3.0;
        let first = if top == 0.0 { self.ec } else { 0.5 * self.fc0 / top };
        let second = if top == p { self.ec } else { stress / (top - p) };
        let slope = if first < second { first } else { second };
        let at_p = power * p.powf(power - 1.0);
        let a = (stress - slope * (top - p)) / (top.powf(power) - p.powf(power) - at_p * (top - p));
        let b = slope - at_p * a;
        let c = -a * p.powf(power) - b * p;
        t.last_slope = slope;
        (a * e.powf(power) + b * e + c, a * power * e.powf(power - 1.0) + b)
    }

    /// Response of reloading in compression.
    fn reload(&self, t: &mut History, e: f64) -> Option<(f64, f64)> {
        let ([start, from], [aim, _, lowered]) = (t.reloading, t.reference);
        let [left, top] = t.envelope;
        if e >= start && e <= aim {
            let small = from > 0.85 * top;
            let straight = left <= STRAINS[0] || small && (t.cycles[0] == 1.0 || t.cycles[0] > 1.0 && t.back == left);
            if left != start && straight {
                t.back = left;
                t.slope = (top - from) / (left - start);
                t.straight = 1.0;
            } else if aim != start {
                t.slope = (lowered - from) / (aim - start);
                t.straight = 0.0;
            }
            return Some((from + t.slope * (e - start), t.slope));
        }
        if e <= aim {
            return None;
        }
        if t.straight == 0.0 {
            let (a, b, c) = self.parabola(t);
            if e <= t.back {
                return Some((a * e * e + b * e + c, 2.0 * a * e + b));
            }
        }
        t.cycles[0] = 0.0;
        t.straight = 0.0;
        Some(self.on_envelope(e))
    }

    /// Parabola from the reference point to the envelope, which it touches.
    fn parabola(&self, t: &mut History) -> (f64, f64, f64) {
        let (ec, e2, fc0) = (self.ec, self.e2(), self.fc0);
        let [x, _, y] = t.reference;
        let through = |a: f64, slope: f64| {
            let b = slope - 2.0 * a * x;
            (a, b, y - a * x.powi(2) - b * x)
        };
        let rest = y - fc0 - e2 * x;
        let straight = |slope: f64| through((slope - e2).powi(2) / (4.0 * rest), slope);
        if t.envelope[0] < self.epst() {
            let d = (ec - e2).powi(2);
            let a = (d * (t.slope * x - y) + (ec - t.slope).powi(2) * fc0)
                / (4.0 * (y - ec * x) * fc0 + ((ec - e2) * x).powi(2));
            let curve = through(a, t.slope);
            t.back = (ec - curve.1) / (2.0 * a + d / fc0 / 2.0);
            if !(t.back >= self.epst() && rest != 0.0) {
                return curve;
            }
        } else if rest == 0.0 {
            return (0.0, 0.0, 0.0);
        }
        let curve = straight(t.slope);
        t.back = (e2 - curve.1) / (2.0 * curve.0);
        curve
    }

    fn in_compression(&self, c: &History, t: &mut History, e: f64) -> (f64, f64) {
        if e > self.epscu {
            t.failed = 1.0;
            return (0.0, NO_STIFFNESS);
        }
        if e > c.strain {
            if c.loads == 0.0 || c.strain < c.plastic {
                self.begin_reloading(c, t);
            }
            t.loads = 1.0;
            if t.cycles[0] == 0.0 {
                t.straight = 0.0;
                return self.on_envelope(e);
            }
            return self.reload(t, e).unwrap_or((c.stress, c.tangent));
        }
        if c.loads != 0.0 {
            self.begin_unloading(c, t);
        }
        t.loads = 0.0;
        if t.cycles[0] == 1.0 {
            t.cycles[1] = 1.0;
        }
        let unloaded = self.unload(t, e);
        if e < t.plastic {
            // The step ends beyond the new plastic strain, as the second trial of OpenSees finds it.
            let before = History { strain: c.strain, stress: c.stress, ..*t };
            return self.in_tension(&before, t, e);
        }
        unloaded
    }

    fn in_tension(&self, c: &History, t: &mut History, e: f64) -> (f64, f64) {
        let [first, last] = c.tension;
        if e <= last + c.plastic || c.tension_slope[1].abs() < MIN_TENSION_STIFFNESS {
            t.tension_slope = [0.0; 2];
            return (0.0, NO_STIFFNESS);
        }
        let x = e - c.plastic;
        if e > c.strain {
            if c.loads == 0.0 {
                if c.strain <= first + c.plastic && c.plastic != c.strain {
                    t.tension_slope[1] = -c.stress / (c.plastic - c.strain);
                }
                t.tension_slope[0] = t.tension_slope[1];
            }
            t.loads = 1.0;
            return (x * t.tension_slope[1], t.tension_slope[1]);
        }
        t.loads = 0.0;
        let slope = c.tension_slope[0].min(c.last_slope);
        t.tension_slope[0] = slope;
        t.tension[0] = last / (slope / self.ets + 1.0);
        if x >= t.tension[0] {
            (slope * x, slope)
        } else if x > last {
            (slope * t.tension[0] - self.ets * (x - t.tension[0]), -self.ets)
        } else {
            (0.0, NO_STIFFNESS)
        }
    }
}

impl UniaxialLaw for FrpConfinedConcrete02 {
    type State = History;
    const NAME: &'static str = "FRPConfinedConcrete02";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let begun = if c.begun == 0.0 { self.begin() } else { *c };
        let (c, e) = (&begun, -strain.value);
        if c.failed == 0.0 && (e - c.strain).abs() <= MIN_INCREMENT {
            return Ok((Stress { value: -c.stress, tangent: c.tangent, damping: 0.0 }, *c));
        }
        let mut t = History { strain: e, ..*c };
        let (stress, tangent) = if c.failed != 0.0 {
            (0.0, NO_STIFFNESS)
        } else if e >= c.plastic {
            self.in_compression(c, &mut t, e)
        } else {
            self.in_tension(c, &mut t, e)
        };
        (t.stress, t.tangent) = (stress, tangent);
        finite(Self::NAME, strain.value, -stress, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.ec
    }
}
