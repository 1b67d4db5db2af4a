//! Rows as lines of text.

use super::file::Form;
use super::output::Separator;
use crate::number_format::Style;

/// A line a row (OpenSees' `-file` and `-csv`).
#[derive(Debug)]
pub(super) struct Text {
    style: Style,
    separator: u8,
}

impl Text {
    pub(super) fn new(style: Style, separator: Separator) -> Self {
        Self { style, separator: if separator == Separator::Space { b' ' } else { b',' } }
    }
}

impl Form for Text {
    fn row(&self, row: &[f64], to: &mut Vec<u8>) {
        for (i, x) in row.iter().enumerate() {
            if i > 0 {
                to.push(self.separator);
            }
            self.style.push_bytes(*x, to);
        }
        to.push(b'\n');
    }
}
