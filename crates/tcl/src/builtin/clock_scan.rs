//! `clock scan` and `clock add`: reading times, and counting from them.

use jiff::Timestamp;
use jiff::civil::{Date, DateTime, Time};
use jiff::tz::TimeZone;
use jiff::{Span, ToSpan as _};

use super::clock::{DAYS, MONTHS, local, numeric_zone, options, since_1970, wrong_args, zone_named};
use crate::command::Call;
use crate::core::Core;
use crate::error::Exception;
use crate::value::Value;

/// Parts of a time that a text names. The others come from the base time.
#[derive(Default)]
struct Fields {
    year: Option<i16>,
    month: Option<i8>,
    day: Option<i8>,
    day_of_year: Option<i16>,
    hour: Option<i8>,
    minute: i8,
    second: i8,
    pm: Option<bool>,
    zone: Option<TimeZone>,
    seconds: Option<i64>,
}

fn refuse(text: &str) -> Exception {
    let message = format!("unable to convert date-time string \"{text}\"");
    Exception::coded(message, &["CLOCK", "badInputString"])
}

fn no_match() -> Exception {
    Exception::coded("input string does not match supplied format", &["CLOCK", "badInputString"])
}

pub(super) fn scan(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() < 3 || call.len().is_multiple_of(2) {
        let usage =
            "clock scan string ?-base seconds? ?-format string? ?-gmt boolean? ?-locale LOCALE? ?-timezone ZONE?";
        return Err(wrong_args(call, usage));
    }
    let o = options(call, 3, &["-base", "-format", "-gmt", "-locale", "-timezone"])?;
    let base = o.base.unwrap_or_else(|| since_1970(1));
    let text = call.arg(2).as_str();
    let at_base = local(base, &o.zone)?.time;
    let seconds = match &o.format {
        Some(format) => {
            let fields = by_format(&text, &format.as_str())?;
            fields.resolve(at_base, &o.zone, true).ok_or_else(no_match)?
        }
        None => free_form(&text, at_base, base, &o.zone).ok_or_else(|| refuse(&text).at(call.span(2), ""))?,
    };
    Ok(Value::from(seconds))
}

fn to_seconds(time: DateTime, zone: &TimeZone) -> Option<i64> {
    zone.to_ambiguous_timestamp(time).compatible().ok().map(Timestamp::as_second)
}

impl Fields {
    /// The time in seconds. `midnight`: a date without a time of day means its start.
    fn resolve(self, base: DateTime, zone: &TimeZone, midnight: bool) -> Option<i64> {
        if let Some(seconds) = self.seconds {
            return Some(seconds);
        }
        let date = match (self.day_of_year, self.month, self.day) {
            (Some(day), ..) => {
                let first = Date::new(self.year.unwrap_or_else(|| base.year()), 1, 1).ok()?;
                first.checked_add((i64::from(day) - 1).days()).ok()?
            }
            (None, None, None) if self.year.is_none() => base.date(),
            (None, month, day) => {
                let year = self.year.unwrap_or_else(|| base.year());
                Date::new(year, month.unwrap_or(1), day.unwrap_or(1)).ok()?
            }
        };
        let hour = match (self.hour, self.pm) {
            (Some(hour), Some(pm)) => hour % 12 + if pm { 12 } else { 0 },
            (Some(hour), None) => hour,
            (None, _) if midnight => 0,
            (None, _) => base.hour(),
        };
        let time = date.to_datetime(Time::new(hour, self.minute, self.second.min(59), 0).ok()?);
        to_seconds(time, self.zone.as_ref().unwrap_or(zone))
    }
}

/// A number of at most so many digits at the start of a text.
fn number<'t>(text: &mut &'t str, most: usize) -> Option<i64> {
    let rest: &'t str = text.trim_start_matches(' ');
    let length = rest.bytes().take(most).take_while(u8::is_ascii_digit).count();
    let value = rest.get(..length)?.parse().ok()?;
    *text = &rest[length..];
    Some(value)
}

/// One of some names, or its first three letters.
fn name(text: &mut &str, names: &[&str]) -> Option<i8> {
    let lower = text.to_ascii_lowercase();
    let found = names.iter().position(|n| lower.starts_with(&n.to_ascii_lowercase()[..3]))?;
    let full = names.get(found)?.to_ascii_lowercase();
    let length = if lower.starts_with(&full) { full.len() } else { 3 };
    *text = text.get(length..)?;
    i8::try_from(found).ok()
}

/// Years of two digits are those from 1938 to 2037.
fn full_year(short: i64) -> i16 {
    (if short < 38 { 2000 + short } else { 1900 + short }) as i16
}

fn by_format(text: &str, format: &str) -> Result<Fields, Exception> {
    let mut fields = Fields::default();
    let mut rest = text.trim();
    let expanded =
        format.replace("%D", "%m/%d/%Y").replace("%T", "%H:%M:%S").replace("%R", "%H:%M").replace("%r", "%I:%M:%S %p");
    let mut letters = expanded.trim().chars();
    while let Some(c) = letters.next() {
        if c.is_whitespace() {
            rest = rest.trim_start();
            continue;
        }
        if c != '%' {
            rest = rest.strip_prefix(c).ok_or_else(no_match)?;
            continue;
        }
        field(&mut fields, letters.next(), &mut rest).ok_or_else(no_match)?;
    }
    if rest.trim().is_empty() { Ok(fields) } else { Err(no_match()) }
}

/// Read one field of a format.
fn field(fields: &mut Fields, letter: Option<char>, rest: &mut &str) -> Option<()> {
    let small = |n: i64| i8::try_from(n).ok();
    match letter? {
        'Y' => fields.year = i16::try_from(number(rest, 4)?).ok(),
        'y' => fields.year = Some(full_year(number(rest, 2)?)),
        'm' | 'N' => fields.month = small(number(rest, 2)?),
        'd' | 'e' => fields.day = small(number(rest, 2)?),
        'j' => fields.day_of_year = i16::try_from(number(rest, 3)?).ok(),
        'H' | 'k' | 'I' | 'l' => fields.hour = small(number(rest, 2)?),
        'M' => fields.minute = small(number(rest, 2)?)?,
        'S' => fields.second = small(number(rest, 2)?)?,
        'b' | 'B' | 'h' => fields.month = name(rest, &MONTHS).map(|m| m + 1),
        'a' | 'A' => {
            name(rest, &DAYS)?;
        }
        'p' | 'P' => {
            fields.pm = Some(rest.get(..1)?.eq_ignore_ascii_case("p"));
            *rest = rest.get(2..)?;
        }
        's' => {
            let negative = rest.starts_with('-');
            *rest = rest.strip_prefix('-').unwrap_or(rest);
            let seconds = number(rest, 18)?;
            fields.seconds = Some(if negative { -seconds } else { seconds });
        }
        'z' | 'Z' => {
            let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
            fields.zone = Some(zone_named(&rest[..length]).ok()?);
            *rest = &rest[length..];
        }
        '%' => *rest = rest.strip_prefix('%')?,
        _ => return None,
    }
    Some(())
}

/// The usual ways to write a time: `2024-05-31 12:00:00`, `20240531T120000`, `5/31/2024`, `31 May 2024`, `tomorrow`.
fn free_form(text: &str, base: DateTime, base_seconds: i64, zone: &TimeZone) -> Option<i64> {
    let mut fields = Fields::default();
    let mut shift = Span::new();
    let mut dated = false;
    let spaced = match text.split_once('T') {
        Some((date, time)) if date.len() == 8 && date.bytes().all(|b| b.is_ascii_digit()) => format!("{date} {time}"),
        Some((date, time)) if date.contains('-') && time.starts_with(|c: char| c.is_ascii_digit()) => {
            format!("{date} {time}")
        }
        _ => text.to_owned(),
    };
    let words: Vec<String> = spaced.replace(',', " ").split_whitespace().map(str::to_lowercase).collect();
    let mut words = words.iter().map(String::as_str).peekable();
    while let Some(word) = words.next() {
        if word.contains(':') {
            time_of_day(word, &mut fields)?;
            continue;
        }
        if let Some(seconds) = numeric_zone(word).filter(|_| fields.hour.is_some()) {
            fields.zone = Some(TimeZone::fixed(jiff::tz::Offset::from_seconds(seconds).ok()?));
            continue;
        }
        if let Some(unit) = words.peek().and_then(|u| unit_of(u))
            && let Ok(count) = word.parse::<i64>()
        {
            words.next();
            let ago = words.next_if(|w| *w == "ago").is_some();
            let count = if ago { count.checked_neg()? } else { count };
            shift = add_unit(shift, count, unit)?;
            continue;
        }
        match word {
            "now" | "today" => {}
            "tomorrow" => shift = add_unit(shift, 1, "day")?,
            "yesterday" => shift = add_unit(shift, -1, "day")?,
            "am" => fields.pm = Some(false),
            "pm" => fields.pm = Some(true),
            "gmt" | "utc" | "z" => fields.zone = Some(TimeZone::UTC),
            _ => {
                date_word(word, &mut fields)?;
                dated = true;
            }
        }
    }
    let timed = fields.hour.is_some();
    let used = fields.zone.clone().unwrap_or_else(|| zone.clone());
    let start = if dated || timed { fields.resolve(base, zone, true)? } else { base_seconds };
    let shifted = local(start, &used).ok()?.time.checked_add(shift).ok()?;
    to_seconds(shifted, &used)
}

fn time_of_day(word: &str, fields: &mut Fields) -> Option<()> {
    let (word, pm) = match (word.strip_suffix("am"), word.strip_suffix("pm")) {
        (Some(w), _) => (w, Some(false)),
        (_, Some(w)) => (w, Some(true)),
        _ => (word, fields.pm),
    };
    let mut parts = word.split(':');
    fields.hour = Some(parts.next()?.parse().ok()?);
    fields.minute = parts.next()?.parse().ok()?;
    fields.second = parts.next().map_or(Some(0), |s| s.parse().ok())?;
    fields.pm = pm;
    Some(())
}

fn date_word(word: &str, fields: &mut Fields) -> Option<()> {
    let numbers = |separator: char| -> Vec<Option<i64>> { word.split(separator).map(|p| p.parse().ok()).collect() };
    let year = |y: i64, digits: usize| if digits <= 2 { Some(full_year(y)) } else { i16::try_from(y).ok() };
    if let [Some(y), Some(m), Some(d)] = numbers('-')[..] {
        (fields.year, fields.month, fields.day) = (i16::try_from(y).ok(), i8::try_from(m).ok(), i8::try_from(d).ok());
        return Some(());
    }
    match numbers('/')[..] {
        [Some(m), Some(d), Some(y)] => {
            (fields.month, fields.day) = (i8::try_from(m).ok(), i8::try_from(d).ok());
            fields.year = year(y, word.rsplit('/').next()?.len());
            return Some(());
        }
        [Some(m), Some(d)] => {
            (fields.month, fields.day) = (i8::try_from(m).ok(), i8::try_from(d).ok());
            return Some(());
        }
        _ => {}
    }
    if let Ok(n) = word.parse::<i64>() {
        match word.len() {
            8 => {
                (fields.year, fields.month) = (i16::try_from(n / 10_000).ok(), i8::try_from(n / 100 % 100).ok());
                fields.day = i8::try_from(n % 100).ok();
            }
            6 if fields.year.is_some() => {
                fields.hour = i8::try_from(n / 10_000).ok();
                (fields.minute, fields.second) = (i8::try_from(n / 100 % 100).ok()?, i8::try_from(n % 100).ok()?);
            }
            1 | 2 if fields.day.is_none() => fields.day = i8::try_from(n).ok(),
            4 => fields.year = i16::try_from(n).ok(),
            _ => return None,
        }
        return Some(());
    }
    if !word.bytes().all(|b| b.is_ascii_alphabetic() || b == b'.') || word.len() < 3 {
        return None;
    }
    let mut rest = word;
    match name(&mut rest, &MONTHS) {
        Some(month) => fields.month = Some(month + 1),
        None => {
            name(&mut rest, &DAYS)?;
        }
    }
    Some(())
}

fn unit_of(word: &str) -> Option<&'static str> {
    let bare = word.strip_suffix('s').unwrap_or(word);
    let units = ["second", "minute", "hour", "day", "week", "fortnight", "month", "year", "sec", "min"];
    let found = units.iter().find(|u| **u == bare)?;
    Some(match *found {
        "sec" => "second",
        "min" => "minute",
        other => other,
    })
}

fn add_unit(span: Span, count: i64, unit: &str) -> Option<Span> {
    let total = |have: i64, each: i64| count.checked_mul(each)?.checked_add(have);
    match unit {
        "second" => span.try_seconds(total(span.get_seconds(), 1)?),
        "minute" => span.try_minutes(total(span.get_minutes(), 1)?),
        "hour" => span.try_hours(total(span.get_hours().into(), 1)?),
        "day" => span.try_days(total(span.get_days().into(), 1)?),
        "week" => span.try_days(total(span.get_days().into(), 7)?),
        "fortnight" => span.try_days(total(span.get_days().into(), 14)?),
        "month" => span.try_months(total(span.get_months().into(), 1)?),
        _ => span.try_years(total(span.get_years().into(), 1)?),
    }
    .ok()
}

pub(super) fn add(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "clock add clockval ?number units?... ?-gmt boolean? ?-locale LOCALE? ?-timezone ZONE?";
    call.expect(3.., "clock add clockval ?arg ...?")?;
    if call.len().is_multiple_of(2) {
        return Err(wrong_args(call, usage));
    }
    let mut seconds = call.arg(2).to_i64()?;
    let is_option = |i: usize| {
        let word = call.arg(i).as_str();
        word.starts_with('-') && !word[1..].starts_with(|c: char| c.is_ascii_digit())
    };
    let first_option = (3..call.len()).step_by(2).find(|i| is_option(*i)).unwrap_or(call.len());
    let o = options(call, first_option, &["-gmt", "-locale", "-timezone"])?;
    for i in (3..first_option).step_by(2) {
        let count = call.arg(i).to_i64()?;
        let word = call.arg(i + 1).as_str();
        let Some(unit) = unit_of(&word) else {
            let list = "years, months, weeks, days, hours, minutes or seconds";
            let message = format!("unknown unit \"{word}\", must be  {list}");
            return Err(Exception::coded(message, &["CLOCK", "badUnit", &word]).at(call.span(i + 1), ""));
        };
        let fixed = match unit {
            "second" => Some(1),
            "minute" => Some(60),
            "hour" => Some(3600),
            _ => None,
        };
        let too_large = || Exception::coded("integer value too large to represent", &["CLOCK", "dateTooLarge"]);
        seconds = match fixed {
            Some(length) => count.checked_mul(length).and_then(|s| seconds.checked_add(s)).ok_or_else(too_large)?,
            None => {
                let span = add_unit(Span::new(), count, unit).ok_or_else(too_large)?;
                let moved = local(seconds, &o.zone)?.time.checked_add(span).map_err(|_| too_large())?;
                to_seconds(moved, &o.zone).ok_or_else(too_large)?
            }
        };
    }
    Ok(Value::from(seconds))
}
