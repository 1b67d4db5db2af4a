//! Rows of numbers as they are in memory.

use super::file::Form;

/// Eight bytes a number, the smallest byte first, and a line feed after each row (OpenSees' `-binary`).
#[derive(Debug)]
pub(super) struct Binary;

impl Form for Binary {
    fn row(&self, row: &[f64], to: &mut Vec<u8>) {
        to.extend(row.iter().flat_map(|x| x.to_le_bytes()));
        to.push(b'\n');
    }
}
