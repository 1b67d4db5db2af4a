//! COSMOS strong motion files (V2c): format of the COSMOS consortium, version 1.20.
//!
//! A channel has a text header, integer and real headers with a line that gives their numbers, comments, and the data.
//! Header lines and the line before the data describe themselves; the meaning of the entries is that of the published format.

use super::Motion;

/// Entry of the integer header with the direction in degrees (counted from 1).
const AZIMUTH_ENTRY: usize = 54;
/// Entry of the real header with the step of the processed data in ms.
const STEP_MS_ENTRY: usize = 62;
/// Entry of the real header with the step of the recorder in s.
const STEP_ENTRY: usize = 34;

/// True if a text is a COSMOS file.
pub(super) fn is_cosmos(text: &str) -> bool {
    let head = |l: &str| l.contains("Real-header values follow");
    text.lines().any(head)
}

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

/// `n` numbers of fixed width from the lines after `at`; the line after them.
fn numbers(lines: &[&str], at: usize, n: usize, width: usize) -> Result<(Vec<f64>, usize), String> {
    let mut out = vec![];
    let mut line = at;
    while out.len() < n {
        let text = lines.get(line).ok_or_else(|| format!("the file ends after {} of {n} numbers", out.len()))?;
        let cells: Vec<String> = if width > 0 && text.is_ascii() {
            text.trim_end().as_bytes().chunks(width).map(|c| String::from_utf8_lossy(c).trim().to_owned()).collect()
        } else {
            text.split_whitespace().map(str::to_owned).collect()
        };
        if cells.is_empty() {
            return Err(format!("line {} is empty after {} of {n} numbers", line + 1, out.len()));
        }
        for cell in cells.iter().take(n - out.len()) {
            let number = cell.parse::<f64>().ok().filter(|x| x.is_finite());
            out.push(number.ok_or_else(|| format!("line {}: \"{cell}\" is not a number", line + 1))?);
        }
        line += 1;
    }
    Ok((out, line))
}

/// The channels of accelerations; others are left out.
///
/// # Errors
/// A description of the fault with its line.
pub(super) fn parse(name: &str, text: &str) -> Result<Vec<Motion>, String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut motions: Vec<Motion> = vec![];
    let (mut title, mut whole, mut real) = (String::new(), vec![], vec![]);
    let mut at = 0;
    while at < lines.len() {
        let line = lines[at];
        if line.contains("(Format v") {
            let station = lines.get(at + 4).map_or("", |l| l.trim());
            title = format!("{}; {station}", lines.get(at + 1).map_or("", |l| l.trim()));
        }
        let values = |n: usize| numbers(&lines, at + 1, n, width(line));
        if line.contains("Integer-header values follow") {
            (whole, at) = values(count(line).unwrap_or(0))?;
        } else if line.contains("Real-header values follow") {
            (real, at) = values(count(line).unwrap_or(0))?;
        } else if line.contains(" pts, approx") {
            let n = count(line).ok_or_else(|| format!("line {}: expected the number of values", at + 1))?;
            let (data, next) = values(n)?;
            if line.contains("acceleration") {
                let unit = unit(line).ok_or_else(|| format!("line {}: the unit is not known", at + 1))?;
                let known = |entry: usize| real.get(entry - 1).copied().filter(|x: &f64| *x > 0.0);
                let dt = known(STEP_MS_ENTRY).map(|ms| ms / 1000.0).or_else(|| known(STEP_ENTRY));
                let dt = dt.ok_or_else(|| format!("line {}: the real header gives no step of time", at + 1))?;
                let azimuth = whole.get(AZIMUTH_ENTRY - 1).copied().filter(|x: &f64| (0.0..=360.0).contains(x));
                let acceleration = data.iter().map(|a| unit * a).collect();
                let name = format!("{name} channel {}", motions.len() + 1);
                motions.push(Motion { name, title: title.clone(), azimuth, dt, acceleration });
            }
            at = next;
        } else {
            at += 1;
        }
    }
    if motions.is_empty() { Err("there is no channel of accelerations".into()) } else { Ok(motions) }
}

/// The unit of a line `units=cm/sec2 (04)` in m/s².
fn unit(line: &str) -> Option<f64> {
    let after = line.split("units=").nth(1)?;
    let name = after.split(['(', ',']).next()?.trim();
    hysteron_identify::study::unit::unit(name).filter(|u| u.quantity == super::read::ACCELERATION).map(|u| u.factor)
}

#[cfg(test)]
mod tests {
    use super::{is_cosmos, parse};

    #[test]
    fn channels_with_their_step_unit_and_direction() {
        let row = |n: usize, entry: usize, value: &str| {
            let cells: Vec<String> = (1..=n).map(|i| if i == entry { value.into() } else { "-999".into() }).collect();
            cells.chunks(10).map(|c| c.iter().map(|x| format!("{x:>8}")).collect::<String>() + "\n").collect::<String>()
        };
        let channel = |azimuth: &str, quantity: &str| {
            format!(
                "Corrected {quantity} (Format v01.20 with 13 text lines)\nEarthquake\n\n\nStation\n  \
                 100 Integer-header values follow on 10 lines, Format= (10I8)\n{}  \
                 100 Real-header values follow on 10 lines, Format= (10F8.3)\n{}   \
                 1 Comment line(s) follow, each starting with a \"|\":\n|none\n      \
                 5 {quantity} pts, approx  0 secs, units=cm/sec2 (04),Format=(4F10.5)\n  -1.00000   2.00000-100.00000   \
                 4.00000\n   5.00000\nEnd-of-data for Chan\n",
                row(100, 54, azimuth),
                row(100, 62, "5.0")
            )
        };
        let text = channel("90", "acceleration") + &channel("90", "velocity") + &channel("360", "acceleration");
        assert!(is_cosmos(&text));
        let m = parse("f", &text).expect("motions");
        assert_eq!(m.len(), 2);
        assert_eq!((m[0].azimuth, m[1].azimuth, m[0].dt), (Some(90.0), Some(360.0), 0.005));
        assert!((m[0].acceleration[2] + 1.0).abs() < 1e-12 && m[0].acceleration.len() == 5);
        assert!(parse("f", &text[..1200]).is_err());
    }
}
