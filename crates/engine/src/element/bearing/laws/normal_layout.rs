//! Positions of the normal springs of a section, and their relative stiffness.

use crate::numeric::{bessel_i, dot};
use std::f64::consts::PI;

/// Outline of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A disc.
    Round,
    /// A square.
    Square,
}

/// Distribution of the vertical stiffness over a section. λ is (D/t) √(3 G/K) for a rubber layer of diameter D and
/// thickness t, with shear modulus G and bulk modulus K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Uniform.
    Uniform,
    /// The pressure in a bonded rubber layer with this λ (0: incompressible).
    Pressure(f64),
}

/// Largest λ; Bessel and hyperbolic functions overflow beyond it.
pub const MAX_LAMBDA: f64 = 700.0;

/// Normalisation of the distribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// Mean over the springs: their axial stiffnesses add up to that of the section.
    Springs,
    /// Mean over the section in closed form, if there is one: round `multipleNormalSpring`.
    Section,
}

/// Positions and relative stiffnesses of n x n springs of equal area in a section of diameter (or edge) `size`.
///
/// A disc has rings of equal width. Ring i has 4 (2 i - 1 - p) sectors, where p = 1 for a core if n is odd. A spring is
/// at the centroid of its sector.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Coordinates along local y.
    pub y: Vec<f64>,
    /// Coordinates along local z.
    pub z: Vec<f64>,
    /// Area of each spring times its relative stiffness.
    pub area: Vec<f64>,
}

impl Layout {
    /// Makes the layout of `n` x `n` springs.
    pub fn new(shape: Shape, size: f64, n: usize, distribution: Distribution, mean: Mean) -> Self {
        let places = match shape {
            Shape::Round => rings(n, size),
            Shape::Square => grid(n, size),
        };
        let mut area: Vec<f64> = match (distribution, shape) {
            (Distribution::Uniform, _) => vec![1.0; places.len()],
            (Distribution::Pressure(lambda), Shape::Round) => {
                places.iter().map(|(y, z)| round_pressure(lambda, y.hypot(*z) / (0.5 * size))).collect()
            }
            (Distribution::Pressure(lambda), Shape::Square) => {
                // Springs of a grid row share y, those of a column z.
                let lines: Vec<f64> = places[..n].iter().map(|(_, z)| z / (0.5 * size)).collect();
                square_pressures(lambda, &lines)
            }
        };
        let whole = if shape == Shape::Round { 0.25 * PI * size * size } else { size * size };
        let sum = match (mean, shape, distribution) {
            (Mean::Section, Shape::Round, Distribution::Pressure(lambda)) => {
                mean_round_pressure(lambda) * area.len() as f64
            }
            _ => area.iter().sum(),
        };
        area.iter_mut().for_each(|a| *a *= whole / sum);
        Self { y: places.iter().map(|p| p.0).collect(), z: places.iter().map(|p| p.1).collect(), area }
    }
}

fn rings(n: usize, size: f64) -> Vec<(f64, f64)> {
    let core = n % 2;
    let mut places = vec![];
    for ring in 1..=(n + core) / 2 {
        if ring == 1 && core == 1 {
            places.push((0.0, 0.0));
            continue;
        }
        let sectors = 4 * (2 * ring - 1 - core);
        let half = PI / sectors as f64;
        let outer = (2 * ring - core) as f64 / (2 * n) as f64 * size;
        let inner = (2 * ring - 2 - core) as f64 / (2 * n) as f64 * size;
        let r = 2.0 / 3.0 * half.sin() / half * (inner * inner + inner * outer + outer * outer) / (inner + outer);
        for sector in 0..sectors {
            let angle = (2 * sector + 1) as f64 * half;
            places.push((r * angle.cos(), r * angle.sin()));
        }
    }
    places
}

fn grid(n: usize, size: f64) -> Vec<(f64, f64)> {
    let at = |i: usize| ((2 * i + 1) as f64 / n as f64 - 1.0) * 0.5 * size;
    (0..n * n).map(|k| (at(k / n), at(k % n))).collect()
}

/// Pressure in a disc at the relative radius ρ: 1 - I₀(λ ρ)/I₀(λ), or its limit 1 - ρ² for λ = 0.
fn round_pressure(lambda: f64, rho: f64) -> f64 {
    if lambda == 0.0 { 1.0 - rho * rho } else { 1.0 - bessel_i(0, lambda * rho) / bessel_i(0, lambda) }
}

/// Mean of [`round_pressure`] over the disc.
fn mean_round_pressure(lambda: f64) -> f64 {
    if lambda == 0.0 { 0.5 } else { 1.0 - 2.0 / lambda * bessel_i(1, lambda) / bessel_i(0, lambda) }
}

/// Number of terms of the pressure series in a square.
const TERMS: usize = 10;

/// Pressure in a square up to a constant factor, at relative positions (y, z) with y and z on `lines`, y in the outer
/// loop. Ten terms of the Fourier series are summed, for odd m:
///
/// Σ sin(mπ/2)/m (1 - cosh(α z)/cosh α)/α² cos(m π y/2), α² = λ² + (m π/2)².
fn square_pressures(lambda: f64, lines: &[f64]) -> Vec<f64> {
    let terms = |of: &dyn Fn(f64, f64) -> f64| -> [f64; TERMS] {
        std::array::from_fn(|i| of((2 * i + 1) as f64, (2 * i + 1) as f64 * PI / 2.0))
    };
    let along_y = |y: f64| terms(&|_, wave| (wave * y).cos());
    let along_z = |z: f64| {
        terms(&|m, wave| {
            let alpha = lambda.hypot(wave);
            // cosh(α z)/cosh α without overflow.
            let ratio =
                ((alpha * (z.abs() - 1.0)).exp() + (-alpha * (z.abs() + 1.0)).exp()) / (1.0 + (-2.0 * alpha).exp());
            wave.sin() / m * (1.0 - ratio) / (alpha * alpha)
        })
    };
    let (rows, columns): (Vec<_>, Vec<_>) = lines.iter().map(|at| (along_y(*at), along_z(*at))).unzip();
    rows.iter().flat_map(|y| columns.iter().map(|z| dot(y, z))).collect()
}
