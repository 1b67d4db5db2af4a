//! Files of numbers: tables, ground motions.

pub mod guard;
pub mod motion;
pub(crate) mod number_files;
pub mod output_folder;
pub(crate) mod series;
pub mod table;
pub mod vtu;
