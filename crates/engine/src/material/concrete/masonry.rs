//! Strut of masonry in an infilled frame (Crisafulli, 1997; Torrisi, 2012): force and shortening.

mod opensees;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Parameters of the strut. Stresses and strains are negative in compression.
#[derive(Clone, Debug, PartialEq)]
pub struct Masonry {
    /// Compressive strength and its strain.
    pub peak: [f64; 2],
    /// Tensile strength.
    pub ft: f64,
    /// Ultimate strain.
    pub ultimate: f64,
    /// Strain at which cracks are closed.
    pub closing: f64,
    /// Initial modulus.
    pub modulus: f64,
    /// Length of the strut.
    pub length: f64,
    /// Area of the strut at first and at last.
    pub area: [f64; 2],
    /// Shortenings, negative, between which the area changes.
    pub shortening: [f64; 2],
    /// Place of the change of slope in reloading, αch.
    pub a_ch: f64,
    /// Growth of the strain where reloading meets the envelope, αre.
    pub a_re: f64,
    /// Stress of the focal point divided by the strength, βa.
    pub b_a: f64,
    /// Stress of the change of slope, βch.
    pub b_ch: f64,
    /// Slopes divided by the modulus: unloading, end of unloading, beginning of reloading.
    pub slopes: [f64; 3],
    /// Exponents of these slopes and of inner cycles.
    pub exponents: [f64; 2],
    /// Falling parabola after the strength; else Sargin's curve goes on.
    pub parabola: bool,
    /// Slips of OpenSees: the initial stiffness is the modulus, and an end slope is divided by a difference of slopes.
    pub compat: bool,
}

crate::state_struct! {
    /// History of [`Masonry`].
    pub struct History {
        /// Deformation.
        strain: f64,
        /// Force.
        force: f64,
        /// Stiffness minus the initial one.
        softening: f64,
        /// Strain of the masonry.
        e: f64,
        /// Stress of the masonry.
        f: f64,
        /// Slope minus the modulus.
        slope: f64,
        /// Branch: a constant of [`branch`].
        branch: f64,
        /// Inner cycles.
        cycles: f64,
        /// 1 after compression on the envelope.
        compressed: f64,
        /// Ends of the curve of unloading or reloading: strain, stress, slope.
        ends: [[f64; 3]; 2],
        /// Strain and stress where the envelope was left.
        unloaded: [f64; 2],
        /// Strain where the last unloading began.
        inner: f64,
        /// Strain, stress and slope where reloading meets the envelope.
        reloaded: [f64; 3],
        /// Plastic strain.
        plastic: f64,
        /// Tensile strength that has been lost.
        lost: f64,
        /// 1 once the area is the last one.
        shrunk: f64,
    }
}

/// Branches, with the numbers of the source less 3.
mod branch {
    pub(super) const ENVELOPE: f64 = -2.0;
    pub(super) const UNLOADS: f64 = -1.0;
    pub(super) const OPEN: f64 = 0.0;
    pub(super) const RELOADS: f64 = 1.0;
    pub(super) const APPROACHES: f64 = 2.0;
    pub(super) const TENSION: f64 = 3.0;
}
use branch::*;

/// Exponent of inner cycles in the stress of the change of slope.
const CYCLE_EXPONENT: f64 = 0.4;
/// Plastic strain of crushed masonry, divided by the strain of the strength.
const CRUSHED: f64 = 1000.0;

/// A stress and its slope.
type Curve = (f64, f64);

/// A trial state on its way.
struct Trial<'a> {
    law: &'a Masonry,
    c: &'a History,
    t: History,
}

impl Masonry {
    /// Stress of the envelope, its slope, and the slope that rules take.
    fn envelope(&self, e: f64) -> (f64, f64, f64) {
        let [fm, um] = self.peak;
        if e > um && self.parabola || e > self.ultimate && !self.parabola {
            let a1 = self.modulus * um / fm;
            let a2 = 1.0 - a1 * um / self.ultimate;
            let x = e / um;
            let d = 1.0 + (a1 - 2.0) * x + a2 * x * x;
            let n = a1 + 2.0 * (a2 - 1.0) * x + (2.0 - a1 - 2.0 * a2) * x * x;
            let slope = fm / um * n / (d * d);
            return (fm * (a1 * x + (a2 - 1.0) * x * x) / d, slope, slope.max(0.0));
        }
        if !self.parabola {
            return (0.0, 0.0, 0.0);
        }
        let length = self.ultimate - um;
        let (f, slope) = (fm * (1.0 - ((e - um) / length).powi(2)), -2.0 * fm * (e - um) / (length * length));
        if f < 0.0 { (f, slope, slope) } else { (0.0, 0.0, slope) }
    }

    /// Initial modulus of the deformation.
    fn stiffness(&self) -> f64 {
        self.modulus * self.area[0] / self.length
    }

    /// Area at a deformation, its rate, and true if it stays.
    fn area(&self, c: &History, d: f64) -> (f64, f64, bool) {
        let ([first, last], [start, end]) = (self.area, self.shortening);
        if first == last || c.shrunk == 1.0 {
            return (last, 0.0, true);
        }
        if d > start {
            (first, 0.0, false)
        } else if d <= end {
            (last, 0.0, true)
        } else {
            let rate = (first - last) / (start - end);
            (first - rate * (start - d), rate, false)
        }
    }
}

impl Trial<'_> {
    fn on(&mut self, branch: f64) {
        self.t.branch = branch;
    }

    fn nothing(&mut self) -> Curve {
        self.on(OPEN);
        (0.0, 0.0)
    }

    fn crushed(&mut self) -> Curve {
        self.t.plastic = CRUSHED * self.law.peak[1];
        self.nothing()
    }

    fn on_envelope(&mut self) -> Curve {
        self.on(ENVELOPE);
        let (f, slope, _) = self.law.envelope(self.t.e);
        (f, slope)
    }

    /// The curve between the ends.
    fn curve(&self) -> Curve {
        let [[u1, s1, e1], [u2, s2, e2]] = self.t.ends;
        let secant = (s2 - s1) / (u2 - u1);
        if secant == 0.0 {
            return (s1, 0.0);
        }
        let b1 = e1 / secant;
        let b3 = 2.0 - e2 / secant * (1.0 + b1);
        let b2 = b1 - b3;
        let x = (self.t.e - u1) / (u2 - u1);
        let (n, d) = (b1 * x + x * x, 1.0 + b2 * x + b3 * x * x);
        (s1 + (s2 - s1) * n / d, secant * ((b1 + 2.0 * x) * d - n * (b2 + 2.0 * b3 * x)) / (d * d))
    }

    fn tensile_strength(&self) -> f64 {
        self.law.ft - self.t.lost
    }

    /// Plastic strain and tensile strength after the envelope has been left.
    fn leave_envelope(&mut self) {
        let ([fm, um], [e, f]) = (self.law.peak, self.t.unloaded);
        let focus = self.law.b_a * fm.abs();
        self.t.plastic = e - (e - focus / self.law.modulus) * f / (f - focus);
        let left = self.t.plastic > um && self.t.plastic <= 0.0 && self.tensile_strength() != 0.0;
        let strength = if left { (self.law.ft * (1.0 - self.t.plastic / um)).max(0.0) } else { 0.0 };
        self.t.lost = self.law.ft - strength;
    }

    /// Slope at the end of unloading, degraded.
    fn end_slope(&self, ratio: f64) -> f64 {
        ratio * self.law.modulus / (1.0 + self.t.unloaded[0] / self.law.peak[1]).powf(self.law.exponents[0])
    }

    /// Unloads from the committed state with a first slope.
    fn unload(&mut self, first: f64, keeps_end: bool) -> Curve {
        let (u1, s1) = (self.c.e, self.c.f);
        let u2 = (u1 - 1.5 * s1 / first).max(self.t.plastic);
        if keeps_end {
            self.t.plastic = u2;
        }
        let secant = -s1 / (u2 - u1);
        let last = self.end_slope(self.law.slopes[1]).min(0.5 * secant);
        self.t.ends = [[u1, s1, first], [u2, 0.0, last]];
        self.on(UNLOADS);
        self.curve()
    }

    /// Point at which reloading meets the envelope, and the change of slope on the way: strain, stress, slope.
    fn prepare_reloading(&mut self) -> [f64; 3] {
        let law = self.law;
        if self.t.inner < self.t.plastic {
            let from = self.c.e.min(self.t.plastic);
            self.t.reloaded[0] += law.a_re * (self.t.inner - from) / (self.t.cycles + 1.0).powf(law.exponents[1]);
            self.t.cycles += 1.0;
        }
        let (stress, _, slope) = law.envelope(self.t.reloaded[0]);
        self.t.reloaded = [self.t.reloaded[0], stress, slope];
        let [e, f] = self.t.unloaded;
        let base = self.t.plastic + law.a_ch * (e - f / (law.slopes[0] * law.modulus) - self.t.plastic);
        let slope = f / (e - base);
        let change = (law.b_ch * stress / (self.t.cycles + 1.0).powf(CYCLE_EXPONENT)).min(0.5 * stress);
        [base + change / slope, change, slope]
    }

    /// Reloads from an open crack.
    fn reload(&mut self) -> Curve {
        let change = self.prepare_reloading();
        if self.t.reloaded[1] >= 0.0 {
            return self.crushed();
        }
        let law = self.law;
        let (u2, s2) = (self.c.e, self.c.f.min(0.0));
        let secant = (s2 - change[1]) / (u2 - change[0]);
        let closed = law.slopes[2] * self.end_slope(law.slopes[0]);
        let first = if self.t.plastic > law.closing {
            closed
        } else {
            let open = 0.15 * closed;
            if law.closing >= u2 && u2 > 0.0 { open } else { open + (u2 / self.t.plastic).abs() * (closed - open) }
        };
        let last = (0.2 * change[2]).min(0.9 * secant).min(first);
        self.t.ends = [change, [u2, s2, last]];
        self.on(RELOADS);
        self.curve()
    }

    /// Goes back to compression during unloading.
    fn turn_during_unloading(&mut self) -> Curve {
        let change = self.prepare_reloading();
        let reloaded = self.t.reloaded;
        if reloaded[1] == 0.0 {
            return self.crushed();
        }
        let (u, s, slope) = (self.c.e, self.c.f, self.law.modulus + self.c.slope);
        if s >= 0.9 * change[1] && u >= 0.9 * change[0] {
            let secant = (s - change[1]) / (u - change[0]);
            self.t.ends = [change, [u, s, (1.2 * slope).min(0.9 * secant)]];
            self.on(RELOADS);
        } else {
            let secant = (reloaded[1] - s) / (reloaded[0] - u);
            let first = (2.0 * slope).max(1.2 * secant).min(self.law.slopes[0] * self.law.modulus);
            let last = if reloaded[2] <= 0.0 { 0.5 * secant } else { reloaded[2] };
            self.t.ends = [[u, s, first], [reloaded[0], reloaded[1], last]];
            self.on(APPROACHES);
        }
        self.curve()
    }

    /// An open crack, or virgin masonry.
    fn open(&mut self, d: f64) -> Curve {
        let (law, e) = (self.law, self.t.e);
        if d >= 0.0 {
            if self.tensile_strength() <= 0.0 {
                return self.nothing();
            }
            self.t.ends[0][0] = 0.0;
            return self.tension(law.modulus * self.tensile_strength() / law.ft, OPEN);
        }
        if e > self.t.plastic && e > law.closing {
            return self.nothing();
        }
        if self.t.compressed == 1.0 {
            return self.reload();
        }
        if e <= 0.0 {
            self.t.compressed = 1.0;
            return self.on_envelope();
        }
        let start = -law.ft / law.modulus;
        let (s1, _, e1) = law.envelope(start);
        self.t.ends = [[start, s1, e1], [e, 0.0, 0.01 * law.modulus]];
        self.on(RELOADS);
        self.curve()
    }

    /// Tension with a slope. At the strength the crack opens on the branch `then`.
    fn tension(&mut self, slope: f64, then: f64) -> Curve {
        let strength = self.tensile_strength();
        let f = slope * (self.t.e - self.t.ends[0][0]);
        if f >= strength {
            self.t.lost = self.law.ft;
            self.on(then);
            return (strength, 0.0);
        }
        self.on(TENSION);
        (f, slope)
    }

    fn respond(&mut self, d: f64) -> Curve {
        let (law, e) = (self.law, self.t.e);
        match self.c.branch {
            ENVELOPE if d < 0.0 => {
                if e <= law.ultimate {
                    return self.crushed();
                }
                self.on_envelope()
            }
            ENVELOPE => {
                self.t.cycles = 0.0;
                (self.t.unloaded, self.t.inner) = ([self.c.e, self.c.f], self.c.e);
                self.t.reloaded[0] = self.c.e;
                self.leave_envelope();
                self.unload(law.slopes[0] * law.modulus, false)
            }
            UNLOADS if e >= self.t.ends[1][0] => {
                if self.tensile_strength() <= 0.0 {
                    return self.nothing();
                }
                self.t.ends[0][0] = self.t.plastic;
                self.tension(law.modulus * self.tensile_strength() / law.ft, TENSION)
            }
            UNLOADS if d > 0.0 => self.curve(),
            UNLOADS => self.turn_during_unloading(),
            RELOADS if d < 0.0 => {
                if e > self.t.ends[0][0] {
                    return self.curve();
                }
                if self.t.compressed != 1.0 {
                    self.t.compressed = 1.0;
                    return self.on_envelope();
                }
                let ([u1, s1, e1], [u2, s2, mut e2]) = (self.t.ends[0], self.t.reloaded);
                if e2 <= 0.0 {
                    e2 = 0.5 * (s2 - s1) / law.end_length([u1, u2], [e1, e2]);
                }
                self.t.ends[1] = [u2, s2, e2];
                self.on(APPROACHES);
                self.curve()
            }
            RELOADS => {
                self.t.inner = self.c.e;
                let first = (2.0 * (law.modulus + self.c.slope)).min(law.slopes[0] * law.modulus);
                self.unload(first, true)
            }
            APPROACHES if e <= self.t.reloaded[0] => self.on_envelope(),
            APPROACHES if d > 0.0 => {
                self.t.inner = self.c.e;
                if self.t.unloaded[0] > self.c.e {
                    self.t.unloaded = [self.c.e, self.c.f];
                    self.t.reloaded[0] = self.c.e;
                    self.t.cycles = 0.0;
                    self.leave_envelope();
                }
                self.unload(law.slopes[0] * law.modulus, false)
            }
            APPROACHES => self.curve(),
            TENSION => {
                let slope = law.modulus * self.tensile_strength() / law.ft;
                let (f, slope) = self.tension(slope, OPEN);
                if f >= 0.0 {
                    return (f, slope);
                }
                if self.t.compressed != 1.0 && e <= 0.0 {
                    self.t.compressed = 1.0;
                    return self.on_envelope();
                }
                self.reload()
            }
            _ => self.open(d),
        }
    }
}

impl UniaxialLaw for Masonry {
    type State = History;
    const NAME: &'static str = "Masonry";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value / self.length;
        let t = History { strain: strain.value, e, ..*c };
        let mut trial = Trial { law: self, c, t };
        let d = e - c.e;
        let (f, slope) = if d.abs() <= f64::EPSILON { (c.f, self.modulus + c.slope) } else { trial.respond(d) };
        let mut t = trial.t;
        (t.f, t.slope) = (f, slope - self.modulus);
        let (area, rate, stays) = self.area(c, strain.value);
        t.shrunk = f64::from(u8::from(stays));
        // Virgin masonry that closes has its stress of zero at any strain, and the slope for what follows.
        let closes = t.compressed != 1.0 && t.branch == RELOADS && t.ends[1][0] == e;
        let slope = if closes { 0.0 } else { slope };
        let (force, tangent) = (f * area, slope * area / self.length + f * rate);
        (t.force, t.softening) = (force, tangent - self.stiffness());
        finite(Self::NAME, strain.value, force, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.reported_stiffness()
    }
}
