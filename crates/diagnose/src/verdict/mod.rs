//! The result of a diagnosis.

pub(crate) mod conclusion;
pub(crate) mod diagnosis;
pub mod discriminating_test;
pub mod mismatch;
pub(crate) mod report;
pub mod result_file;
