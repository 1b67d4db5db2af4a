//! SMC files of the U.S. Geological Survey.

use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::number;
use crate::series::{Clock, Series};
use crate::unit;

pub(super) const SMC: Format = Format {
    name: "SMC",
    recognised_by: "a first line such as \"2 CORRECTED ACCELEROGRAM\" and \"*\" below it",
    states: "quantity and unit (cm/s2, cm/s, cm), step or times, number of values, azimuth",
    description: "USGS National Strong-Motion Program, SMC-format data files: 11 lines of text, 48 integers, 50 reals, comments, values in 8 columns of ten characters",
    is: |input| kind(input).is_some() && input.head.get(1).is_some_and(|l| l.trim_start().starts_with('*')),
    read,
};

const TEXT_LINES: usize = 11;
const INTEGER_LINES: usize = 6;
const REAL_LINES: usize = 10;
const INTEGER_WIDTH: usize = 10;
const REAL_WIDTH: usize = 15;
const VALUE_WIDTH: usize = 10;

/// Unit of the values by the first line.
fn kind(input: &Input<'_>) -> Option<&'static str> {
    let first = input.head.first()?.trim().to_ascii_uppercase();
    let (digit, rest) = first.split_at_checked(1)?;
    digit.parse::<u8>().ok()?;
    [("ACCELEROGRAM", "cm/s2"), ("VELOCITY", "cm/s"), ("DISPLACEMENT", "cm")]
        .iter()
        .find(|(word, _)| rest.contains(word))
        .map(|(_, unit)| *unit)
}

/// Numbers of fixed width in lines; an entry that is none is an error.
fn fixed(lines: &[&str], first: usize, width: usize) -> Result<Vec<f64>, Fault> {
    let mut out = vec![];
    for (i, line) in lines.iter().enumerate() {
        for cell in line.trim_end().as_bytes().chunks(width) {
            let cell = String::from_utf8_lossy(cell);
            let value = number(cell.trim());
            out.push(value.ok_or_else(|| Fault::in_line(first + i, format!("\"{}\" is not a number", cell.trim())))?);
        }
    }
    Ok(out)
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let lines: Vec<&str> = input.text.lines().collect();
    let reals_at = TEXT_LINES + INTEGER_LINES;
    let comments_at = reals_at + REAL_LINES;
    if lines.len() < comments_at {
        return Err(Fault::new(format!("the file ends in its header of {comments_at} lines")));
    }
    let whole = fixed(&lines[TEXT_LINES..reals_at], TEXT_LINES + 1, INTEGER_WIDTH)?;
    let real = fixed(&lines[reals_at..comments_at], reals_at + 1, REAL_WIDTH)?;
    // The first entry of either header is the value that stands for "not known".
    let known = |of: &[f64], i: usize| of.get(i).copied().filter(|x| Some(x) != of.first());
    let count = known(&whole, 16)
        .filter(|n| *n > 0.0)
        .ok_or_else(|| Fault::in_line(14, "the header gives no number of values"))?;
    let comments = known(&whole, 15).unwrap_or(0.0).max(0.0) as usize;
    let first = comments_at.saturating_add(comments);
    let values = fixed(lines.get(first..).unwrap_or_default(), first + 1, VALUE_WIDTH)?;
    let rate = known(&real, 1).filter(|r| *r > 0.0);
    // Without a rate there are pairs of time and value. Some files count the pairs, others the numbers.
    let there = values.len() as f64;
    let needed = if rate.is_none() && there >= 2.0 * count { 2.0 * count } else { count };
    if rate.is_none() && needed % 2.0 != 0.0 {
        return Err(Fault::new(format!("the header says {count} numbers, which are no pairs of time and value")));
    }
    if (values.len() as f64) < needed {
        return Err(Fault::new(format!("the header says {count} values, but there are {}", values.len())));
    }
    let mut notes = vec![];
    if rate.is_none() && needed == count {
        notes.push(format!("the {count} values of the header are taken for times and values together"));
    }
    if values.len() as f64 > needed {
        notes
            .push(format!("the header says {needed} numbers, but there are {}: the others are left out", values.len()));
    }
    let values = &values[..needed as usize];
    let (values, clock) = match rate {
        Some(rate) => (values.to_vec(), Clock::Steps { start: 0.0, dt: 1.0 / rate }),
        None => {
            let times: Vec<f64> = values.iter().step_by(2).copied().collect();
            let samples: Vec<f64> = values.iter().skip(1).step_by(2).copied().collect();
            if let Some(i) = times.windows(2).position(|w| w[0] >= w[1]) {
                return Err(Fault::new(format!("the time of sample {} does not increase", i + 2)));
            }
            (samples, Clock::Times(times.into()))
        }
    };
    let text = |i: usize| lines.get(i).map_or("", |l| l.trim());
    let mut series = Series {
        title: format!("{}; {}", text(3), text(5)),
        event: text(3).to_owned(),
        station: text(2).to_owned(),
        azimuth: known(&whole, 13).filter(|a| (0.0..=360.0).contains(a)),
        clock,
        ..Series::new(values)
    };
    if let Some(unit) = kind(input).and_then(unit::unit) {
        series = series.with_unit(unit);
    }
    series.origin.lines = first + 1..lines.len() + 1;
    let header = lines[..first.min(lines.len())].iter().map(|l| (*l).to_owned()).collect();
    Ok(Content::series(vec![series], header, notes))
}
