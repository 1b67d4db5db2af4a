//! Sparse unsymmetric systems with a symmetric pattern: LU without row exchanges.
//!
//! The tangents of coupled bearings are unsymmetric, but as strongly diagonal as those of other structures: the order
//! that faer finds for a symmetric matrix serves, the pattern of L is that of Uᵀ, and the factors are worked out in
//! place with no bookkeeping. Four times as fast as an LU that looks for pivots. Where a pivot is lost after all, the
//! equations are factored again with row exchanges.

use super::pivoted::PivotedLu;
use super::{Pivots, SINGULAR, SolveError, ordering};
use crate::assembly::Pattern;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;

/// Factors of an unsymmetric matrix.
#[derive(Debug)]
pub(super) struct Lu {
    /// Equation of each row of the factors.
    original: Vec<usize>,
    /// Row of the factors of each equation.
    row_of: Vec<usize>,
    /// Start of each column of L (and row of U); the first entry is the diagonal.
    ptr: Vec<usize>,
    /// Rows of L by columns, rising.
    idx: Vec<usize>,
    /// Entries of L by columns and of U by rows, side by side: the pattern is the same, and they are used together.
    lu: Vec<[f64; 2]>,
    /// For each row the columns left of it that it is in: place of the entry and the column.
    left_ptr: Vec<usize>,
    left: Vec<(usize, usize)>,
    /// Entries of the matrix as (place among the values, row or column of the work vectors), by factor column: those
    /// of the column from the diagonal down, then those of the row right of the diagonal.
    entries: Vec<(usize, usize)>,
    entry_ptr: Vec<(usize, usize)>,
    /// Column of L and row of U that are being worked out.
    work: Vec<[f64; 2]>,
    x: Vec<f64>,
    /// Takes over where a pivot is lost.
    fallback: Option<Box<PivotedLu>>,
    fallen: bool,
}

impl Lu {
    pub(super) fn new(pattern: &Pattern) -> Result<Self, SolveError> {
        let n = pattern.n;
        let symbolic = ordering::cholesky(pattern, SupernodalThreshold::FORCE_SIMPLICIAL)?;
        let (original, row_of) = match symbolic.perm() {
            Some(p) => (p.arrays().0.to_vec(), p.arrays().1.to_vec()),
            None => ((0..n).collect(), (0..n).collect()),
        };
        let SymbolicCholeskyRaw::Simplicial(s) = symbolic.raw() else { unreachable!("asked for a simplicial factor") };
        let (ptr, mut idx) = (s.col_ptr().to_vec(), s.row_idx().to_vec());
        for j in 0..n {
            idx[ptr[j]..ptr[j + 1]].sort_unstable();
        }
        let mut rows = vec![vec![]; n];
        for j in 0..n {
            for (at, &i) in idx[..ptr[j + 1]].iter().enumerate().skip(ptr[j] + 1) {
                rows[i].push((at, j));
            }
        }
        let mut entries = vec![];
        let mut entry_ptr = vec![];
        let mut below = vec![vec![]; n];
        let mut right = vec![vec![]; n];
        for col in 0..n {
            for at in pattern.col_ptr[col]..pattern.col_ptr[col + 1] {
                let (i, j) = (row_of[pattern.row_idx[at]], row_of[col]);
                if i >= j {
                    below[j].push((at, i));
                } else {
                    right[i].push((at, j));
                }
            }
        }
        for (b, r) in below.into_iter().zip(right) {
            let start = entries.len();
            entries.extend(b);
            entry_ptr.push((start, entries.len()));
            entries.extend(r);
        }
        entry_ptr.push((entries.len(), entries.len()));
        let left_ptr = std::iter::once(0)
            .chain(rows.iter().scan(0, |at, r| {
                *at += r.len();
                Some(*at)
            }))
            .collect();
        let nnz = idx.len();
        Ok(Self {
            original,
            row_of,
            ptr,
            idx,
            lu: vec![[0.0; 2]; nnz],
            left_ptr,
            left: rows.into_iter().flatten().collect(),
            entries,
            entry_ptr,
            work: vec![[0.0; 2]; n],
            x: vec![0.0; n],
            fallback: None,
            fallen: false,
        })
    }

    /// Multiplications of a factorisation and of a solution.
    pub(super) fn work(&self) -> (f64, f64) {
        let lengths = self.ptr.windows(2).map(|w| (w[1] - w[0]) as f64);
        (lengths.map(|l| l * l).sum(), 2.0 * self.idx.len() as f64)
    }

    pub(super) fn factor(&mut self, pattern: &Pattern, values: &[f64]) -> Result<Pivots, SolveError> {
        let pivots = self.factor_in_order(values);
        self.fallen = pivots.ratio <= SINGULAR;
        if !self.fallen {
            return Ok(pivots);
        }
        let fallback = match &mut self.fallback {
            Some(f) => f,
            none => none.insert(Box::new(PivotedLu::new(pattern)?)),
        };
        fallback.factor(pattern, values)?;
        // Row exchanges hide the pivots. A regular matrix gives back a vector of ones from its row sums.
        self.x.fill(0.0);
        for col in 0..pattern.n {
            for (row, value) in pattern.column(values, col) {
                self.x[row] += value;
            }
        }
        fallback.solve(&mut self.x);
        let regular = self.x.iter().all(|x| (x - 1.0).abs() < 1e-3);
        Ok(if regular { Pivots::GOOD } else { pivots })
    }

    /// Crout's scheme: column k of L and row k of U from those before.
    fn factor_in_order(&mut self, values: &[f64]) -> Pivots {
        let mut pivots = Pivots::GOOD;
        for k in 0..self.original.len() {
            let (start, middle) = self.entry_ptr[k];
            for &(at, i) in &self.entries[start..middle] {
                self.work[i][0] = values[at];
            }
            for &(at, j) in &self.entries[middle..self.entry_ptr[k + 1].0] {
                self.work[j][1] = values[at];
            }
            let diagonal = self.work[k][0];
            for &(at, j) in &self.left[self.left_ptr[k]..self.left_ptr[k + 1]] {
                // Entry (k, j) of L and (j, k) of U lie at the same place; what follows them in column j of L and row
                // j of U reaches into this column and row.
                let [lkj, ujk] = self.lu[at];
                let rest = at..self.ptr[j + 1];
                for (&i, [l, u]) in self.idx[rest.clone()].iter().zip(&self.lu[rest]) {
                    let [column, row] = &mut self.work[i];
                    *column -= l * ujk;
                    *row -= u * lkj;
                }
            }
            let pivot = std::mem::take(&mut self.work[k])[0];
            pivots.see(self.original[k], pivot, diagonal);
            let own = self.ptr[k]..self.ptr[k + 1];
            self.lu[own.start] = [1.0, pivot];
            let inverse = 1.0 / pivot;
            for at in own.start + 1..own.end {
                let [column, row] = std::mem::take(&mut self.work[self.idx[at]]);
                self.lu[at] = [column * inverse, row];
            }
        }
        pivots
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        if self.fallen {
            if let Some(f) = &mut self.fallback {
                f.solve(x);
            }
            return;
        }
        for (y, &o) in self.x.iter_mut().zip(&self.original) {
            *y = x[o];
        }
        let n = x.len();
        for k in 0..n {
            let y = self.x[k];
            if y != 0.0 {
                let below = self.ptr[k] + 1..self.ptr[k + 1];
                for (&i, lu) in self.idx[below.clone()].iter().zip(&self.lu[below]) {
                    self.x[i] -= lu[0] * y;
                }
            }
        }
        for k in (0..n).rev() {
            let right = self.ptr[k] + 1..self.ptr[k + 1];
            let s: f64 = self.idx[right.clone()].iter().zip(&self.lu[right]).map(|(&j, lu)| lu[1] * self.x[j]).sum();
            self.x[k] = (self.x[k] - s) / self.lu[self.ptr[k]][1];
        }
        for (to, &row) in x.iter_mut().zip(&self.row_of) {
            *to = self.x[row];
        }
    }
}
