//! A section of normal springs: axial force and bending of a laminated bearing.

use crate::material::{Material, MaterialError, Strains, Stresses};
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

/// How the vertical stiffness is distributed over a section, by λ = (D/t) √(3 G/K) with the diameter D and the
/// thickness t of a rubber layer, the shear modulus G and the bulk modulus K of the rubber.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// The same everywhere.
    Uniform,
    /// As the pressure in a bonded layer of rubber with this λ (0: incompressible).
    Pressure(f64),
}

/// Largest λ that the distributions are worked out for; beyond it the Bessel and hyperbolic functions overflow.
pub const MAX_LAMBDA: f64 = 700.0;

/// What the distribution over the springs is divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// The mean over the springs: their axial stiffnesses sum up to that of the section.
    Springs,
    /// The mean over the section in closed form, where there is one: `multipleNormalSpring`, round.
    Section,
}

/// Places and relative stiffnesses of n x n springs of equal area in a section of diameter (or edge) `size`.
///
/// A disc is divided into rings of equal width, these into 4 (2 i - 1 - p) sectors, p = 1 for a core where n is odd; a
/// spring stands in the centroid of its part.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Places along the local y axis.
    pub y: Vec<f64>,
    /// Places along the local z axis.
    pub z: Vec<f64>,
    /// Area of each, times its part in the distribution.
    pub area: Vec<f64>,
}

impl Layout {
    /// Lay out `n` x `n` springs.
    pub fn new(shape: Shape, size: f64, n: usize, distribution: Distribution, mean: Mean) -> Self {
        let places = match shape {
            Shape::Round => rings(n, size),
            Shape::Square => grid(n, size),
        };
        let pressure = |&(y, z): &(f64, f64)| match (distribution, shape) {
            (Distribution::Uniform, _) => 1.0,
            (Distribution::Pressure(lambda), Shape::Round) => round_pressure(lambda, y.hypot(z) / (0.5 * size)),
            (Distribution::Pressure(lambda), Shape::Square) => {
                square_pressure(lambda, y / (0.5 * size), z / (0.5 * size))
            }
        };
        let mut area: Vec<f64> = places.iter().map(pressure).collect();
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

/// Pressure in a disc at the relative radius ρ: 1 - I₀(λ ρ)/I₀(λ), or its limit 1 - ρ².
fn round_pressure(lambda: f64, rho: f64) -> f64 {
    if lambda == 0.0 { 1.0 - rho * rho } else { 1.0 - bessel_i(0, lambda * rho) / bessel_i(0, lambda) }
}

/// Mean of [`round_pressure`] over the disc.
fn mean_round_pressure(lambda: f64) -> f64 {
    if lambda == 0.0 { 0.5 } else { 1.0 - 2.0 / lambda * bessel_i(1, lambda) / bessel_i(0, lambda) }
}

/// Pressure in a square at the relative place (y, z), but for a constant factor: ten terms of its Fourier series
/// Σ sin(mπ/2)/m (1 - cosh(α z)/cosh α)/α² cos(m π y/2), α² = λ² + (m π/2)², m odd.
fn square_pressure(lambda: f64, y: f64, z: f64) -> f64 {
    let term = |m: usize| {
        let wave = m as f64 * PI / 2.0;
        let alpha = lambda.hypot(wave);
        // cosh(α z)/cosh α without overflow
        let ratio = ((alpha * (z.abs() - 1.0)).exp() + (-alpha * (z.abs() + 1.0)).exp()) / (1.0 + (-2.0 * alpha).exp());
        wave.sin() / m as f64 * (1.0 - ratio) / (alpha * alpha) * (wave * y).cos()
    };
    (1..20).step_by(2).map(term).sum()
}

/// Forces of a section and their derivatives: axial force, moment about y, moment about z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    /// Forces.
    pub force: [f64; 3],
    /// Derivatives by the deformations.
    pub stiffness: [[f64; 3]; 3],
    /// Derivatives by the rates of the deformations, of viscous materials.
    pub damping: [[f64; 3]; 3],
}

/// Pairs of deformations, for the symmetric stiffness.
const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

/// From which histories springs go on.
#[derive(Clone, Debug)]
enum Memory {
    /// From the committed ones.
    Committed,
    /// Also from those that the last call of the step left, as laws of OpenSees' do.
    Calls,
    /// The same, and those from this number on never commit: for them the virgin history is the committed one.
    Forgetful(usize, Vec<f64>),
}

/// Springs of one material over a section; their histories lie one after the other in the state of their owner.
#[derive(Clone, Debug)]
pub struct NormalSprings {
    material: Material,
    at: usize,
    memory: Memory,
    /// Length of a spring, by which its extension becomes a strain.
    length: f64,
    /// Extension per unit of axial deformation and of rotations about y and z, spring by spring: 1, z, -y.
    lever: [Vec<f64>; 3],
    /// Area times lever.
    arm: [Vec<f64>; 3],
    /// Area times two levers, for each of [`PAIRS`].
    second: [Vec<f64>; 6],
}

/// Springs updated at a time, so that their stresses stay on the stack.
const CHUNK: usize = 64;

impl NormalSprings {
    /// Springs of a layout, of this length, with their histories from word `at` on.
    pub fn new(material: Material, layout: &Layout, length: f64, at: usize) -> Self {
        let lever = [vec![1.0; layout.y.len()], layout.z.clone(), layout.y.iter().map(|y| -y).collect()];
        let times = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<_>>();
        let arm = lever.each_ref().map(|l| times(l, &layout.area));
        let second = PAIRS.map(|(i, j)| times(&arm[i], &lever[j]));
        Self { material, at, memory: Memory::Committed, length, lever, arm, second }
    }

    /// The same springs with their histories from word `at` on.
    pub fn at(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// The same springs, asked by an element that counts its calls.
    pub fn counting_calls(self) -> Self {
        Self { memory: Memory::Calls, ..self }
    }

    /// The same, of which only the first `n` commit their histories.
    pub fn remembering(self, n: usize) -> Self {
        let mut virgin = vec![0.0; self.state_len()];
        self.clone().at(0).init(&mut virgin);
        Self { memory: Memory::Forgetful(n.min(self.len()), virgin), ..self }
    }

    /// Number of springs.
    pub fn len(&self) -> usize {
        self.lever[0].len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of words that they take.
    pub fn state_len(&self) -> usize {
        self.len() * self.material.state_len()
    }

    /// Their material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Write the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let words = self.material.state_len();
        for spring in 0..self.len() {
            let at = self.at + spring * words;
            self.material.init(&mut state[at..at + words]);
        }
    }

    /// Forces at deformations: extension, rotations about y and z; with the rates of these.
    pub fn respond(
        &self,
        committed: &[f64],
        deformation: [f64; 3],
        rate: [f64; 3],
        dt: f64,
        trial: &mut [f64],
    ) -> Result<Section, MaterialError> {
        let viscous = self.material.is_viscous();
        let [strain, rate] = [deformation, rate].map(|e| e.map(|e| e / self.length));
        let words = self.material.state_len();
        let (mut force, mut stiffness, mut damping) = ([0.0; 3], [0.0; 6], [0.0; 6]);
        let (mut strains, mut rates) = ([0.0; CHUNK], [0.0; CHUNK]);
        let (mut value, mut tangent, mut viscosity) = ([0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK]);
        let cut = if let Memory::Forgetful(n, _) = &self.memory { *n } else { self.len() };
        let chunks = [0..cut, cut..self.len()].into_iter().flat_map(|part| {
            let end = part.end;
            part.step_by(CHUNK).map(move |first| first..(first + CHUNK).min(end))
        });
        for springs in chunks {
            let n = springs.len();
            self.spread(strain, springs.start, &mut strains[..n]);
            if viscous {
                self.spread(rate, springs.start, &mut rates[..n]);
            }
            let at = self.at + springs.start * words..self.at + springs.end * words;
            let old = match &self.memory {
                Memory::Forgetful(n, virgin) if springs.start >= *n => {
                    &virgin[springs.start * words..springs.end * words]
                }
                _ => &committed[at.clone()],
            };
            let strains = Strains { value: &strains[..n], rate: &rates[..n], dt };
            let mut stresses =
                Stresses { value: &mut value[..n], tangent: &mut tangent[..n], damping: &mut viscosity[..n] };
            match self.memory {
                Memory::Committed => self.material.update_all(old, &strains, &mut trial[at], &mut stresses)?,
                _ => self.material.update_all_on(old, &strains, &mut trial[at], &mut stresses)?,
            }
            force.iter_mut().zip(&self.arm).for_each(|(f, arm)| *f += dot(&arm[springs.clone()], &value[..n]));
            for (pair, second) in self.second.iter().enumerate() {
                stiffness[pair] += dot(&second[springs.clone()], &tangent[..n]);
                if viscous {
                    damping[pair] += dot(&second[springs.clone()], &viscosity[..n]);
                }
            }
        }
        Ok(Section { force, stiffness: self.matrix(stiffness), damping: self.matrix(damping) })
    }

    /// Strains of the springs from number `first` on.
    #[inline]
    fn spread(&self, e: [f64; 3], first: usize, out: &mut [f64]) {
        for ((out, z), y) in out.iter_mut().zip(&self.lever[1][first..]).zip(&self.lever[2][first..]) {
            *out = e[0] + z * e[1] + y * e[2];
        }
    }

    /// Stiffness of the virgin section.
    pub fn initial_stiffness(&self) -> [[f64; 3]; 3] {
        let e = self.material.initial_tangent();
        self.matrix(self.second.each_ref().map(|s| e * s.iter().sum::<f64>()))
    }

    /// Matrix of sums over the springs, by their length.
    fn matrix(&self, sums: [f64; 6]) -> [[f64; 3]; 3] {
        let mut m = [[0.0; 3]; 3];
        for ((i, j), sum) in PAIRS.into_iter().zip(sums) {
            (m[i][j], m[j][i]) = (sum / self.length, sum / self.length);
        }
        m
    }
}
