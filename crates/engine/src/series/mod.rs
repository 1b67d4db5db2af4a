//! Time series: the factor of a load, or an acceleration, at a time.

mod path;
mod related;
mod simple;

pub use path::{Path, PathTimes};
pub use related::{Delayed, Derivative, Integral};
pub use simple::{Constant, Linear, Power, Pulse, Rectangular, Triangle, Trig, Wave};

use std::any::Any;
use std::fmt;
use std::sync::Arc;

/// Comparison of series.
pub trait CompareSeries: Any {
    /// Returns true if another series is the same function.
    fn equals(&self, other: &dyn TimeSeries) -> bool;
}

impl<T: TimeSeries + PartialEq> CompareSeries for T {
    fn equals(&self, other: &dyn TimeSeries) -> bool {
        let other: &dyn Any = other;
        other.downcast_ref::<T>() == Some(self)
    }
}

/// A function of time.
pub trait TimeSeries: CompareSeries + fmt::Debug + Send + Sync {
    /// Value at a time.
    fn factor(&self, time: f64) -> f64;

    /// First and second derivative at a time. A jump has none: both are those beside it. At a corner the first derivative is
    /// the mean of both sides. The second one of a broken line is the change of slope at its points, over the mean length
    /// of the pieces beside them, and linear in between.
    fn derivatives(&self, time: f64) -> [f64; 2];

    /// Integral from time zero on of a series without an end; `None` for one that has an end.
    fn integral(&self) -> Option<Series> {
        None
    }

    /// Value and slope with which it goes on after its end.
    fn after_end(&self) -> [f64; 2] {
        [0.0; 2]
    }

    /// Time of the first value that is given explicitly.
    fn start(&self) -> f64 {
        0.0
    }

    /// Time of the last value that is given explicitly: how long an excitation by this series lasts.
    fn end(&self) -> Option<f64> {
        None
    }

    /// A step of time that resolves it, for integrating it: `None` where any does.
    fn step(&self) -> Option<f64> {
        None
    }
}

/// A series as loads and excitations share it.
pub type Series = Arc<dyn TimeSeries>;
