//! Tables of numbers as text: with or without names, in the forms of spreadsheets, loggers and recorders.

pub(crate) mod cells;
pub(crate) mod clock;
pub mod head;
mod layout;
mod rows;

use crate::fault::Fault;
pub(crate) use cells::Separator;
pub(crate) use rows::HEADER_LINES;

/// A column as it is written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Cell of the header; empty without one.
    pub cell: String,
    /// Unit in a row below the names; empty without one.
    pub unit: String,
    /// Numbers; NaN where a sample is missing. Dates and times of day are seconds since the first row.
    pub values: Vec<f64>,
    /// The cells are dates or times of day.
    pub is_clock: bool,
}

/// A table of numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// Lines before the names, as read.
    pub header: Vec<String>,
    /// The columns have names.
    pub named: bool,
    /// Columns of one length.
    pub columns: Vec<Column>,
    /// Line of each row, counted from 1. Empty where the file has no lines.
    pub lines: Vec<u32>,
    /// Line of the names, counted from 1; 0 without one.
    pub(crate) names_line: u32,
    /// What separates the cells.
    pub(crate) separator: Option<Separator>,
    /// What was left out or taken in another way than it is written.
    pub notes: Vec<String>,
}

/// What is known of a table before it is read.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Form<'a> {
    /// Name of the file, for messages.
    pub(crate) name: &'a str,
    /// Separator that the file states.
    pub(crate) separator: Option<Separator>,
    /// Decimal sign that the file states.
    pub(crate) decimal: Option<char>,
    /// Rows may have fewer cells than the header, whose last columns are then missing.
    pub(crate) short_rows: bool,
    /// Lines before these, counted from 1, are no rows.
    pub(crate) first_line: usize,
}

/// Why a text is no table.
#[derive(Debug)]
pub(crate) enum SheetError {
    /// The rows have no names and are not of one length: the numbers may be one list.
    List(Fault),
    /// A fault.
    Fault(Fault),
}

impl From<SheetError> for Fault {
    fn from(e: SheetError) -> Self {
        match e {
            SheetError::List(fault) | SheetError::Fault(fault) => fault,
        }
    }
}

impl Sheet {
    /// Read a table.
    ///
    /// Commas, semicolons, tabs or blanks separate the cells; the decimal sign may be a comma where it does not separate.
    /// Empty lines, and lines that begin with `#` or `%`, are skipped. Units may be in a row below the names.
    ///
    /// # Errors
    /// The place of something else than a number, or of a row with another number of cells.
    pub(crate) fn parse(text: &str, form: &Form<'_>) -> Result<Self, SheetError> {
        rows::parse(text, form)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.values.len())
    }

    /// Byte range of a cell in the text of the file. `None` if there is no such cell.
    pub(crate) fn cell_range(&self, text: &str, line: u32, column: usize) -> Option<(usize, usize)> {
        let at = rows::line_at(text, line as usize)?;
        let mut cells = vec![];
        self.separator?.cells(at.1, &mut cells);
        cells.get(column).map(|c| (at.0 + c.range.0, at.0 + c.range.1))
    }

    /// A row in words: its number and its line.
    pub fn row_name(&self, row: usize) -> String {
        match self.lines.get(row) {
            Some(line) => format!("row {} (line {line})", row + 1),
            None => format!("row {}", row + 1),
        }
    }

    /// Index of a column by its head, its name without unit, or its number counted from 1.
    ///
    /// # Errors
    /// There is none, with those that there are.
    pub fn find(&self, which: &str) -> Result<usize, String> {
        let by = |same: &dyn Fn(&str) -> bool| self.columns.iter().position(|c| !c.cell.is_empty() && same(&c.cell));
        let exact = by(&|cell| cell == which);
        let plain = || by(&|cell| head::known_unit(cell).0 == which);
        let numbered =
            || which.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).filter(|n| *n < self.columns.len());
        let any_case = || by(&|cell| head::known_unit(cell).0.eq_ignore_ascii_case(which));
        exact.or_else(plain).or_else(numbered).or_else(any_case).ok_or_else(|| {
            let names = self.columns.iter().map(|c| c.cell.as_str()).collect::<Vec<_>>().join(", ");
            let there = match (self.named, self.columns.len()) {
                (_, 0) => "the file has none".to_owned(),
                (false, n) => format!("they are 1 to {n}"),
                (true, _) => format!("they are {names}"),
            };
            format!("there is no column \"{which}\": {there}")
        })
    }
}
