//! Solution with the factors of all fronts, for one or more right-hand sides.

use super::tree::{Front, Tree};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_unit_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, MatMut, MatRef, Par};
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};
use std::ops::Range;

/// Factors of a matrix, and a number of right-hand sides.
pub(super) struct Substitution<'a> {
    pub(super) tree: &'a Tree,
    pub(super) lower: &'a [f64],
    pub(super) upper: &'a [f64],
    pub(super) symmetric: bool,
    /// Number of right-hand sides. Vectors have the values of a row side by side.
    pub(super) sides: usize,
}

/// Rows of vectors from a range of rows on.
type RowsOf<'a> = (Range<usize>, &'a mut [f64]);

impl Substitution<'_> {
    /// L⁻¹ x in the place of x, for all rows.
    pub(super) fn forward(&self, parallel: bool, x: &mut [f64]) {
        let mut sums: Vec<Option<Vec<f64>>> = vec![None; self.tree.fronts.len()];
        let down = |(fronts, (rows, own)): (Range<usize>, RowsOf<'_>)| {
            let mut sums: Vec<(usize, Vec<f64>)> = vec![];
            for front in fronts {
                let of_children = sums.split_off(sums.len() - self.tree.fronts[front].children);
                sums.push((front, self.forward_front(front, of_children, own, rows.start)));
            }
            sums.pop().map_or_else(Vec::new, |(_, sums)| sums)
        };
        let parts = self.parts(x);
        let found: Vec<Vec<f64>> =
            if parallel { parts.into_par_iter().map(down).collect() } else { parts.into_iter().map(down).collect() };
        self.tree.side_by_side.iter().zip(found).for_each(|(root, of_root)| sums[*root] = Some(of_root));
        for front in self.tree.above() {
            let children = self.tree.children(front);
            let of_children = children.iter().rev().map(|c| (*c, sums[*c].take().unwrap_or_default())).collect();
            sums[front] = Some(self.forward_front(front, of_children, x, 0));
        }
    }

    /// U⁻¹ x in the place of x, for all rows. `known` is room for a copy.
    pub(super) fn backward(&self, parallel: bool, x: &mut [f64], known: &mut Vec<f64>) {
        let mut room = vec![];
        for front in self.tree.above().into_iter().rev() {
            let f = &self.tree.fronts[front];
            room.clear();
            self.tree.below(f).iter().for_each(|row| room.extend_from_slice(self.row(x, *row)));
            self.backward_front(f, &room, self.columns(f, x, 0));
        }
        // Rows of the fronts above the subtrees are known by now.
        known.clear();
        known.extend_from_slice(x);
        let known = &known[..];
        let up = |(fronts, (rows, own)): (Range<usize>, RowsOf<'_>)| {
            let mut room = vec![];
            for front in fronts.rev() {
                let f = &self.tree.fronts[front];
                room.clear();
                for &row in self.tree.below(f) {
                    let within = row < rows.end;
                    room.extend_from_slice(if within { self.row(own, row - rows.start) } else { self.row(known, row) });
                }
                self.backward_front(f, &room, self.columns(f, own, rows.start));
            }
        };
        let parts = self.parts(x);
        if parallel {
            parts.into_par_iter().for_each(up);
        } else {
            parts.into_iter().for_each(up);
        }
    }

    fn row<'x>(&self, x: &'x [f64], row: usize) -> &'x [f64] {
        &x[row * self.sides..(row + 1) * self.sides]
    }

    /// Rows of the columns of a front, of vectors from a row on.
    fn columns<'x>(&self, f: &Front, x: &'x mut [f64], start: usize) -> MatMut<'x, f64> {
        let rows = (f.columns.start - start) * self.sides..(f.columns.end - start) * self.sides;
        MatMut::from_row_major_slice_mut(&mut x[rows], f.columns.len(), self.sides)
    }

    /// Fronts and rows of the subtrees that go side by side.
    fn parts<'x>(&self, x: &'x mut [f64]) -> Vec<(Range<usize>, RowsOf<'x>)> {
        let (mut out, mut rest, mut at) = (vec![], x, 0);
        for &root in &self.tree.side_by_side {
            let fronts = self.tree.fronts[root].first..root + 1;
            let rows = self.tree.fronts[fronts.start].columns.start..self.tree.fronts[root].columns.end;
            let (before, after) = rest.split_at_mut((rows.end - at) * self.sides);
            let own = &mut before[(rows.start - at) * self.sides..];
            (rest, at) = (after, rows.end);
            out.push((fronts, (rows, own)));
        }
        out
    }

    /// Square of a front, and L below it.
    fn lower(&self, f: &Front) -> (MatRef<'_, f64>, MatRef<'_, f64>) {
        let (width, reach) = f.size();
        let height = width + reach;
        let lower = MatRef::from_column_major_slice(&self.lower[f.lower..][..width * height], height, width);
        lower.split_at_row(width)
    }

    /// Solves for the columns of a front; what they add to its rows below, with the sums of its children.
    fn forward_front(&self, front: usize, children: Vec<(usize, Vec<f64>)>, x: &mut [f64], start: usize) -> Vec<f64> {
        let f = &self.tree.fronts[front];
        let (width, reach) = f.size();
        let sides = self.sides;
        let mut sums = vec![0.0; reach * sides];
        for (child, of_child) in children {
            let places = &self.tree.in_parent[self.tree.fronts[child].below.clone()];
            for (&place, values) in places.iter().zip(of_child.chunks_exact(sides)) {
                let to = match place.checked_sub(width) {
                    Some(place) => &mut sums[place * sides..(place + 1) * sides],
                    None => &mut x[(f.columns.start - start + place) * sides..][..sides],
                };
                to.iter_mut().zip(values).for_each(|(to, value)| *to += value);
            }
        }
        let mut own = self.columns(f, x, start);
        let (square, left) = self.lower(f);
        solve_unit_lower_triangular_in_place(square, own.as_mut(), Par::Seq);
        let to = MatMut::from_row_major_slice_mut(&mut sums, reach, sides);
        matmul(to, Accum::Add, left, own.as_ref(), -1.0, Par::Seq);
        sums
    }

    /// Solves for the columns of a front from its rows below.
    fn backward_front(&self, f: &Front, below: &[f64], mut own: MatMut<'_, f64>) {
        let (width, reach) = f.size();
        let (square, left) = self.lower(f);
        let below = MatRef::from_row_major_slice(below, reach, self.sides);
        if self.symmetric {
            let mut product = vec![0.0; width * self.sides];
            let mut product = MatMut::from_row_major_slice_mut(&mut product, width, self.sides);
            matmul(product.as_mut(), Accum::Replace, left.transpose(), below, 1.0, Par::Seq);
            for k in 0..width {
                let pivot = square[(k, k)];
                (0..self.sides).for_each(|s| own[(k, s)] -= pivot * product[(k, s)]);
            }
        } else {
            let upper = MatRef::from_column_major_slice(&self.upper[f.upper..][..width * reach], reach, width);
            matmul(own.as_mut(), Accum::Add, upper.transpose(), below, -1.0, Par::Seq);
        }
        solve_upper_triangular_in_place(square, own, Par::Seq);
    }
}
