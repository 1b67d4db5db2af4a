//! PEER's AT2, VT2 and DT2, old and new.

use super::{Format, Input, counted, has};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, number, shown};
use crate::series::Series;
use crate::unit::{self, Quantity, Unit};

pub(super) const PEER: Format = Format {
    name: "PEER",
    recognised_by: "NPTS and DT in the header",
    states: "quantity and unit (g, cm/s, cm where the header is silent), step, number of values, azimuth",
    description: "PEER NGA database, flat file documentation: four lines of header, values in rows of five",
    is: |input| header_lines(input).is_some(),
    read,
};

/// Indices of the lines with the count and the step.
fn header_lines(input: &Input<'_>) -> Option<(usize, usize)> {
    let head = &input.head;
    if let Some(at) = head.iter().position(|l| has(l, &["npts", "dt"])) {
        return Some((at, at));
    }
    let begins = |key: &str| {
        let is = |l: &&str| l.trim_start().get(..key.len()).is_some_and(|k| k.eq_ignore_ascii_case(key));
        head.iter().take(12).position(is)
    };
    Some((begins("npts")?, begins("dt")?))
}

/// Numbers and words of a header line; signs between them separate.
fn tokens(line: &str) -> Vec<String> {
    let upper = line.to_ascii_uppercase();
    upper
        .split(|c: char| c.is_whitespace() || matches!(c, '=' | ',' | ':' | ';'))
        .filter(|w| !w.is_empty())
        .map(str::to_owned)
        .collect()
}

/// The word after a key; else, where the keys follow their values, the word at the key's place among the numbers.
fn value_of(line: &str, key: &str, place: usize) -> Option<(String, String)> {
    let words = tokens(line);
    let at = words.iter().position(|w| w == key || w.strip_prefix(key).is_some_and(|r| number(r).is_some()))?;
    // `DT.01` has no sign between.
    if let Some(rest) = words[at].strip_prefix(key).filter(|r| !r.is_empty()) {
        return Some((rest.to_owned(), words.get(at + 1).cloned().unwrap_or_default()));
    }
    let begins_as_number = |w: &String| w.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-'));
    if let Some(value) = words.get(at + 1).filter(|w| begins_as_number(w)) {
        return Some((value.clone(), words.get(at + 2).cloned().unwrap_or_default()));
    }
    let before: Vec<&String> = words.iter().filter(|w| begins_as_number(w)).collect();
    Some(((*before.get(place)?).clone(), String::new()))
}

/// Quantity and unit that the header states, or the format by its extension.
fn statement(
    input: &Input<'_>,
    end: usize,
    notes: &mut Vec<String>,
) -> Result<(Quantity, Option<Unit>, String), Fault> {
    let by_extension = match () {
        () if input.has_extension("vt2") => Some(Quantity::Velocity),
        () if input.has_extension("dt2") => Some(Quantity::Length),
        () if input.has_extension("at2") => Some(Quantity::Acceleration),
        () => None,
    };
    let kinds = [
        ("acceleration", Quantity::Acceleration),
        ("velocity", Quantity::Velocity),
        ("displacement", Quantity::Length),
    ];
    let stated = input.head[..end].iter().enumerate().find_map(|(i, line)| {
        let is_statement = has(line, &["unit"]) || has(line, &["time series"]) || has(line, &["time history"]);
        let kind = kinds.iter().find(|(word, _)| is_statement && has(line, &[word]))?;
        Some((i + 1, kind.1, *line))
    });
    let Some((number_of_line, quantity, line)) = stated else {
        let quantity = by_extension.unwrap_or(Quantity::Acceleration);
        let unit = unit::unit(if quantity == Quantity::Acceleration { "g" } else { cgs(quantity) });
        notes.push(format!(
            "the header states no unit: {} of PEER are in {}",
            quantity.words(),
            unit.map_or("", |u| u.name)
        ));
        return Ok((quantity, unit, String::new()));
    };
    if by_extension.is_some_and(|q| q != quantity) {
        let message = format!(
            "the header says \"{}\", the extension of the name says {}",
            shown(line),
            by_extension.map_or("", Quantity::word)
        );
        return Err(Fault::in_line(number_of_line, message).expected("expected one quantity"));
    }
    let upper = line.to_ascii_uppercase();
    let after = ["UNITS OF", "UNIT OF", "UNITS:", "UNITS", "UNIT"]
        .iter()
        .find_map(|w| upper.find(w).map(|i| &line[i + w.len()..]));
    let bracketed = || line.split_once('(').and_then(|(_, rest)| rest.split(')').next());
    let word = after.or_else(bracketed).unwrap_or("").trim().trim_start_matches([':', '=']).trim();
    let word = word.split([',', ';']).next().unwrap_or("").trim();
    // `G. FILTER POINTS: ...`: a sentence follows.
    let word = word.split(". ").next().unwrap_or("").trim_end_matches('.');
    if word.is_empty() {
        let unit = unit::unit(if quantity == Quantity::Acceleration { "g" } else { cgs(quantity) });
        notes.push(format!(
            "the header states no unit: {} of PEER are in {}",
            quantity.words(),
            unit.map_or("", |u| u.name)
        ));
        return Ok((quantity, unit, String::new()));
    }
    let unit = unit::header_unit(word);
    if let Some(u) = unit.filter(|u| u.quantity != quantity) {
        let message = format!("the header says {} in {}, which is {}", quantity.word(), u.name, u.quantity);
        return Err(Fault::in_line(number_of_line, message).expected("expected one quantity"));
    }
    Ok((quantity, unit, word.to_owned()))
}

fn cgs(quantity: Quantity) -> &'static str {
    if quantity == Quantity::Velocity { "cm/s" } else { "cm" }
}

/// The step in s of `.0100 SEC`, `10.0 MSEC`, `1.0E-02`.
fn step(value: &str, unit_word: &str, line: usize, header: &str) -> Result<f64, Fault> {
    let fault = |what: &str| {
        Fault::in_line(line, format!("{what}: \"{}\"", shown(header))).expected("expected a step of time in s")
    };
    let dt = number(value).ok_or_else(|| fault("the step of time is no number"))?;
    if dt <= 0.0 {
        return Err(fault("the step of time is not greater than 0"));
    }
    let is_unit = unit_word.starts_with(|c: char| c.is_ascii_alphabetic()) && unit_word != "NPTS" && unit_word != "DT";
    match unit::header_unit(unit_word).filter(|u| u.quantity == Quantity::Time) {
        Some(u) => Ok(crate::sheet::head::seconds(dt, &u)),
        None if is_unit => Err(fault("the unit of the step is not known")),
        None => Ok(dt),
    }
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let Some((count_at, step_at)) = header_lines(input) else {
        return Err(Fault::new("there is no line with NPTS and DT"));
    };
    let (count_line, step_line) = (input.head[count_at], input.head[step_at]);
    let upper = count_line.to_ascii_uppercase();
    let npts_first = upper.find("NPTS") <= upper.find("DT") || count_at != step_at;
    let places = if count_at != step_at {
        (0, 0)
    } else if npts_first {
        (0, 1)
    } else {
        (1, 0)
    };
    let no = |what: &str, at: usize| Fault::in_line(at + 1, format!("no {what} in \"{}\"", shown(input.head[at])));
    let (count, _) = value_of(count_line, "NPTS", places.0).ok_or_else(|| no("count and no step of time", count_at))?;
    let count = number(&count).filter(|c| *c >= 0.0 && c.fract() == 0.0).ok_or_else(|| no("count", count_at))?;
    let (dt, unit_word) = value_of(step_line, "DT", places.1).ok_or_else(|| no("step of time", step_at))?;
    let dt = step(&dt, &unit_word, step_at + 1, step_line)?;
    let mut notes = vec![];
    let first = count_at.max(step_at) + 1;
    let (quantity, unit, unit_name) = statement(input, first.min(input.head.len()), &mut notes)?;
    let mut numbers = NumberLines::default();
    let mut last = first;
    for (n, line) in input.lines().skip(first) {
        numbers.push(n, line)?;
        last = n;
    }
    let mut values = numbers.values;
    counted(&mut values, count as usize, &mut notes)?;
    let (title, azimuth) = title(&input.head);
    let mut series =
        Series { title, azimuth, quantity: Some(quantity), unit, unit_name, ..Series::new(values) }.with_step(dt);
    series.origin.lines = first + 1..last + 1;
    let header = input.head[..first].iter().map(|l| (*l).to_owned()).collect();
    Ok(Content::series(vec![series], header, notes))
}

/// The second line is `event, date, station, component`, whose last word is the azimuth if it is a number.
fn title(head: &[&str]) -> (String, Option<f64>) {
    let lines: Vec<&str> = head.iter().take(4).map(|l| l.trim()).collect();
    let line = lines.iter().find(|l| l.matches(',').count() >= 2 && !has(l, &["npts"]));
    let last = line.and_then(|l| l.rsplit(',').next());
    // The component stands alone, or before the name of the station in brackets.
    let word = last.map(|w| w.split('(').next().unwrap_or(w).trim());
    let azimuth = word.and_then(|w| w.trim_start_matches('0').parse().ok().or((w == "000").then_some(0.0)));
    (line.map_or("", |l| l).to_owned(), azimuth.filter(|a: &f64| (0.0..=360.0).contains(a)))
}
