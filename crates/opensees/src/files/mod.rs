//! Files of numbers: tables, ground motions.

pub mod motion;
pub mod number_files;
pub mod table;
