//! Content of a file that a format reads.

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
