//! Elimination tree of the fronts, their rows, and where the entries of the matrix go.

use super::super::{SolveError, ordering};
use crate::assembly::{Pattern, Storage};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use std::ops::Range;

/// Subtrees that are eliminated side by side have at most one part in so many of all multiplications, where the tree allows it.
const PARTS: f64 = 32.0;

/// Columns that are eliminated together, and the rows that they reach.
#[derive(Clone, Debug)]
pub(super) struct Front {
    /// Its columns.
    pub(super) columns: Range<usize>,
    /// Its rows below them, in [`Tree::rows`].
    pub(super) below: Range<usize>,
    /// First front of its subtree: the fronts of a subtree follow each other, its root last.
    pub(super) first: usize,
    /// Number of its children.
    pub(super) children: usize,
    /// Start of its columns in the lower factor, by columns of all its rows. Its rows of the upper factor right of them start
    /// at a place of their own.
    pub(super) lower: usize,
    pub(super) upper: usize,
    /// Entries of the matrix that go into both, in [`Tree::entries`]: those of the lower factor end at the middle.
    pub(super) entries: [usize; 3],
    /// Multiplications of its subtree.
    work: f64,
}

impl Front {
    /// Number of columns, and of rows below them.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns.len(), self.below.len())
    }
}

/// The fronts in the order of their elimination.
#[derive(Debug)]
pub(super) struct Tree {
    /// Equation of each row of the factors, and row of each equation.
    pub(super) original: Vec<usize>,
    pub(super) row_of: Vec<usize>,
    pub(super) fronts: Vec<Front>,
    /// Rows below the columns of all fronts.
    pub(super) rows: Vec<usize>,
    /// Place of each of them in the front of the parent.
    pub(super) in_parent: Vec<usize>,
    /// Place of an entry among the values of the matrix, and from the start of its front in a factor.
    pub(super) entries: Vec<(usize, usize)>,
    /// Place of the diagonal of each equation among the values of the matrix.
    pub(super) diagonal: Vec<usize>,
    /// Roots of the subtrees that are eliminated side by side, rising.
    pub(super) side_by_side: Vec<usize>,
    /// Lengths of the factors.
    pub(super) lengths: [usize; 2],
}

impl Tree {
    /// The tree of a matrix. `None` where a factorisation takes fewer multiplications than `least`.
    ///
    /// # Errors
    /// Not enough memory.
    pub(super) fn new(pattern: &Pattern, least: f64) -> Result<Option<Self>, SolveError> {
        let symbolic = ordering::cholesky(pattern, SupernodalThreshold::FORCE_SUPERNODAL)?;
        let SymbolicCholeskyRaw::Supernodal(s) = symbolic.raw() else { return Ok(None) };
        let (fronts, rows, lengths) = fronts(s, pattern.storage == Storage::Full);
        if work(&fronts, pattern.storage) < least {
            return Ok(None);
        }
        let (original, row_of) = ordering::permutation(&symbolic, pattern.n);
        let mut tree = Self {
            in_parent: vec![0; rows.len()],
            side_by_side: vec![],
            diagonal: diagonal(pattern),
            entries: vec![],
            original,
            row_of,
            fronts,
            rows,
            lengths,
        };
        tree.join_parents();
        tree.place_entries(pattern);
        tree.part();
        Ok(Some(tree))
    }

    /// Rows below the columns of a front.
    pub(super) fn below(&self, front: &Front) -> &[usize] {
        &self.rows[front.below.clone()]
    }

    /// Place of a row in a front.
    fn place(&self, front: &Front, row: usize) -> usize {
        if row < front.columns.end {
            return row - front.columns.start;
        }
        front.columns.len() + self.below(front).partition_point(|r| *r < row)
    }

    /// Find the parents, the extents of the subtrees and the places of rows in parents.
    fn join_parents(&mut self) {
        let mut front_of = vec![0; self.original.len()];
        for (i, f) in self.fronts.iter().enumerate() {
            front_of[f.columns.clone()].fill(i);
        }
        for i in 0..self.fronts.len() {
            self.fronts[i].work += own_work(&self.fronts[i]);
            let Some(&next) = self.below(&self.fronts[i]).first() else { continue };
            let parent = front_of[next];
            let places: Vec<usize> =
                self.below(&self.fronts[i]).iter().map(|row| self.place(&self.fronts[parent], *row)).collect();
            self.in_parent[self.fronts[i].below.clone()].copy_from_slice(&places);
            let (first, work) = (self.fronts[i].first, self.fronts[i].work);
            let parent = &mut self.fronts[parent];
            parent.first = parent.first.min(first);
            parent.work += work;
            parent.children += 1;
        }
    }

    /// Sort the entries of the matrix into the fronts.
    fn place_entries(&mut self, pattern: &Pattern) {
        let n = pattern.n;
        let (mut lower, mut upper) = (vec![vec![]; n], vec![vec![]; n]);
        for col in 0..n {
            for at in pattern.col_ptr[col]..pattern.col_ptr[col + 1] {
                let (i, j) = (self.row_of[pattern.row_idx[at]], self.row_of[col]);
                match pattern.storage {
                    Storage::Upper => lower[i.min(j)].push((at, i.max(j))),
                    _ if i >= j => lower[j].push((at, i)),
                    _ => upper[i].push((at, j)),
                }
            }
        }
        let mut entries = vec![];
        for f in 0..self.fronts.len() {
            let front = &self.fronts[f];
            let (width, reach) = front.size();
            let height = width + reach;
            let start = entries.len();
            let place = |row| self.place(front, row);
            for (k, column) in front.columns.clone().enumerate() {
                entries.extend(lower[column].iter().map(|&(at, row)| (at, k * height + place(row))));
                // Entries right of the diagonal within the front lie above the diagonal of its square.
                let square = upper[column].iter().filter(|(_, j)| *j < front.columns.end);
                entries.extend(square.map(|&(at, j)| (at, place(j) * height + k)));
            }
            let middle = entries.len();
            for (k, row) in front.columns.clone().enumerate() {
                let right = upper[row].iter().filter(|(_, j)| *j >= front.columns.end);
                entries.extend(right.map(|&(at, j)| (at, k * reach + place(j) - width)));
            }
            self.fronts[f].entries = [start, middle, entries.len()];
        }
        self.entries = entries;
    }

    /// Choose the subtrees that are eliminated side by side: the heaviest is divided until none is heavy.
    fn part(&mut self) {
        let heavy = self.fronts.iter().map(own_work).sum::<f64>() / PARTS;
        let mut open: Vec<usize> = self.children(self.fronts.len());
        while let Some(root) = open.pop() {
            let children = self.children(root);
            if self.fronts[root].work > heavy && !children.is_empty() {
                open.extend(children);
            } else {
                self.side_by_side.push(root);
            }
        }
        self.side_by_side.sort_unstable();
    }

    /// Fronts above the subtrees that go side by side, rising.
    pub(super) fn above(&self) -> Vec<usize> {
        let mut out = vec![];
        let mut next = 0;
        for &root in &self.side_by_side {
            out.extend(next..self.fronts[root].first);
            next = root + 1;
        }
        out.extend(next..self.fronts.len());
        out
    }

    /// Children of a front, the last first; of the number of fronts, the roots.
    pub(super) fn children(&self, front: usize) -> Vec<usize> {
        let first = self.fronts.get(front).map_or(0, |f| f.first);
        let mut out = vec![];
        let mut end = front;
        while end > first {
            out.push(end - 1);
            end = self.fronts[end - 1].first;
        }
        out
    }
}

/// Multiplications of a factorisation.
pub(super) fn work(fronts: &[Front], storage: Storage) -> f64 {
    let share = if storage == Storage::Upper { 0.5 } else { 1.0 };
    share * fronts.iter().map(own_work).sum::<f64>()
}

/// Multiplications of the elimination of a front, where the matrix is not symmetric.
fn own_work(front: &Front) -> f64 {
    let (w, r) = (front.columns.len() as f64, front.below.len() as f64);
    w * w * w / 3.0 + w * w * r + w * r * r
}

/// Place of the diagonal of each equation among the values.
fn diagonal(pattern: &Pattern) -> Vec<usize> {
    (0..pattern.n).map(|i| pattern.place(i, i).unwrap_or(0)).collect()
}

/// Fronts without their parents, their rows, and the lengths of both factors.
fn fronts(s: &SymbolicSupernodalCholesky<usize>, full: bool) -> (Vec<Front>, Vec<usize>, [usize; 2]) {
    let (mut fronts, mut rows, mut lengths) = (vec![], vec![], [0; 2]);
    for k in 0..s.n_supernodes() {
        let columns = s.supernode_begin()[k]..s.supernode_end()[k];
        let start = rows.len();
        rows.extend_from_slice(s.supernode(k).pattern());
        rows[start..].sort_unstable();
        let (width, reach) = (columns.len(), rows.len() - start);
        fronts.push(Front {
            columns,
            below: start..rows.len(),
            first: k,
            children: 0,
            lower: lengths[0],
            upper: lengths[1],
            entries: [0; 3],
            work: 0.0,
        });
        lengths[0] += width * (width + reach);
        lengths[1] += if full { width * reach } else { 0 };
    }
    (fronts, rows, lengths)
}
