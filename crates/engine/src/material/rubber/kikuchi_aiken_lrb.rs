//! Lead rubber bearings in the law of Kikuchi and Aiken.

use crate::material::rubber::kikuchi_aiken::{Device, Loops, Shape, bump_of_damping, decay_of_damping, intersection};
use std::f64::consts::PI;

/// Largest decay a, and the constant a above γ = 2.
const A: f64 = 26.501472;
/// Shear strain above which the bearing stiffens.
const STIFFENING: f64 = 2.0;

/// A lead rubber bearing. The characteristic strength Q_d and the post-yield stiffness K_d vary with the shear strain
/// and the temperature.
///
/// Source: Kikuchi, Nakamura and Aiken (2010), <https://doi.org/10.1002/eqe.994>. The coefficients are those of
/// OpenSees' `KikuchiAikenLRB` (Kikuchi, 2012).
#[derive(Clone, Debug, PartialEq)]
pub struct LeadRubber {
    height: f64,
    /// Q_d, K_d and the initial stiffness K_u at γ = 1.
    qd: f64,
    kd: f64,
    ku: f64,
    /// Limit strains between the formulas of the factors of Q_d and of K_d.
    strength_limits: [f64; 2],
    stiffness_limits: [f64; 3],
}

/// Factor k γ^m of Q_d between consecutive limits: k and m.
const STRENGTH: [[f64; 2]; 3] = [[2.036, 0.410], [1.106, 0.145], [1.0, 0.0]];
/// Factor k γ^m of K_d between consecutive limits: k and m. The bearing stiffens beyond the last limit.
const STIFFNESS: [[f64; 2]; 3] = [[0.779, -0.43], [1.0, -0.25], [1.0, -0.12]];

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
    /// Initial stiffness divided by the post-yield stiffness, greater than 1.
    pub stiffness_ratio: f64,
    /// Temperature, °C; the other parameters are values at 15 °C.
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
        let (strength_limits, stiffness_limits) = ([0.1, 0.5], [0.25, 1.0, STIFFENING]);
        Self { height: p.height, qd, kd, ku: p.stiffness_ratio * kd, strength_limits, stiffness_limits }
    }

    /// Factor of Q_d and its derivative with respect to γ.
    fn strength(&self, gamma: f64) -> (f64, f64) {
        let formula = self.strength_limits.iter().take_while(|limit| gamma >= **limit).count();
        power(STRENGTH[formula], gamma)
    }

    /// Factor of K_d and its derivative with respect to γ.
    fn stiffness(&self, gamma: f64) -> (f64, f64) {
        let formula = self.stiffness_limits.iter().take_while(|limit| gamma >= **limit).count();
        STIFFNESS.get(formula).map_or_else(|| stiffened(gamma), |f| power(*f, gamma))
    }

    /// Q_d at γ, the factor of K_d, and the force at γ.
    fn at(&self, gamma: f64) -> (f64, f64, f64) {
        let (qd, factor) = (self.strength(gamma).0 * self.qd, self.stiffness(gamma).0);
        (qd, factor, qd + factor * self.kd * gamma * self.height)
    }

    /// Hysteretic share u, and the equivalent damping: that of the bilinear loop times a factor above γ = 2.
    fn damping(&self, gamma: f64) -> (f64, f64) {
        let (qd, factor, fm) = self.at(gamma);
        let yielded = qd / (factor * (self.ku - self.kd));
        let over = (gamma - STIFFENING).max(0.0);
        let more = 0.036375 * over * over + 1.0;
        (qd / fm, more * 2.0 * qd / PI / fm * (1.0 - yielded / (gamma * self.height)))
    }
}

/// k x^m and its derivative.
fn power([k, m]: [f64; 2], x: f64) -> (f64, f64) {
    if m == 0.0 {
        return (k, 0.0);
    }
    let value = k * x.powf(m);
    (value, m * value / x)
}

/// Factor of K_d above γ = 2, and its derivative.
fn stiffened(gamma: f64) -> (f64, f64) {
    let over = gamma - STIFFENING;
    (0.0482025 * over * over + 0.92019, 2.0 * 0.0482025 * over)
}

impl Device for LeadRubber {
    const NAME: &'static str = "KikuchiAikenLRB";

    fn joined(mut self) -> Self {
        for (i, limit) in self.strength_limits.iter_mut().enumerate() {
            *limit = intersection(*limit, |g| power(STRENGTH[i], g).0, |g| power(STRENGTH[i + 1], g).0);
        }
        for (i, limit) in self.stiffness_limits.iter_mut().enumerate() {
            let above = |g: f64| STIFFNESS.get(i + 1).map_or_else(|| stiffened(g), |f| power(*f, g)).0;
            *limit = intersection(*limit, |g| power(STIFFNESS[i], g).0, above);
        }
        self
    }

    fn height(&self) -> f64 {
        self.height
    }

    fn min_increment(&self) -> f64 {
        f64::EPSILON
    }

    fn skeleton(&self, gamma: f64) -> (f64, f64) {
        let ((strength, strength_slope), (stiffness, stiffness_slope)) = (self.strength(gamma), self.stiffness(gamma));
        let force = strength * self.qd + stiffness * self.kd * gamma * self.height;
        let slope = strength_slope * self.qd / self.height + self.kd * (stiffness + stiffness_slope * gamma);
        (force, slope)
    }

    fn shape(&self, gamma: f64, loops: Loops) -> Shape {
        let (u, heq) = self.damping(gamma);
        let a = if gamma < STIFFENING { decay_of_damping(heq, u, 50.0, A, loops) } else { A };
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
