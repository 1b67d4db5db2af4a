//! Recordings: measured channels over time, as comma-separated values.

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
}

impl RecordingText<'_> {
    /// An error at a byte range of the text.
    fn error(&self, sources: &mut SourceMap, at: (usize, usize), message: String, label: &str) -> Box<Diagnostic> {
        let source = sources.add(self.name, self.text);
        let span = Span { source, start: at.0 as u32, end: at.1 as u32 };
        Box::new(Diagnostic::error(message).at(Some(span), label))
    }
}

/// Byte range of a cell. A record stores its cells without the separators, which count one byte each here.
/// Quotes shift the range; a message can bear that.
fn cell_range(record: &csv::StringRecord, cell: usize) -> (usize, usize) {
    let start = record.position().map_or(0, |p| p.byte() as usize);
    let range = record.range(cell).unwrap_or_default();
    (start + range.start + cell, start + range.end + cell)
}

/// Name and unit of `name[unit]`.
fn header(cell: &str) -> (String, String) {
    match cell.trim().strip_suffix(']').and_then(|c| c.split_once('[')) {
        Some((name, unit)) => (name.trim().to_owned(), unit.trim().to_owned()),
        None => (cell.trim().to_owned(), String::new()),
    }
}

/// Empty columns for the cells of a header but the first, which must be the time.
fn columns(
    head: &csv::StringRecord,
    source: &RecordingText<'_>,
    sources: &mut SourceMap,
) -> Result<Vec<Column>, Box<Diagnostic>> {
    let mut columns: Vec<Column> = vec![];
    for (i, cell) in head.iter().enumerate() {
        let (name, unit) = header(cell);
        if i == 0 {
            if name != "time" || !["s", "sec", ""].contains(&unit.as_str()) {
                let message = format!("the first column of {} is \"{cell}\"", source.name);
                return Err(source.error(sources, cell_range(head, 0), message, "expected time[s]"));
            }
            continue;
        }
        if name.is_empty() || columns.iter().any(|c| c.name == name) {
            let message = format!("the column \"{cell}\" of {} has no name of its own", source.name);
            return Err(source.error(sources, cell_range(head, i), message, "expected another name[unit]"));
        }
        columns.push(Column { name, unit, values: vec![] });
    }
    Ok(columns)
}

impl Recording {
    /// Read a recording: a header row of `name[unit]`, the first being `time[s]`, and rows of numbers. Empty cells are
    /// missing samples. Messages call the recording `name`.
    ///
    /// # Errors
    /// The text is no such table, or its times do not increase. The message has the location.
    pub fn parse(name: &str, text: &str, sources: &mut SourceMap) -> Result<Self, Box<Diagnostic>> {
        let source = RecordingText { name, text };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let mut rows = reader.records();
        let unreadable = |e: csv::Error, sources: &mut SourceMap| {
            let at = e.position().map_or(0, |p| p.byte() as usize);
            source.error(sources, (at, at), format!("{name}: {e}"), "expected comma-separated values")
        };
        let head = match rows.next() {
            Some(row) => row.map_err(|e| unreadable(e, sources))?,
            None => return Err(source.error(sources, (0, 0), format!("{name} is empty"), "expected a header row")),
        };
        let mut recording = Self { times: vec![], columns: columns(&head, &source, sources)? };
        for row in rows {
            let row = row.map_err(|e| unreadable(e, sources))?;
            if row.len() != head.len() {
                let message = format!("a row of {name} has {} cells, its header {}", row.len(), head.len());
                let end = cell_range(&row, row.len().saturating_sub(1)).1;
                let start = cell_range(&row, 0).0;
                return Err(source.error(sources, (start, end), message, "expected as many cells as columns"));
            }
            for (i, cell) in row.iter().enumerate() {
                let value = match cell {
                    "" | "nan" | "NaN" | "NAN" if i > 0 => f64::NAN,
                    _ => match cell.parse::<f64>() {
                        Ok(x) if x.is_finite() => x,
                        _ => {
                            let what = if i == 0 { "the time" } else { &recording.columns[i - 1].name };
                            let message = format!("{what} is not a number: \"{cell}\"");
                            return Err(source.error(sources, cell_range(&row, i), message, "expected a number"));
                        }
                    },
                };
                if i > 0 {
                    recording.columns[i - 1].values.push(value);
                    continue;
                }
                if let Some(last) = recording.times.last().filter(|l| **l >= value) {
                    let message = format!("the time goes from {last} to {value}");
                    return Err(source.error(sources, cell_range(&row, 0), message, "expected a later time"));
                }
                recording.times.push(value);
            }
        }
        if recording.times.len() < 2 {
            let message = format!("{name} has {} rows of numbers", recording.times.len());
            return Err(source.error(sources, (0, text.len().min(1)), message, "expected two or more"));
        }
        Ok(recording)
    }

    /// The column of a name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|c| c.name == name)
    }
}
