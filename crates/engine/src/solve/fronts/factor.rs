//! Elimination of all fronts: subtrees side by side, the fronts above them one after the other with blocks side by side.

use super::dense::{left_of, left_of_transposed, lu, subtract};
use super::tree::{Front, Tree};
use faer::{MatMut, MatRef};
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};
use std::ops::Range;

/// Both factors of some fronts that follow each other.
pub(super) struct Factors<'a> {
    pub(super) lower: &'a mut [f64],
    pub(super) upper: &'a mut [f64],
    /// Places of their starts among those of all fronts.
    pub(super) start: [usize; 2],
}

/// Elimination of a matrix.
pub(super) struct Elimination<'a> {
    pub(super) tree: &'a Tree,
    pub(super) values: &'a [f64],
    pub(super) symmetric: bool,
}

/// Contribution of a front to its parent: a square matrix over its rows below, by columns; of a symmetric one the lower triangle.
type Contribution = Vec<f64>;

impl Elimination<'_> {
    /// Factor all fronts.
    pub(super) fn run(&self, parallel: bool, mut factors: Factors<'_>) {
        let mut contributions: Vec<Option<Contribution>> = vec![None; self.tree.fronts.len()];
        let roots = &self.tree.side_by_side;
        let parts = self.parts(&mut factors);
        let eliminate = |(range, mut own): (Range<usize>, Factors<'_>)| self.subtree(range, &mut own);
        let found: Vec<Contribution> = if parallel {
            parts.into_par_iter().map(eliminate).collect()
        } else {
            parts.into_iter().map(eliminate).collect()
        };
        roots.iter().zip(found).for_each(|(root, contribution)| contributions[*root] = Some(contribution));
        for front in self.tree.above() {
            let children = self.tree.children(front);
            let of_children =
                children.iter().rev().map(|c| (*c, contributions[*c].take().unwrap_or_default())).collect();
            contributions[front] = Some(self.front(parallel, front, of_children, &mut factors));
        }
    }

    /// Parts of the factors of the subtrees that are eliminated side by side.
    fn parts<'f>(&self, factors: &'f mut Factors<'_>) -> Vec<(Range<usize>, Factors<'f>)> {
        let mut out = vec![];
        let (mut lower, mut upper, mut at) = (&mut *factors.lower, &mut *factors.upper, [0; 2]);
        for &root in &self.tree.side_by_side {
            let range = self.tree.fronts[root].first..root + 1;
            let (start, end) = (self.starts(range.start), self.starts(range.end));
            let (to_lower, after_lower) = lower.split_at_mut(end[0] - at[0]);
            let (to_upper, after_upper) = upper.split_at_mut(end[1] - at[1]);
            let own =
                Factors { lower: &mut to_lower[start[0] - at[0]..], upper: &mut to_upper[start[1] - at[1]..], start };
            (lower, upper, at) = (after_lower, after_upper, end);
            out.push((range, own));
        }
        out
    }

    /// Places of a front in both factors; of the number of fronts, their lengths.
    fn starts(&self, front: usize) -> [usize; 2] {
        self.tree.fronts.get(front).map_or(self.tree.lengths, |f| [f.lower, f.upper])
    }

    /// Factor the fronts of a subtree.
    fn subtree(&self, range: Range<usize>, factors: &mut Factors<'_>) -> Contribution {
        let mut contributions: Vec<(usize, Contribution)> = vec![];
        for front in range {
            let of_children = contributions.split_off(contributions.len() - self.tree.fronts[front].children);
            contributions.push((front, self.front(false, front, of_children, factors)));
        }
        contributions.pop().map_or_else(Vec::new, |(_, contribution)| contribution)
    }

    /// Factor a front.
    fn front(
        &self,
        parallel: bool,
        front: usize,
        children: Vec<(usize, Contribution)>,
        factors: &mut Factors<'_>,
    ) -> Contribution {
        let f = &self.tree.fronts[front];
        let (width, reach) = f.size();
        let height = width + reach;
        let lower = &mut factors.lower[f.lower - factors.start[0]..][..width * height];
        // The rows of U of a symmetric matrix follow from the columns of L.
        let mut own = vec![];
        let upper = if self.symmetric {
            own.resize(width * reach, 0.0);
            &mut own[..]
        } else {
            &mut factors.upper[f.upper - factors.start[1]..][..width * reach]
        };
        let mut contribution = vec![0.0; reach * reach];
        self.assemble(f, lower, upper);
        for (child, of_child) in children {
            self.add_child(f, &self.tree.fronts[child], &of_child, [&mut *lower, &mut *upper, &mut contribution]);
        }
        if self.symmetric {
            mirror(lower, width, height);
        }
        let lower = MatMut::from_column_major_slice_mut(lower, height, width);
        let upper = MatMut::from_column_major_slice_mut(upper, reach, width);
        let (mut square, left) = lower.split_at_row_mut(width);
        lu(parallel, square.as_mut());
        let left = left_of(parallel, square.as_ref(), left);
        let upper = if self.symmetric {
            times_pivots(left.as_ref(), square.as_ref(), upper)
        } else {
            left_of_transposed(parallel, square.as_ref(), upper)
        };
        let square = MatMut::from_column_major_slice_mut(&mut contribution, reach, reach);
        subtract(parallel, self.symmetric, square, left.as_ref(), upper.as_ref().transpose());
        contribution
    }

    /// Write the entries of the matrix into a front.
    fn assemble(&self, f: &Front, lower: &mut [f64], upper: &mut [f64]) {
        let [start, middle, end] = f.entries;
        lower.fill(0.0);
        upper.fill(0.0);
        self.tree.entries[start..middle].iter().for_each(|&(from, to)| lower[to] += self.values[from]);
        self.tree.entries[middle..end].iter().for_each(|&(from, to)| upper[to] += self.values[from]);
    }

    /// Add to a front the parts of its child's contribution: to the columns of L, the rows of U, and its own contribution.
    fn add_child(&self, f: &Front, child: &Front, contribution: &[f64], [lower, upper, own]: [&mut [f64]; 3]) {
        let (width, reach) = f.size();
        let height = width + reach;
        let places = &self.tree.in_parent[child.below.clone()];
        let n = places.len();
        let of_columns = places.partition_point(|p| *p < width);
        for (b, &column) in places.iter().enumerate() {
            let values = &contribution[b * n..(b + 1) * n];
            let from = if self.symmetric { b } else { 0 };
            if b < of_columns {
                let to = &mut lower[column * height..(column + 1) * height];
                places[from..].iter().zip(&values[from..]).for_each(|(row, value)| to[*row] += value);
                continue;
            }
            let column = column - width;
            let middle = of_columns.max(from);
            if !self.symmetric {
                places[..of_columns].iter().zip(values).for_each(|(row, value)| upper[row * reach + column] += value);
            }
            let to = &mut own[column * reach..(column + 1) * reach];
            places[middle..].iter().zip(&values[middle..]).for_each(|(row, value)| to[*row - width] += value);
        }
    }
}

/// Copy the lower triangle of the square of a front to the upper one.
fn mirror(lower: &mut [f64], width: usize, height: usize) {
    for j in 0..width {
        for i in j + 1..width {
            lower[i * height + j] = lower[j * height + i];
        }
    }
}

/// Columns of L times their pivots: the rows of U of a symmetric matrix.
fn times_pivots<'a>(left: MatRef<'_, f64>, square: MatRef<'_, f64>, mut out: MatMut<'a, f64>) -> MatMut<'a, f64> {
    for k in 0..square.ncols() {
        let pivot = square[(k, k)];
        for i in 0..left.nrows() {
            out[(i, k)] = left[(i, k)] * pivot;
        }
    }
    out
}
