//! What a format reads, and what the user says beside it.

use crate::series::Series;
use crate::sheet::Sheet;

/// Most bytes that a compressed file may have when it is unpacked.
pub const MAX_UNPACKED: usize = 1 << 29;

/// What a format has read.
#[derive(Clone, Debug)]
pub(crate) enum Content {
    /// A table whose columns are still to be understood.
    Table(Sheet),
    /// Channels.
    Series {
        /// The channels.
        series: Vec<Series>,
        /// Lines of the header.
        header: Vec<String>,
        /// What was left out or taken otherwise than it is written.
        notes: Vec<String>,
    },
}

impl Content {
    pub(crate) fn series(series: Vec<Series>, header: Vec<String>, notes: Vec<String>) -> Self {
        Self::Series { series, header, notes }
    }
}

/// What the user says about a file that does not say it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Told {
    /// Unit of the values.
    pub unit: Option<String>,
    /// Step of time in s.
    pub dt: Option<f64>,
    /// Quantity: acceleration, velocity, displacement, force, ...
    pub quantity: Option<String>,
    /// What the numbers of a row are, in a table without names.
    pub layout: Option<Layout>,
}

/// What the numbers of a row are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Samples of several channels at one time.
    Columns,
    /// Samples of one channel one after another.
    Wrapped,
}

impl Layout {
    /// The layout of a word.
    ///
    /// # Errors
    /// The word is none.
    pub fn named(word: &str) -> Result<Self, String> {
        match word {
            "columns" => Ok(Self::Columns),
            "wrapped" => Ok(Self::Wrapped),
            _ => Err(format!("\"{word}\" is no layout: expected columns or wrapped")),
        }
    }
}
