//! Files of numbers: tables, ground motions.

pub mod guard;
pub(crate) mod live;
pub mod motion;
pub(crate) mod number_files;
pub mod output_folder;
pub(crate) mod series;
pub mod table;
pub mod vtu;

pub use hysteron_files::write_durably as write_whole;
