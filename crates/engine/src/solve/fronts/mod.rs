//! Large sparse systems with a symmetric pattern: LU without row exchanges by fronts (Duff and Reid, 1983), or LDLᵀ where the
//! matrix is symmetric.
//!
//! The order and the columns that go together are faer's. A front is a dense matrix: the columns that it eliminates, the rows
//! that they reach, and the sums of its children there. Subtrees go side by side on several threads, and above them the blocks
//! of each front. The sums are the same for any number of threads, to the last bit.

mod dense;
mod factor;
mod substitute;
mod tree;

use super::threads::Threads;
use super::{Pivots, SolveError};
use crate::assembly::{Pattern, Storage};
use factor::{Elimination, Factors};
use substitute::Substitution;
use tree::Tree;

/// Factors of a large matrix.
#[derive(Debug)]
pub(super) struct Fronts {
    tree: Tree,
    storage: Storage,
    /// L by fronts, with the square of each front in which U lies above the diagonal.
    lower: Vec<f64>,
    /// U right of these squares, by columns of its transpose; empty where the matrix is symmetric.
    upper: Vec<f64>,
    /// Right-hand sides by rows, and room for their copy.
    x: [Vec<f64>; 2],
    threads: Threads,
}

/// An entry that is read from memory for one product takes as long as so many multiplications of a factorisation.
const FROM_MEMORY: f64 = 8.0;

/// Zeros, if there is memory for them.
fn zeros(n: usize) -> Result<Vec<f64>, SolveError> {
    let mut out = vec![];
    out.try_reserve_exact(n).map_err(|_| SolveError::OutOfMemory)?;
    out.resize(n, 0.0);
    Ok(out)
}

impl Fronts {
    /// For a pattern. `None` where a factorisation takes fewer multiplications than `least`.
    pub(super) fn new(pattern: &Pattern, least: f64, threads: &Threads) -> Result<Option<Self>, SolveError> {
        let Some(tree) = Tree::new(pattern, least)? else { return Ok(None) };
        let [lower, upper] = tree.lengths;
        Ok(Some(Self {
            storage: pattern.storage,
            lower: zeros(lower)?,
            upper: zeros(upper)?,
            x: [vec![], vec![]],
            threads: threads.clone(),
            tree,
        }))
    }

    /// Multiplications of a factorisation and of a solution.
    pub(super) fn work(&self) -> (f64, f64) {
        let entries = 2 * self.lower.len();
        (tree::work(&self.tree.fronts, self.storage), FROM_MEMORY * entries as f64)
    }

    /// Factors of the values of a matrix.
    pub(super) fn factor(&mut self, values: &[f64]) -> Pivots {
        let elimination = Elimination { tree: &self.tree, values, symmetric: self.storage == Storage::Upper };
        let factors = Factors { lower: &mut self.lower, upper: &mut self.upper, start: [0; 2] };
        self.threads.run(|parallel| elimination.run(parallel, factors));
        let mut pivots = Pivots::GOOD;
        for f in &self.tree.fronts {
            let (width, reach) = f.size();
            for (k, row) in f.columns.clone().enumerate() {
                let equation = self.tree.original[row];
                let pivot = self.lower[f.lower + k * (width + reach + 1)];
                pivots.see(equation, pivot, values[self.tree.diagonal[equation]]);
            }
        }
        pivots
    }

    /// Solve for right-hand sides, one after the other in `x`, in place.
    pub(super) fn solve(&mut self, x: &mut [f64]) {
        let Self { tree, lower, upper, x: [own, known], .. } = self;
        let n = tree.original.len();
        let sides = x.len() / n.max(1);
        own.resize(x.len(), 0.0);
        for (row, &equation) in tree.original.iter().enumerate() {
            (0..sides).for_each(|s| own[row * sides + s] = x[s * n + equation]);
        }
        let substitution = Substitution { tree, lower, upper, symmetric: self.storage == Storage::Upper, sides };
        self.threads.run(|parallel| {
            substitution.forward(parallel, own);
            substitution.backward(parallel, own, known);
        });
        for (row, &equation) in tree.original.iter().enumerate() {
            (0..sides).for_each(|s| x[s * n + equation] = own[row * sides + s]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Fronts;
    use crate::assembly::{Pattern, Storage};
    use crate::solve::Threads;

    /// Equations of a grid of nodes with three unknowns each, joined to their neighbours; values by a formula.
    fn grid(storage: Storage) -> (Pattern, Vec<f64>) {
        let (side, unknowns) = (17u32, 3u32);
        let node = |i: u32, j: u32| (0..unknowns).map(move |k| (i * side + j) * unknowns + k);
        let mut groups: Vec<Vec<u32>> = vec![];
        for i in 0..side {
            for j in 0..side {
                if i + 1 < side {
                    groups.push(node(i, j).chain(node(i + 1, j)).collect());
                }
                if j + 1 < side {
                    groups.push(node(i, j).chain(node(i, j + 1)).collect());
                }
            }
        }
        let n = (side * side * unknowns) as usize;
        let pattern = Pattern::new(n, storage, groups.iter().map(Vec::as_slice));
        let mut values = vec![];
        for col in 0..n {
            for &row in &pattern.row_idx[pattern.col_ptr[col]..pattern.col_ptr[col + 1]] {
                let skew = if row > col { 0.3 } else { 0.0 };
                let wave = ((row * col) as f64 * 0.71 + (row + col) as f64).sin() + skew;
                values.push(if row == col { 20.0 } else { wave });
            }
        }
        (pattern, values)
    }

    fn fronts(pattern: &Pattern, threads: usize) -> Fronts {
        Fronts::new(pattern, 0.0, &Threads::new(threads)).expect("memory").expect("fronts")
    }

    #[test]
    fn solutions_satisfy_the_equations() {
        for storage in [Storage::Upper, Storage::Full] {
            let (pattern, values) = grid(storage);
            let n = pattern.n;
            let mut fronts = fronts(&pattern, 1);
            assert!(fronts.factor(&values).ratio > 0.1);
            let exact: Vec<f64> = (0..3 * n).map(|i| (i as f64 * 0.37).cos()).collect();
            let mut x = vec![0.0; 3 * n];
            exact.chunks(n).zip(x.chunks_mut(n)).for_each(|(e, x)| pattern.multiply(&values, e, x));
            let mut one = x[..n].to_vec();
            fronts.solve(&mut x);
            let apart = x.iter().zip(&exact).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(apart < 1e-11, "{storage:?}: {apart}");
            fronts.solve(&mut one);
            let apart = one.iter().zip(&exact).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(apart < 1e-11, "{storage:?}: {apart}");
        }
    }

    #[test]
    fn threads_change_no_bit() {
        for storage in [Storage::Upper, Storage::Full] {
            let (pattern, values) = grid(storage);
            let solved = |threads| {
                let mut fronts = fronts(&pattern, threads);
                let pivots = fronts.factor(&values);
                let mut x: Vec<f64> = (0..2 * pattern.n).map(|i| (i as f64 * 0.11).sin()).collect();
                fronts.solve(&mut x);
                (pivots, x, fronts.lower, fronts.upper)
            };
            let one = solved(1);
            assert!(solved(2) == one && solved(5) == one, "{storage:?}");
        }
    }

    /// A row without entries but a zero on its diagonal.
    #[test]
    fn an_equation_without_a_pivot_is_named() {
        for storage in [Storage::Upper, Storage::Full] {
            let (pattern, mut values) = grid(storage);
            for col in 0..pattern.n {
                let own = pattern.col_ptr[col]..pattern.col_ptr[col + 1];
                for (row, value) in pattern.row_idx[own.clone()].iter().zip(&mut values[own]) {
                    if col == 400 || *row == 400 {
                        *value = 0.0;
                    }
                }
            }
            let pivots = fronts(&pattern, 1).factor(&values);
            assert_eq!((pivots.equation, pivots.ratio), (400, 0.0), "{storage:?}");
        }
    }
}
