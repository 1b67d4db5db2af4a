//! Axes of charts: the map from values to pixels, and their ticks.

/// An axis between two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    low: f64,
    high: f64,
    /// Pixels of both ends.
    pixels: (f64, f64),
    log: bool,
}

/// Ticks of an axis, about.
const TICKS: f64 = 7.0;
/// Largest magnitude that is drawn: beyond, differences and sums of ends are not finite.
pub(crate) const MAX_DRAWN: f64 = 1e100;
/// Ratio of the largest to the smallest positive value from which an axis is better logarithmic.
const LOG_RATIO: f64 = 100.0;

/// Returns true if all values are positive and span more than two decades.
pub fn spans_decades(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) = values.filter(|x| x.is_finite()).fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(x), b.max(x)));
    low > 0.0 && high > LOG_RATIO * low
}

impl Axis {
    /// An axis; a logarithmic one needs positive ends.
    pub(super) fn new((low, high): (f64, f64), pixels: (f64, f64), log: bool) -> Self {
        Self { low, high, pixels, log: log && low > 0.0 }
    }

    /// Ends of an axis around values, with a little room; whole decades of a logarithmic one. `None` without values.
    pub(super) fn ends(values: impl Iterator<Item = f64>, log: bool) -> Option<(f64, f64)> {
        let usable = values.filter(|x| x.abs() <= MAX_DRAWN && (!log || *x > 0.0));
        let (low, high) = usable.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if low > high {
            return None;
        }
        if log {
            let decade = |x: f64| 10f64.powf(x);
            return Some((decade((low.log10() - 0.05).floor()), decade((high.log10() + 0.05).ceil())));
        }
        let room = if high > low { 0.04 * (high - low) } else { high.abs().max(1.0) };
        Some((low - room, high + room))
    }

    fn part(&self, value: f64) -> f64 {
        if self.log {
            (value.max(f64::MIN_POSITIVE) / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// Pixel of a value.
    pub(super) fn pixel(&self, value: f64) -> f64 {
        self.pixels.0 + self.part(value) * (self.pixels.1 - self.pixels.0)
    }

    /// Ticks with their texts. `whole` keeps whole numbers only.
    pub(super) fn ticks(&self, whole: bool) -> Vec<(f64, String)> {
        if self.log {
            let exponents = self.low.log10().ceil() as i32..=self.high.log10().floor() as i32;
            return exponents.map(|e| (10f64.powi(e), decade(e))).collect();
        }
        let rough = (self.high - self.low) / TICKS;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(10.0 * power);
        let step = if whole { step.max(1.0) } else { step };
        let first = (self.low / step).ceil() as i64;
        let last = (self.high / step).floor() as i64;
        let largest = self.low.abs().max(self.high.abs());
        (first..=last).map(|i| (i as f64 * step, label(i as f64 * step, step, largest))).collect()
    }
}

/// A power of ten: a plain number near one.
fn decade(exponent: i32) -> String {
    match exponent {
        0..=4 => format!("{:.0}", 10f64.powi(exponent)),
        -4..=-1 => format!("{:.*}", exponent.unsigned_abs() as usize, 10f64.powi(exponent)),
        e => format!("1e{e}"),
    }
}

/// A number on an axis with the digits of the step.
fn label(value: f64, step: f64, largest: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&largest) {
        let digits = ((value.abs().log10().floor() - step.log10().floor()).max(0.0) as usize).min(6);
        return format!("{value:.digits$e}");
    }
    let digits = (-step.log10().floor()).max(0.0) as usize;
    format!("{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::{Axis, spans_decades};

    fn texts(low: f64, high: f64, log: bool) -> Vec<String> {
        Axis::new((low, high), (0.0, 100.0), log).ticks(false).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(texts(-0.11, 0.21, false), ["-0.10", "-0.05", "0", "0.05", "0.10", "0.15", "0.20"]);
        assert_eq!(texts(0.0, 4.2e7, false), ["0", "1e7", "2e7", "3e7", "4e7"]);
        assert_eq!(texts(1e-5, 10.0, true), ["1e-5", "0.0001", "0.001", "0.01", "0.1", "1", "10"]);
    }

    #[test]
    fn values_have_pixels() {
        let axis = Axis::new((0.01, 100.0), (300.0, 100.0), true);
        assert!((axis.pixel(1.0) - 200.0).abs() < 1e-9);
        assert!((Axis::new((-1.0, 1.0), (0.0, 50.0), false).pixel(0.5) - 37.5).abs() < 1e-9);
    }

    #[test]
    fn positive_values_over_decades_are_logarithmic() {
        assert!(spans_decades([0.001, 0.2].into_iter()));
        assert!(!spans_decades([0.1, 0.2].into_iter()) && !spans_decades([0.0, 0.2].into_iter()));
        assert_eq!(Axis::ends([0.002, 0.3].into_iter(), true), Some((0.001, 1.0)));
    }
}
