//! Which columns of the factors are worked out together, and which columns before them they need.

use super::super::{SolveError, ordering};
use crate::assembly::{Pattern, Storage};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;
use std::ops::Range;

/// Columns that are worked out together at most: what their sums keep in registers.
pub(super) const WIDTH: usize = 4;

/// Place of each entry among the values of the matrix, and its row or column.
type Entries = Vec<(usize, usize)>;

/// Pattern of the factors. That of L is that of Uᵀ.
#[derive(Debug)]
pub(super) struct Structure {
    /// Equation of each row of the factors.
    pub(super) original: Vec<usize>,
    /// Row of the factors of each equation.
    pub(super) row_of: Vec<usize>,
    /// Start of each column of L (and row of U); the first entry is the diagonal.
    pub(super) ptr: Vec<usize>,
    /// Rows of L by columns, rising.
    pub(super) idx: Vec<usize>,
    /// Columns that follow each other, where each has the rows of the one before without its first, at most [`WIDTH`].
    pub(super) panels: Vec<Panel>,
    /// Updates of the panels.
    pub(super) updates: Vec<Update>,
    /// Entries of the matrix as (place among the values, row or column of the factors), by factor column: those of the
    /// column from the diagonal down, then those of the row right of the diagonal.
    pub(super) entries: Entries,
    /// Start of both in `entries` by factor column.
    pub(super) entry_ptr: Vec<(usize, usize)>,
}

/// Columns that are worked out together.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    pub(super) columns: Range<usize>,
    /// Those in [`Structure::updates`].
    pub(super) updates: Range<usize>,
}

/// Columns of a group that rows of a panel are in.
#[derive(Clone, Debug)]
pub(super) struct Update {
    pub(super) columns: Range<usize>,
    /// Place of the first such row in the first column.
    pub(super) at: usize,
    /// Number of such rows.
    pub(super) rows: usize,
}

impl Structure {
    /// Pattern of the factors of a matrix.
    ///
    /// # Errors
    /// Not enough memory.
    pub(super) fn new(pattern: &Pattern) -> Result<Self, SolveError> {
        let n = pattern.n;
        let symbolic = ordering::cholesky(pattern, SupernodalThreshold::FORCE_SIMPLICIAL)?;
        let (original, row_of) = ordering::permutation(&symbolic, n);
        let SymbolicCholeskyRaw::Simplicial(s) = symbolic.raw() else { unreachable!("asked for a simplicial factor") };
        let (ptr, mut idx) = (s.col_ptr()[..=n].to_vec(), s.row_idx().to_vec());
        for j in 0..n {
            idx[ptr[j]..ptr[j + 1]].sort_unstable();
        }
        let groups = groups(&ptr, &idx);
        let (panels, updates) = panels(&ptr, &idx, &groups);
        let (entries, entry_ptr) = entries(pattern, &row_of);
        Ok(Self { original, row_of, ptr, idx, panels, updates, entries, entry_ptr })
    }

    /// Rows of a column below its diagonal.
    #[inline(always)]
    pub(super) fn rows_below(&self, column: usize) -> &[usize] {
        &self.idx[self.ptr[column] + 1..self.ptr[column + 1]]
    }
}

/// Columns that follow each other, where each has the rows of the one before without its first.
fn groups(ptr: &[usize], idx: &[usize]) -> Vec<Range<usize>> {
    let n = ptr.len() - 1;
    let mut groups: Vec<Range<usize>> = vec![];
    for j in 0..n {
        match groups.last_mut() {
            Some(g) if idx[ptr[j - 1] + 1..ptr[j]] == idx[ptr[j]..ptr[j + 1]] => g.end = j + 1,
            _ => groups.push(j..j + 1),
        }
    }
    groups
}

/// Panels of the groups, and the updates of each.
fn panels(ptr: &[usize], idx: &[usize], groups: &[Range<usize>]) -> (Vec<Panel>, Vec<Update>) {
    let columns: Vec<Range<usize>> =
        groups.iter().flat_map(|g| g.clone().step_by(WIDTH).map(|k| k..g.end.min(k + WIDTH))).collect();
    let mut panel_of = vec![0; ptr.len() - 1];
    for (p, c) in columns.iter().enumerate() {
        panel_of[c.clone()].fill(p);
    }
    let mut by_panel = vec![vec![]; columns.len()];
    for group in groups {
        let first = group.start;
        let mut at = ptr[first];
        while at < ptr[first + 1] {
            let panel = panel_of[idx[at]];
            let end = columns[panel].end;
            let rows = idx[at..ptr[first + 1]].iter().take_while(|&&row| row < end).count();
            let before = first..group.end.min(columns[panel].start);
            if !before.is_empty() {
                by_panel[panel].push(Update { columns: before, at, rows });
            }
            at += rows;
        }
    }
    let (mut panels, mut updates) = (vec![], vec![]);
    for (columns, own) in columns.into_iter().zip(by_panel) {
        let start = updates.len();
        updates.extend(own);
        panels.push(Panel { columns, updates: start..updates.len() });
    }
    (panels, updates)
}

/// Entries of a matrix by factor column, and where each starts. Those of a symmetric one all lie in the columns.
fn entries(pattern: &Pattern, row_of: &[usize]) -> (Entries, Vec<(usize, usize)>) {
    let n = pattern.n;
    let (mut below, mut right) = (vec![vec![]; n], vec![vec![]; n]);
    for col in 0..n {
        for at in pattern.col_ptr[col]..pattern.col_ptr[col + 1] {
            let (i, j) = (row_of[pattern.row_idx[at]], row_of[col]);
            match pattern.storage {
                Storage::Upper => below[i.min(j)].push((at, i.max(j))),
                _ if i >= j => below[j].push((at, i)),
                _ => right[i].push((at, j)),
            }
        }
    }
    let (mut entries, mut entry_ptr) = (vec![], vec![]);
    for (b, r) in below.into_iter().zip(right) {
        let start = entries.len();
        entries.extend(b);
        entry_ptr.push((start, entries.len()));
        entries.extend(r);
    }
    entry_ptr.push((entries.len(), entries.len()));
    (entries, entry_ptr)
}
