//! GeoNet's V1A and V2A: accelerograms of New Zealand.

use super::{Format, Input, azimuth, has};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::number;
use crate::series::Series;
use crate::unit;

pub(super) const GEONET: Format = Format {
    name: "GeoNet",
    recognised_by: "\"accelerogram\" and \"GNS Science\" in the first line",
    states: "quantities and units (mm/s2, mm/s, mm), step, numbers of values, azimuths",
    description: "GNS Science, Accelerogram data file format (2012): 16 lines of text, 40 integers, 60 reals, values in 10 columns of eight characters",
    is: |input| input.head.first().is_some_and(|l| has(l, &["accelerogram", "gns"])),
    read,
};

const TEXT_LINES: usize = 16;
const NUMBER_LINES: usize = 10;
const WIDTH: usize = 8;

/// `n` numbers after line `at`, and the line after them.
fn numbers(lines: &[&str], at: usize, n: usize) -> Result<(Vec<f64>, usize, usize), Fault> {
    let mut out = vec![];
    let mut left = 0;
    let mut line = at;
    while out.len() < n {
        let text =
            lines.get(line).ok_or_else(|| Fault::new(format!("the file ends after {} of {n} values", out.len())))?;
        let before = out.len();
        left = text.trim_end().len().div_ceil(WIDTH).saturating_sub(n - before);
        for cell in text.trim_end().as_bytes().chunks(WIDTH).take(n - out.len()) {
            let cell = String::from_utf8_lossy(cell);
            let value = number(cell.trim());
            out.push(value.ok_or_else(|| Fault::in_line(line + 1, format!("\"{}\" is not a number", cell.trim())))?);
        }
        if out.len() == before {
            return Err(Fault::in_line(line + 1, format!("the line is empty after {} of {n} values", out.len())));
        }
        line += 1;
    }
    Ok((out, line, left))
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let lines: Vec<&str> = input.text.lines().collect();
    let mut series = vec![];
    let mut at = 0;
    let mut channel = 0;
    while lines.get(at).is_some_and(|l| !l.trim().is_empty()) {
        let data = at + TEXT_LINES + NUMBER_LINES;
        if lines.len() < data {
            return Err(Fault::in_line(at + 1, "the file ends in a header"));
        }
        let uncorrected = has(lines[at], &["uncorrected"]);
        channel += 1;
        let mut entries: Vec<Vec<f64>> = vec![];
        for (i, line) in lines[at + TEXT_LINES..data].iter().enumerate() {
            let row = line.split_whitespace().map(number).collect::<Option<Vec<f64>>>().filter(|r| r.len() == 10);
            let wrong = || Fault::in_line(at + TEXT_LINES + i + 1, "expected ten numbers of the header");
            entries.push(row.ok_or_else(wrong)?);
        }
        let dt = if uncorrected { 1.0 / entries[4][0] } else { entries[6][5] };
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(Fault::in_line(at + TEXT_LINES + 1, "the header gives no step of time"));
        }
        let component = lines[at + 12].split_whitespace().nth(1).unwrap_or_default();
        let blocks: &[(usize, &str)] =
            if uncorrected { &[(0, "mm/s2")] } else { &[(3, "mm/s2"), (4, "mm/s"), (5, "mm")] };
        let mut next = data;
        for (entry, unit) in blocks {
            let count = entries[3][*entry];
            if !(count >= 0.0 && count.fract() == 0.0) {
                return Err(Fault::in_line(at + TEXT_LINES + 4, "the header gives no number of values"));
            }
            let from = next;
            let (values, after, left) = numbers(&lines, from, count as usize)?;
            if left > 0 {
                return Err(Fault::in_line(after, format!("there are {left} more values than the header says")));
            }
            next = after;
            let Some(unit) = unit::unit(unit).filter(|_| !values.is_empty()) else { continue };
            let mut s = Series {
                name: format!("channel {channel}"),
                title: lines[at].trim().to_owned(),
                station: lines[at + 2].trim().to_owned(),
                event: lines[at + 8].trim().to_owned(),
                direction: component.to_owned(),
                azimuth: azimuth(component),
                ..Series::new(values)
            }
            .with_unit(unit)
            .with_step(dt);
            s.origin.lines = from + 1..next + 1;
            series.push(s);
        }
        at = next;
    }
    if let Some(i) = (at..lines.len()).find(|i| !lines[*i].trim().is_empty()) {
        return Err(Fault::in_line(i + 1, "expected the header of a component"));
    }
    Ok(Content::series(series, input.head.iter().take(TEXT_LINES).map(|l| (*l).to_owned()).collect(), vec![]))
}
