//! Envelopes.

use super::RecordError;
use super::output::Output;

/// Smallest, largest and largest absolute value of each column, and when.
#[derive(Clone, Debug, Default)]
pub struct Envelope {
    /// Time and value of minimum, maximum and absolute maximum, by column.
    columns: Vec<[(f64, f64); 3]>,
}

impl Envelope {
    /// Take a row into account; whether it changed anything.
    pub fn take(&mut self, time: f64, row: &[f64]) -> bool {
        if self.columns.len() != row.len() {
            self.columns.clear();
            self.columns.extend(row.iter().map(|&x| [(time, x), (time, x), (time, x.abs())]));
            return true;
        }
        let mut changed = false;
        for (c, &x) in self.columns.iter_mut().zip(row) {
            if x < c[0].1 {
                c[0] = (time, x);
            } else if x > c[1].1 {
                c[1] = (time, x);
            } else {
                continue;
            }
            changed = true;
            if x.abs() > c[2].1 {
                c[2] = (time, x.abs());
            }
        }
        changed
    }

    /// Write the three rows; with the times, each before its value, if wanted.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn write(&self, times: bool, output: &mut dyn Output) -> Result<(), RecordError> {
        if self.columns.is_empty() {
            return Ok(());
        }
        output.restart()?;
        for kind in 0..3 {
            let row: Vec<f64> =
                self.columns.iter().flat_map(|c| [times.then_some(c[kind].0), Some(c[kind].1)]).flatten().collect();
            output.row(&row)?;
        }
        Ok(())
    }
}
