//! Sparsity pattern of the system matrix.

use std::ops::Range;

/// Storage of the matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// All n x n values by rows.
    Dense,
    /// By compressed columns, the upper triangle of a symmetric matrix.
    Upper,
    /// By compressed columns, all entries of a matrix whose pattern is symmetric.
    Full,
}

/// Places of the entries of a square matrix with a symmetric pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Number of rows.
    pub n: usize,
    /// Storage of the values.
    pub storage: Storage,
    /// Start of each column; empty for dense storage.
    pub col_ptr: Vec<usize>,
    /// Row of each entry, rising within a column; empty for dense storage.
    pub row_idx: Vec<usize>,
    /// Columns that follow each other and have the same rows, as those of a node; for full storage only.
    alike: Vec<Range<usize>>,
}

impl Pattern {
    /// From groups of equations that are all joined with each other (one group an element). The diagonal is always
    /// there.
    pub fn new<'a>(n: usize, storage: Storage, groups: impl Iterator<Item = &'a [u32]>) -> Self {
        let mut pattern = Self { n, storage, col_ptr: vec![], row_idx: vec![], alike: vec![] };
        if storage == Storage::Dense {
            return pattern;
        }
        let mut columns: Vec<Vec<u32>> = (0..n as u32).map(|i| vec![i]).collect();
        for group in groups {
            for &col in group {
                columns[col as usize]
                    .extend(group.iter().copied().filter(|&row| storage == Storage::Full || row < col));
            }
        }
        pattern.col_ptr.push(0);
        for c in &mut columns {
            c.sort_unstable();
            c.dedup();
            pattern.row_idx.extend(c.iter().map(|&r| r as usize));
            pattern.col_ptr.push(pattern.row_idx.len());
        }
        if storage == Storage::Full {
            pattern.alike = pattern.alike_columns();
        }
        pattern
    }

    /// Columns that follow each other and have the same rows, three at most.
    fn alike_columns(&self) -> Vec<Range<usize>> {
        let rows = |col: usize| &self.row_idx[self.col_ptr[col]..self.col_ptr[col + 1]];
        let mut alike: Vec<Range<usize>> = vec![];
        for col in 0..self.n {
            match alike.last_mut() {
                Some(a) if a.len() < 3 && rows(a.start) == rows(col) => a.end = col + 1,
                _ => alike.push(col..col + 1),
            }
        }
        alike
    }

    /// Number of values kept.
    pub fn len(&self) -> usize {
        if self.storage == Storage::Dense { self.n * self.n } else { self.row_idx.len() }
    }

    /// Returns true if there are no entries.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Place of an entry among the values; `None` where the transposed entry stands for it, or there is none.
    pub fn place(&self, row: usize, col: usize) -> Option<usize> {
        if self.storage == Storage::Dense {
            return Some(row * self.n + col);
        }
        let from = self.col_ptr[col];
        self.row_idx[from..self.col_ptr[col + 1]].binary_search(&row).ok().map(|i| from + i)
    }

    /// Rows and values of the entries stored of a column.
    pub fn column<'a>(&'a self, values: &'a [f64], col: usize) -> impl Iterator<Item = (usize, f64)> + 'a {
        let range = self.col_ptr[col]..self.col_ptr[col + 1];
        self.row_idx[range.clone()].iter().copied().zip(values[range].iter().copied())
    }

    /// Calls `look` with row, column and value of each entry of a matrix, those for which a transposed entry stands too.
    pub fn for_each(&self, values: &[f64], mut look: impl FnMut(usize, usize, f64)) {
        if self.storage == Storage::Dense {
            return values.iter().enumerate().for_each(|(at, &value)| look(at / self.n, at % self.n, value));
        }
        for col in 0..self.n {
            for (row, value) in self.column(values, col) {
                look(row, col, value);
                if self.storage == Storage::Upper && row != col {
                    look(col, row, value);
                }
            }
        }
    }

    /// y = A x.
    pub fn multiply(&self, values: &[f64], x: &[f64], y: &mut [f64]) {
        if self.storage == Storage::Dense {
            for (y, row) in y.iter_mut().zip(values.chunks_exact(self.n.max(1))) {
                *y = row.iter().zip(x).map(|(a, x)| a * x).sum();
            }
            return;
        }
        y.fill(0.0);
        if self.storage == Storage::Upper {
            return self.for_each(values, |row, col, value| y[row] += value * x[col]);
        }
        for columns in &self.alike {
            let first = self.col_ptr[columns.start];
            let rows = &self.row_idx[first..self.col_ptr[columns.start + 1]];
            let (n, x) = (rows.len(), &x[columns.clone()]);
            match *x {
                [x] => rows.iter().zip(&values[first..first + n]).for_each(|(&row, a)| y[row] += a * x),
                [x0, x1] => {
                    let (a, b) = values[first..first + 2 * n].split_at(n);
                    for ((&row, a), b) in rows.iter().zip(a).zip(b) {
                        y[row] += a * x0 + b * x1;
                    }
                }
                [x0, x1, x2] => {
                    let (a, b) = values[first..first + 3 * n].split_at(n);
                    let (b, c) = b.split_at(n);
                    for (((&row, a), b), c) in rows.iter().zip(a).zip(b).zip(c) {
                        y[row] += a * x0 + b * x1 + c * x2;
                    }
                }
                _ => unreachable!("three columns at most"),
            }
        }
    }
}
