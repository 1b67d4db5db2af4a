//! Tables and pictures of results.

mod figure;
pub mod html;
mod loops;
mod table;

pub use figure::{Curve, Figure, FigureError, Mark, sheet};
pub use loops::{Record, Units, cycle_charts, cycle_table, orbit_charts, orbit_table};
pub use table::{Cell, Column, Table};
