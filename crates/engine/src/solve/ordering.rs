//! Fill-reducing ordering and the pattern of the factors, by faer.

use super::SolveError;
use crate::assembly::{Pattern, Storage};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::cholesky::{CholeskySymbolicParams, SymbolicCholesky, SymmetricOrdering};
use faer::sparse::linalg::{SupernodalThreshold, cholesky};

/// The pattern as faer sees it.
pub(super) fn symbolic(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(pattern.n, pattern.n, &pattern.col_ptr, None, &pattern.row_idx)
}

/// Symbolic Cholesky factors of the (symmetrised) pattern, ordered by approximate minimum degree.
pub(super) fn cholesky(
    pattern: &Pattern,
    threshold: SupernodalThreshold,
) -> Result<SymbolicCholesky<usize>, SolveError> {
    debug_assert!(pattern.storage != Storage::Dense);
    let params = CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..Default::default() };
    cholesky::factorize_symbolic_cholesky(symbolic(pattern), faer::Side::Upper, SymmetricOrdering::Amd, params)
        .map_err(|_| SolveError::OutOfMemory)
}

/// Equation of each row of the factors, and row of each equation.
pub(super) fn permutation(symbolic: &SymbolicCholesky<usize>, n: usize) -> (Vec<usize>, Vec<usize>) {
    match symbolic.perm() {
        Some(p) => (p.arrays().0.to_vec(), p.arrays().1.to_vec()),
        None => ((0..n).collect(), (0..n).collect()),
    }
}
