//! Files of the strong-motion network of Turkey (AFAD, TR-NSMN): three components side by side.

use super::{Format, Input, azimuth, has};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{number, shown};
use crate::series::Series;
use crate::unit::{self, Unit};

pub(super) const AFAD: Format = Format {
    name: "AFAD",
    recognised_by: "lines \"SAMPLING INTERVAL\" and \"NUMBER OF DATA\" in the header, and the names of three components",
    states: "accelerations in the unit of the peak values (gal), step, number of values, directions, station",
    description: "AFAD, Turkish National Strong Motion Network, text format: lines KEY : value, then columns N-S, E-W, U-D",
    is: |input| input.has(&["sampling interval", ":"]) && input.has(&["number of data", ":"]) && names(input).is_some(),
    read,
};

/// Index of the line with the names of the components, and these.
fn names<'a>(input: &Input<'a>) -> Option<(usize, Vec<&'a str>)> {
    let is =
        |w: &&str| azimuth(w).is_some() || matches!(w.to_ascii_uppercase().as_str(), "U-D" | "UD" | "UP" | "Z" | "V");
    input.head.iter().enumerate().find_map(|(i, line)| {
        let words: Vec<&str> = line.split_whitespace().collect();
        (words.len() > 1 && words.iter().all(|w| is(w) && number(w).is_none())).then_some((i, words))
    })
}

/// The value and the place of the line with a key, and the unit in round brackets before its colon.
fn entry<'a>(input: &Input<'a>, key: &str) -> Option<(usize, &'a str, Option<Unit>)> {
    input.head.iter().enumerate().find_map(|(i, line)| {
        let (name, value) = line.split_once(':').filter(|(name, _)| has(name, &[key]))?;
        let unit = name.split_once('(').and_then(|(_, u)| unit::header_unit(u.split(')').next()?));
        Some((i + 1, value.trim(), unit))
    })
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let (names_at, names) = names(input).ok_or_else(|| Fault::new("there are no names of components"))?;
    let missing = |key: &str| Fault::new(format!("the header has no \"{key}\""));
    let (line, step, step_unit) = entry(input, "sampling interval").ok_or_else(|| missing("SAMPLING INTERVAL"))?;
    let factor = step_unit.map_or(1.0, |u| u.factor);
    let dt = number(step).map(|x| x * factor).filter(|x| *x > 0.0);
    let dt = dt.ok_or_else(|| Fault::in_line(line, format!("the sampling interval is \"{}\"", shown(step))))?;
    let (line, count, _) = entry(input, "number of data").ok_or_else(|| missing("NUMBER OF DATA"))?;
    let count: usize =
        count.parse().map_err(|_| Fault::in_line(line, format!("the number of data is \"{}\"", shown(count))))?;
    let unit = entry(input, "pga").and_then(|(.., unit)| unit);
    let mut columns: Vec<Vec<f64>> = vec![vec![]; names.len()];
    let mut last = names_at;
    for (n, line) in input.lines().skip(names_at + 1).filter(|(_, l)| !l.trim().is_empty()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if words.len() != names.len() {
            return Err(Fault::in_line(n, format!("there are {} numbers for {} components", words.len(), names.len())));
        }
        for (column, word) in columns.iter_mut().zip(words) {
            column.push(number(word).ok_or_else(|| Fault::in_line(n, format!("\"{word}\" is not a number")))?);
        }
        last = n;
    }
    let there = columns[0].len();
    if there != count {
        return Err(Fault::new(format!("the header says {count} values, but there are {there}")));
    }
    let text = |key: &str| entry(input, key).map_or("", |(_, v, _)| v).to_owned();
    let series = names.iter().zip(columns).map(|(name, values)| {
        let mut s = Series {
            name: (*name).to_owned(),
            title: format!("{} {}", text("earthquake date"), text("station id")).trim().to_owned(),
            station: text("station id"),
            event: text("earthquake date"),
            direction: (*name).to_owned(),
            azimuth: azimuth(name),
            ..Series::new(values)
        };
        if let Some(unit) = unit {
            s = s.with_unit(unit);
        }
        s.origin.lines = names_at + 2..last + 1;
        s.with_step(dt)
    });
    Ok(Content::series(series.collect(), input.head[..=names_at].iter().map(|l| (*l).to_owned()).collect(), vec![]))
}
