//! COSMOS strong motion files, V0 to V2: format of the COSMOS consortium, version 1.20.
//!
//! A channel has a text header, integer and real headers with a line that gives their numbers, comments, and the data.
//! Header lines and the line before the data describe themselves; the meaning of the entries is that of the published format.

use super::{Format, Input, has, note_surplus};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::number;
use crate::series::Series;
use crate::unit::{self, Quantity};

pub(super) const COSMOS: Format = Format {
    name: "COSMOS",
    recognised_by: "\"Real-header values follow\" in a line",
    states: "quantity, unit, step, number of values, azimuth, event and station of each channel",
    description: "COSMOS Strong Motion Data Format, version 1.20",
    is: |input| input.text.contains("Real-header values follow"),
    read,
};

/// Entry of the integer header with the direction in degrees (counted from 1).
const AZIMUTH_ENTRY: usize = 54;
/// Entry of the real header with the step of the processed data in ms.
const STEP_MS_ENTRY: usize = 62;
/// Entry of the real header with the step of the recorder in s.
const STEP_ENTRY: usize = 34;

/// The first whole number of a line.
fn count(line: &str) -> Option<usize> {
    line.split_whitespace().next()?.parse().ok()
}

/// Width of a number in a line `Format=(8F10.5)`; zero if it is not given.
fn width(line: &str) -> usize {
    let Some((_, format)) = line.rsplit_once('(') else { return 0 };
    let after = format.find(|c: char| c.is_ascii_alphabetic()).map_or("", |i| &format[i + 1..]);
    after.split(|c: char| !c.is_ascii_digit()).next().and_then(|w| w.parse().ok()).unwrap_or(0)
}

/// `n` numbers of fixed width from the lines after `at`; the line after them, and cells that are left in their last line.
fn numbers(lines: &[&str], at: usize, n: usize, width: usize) -> Result<(Vec<f64>, usize, usize), Fault> {
    let mut out = vec![];
    let mut left = 0;
    let mut line = at;
    while out.len() < n {
        let ends = || Fault::new(format!("the file ends after {} of {n} numbers", out.len()));
        let text = lines.get(line).ok_or_else(ends)?;
        let cells: Vec<String> = if width > 0 && text.is_ascii() {
            text.trim_end().as_bytes().chunks(width).map(|c| String::from_utf8_lossy(c).trim().to_owned()).collect()
        } else {
            text.split_whitespace().map(str::to_owned).collect()
        };
        if cells.is_empty() {
            return Err(Fault::in_line(line + 1, format!("the line is empty after {} of {n} numbers", out.len())));
        }
        left = cells.len().saturating_sub(n - out.len());
        for cell in cells.iter().take(n - out.len()) {
            let value = number(cell);
            out.push(value.ok_or_else(|| Fault::in_line(line + 1, format!("\"{cell}\" is not a number")))?);
        }
        line += 1;
    }
    Ok((out, line, left))
}

/// The quantity of the line before the data.
fn quantity(line: &str) -> Option<Quantity> {
    let words = [("accel", Quantity::Acceleration), ("veloc", Quantity::Velocity), ("displ", Quantity::Length)];
    words.iter().find(|(w, _)| has(line, &[w])).map(|(_, q)| *q)
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let lines: Vec<&str> = input.text.lines().collect();
    let mut series: Vec<Series> = vec![];
    let (mut event, mut station, mut whole, mut real) = (String::new(), String::new(), vec![], vec![]);
    let (mut at, mut accelerations) = (0, 0);
    let mut notes = vec![];
    while at < lines.len() {
        let line = lines[at];
        if line.contains("(Format v") {
            station = lines.get(at + 4).map_or("", |l| l.trim()).to_owned();
            event = lines.get(at + 1).map_or("", |l| l.trim()).to_owned();
        }
        let values = |n: usize| numbers(&lines, at + 1, n, width(line));
        if line.contains("Integer-header values follow") {
            (whole, at, _) = values(count(line).unwrap_or(0))?;
        } else if line.contains("Real-header values follow") {
            (real, at, _) = values(count(line).unwrap_or(0))?;
        } else if line.contains(" pts, approx") {
            let n = count(line).ok_or_else(|| Fault::in_line(at + 1, "expected the number of values"))?;
            let (data, next, left) = values(n)?;
            note_surplus(&lines, next, left, &mut notes);
            let unit_name = line.split("units=").nth(1).and_then(|w| w.split(['(', ',']).next()).unwrap_or("").trim();
            let known = |entry: usize| real.get(entry - 1).copied().filter(|x: &f64| *x > 0.0);
            let dt = known(STEP_MS_ENTRY).map(|ms| ms / 1000.0).or_else(|| known(STEP_ENTRY));
            let dt = dt.ok_or_else(|| Fault::in_line(at + 1, "the real header gives no step of time"))?;
            let quantity = quantity(line);
            accelerations += usize::from(quantity == Some(Quantity::Acceleration));
            let channel = if quantity == Some(Quantity::Acceleration) { accelerations } else { series.len() + 1 };
            let mut s = Series {
                name: format!("channel {channel}"),
                title: format!("{event}; {station}"),
                azimuth: whole.get(AZIMUTH_ENTRY - 1).copied().filter(|x: &f64| (0.0..=360.0).contains(x)),
                quantity,
                unit: unit::header_unit(unit_name).filter(|u| quantity.is_none_or(|q| q == u.quantity)),
                unit_name: unit_name.to_owned(),
                event: event.clone(),
                station: station.clone(),
                ..Series::new(data)
            }
            .with_step(dt);
            s.origin.lines = at + 2..next + 1;
            series.push(s);
            at = next;
        } else {
            at += 1;
        }
    }
    if series.is_empty() {
        return Err(Fault::new("there is no channel with values"));
    }
    Ok(Content::series(series, input.head.iter().map(|l| (*l).to_owned()).collect(), notes))
}
