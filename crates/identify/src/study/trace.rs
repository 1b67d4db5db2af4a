//! What a recorder of a script wrote, kept as numbers.

use hysteron_engine::record::{Output, RecordError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The rows of a recorder, with their times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Domain time of each row. The first row is the state that the analysis started from, where that is known.
    pub times: Vec<f64>,
    /// Numbers in a row.
    pub width: usize,
    /// The rows, one after the other.
    pub values: Vec<f64>,
    /// The first row is the state at the start: the recorder did not write it.
    pub has_start: bool,
    /// The time went back, or stood, within an analysis: it is no clock (that of DisplacementControl is the load factor).
    pub no_clock: bool,
}

impl Trace {
    #[inline]
    fn push(&mut self, time: f64, row: &[f64]) {
        if self.width != row.len() {
            *self = Self { width: row.len(), ..Self::default() };
        }
        self.no_clock |= self.times.last().is_some_and(|t| *t >= time);
        self.times.push(time);
        self.values.extend_from_slice(row);
    }

    /// Forget the rows, keeping their memory.
    fn clear(&mut self) {
        self.times.clear();
        self.values.clear();
        (self.has_start, self.no_clock) = (false, false);
    }

    /// A column at given times, increasing: linear between the rows, the first row before it, NaN after the last.
    pub fn sample(&self, column: usize, times: &[f64]) -> Vec<f64> {
        let value = |row: usize| self.values[row * self.width + column];
        let mut row = 0;
        let at = |t: f64| {
            while row < self.times.len() && self.times[row] < t {
                row += 1;
            }
            match row {
                0 => value(0),
                r if r == self.times.len() => f64::NAN,
                r => {
                    let (t0, t1) = (self.times[r - 1], self.times[r]);
                    let (a, b) = (value(r - 1), value(r));
                    a + (b - a) * ((t - t0) / (t1 - t0))
                }
            }
        };
        if self.times.is_empty() || column >= self.width {
            return vec![f64::NAN; times.len()];
        }
        // A last sample at the end of the analysis, but for round-off, is within it.
        let end = self.times[self.times.len() - 1];
        let close = 1e-9 * end.abs().max(1e-9);
        times.iter().map(|t| if *t > end && *t - end <= close { end } else { *t }).map(at).collect()
    }
}

/// Where a recorder writes that is observed. Clones share the rows: the one that writes has them to itself until it is
/// finished or dropped, so that a row takes no lock.
#[derive(Debug, Default)]
pub(super) struct TraceOutput {
    shared: Arc<Mutex<Trace>>,
    own: Option<Trace>,
    time: f64,
}

impl Clone for TraceOutput {
    fn clone(&self) -> Self {
        Self { shared: self.shared.clone(), own: None, time: self.time }
    }
}

impl TraceOutput {
    fn shared(&self) -> MutexGuard<'_, Trace> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Forget the rows.
    pub(super) fn clear(&self) {
        self.shared().clear();
    }

    /// Look at the rows.
    pub(super) fn with<R>(&self, look: impl FnOnce(&Trace) -> R) -> R {
        look(&self.shared())
    }

    /// The rows, to write to.
    fn own(&mut self) -> &mut Trace {
        let Self { shared, own, .. } = self;
        own.get_or_insert_with(|| std::mem::take(&mut *shared.lock().unwrap_or_else(PoisonError::into_inner)))
    }

    /// Give back the rows.
    fn share(&mut self) {
        if let Some(own) = self.own.take() {
            *self.shared() = own;
        }
    }
}

impl Drop for TraceOutput {
    fn drop(&mut self) {
        self.share();
    }
}

impl Output for TraceOutput {
    fn wants_start(&self, time: f64) -> bool {
        let outlived = |t: &Trace| t.times.last().is_none_or(|last| time < *last);
        self.own.as_ref().map_or_else(|| self.with(outlived), outlived)
    }

    fn start(&mut self, time: f64, row: &[f64]) {
        // The clock was set back: what came before belongs to an earlier stage.
        let t = self.own();
        t.clear();
        t.push(time, row);
        t.has_start = true;
    }

    fn at(&mut self, time: f64) {
        self.time = time;
    }

    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        let time = self.time;
        self.own().push(time, row);
        Ok(())
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.share();
        Ok(())
    }
}

/// Where a recorder writes that nobody observes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unobserved;

impl Output for Unobserved {
    fn row(&mut self, _: &[f64]) -> Result<(), RecordError> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Trace;

    #[test]
    fn sampled_between_rows_and_never_beyond_the_last() {
        let t = Trace {
            times: vec![0.0, 1.0, 3.0],
            width: 2,
            values: vec![0.0, 0.0, 1.0, 10.0, 3.0, 30.0],
            ..Trace::default()
        };
        let y = t.sample(1, &[-1.0, 0.5, 1.0, 2.0, 3.0, 3.1]);
        assert_eq!(y[..5], [0.0, 5.0, 10.0, 20.0, 30.0]);
        assert!(y[5].is_nan());
        assert!(t.sample(2, &[1.0])[0].is_nan());
    }
}
