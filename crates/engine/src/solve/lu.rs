//! Sparse unsymmetric systems with a symmetric pattern: LU without row exchanges.
//!
//! The tangents of coupled bearings are unsymmetric, but as strongly diagonal as those of other structures: the order
//! that faer finds for a symmetric matrix serves, the pattern of L is that of Uᵀ, and the factors are worked out in
//! place with no bookkeeping. Neighbouring columns with the same rows below them, as those of a node, are taken
//! together (Ng and Peyton, 1993): their products are summed by vector instructions before they are spread. Where a
//! pivot is lost after all, the equations are factored again with row exchanges.

use super::pivoted::PivotedLu;
use super::{Pivots, SINGULAR, SolveError, ordering};
use crate::assembly::Pattern;
use crate::numeric::lanes::{Lanes, in_lanes};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;
use std::ops::Range;

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
    /// Entries of L by columns.
    lower: Vec<f64>,
    /// Entries of U by rows, at the same places.
    upper: Vec<f64>,
    /// For each row the groups of columns left of it that it is in.
    left_ptr: Vec<usize>,
    left: Vec<Group>,
    /// Entries of the matrix as (place among the values, row or column of the work vectors), by factor column: those
    /// of the column from the diagonal down, then those of the row right of the diagonal.
    entries: Vec<(usize, usize)>,
    entry_ptr: Vec<(usize, usize)>,
    /// Column of L and row of U that are being worked out.
    work: [Vec<f64>; 2],
    /// Products of a group.
    products: [Vec<f64>; 2],
    x: Vec<f64>,
    /// Takes over where a pivot is lost.
    fallback: Option<Box<PivotedLu>>,
    fallen: bool,
}

/// Columns left of a row with the same rows from this one on.
#[derive(Clone, Debug)]
struct Group {
    columns: Range<usize>,
    /// Place of the row in the first column.
    at: usize,
}

/// Last column and one more of the group of each column: columns follow each other in it, and each has the rows of the
/// one before without its first.
fn group_ends(ptr: &[usize], idx: &[usize]) -> Vec<usize> {
    let n = ptr.len() - 1;
    let mut ends: Vec<usize> = (1..=n).collect();
    for j in (0..n.saturating_sub(1)).rev() {
        if idx[ptr[j] + 1..ptr[j + 1]] == idx[ptr[j + 1]..ptr[j + 2]] {
            ends[j] = ends[j + 1];
        }
    }
    ends
}

/// Groups of columns that each row is in, left of it.
fn groups_of_rows(ptr: &[usize], idx: &[usize]) -> Vec<Vec<Group>> {
    let n = ptr.len() - 1;
    let ends = group_ends(ptr, idx);
    let mut rows = vec![vec![]; n];
    let mut first = 0;
    while first < n {
        let end = ends[first];
        for (at, &row) in idx.iter().enumerate().take(ptr[first + 1]).skip(ptr[first] + 1) {
            rows[row].push(Group { columns: first..end.min(row), at });
        }
        first = end;
    }
    rows
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
        let rows = groups_of_rows(&ptr[..=n], &idx);
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
            lower: vec![0.0; nnz],
            upper: vec![0.0; nnz],
            left_ptr,
            left: rows.into_iter().flatten().collect(),
            entries,
            entry_ptr,
            work: [vec![0.0; n], vec![0.0; n]],
            products: [vec![0.0; n], vec![0.0; n]],
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
        let mut factoring = Factoring { lu: self, values, pivots: Pivots::GOOD };
        in_lanes(&mut factoring);
        let pivots = factoring.pivots;
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
    #[inline(always)]
    fn factor_in_order(&mut self, values: &[f64]) -> Pivots {
        let mut pivots = Pivots::GOOD;
        for k in 0..self.original.len() {
            let (start, middle) = self.entry_ptr[k];
            for &(at, i) in &self.entries[start..middle] {
                self.work[0][i] = values[at];
            }
            for &(at, j) in &self.entries[middle..self.entry_ptr[k + 1].0] {
                self.work[1][j] = values[at];
            }
            let diagonal = self.work[0][k];
            for i in self.left_ptr[k]..self.left_ptr[k + 1] {
                self.subtract_group(i);
            }
            let pivot = self.work[0][k];
            (self.work[0][k], self.work[1][k]) = (0.0, 0.0);
            pivots.see(self.original[k], pivot, diagonal);
            let own = self.ptr[k]..self.ptr[k + 1];
            (self.lower[own.start], self.upper[own.start]) = (1.0, pivot);
            let inverse = 1.0 / pivot;
            for at in own.start + 1..own.end {
                let i = self.idx[at];
                (self.lower[at], self.upper[at]) = (self.work[0][i] * inverse, self.work[1][i]);
                (self.work[0][i], self.work[1][i]) = (0.0, 0.0);
            }
        }
        pivots
    }

    /// Subtracts from column k and row k what the columns of a group left of it contribute. Entry (k, j) of L and (j, k)
    /// of U lie at the same place; what follows them in column j of L and row j of U reaches into this column and row.
    #[inline(always)]
    fn subtract_group(&mut self, group: usize) {
        let Group { columns, at } = self.left[group].clone();
        let rows = &self.idx[at..self.ptr[columns.start + 1]];
        let n = rows.len();
        let [column, row] = &mut self.products;
        let (column, row) = (&mut column[..n], &mut row[..n]);
        // A column of the group has an entry less before the row than the one before it.
        let place = |j: usize| self.ptr[j + 1] - n;
        let mut j = columns.start;
        let at = place(j);
        scale(&self.lower[at..at + n], self.upper[at], column);
        scale(&self.upper[at..at + n], self.lower[at], row);
        j += 1;
        while j + 1 < columns.end {
            let (a, b) = (place(j), place(j + 1));
            let (la, lb, ua, ub) = (self.lower[a], self.lower[b], self.upper[a], self.upper[b]);
            add_two(&self.lower[a..a + n], ua, &self.lower[b..b + n], ub, column);
            add_two(&self.upper[a..a + n], la, &self.upper[b..b + n], lb, row);
            j += 2;
        }
        if j < columns.end {
            let a = place(j);
            let (l, u) = (self.lower[a], self.upper[a]);
            add_one(&self.lower[a..a + n], u, column);
            add_one(&self.upper[a..a + n], l, row);
        }
        let [work_column, work_row] = &mut self.work;
        for ((&i, c), r) in rows.iter().zip(&*column).zip(&*row) {
            work_column[i] -= c;
            work_row[i] -= r;
        }
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
                for (&i, l) in self.idx[below.clone()].iter().zip(&self.lower[below]) {
                    self.x[i] -= l * y;
                }
            }
        }
        for k in (0..n).rev() {
            let right = self.ptr[k] + 1..self.ptr[k + 1];
            let s: f64 = self.idx[right.clone()].iter().zip(&self.upper[right]).map(|(&j, u)| u * self.x[j]).sum();
            self.x[k] = (self.x[k] - s) / self.upper[self.ptr[k]];
        }
        for (to, &row) in x.iter_mut().zip(&self.row_of) {
            *to = self.x[row];
        }
    }
}

/// Factoring by the widest vector instructions.
struct Factoring<'a> {
    lu: &'a mut Lu,
    values: &'a [f64],
    pivots: Pivots,
}

impl Lanes for Factoring<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        self.pivots = self.lu.factor_in_order(self.values);
    }
}

/// y = c x
#[inline(always)]
fn scale(x: &[f64], c: f64, y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y = c * x;
    }
}

/// y += c x
#[inline(always)]
fn add_one(x: &[f64], c: f64, y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += c * x;
    }
}

/// y += c x + d z
#[inline(always)]
fn add_two(x: &[f64], c: f64, z: &[f64], d: f64, y: &mut [f64]) {
    for ((y, x), z) in y.iter_mut().zip(x).zip(z) {
        *y += c * x + d * z;
    }
}
