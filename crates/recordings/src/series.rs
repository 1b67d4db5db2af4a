//! A measured series with its meaning.

use crate::unit::{Quantity, Unit};
use std::ops::Range;
use std::sync::Arc;

/// Times of the samples.
#[derive(Clone, Debug, PartialEq)]
pub enum Clock {
    /// The file gives none.
    Unknown,
    /// Equal steps in s.
    Steps {
        /// Time of the first sample.
        start: f64,
        /// Step.
        dt: f64,
    },
    /// A time in s for each sample, increasing.
    Times(Arc<[f64]>),
}

/// Steps that differ by more than this share of the mean are not equal.
const STEP_TOLERANCE: f64 = 0.02;

/// The first of two or more times that does not follow after the mean step.
pub(crate) fn uneven(times: &[f64]) -> Option<usize> {
    let dt = mean_step(times);
    times.windows(2).position(|w| (w[1] - w[0] - dt).abs() > STEP_TOLERANCE * dt.abs()).map(|i| i + 1)
}

fn mean_step(times: &[f64]) -> f64 {
    (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64
}

impl Clock {
    /// The clock of increasing times, two or more: of steps if they are equal.
    pub(crate) fn of_times(times: Vec<f64>) -> Self {
        match uneven(&times) {
            Some(_) => Self::Times(times.into()),
            None => Self::Steps { start: times[0], dt: mean_step(&times) },
        }
    }

    /// The step in s, if the steps are equal.
    pub fn dt(&self) -> Option<f64> {
        if let Self::Steps { dt, .. } = self { Some(*dt) } else { None }
    }

    /// The time in s of a sample. `None` if it is not known.
    pub fn time(&self, sample: usize) -> Option<f64> {
        match self {
            Self::Unknown => None,
            Self::Steps { start, dt } => Some(start + sample as f64 * dt),
            Self::Times(times) => times.get(sample).copied(),
        }
    }
}

/// The place of a series in its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Name of the file.
    pub file: String,
    /// Lines, counted from 1; empty for binary files.
    pub lines: Range<usize>,
    /// Bytes of the file that the samples came from.
    pub bytes: Range<usize>,
    /// Column, counted from 1, of a table.
    pub column: Option<usize>,
}

/// A measured series: samples and what is known about them.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name of the channel; empty where the file has one channel without a name.
    pub name: String,
    /// Text of the header about the record: event, date, station.
    pub title: String,
    /// Station, where the file gives it.
    pub station: String,
    /// Event, where the file gives it.
    pub event: String,
    /// Direction in the words of the file.
    pub direction: String,
    /// Direction of positive values in degrees clockwise from north.
    pub azimuth: Option<f64>,
    /// Quantity, where the file gives it.
    pub quantity: Option<Quantity>,
    /// Unit, where the file gives one that is known.
    pub unit: Option<Unit>,
    /// Unit in the words of the file.
    pub unit_name: String,
    /// Times.
    pub clock: Clock,
    /// Samples in the unit of the file; NaN where one is missing.
    pub values: Vec<f64>,
    /// Where they came from.
    pub origin: Origin,
}

impl Series {
    /// A series of which nothing is known but its samples.
    pub fn new(values: Vec<f64>) -> Self {
        Self {
            name: String::new(),
            title: String::new(),
            station: String::new(),
            event: String::new(),
            direction: String::new(),
            azimuth: None,
            quantity: None,
            unit: None,
            unit_name: String::new(),
            clock: Clock::Unknown,
            values,
            origin: Origin::default(),
        }
    }

    /// With equal steps from time 0.
    #[must_use]
    pub fn with_step(mut self, dt: f64) -> Self {
        self.clock = Clock::Steps { start: 0.0, dt };
        self
    }

    /// With a known unit and its quantity.
    #[must_use]
    pub fn with_unit(mut self, unit: Unit) -> Self {
        (self.quantity, self.unit, self.unit_name) = (Some(unit.quantity), Some(unit), unit.name.to_owned());
        self
    }

    /// Largest absolute value; 0 of no samples. Missing samples are left out.
    pub fn peak(&self) -> f64 {
        self.values.iter().fold(0.0, |m, x| m.max(x.abs()))
    }
}
