//! How heat that enters a surface warms it.

use crate::element::bearing::laws::rubber::PI as ROUGHLY;
use std::f64::consts::PI;

/// What the heat flows into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// A half space.
    HalfSpace,
    /// A plate that no heat leaves at its back.
    Plate,
}

/// Conduction of the heat of a surface into the plate behind it, one-dimensional. H. S. Carslaw and J. C. Jaeger, "Conduction of Heat in
/// Solids", 2nd edition (1959), sections 2.9 and 3.8.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conduction {
    /// Half space or plate.
    pub body: Body,
    /// Thermal diffusivity α, length²/time.
    pub diffusivity: f64,
    /// Thermal conductivity k, power/(length °C).
    pub conductivity: f64,
    /// OpenSees' constants (22/7 and 3.14159 for π) and its end of the series: the first term that adds less than a thousandth.
    pub compat: bool,
}

impl Conduction {
    /// Temperature per heat of an area at an age `tau` > 0, at the surface and at the depth `thickness` (the back of the plate),
    /// °C area/energy.
    pub fn rise(&self, thickness: f64, tau: f64) -> [f64; 2] {
        let pi = match (self.compat, self.body) {
            (false, _) => PI,
            (true, Body::HalfSpace) => 22.0 / 7.0,
            (true, Body::Plate) => ROUGHLY,
        };
        // Images of the source lie at even multiples of the thickness.
        let age = self.diffusivity * tau / (thickness * thickness);
        let image = |n: f64| (-0.25 * n * n / age).exp();
        let share = match self.body {
            Body::HalfSpace => [1.0, image(1.0)],
            Body::Plate if self.compat => {
                [0.0, 1.0].map(|z| cut_short(|n| image(2.0 * n + z) + image(2.0 * n + 2.0 - z)))
            }
            Body::Plate if age < 0.3 => {
                let sum = |from: u32| 2.0 * (0..6).map(|n| image(f64::from(2 * n + from))).sum::<f64>();
                [1.0 + sum(2), sum(1)]
            }
            Body::Plate => {
                // The same sum by Poisson's formula.
                let mode = |n: u32| (-PI * PI * f64::from(n * n) * age).exp();
                let sum = |sign: f64| 1.0 + 2.0 * (1..5).map(|n| sign.powi(n as i32) * mode(n)).sum::<f64>();
                [1.0, -1.0].map(|sign| (PI * age).sqrt() * sum(sign))
            }
        };
        let source = (self.diffusivity / (pi * tau)).sqrt() / self.conductivity;
        share.map(|s| source * s)
    }
}

/// The sum of `term` until one adds no more than a thousandth.
fn cut_short(term: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for n in 0..=100 {
        let before = sum;
        sum += term(f64::from(n));
        if sum - before <= 1e-3 * before {
            break;
        }
    }
    sum
}
