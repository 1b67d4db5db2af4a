//! Shear springs in a circle: bidirectional shear of a bearing from uniaxial laws.

use crate::material::{Material, MaterialError, Strain, Strains, Stresses};
use std::f64::consts::PI;

/// Springs in the directions θ = π i/n of the plane of shear (Wada and Hirose, 1989), of one material or of several; their
/// histories lie one after the other in the state of their owner, behind them room for two more.
///
/// With a limit u₀ the forces are multiplied so that the bundle, sheared in one direction from the virgin state to
/// max(|u|, u₀), carries the force of one spring alone, all of the first material; |u| is the size of the displacement. Without one they are
/// not, and n springs are about n/2 times as stiff as one.
#[derive(Clone, Debug)]
pub struct ShearSprings {
    runs: Vec<Run>,
    directions: Vec<[f64; 2]>,
    limit: Option<f64>,
    /// Virgin state of the first material.
    virgin: Vec<f64>,
    /// Where there is room for two springs, after all others: one that is tried for the factors, and what it answers.
    room: usize,
}

/// Neighbouring springs of one material.
#[derive(Clone, Debug)]
struct Run {
    material: Material,
    at: usize,
    springs: std::ops::Range<usize>,
}

/// Forces of a bundle along y and z, before they are multiplied by the factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bundle {
    /// Forces.
    pub force: [f64; 2],
    /// Derivatives by the displacements.
    pub stiffness: [[f64; 2]; 2],
    /// Derivatives by the velocities, of viscous materials.
    pub damping: [[f64; 2]; 2],
}

/// What the forces and stiffnesses of a bundle are multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// Factor of the forces.
    pub force: f64,
    /// Factor that OpenSees multiplies the stiffness by, instead of deriving the forces.
    pub stiffness: f64,
    /// Derivative of the factor of the forces by the size of the displacement.
    pub slope: f64,
}

impl Factors {
    /// No factors.
    pub const ONE: Self = Self { force: 1.0, stiffness: 1.0, slope: 0.0 };
}

/// Springs updated at a time, so that their stresses stay on the stack.
const CHUNK: usize = 32;

impl ShearSprings {
    /// `n` springs of one material with their histories from word `at` on.
    pub fn new(material: Material, n: usize, limit: Option<f64>, at: usize) -> Self {
        Self::of(vec![(material, n)], limit, at)
    }

    /// Springs of several materials, each with the number of neighbouring springs that are of it; at least one.
    pub fn of(materials: Vec<(Material, usize)>, limit: Option<f64>, at: usize) -> Self {
        let n: usize = materials.iter().map(|(_, n)| n).sum();
        let directions = (0..n).map(|i| PI * i as f64 / n as f64).map(|angle| [angle.cos(), angle.sin()]).collect();
        let mut virgin = vec![0.0; materials.first().map_or(0, |(m, _)| m.state_len())];
        let (mut runs, mut room, mut first) = (Vec::with_capacity(materials.len()), at, 0);
        for (material, n) in materials {
            let words = n * material.state_len();
            runs.push(Run { material, at: room, springs: first..first + n });
            room += words;
            first += n;
        }
        if let Some(run) = runs.first() {
            run.material.init(&mut virgin);
        }
        Self { runs, directions, limit, virgin, room }
    }

    /// Number of words that they take.
    pub fn state_len(&self) -> usize {
        let first = self.runs.first().map_or(self.room, |run| run.at);
        self.room - first + 2 * self.virgin.len()
    }

    /// Their materials.
    pub fn materials(&self) -> impl Iterator<Item = &Material> {
        self.runs.iter().map(|run| &run.material)
    }

    /// Whether their forces are multiplied by factors that depend on the displacement.
    pub fn is_limited(&self) -> bool {
        self.limit.is_some()
    }

    /// Write the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        for Run { material, at, springs } in &self.runs {
            let words = material.state_len();
            for first in (0..springs.len()).step_by(CHUNK) {
                let n = CHUNK.min(springs.len() - first);
                material.init_all(n, &mut state[at + first * words..at + (first + n) * words]);
            }
        }
        let words = self.virgin.len();
        for room in [self.room, self.room + words] {
            state[room..room + words].copy_from_slice(&self.virgin);
        }
    }

    /// Take over their histories of a trial state.
    pub fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        for Run { material, at, springs } in &self.runs {
            let words = *at..at + springs.len() * material.state_len();
            material.commit_all(&trial[words.clone()], &mut committed[words]);
        }
        // Of the two that are tried, one is worked with.
        let tried = self.room..self.room + self.virgin.len();
        committed[tried.clone()].copy_from_slice(&trial[tried]);
    }

    /// Forces at displacements along y and z, with their rates.
    pub fn respond(
        &self,
        committed: &[f64],
        u: [f64; 2],
        rate: [f64; 2],
        dt: f64,
        trial: &mut [f64],
    ) -> Result<Bundle, MaterialError> {
        let mut sum = Bundle::default();
        let (mut strains, mut rates) = ([0.0; CHUNK], [0.0; CHUNK]);
        let (mut value, mut tangent, mut damping) = ([0.0; CHUNK], [0.0; CHUNK], [0.0; CHUNK]);
        let chunks = self.runs.iter().flat_map(|run| {
            let words = run.material.state_len();
            let chunks = self.directions[run.springs.clone()].chunks(CHUNK).enumerate();
            chunks.map(move |(i, directions)| (run, run.at + i * CHUNK * words, directions))
        });
        for (run, at, directions) in chunks {
            let n = directions.len();
            let at = at..at + n * run.material.state_len();
            for ((e, r), [c, s]) in strains.iter_mut().zip(&mut rates).zip(directions) {
                (*e, *r) = (c * u[0] + s * u[1], c * rate[0] + s * rate[1]);
            }
            run.material.update_all(
                &committed[at.clone()],
                &Strains { value: &strains[..n], rate: &rates[..n], dt },
                &mut trial[at],
                &mut Stresses { value: &mut value[..n], tangent: &mut tangent[..n], damping: &mut damping[..n] },
            )?;
            for (i, d) in directions.iter().enumerate() {
                let products = [d[0] * d[0], d[0] * d[1], d[1] * d[1]];
                for a in 0..2 {
                    sum.force[a] += value[i] * d[a];
                    for b in 0..2 {
                        sum.stiffness[a][b] += tangent[i] * products[a + b];
                        sum.damping[a][b] += damping[i] * products[a + b];
                    }
                }
            }
        }
        Ok(sum)
    }

    /// Stiffness of the virgin bundle.
    pub fn initial_stiffness(&self) -> [[f64; 2]; 2] {
        let mut sum = [[0.0; 2]; 2];
        for run in &self.runs {
            let k = run.material.initial_tangent();
            for d in &self.directions[run.springs.clone()] {
                for a in 0..2 {
                    for b in 0..2 {
                        sum[a][b] += k * d[a] * d[b];
                    }
                }
            }
        }
        sum
    }

    /// Factors at a displacement of this size, from the committed state of the owner; `trial` has room to work, and keeps
    /// what OpenSees' springs remember of having been tried.
    ///
    /// # Errors
    /// A virgin bundle that resists no displacement.
    pub fn factors(&self, size: f64, committed: &[f64], trial: &mut [f64]) -> Result<Factors, MaterialError> {
        let tried = self.room..self.room + self.virgin.len();
        trial[tried.clone()].copy_from_slice(&committed[tried]);
        let (Some(limit), Some(Run { material, .. })) = (self.limit, self.runs.first()) else {
            return Ok(Factors::ONE);
        };
        let words = self.virgin.len();
        let (tried, answer) = trial[self.room..self.room + 2 * words].split_at_mut(words);
        let u = size.max(limit);
        let mut at = |value: f64| {
            let stress = material.update(tried, Strain { value, rate: 0.0, dt: 0.0 }, answer)?;
            material.leave_trace(answer, tried);
            Ok::<_, MaterialError>(stress)
        };
        let one = at(u)?;
        let (mut force, mut stiffness) = (0.0, 0.0);
        for [c, _] in &self.directions {
            let s = at(u * c)?;
            force += s.value * c;
            stiffness += s.tangent * c * c;
        }
        if force == 0.0 || stiffness == 0.0 {
            return Err(MaterialError(format!("the virgin shear springs do not resist a displacement of {u}")));
        }
        let factor = one.value / force;
        let slope = if size > limit { (one.tangent - factor * stiffness) / force } else { 0.0 };
        Ok(Factors { force: factor, stiffness: one.tangent / stiffness, slope })
    }
}
