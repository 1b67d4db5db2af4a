//! Series that follow from others.

use super::{Path, Series, TimeSeries};

/// The first derivative of a series that has no end.
#[derive(Clone, Debug)]
pub struct Derivative {
    of: Series,
}

impl Derivative {
    /// Of a series.
    pub fn new(of: Series) -> Self {
        Self { of }
    }
}

impl PartialEq for Derivative {
    fn eq(&self, other: &Self) -> bool {
        self.of.equals(&*other.of)
    }
}

impl TimeSeries for Derivative {
    fn factor(&self, time: f64) -> f64 {
        self.of.derivatives(time)[0]
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        [self.of.derivatives(time)[1], 0.0]
    }
    fn end(&self) -> Option<f64> {
        self.of.end()
    }
}

/// A series with an end, later by a time.
#[derive(Clone, Debug)]
pub struct Delayed {
    /// The series.
    pub of: Series,
    /// Delay, s.
    pub by: f64,
}

impl PartialEq for Delayed {
    fn eq(&self, other: &Self) -> bool {
        self.by == other.by && self.of.equals(&*other.of)
    }
}

impl TimeSeries for Delayed {
    fn factor(&self, time: f64) -> f64 {
        self.of.factor(time - self.by)
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        self.of.derivatives(time - self.by)
    }
    fn after_end(&self) -> [f64; 2] {
        self.of.after_end()
    }
    fn start(&self) -> f64 {
        self.of.start() + self.by
    }
    fn end(&self) -> Option<f64> {
        self.of.end().map(|end| end + self.by)
    }
    fn step(&self) -> Option<f64> {
        self.of.step()
    }
}

/// The integral of a series that goes on after its end: sums up to there, and a polynomial from there.
#[derive(Clone, Debug, PartialEq)]
pub struct Integral {
    /// Sums up to the end.
    pub sums: Path,
    /// Value and slope of the series where the sums are over.
    pub after: [f64; 2],
}

impl Integral {
    /// Time since the last of the sums, where it is over.
    fn since(&self, time: f64) -> Option<f64> {
        let end = self.sums.start + self.sums.dt * (self.sums.values.len() as f64 - 1.0);
        (time > end).then_some(time - end)
    }
}

impl TimeSeries for Integral {
    fn factor(&self, time: f64) -> f64 {
        let [value, slope] = self.after;
        let since = self.since(time).unwrap_or(0.0);
        self.sums.factor(time) + since * (value + 0.5 * since * slope)
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        let [value, slope] = self.after;
        self.since(time).map_or_else(|| self.sums.derivatives(time), |since| [value + since * slope, slope])
    }
    fn after_end(&self) -> [f64; 2] {
        let end = self.sums.start + self.sums.dt * self.sums.values.len() as f64;
        [self.factor(end), self.derivatives(end)[0]]
    }
    fn start(&self) -> f64 {
        self.sums.start
    }
    fn end(&self) -> Option<f64> {
        self.sums.end()
    }
    fn step(&self) -> Option<f64> {
        Some(self.sums.dt)
    }
}
