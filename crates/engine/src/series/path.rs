//! Series given by points, linear in between.

use super::TimeSeries;

/// Times within this part of a piece from one of its points are at the point: sums of steps of time round.
const AT_POINT: f64 = 1e-6;

/// First and second derivative of a broken line of `n` points at a part, 0 to 1, of its piece `i`. `point` gives time and value
/// of a point.
fn derivatives_of_line(n: usize, point: impl Fn(usize) -> (f64, f64), i: usize, part: f64) -> [f64; 2] {
    let slope = |k: usize| {
        let ((t1, a), (t2, b)) = (point(k), point(k + 1));
        if t2 > t1 { (b - a) / (t2 - t1) } else { 0.0 }
    };
    let bend = |k: usize| {
        if k == 0 || k + 1 >= n {
            return 0.0;
        }
        let length = point(k + 1).0 - point(k - 1).0;
        if length > 0.0 { 2.0 * (slope(k) - slope(k - 1)) / length } else { 0.0 }
    };
    let corner = |k: usize| {
        let first = match k {
            0 => slope(0),
            _ if k + 1 == n => slope(k - 1),
            _ => 0.5 * (slope(k - 1) + slope(k)),
        };
        [first, bend(k)]
    };
    if part < AT_POINT {
        corner(i)
    } else if part > 1.0 - AT_POINT {
        corner(i + 1)
    } else {
        [slope(i), (1.0 - part) * bend(i) + part * bend(i + 1)]
    }
}

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
    fn derivatives(&self, time: f64) -> [f64; 2] {
        let (n, place) = (self.values.len(), (time - self.start) / self.dt);
        if n < 2 || place < 0.0 || place > (n - 1) as f64 + AT_POINT {
            return [0.0; 2];
        }
        let i = (place as usize).min(n - 2);
        let point = |k: usize| (self.dt * k as f64, self.factor * self.values[k]);
        derivatives_of_line(n, point, i, place - i as f64)
    }
    fn after_end(&self) -> [f64; 2] {
        let last = self.values.last().filter(|_| self.use_last);
        [last.map_or(0.0, |last| self.factor * last), 0.0]
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
    fn derivatives(&self, time: f64) -> [f64; 2] {
        let (n, times) = (self.times.len(), &self.times);
        if n < 2 || time < times[0] {
            return [0.0; 2];
        }
        // The last of several points at one time.
        let i = (times.partition_point(|&t| t <= time) - 1).min(n - 2);
        let length = times[i + 1] - times[i];
        let part = if length > 0.0 { (time - times[i]) / length } else { 1.0 };
        if part > 1.0 + AT_POINT {
            return [0.0; 2];
        }
        derivatives_of_line(n, |k| (times[k], self.factor * self.values[k]), i, part)
    }
    fn after_end(&self) -> [f64; 2] {
        let last = self.values.last().filter(|_| self.use_last);
        [last.map_or(0.0, |last| self.factor * last), 0.0]
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
