//! Backbone curves (`hystereticBackbone`), and the elastic law that follows one.

use crate::material::{
    Material, MaterialError, MaterialResult, Strain, Stress, Uniaxial, UniaxialRoles, UniaxialTraits,
    updates_each_point,
};
use std::sync::Arc;

/// Slope of a horizontal branch divided by the elastic slope.
const FLAT_SLOPE_RATIO: f64 = 1.0e-9;

/// A curve of stress over strain.
#[derive(Clone, Debug)]
pub enum Backbone {
    /// Straight lines from the origin through points (strain, stress), horizontal behind the last. Negative strains
    /// continue the first line.
    Multilinear(Vec<(f64, f64)>),
    /// `k1` atan(`k2` strain).
    Arctangent {
        /// Stress divided by 2/π at large strains.
        k1: f64,
        /// Factor of the strain.
        k2: f64,
    },
    /// Concrete under compression, positive here (Mander, Priestley and Park, 1988); nothing at negative strains.
    Mander {
        /// Strength.
        fc: f64,
        /// Strain at the strength.
        epsc: f64,
        /// Initial modulus.
        e: f64,
    },
    /// Reinforcing steel (Raynor, Lehman and Stanton, 2002).
    Raynor {
        /// Elastic modulus.
        es: f64,
        /// Yield stress.
        fy: f64,
        /// Ultimate stress.
        fsu: f64,
        /// Strains at the begin of hardening and at the ultimate stress.
        strain: [f64; 2],
        /// Exponent of hardening.
        c1: f64,
        /// Modulus of the yield plateau.
        ey: f64,
    },
    /// A soil around a pile.
    Soil(SoilCurve),
    /// The virgin curve of a uniaxial material, in compression with the sign -1.
    Material(Material, f64),
    /// Another curve up to a strain, then a line to a residual stress.
    LinearCapped {
        /// The other curve.
        inner: Arc<Backbone>,
        /// Strain of the cap.
        cap: f64,
        /// Slope behind it.
        slope: f64,
        /// Residual stress.
        residual: f64,
    },
}

/// Resistance of a soil per length of a pile over the displacement; odd.
#[derive(Clone, Debug, PartialEq)]
pub enum SoilCurve {
    /// Sand (Reese, Cox and Koop, 1974): initial stiffness, two points (displacement, resistance).
    Sand {
        /// Initial stiffness.
        kx: f64,
        /// Begin and end of the straight part.
        points: [(f64, f64); 2],
    },
    /// Soft clay (Matlock, 1970).
    SoftClay {
        /// Ultimate resistance.
        pu: f64,
        /// Displacement at half the ultimate resistance.
        y50: f64,
        /// Exponent n.
        n: f64,
    },
    /// Stiff clay below the water table (Reese, Cox and Koop, 1975).
    StiffClayBelowWater {
        /// Initial stiffness.
        esi: f64,
        /// Reference displacement.
        y50: f64,
        /// Coefficient As.
        a: f64,
        /// Ultimate resistance.
        pc: f64,
    },
    /// Stiff clay above the water table (Welch and Reese, 1972).
    StiffClayAboveWater {
        /// Ultimate resistance.
        pu: f64,
        /// Displacement at half the ultimate resistance.
        y50: f64,
        /// Displacement of the linear part over y50.
        linear: f64,
    },
    /// Vuggy limestone (Reese and Nyman, 1978).
    VuggyLimestone {
        /// Diameter of the pile.
        diameter: f64,
        /// Shear strength.
        strength: f64,
    },
    /// Cemented soil (Ismael, 1990).
    CementedSoil {
        /// Resistances at b/60 and 3b/80.
        resistance: [f64; 2],
        /// Stiffness at the depth.
        stiffness: f64,
        /// Diameter of the pile.
        diameter: f64,
    },
    /// Weak rock (Reese, 1997).
    WeakRock {
        /// Initial stiffness.
        kir: f64,
        /// Ultimate resistance.
        pur: f64,
        /// Reference displacement.
        yrm: f64,
    },
}

impl SoilCurve {
    /// Resistance and stiffness at a displacement without sign.
    fn at(&self, y: f64) -> (f64, f64) {
        match *self {
            Self::Sand { kx, points: [(ym, pm), (yu, pu)] } => {
                let m = (pu - pm) / (yu - ym);
                let n = pm / (m * ym);
                let c = pm / ym.powf(1.0 / n);
                let yk = (c / kx).powf(n / (n - 1.0));
                if y <= yk {
                    (kx * y, kx)
                } else if y <= ym {
                    (c * y.powf(1.0 / n), c / n * y.powf(1.0 / n - 1.0))
                } else if y <= yu {
                    (pm + m * (y - ym), m)
                } else {
                    (pu, 0.001 * kx)
                }
            }
            Self::SoftClay { pu, y50, n } => {
                let (power, least) = (1.0 / n, 0.001 * y50);
                let first = pu * 0.5 * 0.001f64.powf(power) / least;
                if y > 2f64.powf(n) * y50 {
                    (pu, 0.001 * pu / y50)
                } else if y > least {
                    (pu * 0.5 * (y / y50).powf(power), pu / (2.0 * n * y50) * (y50 / y).powf(1.0 - power))
                } else {
                    (first * y, first)
                }
            }
            Self::StiffClayBelowWater { esi, y50, a, pc } => {
                let (y1, y2) = (0.25 * pc * pc / (y50 * esi * esi), a * y50);
                let root = || (0.5 * pc * (y / y50).sqrt(), 0.25 * pc / y50 * (y / y50).powf(-0.5));
                if y <= y1 {
                    (esi * y, esi)
                } else if y <= y2 {
                    root()
                } else if y <= 6.0 * y2 {
                    let (x, (p, k)) = ((y - y2) / y2, root());
                    (p - 0.055 * pc * x.powf(1.25), k - 0.06875 * pc / y2 * x.powf(0.25))
                } else if y <= 18.0 * y2 {
                    let p = 0.5 * pc * (6.0 * a).sqrt() - 0.411 * pc - 0.0625 / y50 * pc * (y - 6.0 * y2);
                    (p, -0.0625 * pc / y50)
                } else {
                    (pc * (1.225 * a.sqrt() - 0.75 * a - 0.411), 0.001 * esi)
                }
            }
            Self::StiffClayAboveWater { pu, y50, linear } => {
                let yl = linear * y50;
                let curve = |y: f64| 0.5 * pu * (y / y50).powf(0.25);
                if y < yl * 0.999 {
                    let k = curve(yl) / yl;
                    (y * curve(yl) / yl, k)
                } else if y > 16.0 * y50 {
                    (pu, 0.0)
                } else {
                    (curve(y), pu * (y / y50).powf(-0.75) * 0.125 / y50)
                }
            }
            Self::VuggyLimestone { diameter, strength } => {
                let first = 0.0004 * diameter;
                if y <= first {
                    (2000.0 * strength * y, 2000.0 * strength)
                } else if y <= 0.0024 * diameter {
                    (0.8 * diameter * strength + 100.0 * strength * (y - first), 100.0 * strength)
                } else {
                    (0.0, 0.0)
                }
            }
            Self::CementedSoil { resistance: [pm, pu], stiffness, diameter } => {
                let (ym, yu) = (diameter / 60.0, diameter * 3.0 / 80.0);
                let m = (pu - pm) / (yu - ym);
                let n = pm / (m.abs() * ym);
                let c = pm / ym.powf(1.0 / n);
                let (yk, line) = if stiffness > pm / ym {
                    ((c / stiffness).powf(n / (n - 1.0)), ym)
                } else if stiffness > pu / yu {
                    ((pm - m * ym) / (stiffness - m), 0.0)
                } else {
                    (pu / stiffness, f64::INFINITY)
                };
                if y < yk {
                    (stiffness * y, stiffness)
                } else if y < line && line.is_finite() {
                    (c * y.powf(1.0 / n), c / n * y.powf((1.0 - n) / n))
                } else if y < yu && line.is_finite() {
                    (pm + m * (y - ym), m)
                } else {
                    (pu, 0.0)
                }
            }
            Self::WeakRock { kir, pur, yrm } => {
                // The exponent is 4/3, in the digits of OpenSees.
                let first = (pur / (2.0 * yrm.powf(0.25) * kir)).powf(1.333);
                if y < first {
                    (kir * y, kir)
                } else if y < 16.0 * yrm {
                    (pur * 0.5 * (y / yrm).powf(0.25), pur / (8.0 * yrm) * (y / yrm).powf(-0.75))
                } else {
                    (pur, 0.0)
                }
            }
        }
    }
}

impl Backbone {
    /// Stress and slope at a strain.
    ///
    /// # Errors
    /// A material has no response at this strain.
    pub fn at(&self, strain: f64) -> MaterialResult<(f64, f64)> {
        Ok(match self {
            Self::Multilinear(points) => multilinear(points, strain),
            Self::Arctangent { k1, k2 } => {
                let u = k2 * strain;
                (k1 * u.atan(), k1 / (1.0 + u * u) * k2)
            }
            Self::Mander { fc, epsc, e } => {
                if strain < 0.0 {
                    return Ok((0.0, 0.0));
                }
                let (x, secant) = (strain / epsc, fc / epsc);
                let r = e / (e - secant);
                let power = x.powf(r);
                let d = r - 1.0 + power;
                (fc * (x * r) / d, secant * r * (r - 1.0) * (1.0 - power) / (d * d))
            }
            Self::Raynor { es, fy, fsu, strain: [hard, ultimate], c1, ey } => {
                let (yielding, x, s) = (fy / es, strain.abs(), 1f64.copysign(strain));
                let end = fy + (hard - yielding) * ey;
                let (stress, slope) = if x <= yielding {
                    (es * x, *es)
                } else if x <= *hard {
                    (fy + (x - yielding) * ey, *ey)
                } else if x <= *ultimate {
                    let (rest, length) = ((ultimate - x) / (ultimate - hard), ultimate - hard);
                    let slope = if *c1 == 0.0 { 0.0 } else { (fsu - end) / length * c1 * rest.powf(c1 - 1.0) };
                    (fsu - (fsu - end) * rest.powf(*c1), slope)
                } else {
                    (*fsu, 0.0001 * es)
                };
                (s * stress, slope)
            }
            Self::Soil(curve) => {
                let (p, k) = curve.at(strain.abs());
                (p.copysign(strain), k)
            }
            Self::Material(material, sign) => {
                let mut virgin = vec![0.0; material.state_len()];
                material.init(&mut virgin);
                let mut next = virgin.clone();
                let value = sign * strain;
                let s = material.update(&virgin, Strain { value, ..Strain::default() }, &mut next)?;
                (sign * s.value, s.tangent)
            }
            Self::LinearCapped { inner, cap, slope, residual } => {
                if strain < *cap {
                    return inner.at(strain);
                }
                let top = inner.at(*cap)?.0;
                let drop = residual - top;
                let end = cap + if *slope == 0.0 { drop * 1.0e9 } else { drop / slope };
                if strain < end { (top + slope * (strain - cap), *slope) } else { (*residual, FLAT_SLOPE_RATIO) }
            }
        })
    }
}

fn multilinear(points: &[(f64, f64)], strain: f64) -> (f64, f64) {
    let (mut start, mut first) = ((0.0, 0.0), None);
    for &end in points {
        let slope = (end.1 - start.1) / (end.0 - start.0);
        first.get_or_insert(slope);
        if strain < end.0 {
            return (start.1 + slope * (strain - start.0), slope);
        }
        start = end;
    }
    (start.1, first.unwrap_or(0.0) * FLAT_SLOPE_RATIO)
}

/// Elastic along a backbone curve, times a factor.
#[derive(Clone, Debug)]
pub struct BackboneElastic {
    /// The curve.
    pub backbone: Arc<Backbone>,
    /// Factor of the stress.
    pub factor: f64,
}

/// The material of a curve is virgin at every strain: there is no history that a column could change.
#[deny(clippy::missing_trait_methods)]
impl Uniaxial for BackboneElastic {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        "Backbone"
    }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn update(&self, _: &[f64], strain: Strain, _: &mut [f64]) -> MaterialResult<Stress> {
        let (stress, slope) = self.backbone.at(strain.value)?;
        let (value, tangent) = (self.factor * stress, self.factor * slope);
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(MaterialError(format!("Backbone has no stress at a strain of {:.6e}", strain.value)));
        }
        Ok(Stress { value, tangent, damping: 0.0 })
    }
    fn initial_tangent(&self) -> f64 {
        self.factor * self.backbone.at(0.0).map_or(0.0, |(_, slope)| slope)
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits::default()
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles::default()
    }
}
