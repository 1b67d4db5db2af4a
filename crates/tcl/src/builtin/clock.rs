//! `clock`: the time, and writing it.

use std::fmt::Write as _;
use std::time::SystemTime;

use jiff::Timestamp;
use jiff::civil::{Date, DateTime};
use jiff::tz::{Offset, TimeZone};

use super::clock_scan;
use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("clock", |core, call| dispatch(core, call, SUBS))];

const SUBS: &[(&str, CoreFn)] = &[
    ("add", clock_scan::add),
    ("clicks", clicks),
    ("format", format),
    ("microseconds", |_, call| now(call, "microseconds", 1_000_000)),
    ("milliseconds", |_, call| now(call, "milliseconds", 1000)),
    ("scan", clock_scan::scan),
    ("seconds", |_, call| now(call, "seconds", 1)),
];

pub(super) const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];
pub(super) const DAYS: [&str; 7] = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];

/// The error for a wrong number of words, with the code that `clock` has for it.
pub(super) fn wrong_args(call: &Call<'_>, usage: &str) -> Exception {
    call.wrong_args(usage).with_code(Value::list(["CLOCK", "wrongNumArgs"].map(Value::from)))
}

/// Time since 1970 in parts of a second.
pub(super) fn since_1970(parts: u32) -> i64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    (since.as_micros() * u128::from(parts) / 1_000_000) as i64
}

fn now(call: &Call<'_>, name: &str, parts: u32) -> Result<Value, Exception> {
    call.expect(2..=2, &format!("clock {name}"))?;
    Ok(Value::from(since_1970(parts)))
}

fn clicks(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "clock clicks ?-switch?")?;
    let parts = match call.len() {
        3 if call.choose(2, "option", &["-milliseconds", "-microseconds"], false)? == 0 => 1000,
        _ => 1_000_000,
    };
    Ok(Value::from(since_1970(parts)))
}

/// The options of `clock format`, `scan` and `add`.
pub(super) struct Options {
    pub(super) format: Option<Value>,
    pub(super) base: Option<i64>,
    pub(super) zone: TimeZone,
}

pub(super) fn options(call: &Call<'_>, from: usize, names: &[&str]) -> Result<Options, Exception> {
    let mut o = Options { format: None, base: None, zone: TimeZone::UTC };
    let mut zone: Option<Value> = None;
    let mut gmt = false;
    for i in (from..call.len()).step_by(2) {
        let word = call.arg(i).as_str();
        let mut fitting = names.iter().filter(|n| word.len() > 1 && n.starts_with(&*word));
        let (Some(name), None) = (fitting.next(), fitting.next()) else {
            let (last, most) = names.split_last().unwrap_or((&"", &[]));
            // `clock format` has a wording of its own.
            let (before, and) = if names.first() == Some(&"-format") { (":", ", or") } else { (",", " or") };
            let message = format!("bad option \"{word}\"{before} must be {}{and} {last}", most.join(", "));
            return Err(Exception::coded(message, &["CLOCK", "badOption", &word]).at(call.span(i), ""));
        };
        let value = call.arg(i + 1);
        match *name {
            "-format" => o.format = Some(value.clone()),
            "-gmt" => gmt = value.to_bool()?,
            "-timezone" => zone = Some(value.clone()),
            "-base" => o.base = Some(value.to_i64()?),
            _ => {}
        }
    }
    if gmt && zone.is_some() {
        let message = "cannot use -gmt and -timezone in same call";
        return Err(Exception::coded(message, &["CLOCK", "gmtWithTimezone"]));
    }
    o.zone = match zone {
        Some(name) => zone_named(&name.as_str())?,
        None if gmt => TimeZone::UTC,
        None => TimeZone::system(),
    };
    Ok(o)
}

pub(super) fn zone_named(name: &str) -> Result<TimeZone, Exception> {
    let bare = name.trim_start_matches(':');
    if matches!(bare, "" | "localtime") {
        return Ok(TimeZone::system());
    }
    if let Some(seconds) = numeric_zone(bare)
        && let Ok(offset) = Offset::from_seconds(seconds)
    {
        return Ok(TimeZone::fixed(offset));
    }
    if matches!(bare.to_ascii_uppercase().as_str(), "UTC" | "GMT" | "Z") {
        return Ok(TimeZone::UTC);
    }
    TimeZone::get(bare)
        .map_err(|_| Exception::coded(format!("time zone \"{name}\" not found"), &["CLOCK", "badTimeZone", name]))
}

/// `+0130`, `-05:00`: seconds east of Greenwich.
pub(super) fn numeric_zone(text: &str) -> Option<i32> {
    let sign = match text.as_bytes().first()? {
        b'+' => 1,
        b'-' => -1,
        _ => return None,
    };
    let digits: String = text[1..].chars().filter(|c| *c != ':').collect();
    if !matches!(digits.len(), 2 | 4 | 6) || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let field = |at: usize| digits.get(at..at + 2).and_then(|d| d.parse::<i32>().ok()).unwrap_or(0);
    Some(sign * (field(0) * 3600 + field(2) * 60 + field(4)))
}

/// The time as people read it.
pub(super) struct Local {
    pub(super) time: DateTime,
    offset: i32,
    zone: String,
}

pub(super) fn local(seconds: i64, zone: &TimeZone) -> Result<Local, Exception> {
    let stamp = Timestamp::from_second(seconds)
        .map_err(|_| Exception::coded("integer value too large to represent", &["CLOCK", "dateTooLarge"]))?;
    let info = zone.to_offset_info(stamp);
    let abbreviation = info.abbreviation();
    let zone = if *zone == TimeZone::UTC { "GMT".to_owned() } else { abbreviation.to_owned() };
    Ok(Local { time: info.offset().to_datetime(stamp), offset: info.offset().seconds(), zone })
}

fn format(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() < 3 || call.len().is_multiple_of(2) {
        let usage = "clock format clockval ?-format string? ?-gmt boolean? ?-locale LOCALE? ?-timezone ZONE?";
        return Err(wrong_args(call, usage));
    }
    let o = options(call, 3, &["-format", "-gmt", "-locale", "-timezone"])?;
    let seconds = call.arg(2).to_wide()?;
    let local = local(seconds, &o.zone)?;
    let pattern = o.format.as_ref().map_or("%a %b %d %H:%M:%S %Z %Y".into(), Value::as_str);
    let mut out = String::new();
    let mut chars = pattern.chars();
    while let Some(c) = chars.next() {
        match c {
            '%' => match chars.next() {
                Some(letter @ ('E' | 'O')) => match chars.next() {
                    Some(next) => local.write(next, seconds, &mut out),
                    None => out.extend(['%', letter]),
                },
                Some(letter) => local.write(letter, seconds, &mut out),
                None => out.push('%'),
            },
            c => out.push(c),
        }
    }
    Ok(Value::from(out))
}

/// Days from the first of January of year 0, as Tcl's Julian day counts them.
fn julian_day(date: Date) -> i64 {
    let epoch = Date::constant(1970, 1, 1);
    2_440_588 + i64::from((date - epoch).get_days())
}

impl Local {
    /// Number of the week if weeks start on a day (0: Sunday).
    fn week(&self, start: i64) -> i64 {
        let day_of_year = i64::from(self.time.day_of_year());
        let weekday = i64::from(self.time.weekday().to_sunday_zero_offset());
        (day_of_year + 6 - (weekday - start).rem_euclid(7)) / 7
    }

    fn write(&self, letter: char, seconds: i64, out: &mut String) {
        let t = &self.time;
        let weekday = i64::from(t.weekday().to_sunday_zero_offset());
        let hour12 = (t.hour() + 11) % 12 + 1;
        let iso = t.date().iso_week_date();
        let year = t.year();
        let month = usize::try_from(t.month()).unwrap_or(1).clamp(1, 12);
        let _ = match letter {
            'a' => write!(out, "{}", &DAYS[weekday as usize % 7][..3]),
            'A' => write!(out, "{}", DAYS[weekday as usize % 7]),
            'b' | 'h' => write!(out, "{}", &MONTHS[month - 1][..3]),
            'B' => write!(out, "{}", MONTHS[month - 1]),
            'C' => write!(out, "{:02}", year / 100),
            'd' => write!(out, "{:02}", t.day()),
            'e' => write!(out, "{:2}", t.day()),
            'g' => write!(out, "{:02}", iso.year() % 100),
            'G' => write!(out, "{:04}", iso.year()),
            'H' => write!(out, "{:02}", t.hour()),
            'I' => write!(out, "{hour12:02}"),
            'j' => write!(out, "{:03}", t.day_of_year()),
            'J' => write!(out, "{:07}", julian_day(t.date())),
            'k' => write!(out, "{:2}", t.hour()),
            'l' => write!(out, "{hour12:2}"),
            'm' => write!(out, "{:02}", t.month()),
            'M' => write!(out, "{:02}", t.minute()),
            'N' => write!(out, "{:2}", t.month()),
            'n' => writeln!(out),
            'p' => write!(out, "{}", if t.hour() < 12 { "AM" } else { "PM" }),
            'P' => write!(out, "{}", if t.hour() < 12 { "am" } else { "pm" }),
            's' => write!(out, "{seconds}"),
            'S' => write!(out, "{:02}", t.second()),
            't' => write!(out, "\t"),
            'u' => write!(out, "{}", if weekday == 0 { 7 } else { weekday }),
            'U' => write!(out, "{:02}", self.week(0)),
            'V' => write!(out, "{:02}", iso.week()),
            'w' => write!(out, "{weekday}"),
            'W' => write!(out, "{:02}", self.week(1)),
            'y' => write!(out, "{:02}", year.rem_euclid(100)),
            'Y' => write!(out, "{year:04}"),
            'z' => {
                let minutes = self.offset.abs() / 60;
                let sign = if self.offset < 0 { '-' } else { '+' };
                write!(out, "{sign}{:02}{:02}", minutes / 60, minutes % 60)
            }
            'Z' => write!(out, "{}", self.zone),
            'D' => return self.write_all("m/d/Y", seconds, out),
            'x' => return self.write_all("m/d/Y", seconds, out),
            'X' | 'T' => return self.write_all("H:M:S", seconds, out),
            'r' => return self.write_all("I:M:S P", seconds, out),
            'R' => return self.write_all("H:M", seconds, out),
            'c' => return self.write_all("a b e H:M:S Y", seconds, out),
            '+' => return self.write_all("a b e H:M:S Z Y", seconds, out),
            '%' => write!(out, "%"),
            other => write!(out, "%{other}"),
        };
    }

    /// Write several fields; anything but a letter stands for itself.
    fn write_all(&self, letters: &str, seconds: i64, out: &mut String) {
        for c in letters.chars() {
            if c.is_ascii_alphabetic() { self.write(c, seconds, out) } else { out.push(c) }
        }
    }
}
