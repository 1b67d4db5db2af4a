//! Laws in space in series: one stress, and strains that add up with weights.

use super::plain_methods::{inner_methods, plain_methods};
use super::{Multiaxial, SOLID, SharedMultiaxial, Tangent, WeightedLaws};
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};
use crate::probe::Probe;
use nalgebra::{SMatrix, SVector};
use std::sync::Arc;

type Matrix = SMatrix<f64, SOLID, SOLID>;
type Vector = SVector<f64, SOLID>;

/// Factor on the number of iterations with the initial tangents.
const PATIENCE: usize = 10;

/// When the stresses of the laws count as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesTolerance {
    /// Largest number of iterations.
    pub iterations: usize,
    /// Difference of the stresses over their size.
    pub relative: f64,
    /// Difference of the stresses.
    pub absolute: f64,
}

/// Laws in series: all have the stress σ, and Σ w ε is the strain.
///
/// The state begins with the strains of all laws.
#[derive(Clone, Debug)]
pub struct SeriesSolids {
    /// The laws with their weights.
    pub laws: WeightedLaws,
    /// Accuracy of the equilibrium.
    pub tolerance: SeriesTolerance,
}

fn matrix(t: &Tangent<SOLID>) -> Matrix {
    Matrix::from_fn(|i, j| t[i][j])
}

impl SeriesSolids {
    /// Number of strains in front of the states of the laws.
    fn strains(&self) -> usize {
        SOLID * self.laws.len()
    }

    /// Stiffness of stiffnesses in series; `None` if one is singular.
    fn combined(&self, inverses: &[Matrix]) -> Option<Matrix> {
        let flexibility: Matrix = inverses.iter().zip(self.laws.iter()).map(|(f, (_, w))| f * *w).sum();
        flexibility.try_inverse()
    }

    fn initial_inverses(&self) -> Option<Vec<Matrix>> {
        self.laws.iter().map(|(law, _)| matrix(&law.initial_tangent()).try_inverse()).collect()
    }

    /// Stresses and tangents at strains of the laws.
    fn evaluate(
        &self,
        mut committed: &[f64],
        strains: &[Vector],
        dt: f64,
        mut next: &mut [f64],
    ) -> MaterialResult<Vec<(Vector, Matrix)>> {
        let mut out = vec![];
        for ((law, _), strain) in self.laws.iter().zip(strains) {
            let (own, rest) = committed.split_at(law.state_len());
            let (trial, after) = next.split_at_mut(law.state_len());
            let (stress, tangent) = law.update(own, &(*strain).into(), dt, trial)?;
            out.push((Vector::from(stress), matrix(&tangent)));
            (committed, next) = (rest, after);
        }
        Ok(out)
    }

    /// Iterates on the strains; false if the stresses do not become one.
    fn iterate(
        &self,
        (committed, e, dt): (&[f64], &Vector, f64),
        strains: &mut [Vector],
        next: &mut [f64],
        initial: Option<&[Matrix]>,
    ) -> MaterialResult<Option<(Vector, Matrix)>> {
        let SeriesTolerance { iterations, relative, absolute } = self.tolerance;
        let iterations = if initial.is_some() { PATIENCE * iterations } else { iterations };
        let mut best = f64::INFINITY;
        for round in 0..=iterations {
            let now = self.evaluate(committed, strains, dt, next)?;
            let inverses: Option<Vec<Matrix>> = match initial {
                Some(initial) => Some(initial.to_vec()),
                None => now.iter().map(|(_, k)| k.try_inverse()).collect(),
            };
            let Some(inverses) = inverses else { return Ok(None) };
            let Some(stiffness) = self.combined(&inverses) else { return Ok(None) };
            // Strain that is left, and what the stresses take to become one.
            let total: Vector = strains.iter().zip(self.laws.iter()).map(|(s, (_, w))| s * *w).sum();
            let by_stress: Vector =
                now.iter().zip(&inverses).zip(self.laws.iter()).map(|(((s, _), f), (_, w))| f * s * *w).sum();
            let stress = stiffness * (e - total + by_stress);
            let error = now.iter().map(|(s, _)| (s - stress).norm()).fold(0.0, f64::max);
            let size = now.iter().map(|(s, _)| s.norm()).fold(0.0, f64::max);
            let small = error <= absolute.min(relative * size.max(f64::MIN_POSITIVE)) && round > 0;
            // Beyond the tolerance the iteration goes on while it still helps.
            if error <= f64::EPSILON * size || small && error >= 0.1 * best {
                let tangents: Option<Vec<Matrix>> = now.iter().map(|(_, k)| k.try_inverse()).collect();
                let tangent = tangents.and_then(|t| self.combined(&t)).unwrap_or(stiffness);
                return Ok(Some((stress, tangent)));
            }
            best = best.min(error);
            if !error.is_finite() {
                return Ok(None);
            }
            for ((strain, (s, _)), f) in strains.iter_mut().zip(&now).zip(&inverses) {
                *strain += f * (stress - s);
            }
        }
        Ok(None)
    }
}

crate::watches_columns!(SeriesSolids => |s| at [(s.strains()..s.strains() + s.laws.state_len(), &s.laws)]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<SOLID> for SeriesSolids {
    plain_methods! { SOLID: shown_stress }
    fn state_len(&self) -> usize {
        self.strains() + self.laws.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        let (strains, rest) = state.split_at_mut(self.strains());
        strains.fill(0.0);
        self.laws.init(rest);
    }
    inner_methods! { laws: is_linear is_symmetric properties }

    fn update(&self, committed: &[f64], e: &[f64; SOLID], dt: f64, next: &mut [f64]) -> MultiaxialResult<SOLID> {
        let (old, histories) = committed.split_at(self.strains());
        let (found, trial) = next.split_at_mut(self.strains());
        let e = Vector::from(*e);
        let start = || -> Vec<Vector> { old.chunks_exact(SOLID).map(Vector::from_column_slice).collect() };
        let mut strains = start();
        let mut result = self.iterate((histories, &e, dt), &mut strains, trial, None)?;
        if result.is_none() {
            strains = start();
            let initial = self.initial_inverses();
            result = match &initial {
                Some(initial) => self.iterate((histories, &e, dt), &mut strains, trial, Some(initial))?,
                None => None,
            };
        }
        let Some((stress, tangent)) = result else {
            return Err(MaterialError("the laws in series find no common stress".into()));
        };
        found.chunks_exact_mut(SOLID).zip(&strains).for_each(|(out, s)| out.copy_from_slice(s.as_slice()));
        Ok((stress.into(), std::array::from_fn(|i| std::array::from_fn(|j| tangent[(i, j)]))))
    }

    fn initial_tangent(&self) -> Tangent<SOLID> {
        let tangent = self.initial_inverses().and_then(|inverses| self.combined(&inverses)).unwrap_or_default();
        std::array::from_fn(|i| std::array::from_fn(|j| tangent[(i, j)]))
    }

    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<SOLID>> {
        Some(Arc::new(Self { laws: self.laws.of_length(length)?, ..self.clone() }))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.laws.probe(words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.laws.read(path, &state[self.strains()..], out);
    }
}
