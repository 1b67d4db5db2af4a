//! Reinforcing steel of Dodd and Restrepo, renewed: curves that rejoin the skeleton, softening in tension after the strength
//! (Kim and Koutromanos, 2016; Carreño, Lotfizadeh, Conte and Restrepo, 2020).

mod curves;
mod opensees;
mod reversal;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};
pub use curves::BauschingerKind;
use curves::{Curve, End};

/// Stiffness that the law reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReportedStiffness {
    /// Tangent.
    Tangent,
    /// Tangent, or the secant from the last reversal if that is more.
    Secant,
    /// Elastic modulus.
    Elastic,
}

/// Parameters in engineering stresses and strains.
#[derive(Clone, Debug, PartialEq)]
pub struct SteelDrc {
    /// Elastic modulus.
    pub e: f64,
    /// Yield stress.
    pub fy: f64,
    /// Strain where hardening begins.
    pub hardening: f64,
    /// Strain and stress of the strength.
    pub ultimate: [f64; 2],
    /// Exponent of the hardening curve.
    pub power: f64,
    /// Strain of fracture; without it the engineering stress stays at the strength.
    pub fracture: Option<f64>,
    /// Factor of the area of a Bauschinger curve.
    pub omega: f64,
    /// Length of the straight line after a reversal, divided by the yield stress.
    pub straight: f64,
    /// Kind of Bauschinger curve.
    pub curve: BauschingerKind,
    /// Reported stiffness.
    pub stiffness: ReportedStiffness,
    /// Coefficient and exponent of a dashpot beside the steel.
    pub viscous: [f64; 2],
    /// The reported stiffness is bounded and lacks the dashpot, as in OpenSees.
    pub compat: bool,
}

crate::state_struct! {
    /// A point of a curve: natural strain, true stress, slope.
    pub struct Point {
        /// Natural strain.
        e: f64,
        /// True stress.
        f: f64,
        /// Slope.
        k: f64,
    }
}

crate::state_struct! {
    /// History of [`SteelDrc`]. Pairs are for the directions of tension and of compression.
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the elastic modulus.
        softening: f64,
        /// Committed point; its slope is less the elastic modulus.
        at: Point,
        /// Direction after the last reversal, 0 before the first.
        direction: f64,
        /// Shifts of the skeleton.
        shift: [f64; 2],
        /// Largest shift.
        max_shift: f64,
        /// Last reversal.
        last: Point,
        /// Natural strain and true stress at the end of the straight line after a reversal.
        line: [[f64; 2]; 2],
        /// Points on the yield plateau where curves rejoin the skeleton.
        rejoin: [Point; 2],
        /// 1 if there is no such point.
        no_rejoin: [f64; 2],
        /// Points of the strength where curves rejoin the skeleton.
        far: [Point; 2],
        /// 1 if the point differs from that of virgin steel.
        far_moved: [f64; 2],
        /// Major reversals.
        major: [Point; 2],
        /// 1 if the curve of a direction comes from the skeleton, -1 if it goes there, else 0.
        from_skeleton: [f64; 2],
        /// Natural strain and true stress at the end of the straight line after a major reversal.
        major_line: [[f64; 2]; 2],
        /// 1 or 2 beyond the strength in tension or in compression, -1 after fracture.
        fractured: f64,
        /// 1 after hardening has begun.
        hardened: f64,
    }
}

/// Rate without a viscous stress.
const MIN_RATE: f64 = 1e-10;
/// Bounds of the area of a Bauschinger curve.
const OMEGA: [f64; 2] = [0.05, 0.085];
/// Area of curves to a former reversal.
const MINOR_OMEGA: f64 = 0.04;
/// Natural strain by which the distance of a reversal is divided.
const REFERENCE_STRAIN: f64 = 0.2;

impl SteelDrc {
    /// Exponent of the hardening curve through a point (strain, stress).
    pub fn power_through(&self, [strain, stress]: [f64; 2]) -> f64 {
        let (start, end, fu) = (self.hardening_n(), self.ultimate_n(), self.strength_n());
        let (e, f) = (strain.ln_1p(), stress * (1.0 + strain));
        let rise = self.fy * start.exp() + fu * (end - start) - fu;
        ((f + fu * (end - e) - fu) / rise).ln() / ((end - e) / (end - start)).ln()
    }

    fn hardening_n(&self) -> f64 {
        self.hardening.ln_1p()
    }

    fn ultimate_n(&self) -> f64 {
        self.ultimate[0].ln_1p()
    }

    fn strength_n(&self) -> f64 {
        self.ultimate[1] * (1.0 + self.ultimate[0])
    }

    fn unloading(&self, t: &History) -> f64 {
        self.e * (0.82 + 1.0 / (5.55 + 1000.0 * t.max_shift.abs()))
    }

    /// The far end of curves in a direction.
    fn far(&self, t: &History, k: usize) -> Point {
        if t.far_moved[k] == 1.0 {
            return t.far[k];
        }
        let (s, f) = (if k == 0 { 1.0 } else { -1.0 }, self.strength_n());
        Point { e: s * self.ultimate_n(), f: s * f, k: f }
    }

    /// True stress and slope of the skeleton, which notes hardening and fracture.
    fn skeleton(&self, t: &mut History, e: f64) -> Curve {
        let (s, x) = (if e < 0.0 { -1.0 } else { 1.0 }, e.abs());
        let (start, end, fu) = (self.hardening_n(), self.ultimate_n(), self.strength_n());
        if x <= (self.fy / self.e).ln_1p() {
            return (self.e * e.exp() * e.exp_m1(), self.e * e.exp() * (2.0 * e.exp() - 1.0));
        }
        if x < start {
            let f = self.fy * x.exp();
            return (s * f, f);
        }
        t.hardened = 1.0;
        if x <= end {
            let rise = self.fy * start.exp() + fu * (end - start) - fu;
            let rest = (end - x) / (end - start);
            let slope = -self.power * rise / (end - start) * rest.powf(self.power - 1.0) + fu;
            return (s * (rise * rest.powf(self.power) - fu * (end - x) + fu), slope);
        }
        if e < 0.0 {
            t.fractured = 2.0;
            return (fu * (e + end - 1.0), fu);
        }
        t.fractured = 1.0;
        let Some(fracture) = self.fracture.map(f64::ln_1p) else {
            let f = self.ultimate[1] * e.exp();
            return (f, f);
        };
        let a = -fu * (1.0 + fracture - end) / (fracture - end).powi(2);
        let f = a * (e - fracture) * (e + fracture - 2.0 * end) - fu * (fracture - end);
        if f <= 0.0 {
            t.fractured = -1.0;
            return (0.0, 0.0);
        }
        (f, 2.0 * a * (e - end) + fu)
    }

    /// Area of a Bauschinger curve from the end of a straight line.
    fn area(&self, t: &History, [e, f]: [f64; 2], shift: f64, s: f64, k: usize) -> f64 {
        let ends = [self.ultimate_n() + t.shift[0], -self.ultimate_n() + t.shift[1]];
        let fu = self.strength_n();
        let (part, whole) = (fu * (s - ends[k] + e) - f, fu * (2.0 - ends[0] + ends[1]));
        let distance = (REFERENCE_STRAIN * s + shift - e).abs() / REFERENCE_STRAIN;
        let area = (0.001 + 0.00108 / (1.043 - distance)) / 0.18 * ((part / whole).abs() - 0.69) + 0.085;
        area.clamp(OMEGA[0], OMEGA[1]) * self.omega
    }

    /// A major curve in direction `s` from the end of a straight line with the area at another one.
    fn major(&self, t: &History, (from, to): ([f64; 2], Point), area_at: ([f64; 2], f64), s: f64, e: f64) -> Curve {
        let k = usize::from(s < 0.0);
        let omega = self.area(t, area_at.0, area_at.1, s, k);
        let ends = [End::new(from, self.unloading(t)), End::new([to.e, to.f], to.k)];
        self.curve.at(ends, omega, Some(self.turn(omega)), e)
    }

    fn minor(&self, t: &History, k: usize, to: Point, e: f64) -> Curve {
        let ends = [End::new(t.line[k], self.unloading(t)), End::new([to.e, to.f], to.k)];
        self.curve.at(ends, MINOR_OMEGA, None, e)
    }

    /// Position of the inner points of a rational curve, by its area.
    fn turn(&self, omega: f64) -> f64 {
        let (yielding, gain) = (self.fy / self.e, (self.ultimate[1] - self.fy) / self.ultimate[1]);
        let slope = 17034.0 * yielding - 85.66;
        let (w0, w1, w3) = (0.04, 0.069 * gain + 0.0555, 0.0753 * gain + 0.0691);
        let joint = (0.404 - w3 * slope) / (10.1 - slope);
        let w2 = (w3 - joint) * (self.power - 1.0) / (84.0 + self.power) * w1 / joint + joint;
        if omega <= w0 || omega >= w3 {
            return 0.0;
        }
        if omega <= w1 {
            return 10.1 * (omega - w0);
        }
        if omega > w2 {
            return slope * (omega - w3);
        }
        let [b1, b2, b3] = [10.1 * (w1 - w0), 10.1 * (joint - w0), slope * (w2 - w3)];
        let bend = w2 - 2.0 * joint + w1;
        let root = ((2.0 * (joint - w1)).powi(2) - 4.0 * bend * (w1 - omega)).sqrt();
        let u = (2.0 * (w1 - joint) + root) / (2.0 * bend);
        (1.0 - u).powi(2) * b1 + 2.0 * u * (1.0 - u) * b2 + u * u * b3
    }

    /// True stress and slope at a natural strain in direction `s`.
    fn respond(&self, t: &mut History, e: f64, s: f64, k: usize) -> Curve {
        if t.fractured == -1.0 {
            return (0.0, 0.0);
        }
        if t.shift == [0.0, 0.0] {
            return self.skeleton(t, e);
        }
        let (d, unloading, last) = (t.direction, self.unloading(t), usize::from(t.direction < 0.0));
        if d * t.last.e < d * e && d * e < d * t.line[last][0] {
            return (unloading * (e - t.last.e) + t.last.f, unloading);
        }
        let (joins, far) = (t.no_rejoin[k] != 1.0, self.far(t, k));
        if joins && s * e > s * t.rejoin[k].e || s * e > s * far.e {
            return self.skeleton(t, e - t.shift[k]);
        }
        let ([line_e, line_f], major) = (t.line[k], t.major[k]);
        let area_at = (t.major_line[k], t.shift[k]);
        let reach = |slope: f64| s * (line_f + slope * (major.e - line_e));
        if (reach(major.k) > s * major.f || reach(unloading) < s * major.f) && t.hardened == 1.0 {
            return self.major(t, (t.line[k], far), area_at, s, e);
        }
        if !joins && (s * e > s * major.e || t.from_skeleton[k] == 1.0) {
            return self.major(t, (t.major_line[k], far), area_at, s, e);
        }
        self.minor(t, k, if joins { t.rejoin[k] } else { major }, e)
    }

    /// Reported stiffness.
    fn reported(&self, t: &History, strain: f64, value: f64, tangent: f64) -> f64 {
        match self.stiffness {
            ReportedStiffness::Elastic => self.e,
            ReportedStiffness::Secant if (strain - t.last.e).abs() > f64::EPSILON => {
                self.bounded(tangent.max((value - t.last.f) / (strain - t.last.e)))
            }
            _ => self.bounded(tangent),
        }
    }
}

impl UniaxialLaw for SteelDrc {
    type State = History;
    const NAME: &'static str = "SteelDRC";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        if (strain.value - c.strain).abs() < f64::EPSILON {
            let tangent = self.reported(c, c.strain, c.stress, self.e + c.softening);
            return Ok((Stress { value: c.stress, tangent, damping: 0.0 }, *c));
        }
        let mut t = *c;
        let e = strain.value.ln_1p();
        let (s, k) = if e - c.at.e > 0.0 { (1.0, 0) } else { (-1.0, 1) };
        if (c.at.e - t.last.e) * (e - c.at.e) < 0.0 {
            self.reverse(&mut t, s, k);
        }
        let (f, slope) = self.respond(&mut t, e, s, k);
        t.strain = strain.value;
        t.at = Point { e, f, k: slope - self.e };
        let stretch = 1.0 + strain.value;
        let (mut value, tangent) = (f / stretch, (slope - f) / (stretch * stretch));
        let ([c_visc, alpha], rate, mut damping) = (self.viscous, strain.rate.abs(), 0.0);
        if c_visc != 0.0 && rate > MIN_RATE {
            let force = c_visc * rate.powf(alpha);
            value += force.copysign(strain.rate);
            damping = self.damping(alpha * force / rate);
        }
        (t.stress, t.softening) = (value, tangent - self.e);
        let reported = self.reported(&t, strain.value, value, tangent);
        let (stress, t) = finite(Self::NAME, strain.value, value, reported, t)?;
        Ok((Stress { damping, ..stress }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }

    fn is_viscous(&self) -> bool {
        self.viscous[0] != 0.0
    }
}
