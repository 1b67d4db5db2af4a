//! Sparse symmetric systems: LDLᵀ by faer, simplicial or supernodal.

use super::{Pivots, SolveError, ordering};
use crate::assembly::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{LdltRef, SymbolicCholesky, SymbolicCholeskyRaw};
use faer::{Conj, MatMut, Par, Side, Spec};

/// Factors of a symmetric matrix.
pub(super) struct Ldlt {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    /// Diagonal of the matrix.
    diagonal: Vec<f64>,
    memory: MemBuffer,
}

impl std::fmt::Debug for Ldlt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Ldlt").field("values", &self.values.len()).finish_non_exhaustive()
    }
}

impl Ldlt {
    pub(super) fn new(pattern: &Pattern) -> Result<Self, SolveError> {
        let symbolic = ordering::cholesky(pattern, SupernodalThreshold::AUTO)?;
        let factor = symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default());
        let solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let memory = MemBuffer::new(factor.or(solve));
        Ok(Self { values: vec![0.0; symbolic.len_val()], diagonal: vec![0.0; pattern.n], symbolic, memory })
    }

    /// Multiplications of a factorisation and of a solution, about.
    pub(super) fn work(&self) -> (f64, f64) {
        let (n, nnz) = (self.diagonal.len() as f64, self.values.len() as f64);
        // As if all columns were of the same length; they are not, so it is more.
        (0.5 * nnz * nnz / n.max(1.0), 2.0 * nnz)
    }

    pub(super) fn factor(&mut self, pattern: &Pattern, values: &[f64]) -> Result<Pivots, SolveError> {
        for (j, d) in self.diagonal.iter_mut().enumerate() {
            // In the upper triangle the diagonal ends each column.
            *d = values[pattern.col_ptr[j + 1] - 1];
        }
        let a = SparseColMatRef::new(ordering::symbolic(pattern), values);
        let regularization = LdltRegularization {
            dynamic_regularization_signs: None,
            dynamic_regularization_delta: 0.0,
            dynamic_regularization_epsilon: 0.0,
        };
        let result = self.symbolic.factorize_numeric_ldlt(
            &mut self.values,
            a,
            Side::Upper,
            regularization,
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        );
        if let Err(LdltError::ZeroPivot { index }) = result {
            // The index may be one within a supernode.
            let mut equation = None;
            self.see_pivots(|own, d| equation = equation.or((d == 0.0 || !d.is_finite()).then_some(own)));
            return Err(SolveError::Singular { equation: equation.unwrap_or_else(|| self.original(index)) });
        }
        Ok(self.pivots())
    }

    /// Equation of a row of the factors.
    fn original(&self, row: usize) -> usize {
        self.symbolic.perm().map_or(row, |p| p.arrays().0[row])
    }

    fn pivots(&self) -> Pivots {
        let mut pivots = Pivots::GOOD;
        self.see_pivots(|equation, d| pivots.see(equation, d, self.diagonal[equation]));
        pivots
    }

    /// Calls `look` with the equation and value of each pivot in the order of the elimination.
    fn see_pivots(&self, mut look: impl FnMut(usize, f64)) {
        let mut see = |row: usize, d: f64| look(self.original(row), d);
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(s) => {
                // The pivot is the first entry of each column.
                s.col_ptr()[..s.ncols()].iter().enumerate().for_each(|(j, &at)| see(j, self.values[at]));
            }
            SymbolicCholeskyRaw::Supernodal(s) => {
                for k in 0..s.n_supernodes() {
                    let (start, end) = (s.supernode_begin()[k], s.supernode_end()[k]);
                    let at = s.col_ptr_for_val()[k];
                    let width = end - start;
                    let rows = (s.col_ptr_for_val()[k + 1] - at) / width.max(1);
                    (0..width).for_each(|j| see(start + j, self.values[at + j * rows + j]));
                }
            }
        }
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        let n = x.len();
        LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, n, 1),
            Par::Seq,
            MemStack::new(&mut self.memory),
        );
    }
}
