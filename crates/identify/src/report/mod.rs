//! Tables and charts of results.

mod channels;
mod digits;
pub mod html;
mod loops;
mod table;

pub use channels::{NamedResponses, channel_files};
pub use digits::{significant, with_half_width};
pub use loops::{Record, Units, cycle_charts, cycle_table, orbit_charts, orbit_table};
pub use table::{Cell, Column, Table};
