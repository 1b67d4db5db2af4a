//! Row exchanges for a matrix that was factored without them and has lost a pivot.

use super::pivoted::PivotedLu;
use super::{Pivots, SINGULAR, SolveError};
use crate::assembly::{Pattern, Storage};

/// Factors with row exchanges, which take over where a pivot of an unsymmetric matrix is lost.
#[derive(Debug, Default)]
pub(super) struct Exchanges {
    factors: Option<Box<PivotedLu>>,
    /// They are those of the last matrix.
    in_use: bool,
}

impl Exchanges {
    /// Factor a matrix again, if these pivots were lost. The pivots of what counts.
    pub(super) fn where_lost(
        &mut self,
        pivots: Pivots,
        pattern: &Pattern,
        values: &[f64],
    ) -> Result<Pivots, SolveError> {
        self.in_use = pivots.ratio <= SINGULAR && pattern.storage == Storage::Full;
        if !self.in_use {
            return Ok(pivots);
        }
        let factors = match &mut self.factors {
            Some(f) => f,
            none => none.insert(Box::new(PivotedLu::new(pattern)?)),
        };
        factors.factor(pattern, values)?;
        // Row exchanges hide the pivots. A regular matrix gives back a vector of ones from its row sums.
        let mut x = vec![0.0; pattern.n];
        for col in 0..pattern.n {
            for (row, value) in pattern.column(values, col) {
                x[row] += value;
            }
        }
        factors.solve(&mut x);
        let regular = x.iter().all(|x| (x - 1.0).abs() < 1e-3);
        Ok(if regular { Pivots::GOOD } else { pivots })
    }

    /// Returns true if they are those of the last matrix.
    pub(super) fn are_in_use(&self) -> bool {
        self.in_use
    }

    /// Solve with them in place if they are in use, else with others.
    pub(super) fn solve_or(&mut self, x: &mut [f64], others: impl FnOnce(&mut [f64])) {
        match &mut self.factors {
            Some(f) if self.in_use => f.solve(x),
            _ => others(x),
        }
    }
}
