//! Histories of single nodes and devices, at every step.

use crate::numbers::narrow;
use crate::thin::thinned;

/// Rows of a table that grows with the steps. Beyond [`History::MOST`] rows, those that an eye does not miss are left
/// out.
#[derive(Clone, Debug)]
pub(crate) struct History {
    /// Numbers of a row.
    pub(crate) columns: usize,
    /// Step of each row.
    pub(crate) steps: Vec<u32>,
    /// The rows.
    pub(crate) rows: Vec<f32>,
}

impl History {
    const MOST: usize = 20_000;

    pub(crate) fn new(columns: usize) -> Self {
        Self { columns, steps: vec![], rows: vec![] }
    }

    /// Take the row of a step.
    pub(crate) fn push(&mut self, step: usize, row: impl Iterator<Item = f64>) {
        self.steps.push(step as u32);
        let end = self.rows.len() + self.columns;
        self.rows.extend(row.map(narrow).take(self.columns));
        self.rows.resize(end, 0.0);
        if self.steps.len() > Self::MOST {
            *self = self.thinned(1e-4, Self::MOST / 2);
        }
    }

    /// The rows that remain of it; see [`thinned`].
    pub(crate) fn thinned(&self, tolerance: f32, most: usize) -> Self {
        let kept = thinned(&self.rows, self.columns, tolerance, most);
        let rows = kept.iter().flat_map(|i| &self.rows[i * self.columns..][..self.columns]).copied().collect();
        Self { columns: self.columns, steps: kept.iter().map(|i| self.steps[*i]).collect(), rows }
    }

    /// A column.
    pub(crate) fn column(&self, column: usize) -> Vec<f32> {
        self.rows.iter().skip(column).step_by(self.columns).copied().collect()
    }

    /// The number of largest absolute value in a column, and its step.
    pub(crate) fn peak(&self, column: usize) -> (f32, u32) {
        let values = self.column(column);
        let all = values.iter().zip(&self.steps);
        all.fold((0.0, 0), |peak: (f32, u32), (x, s)| if x.abs() > peak.0.abs() { (*x, *s) } else { peak })
    }
}
