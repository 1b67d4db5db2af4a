//! Slip of reinforcing bars that are anchored in a beam-column joint (Lowes, Mitra and Altoontash, 2003, and Mitra, 2007).

use crate::material::deteriorating::pinching4::{Damage, LinearDamage, Pinching4Parameters, Pinching4Side};
use std::f64::consts::PI;

/// Bond of a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bond {
    /// As in tests of joints with good confinement.
    Strong,
    /// Of joints that lose their bond.
    Weak,
}

/// Place of the bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BarPlace {
    /// Top or bottom of a beam.
    Beam,
    /// A column.
    Column,
}

/// Degradation of the strength of the bond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BondDamage {
    /// No damage at all.
    None,
    /// The strength falls linearly with the slip.
    Linear,
    /// The strength falls with a power of the slip.
    Power,
}

/// Units of stress, from which those of length follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StressUnit {
    /// MPa and mm.
    Mpa,
    /// psi and in.
    Psi,
    /// Pa and m.
    Pa,
    /// psf and ft.
    Psf,
    /// ksi and in.
    Ksi,
    /// ksf and ft.
    Ksf,
}

impl StressUnit {
    /// Bond strengths over the root of the concrete strength: yielded and elastic in tension, elastic and yielded in
    /// compression, residual. In the digits of OpenSees.
    fn bond(self, bond: Bond) -> [f64; 5] {
        let weak = bond == Bond::Weak;
        match self {
            Self::Mpa => [if weak { 0.05 } else { 0.4 }, 1.8, 2.2, 3.7, 0.15],
            Self::Psi if weak => [0.6, 10.0, 13.0, 21.0, 0.6],
            Self::Psi => [4.8, 21.0, 26.0, 43.0, 1.8],
            Self::Pa => [if weak { 1.58 } else { 12.65 }, 56.92, 69.57, 117.0, 4.74],
            Self::Psf => [if weak { 7.2 } else { 57.6 }, 252.0, 312.0, 516.0, 21.6],
            Self::Ksi => [if weak { 0.02 } else { 0.15 }, 0.66, 0.82, 1.36, 0.06],
            Self::Ksf => [if weak { 0.24 } else { 1.8 }, 7.92, 9.84, 16.32, 0.72],
        }
    }

    /// A millimetre in the unit of length.
    fn millimetre(self) -> f64 {
        match self {
            Self::Mpa => 1.0,
            Self::Psi | Self::Ksi => 1.0 / 25.43,
            Self::Pa => 0.001,
            Self::Psf | Self::Ksf => 1.0 / (25.43 * 12.0),
        }
    }

    /// Pounds per square inch in a unit of stress.
    fn psi(self) -> f64 {
        match self {
            Self::Mpa => 145.0,
            Self::Psi => 1.0,
            Self::Pa => 0.000145,
            Self::Psf => 0.00694,
            Self::Ksi => 1000.0,
            Self::Ksf => 6.94,
        }
    }
}

/// Bars in a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarSlip {
    /// Strength of the concrete, positive.
    pub fc: f64,
    /// Yield stress.
    pub fy: f64,
    /// Elastic modulus.
    pub es: f64,
    /// Ultimate stress.
    pub fu: f64,
    /// Hardening modulus.
    pub eh: f64,
    /// Diameter of a bar.
    pub diameter: f64,
    /// Anchorage length.
    pub anchorage: f64,
    /// Number of bars.
    pub bars: f64,
    /// Width and depth of the member.
    pub member: [f64; 2],
    /// Bond.
    pub bond: Bond,
    /// Place.
    pub place: BarPlace,
    /// Damage.
    pub damage: BondDamage,
    /// Units.
    pub unit: StressUnit,
}

/// Slips beyond which the backbone in compression is almost flat, and at its end, mm.
const SLIP: [f64; 2] = [3.0, 10.0];
/// Depth of the concrete's stress block, and its cover, as parts of the depth.
const BLOCK: f64 = 0.85;
const COVER: f64 = 0.1;
/// Share of the force of unloading at which reloading begins.
const RELOADING_RATIO: f64 = 1.1;

/// Backbone of one side up to the yield force: forces and slips, positive, and the stiffnesses before and after it.
struct YieldingBar {
    force: [f64; 2],
    slip: [f64; 2],
    k1: f64,
    k2: f64,
}

impl BarSlip {
    /// Backbone of one side. `steel` is the area that carries the force.
    fn backbone(&self, [elastic, yielded]: [f64; 2], steel: f64) -> YieldingBar {
        let perimeter = PI * self.diameter / (PI * self.diameter.powi(2) / 4.0);
        let (fy, fu) = (self.fy, self.fu);
        let length = (fu - fy) / (yielded * perimeter);
        let k1 = 2.0 * self.es * (elastic / fy) * perimeter * steel;
        let anchored = fy / (elastic * perimeter) + length < self.anchorage && self.bond == Bond::Strong;
        let k2 = if anchored {
            (fu - fy) * steel / (fy * length / self.es + 0.5 * perimeter * yielded * length.powi(2) / self.eh)
        } else {
            let (le1, le2) = (fy / (elastic * perimeter), fy / (yielded * perimeter));
            let strain = le2.powi(2) / self.es - le1.powi(2) / self.es + length.powi(2) / self.eh;
            (fu - fy) * steel / (perimeter * 0.5 * yielded * strain + fy * length / self.es)
        };
        let force = [0.5 * fy * steel, fy * steel];
        YieldingBar { force, slip: [0.5 * fy * steel / k1, fy * steel / k1], k1, k2 }
    }

    /// Steel area in compression over that in tension: concrete takes a part of the force.
    fn compression_factor(&self, steel: f64) -> f64 {
        let depth = self.member[1];
        let j = if self.place == BarPlace::Beam { 0.85 } else { 0.75 };
        let beta1 = 0.85 - ((self.unit.psi() * self.fc - 4000.0) * 0.05 / 1000.0).clamp(0.0, 0.2);
        let cover = COVER * depth;
        let concrete = BLOCK * self.fc * depth * self.member[0] * 2.0 * (1.0 - j);
        1.0 + concrete / (self.es * steel * 0.003 * beta1 * (1.0 - cover * beta1 / (2.0 * depth * (1.0 - j))))
    }

    /// Parameters of the pinched hysteresis of the slip.
    pub fn pinching(&self) -> Pinching4Parameters {
        let root = self.fc.sqrt();
        let [yt, et, ec, yc, residual] = self.unit.bond(self.bond).map(|t| t * root);
        let bar = PI * self.diameter.powi(2) / 4.0;
        let steel = bar * self.bars;
        let perimeter = PI * self.diameter / bar;
        let (fy, fu) = (self.fy, self.fu);
        let YieldingBar { force: s, slip: e, k1, k2 } = self.backbone([et, yt], steel);
        let e3 = fy * steel / k1 + (fu - fy) * steel / k2;
        let s3 = fu * steel;
        let e4 = 10.0 * e3;
        let tension = ([s[0], s[1], s3, s3 + (s3 - s[1]) * (e4 - e3) / (e3 - e[1])], [e[0], e[1], e3, e4]);
        let limit = 1.0 - residual * self.anchorage * PI * self.diameter * steel / bar / s3;
        let pressed = steel * self.compression_factor(steel);
        let YieldingBar { force: s, slip: e, k1, k2 } = self.backbone([ec, yc], pressed);
        let [delta, ultimate] = SLIP.map(|slip| slip * self.unit.millimetre());
        let free = fy * pressed / k1 + (fu - fy) * pressed / k2;
        let (e3, s3) =
            if delta < free { (delta, fy * pressed + (delta - fy * pressed / k1) * k2) } else { (free, fu * pressed) };
        let compression = ([s[0], s[1], s3, s3 + 1e-3 * k1 * (ultimate - e3)], [e[0], e[1], e3, ultimate]);
        let bonded = |elastic: f64, yielded: f64| {
            let length = fy / (elastic * perimeter) + (fu - fy) / (yielded * perimeter);
            residual * PI * self.diameter * steel * length.min(self.anchorage) / bar
        };
        let unloading = [bonded(ec, yc) / tension.0[2], bonded(et, yt) / compression.0[2]];
        let reloading = [0.25, RELOADING_RATIO * unloading[1] * compression.0[3] / compression.0[0]];
        let side = |i: usize, (stress, strain): ([f64; 4], [f64; 4])| Pinching4Side {
            stress,
            strain,
            reloading_strain: 0.25,
            reloading_stress: reloading[i],
            unloading_stress: unloading[i],
        };
        let mode = |first: f64, exponent: f64, limit: f64| match self.damage {
            BondDamage::None => Damage { rate: [0.0; 2], exponent: [0.0; 2], limit: 0.0 },
            _ => Damage { rate: [first, 0.0], exponent: [exponent, 0.0], limit },
        };
        let mut strength = mode(11.8986, 3.9694, limit);
        strength.limit = limit;
        let (last, third) = (tension.1[3], tension.1[2]);
        let span = last.max(compression.1[3]);
        let linear = LinearDamage {
            begin: third,
            rate: limit * last * span / (last - third),
            offset: -limit * third * span / (last - third),
        };
        Pinching4Parameters {
            sides: [side(0, tension), side(1, compression)],
            stiffness: mode(0.3, 0.1, 0.4),
            reloading: mode(0.6, 0.2, 0.25),
            strength,
            linear_strength: (self.damage == BondDamage::Linear).then_some(linear),
            energy: 10.0,
            by_cycles: false,
        }
    }
}
