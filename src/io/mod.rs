//! Reading and writing numbers.

pub mod number;
