//! LabVIEW measurement files (LVM).

use super::{Format, Input, value_after};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{number, shown};
use crate::series::{Clock, Series};
use crate::sheet::{Form, Separator, Sheet};
use crate::unit;

pub(super) const LABVIEW: Format = Format {
    name: "LabVIEW",
    recognised_by: "\"LabVIEW Measurement\" in the first line",
    states: "separator, decimal sign, times or step, units of the channels",
    description: "National Instruments, Specification for the LabVIEW measurement file (.lvm), version 2",
    is: |input| input.head.first().is_some_and(|l| l.starts_with("LabVIEW Measurement")),
    read,
};

const END: &str = "***End_of_Header***";

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let ends: Vec<usize> = input.lines().filter(|(_, l)| l.trim_start().starts_with(END)).map(|(n, _)| n).collect();
    let Some(&last) = ends.last().filter(|_| ends.len() == 2) else {
        let message = format!("there are {} ends of headers", ends.len());
        return Err(
            Fault::new(message).expected("expected one segment of data: a header of the file and one of the data")
        );
    };
    let separator = match value_after(&input.head, "Separator") {
        Some("Comma") => Separator::Char(','),
        _ => Separator::Char('\t'),
    };
    let decimal = value_after(&input.head, "Decimal_Separator").and_then(|w| w.chars().next());
    let form = Form { name: input.name, separator: Some(separator), decimal, short_rows: true, first_line: last + 1 };
    let mut sheet = Sheet::parse(input.text, &form)?;
    sheet.header = input.lines().take(last).map(|(_, l)| l.to_owned()).collect();
    // The comments at the ends of rows are no channel.
    if sheet.columns.last().is_some_and(|c| c.cell == "Comment") && sheet.columns.len() > 1 {
        sheet.columns.pop();
    }
    drop_equal_times(&mut sheet)?;
    let entries = |key: &str| {
        let line = input.head.iter().find(|l| l.split(separator.char()).next() == Some(key));
        line.map(|l| l.split(separator.char()).skip(1).map(str::trim).collect::<Vec<_>>()).unwrap_or_default()
    };
    let samples = entries("Samples").iter().filter_map(|w| w.parse::<usize>().ok()).max();
    if let Some(n) = samples.filter(|n| *n != sheet.rows()) {
        sheet.notes.push(format!("the header says {n} samples, but there are {}", sheet.rows()));
    }
    let units = entries("Y_Unit_Label");
    let is_x = |cell: &str| cell.starts_with("X_Value");
    for (channel, column) in sheet.columns.iter_mut().filter(|c| !is_x(&c.cell)).enumerate() {
        if let Some(unit) = units.get(channel).filter(|u| !u.is_empty()) {
            column.unit = (*unit).to_owned();
        }
    }
    if value_after(&input.head, "X_Columns") != Some("No") {
        return Ok(Content::Table(sheet));
    }
    without_times(input, sheet, &entries("X0"), &entries("Delta_X"))
}

/// Columns of times beside each channel (`Multi`) are one if they are equal.
fn drop_equal_times(sheet: &mut Sheet) -> Result<(), Fault> {
    let is_time = |c: &crate::sheet::Column| c.cell.starts_with("X_Value");
    let Some(first) = sheet.columns.iter().find(|c| is_time(c)).map(|c| c.values.clone()) else { return Ok(()) };
    let same = |c: &crate::sheet::Column| c.values.iter().zip(&first).all(|(a, b)| a.to_bits() == b.to_bits());
    if !sheet.columns.iter().filter(|c| is_time(c)).all(same) {
        return Err(Fault::new("the channels have times of their own").help("export one channel, or one X column"));
    }
    let mut seen = false;
    sheet.columns.retain(|c| !is_time(c) || !std::mem::replace(&mut seen, true));
    Ok(())
}

/// Channels whose times follow from their start and step.
fn without_times(input: &Input<'_>, sheet: Sheet, starts: &[&str], steps: &[&str]) -> Result<Content, Fault> {
    let mut series = vec![];
    for (i, column) in sheet.columns.into_iter().filter(|c| !c.cell.starts_with("X_Value")).enumerate() {
        let value = |of: &[&str]| of.get(i).or(of.first()).and_then(|w| number(&w.replacen(',', ".", 1)));
        let dt = value(steps).filter(|dt| *dt > 0.0);
        let dt = dt.ok_or_else(|| Fault::new(format!("the header gives no Delta_X of \"{}\"", shown(&column.cell))))?;
        let start = value(starts).unwrap_or(0.0);
        let mut s = Series { name: column.cell, unit_name: column.unit, ..Series::new(column.values) };
        s.clock = Clock::Steps { start, dt };
        s.unit = unit::header_unit(&s.unit_name);
        s.quantity = s.unit.map(|u| u.quantity);
        s.origin.lines = 1..input.lines().count() + 1;
        series.push(s);
    }
    Ok(Content::series(series, sheet.header, sheet.notes))
}
