//! Time series: the factor of a load, or an acceleration, at a time.

mod path;
mod simple;

pub use path::{Path, PathTimes};
pub use simple::{Constant, Linear, Pulse, Rectangular, Triangle, Trig, Wave};

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
