//! Sparse systems with a symmetric pattern: LU without row exchanges, or LDLᵀ where the matrix is symmetric.
//!
//! The tangents of coupled bearings are unsymmetric, but as strongly diagonal as those of other structures: the order
//! that faer finds for a symmetric matrix serves, the pattern of L is that of Uᵀ, and the factors are worked out in
//! place with no bookkeeping. Neighbouring columns with the same rows below them, as those of a node, are taken
//! together (Ng and Peyton, 1993): their products are summed by vector instructions before they are spread.

mod kernels;
mod structure;

use super::{Pivots, SolveError};
use crate::assembly::{Pattern, Storage};
use crate::numeric::lanes::{BLOCK, Lanes, in_lanes};
use kernels::{backward, forward, subtract, sums_of};
use structure::{Panel, Structure, Update, WIDTH};

/// Factors L U of a matrix. Those of a symmetric one have U = D Lᵀ.
#[derive(Debug)]
pub(super) struct Lu {
    structure: Structure,
    symmetric: bool,
    /// Entries of L by columns, with a block behind them.
    lower: Vec<f64>,
    /// Entries of U by rows, at the same places.
    upper: Vec<f64>,
    /// Columns of L and rows of U of a panel that are being worked out, entry by entry side by side.
    work: [Vec<[f64; 2]>; WIDTH],
    /// Sums over the columns of an update, with a block behind them.
    sums: [[Vec<f64>; WIDTH]; 2],
    x: Vec<f64>,
}

impl Lu {
    pub(super) fn new(pattern: &Pattern) -> Result<Self, SolveError> {
        let n = pattern.n;
        let structure = Structure::new(pattern)?;
        let padded = structure.idx.len() + BLOCK;
        Ok(Self {
            structure,
            symmetric: pattern.storage == Storage::Upper,
            lower: vec![0.0; padded],
            upper: vec![0.0; padded],
            work: std::array::from_fn(|_| vec![[0.0; 2]; n]),
            sums: std::array::from_fn(|_| std::array::from_fn(|_| vec![0.0; n + BLOCK])),
            x: vec![0.0; n],
        })
    }

    /// Multiplications of a factorisation and of a solution.
    pub(super) fn work(&self) -> (f64, f64) {
        let lengths = self.structure.ptr.windows(2).map(|w| (w[1] - w[0]) as f64);
        let share = if self.symmetric { 0.5 } else { 1.0 };
        (share * lengths.map(|l| l * l).sum::<f64>(), 2.0 * self.structure.idx.len() as f64)
    }

    pub(super) fn factor(&mut self, values: &[f64]) -> Pivots {
        let mut factoring = Factoring { lu: self, values, pivots: Pivots::GOOD };
        in_lanes(&mut factoring);
        factoring.pivots
    }

    /// Factors panel by panel, each from those before.
    #[inline(always)]
    fn factor_in_order(&mut self, values: &[f64]) -> Pivots {
        let mut pivots = Pivots::GOOD;
        let (s, symmetric) = (&self.structure, self.symmetric);
        let work = &mut self.work;
        for Panel { columns: panel, updates } in &s.panels {
            for (k, q) in panel.clone().zip(0..) {
                let (start, middle) = s.entry_ptr[k];
                for &(at, i) in &s.entries[start..middle] {
                    work[q][i][0] = values[at];
                }
                for &(at, j) in &s.entries[middle..s.entry_ptr[k + 1].0] {
                    work[q][j][1] = values[at];
                }
            }
            let mut diagonal = [0.0; WIDTH];
            for (k, q) in panel.clone().zip(0..) {
                diagonal[q] = work[q][k][0];
            }
            for update in &s.updates[updates.clone()] {
                let factors = [&self.lower[..], &self.upper];
                if symmetric {
                    update_symmetric(s, panel.start, update, factors, &mut self.sums[0], work);
                } else {
                    update_panel(s, panel.start, update, factors, &mut self.sums, work);
                }
            }
            for (k, q) in panel.clone().zip(0..) {
                for at in s.ptr[k]..s.ptr[k + 1] {
                    let i = s.idx[at];
                    [self.lower[at], self.upper[at]] = std::mem::take(&mut work[q][i]);
                }
            }
            for (k, q) in panel.clone().zip(0..) {
                let pivot = self.lower[s.ptr[k]];
                pivots.see(s.original[k], pivot, diagonal[q]);
                if symmetric {
                    let own = s.ptr[k]..s.ptr[k + 1];
                    self.upper[own.clone()].copy_from_slice(&self.lower[own]);
                }
                eliminate(&s.ptr, k..panel.end, &mut self.lower, &mut self.upper);
            }
        }
        pivots
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        for (y, &o) in self.x.iter_mut().zip(&self.structure.original) {
            *y = x[o];
        }
        in_lanes(&mut Substitution(self));
        for (to, &row) in x.iter_mut().zip(&self.structure.row_of) {
            *to = self.x[row];
        }
    }

    /// Solves with the factors for `x`, panel by panel.
    #[inline(always)]
    fn substitute(&mut self) {
        let s = &self.structure;
        let (x, buffer) = (&mut self.x, &mut self.sums[0][0]);
        for Panel { columns, .. } in &s.panels {
            match columns.len() {
                1 => forward::<1>(s, columns.start, &self.lower, x, buffer),
                2 => forward::<2>(s, columns.start, &self.lower, x, buffer),
                3 => forward::<3>(s, columns.start, &self.lower, x, buffer),
                _ => forward::<WIDTH>(s, columns.start, &self.lower, x, buffer),
            }
        }
        for Panel { columns, .. } in s.panels.iter().rev() {
            match columns.len() {
                1 => backward::<1>(s, columns.start, &self.upper, x, buffer),
                2 => backward::<2>(s, columns.start, &self.upper, x, buffer),
                3 => backward::<3>(s, columns.start, &self.upper, x, buffer),
                _ => backward::<WIDTH>(s, columns.start, &self.upper, x, buffer),
            }
        }
    }
}

/// Subtracts from the columns and rows of a panel what columns left of it contribute. Entry (k, j) of L and (j, k) of U
/// lie at the same place; what follows them in column j of L and row j of U reaches into this panel.
#[inline(always)]
fn update_panel(
    s: &Structure,
    first: usize,
    update: &Update,
    [lower, upper]: [&[f64]; 2],
    [column_sums, row_sums]: &mut [[Vec<f64>; WIDTH]; 2],
    work: &mut [Vec<[f64; 2]>; WIDTH],
) {
    let reach = &s.idx[update.at..s.ptr[update.columns.start + 1]];
    let ends = &s.ptr[update.columns.start + 1..=update.columns.end];
    let n = reach.len();
    sums_of(update.rows, lower, upper, ends, n, column_sums);
    sums_of(update.rows, upper, lower, ends, n, row_sums);
    for q in 0..update.rows {
        let work = &mut work[reach[q] - first][..];
        for ((&i, c), r) in reach[q..].iter().zip(&column_sums[q][q..]).zip(&row_sums[q][q..]) {
            let [column, row] = &mut work[i];
            *column -= c;
            *row -= r;
        }
    }
}

/// The same for the columns alone, whose transposed are the rows.
#[inline(always)]
fn update_symmetric(
    s: &Structure,
    first: usize,
    update: &Update,
    [lower, upper]: [&[f64]; 2],
    sums: &mut [Vec<f64>; WIDTH],
    work: &mut [Vec<[f64; 2]>; WIDTH],
) {
    let reach = &s.idx[update.at..s.ptr[update.columns.start + 1]];
    let ends = &s.ptr[update.columns.start + 1..=update.columns.end];
    sums_of(update.rows, lower, upper, ends, reach.len(), sums);
    for q in 0..update.rows {
        let work = &mut work[reach[q] - first][..];
        for (&i, c) in reach[q..].iter().zip(&sums[q][q..]) {
            work[i][0] -= c;
        }
    }
}

/// Scales the first of the columns and subtracts it from the others, which have its rows without those before them.
#[inline(always)]
fn eliminate(ptr: &[usize], columns: std::ops::Range<usize>, lower: &mut [f64], upper: &mut [f64]) {
    let k = columns.start;
    let own = ptr[k]..ptr[k + 1];
    let pivot = lower[own.start];
    (lower[own.start], upper[own.start]) = (1.0, pivot);
    let inverse = 1.0 / pivot;
    for l in &mut lower[own.start + 1..own.end] {
        *l *= inverse;
    }
    for j in k + 1..columns.end {
        let n = ptr[j + 1] - ptr[j];
        let (l, u) = (lower[own.end - n], upper[own.end - n]);
        let (before, after) = lower.split_at_mut(ptr[j]);
        subtract(&before[own.end - n..own.end], u, &mut after[..n]);
        let (before, after) = upper.split_at_mut(ptr[j]);
        subtract(&before[own.end - n..own.end], l, &mut after[..n]);
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

/// Substitution by the widest vector instructions.
struct Substitution<'a>(&'a mut Lu);

impl Lanes for Substitution<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        self.0.substitute();
    }
}
