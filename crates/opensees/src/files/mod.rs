//! Files that scripts read and write.

pub mod guard;
pub(crate) mod live;
pub(crate) mod number_files;
pub mod output_folder;
pub(crate) mod outputs;
pub(crate) mod series;
pub mod vtu;

pub use hysteron_files::write_durably as write_whole;
