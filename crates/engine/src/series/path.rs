//! Series given by points, linear in between.

use super::TimeSeries;

/// Points at equal steps of time from `start`.
///
/// As in OpenSees the value is zero before the first point, and from the last point on, unless `use_last`.
#[derive(Clone, Debug)]
pub struct Path {
    /// Values at the points.
    pub values: Vec<f64>,
    /// Step of time.
    pub dt: f64,
    /// Multiplies the values.
    pub factor: f64,
    /// Go on with the last value.
    pub use_last: bool,
    /// Time of the first point.
    pub start: f64,
}

impl PartialEq for Path {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |p: &Self| (p.values.len(), p.dt, p.factor, p.use_last, p.start);
        // Series of thousands of points are compared for each model: without an early end, in vector instructions.
        let points = || self.values.iter().zip(&other.values);
        numbers(self) == numbers(other) && points().fold(true, |same, (a, b)| same & (a == b))
    }
}

impl TimeSeries for Path {
    fn factor(&self, time: f64) -> f64 {
        let Some(last) = self.values.last() else { return 0.0 };
        if time < self.start {
            return 0.0;
        }
        // Written so that a time on a point gives the interval that OpenSees takes.
        let place = (time - self.start) / self.dt;
        let i = place as usize;
        match self.values.get(i..i.saturating_add(2)) {
            Some(&[a, b]) => self.factor * (a + (b - a) * (place - i as f64)),
            _ if self.use_last => self.factor * last,
            _ => 0.0,
        }
    }
    fn start(&self) -> f64 {
        self.start
    }
    fn end(&self) -> Option<f64> {
        Some(self.start + self.dt * self.values.len() as f64)
    }
    fn step(&self) -> Option<f64> {
        Some(self.dt)
    }
}

/// Points at given times, which do not decrease.
///
/// Zero before the first and after the last, unless `use_last`; at the last point itself the last value.
#[derive(Clone, Debug, PartialEq)]
pub struct PathTimes {
    /// Times of the points.
    pub times: Vec<f64>,
    /// Values at the points, as many.
    pub values: Vec<f64>,
    /// Multiplies the values.
    pub factor: f64,
    /// Go on with the last value.
    pub use_last: bool,
}

impl TimeSeries for PathTimes {
    fn factor(&self, time: f64) -> f64 {
        let (Some(&first), Some(&end)) = (self.times.first(), self.times.last()) else { return 0.0 };
        let last = self.values[self.values.len() - 1];
        if time < first {
            return 0.0;
        }
        if time > end {
            return if self.use_last { self.factor * last } else { 0.0 };
        }
        // First point at or after the time.
        let i = self.times.partition_point(|&t| t < time);
        if self.times[i] == time {
            return self.factor * self.values[i];
        }
        let (t1, t2) = (self.times[i - 1], self.times[i]);
        let (a, b) = (self.values[i - 1], self.values[i]);
        self.factor * (a + (b - a) * (time - t1) / (t2 - t1))
    }
    fn start(&self) -> f64 {
        self.times.first().copied().unwrap_or(0.0)
    }
    fn end(&self) -> Option<f64> {
        self.times.last().copied()
    }
    fn step(&self) -> Option<f64> {
        let gaps = self.times.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > 0.0);
        gaps.min_by(f64::total_cmp)
    }
}
