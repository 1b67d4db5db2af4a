//! A measured series with its meaning.

use crate::fault::Fault;
use crate::unit::{Quantity, Unit};
use crate::way::{Key, Way};
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
        self.set_unit(unit);
        self
    }

    /// State a known unit and its quantity.
    pub fn set_unit(&mut self, unit: Unit) {
        (self.quantity, self.unit, self.unit_name) = (Some(unit.quantity), Some(unit), unit.name.to_owned());
    }

    /// The samples in another unit of the same quantity.
    ///
    /// # Errors
    /// The unit of the samples is not known, or is one of another quantity.
    pub fn in_unit(&self, to: Unit, way: Way) -> Result<Vec<f64>, Fault> {
        let from = self.unit.ok_or_else(|| self.no_unit("a conversion needs it", way))?;
        let (factor, offset) = from.conversion(&to).ok_or_else(|| {
            Fault::new(format!("{} is {}, and {} is {}", from.name, from.quantity, to.name, to.quantity))
        })?;
        Ok(self.values.iter().map(|x| factor * x + offset).collect())
    }

    /// The fault of a unit that neither the file nor the user says.
    pub(crate) fn no_unit(&self, why: &str, way: Way) -> Fault {
        let what = self.quantity.map_or_else(|| "values".to_owned(), Quantity::words);
        let message = match self.unit_name.as_str() {
            "" => format!("the file gives no unit of its {what}"),
            word => format!("the unit \"{word}\" of the {what} is not known"),
        };
        let add = format!("add {}", way.spelled(Key::Unit));
        Fault::new(message).expected(if why.is_empty() { add } else { format!("{why}: {add}") })
    }

    /// Largest absolute value; 0 of no samples. Missing samples are left out.
    pub fn peak(&self) -> f64 {
        self.values.iter().fold(0.0, |m, x| m.max(x.abs()))
    }
}

/// The number of the channel of a name, a direction, or a number from 1.
///
/// # Errors
/// There is none, with those that there are.
pub fn find_channel<'a>(all: impl Iterator<Item = &'a Series> + Clone, word: &str) -> Result<usize, Fault> {
    let named = all.clone().position(|s| s.name == word || s.direction == word);
    let count = all.clone().count();
    let number = || word.parse::<usize>().ok()?.checked_sub(1).filter(|i| *i < count);
    named.or_else(number).ok_or_else(|| {
        Fault::new(format!("there is no channel \"{word}\"")).expected(format!("they are {}", channel_names(all)))
    })
}

/// Names of channels, or their numbers from 1, for a message.
pub fn channel_names<'a>(all: impl Iterator<Item = &'a Series>) -> String {
    let label = |(i, s): (usize, &Series)| if s.name.is_empty() { (i + 1).to_string() } else { s.name.clone() };
    all.enumerate().map(label).collect::<Vec<_>>().join(", ")
}
