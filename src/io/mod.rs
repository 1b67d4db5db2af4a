//! Reading and writing numbers and files of ground motions.

pub mod motion;
pub mod number;
