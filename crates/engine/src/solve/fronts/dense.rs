//! Elimination of a front: dense matrices by faer, in blocks that do not depend on the number of threads.

use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_unit_lower_triangular_in_place};
use faer::{Accum, MatMut, MatRef, Par};

/// Up to so many columns are eliminated one by one.
const FEW: usize = 16;
/// Rows or columns that one thread takes at once.
const BLOCK: usize = 128;

/// Both, side by side where there are threads for it.
fn both(parallel: bool, a: impl FnOnce() + Send, b: impl FnOnce() + Send) {
    if parallel {
        rayon::join(a, b);
    } else {
        a();
        b();
    }
}

/// Calls `each` with blocks of the rows of a matrix and the first row of each.
fn by_rows(parallel: bool, first: usize, m: MatMut<'_, f64>, each: &(impl Fn(usize, MatMut<'_, f64>) + Sync)) {
    let n = m.nrows();
    if n <= BLOCK {
        return each(first, m);
    }
    let half = (n / 2).next_multiple_of(BLOCK).min(n - 1);
    let (top, bottom) = m.split_at_row_mut(half);
    both(parallel, || by_rows(parallel, first, top, each), || by_rows(parallel, first + half, bottom, each));
}

/// c -= a b, of a symmetric c the lower triangle alone.
pub(super) fn subtract(parallel: bool, lower_only: bool, c: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    // Blocks of columns are blocks of rows of the transposed matrix.
    by_rows(parallel, 0, c.transpose_mut(), &|first, rows| {
        let (count, columns) = (rows.nrows(), rows.transpose_mut());
        let b = b.subcols(first, count);
        let top = if lower_only { first } else { 0 };
        let (_, columns) = columns.split_at_row_mut(top);
        matmul(columns, Accum::Add, a.subrows(top, a.nrows() - top), b, -1.0, Par::Seq);
    });
}

/// L and U of a square matrix without row exchanges, in its place. L has ones on its diagonal, which are not kept.
pub(super) fn lu(parallel: bool, mut a: MatMut<'_, f64>) {
    let n = a.nrows();
    if n <= FEW {
        for k in 0..n {
            let inverse = 1.0 / a[(k, k)];
            for i in k + 1..n {
                a[(i, k)] *= inverse;
            }
            for j in k + 1..n {
                let u = a[(k, j)];
                for i in k + 1..n {
                    a[(i, j)] = a[(i, k)].mul_add(-u, a[(i, j)]);
                }
            }
        }
        return;
    }
    let (mut first, right, left, mut rest) = a.split_at_mut(n / 2, n / 2);
    lu(parallel, first.as_mut());
    let (right, left) = (right_of(parallel, first.as_ref(), right), left_of(parallel, first.as_ref(), left));
    subtract(parallel, false, rest.as_mut(), left.as_ref(), right.as_ref());
    lu(parallel, rest);
}

/// L⁻¹ b of the factors of a square matrix, in the place of b.
fn right_of<'a>(parallel: bool, factors: MatRef<'_, f64>, b: MatMut<'a, f64>) -> MatMut<'a, f64> {
    left_of_transposed(parallel, factors, b.transpose_mut()).transpose_mut()
}

/// bᵀ with L⁻¹ b in the place of b.
pub(super) fn left_of_transposed<'a>(
    parallel: bool,
    factors: MatRef<'_, f64>,
    mut b: MatMut<'a, f64>,
) -> MatMut<'a, f64> {
    by_rows(parallel, 0, b.as_mut(), &|_, rows| {
        solve_unit_lower_triangular_in_place(factors, rows.transpose_mut(), Par::Seq);
    });
    b
}

/// b U⁻¹ of the factors of a square matrix, in the place of b.
pub(super) fn left_of<'a>(parallel: bool, factors: MatRef<'_, f64>, mut b: MatMut<'a, f64>) -> MatMut<'a, f64> {
    by_rows(parallel, 0, b.as_mut(), &|_, rows| {
        solve_lower_triangular_in_place(factors.transpose(), rows.transpose_mut(), Par::Seq);
    });
    b
}
