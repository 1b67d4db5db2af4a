//! Files of numbers: tables, ground motions.

pub mod motion;
pub(crate) mod number_files;
pub(crate) mod series;
pub mod table;
pub mod vtu;
