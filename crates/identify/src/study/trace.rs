//! Recorder output in memory.

use hysteron_engine::record::{Output, RecordError};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The rows of a recorder, with their times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Domain time of each row. The first row is the state at the start of the analysis, if it is known.
    pub times: Vec<f64>,
    /// Number of columns.
    pub width: usize,
    /// Values, row by row.
    pub values: Vec<f64>,
    /// True if the first row is the state at the start, which the recorder itself did not write.
    pub has_start: bool,
    /// Names of the columns.
    pub labels: Vec<String>,
    /// Columns that are kept, in rising order; `None` for all of them.
    pub kept: Option<Arc<[usize]>>,
    /// True if the time did not increase within an analysis. The pseudo-time of DisplacementControl is the load factor.
    pub no_clock: bool,
}

impl Trace {
    #[inline]
    fn push(&mut self, time: f64, row: &[f64]) {
        if self.width != row.len() {
            let (labels, kept) = (std::mem::take(&mut self.labels), self.kept.take());
            *self = Self { width: row.len(), labels, kept, ..Self::default() };
        }
        self.no_clock |= self.times.last().is_some_and(|t| *t >= time);
        self.times.push(time);
        match &self.kept {
            None => self.values.extend_from_slice(row),
            Some(kept) => self.values.extend(kept.iter().map(|c| row.get(*c).copied().unwrap_or(f64::NAN))),
        }
    }

    /// Number of columns that are kept.
    fn kept_width(&self) -> usize {
        self.kept.as_ref().map_or(self.width, |kept| kept.len())
    }

    /// Place of a column among those that are kept.
    fn place(&self, column: usize) -> Option<usize> {
        match &self.kept {
            None => (column < self.width).then_some(column),
            Some(kept) => kept.binary_search(&column).ok(),
        }
    }

    /// Values of a column, row by row; `None` where it is not kept.
    pub fn column(&self, column: usize) -> Option<impl Iterator<Item = f64> + Clone + '_> {
        let place = self.place(column).filter(|_| column < self.width)?;
        Some(self.values.iter().skip(place).step_by(self.kept_width()).copied())
    }

    /// Add rows at their times, of the columns that are kept.
    fn extend(&mut self, times: &[f64], rows: &[f64]) {
        self.no_clock |= self.times.last().zip(times.first()).is_some_and(|(last, first)| last >= first);
        // Without an early end, the compiler makes vector instructions of it.
        self.no_clock |= times.windows(2).fold(false, |stands, t| stands | (t[0] >= t[1]));
        self.times.extend_from_slice(times);
        self.values.extend_from_slice(rows);
    }

    /// Remove the rows, keeping their memory.
    fn clear(&mut self) {
        self.times.clear();
        self.values.clear();
        (self.has_start, self.no_clock) = (false, false);
    }

    /// Returns true if a column is kept and has numbers alone.
    pub(super) fn is_finite(&self, column: usize) -> bool {
        let (width, place) = (self.kept_width(), self.place(column));
        let Some(place) = place.filter(|_| column < self.width) else { return false };
        // Without an early end, the compiler makes vector instructions of it.
        let all = |sum: bool, v: &f64| sum & v.is_finite();
        if width == 1 {
            self.values.iter().fold(true, all)
        } else {
            self.values.iter().skip(place).step_by(width).fold(true, all)
        }
    }

    /// A column at increasing times: linear between rows, the first row before it, NaN after the last row.
    pub fn sample(&self, column: usize, times: &[f64]) -> Vec<f64> {
        let (width, place) = (self.kept_width(), self.place(column));
        let Some(place) = place.filter(|_| !self.times.is_empty() && column < self.width) else {
            return vec![f64::NAN; times.len()];
        };
        // Round-off must not put a last sample beyond the end of the analysis.
        let end = self.times[self.times.len() - 1];
        let close = 1e-9 * end.abs().max(1e-9);
        let row = |i: usize| self.times.get(i).zip(self.values.get(i * width + place));
        // Rows before and after a time. After the last one there is none, and the samples are no numbers.
        let (mut i, mut t0, mut a) = (0, f64::NAN, f64::NAN);
        let (mut t1, mut b) = (self.times[0], self.values[place]);
        let mut samples = Vec::with_capacity(times.len());
        for &t in times {
            let t = if t > end && t - end <= close { end } else { t };
            while t1 < t {
                i += 1;
                (t0, a) = (t1, b);
                (t1, b) = row(i).map_or((f64::INFINITY, f64::NAN), |(t, v)| (*t, *v));
            }
            samples.push(if i == 0 { b } else { a + (b - a) * ((t - t0) / (t1 - t0)) });
        }
        samples
    }
}

/// Output of an observed recorder. Clones share its trace. The clone that writes owns the trace until it is finished or
/// dropped, so that writing a row takes no lock.
#[derive(Debug, Default)]
pub(super) struct TraceOutput {
    shared: Arc<Mutex<Trace>>,
    writing: Option<Trace>,
    time: f64,
    kept: Option<Arc<[usize]>>,
}

impl Clone for TraceOutput {
    fn clone(&self) -> Self {
        Self { shared: self.shared.clone(), writing: None, time: self.time, kept: self.kept.clone() }
    }
}

impl TraceOutput {
    /// An output that keeps some columns, in rising order.
    pub(super) fn of_columns(columns: Vec<usize>) -> Self {
        let kept: Option<Arc<[usize]>> = Some(columns.into());
        let trace = Trace { kept: kept.clone(), ..Trace::default() };
        Self { shared: Arc::new(Mutex::new(trace)), writing: None, time: 0.0, kept }
    }

    fn shared(&self) -> MutexGuard<'_, Trace> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Remove the rows.
    pub(super) fn clear(&self) {
        self.shared().clear();
    }

    /// Apply a function to the trace.
    pub(super) fn with<R>(&self, f: impl FnOnce(&Trace) -> R) -> R {
        f(&self.shared())
    }

    /// The trace to write to, taken from the shared place at first.
    fn writing(&mut self) -> &mut Trace {
        let Self { shared, writing, .. } = self;
        writing.get_or_insert_with(|| std::mem::take(&mut *shared.lock().unwrap_or_else(PoisonError::into_inner)))
    }

    /// Put the trace back to the shared place.
    fn share(&mut self) {
        if let Some(trace) = self.writing.take() {
            *self.shared() = trace;
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
        let is_reset = |t: &Trace| t.times.last().is_none_or(|last| time < *last);
        self.writing.as_ref().map_or_else(|| self.with(is_reset), is_reset)
    }

    fn start(&mut self, time: f64, row: &[f64]) {
        // The time was reset, so earlier rows belong to an earlier stage.
        let t = self.writing();
        t.clear();
        t.push(time, row);
        t.has_start = true;
    }

    fn begin(&mut self, labels: &[String]) -> Result<(), RecordError> {
        let trace = self.writing();
        // Thousands of runs have the same columns.
        if trace.labels != labels {
            trace.labels = labels.to_vec();
        }
        if trace.times.is_empty() {
            trace.width = labels.len();
        }
        Ok(())
    }

    fn at(&mut self, time: f64) {
        self.time = time;
    }

    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        let time = self.time;
        self.writing().push(time, row);
        Ok(())
    }

    fn columns(&self) -> Option<&[usize]> {
        self.kept.as_deref()
    }

    fn rows(&mut self, times: &[f64], rows: &[f64]) -> Result<(), RecordError> {
        self.writing().extend(times, rows);
        Ok(())
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.share();
        Ok(())
    }
}

/// Output of a recorder that is not observed. It keeps nothing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unobserved;

impl Output for Unobserved {
    fn row(&mut self, _: &[f64]) -> Result<(), RecordError> {
        Ok(())
    }

    fn rows(&mut self, _: &[f64], _: &[f64]) -> Result<(), RecordError> {
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
    fn sample_interpolates_between_rows_and_is_nan_after_the_last() {
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
