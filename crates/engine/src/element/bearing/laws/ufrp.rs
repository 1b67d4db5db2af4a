//! Shear law of `elastomericBearingUFRP`.

use crate::element::Class;
use crate::element::bearing::laws::shear::{Shear, ShearLaw, at_rest};
use crate::element::{ElementError, ElementResult};
use crate::numeric::{bracketed_root, sign};

/// Shear law of an unbonded fibre-reinforced bearing, whose ends roll off their supports:
///
/// q = b (1 - γ |z|^η) z + a₁ u + a₂ |u| u + a₃ u³ + a₄ |u| u³ + a₅ u⁵ + c u̇,
///
/// ż = u̇/u_y [1 - |z|^η (γ + β sign(z u̇))].
///
/// Source: Love, Toopchi-Nezhad, Tait and Drysdale (2011), as in OpenSees. Backward Euler over a step.
#[derive(Clone, Debug, PartialEq)]
pub struct UfrpShear {
    /// Yield displacement u_y.
    pub uy: f64,
    /// Coefficients a₁ to a₅ of the polynomial.
    pub a: [f64; 5],
    /// Factor b of the hysteretic force.
    pub b: f64,
    /// Damping coefficient c.
    pub c: f64,
    /// Yielding exponent η.
    pub eta: f64,
    /// First loop shape parameter β.
    pub beta: f64,
    /// Second loop shape parameter γ.
    pub gamma: f64,
}

impl UfrpShear {
    /// Force of the polynomial, and its stiffness.
    fn backbone(&self, u: f64) -> [f64; 2] {
        let [a1, a2, a3, a4, a5] = self.a;
        let v = u.abs();
        let secant = a1 + v * (a2 + v * (a3 + v * (a4 + v * a5)));
        [secant * u, a1 + v * (2.0 * a2 + v * (3.0 * a3 + v * (4.0 * a4 + v * 5.0 * a5)))]
    }

    /// Hysteretic force, and its slope by z.
    fn hysteretic(&self, z: f64) -> [f64; 2] {
        let p = self.gamma * z.abs().powf(self.eta);
        [self.b * (1.0 - p) * z, self.b * (1.0 - (self.eta + 1.0) * p)]
    }

    /// Hysteretic parameter after an increment `d` of displacement over yield displacement, and its slope.
    fn evolve(&self, zc: f64, d: f64) -> Option<[f64; 2]> {
        // For a positive increment z rises from z_c towards its bound.
        let (s, d) = (sign(d), d.abs());
        let rate = |z: f64| {
            let shape = self.gamma + self.beta * sign(z);
            let p = z.abs().powf(self.eta) * shape;
            let slope = if z == 0.0 { 0.0 } else { self.eta * p / z };
            [1.0 - p, -slope]
        };
        let equation = |z: f64| {
            let [r, slope] = rate(z);
            (z - s * zc - d * r, 1.0 - d * slope)
        };
        let bound = (self.gamma + self.beta).powf(-1.0 / self.eta);
        let z = bracketed_root(equation, (s * zc, bound.max(s * zc)), s * zc, 1.0, 200)?;
        let [r, slope] = rate(z);
        Some([s * z, r / (1.0 - d * slope)])
    }
}

impl ShearLaw<1> for UfrpShear {
    const CLASS: [Class; 2] = [Class::new("ElastomericBearingUFRP2d", 147), Class::own("")];
    const HYSTERETIC: bool = true;

    fn dashpot(&self) -> f64 {
        self.c
    }

    fn virgin(&self) -> Shear<1> {
        Shear { k: [[self.b / self.uy + self.a[0]]], ..Shear::default() }
    }

    fn step(&self, c: &Shear<1>, u: [f64; 1]) -> ElementResult<Shear<1>> {
        let d = (u[0] - c.u[0]) / self.uy;
        let [polynomial, stiffness] = self.backbone(u[0]);
        if at_rest(&u, &c.u) {
            return Ok(Shear { u, q: [polynomial + self.hysteretic(c.internal[0])[0]], ..*c });
        }
        let [z, slope] = self
            .evolve(c.internal[0], d)
            .ok_or_else(|| ElementError("the step is too large: no hysteretic parameter z belongs to it".into()))?;
        let [q, by_z] = self.hysteretic(z);
        Ok(Shear { u, internal: [z], q: [polynomial + q], k: [[stiffness + by_z * slope / self.uy]] })
    }
}
