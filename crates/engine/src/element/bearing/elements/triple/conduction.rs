//! Heat conduction: temperature rise from the heat that enters a surface.

use crate::element::bearing::laws::rubber::PI as ROUNDED_PI;
use std::f64::consts::PI;

/// Fourier number α t / h² below which the image series converges faster than the Fourier series.
const IMAGE_SERIES_LIMIT: f64 = 0.3;
/// Relative size of the last term of OpenSees' series.
const TRUNCATION: f64 = 1e-3;

/// Body behind the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// A half-space.
    HalfSpace,
    /// A plate with an insulated back.
    Plate,
}

/// One-dimensional conduction of heat from a surface into the body behind it. Source: H. S. Carslaw and J. C. Jaeger,
/// "Conduction of Heat in Solids", 2nd edition (1959), sections 2.9 and 3.8.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conduction {
    /// Half-space or plate.
    pub body: Body,
    /// Thermal diffusivity α, length²/time.
    pub diffusivity: f64,
    /// Thermal conductivity k, power/(length °C).
    pub conductivity: f64,
    /// OpenSees' constants (22/7 and 3.14159 for π) and its truncation of the series at the first term below 10⁻³ of
    /// the sum.
    pub compat: bool,
}

impl Conduction {
    /// Temperature rise for a unit heat per area at an age `tau` > 0, °C area/energy. Entries are at the surface and at
    /// the depth `thickness`, the back of the plate.
    pub fn rise(&self, thickness: f64, tau: f64) -> [f64; 2] {
        let pi = match (self.compat, self.body) {
            (false, _) => PI,
            (true, Body::HalfSpace) => 22.0 / 7.0,
            (true, Body::Plate) => ROUNDED_PI,
        };
        // Image sources lie at even multiples of the thickness.
        let age = self.diffusivity * tau / (thickness * thickness);
        let image = |n: f64| (-0.25 * n * n / age).exp();
        let share = match self.body {
            Body::HalfSpace => [1.0, image(1.0)],
            Body::Plate if self.compat => {
                [0.0, 1.0].map(|z| truncated_sum(|n| image(2.0 * n + z) + image(2.0 * n + 2.0 - z)))
            }
            Body::Plate if age < IMAGE_SERIES_LIMIT => {
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

/// Sum of `term` until a term is at most 10⁻³ of the sum before.
fn truncated_sum(term: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for n in 0..=100 {
        let before = sum;
        sum += term(f64::from(n));
        if sum - before <= TRUNCATION * before {
            break;
        }
    }
    sum
}
