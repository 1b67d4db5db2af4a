//! Sparse systems that need row exchanges: LU by faer.

use super::{Pivots, SolveError, ordering};
use crate::assembly::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::LuError;
use faer::sparse::linalg::lu::{LuRef, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::{Conj, MatMut, Par, Spec};

/// Factors of any regular matrix.
pub(super) struct PivotedLu {
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
    memory: MemBuffer,
}

impl std::fmt::Debug for PivotedLu {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PivotedLu").finish_non_exhaustive()
    }
}

impl PivotedLu {
    pub(super) fn new(pattern: &Pattern) -> Result<Self, SolveError> {
        let symbolic = factorize_symbolic_lu(ordering::symbolic(pattern), Default::default())
            .map_err(|_| SolveError::OutOfMemory)?;
        let factor = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Spec::default());
        let solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let memory = MemBuffer::new(factor.or(solve));
        Ok(Self { symbolic, numeric: NumericLu::new(), memory })
    }

    /// Only an exact zero is found out: the pivots of faer's LU are not to be had.
    pub(super) fn factor(&mut self, pattern: &Pattern, values: &[f64]) -> Result<Pivots, SolveError> {
        let a = SparseColMatRef::new(ordering::symbolic(pattern), values);
        let result = self.symbolic.factorize_numeric_lu(
            &mut self.numeric,
            a,
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        );
        match result {
            Ok(_) => Ok(Pivots::GOOD),
            Err(LuError::SymbolicSingular { index }) => Err(SolveError::Singular { equation: index }),
            Err(LuError::Generic(_)) => Err(SolveError::OutOfMemory),
        }
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        let n = x.len();
        // Safety of the pairing: `numeric` is only ever filled by `factor` with this `symbolic`.
        let factors = LuRef::new_unchecked(&self.symbolic, &self.numeric);
        factors.solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, n, 1),
            Par::Seq,
            MemStack::new(&mut self.memory),
        );
    }
}
