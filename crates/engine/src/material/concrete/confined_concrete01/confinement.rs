//! Envelope of concrete in a section with stirrups and jackets. Stresses are in MPa and lengths in mm.
//!
//! The confining pressure comes from plane elasticity with the secant moduli of concrete and steel (Braga, Gigliotti and
//! Laterza, 2006). It grows with the axial strain. Each stress is that of the active confinement of Attard and Setunge (1996).

use super::ConfinedConcrete01;
use std::f64::consts::PI;

/// Distance of the strains of the envelope.
const STEP: f64 = 0.0005;
/// Part of the step by which a strain may pass the ultimate one.
const EXCESS: f64 = 0.1;
/// Largest Poisson's ratio of bounded dilation.
const MAX_POISSON: f64 = 0.5;
/// Poisson's ratio of concrete without load.
const FIRST_POISSON: f64 = 0.2;
/// Stress divided by the strength where Attard and Setunge measure the modulus.
const ELASTIC_SHARE: f64 = 0.45;

/// Shape of a section and of its stirrups (Braga, Gigliotti and Laterza, 2006, figure 8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConfinementSection {
    /// Square, one hoop.
    S1,
    /// Square with cross ties.
    S2,
    /// Square with a diamond.
    S3,
    /// Square with overlapping hoops.
    S4a,
    /// Square with two interlocking hoops.
    S4b,
    /// Square with a spiral.
    S5,
    /// Circle.
    Circular,
    /// Rectangle.
    Rectangular,
}

/// A hoop or a jacket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hoop {
    /// Half of the side, or radius.
    pub semi_length: f64,
    /// Diameter of the bar, 0 for a jacket.
    pub diameter: f64,
    /// Area of the bar.
    pub area: f64,
    /// Second moment of area of the bar.
    pub inertia: f64,
    /// Distance along the column.
    pub spacing: f64,
    /// Yield stress.
    pub yield_stress: f64,
    /// Elastic modulus.
    pub modulus: f64,
    /// Hardening modulus divided by the elastic one.
    pub hardening: f64,
    /// Ultimate strain divided by the yield strain.
    pub ductility: f64,
}

/// End of the envelope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UltimateStrain {
    /// A strain.
    Strain(f64),
    /// The strain where the stress has fallen to a share of the strength, at most `limit`.
    Share {
        /// Stress divided by the strength.
        gamma: f64,
        /// Largest strain.
        limit: f64,
    },
}

/// Poisson's ratio of concrete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dilation {
    /// Constant.
    Constant(f64),
    /// Growing with the strain (Kupfer, 1969), at most 0.5.
    Bounded,
    /// Growing without bound.
    Unbounded,
}

/// A confined section.
#[derive(Clone, Debug, PartialEq)]
pub struct Confinement {
    /// Shape.
    pub section: ConfinementSection,
    /// Hoops in the order of the shape, then the jacket.
    pub hoops: Vec<Hoop>,
    /// Strength of the cylinder, positive.
    pub fpc: f64,
    /// Strength of unconfined concrete in the column divided by that of the cylinder.
    pub strength_ratio: f64,
    /// Modulus at 45 % of the strength.
    pub ec: f64,
    /// End of the envelope.
    pub ultimate: UltimateStrain,
    /// Poisson's ratio.
    pub dilation: Dilation,
    /// Diameter of the longitudinal bars.
    pub bar: f64,
    /// Aggregate of gravel instead of crushed stone.
    pub gravel: bool,
    /// Concrete with silica fume.
    pub silica: bool,
    /// Change of the secant modulus, relative, that ends the iteration.
    pub tolerance: f64,
    /// Largest number of iterations at a strain.
    pub max_iterations: usize,
}

/// Unconfined concrete of Attard and Setunge.
struct Unconfined {
    /// Strength and its strain.
    peak: [f64; 2],
    /// Stress and strain of the inflection after the strength.
    inflection: [f64; 2],
    /// Tensile strength.
    ft: f64,
    /// Initial modulus divided by that at 45 % of the strength.
    alpha: f64,
    /// Initial modulus.
    modulus: f64,
}

/// Curves of one confining pressure.
struct Active {
    strength: f64,
    peak: f64,
    /// Numerator and denominator after the strength.
    falling: [f64; 4],
    rising: [f64; 4],
}

impl Unconfined {
    fn new(c: &Confinement) -> Self {
        let fc = c.fpc * c.strength_ratio;
        let alpha = 1.17 - 0.17 * ((c.fpc - 20.0) / 80.0).clamp(0.0, 1.0);
        let shape = if c.gravel { 3.78 } else { 4.26 };
        let epsc = c.fpc / c.ec * shape / c.fpc.powf(0.25);
        let ft = if c.silica { 0.9 * (0.62 * fc.sqrt()) } else { 0.9 * (0.32 * fc.powf(0.67)) };
        let inflection = [(1.41 - 0.17 * fc.ln()) * fc, (2.5 - 0.3 * fc.ln()) * epsc];
        Self { peak: [fc, epsc], inflection, ft, alpha, modulus: alpha * c.ec }
    }

    /// Curves under a constant pressure.
    fn under(&self, pressure: f64) -> Active {
        let ([fc, epsc], [fic, epsic], alpha) = (self.peak, self.inflection, self.alpha);
        let elastic = ELASTIC_SHARE * fc;
        let rising = |f0: f64, eps0: f64, least: f64| {
            let a = self.modulus * eps0 / f0;
            let share = elastic / f0;
            let first = (a - 1.0).powi(2) / (alpha * (1.0 - share));
            let second = a * a * (1.0 - alpha) / (alpha * alpha * share * (1.0 - share));
            let b = (first + second - 1.0).max(least);
            [a, b, a - 2.0, b + 1.0]
        };
        if pressure == 0.0 {
            let a = fic / (epsc * epsic) * (epsic - epsc).powi(2) / (fc - fic);
            let rising = rising(fc, epsc, f64::NEG_INFINITY);
            return Active { strength: fc, peak: epsc, rising, falling: [a, 0.0, a - 2.0, 1.0] };
        }
        let q = pressure / fc;
        let k = 1.25 * (1.0 + 0.062 * q) * fc.powf(-0.21);
        let f0 = (pressure / self.ft + 1.0).powf(k) * fc;
        let eps0 = (1.0 + (17.0 - 0.06 * fc) * q) * epsc;
        let fi = ((fic / fc - 1.0) / (5.06 * q.powf(0.57) + 1.0) + 1.0) * f0;
        let epsi = ((epsic / epsc - 2.0) / (1.12 * q.powf(0.26) + 1.0) + 2.0) * eps0;
        let unconfined = (1.45 - 0.25 * fc.ln()) * fc;
        let f2i = ((unconfined / fc - 1.0) / (6.35 * q.powf(0.62) + 1.0) + 1.0) * f0;
        let eps2i = 2.0 * epsi - eps0;
        let (near, far) = (fi / epsi / (f0 - fi), 4.0 * (f2i / eps2i) / (f0 - f2i));
        let a = (eps2i - epsi) / eps0 * (eps2i * near - epsi * far);
        let b = (epsi - eps2i) * (near - far);
        Active { strength: f0, peak: eps0, rising: rising(f0, eps0, -1.0), falling: [a, b, a - 2.0, b + 1.0] }
    }
}

impl Active {
    fn stress(&self, e: f64) -> f64 {
        let x = e / self.peak;
        let [a, b, c, d] = if e <= self.peak { self.rising } else { self.falling };
        (a * x + b * x * x) / (1.0 + c * x + d * x * x) * self.strength
    }

    /// Strain of a stress after the strength, if there is one.
    fn strain_at(&self, stress: f64) -> Option<f64> {
        let y = stress / self.strength;
        let [a, b, ..] = self.falling;
        let (half, lead) = (a * (1.0 - y) + 2.0 * y, b * (1.0 - y) - y);
        let x = (-half - (half * half + 4.0 * lead * y).sqrt()) / (2.0 * lead);
        if x <= 0.0 { None } else { Some(x * self.peak) }
    }
}

impl Hoop {
    /// Share of the pressure that acts between hoops.
    fn effectiveness(&self, bar: f64) -> f64 {
        if self.diameter == 0.0 {
            return 1.0;
        }
        let between = (1.0 - self.spacing / (4.0 * self.semi_length)).powi(2).min(1.0);
        let slender = 45.0 * (bar / self.spacing).powi(3);
        let k = slender / (slender + self.diameter / bar * (self.diameter / self.semi_length));
        k.max(between)
    }

    /// Secant modulus at a strain, from the modulus before. A broken hoop keeps its modulus.
    fn secant(&self, strain: f64, modulus: f64) -> f64 {
        let first = self.yield_stress / self.modulus;
        if strain >= first && strain <= self.ductility * first {
            return (self.yield_stress + self.hardening * self.modulus * (strain - first)) / strain;
        }
        modulus
    }

    /// Constants of Airy's function of a square section at an axial strain.
    fn airy(&self, ec: f64, nu: f64, es: f64, e: f64) -> [f64; 2] {
        let (l, s, area, inertia) = (self.semi_length, self.spacing, self.area, self.inertia);
        let bending = 25.0 * s * s * ec * ec * l.powi(4);
        let mixed = 6.0 * s * ec * es * l * (315.0 * inertia * (nu + 1.0) + 2.0 * l * l * area * (2.0 * nu + 5.0));
        let d = bending + mixed - 1890.0 * ec * ec * inertia * area * (nu * nu - 1.0);
        let a = 21.0 * s * ec * ec * es * area * nu * l / d * e;
        let b = 18.0 * ec * es * area * nu * (s * ec * l.powi(3) + 105.0 * es * inertia * (nu + 1.0)) / (l * l * d) * e;
        [a, b]
    }

    /// Tension of a circular hoop at an axial strain.
    fn hoop_tension(&self, ec: f64, nu: f64, es: f64, e: f64) -> f64 {
        let d = self.semi_length * ec * self.spacing + es * self.area * (1.0 - nu) * (nu * e + 1.0);
        ec * es * self.area * nu * self.spacing / d * e
    }
}

/// Constants and secant modulus of one hoop on its way through the strains.
#[derive(Clone, Copy)]
struct HoopState {
    a: f64,
    b: f64,
    modulus: f64,
    effectiveness: f64,
}

impl Confinement {
    /// Strain of the first rupture of a hoop (Scott, Park and Priestley, 1982) for a volumetric ratio of hoops.
    pub fn scott(&self) -> f64 {
        0.004 + 0.9 * self.hoop_ratio() * (self.hoops[0].yield_stress / 300.0)
    }

    /// Volume of the hoops divided by that of the core, without jackets.
    fn hoop_ratio(&self) -> f64 {
        use ConfinementSection::*;
        let (first, root) = (&self.hoops[0], 2f64.sqrt());
        let area = |i: usize| self.hoops[i].area;
        let core = first.spacing * first.semi_length;
        match self.section {
            S1 | Circular => 2.0 * area(0) / core,
            S2 => (2.0 * area(0) + area(1)) / core,
            S3 => (2.0 * area(0) + root * area(1)) / core,
            S4a => (3.0 * area(0) + area(1)) / core,
            S4b => 2.0 * (area(0) + area(1)) / core,
            S5 => 2.0 * (area(0) + (1.0 + root) / 3.0 * area(1)) / core,
            Rectangular => {
                area(0) * (first.semi_length + self.hoops[1].semi_length) / (core * self.hoops[1].semi_length)
            }
        }
    }

    fn is_circular(&self, hoop: usize) -> bool {
        match self.section {
            ConfinementSection::Circular => true,
            ConfinementSection::S5 => hoop == 1,
            _ => false,
        }
    }

    fn poisson(&self, e: f64, epsc: f64) -> f64 {
        let r = e / epsc;
        let kupfer = FIRST_POISSON * (1.0 + 0.2 * r - r * r + 1.55 * r.powi(3));
        match self.dilation {
            Dilation::Constant(nu) => nu,
            Dilation::Bounded => kupfer.min(MAX_POISSON),
            Dilation::Unbounded => kupfer,
        }
    }

    /// Pressure of all hoops and jackets on the whole section, from that of each.
    fn superposed(&self, f: &[f64]) -> f64 {
        use ConfinementSection::*;
        let l = |i: usize| self.hoops[i].semi_length;
        let jacket = |i: usize| self.hoops.len() > i;
        // Two hoops of the sides `a` and `b`, side by side.
        let pair = |a: usize, b: usize| (f[b] * l(b) * l(b) + f[a] * (l(a) - l(b)) * l(b)) / (l(a) * l(b));
        match self.section {
            S1 | Circular if jacket(1) => (l(0) / l(1)).powi(2) * f[0] + f[1],
            S1 | Circular => f[0],
            S2 | S3 if jacket(2) => (f[0] + 0.5 * f[1]) * (l(0) / l(2)).powi(2) + f[2],
            S2 | S3 => f[0] + f[1] / 2.0,
            S4a => {
                let (first, second) = (pair(0, 1), pair(2, 3));
                if jacket(4) {
                    let jacket = l(4) * l(4);
                    first * l(0) * (l(0) + l(3)) / jacket + second * l(3) * l(0) / jacket + f[4]
                } else {
                    (1.0 + l(3) / l(0)) * first + l(3) / l(0) * second
                }
            }
            S4b => {
                let second = pair(1, 2);
                if jacket(3) {
                    f[0] * (l(0) / l(3)).powi(2) + 2.0 * (l(2) * l(0) / (l(3) * l(3))) * second + f[3]
                } else {
                    f[0] + 2.0 * l(2) / l(0) * second
                }
            }
            S5 if jacket(2) => {
                let ratio = (l(0) / l(2)).powi(2);
                f[0] * ratio + f[1] * (PI / 4.0) * ratio + f[2]
            }
            S5 => f[1] * PI / 4.0 + f[0],
            Rectangular if jacket(2) => l(0) * l(1) / (l(2) * l(3)) * pair(0, 1) + pair(2, 3),
            Rectangular => pair(0, 1),
        }
    }

    /// Confining pressure at an axial strain and a secant modulus of concrete; the hoops follow.
    fn pressure(&self, hoops: &mut [HoopState], parts: &mut [f64], ec: f64, nu: f64, e: f64) -> f64 {
        for (j, (hoop, state)) in self.hoops.iter().zip(&mut *hoops).enumerate() {
            let l = hoop.semi_length;
            let circular = self.is_circular(j);
            let strain = if circular {
                state.b * l / (state.modulus * hoop.area)
            } else {
                hoop.spacing * l.powi(3) * (state.a + 3.0 * state.b) / (3.0 * state.modulus * hoop.area)
            };
            state.modulus = hoop.secant(strain, state.modulus);
            parts[j] = if circular {
                state.b = hoop.hoop_tension(ec, nu, state.modulus, e);
                state.effectiveness * (state.b / hoop.spacing)
            } else {
                [state.a, state.b] = hoop.airy(ec, nu, state.modulus, e);
                state.effectiveness * (state.b * l * l)
            };
        }
        self.superposed(parts)
    }

    /// The law of the concrete, and the largest strain at which the iteration did not end.
    ///
    /// # Errors
    /// The envelope has no strength.
    pub fn law(&self) -> Result<(ConfinedConcrete01, Option<f64>), String> {
        let concrete = Unconfined::new(self);
        let [_, epsc] = concrete.peak;
        let (mut ultimate, limit, gamma) = match self.ultimate {
            UltimateStrain::Strain(e) => (e, f64::INFINITY, None),
            UltimateStrain::Share { gamma, limit } => (limit, limit, Some(gamma)),
        };
        let mut hoops: Vec<HoopState> = self
            .hoops
            .iter()
            .map(|h| HoopState { a: 0.0, b: 0.0, modulus: h.modulus, effectiveness: h.effectiveness(self.bar) })
            .collect();
        let mut parts = vec![0.0; hoops.len()];
        let (mut envelope, mut peak, mut ec) = (vec![], [0.0; 2], concrete.modulus);
        let (mut e, mut unfinished) = (0.0, None);
        loop {
            hoops.iter_mut().for_each(|h| (h.a, h.b) = (0.0, 0.0));
            let nu = self.poisson(e, epsc);
            let (mut before, mut halved, mut iterations) = (0.0, false, 0);
            let stress = loop {
                let curves = concrete.under(self.pressure(&mut hoops, &mut parts, ec, nu, e));
                let stress = curves.stress(e);
                if let Some(gamma) = gamma {
                    ultimate = curves.strain_at(gamma * peak[1]).unwrap_or(limit);
                }
                let secant = if stress == 0.0 { concrete.modulus } else { stress / e };
                let change = secant - ec;
                halved |= iterations > 0 && before * change < 0.0;
                let relative = (change / ec).abs();
                ec = if halved { 0.5 * (ec + secant) } else { secant };
                before = change;
                iterations += 1;
                // A secant modulus that is not a number ends the iteration too.
                if !(relative > self.tolerance && iterations < self.max_iterations) {
                    break stress;
                }
            };
            if iterations == self.max_iterations {
                unfinished = Some(e);
            }
            envelope.push([-e, if stress.is_nan() { 0.0 } else { -stress }]);
            if stress > peak[1] {
                peak = [e, stress];
            }
            let next = e + STEP;
            if !(next <= ultimate + EXCESS * STEP && next <= limit + EXCESS * STEP) {
                break;
            }
            e = next.min(ultimate);
        }
        if peak[0] == 0.0 {
            return Err("the confined concrete has no strength".into());
        }
        if ultimate.is_nan() {
            ultimate = e;
        }
        let modulus = concrete.modulus;
        Ok((ConfinedConcrete01 { envelope, peak: -peak[0], ultimate: -ultimate, modulus }, unfinished))
    }
}
