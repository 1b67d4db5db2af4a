//! Rows of a table: where they begin, what their cells are, where they end.

use super::cells::{Cell, detect, is_infinite, is_missing, is_number, stated};
use super::clock::{Stamp, between, parse as parse_stamp};
use super::layout::{Layout, filled, has_numbers, is_name, layout, split_names};
use super::{Column, Form, Separator, Sheet, SheetError, head};
use crate::fault::Fault;
use crate::number::{Decimals, shown};

/// Lines that the form of a table is told from.
const SAMPLE_LINES: usize = 300;
/// Lines of a header that are kept for messages.
pub(crate) const HEADER_LINES: usize = 60;
/// First words of lines below a table that are no samples.
const FOOTERS: &[&str] =
    &["end", "eof", "max", "maximum", "min", "minimum", "mean", "average", "std", "sum", "total", "mittelwert", "ende"];

/// A line of the text.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) number: usize,
    /// Byte at which it starts.
    pub(super) start: usize,
    pub(super) text: &'a str,
}

/// Lines that end with a line feed; with a carriage return alone if the text has no line feed.
struct Lines<'a> {
    text: &'a str,
    at: usize,
    number: usize,
    end: char,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Self {
        let end = if !text.contains('\n') && text.contains('\r') { '\r' } else { '\n' };
        Self { text, at: 0, number: 0, end }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        if self.at >= self.text.len() {
            return None;
        }
        let start = self.at;
        let length = self.text[start..].find(self.end).unwrap_or(self.text.len() - start);
        self.at = start + length + 1;
        self.number += 1;
        let text = &self.text[start..start + length];
        Some(Line { number: self.number, start, text: text.strip_suffix('\r').unwrap_or(text) })
    }
}

/// Start and text of a line, counted from 1.
pub(super) fn line_at(text: &str, number: usize) -> Option<(usize, &str)> {
    Lines::new(text).find(|l| l.number == number).map(|l| (l.start, l.text))
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with(['#', '%'])
}

/// Reads the rows.
struct Reader<'a> {
    form: &'a Form<'a>,
    separator: Separator,
    decimals: Decimals,
    sheet: Sheet,
    /// First stamp of each column of dates or times.
    stamps: Vec<Option<Stamp>>,
    /// Line of the names, for repetitions.
    names: &'a str,
    units: &'a str,
    repeated: Vec<usize>,
}

pub(super) fn parse(text: &str, form: &Form<'_>) -> Result<Sheet, SheetError> {
    let mut lines = Lines::new(text);
    let mut separator = form.separator;
    if let Some(found) = text.lines().next().and_then(stated) {
        lines.next();
        separator = separator.or(Some(found));
    }
    let is_row = |l: &Line<'_>| !l.text.trim().is_empty() && !is_comment(l.text) && l.number >= form.first_line;
    let (after, first) = (lines.at, lines.number);
    let sample: Vec<Line<'_>> = lines.filter(is_row).take(SAMPLE_LINES).collect();
    let texts: Vec<&str> = sample.iter().map(|l| l.text).collect();
    let separator = separator.unwrap_or_else(|| detect(&texts));
    let Some(layout) = layout(&sample, separator, form) else {
        let mut sheet = Sheet::default();
        sheet.header.extend(texts.iter().take(HEADER_LINES).map(|l| (*l).to_owned()));
        if let Some(names) = sample.first().filter(|_| sample.len() == 1) {
            // Names without rows are an empty table.
            let mut cells = vec![];
            separator.cells(names.text, &mut cells);
            if cells.iter().all(|c| is_name(c.text)) {
                sheet.columns = cells.iter().map(|c| Column { cell: c.text.to_owned(), ..Column::default() }).collect();
                (sheet.named, sheet.header) = (true, vec![]);
                (sheet.names_line, sheet.separator) = (names.number as u32, Some(separator));
            }
        }
        return if sample.is_empty() || sheet.named {
            Ok(sheet)
        } else {
            Err(SheetError::List(Fault::new("there are no rows of numbers")))
        };
    };
    let decimals =
        form.decimal.map_or_else(|| Decimals::new(separator.char()), |d| Decimals::stated(separator.char(), d));
    let line_of = |at: Option<usize>| at.map_or("", |i| sample[i].text);
    if layout.names.is_none()
        && let Some(line) = sample[..layout.rows].iter().find(|l| has_numbers(l.text, separator))
    {
        // Numbers above a table without names would be lost.
        let message = format!("line {} is no row of the table below it: \"{}\"", line.number, shown(line.text));
        return Err(SheetError::List(Fault::new(message).expected("expected rows of as many numbers")));
    }
    let mut reader = Reader {
        form,
        separator,
        decimals,
        sheet: Sheet::default(),
        stamps: vec![],
        names: line_of(layout.names),
        units: line_of(layout.units),
        repeated: vec![],
    };
    reader.sheet.separator = Some(separator);
    reader.sheet.names_line = layout.names.map_or(0, |i| sample[i].number as u32);
    let before = sample.get(layout.names.unwrap_or(layout.rows)).map_or(usize::MAX, |l| l.number);
    let is_header = |l: &Line<'_>| l.number > first && !l.text.trim().is_empty();
    let header = Lines::new(text).take_while(|l| l.number < before).filter(is_header).take(HEADER_LINES);
    reader.sheet.header.extend(header.map(|l| l.text.to_owned()));
    reader.heads(&sample, &layout)?;
    let lines = Lines { text, at: after, number: first, end: Lines::new(text).end };
    reader.rows(lines, sample.get(layout.rows).map_or(usize::MAX, |l| l.number))?;
    Ok(reader.finished())
}

impl<'a> Reader<'a> {
    /// Take names and units.
    fn heads(&mut self, sample: &[Line<'_>], layout: &Layout) -> Result<(), SheetError> {
        let mut cells = vec![];
        let mut row = vec![];
        if let Some(first) = sample.get(layout.rows) {
            self.separator.cells(first.text, &mut row);
        }
        let Some(names) = layout.names else {
            let n = filled(&row);
            self.sheet.columns.resize(n, Column::default());
            self.stamps.resize(n, None);
            return Ok(());
        };
        split_names(self.separator, sample[names].text, filled(&row), &mut cells);
        let filled = filled(&cells);
        self.sheet.columns =
            cells[..filled].iter().map(|c| Column { cell: c.text.to_owned(), ..Column::default() }).collect();
        self.sheet.named = true;
        self.stamps.resize(filled, None);
        if let Some(line) = layout.units.map(|i| sample[i]) {
            split_names(self.separator, line.text, filled, &mut cells);
            let units = head::units_row(cells.iter().map(|c| c.text)).unwrap_or_default();
            for (i, unit) in units.into_iter().enumerate().take(filled).filter(|(_, u)| !u.is_empty()) {
                let column = &mut self.sheet.columns[i];
                let (name, said) = head::name_and_unit(&column.cell);
                if !said.is_empty() && said != unit && head::time_unit(&unit).is_none() {
                    let message = format!("{name} has the unit {said} in the header and {unit} below");
                    let range = cells.get(i).map_or((0, 0), |c| c.range);
                    let fault = Fault::in_line(line.number, message).expected("expected one unit");
                    return Err(SheetError::Fault(fault.at((line.start + range.0, line.start + range.1))));
                }
                column.unit = unit;
            }
        }
        Ok(())
    }

    fn rows<'t>(&mut self, mut lines: Lines<'t>, first: usize) -> Result<(), SheetError> {
        let mut cells: Vec<Cell<'t>> = vec![];
        let mut after_blank = false;
        while let Some(line) = lines.next() {
            if line.number < first {
                continue;
            }
            if line.text.trim().is_empty() {
                after_blank = true;
                continue;
            }
            if is_comment(line.text) {
                continue;
            }
            self.separator.cells(line.text, &mut cells);
            if cells.iter().all(|c| c.text.is_empty()) && self.sheet.columns.len() > 1 {
                continue;
            }
            if let Err(e) = self.row(&line, &cells) {
                if !self.names.is_empty() && (line.text == self.names || line.text == self.units) {
                    self.repeated.push(line.number);
                } else if self.is_footer(&line, &cells, after_blank, Lines { ..lines }) {
                    let rest = lines.filter(|l| !l.text.trim().is_empty()).count();
                    let (from, to) = (line.number, line.number + rest);
                    let which =
                        if rest == 0 { format!("line {from}") } else { format!("lines {from} to {to} or later") };
                    self.sheet.notes.push(format!("{which} below the table: no samples: \"{}\"", shown(line.text)));
                    return Ok(());
                } else {
                    return Err(e);
                }
            }
            after_blank = false;
        }
        Ok(())
    }

    /// A line and all after it are no rows, and it begins as such lines do.
    fn is_footer(&self, line: &Line<'_>, cells: &[Cell<'_>], after_blank: bool, rest: Lines<'_>) -> bool {
        let word = line.text.trim().split(|c: char| !c.is_alphabetic()).next().unwrap_or_default().to_lowercase();
        let comma = self.separator != Separator::Char(',');
        let begins = FOOTERS.contains(&word.as_str()) || (after_blank && cells.iter().all(|c| is_name(c.text)));
        let mut cells = vec![];
        begins
            && self.sheet.rows() > 1
            && !rest.into_iter().any(|l| {
                self.separator.cells(l.text, &mut cells);
                cells.len() == self.sheet.columns.len() && cells.iter().all(|c| is_number(c.text, comma))
            })
    }

    /// The column of a cell, for messages.
    fn column_name(&self, i: usize) -> String {
        match self.sheet.columns.get(i) {
            Some(c) if head::time_head(&c.cell).is_some() => "the time".to_owned(),
            Some(c) if !c.cell.is_empty() => head::name_and_unit(&c.cell).0,
            Some(_) => String::new(),
            None => "a column without a name".to_owned(),
        }
    }

    fn row(&mut self, line: &Line<'_>, cells: &[Cell<'_>]) -> Result<(), SheetError> {
        let width = self.sheet.columns.len();
        let fault = |message: String, range: (usize, usize)| {
            Fault::in_line(line.number, message).at((line.start + range.0, line.start + range.1))
        };
        if cells.len() != width {
            self.check_width(line, cells)?;
        }
        let row = self.sheet.lines.len();
        for i in 0..width {
            let Some(cell) = cells.get(i) else {
                self.sheet.columns[i].values.push(f64::NAN);
                continue;
            };
            let value = self.value(i, cell.text, row);
            match value {
                Ok(x) => self.sheet.columns[i].values.push(x),
                Err(advice) => {
                    self.sheet.columns.iter_mut().for_each(|c| c.values.truncate(row));
                    let message = match self.column_name(i) {
                        name if name.is_empty() => format!("\"{}\" is not a number", cell.text),
                        name => format!("{name} is not a number: \"{}\"", cell.text),
                    };
                    let fault = fault(message, cell.range).expected("expected a number").help(advice);
                    return Err(if self.sheet.named { SheetError::Fault(fault) } else { SheetError::List(fault) });
                }
            }
        }
        self.sheet.lines.push(line.number as u32);
        Ok(())
    }

    /// The number in a cell, or seconds since the first row.
    fn value(&mut self, i: usize, text: &str, row: usize) -> Result<f64, String> {
        if self.sheet.columns[i].is_clock {
            let stamp = parse_stamp(text).ok_or("expected a date or a time of day")?;
            let first = self.stamps[i].get_or_insert(stamp);
            let unsure = "the order of day and month is not sure: save dates as 2024-12-31";
            return Ok(between(first, &stamp).ok_or(unsure)? as f64 / 1e9);
        }
        let bytes = text.as_bytes();
        if self.separator == Separator::Char(',') && bytes.len() > 1 && bytes[0] == b'0' && bytes[1].is_ascii_digit() {
            let whole = bytes.iter().all(u8::is_ascii_digit);
            if whole {
                return Err(
                    "are the commas decimal signs too? Save decimals with a point, or cells with semicolons".into()
                );
            }
        }
        let error = match self.decimals.number(text) {
            Ok(x) => return Ok(x),
            Err(advice) => advice,
        };
        if is_missing(text) {
            return Ok(f64::NAN);
        }
        if is_infinite(text) {
            return text.parse().map_err(|_| String::new());
        }
        if row == 0
            && let Some(stamp) = parse_stamp(text)
        {
            self.sheet.columns[i].is_clock = true;
            self.stamps[i] = Some(stamp);
            return Ok(0.0);
        }
        Err(error.to_owned())
    }

    /// A row of another number of cells than the columns: refused unless the rest is empty.
    fn check_width(&self, line: &Line<'_>, cells: &[Cell<'_>]) -> Result<(), SheetError> {
        let width = self.sheet.columns.len();
        let whole_line = (line.start, line.start + line.text.trim_end().len());
        if let Some(extra) = cells.iter().skip(width).position(|c| !c.text.is_empty()) {
            let at = cells[width + extra].range;
            // Trailing separators of the header have room for cells without a name.
            let unnamed = self.sheet.named && self.separator.char() != ' ' && {
                let mut heads = vec![];
                self.separator.cells(self.names, &mut heads);
                heads.len() >= cells.len()
            };
            if unnamed {
                let message = format!("column {} of {} has no name", width + extra + 1, self.form.name);
                let fault = Fault::in_line(line.number, message).expected("expected an empty cell");
                return Err(SheetError::Fault(fault.at((line.start + at.0, line.start + at.1))));
            }
        } else if cells.len() > width || self.form.short_rows {
            return Ok(());
        }
        if !self.sheet.named {
            let message = format!("there are {width} columns, but {} in line {}", cells.len(), line.number);
            return Err(SheetError::List(Fault::new(message).at(whole_line)));
        }
        let message = format!("a row of {} has {} cells, its header {width}", self.form.name, cells.len());
        let mut fault =
            Fault::in_line(line.number, message).expected("expected as many cells as columns").at(whole_line);
        let is_whole =
            |c: &str| c.trim_start_matches(['-', '+']).bytes().all(|b| b.is_ascii_digit() || b == b'e' || b == b'E');
        let twice = (width + 1..=2 * width).contains(&cells.len());
        if self.separator == Separator::Char(',') && twice && cells.iter().all(|c| is_whole(c.text)) {
            fault =
                fault.help("are the commas decimal signs too? Save decimals with a point, or cells with semicolons");
        }
        Err(SheetError::Fault(fault))
    }

    fn finished(mut self) -> Sheet {
        if let Some(first) = self.repeated.first() {
            let n = self.repeated.len();
            self.sheet.notes.push(format!("the names of the columns are repeated in line {first} and {} more", n - 1));
        }
        self.sheet
    }
}
