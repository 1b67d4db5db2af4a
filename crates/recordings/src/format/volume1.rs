//! Uncorrected accelerograms of Volume 1, as CSMIP, USC, BHRC and the University of Chile write them: 13 lines of text, 100
//! integers and 50 reals in seven lines each, and the values.

use super::{Format, Input, azimuth, has};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, header_numbers, shown};
use crate::series::{Clock, Series};
use crate::unit;

pub(super) const VOLUME1: Format = Format {
    name: "Volume 1",
    recognised_by: "\"NO. OF POINTS\" and, below it, \"UNITS\" with G in the first 13 lines, and a first line with \"UNCORRECTED\" or \"VOL1\"",
    states: "accelerations in g or g/10, number of values, times or the duration, azimuth",
    description: "California Institute of Technology, Strong motion earthquake accelerograms, Volume I: pairs of time and acceleration, or accelerations alone",
    is: |input| {
        let first = input.head.first().is_some_and(|l| has(l, &["uncorrected"]) || has(l, &["vol1"]));
        first
            && input.head.iter().take(TEXT_LINES).any(|l| has(l, &["no. of points"]))
            && input.head.iter().take(TEXT_LINES).any(|l| unit_of(l).is_some())
    },
    read,
};

const TEXT_LINES: usize = 13;
const NUMBER_LINES: usize = 14;
/// Sampling rates are whole numbers, and digital recorders have no higher one.
const HIGHEST_RATE: f64 = 1000.0;

/// Factor to g and name of the unit of a line such as `UNITS ARE SEC AND G/10`.
fn unit_of(line: &str) -> Option<(f64, &'static str)> {
    let upper = line.trim().to_ascii_uppercase();
    let rest = upper.strip_prefix("UNITS")?;
    let word = rest.split_whitespace().find(|w| matches!(w.trim_end_matches(['.', ',']), "G" | "G/10"))?;
    Some(if word.starts_with("G/10") { (0.1, "g/10") } else { (1.0, "g") })
}

/// The number after a word and an equals sign.
fn entry(lines: &[&str], word: &str) -> Option<f64> {
    lines.iter().find_map(|line| {
        let upper = line.to_ascii_uppercase();
        let after = &upper[upper.find(word)? + word.len()..];
        header_numbers(after.split_once('=')?.1).first().copied()
    })
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let lines: Vec<&str> = input.text.lines().collect();
    let mut series = vec![];
    let mut at = 0;
    while at < lines.len() {
        if lines[at].trim().is_empty() || lines[at].starts_with("/&") {
            at += 1;
            continue;
        }
        let (s, next) = block(&lines, at, series.len() + 1)?;
        series.push(s);
        at = next;
    }
    let header = lines.iter().take(TEXT_LINES).map(|l| (*l).to_owned()).collect();
    Ok(Content::series(series, header, vec![]))
}

/// The channel that begins at a line, and the line after it.
fn block(lines: &[&str], at: usize, channel: usize) -> Result<(Series, usize), Fault> {
    let data = at + TEXT_LINES + NUMBER_LINES;
    let head = lines.get(at..at + TEXT_LINES).unwrap_or_default();
    let missing = |what: &str| Fault::in_line(at + 1, format!("the header from here on gives no {what}"));
    let count = entry(head, "NO. OF POINTS").filter(|n| *n > 1.0 && n.fract() == 0.0);
    let count = count.ok_or_else(|| missing("NO. OF POINTS"))? as usize;
    let (factor, unit_name) = head.iter().find_map(|l| unit_of(l)).ok_or_else(|| missing("UNITS in G"))?;
    let mut numbers = NumberLines::default();
    let mut last = data;
    for (i, line) in lines.iter().enumerate().skip(data) {
        let begins = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
        if numbers.values.len() >= 2 * count || line.starts_with("/&") || !line.trim_start().starts_with(begins) {
            break;
        }
        numbers.push(i + 1, line)?;
        last = i + 1;
    }
    let values = numbers.values;
    let (clock, values) = if values.len() == 2 * count {
        let times: Vec<f64> = values.iter().copied().step_by(2).collect();
        if let Some(i) = times.windows(2).position(|w| w[1] <= w[0]) {
            let message = format!("the time of sample {} of channel {channel} does not increase", i + 2);
            return Err(Fault::in_line(data + 1, message));
        }
        (Clock::of_times(times), values.into_iter().skip(1).step_by(2).collect())
    } else if values.len() == count && !begins_with_times(&values) {
        let duration = entry(head, "DURATION").or_else(|| entry(head, "RECORD LENGTH"));
        (duration.and_then(|d| step(d, count)).map_or(Clock::Unknown, |dt| Clock::Steps { start: 0.0, dt }), values)
    } else {
        let message = format!("the header says {count} points, but there are {} numbers", values.len());
        return Err(Fault::in_line(at + 1, message).expected("expected as many, or a time with each"));
    };
    let values: Vec<f64> = values.iter().map(|x: &f64| factor * x).collect();
    let unit = unit::unit("g").ok_or_else(|| Fault::new("no unit"))?;
    let component = component(head);
    let mut s = Series {
        name: format!("channel {channel}"),
        title: head.iter().skip(1).take(2).map(|l| l.trim()).collect::<Vec<_>>().join("; "),
        station: head.get(4).map_or("", |l| l.trim()).to_owned(),
        azimuth: azimuth(&component),
        direction: component,
        clock,
        ..Series::new(values)
    }
    .with_unit(unit);
    s.origin.lines = data + 1..last + 1;
    if unit_name == "g/10" {
        s.title = shown(&format!("{} (written in g/10)", s.title)).into_owned();
    }
    Ok((s, last))
}

/// Every second number is later than the one before: pairs of time and value, of which half are missing.
fn begins_with_times(values: &[f64]) -> bool {
    let times: Vec<f64> = values.iter().copied().step_by(2).collect();
    times.len() > 2 && times.windows(2).all(|w| w[1] > w[0])
}

/// The component of `COMP N90E`, `CHAN  1:  90 DEG` or `CHAN  1: NS`.
fn component(head: &[&str]) -> String {
    let word = head.iter().find_map(|line| {
        let upper = line.trim().to_ascii_uppercase();
        let rest = upper.strip_prefix("COMP ").or_else(|| upper.strip_prefix("CHAN")?.split_once(':').map(|p| p.1));
        Some(rest?.split_whitespace().next()?.to_owned())
    });
    word.unwrap_or_default()
}

/// The step of a record of a duration, if one alone gives a whole number of samples a second.
fn step(duration: f64, count: usize) -> Option<f64> {
    let whole = |n: usize| {
        let rate = n as f64 / duration;
        let error = (rate - rate.round()).abs() / rate;
        (rate.round() >= 1.0 && rate <= HIGHEST_RATE && error < 1e-6).then(|| 1.0 / rate.round())
    };
    // Of 200 and 199 samples a second the former is the rate of a recorder: its step is a whole number of milliseconds.
    let in_ms = |dt: f64| (1000.0 * dt).fract().min(1.0 - (1000.0 * dt).fract()) < 1e-9;
    match (whole(count), whole(count - 1)) {
        (Some(dt), None) | (None, Some(dt)) => Some(dt),
        (Some(a), Some(b)) if in_ms(a) != in_ms(b) => Some(if in_ms(a) { a } else { b }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{step, unit_of};

    #[test]
    fn units_and_steps_of_headers() {
        assert_eq!(unit_of("UNITS ARE SEC AND G/10      22"), Some((0.1, "g/10")));
        assert_eq!(unit_of("UNITS OF UNCOR ACCEL ARE SEC AND G/10.  MAX = -.055 G, AT"), Some((0.1, "g/10")));
        assert_eq!(unit_of("NO. OF POINTS = 4, G"), None);
        assert_eq!((step(78.08, 15616), step(78.075, 15616), step(33.333, 1001)), (Some(0.005), Some(0.005), None));
        assert_eq!((step(1.0, 200), step(1.0, 201)), (Some(0.005), Some(0.005)));
    }
}
