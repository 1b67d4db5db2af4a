//! Pictures of results.

mod figure;

pub use figure::{Curve, Figure, FigureError, Mark};
