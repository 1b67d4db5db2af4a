//! Lead rubber bearings in Kikuchi and Aiken's law.

use super::kikuchi_aiken::{Device, Shape, bump_of_damping, decay_of_damping};
use std::f64::consts::PI;

/// Decay a from γ = 2 on, and at most.
const A: f64 = 26.501472;
/// Strain from which the loops stiffen.
const STIFFENING: f64 = 2.0;

/// A lead rubber bearing: the characteristic strength Q_d and the stiffness K_d after yield vary with the shear strain
/// and the temperature.
///
/// Kikuchi, Nakamura and Aiken (2010), <https://doi.org/10.1002/eqe.994>; coefficients of OpenSees' `KikuchiAikenLRB`
/// (Kikuchi, 2012).
#[derive(Clone, Debug, PartialEq)]
pub struct LeadRubber {
    height: f64,
    /// Q_d, K_d and the initial stiffness K_u at γ = 1.
    qd: f64,
    kd: f64,
    ku: f64,
}

/// Parameters of a [`LeadRubber`] bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadRubberParameters {
    /// Area A_r of the rubber.
    pub rubber_area: f64,
    /// Total thickness H_r of the rubber.
    pub height: f64,
    /// Shear modulus G_r of the rubber.
    pub rubber_modulus: f64,
    /// Area A_p of the lead plug.
    pub lead_area: f64,
    /// Yield stress τ_p of the lead.
    pub lead_strength: f64,
    /// Apparent shear modulus α_p of the lead.
    pub lead_modulus: f64,
    /// Initial stiffness over that after yield, greater than 1.
    pub stiffness_ratio: f64,
    /// Temperature, °C; the other parameters are those at 15 °C.
    pub temperature: f64,
    /// Factors of K_d and Q_d.
    pub factors: [f64; 2],
}

impl LeadRubber {
    /// From the parameters.
    pub fn new(p: &LeadRubberParameters) -> Self {
        let warmer = p.temperature - 15.0;
        let qd = p.lead_strength * p.lead_area * (-0.00879 * warmer).exp() * p.factors[1];
        let elastic = p.rubber_modulus * p.rubber_area + p.lead_modulus * p.lead_area;
        let kd = elastic / p.height * (-0.00271 * warmer).exp() * p.factors[0];
        Self { height: p.height, qd, kd, ku: p.stiffness_ratio * kd }
    }

    /// Factor of Q_d and its derivative with respect to γ.
    fn strength(gamma: f64) -> (f64, f64) {
        match gamma {
            g if g < 0.1 => power(2.036, 0.410, g),
            g if g < 0.5 => power(1.106, 0.145, g),
            _ => (1.0, 0.0),
        }
    }

    /// Factor of K_d and its derivative with respect to γ.
    fn stiffness(gamma: f64) -> (f64, f64) {
        match gamma {
            g if g < 0.25 => power(0.779, -0.43, g),
            g if g < 1.0 => power(1.0, -0.25, g),
            g if g < STIFFENING => power(1.0, -0.12, g),
            g => {
                let over = g - STIFFENING;
                (0.0482025 * over * over + 0.92019, 2.0 * 0.0482025 * over)
            }
        }
    }

    /// Q_d, K_d over its factor's, and the force at γ.
    fn at(&self, gamma: f64) -> (f64, f64, f64) {
        let (qd, factor) = (Self::strength(gamma).0 * self.qd, Self::stiffness(gamma).0);
        (qd, factor, qd + factor * self.kd * gamma * self.height)
    }

    /// Hysteretic part u and equivalent damping, that of the bilinear loop with a factor.
    fn damping(&self, gamma: f64) -> (f64, f64) {
        let (qd, factor, fm) = self.at(gamma);
        let yielded = qd / (factor * (self.ku - self.kd));
        let over = (gamma - STIFFENING).max(0.0);
        let more = 0.036375 * over * over + 1.0;
        (qd / fm, more * 2.0 * qd / PI / fm * (1.0 - yielded / (gamma * self.height)))
    }
}

/// k x^m and its derivative.
fn power(k: f64, m: f64, x: f64) -> (f64, f64) {
    let value = k * x.powf(m);
    (value, m * value / x)
}

impl Device for LeadRubber {
    const NAME: &'static str = "KikuchiAikenLRB";

    fn height(&self) -> f64 {
        self.height
    }

    fn rest(&self) -> f64 {
        f64::EPSILON
    }

    fn skeleton(&self, gamma: f64) -> (f64, f64) {
        let ((strength, strength_slope), (stiffness, stiffness_slope)) =
            (Self::strength(gamma), Self::stiffness(gamma));
        let force = strength * self.qd + stiffness * self.kd * gamma * self.height;
        let slope = strength_slope * self.qd / self.height + self.kd * (stiffness + stiffness_slope * gamma);
        (force, slope)
    }

    fn shape(&self, gamma: f64, tolerance: f64) -> Shape {
        let (u, heq) = self.damping(gamma);
        let a = if gamma < STIFFENING { decay_of_damping(heq, u, 50.0, A, tolerance) } else { A };
        let p = if gamma < STIFFENING { 0.0 } else { -0.30226 + 0.15113 * gamma };
        Shape { u, p, n: 8.0, a }
    }

    fn bump(&self, gamma: f64, a: f64) -> f64 {
        if gamma < STIFFENING {
            return 0.0;
        }
        let (u, heq) = self.damping(gamma);
        bump_of_damping(heq, u, a, self.decay())
    }

    fn decay(&self) -> f64 {
        6.0
    }
}
