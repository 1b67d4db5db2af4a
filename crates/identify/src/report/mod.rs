//! Tables and charts of results.

pub mod html;
mod loops;
mod table;

pub use loops::{Record, Units, cycle_charts, cycle_table, orbit_charts, orbit_table};
pub use table::{Cell, Column, Table};
