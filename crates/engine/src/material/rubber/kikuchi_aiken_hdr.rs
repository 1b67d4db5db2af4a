//! High damping rubber bearings in the law of Kikuchi and Aiken.

use crate::material::rubber::kikuchi_aiken::{Device, Loops, Shape, bump_of_damping, decay_of_damping, intersection};

/// Functions of the shear strain γ for a rubber compound, fitted to tests up to γ = 4.1, in MPa.
///
/// The compounds are Bridgestone's, with the coefficients of OpenSees' `KikuchiAikenHDR` (Ishii and Kikuchi, 2012 and
/// 2017).
#[derive(Clone, Debug, PartialEq)]
pub struct Compound {
    /// Name in the command.
    pub name: &'static str,
    /// Equivalent shear modulus G_eq = k γ^m below a limit strain: the limit, k and m.
    geq_power: [f64; 3],
    /// G_eq above the limit: coefficients of 1, γ, γ², γ³.
    geq: [f64; 4],
    /// Equivalent damping h_eq: coefficients of 1, γ, γ², γ³.
    heq: [f64; 4],
    /// Hysteretic share u of the force at the amplitude: coefficients of 1, γ, γ², γ³.
    u: [f64; 4],
    /// Exponent n of the elastic part: 1 below a strain, and above it coefficients of 1, γ, γ², γ³.
    n: (f64, [f64; 4]),
    /// Strain above which a is constant and b nonzero, and that constant a.
    a: [f64; 2],
    /// Parameter c of the curves.
    c: f64,
}

/// The compounds in the order of their numbers, from 1: each under nominal pressure and without pressure.
pub const COMPOUNDS: [Compound; 6] = [
    Compound {
        name: "X0.6",
        geq_power: [1.15, 0.68358, -0.39964],
        geq: [1.10103, -0.61946, 0.22047, -0.022191],
        heq: [0.23834, -0.028108, 0.000087664, 0.0],
        u: [0.44236, -0.062943, -0.0037571, 0.0],
        n: (1.5, [0.91173, -0.59184, 0.43379, 0.0]),
        a: [1.4, 10.19171],
        c: 5.0,
    },
    Compound {
        name: "X0.6-0MPa",
        geq_power: [1.1, 0.67148, -0.41264],
        geq: [0.99225, -0.45820, 0.14236, -0.011238],
        heq: [0.21907, -0.021302, -0.0013313, 0.0],
        u: [0.44226, -0.091218, 0.0030028, 0.0],
        n: (1.5, [2.10973, -1.6166, 0.58452, 0.0]),
        a: [1.3, 10.38035],
        c: 6.0,
    },
    Compound {
        name: "X0.4",
        geq_power: [2.0, 0.38073, -0.42052],
        geq: [0.46499, -0.12723, 0.0184823, 0.0],
        heq: [0.22184, 0.0059574, -0.0072693, 0.0014267],
        u: [0.42715, -0.041644, 0.0070867, -0.0019158],
        n: (2.0, [0.20924, 0.39538, 0.0, 0.0]),
        a: [1.5, 12.5603],
        c: 5.5,
    },
    Compound {
        name: "X0.4-0MPa",
        geq_power: [2.0, 0.40132, -0.39224],
        geq: [0.53123, -0.18673, 0.037003, 0.0],
        heq: [0.18932, 0.010906, -0.007593, 0.0],
        u: [0.36558, -0.0021387, -0.013006, 0.0],
        n: (2.0, [-0.842, 0.921, 0.0, 0.0]),
        a: [1.2, 15.7279],
        c: 6.0,
    },
    Compound {
        name: "X0.3",
        geq_power: [2.0, 0.32669, -0.34317],
        geq: [0.50315, -0.23474, 0.069144, -0.0065894],
        heq: [0.18872, -0.028833, 0.0070127, -0.00073321],
        u: [0.40097, -0.12992, 0.038851, -0.0052934],
        n: (2.0, [0.26386, 0.19679, 0.085685, 0.0]),
        a: [1.5, 10.5057],
        c: 6.0,
    },
    Compound {
        name: "X0.3-0MPa",
        geq_power: [2.0, 0.33433, -0.34538],
        geq: [0.49000, -0.21014, 0.057652, -0.0046475],
        heq: [0.18956, -0.05284, 0.019156, -0.0028118],
        u: [0.38928, -0.15678, 0.05432, -0.0077259],
        n: (2.0, [1.86072, -1.135, 0.35232, 0.0]),
        a: [1.5, 10.3411],
        c: 6.0,
    },
];

/// Conversion of MPa to Pa: the command's force is in N for an area in m².
const MEGA: f64 = 1e6;

fn cubic(c: &[f64; 4], x: f64) -> f64 {
    c[0] + x * (c[1] + x * (c[2] + x * c[3]))
}

/// A high damping rubber bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct HighDampingRubber {
    /// Compound.
    pub compound: Compound,
    /// Area A_r of the rubber, m² for forces in N.
    pub area: f64,
    /// Total thickness H_r of the rubber, in the unit of the displacement.
    pub height: f64,
    /// Factors of G_eq, h_eq and u, without unit.
    pub factors: [f64; 3],
}

impl HighDampingRubber {
    fn heq(&self, gamma: f64) -> f64 {
        cubic(&self.compound.heq, gamma) * self.factors[1]
    }
    fn u(&self, gamma: f64) -> f64 {
        cubic(&self.compound.u, gamma) * self.factors[2]
    }
}

impl Device for HighDampingRubber {
    const NAME: &'static str = "KikuchiAikenHDR";

    fn joined(mut self) -> Self {
        let [limit, k, m] = self.compound.geq_power;
        self.compound.geq_power[0] = intersection(limit, |g| k * g.powf(m), |g| cubic(&self.compound.geq, g));
        self
    }

    fn height(&self) -> f64 {
        self.height
    }

    fn min_increment(&self) -> f64 {
        f64::EPSILON * self.height
    }

    fn skeleton(&self, gamma: f64) -> (f64, f64) {
        let [limit, k, m] = self.compound.geq_power;
        // G_eq γ and its derivative.
        let (stress, modulus) = if gamma < limit {
            let geq = k * gamma.powf(m);
            (geq * gamma, (1.0 + m) * geq)
        } else {
            let c = &self.compound.geq;
            let slope = c[0] + gamma * (2.0 * c[1] + gamma * (3.0 * c[2] + gamma * 4.0 * c[3]));
            (cubic(c, gamma) * gamma, slope)
        };
        let scale = MEGA * self.factors[0] * self.area;
        (stress * scale, modulus * scale / self.height)
    }

    fn shape(&self, gamma: f64, loops: Loops) -> Shape {
        let u = self.u(gamma);
        let [from, limit] = self.compound.a;
        let a = if gamma < from { decay_of_damping(self.heq(gamma), u, 20.0, limit, loops) } else { limit };
        let n = if gamma < self.compound.n.0 { 1.0 } else { cubic(&self.compound.n.1, gamma) };
        Shape { u, p: 0.5, n, a }
    }

    fn bump(&self, gamma: f64, a: f64) -> f64 {
        if gamma < self.compound.a[0] {
            return 0.0;
        }
        bump_of_damping(self.heq(gamma), self.u(gamma), a, self.compound.c)
    }

    fn decay(&self) -> f64 {
        self.compound.c
    }
}
