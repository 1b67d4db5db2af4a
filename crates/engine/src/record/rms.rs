//! Root mean squares.

use super::RecordError;
use super::output::Output;

/// Root mean square of each column over the steps.
#[derive(Clone, Debug, Default)]
pub struct RootMeanSquare {
    sums: Vec<f64>,
    steps: u32,
}

impl RootMeanSquare {
    /// Take the row of a step into account.
    pub fn take(&mut self, row: &[f64]) {
        self.sums.resize(row.len(), 0.0);
        for (sum, x) in self.sums.iter_mut().zip(row) {
            *sum += x * x;
        }
        self.steps += 1;
    }

    /// Write the row of root mean squares; nothing before the first step.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn write(&self, output: &mut dyn Output) -> Result<(), RecordError> {
        if self.sums.is_empty() {
            return Ok(());
        }
        output.restart()?;
        let row: Vec<f64> = self.sums.iter().map(|sum| (sum / f64::from(self.steps)).sqrt()).collect();
        output.row(&row)
    }
}
