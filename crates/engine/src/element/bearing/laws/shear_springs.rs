//! Shear springs in a circle: bidirectional shear of a bearing from uniaxial laws.

use crate::element::Histories;
use crate::material::{
    LimitCurve, Material, MaterialError, ObservedColumns, Strain, Strains, Stresses, WatchesColumns, observe_points,
};
use std::f64::consts::PI;

/// Springs in the directions θ = π i/n of the shear plane (Wada and Hirose, 1989), of one or several materials. Their
/// state variables follow each other in the state of their owner, then those of two auxiliary springs.
///
/// With a limit u₀ the forces are multiplied by a factor. The reference is a virgin bundle of the first material,
/// sheared in one direction to max(|u|, u₀). The factor gives it the force of a single spring. Without a limit there is
/// no factor, and n springs are about n/2 times as stiff as one.
#[derive(Clone, Debug)]
pub struct ShearSprings {
    groups: Vec<SpringGroup>,
    directions: Vec<[f64; 2]>,
    limit: Option<f64>,
    /// Virgin state of the first material.
    virgin: Vec<f64>,
    /// Index of the two auxiliary springs: the one evaluated for the factors, and its response.
    auxiliary_at: usize,
}

/// Neighbouring springs of one material.
#[derive(Clone, Debug)]
struct SpringGroup {
    material: Material,
    at: usize,
    springs: std::ops::Range<usize>,
}

/// Forces of a bundle along y and z, without the factors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bundle {
    /// Forces.
    pub force: [f64; 2],
    /// Derivatives by the displacements.
    pub stiffness: [[f64; 2]; 2],
    /// Derivatives by the velocities, for viscous materials.
    pub damping: [[f64; 2]; 2],
}

/// Factors of the forces and stiffnesses of a bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// Factor of the forces.
    pub force: f64,
    /// Factor of the stiffness in OpenSees, in place of the derivative of the forces.
    pub stiffness: f64,
    /// Derivative of the factor of the forces by the size of the displacement.
    pub slope: f64,
}

impl Factors {
    /// Factors of 1.
    pub const ONE: Self = Self { force: 1.0, stiffness: 1.0, slope: 0.0 };
}

/// Number of springs updated in one call: their stresses are on the stack.
const CHUNK_LEN: usize = 32;

impl WatchesColumns for ShearSprings {
    fn limit_curves(&self) -> Vec<&LimitCurve> {
        self.groups.iter().flat_map(|group| group.material.limit_curves()).collect()
    }
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>) {
        for SpringGroup { material, at, springs } in &self.groups {
            let len = material.state_len();
            for first in (0..springs.len()).step_by(CHUNK_LEN) {
                let n = CHUNK_LEN.min(springs.len() - first);
                let range = at + first * len..at + (first + n) * len;
                observe_points(material, n, &mut committed[range], columns);
            }
        }
    }
}

impl ShearSprings {
    /// Makes `n` springs of one material, with state variables from index `at` on.
    pub fn new(material: Material, n: usize, limit: Option<f64>, at: usize) -> Self {
        Self::of(vec![(material, n)], limit, at)
    }

    /// Makes springs of several materials, each with its number of neighbouring springs. At least one material is
    /// needed.
    pub fn of(materials: Vec<(Material, usize)>, limit: Option<f64>, at: usize) -> Self {
        let n: usize = materials.iter().map(|(_, n)| n).sum();
        let directions = (0..n).map(|i| PI * i as f64 / n as f64).map(|angle| [angle.cos(), angle.sin()]).collect();
        let mut virgin = vec![0.0; materials.first().map_or(0, |(m, _)| m.state_len())];
        let (mut groups, mut auxiliary_at, mut first) = (Vec::with_capacity(materials.len()), at, 0);
        for (material, n) in materials {
            let len = n * material.state_len();
            groups.push(SpringGroup { material, at: auxiliary_at, springs: first..first + n });
            auxiliary_at += len;
            first += n;
        }
        if let Some(group) = groups.first() {
            group.material.init(&mut virgin);
        }
        Self { groups, directions, limit, virgin, auxiliary_at }
    }

    /// Number of state variables.
    pub fn state_len(&self) -> usize {
        let first = self.groups.first().map_or(self.auxiliary_at, |group| group.at);
        self.auxiliary_at - first + 2 * self.virgin.len()
    }

    /// Materials of the springs.
    pub fn materials(&self) -> impl Iterator<Item = &Material> {
        self.groups.iter().map(|group| &group.material)
    }

    /// Returns true if the forces have a factor that depends on the displacement.
    pub fn is_limited(&self) -> bool {
        self.limit.is_some()
    }

    /// Writes the virgin state variables.
    pub fn init(&self, state: &mut [f64]) {
        for SpringGroup { material, at, springs } in &self.groups {
            let len = material.state_len();
            for first in (0..springs.len()).step_by(CHUNK_LEN) {
                let n = CHUNK_LEN.min(springs.len() - first);
                material.init_all(n, &mut state[at + first * len..at + (first + n) * len]);
            }
        }
        let len = self.virgin.len();
        for at in [self.auxiliary_at, self.auxiliary_at + len] {
            state[at..at + len].copy_from_slice(&self.virgin);
        }
    }

    /// Copies the state variables of a trial state.
    pub fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        for SpringGroup { material, at, springs } in &self.groups {
            let range = *at..at + springs.len() * material.state_len();
            let (trial, committed) = (&trial[range.clone()], &mut committed[range]);
            match material.roles().commit {
                Some(law) => law.commit_all(trial, committed),
                None => committed.copy_from_slice(trial),
            }
        }
        // Of the auxiliary springs only the first has a committed state.
        let auxiliary = self.auxiliary_at..self.auxiliary_at + self.virgin.len();
        committed[auxiliary.clone()].copy_from_slice(&trial[auxiliary]);
    }

    /// Forces at displacements along y and z, and their rates.
    ///
    /// # Errors
    /// Errors of the materials.
    pub fn respond(
        &self,
        h: &mut Histories<'_>,
        u: [f64; 2],
        rate: [f64; 2],
        dt: f64,
    ) -> Result<Bundle, MaterialError> {
        let mut sum = Bundle::default();
        let (mut strains, mut rates) = ([0.0; CHUNK_LEN], [0.0; CHUNK_LEN]);
        let (mut value, mut tangent, mut damping) = ([0.0; CHUNK_LEN], [0.0; CHUNK_LEN], [0.0; CHUNK_LEN]);
        let chunks = self.groups.iter().flat_map(|group| {
            let len = group.material.state_len();
            let chunks = self.directions[group.springs.clone()].chunks(CHUNK_LEN).enumerate();
            chunks.map(move |(i, directions)| (group, group.at + i * CHUNK_LEN * len, directions))
        });
        for (group, at, directions) in chunks {
            let n = directions.len();
            let at = at..at + n * group.material.state_len();
            for ((e, r), [c, s]) in strains.iter_mut().zip(&mut rates).zip(directions) {
                (*e, *r) = (c * u[0] + s * u[1], c * rate[0] + s * rate[1]);
            }
            group.material.update_all(
                &h.committed[at.clone()],
                &Strains { value: &strains[..n], rate: &rates[..n], dt },
                &mut h.trial[at],
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
        for group in &self.groups {
            let k = group.material.initial_tangent();
            for d in &self.directions[group.springs.clone()] {
                for a in 0..2 {
                    for b in 0..2 {
                        sum[a][b] += k * d[a] * d[b];
                    }
                }
            }
        }
        sum
    }

    /// Factors at a displacement of this size, from the committed state of the owner. `trial` is workspace, and keeps
    /// the state that OpenSees' springs retain after an evaluation.
    ///
    /// # Errors
    /// A virgin bundle without resistance.
    pub fn factors(&self, size: f64, h: &mut Histories<'_>) -> Result<Factors, MaterialError> {
        let auxiliary = self.auxiliary_at..self.auxiliary_at + self.virgin.len();
        h.trial[auxiliary.clone()].copy_from_slice(&h.committed[auxiliary]);
        let (Some(limit), Some(SpringGroup { material, .. })) = (self.limit, self.groups.first()) else {
            return Ok(Factors::ONE);
        };
        let len = self.virgin.len();
        let (auxiliary, response) = h.trial[self.auxiliary_at..self.auxiliary_at + 2 * len].split_at_mut(len);
        let (u, trace) = (size.max(limit), material.roles().trace);
        let mut at = |value: f64| {
            let stress = material.update(auxiliary, Strain { value, rate: 0.0, dt: 0.0 }, response)?;
            if let Some(law) = trace {
                law.leave_trace(response, auxiliary);
            }
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
