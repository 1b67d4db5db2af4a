//! Reading and writing numbers, tables, and files of ground motions.

pub mod motion;
pub mod number;
pub mod table;
