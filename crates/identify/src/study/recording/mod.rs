//! Recordings: measured channels over time, as a table of separated values.

mod format;

use super::unit::Unit;
use format::{Decimals, separator};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, Span};

/// A measured channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, without the unit.
    pub name: String,
    /// Unit; empty if the header has none.
    pub unit: String,
    /// Samples in that unit, one for each time; NaN where one is missing.
    pub values: Vec<f64>,
}

/// The recording of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    /// Times in s, increasing.
    pub times: Vec<f64>,
    /// All columns but the time.
    pub columns: Vec<Column>,
}

/// The text of a recording, for messages.
struct RecordingText<'a> {
    name: &'a str,
    text: &'a str,
    /// Bytes before the header that the reader does not see.
    skipped: usize,
}

impl RecordingText<'_> {
    /// An error at a byte range of the text.
    fn error(&self, sources: &mut SourceMap, at: (usize, usize), message: String, label: &str) -> Box<Diagnostic> {
        let source = sources.add(self.name, self.text);
        let span = Span { source, start: at.0 as u32, end: at.1 as u32 };
        Box::new(Diagnostic::error(message).at(Some(span), label))
    }

    /// Byte range of a cell. A record stores its cells without the separators, which count one byte each here.
    /// Quotes shift the range; a message can bear that.
    fn cell_range(&self, record: &csv::StringRecord, cell: usize) -> (usize, usize) {
        let start = self.skipped + record.position().map_or(0, |p| p.byte() as usize);
        let range = record.range(cell).unwrap_or_default();
        (start + range.start + cell, start + range.end + cell)
    }
}

/// The head of a table: the unit of its times, and its other columns, still empty.
struct Head {
    time: Unit,
    columns: Vec<Column>,
}

/// The columns for the cells of a header. The first must be the time.
fn columns(
    head: &csv::StringRecord,
    source: &RecordingText<'_>,
    sources: &mut SourceMap,
) -> Result<Head, Box<Diagnostic>> {
    let first = head.get(0).unwrap_or_default();
    let Some(time) = format::time_head(first) else {
        let message = format!("the first column of {} is \"{first}\"", source.name);
        let mut d = source.error(sources, source.cell_range(head, 0), message, "expected time[s]");
        if let Some(place) = head.iter().position(|c| format::time_head(c).is_some()) {
            d.help.push(format!("the time is column {}: save it as the first", place + 1));
        }
        return Err(d);
    };
    let mut columns: Vec<Column> = vec![];
    // Excel writes cells without a name where the sheet was wider once. Their rows must be empty as well.
    let named = head.iter().enumerate().filter(|(_, c)| !c.is_empty()).map(|(i, _)| i + 1).last().unwrap_or(0);
    for (i, cell) in head.iter().enumerate().take(named).skip(1) {
        let (name, unit) = format::name_and_unit(cell);
        if name.is_empty() || columns.iter().any(|c| c.name == name) {
            let message = format!("the column \"{cell}\" of {} has no name of its own", source.name);
            return Err(source.error(sources, source.cell_range(head, i), message, "expected another name[unit]"));
        }
        columns.push(Column { name, unit, values: vec![] });
    }
    Ok(Head { time, columns })
}

/// Take the units of the row below the header. One that contradicts the header is an error.
fn take_units(
    head: &mut Head,
    units: Vec<String>,
    row: &csv::StringRecord,
    source: &RecordingText<'_>,
    sources: &mut SourceMap,
) -> Result<(), Box<Diagnostic>> {
    for (i, unit) in units.into_iter().enumerate().filter(|(_, u)| !u.is_empty()) {
        if i == 0 {
            // `time[s]` above `s` is one unit; `time` above `ms` has its unit here.
            head.time = format::time_unit(&unit).unwrap_or(head.time);
            continue;
        }
        let Some(column) = head.columns.get_mut(i - 1) else { continue };
        if !column.unit.is_empty() && column.unit != unit {
            let message = format!("{} has the unit {} in the header and {unit} below", column.name, column.unit);
            return Err(source.error(sources, source.cell_range(row, i), message, "expected one unit"));
        }
        column.unit = unit;
    }
    Ok(())
}

/// The error of a row with another number of cells than the header.
fn wrong_width(
    row: &csv::StringRecord,
    width: usize,
    source: &RecordingText<'_>,
    sources: &mut SourceMap,
    separator: char,
) -> Box<Diagnostic> {
    let message = format!("a row of {} has {} cells, its header {width}", source.name, row.len());
    let end = source.cell_range(row, row.len().saturating_sub(1)).1;
    let start = source.cell_range(row, 0).0;
    let mut d = source.error(sources, (start, end), message, "expected as many cells as columns");
    let is_whole =
        |c: &str| c.trim_start_matches(['-', '+']).bytes().all(|b| b.is_ascii_digit() || b == b'e' || b == b'E');
    if separator == ',' && (width + 1..=2 * width).contains(&row.len()) && row.iter().all(is_whole) {
        let advice = "are the commas decimal signs too? Save decimals with a point, or cells with semicolons";
        d.help.push(advice.into());
    }
    d
}

impl Recording {
    /// Read the file of a recording: text in UTF-8, UTF-16 or Windows-1252. See [`Recording::parse`].
    ///
    /// # Errors
    /// The bytes are no text, or not that of a recording. The message of a text has the location.
    pub fn read(name: &str, bytes: &[u8], sources: &mut SourceMap) -> Result<Self, Box<Diagnostic>> {
        let text = format::decode(bytes)
            .map_err(|(what, advice)| Box::new(Diagnostic::error(format!("{name} {what}")).help(advice)))?;
        Self::parse(name, &text, sources)
    }

    /// Read a recording: a header row of `name[unit]`, the first being `time[s]`, and rows of numbers. Cells are
    /// separated by commas, semicolons or tabs; with the latter two the decimal sign may be a comma. Units may be in a
    /// row below the header. Empty cells are missing samples. Messages call the recording `name`.
    ///
    /// # Errors
    /// The text is no such table, or its times do not increase. The message has the location.
    pub fn parse(name: &str, text: &str, sources: &mut SourceMap) -> Result<Self, Box<Diagnostic>> {
        let (skipped, separator) = separator(text);
        let source = RecordingText { name, text, skipped };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(separator as u8)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(&text.as_bytes()[skipped..]);
        let unreadable = |e: csv::Error, sources: &mut SourceMap| {
            let at = skipped + e.position().map_or(0, |p| p.byte() as usize);
            source.error(sources, (at, at), format!("{name}: {e}"), "expected comma-separated values")
        };
        let mut rows = reader.records();
        let first = match rows.next() {
            Some(row) => row.map_err(|e| unreadable(e, sources))?,
            None => return Err(source.error(sources, (0, 0), format!("{name} is empty"), "expected a header row")),
        };
        let mut head = columns(&first, &source, sources)?;
        let mut times: Vec<f64> = vec![];
        let mut decimals = Decimals::new(separator);
        for (number, row) in rows.enumerate() {
            let row = row.map_err(|e| unreadable(e, sources))?;
            if row.len() != first.len() {
                return Err(wrong_width(&row, first.len(), &source, sources, separator));
            }
            if row.len() > 1 && row.iter().all(str::is_empty) {
                continue;
            }
            if number == 0
                && let Some(units) = format::units_row(row.iter())
            {
                take_units(&mut head, units, &row, &source, sources)?;
                continue;
            }
            read_row(&mut head, &mut times, &mut decimals, &row, &source, sources)?;
        }
        if times.len() < 2 {
            let message = format!("{name} has {} rows of numbers", times.len());
            return Err(source.error(sources, (0, text.len().min(1)), message, "expected two or more"));
        }
        Ok(Self { times, columns: head.columns })
    }

    /// The column of a name, with or without its unit.
    pub fn column(&self, name: &str) -> Option<&Column> {
        let (plain, unit) = format::name_and_unit(name);
        let find = |name: &str| self.columns.iter().find(|c| c.name == name);
        find(name).or_else(|| find(&plain).filter(|c| c.unit == unit))
    }
}

/// Append a row of numbers.
fn read_row(
    head: &mut Head,
    times: &mut Vec<f64>,
    decimals: &mut Decimals,
    row: &csv::StringRecord,
    source: &RecordingText<'_>,
    sources: &mut SourceMap,
) -> Result<(), Box<Diagnostic>> {
    for (i, cell) in row.iter().enumerate() {
        let value = match cell {
            "" | "nan" | "NaN" | "NAN" if i > 0 => f64::NAN,
            _ => match decimals.number(cell) {
                Ok(x) => x,
                Err(advice) => {
                    let column =
                        i.checked_sub(1).map(|c| head.columns.get(c).map_or("a column without a name", |c| &c.name));
                    let message = format!("{} is not a number: \"{cell}\"", column.unwrap_or("the time"));
                    let mut d = source.error(sources, source.cell_range(row, i), message, "expected a number");
                    d.help.extend((!advice.is_empty()).then(|| advice.to_owned()));
                    return Err(d);
                }
            },
        };
        if i > 0 {
            match head.columns.get_mut(i - 1) {
                Some(column) => column.values.push(value),
                None if value.is_nan() => {}
                None => {
                    let message = format!("column {} of {} has no name", i + 1, source.name);
                    return Err(source.error(sources, source.cell_range(row, i), message, "expected an empty cell"));
                }
            }
            continue;
        }
        let value = format::seconds(value, &head.time);
        if let Some(last) = times.last().filter(|l| **l >= value) {
            let message = format!("the time goes from {last} to {value}");
            return Err(source.error(sources, source.cell_range(row, 0), message, "expected a later time"));
        }
        times.push(value);
    }
    Ok(())
}
