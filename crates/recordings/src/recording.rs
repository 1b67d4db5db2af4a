//! Recordings of a study: measured channels over time, with faults that point into the file.

use crate::content::Content;
use crate::fault::Fault;
use crate::format::Beside;
use crate::interpret::{stated_clock, time_unit_of};
use crate::measured::Measured;
use crate::series::{Clock, Series};
use crate::sheet::{Column as SheetColumn, Form, Sheet, SheetError, head};
use crate::unit::{self, Quantity};
use crate::user_statements::{Statement, UserStatements};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};

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

impl Recording {
    /// Read the file of a recording, of any format. See [`Recording::parse`] for tables as text.
    ///
    /// # Errors
    /// The bytes are none of a recording. The message about a text has the location.
    pub fn read(name: &str, bytes: &[u8], sources: &mut SourceMap) -> Result<Self, Box<Diagnostic>> {
        Self::read_told(name, bytes, &UserStatements::default(), &|_| None, sources)
    }

    /// As [`Recording::read`], of a file about which the user says something: the step where the file has no times, the
    /// unit of channels without one, the quantity and the layout of numbers without names. `beside` gives the bytes of
    /// another file of its folder.
    ///
    /// # Errors
    /// As there; and what is said contradicts the file, or has no meaning.
    pub fn read_told(
        name: &str,
        bytes: &[u8],
        told: &UserStatements,
        beside: Beside<'_>,
        sources: &mut SourceMap,
    ) -> Result<Self, Box<Diagnostic>> {
        let named = |fault: Fault| match (fault.line, fault.range) {
            (None, None) if !fault.message.contains(name) => {
                Fault { message: format!("{name} {}", fault.message), ..fault }
            }
            _ => fault,
        };
        let measured = Measured::read_with_text(name, bytes, beside)
            .map_err(|e| named(whole_name(e.0, name)).diagnostic(name, &e.1, sources))?;
        let first_is_time =
            |sheet: &Sheet| sheet.columns.first().is_some_and(|c| time_unit_of(c).is_some() || c.is_clock);
        let read = match &measured.content {
            Content::Table(sheet) if told.dt.is_none() || first_is_time(sheet) => {
                of_sheet(name, sheet.clone(), &measured.text).and_then(|r| r.with_step(told, sheet))
            }
            _ => measured.series(told).and_then(|series| of_series(&measured, name, series, told)),
        };
        let read = read.and_then(|r| r.with_unit(told));
        read.map_err(|fault| whole_name(fault, name).diagnostic(name, &measured.text, sources))
    }

    /// Read a recording from text: a header row of `name[unit]`, the first being `time[s]`, and rows of numbers. Cells are
    /// separated by commas, semicolons or tabs; with the latter two the decimal sign may be a comma. Units may be in a
    /// row below the header. Empty cells are missing samples. Messages call the recording `name`.
    ///
    /// # Errors
    /// The text is no such table, or its times do not increase. The message has the location.
    pub fn parse(name: &str, text: &str, sources: &mut SourceMap) -> Result<Self, Box<Diagnostic>> {
        let sheet = match Sheet::parse(text, &Form { name, ..Form::default() }) {
            Ok(sheet) => Ok(sheet),
            Err(SheetError::Fault(fault)) => Err(fault),
            // Names are needed: without them the first line is the fault.
            Err(SheetError::List(fault)) => Err(headless(name, text).unwrap_or(fault)),
        };
        sheet.and_then(|sheet| of_sheet(name, sheet, text)).map_err(|fault| fault.diagnostic(name, text, sources))
    }

    /// With the step that the user says, if the times agree.
    fn with_step(mut self, told: &UserStatements, sheet: &Sheet) -> Result<Self, Fault> {
        if told.dt.is_some() {
            let clock = stated_clock(Clock::Times(self.times.as_slice().into()), told, &|i| sheet.row_name(i))?;
            self.times = (0..self.times.len()).filter_map(|i| clock.time(i)).collect();
        }
        Ok(self)
    }

    /// With the unit that the user says for the channels that have none.
    fn with_unit(mut self, told: &UserStatements) -> Result<Self, Fault> {
        let said = Statement::of(told)?;
        said.complete_each(
            &mut self.columns,
            |c| {
                let own = unit::unit(&c.unit);
                (&c.name, own.map(|u| u.quantity).or_else(|| Quantity::of_head(&c.name)), own)
            },
            |c| {
                if let Some(unit) = said.unit.filter(|_| c.unit.is_empty()) {
                    unit.name.clone_into(&mut c.unit);
                }
            },
        )?;
        Ok(self)
    }

    /// The column of a name, with or without its unit.
    pub fn column(&self, name: &str) -> Option<&Column> {
        let (plain, unit) = head::name_and_unit(name);
        let find = |name: &str| self.columns.iter().find(|c| c.name == name);
        find(name).or_else(|| find(&plain).filter(|c| c.unit == unit))
    }
}

/// The name that the study gives the file stands in messages for its short one.
fn whole_name(fault: Fault, name: &str) -> Fault {
    let short = name.rsplit(['/', '\\']).next().unwrap_or(name);
    if short == name || fault.message.contains(name) {
        return fault;
    }
    Fault { message: fault.message.replace(&format!(" {short} "), &format!(" {name} ")), ..fault }
}

fn of_series(m: &Measured, name: &str, series: Vec<Series>, told: &UserStatements) -> Result<Recording, Fault> {
    let Some(first) = series.first().cloned() else { return Err(Fault::new(format!("{name} has no channel"))) };
    let times: Option<Vec<f64>> = (0..first.values.len()).map(|i| first.clock.time(i)).collect();
    let times = times.ok_or_else(|| m.no_step(told.way))?;
    if let Some(other) = series.iter().find(|s| s.clock != first.clock || s.values.len() != times.len()) {
        let message = format!("the channels \"{}\" and \"{}\" of {name} have other times", first.name, other.name);
        return Err(Fault::new(message));
    }
    let mut columns: Vec<Column> = vec![];
    for s in series {
        let word = s.quantity.map_or("value", |q| q.word());
        // Columns without names have their numbers.
        let of_column = s.origin.column.map_or(word.to_owned(), |n| n.to_string());
        let name = if s.name.is_empty() { of_column } else { s.name };
        let taken = |n: &str| columns.iter().any(|c| c.name == n);
        let name = if taken(&name) { format!("{name} {word}") } else { name };
        let unit = s.unit.map_or(s.unit_name, |u| u.name.to_owned());
        columns.push(Column { name, unit, values: s.values });
    }
    Ok(Recording { times, columns })
}

/// The fault of a text whose first line is no header.
fn headless(name: &str, text: &str) -> Option<Fault> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let shown = line.trim();
        if !shown.is_empty() && !shown.starts_with(['#', '%']) {
            let first = shown.split([',', ';', '\t']).next().unwrap_or(shown).trim();
            let fault = Fault::new(format!("the first column of {name} is \"{first}\"")).expected("expected time[s]");
            let at = start + line.find(first).unwrap_or(0);
            return (head::time_head(first).is_none()).then(|| fault.at((at, at + first.len())));
        }
        start += line.len();
    }
    None
}

/// The names of the columns, each of which has one of its own; the first is the time.
fn check_heads(name: &str, sheet: &Sheet, text: &str) -> Result<(), Fault> {
    let at = |fault: Fault, column: usize| match sheet.cell_range(text, sheet.names_line, column) {
        Some(range) if sheet.names_line > 0 => fault.at(range),
        _ => fault,
    };
    let is_time = |c: &SheetColumn| time_unit_of(c).is_some() || c.is_clock;
    let first = &sheet.columns[0];
    if !is_time(first) {
        let fault =
            Fault::new(format!("the first column of {name} is \"{}\"", first.cell)).expected("expected time[s]");
        let place = sheet.columns.iter().position(is_time);
        let help = place.map_or(String::new(), |i| format!("the time is column {}: save it as the first", i + 1));
        return Err(at(fault, 0).help(help));
    }
    for (i, column) in sheet.columns.iter().enumerate().skip(1) {
        let plain = head::name_and_unit(&column.cell).0;
        let same = |c: &SheetColumn| head::name_and_unit(&c.cell).0 == plain;
        if plain.is_empty() || sheet.columns[1..i].iter().any(same) {
            let message = format!("the column \"{}\" of {name} has no name of its own", column.cell);
            return Err(at(Fault::new(message).expected("expected another name[unit]"), i));
        }
    }
    Ok(())
}

fn of_sheet(name: &str, sheet: Sheet, text: &str) -> Result<Recording, Fault> {
    if sheet.columns.is_empty() {
        return Err(Fault::new(format!("{name} is empty")).expected("expected a header row").at((0, 0)));
    }
    if !sheet.named {
        return Err(headless(name, text)
            .unwrap_or_else(|| Fault::new(format!("{name} has no header row")).expected("expected time[s]")));
    }
    check_heads(name, &sheet, text)?;
    let cell = |fault: Fault, row: usize, column: usize| {
        let range = sheet.lines.get(row).and_then(|line| sheet.cell_range(text, *line, column));
        range.map_or(fault.clone(), |r| fault.at(r))
    };
    let unit = time_unit_of(&sheet.columns[0]);
    let mut times: Vec<f64> = Vec::with_capacity(sheet.rows());
    for (row, x) in sheet.columns[0].values.iter().enumerate() {
        if !x.is_finite() {
            return Err(cell(Fault::new("the time is not a number: \"\"").expected("expected a number"), row, 0));
        }
        let time = unit.as_ref().map_or(*x, |u| head::seconds(*x, u));
        if let Some(last) = times.last().filter(|l| **l >= time) {
            let message = format!("the time goes from {last} to {time}");
            return Err(cell(Fault::new(message).expected("expected a later time"), row, 0));
        }
        times.push(time);
    }
    if times.is_empty() {
        let message = format!("{name} has no rows of numbers");
        return Err(Fault::new(message).expected("expected one or more").at((0, text.len().min(1))));
    }
    let infinite = |c: &SheetColumn| c.values.iter().position(|x| x.is_infinite());
    if let Some((i, row)) = sheet.columns.iter().enumerate().find_map(|(i, c)| Some((i, infinite(c)?))) {
        let plain = head::name_and_unit(&sheet.columns[i].cell).0;
        let message = format!("{plain} is not a number: \"{}\"", sheet.columns[i].values[row]);
        return Err(cell(Fault::new(message).expected("expected a number"), row, i));
    }
    let columns = sheet.columns.into_iter().skip(1).map(|c| {
        let (name, unit) = head::name_and_unit(&c.cell);
        Column { name, unit: if c.unit.is_empty() { unit } else { c.unit }, values: c.values }
    });
    Ok(Recording { times, columns: columns.collect() })
}
