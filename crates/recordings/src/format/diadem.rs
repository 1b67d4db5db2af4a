//! DIAdem's header (`.DAT`), whose values are in files beside it.

use super::array::Element;
use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{number, shown};
use crate::series::{Clock, Series};
use crate::sheet::{Form, Separator, Sheet};
use crate::unit::{self, Quantity};
use std::collections::BTreeMap;

pub(super) const DIADEM: Format = Format {
    name: "DIAdem",
    recognised_by: "a line \"#BEGINCHANNELHEADER\"",
    states: "names, units, numbers of values, step or times of the channels; the values are in the files that it names",
    description: "National Instruments, DIAdem: Structure of the DAT header file: keys 200 to 241; data as CHANNEL or BLOCK of REAL32, REAL64, INT16, INT32, or columns of ASCII",
    is: |input| input.head.iter().any(|l| l.trim() == BEGIN),
    read,
};

const BEGIN: &str = "#BEGINCHANNELHEADER";
const END: &str = "#ENDCHANNELHEADER";

/// Keys of a channel's header.
type Header<'a> = BTreeMap<u16, (usize, &'a str)>;

/// The value of a key that is there and is not empty.
fn text<'a>(header: &Header<'a>, key: u16) -> Option<&'a str> {
    header.get(&key).map(|(_, v)| v.trim()).filter(|v| !v.is_empty())
}

fn value(header: &Header<'_>, key: u16, otherwise: f64) -> Result<f64, Fault> {
    let Some((line, text)) = header.get(&key).filter(|(_, v)| !v.trim().is_empty()) else { return Ok(otherwise) };
    number(&text.trim().replace(',', "."))
        .ok_or_else(|| Fault::in_line(*line, format!("key {key} is \"{}\"", shown(text))).expected("expected a number"))
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let (mut headers, mut open): (Vec<Header<'_>>, Option<Header<'_>>) = (vec![], None);
    let mut lines = vec![];
    for (n, line) in input.lines() {
        let line = line.trim();
        if line == BEGIN {
            headers.extend(open.replace(Header::new()));
        } else if line == END {
            headers.extend(open.take());
        } else if let Some((key, text)) = line.split_once(',')
            && let Ok(key) = key.trim().parse::<u16>()
        {
            if key == 112 && text.trim().to_ascii_lowercase().starts_with("low") {
                return Err(Fault::in_line(n, "the bytes of the values are exchanged").help("export it as CSV"));
            }
            if let Some(header) = open.as_mut() {
                header.insert(key, (n, text));
            }
        }
        lines.push(line.to_owned());
    }
    headers.extend(open);
    let mut series = vec![];
    let mut times: Option<(String, Clock)> = None;
    for header in &headers {
        let name = text(header, 200).unwrap_or_default().to_owned();
        let unit_name = text(header, 202).unwrap_or_default().trim_matches(['[', ']']).to_owned();
        let unit = unit::header_unit(&unit_name);
        let implicit = text(header, 210).is_some_and(|t| t.eq_ignore_ascii_case("IMPLICIT"));
        let count = value(header, 220, 0.0)?;
        if !(count > 0.0 && count.fract() == 0.0) {
            return Err(Fault::new(format!("the header of \"{name}\" gives no number of values (key 220)")));
        }
        let (start, step) = (value(header, 240, 0.0)?, value(header, 241, 1.0)?);
        if implicit {
            let u = unit.filter(|u| u.quantity == Quantity::Time && step > 0.0);
            let u = u.ok_or_else(|| Fault::new(format!("\"{name}\" grows by equal steps and has no unit of time")))?;
            let seconds = |x: f64| crate::sheet::head::seconds(x, &u);
            times.get_or_insert((name, Clock::Steps { start: seconds(start), dt: seconds(step) }));
            continue;
        }
        let raw = raw_values(input, header, &name, count as usize)?;
        let values: Vec<f64> = raw.iter().map(|x| start + step * x).collect();
        if crate::sheet::head::time_column(&name, &unit_name).is_some() && times.is_none() {
            times = Some((name, clock(values, unit)?));
            continue;
        }
        let quantity = unit.map(|u| u.quantity).or_else(|| Quantity::of_head(&name));
        series.push(Series { name, unit, unit_name, quantity, ..Series::new(values) });
    }
    if let Some((_, clock)) = times {
        series.iter_mut().for_each(|s| s.clock = clock.clone());
    }
    if series.is_empty() {
        return Err(Fault::new("the header names no channel with values"));
    }
    if let Some(s) = series.iter().find(|s| matches!(&s.clock, Clock::Times(t) if t.len() != s.values.len())) {
        return Err(Fault::new(format!("\"{}\" has {} values, the times are others", s.name, s.values.len())));
    }
    Ok(Content::series(series, lines, vec![]))
}

fn clock(times: Vec<f64>, unit: Option<unit::Unit>) -> Result<Clock, Fault> {
    let times: Vec<f64> = times.iter().map(|t| unit.map_or(*t, |u| crate::sheet::head::seconds(*t, &u))).collect();
    if times.len() < 2 || times.windows(2).any(|w| w[1] <= w[0] || !w[1].is_finite()) {
        return Err(Fault::new("the times of the header's file do not increase"));
    }
    Ok(Clock::of_times(times))
}

/// The numbers of a channel in the file that its header names.
fn raw_values(input: &Input<'_>, header: &Header<'_>, name: &str, count: usize) -> Result<Vec<f64>, Fault> {
    let file =
        text(header, 211).ok_or_else(|| Fault::new(format!("the header of \"{name}\" names no file (key 211)")))?;
    let short = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let bytes = (input.beside)(short).ok_or_else(|| {
        Fault::new(format!("is the header of values in \"{short}\", which is not beside it or not read here"))
            .help("hysteron recording FILE --out FILE.csv reads both and writes them as CSV")
    })?;
    let kind = text(header, 214).unwrap_or_default().to_ascii_uppercase();
    let in_blocks = text(header, 213).is_some_and(|m| m.eq_ignore_ascii_case("BLOCK"));
    let first = (value(header, 221, 1.0)?.max(1.0) - 1.0) as usize;
    let element = match kind.as_str() {
        "REAL32" => Element::F4,
        "REAL64" => Element::F8,
        "INT16" => Element::Signed(2),
        "INT32" => Element::Signed(4),
        "ASCII" => return ascii(header, name, short, &bytes, count),
        _ => return Err(Fault::new(format!("\"{name}\" has values of type {kind}")).help("export it as CSV")),
    };
    let size = element.size();
    let there = bytes.len() / size;
    // Values of one channel follow each other, or those of several alternate: then their number is that of the file.
    let stride = if in_blocks { there / count } else { 1 };
    let fits = if in_blocks { stride > first && bytes.len() == stride * count * size } else { first + count <= there };
    if !fits {
        let message = format!("\"{short}\" has {there} numbers, and {name} needs {count} from number {}", first + 1);
        return Err(Fault::new(message).help("export it as CSV"));
    }
    let at = |i: usize| (first + i * stride) * size;
    Ok((0..count).map(|i| element.value(&bytes[at(i)..at(i) + size], true)).collect())
}

/// A column of a file of text.
fn ascii(header: &Header<'_>, name: &str, file: &str, bytes: &[u8], count: usize) -> Result<Vec<f64>, Fault> {
    let text_of = crate::text::decode(bytes)?;
    let separator = text(header, 230).and_then(|w| w.chars().next()).map(Separator::Char);
    let form =
        Form { name: file, separator, decimal: text(header, 231).and_then(|w| w.chars().next()), ..Form::default() };
    let sheet = Sheet::parse(&text_of, &form).map_err(Fault::from)?;
    let column = value(header, 223, 1.0)? as usize;
    let found = column.checked_sub(1).and_then(|i| sheet.columns.get(i));
    let found = found.ok_or_else(|| Fault::new(format!("\"{file}\" has no column {column} for \"{name}\"")))?;
    if found.values.len() != count {
        let message = format!("the header says {count} values of {name}, \"{file}\" has {}", found.values.len());
        return Err(Fault::new(message));
    }
    Ok(found.values.clone())
}
