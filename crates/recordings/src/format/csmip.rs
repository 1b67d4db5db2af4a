//! CSMIP's Volumes 1 and 2: accelerations, and in Volume 2 velocities and displacements, of one channel after another.

use super::{Format, Input, has, note_surplus};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{header_numbers, number, shown};
use crate::series::Series;
use crate::unit::{self, Quantity, Unit};

pub(super) const CSMIP: Format = Format {
    name: "CSMIP",
    recognised_by: "\"accel\" and \"spaced at\", or \"Accelerogram points at\", in a line of the header",
    states: "quantities and units (cm/s2, cm/s, cm where the header is silent), step, number of values, azimuths",
    description: "CSMIP, Standard tape format for CSMIP strong-motion data tapes, OSMS 85-03: values in eight columns of the width of the header's format",
    is: |input| input.has(&["accel", "spaced at"]) || input.has(&["accelerogram points at"]) || is_spectra(input),
    read,
};

/// Volume 3: spectra of a corrected accelerogram.
fn is_spectra(input: &Input<'_>) -> bool {
    let first = |words: &[&str]| input.head.first().is_some_and(|l| has(l, words));
    first(&["response", "spectra"]) && input.head.get(1).is_some_and(|l| has(l, &["accelerogram"]))
}

/// Words of the lines before the values, and the unit of these.
const KINDS: &[(&str, &str)] = &[("accel", "cm/s2"), ("veloc", "cm/s"), ("displ", "cm")];

/// The unit of the values after a line.
fn kind(line: &str) -> Option<Unit> {
    let is_block = |word: &str| has(line, &[word, "spaced at"]) || has(line, &[word, "points at"]);
    let word = KINDS.iter().find(|(word, _)| is_block(word))?;
    let by_format = unit::unit(word.1)?;
    // `..., in cm/sec2`, `in units of g .` or `(UNITS: CM/SEC/SEC)` says it again.
    let lower = line.to_ascii_lowercase();
    let after = ["in units of", "units:", " in "].iter().find_map(|w| lower.rfind(w).map(|i| &line[i + w.len()..]));
    let stated = after.and_then(|a| unit::header_unit(a.split(['.', ',', ')', '(']).next().unwrap_or("")));
    Some(stated.filter(|u| u.quantity == by_format.quantity).unwrap_or(by_format))
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    if is_spectra(input) {
        return Err(Fault::new("holds spectra (Volume 3) and no series").help("take the file of Volume 1 or 2"));
    }
    let lines: Vec<&str> = input.text.lines().collect();
    let is_acceleration = |l: &str| kind(l).is_some_and(|u| u.quantity == Quantity::Acceleration);
    let channels = lines.iter().filter(|l| is_acceleration(l)).count();
    let (mut series, mut channel, mut from) = (vec![], 0, 0);
    let (mut title, mut azimuth) = (String::new(), None);
    let mut notes = vec![];
    for (at, line) in lines.iter().enumerate() {
        let Some(unit) = kind(line) else { continue };
        if unit.quantity == Quantity::Acceleration {
            channel += 1;
            azimuth = lines[from..at].iter().find_map(degrees).filter(|a| (0.0..=360.0).contains(a));
            let first = lines[from..at].iter().map(|l| l.trim()).find(|l| !l.is_empty());
            title = first.unwrap_or_default().to_owned();
            from = at + 1;
        }
        let (values, dt, last, left) = match block(&lines, at) {
            Ok(block) => block,
            Err(fault) if unit.quantity == Quantity::Acceleration => return Err(fault),
            // Velocities and displacements follow from the accelerations: these are read without them.
            Err(fault) => {
                notes.push(format!("{} are left out: {fault}", unit.quantity.words()));
                continue;
            }
        };
        note_surplus(&lines, last + 1, left, &mut notes);
        let name = if channels > 1 { format!("channel {channel}") } else { String::new() };
        let mut s = Series { name, title: title.clone(), azimuth, ..Series::new(values) }.with_unit(unit).with_step(dt);
        s.origin.lines = at + 2..last + 2;
        series.push(s);
    }
    let end = lines.iter().position(|l| kind(l).is_some()).unwrap_or(0) + 1;
    Ok(Content::series(series, lines[..end].iter().map(|l| (*l).to_owned()).collect(), notes))
}

/// Characters of a value: of `(8f9.6)` in the header, or an eighth of a full line of values; else ten.
fn width(header: &str, first: &str) -> usize {
    const COLUMNS: usize = 8;
    let stated = || {
        let format = header.rsplit_once('(')?.1.to_ascii_lowercase();
        let digits = format.strip_prefix('8')?.strip_prefix(['f', 'e'])?;
        digits.split('.').next()?.parse::<usize>().ok().filter(|w| *w > 0)
    };
    let length = first.trim_end().len();
    let full = length.is_multiple_of(COLUMNS) && (9 * COLUMNS..=15 * COLUMNS).contains(&length);
    stated().unwrap_or(if full { length / COLUMNS } else { 10 })
}

/// `CHAN  1:  360 DEG`.
fn degrees(line: &&str) -> Option<f64> {
    let upper = line.to_ascii_uppercase();
    let before = upper.split("DEG").next().filter(|_| upper.contains("CHAN") && upper.contains("DEG"))?;
    before.split_whitespace().last()?.trim_start_matches(':').parse::<f64>().ok()
}

/// The values after a line that says how many they are and their step; index of their last line, and cells left in it.
fn block(lines: &[&str], at: usize) -> Result<(Vec<f64>, f64, usize, usize), Fault> {
    let header = lines[at];
    let numbers = header_numbers(header);
    let Some(&count) = numbers.first() else {
        return Err(Fault::in_line(at + 1, format!("no count in \"{}\"", shown(header))));
    };
    let lower = header.to_ascii_lowercase();
    let after = |words: &str| lower.find(words).and_then(|i| header_numbers(&header[i..]).first().copied());
    // A step, or samples a second.
    let dt = after("spaced at").or_else(|| after("points at").map(|rate| 1.0 / rate));
    let dt = dt.filter(|dt| *dt > 0.0 && dt.is_finite());
    let width = width(header, lines.get(at + 1).copied().unwrap_or_default());
    let dt = dt.ok_or_else(|| Fault::in_line(at + 1, format!("no step of time in \"{}\"", shown(header))))?;
    let (mut values, mut last, mut left) = (vec![], at, 0);
    for (i, line) in lines.iter().enumerate().skip(at + 1) {
        if values.len() as f64 >= count || !line.is_ascii() {
            break;
        }
        last = i;
        for cell in line.trim_end().as_bytes().chunks(width) {
            if values.len() as f64 >= count {
                left += 1;
                continue;
            }
            let cell = String::from_utf8_lossy(cell);
            let value = number(cell.trim());
            values.push(value.ok_or_else(|| Fault::in_line(i + 1, format!("\"{}\" is not a number", cell.trim())))?);
        }
    }
    if (values.len() as f64) < count {
        return Err(Fault::in_line(at + 1, format!("the header says {count} values, but there are {}", values.len())));
    }
    Ok((values, dt, last, left))
}
