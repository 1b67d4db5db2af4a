//! Dates and times of day in cells.

/// A date, a time of day, or both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stamp {
    /// Days since 1970-01-01, where there is a date whose order of day and month is sure.
    pub(crate) days: Option<i64>,
    /// A date of which day and month may be exchanged, as it is written.
    pub(crate) unsure_date: Option<[i64; 3]>,
    /// Nanoseconds since midnight, where there is a time.
    pub(crate) nanoseconds: Option<i64>,
}

/// Days of a date since 1970-01-01 in the Gregorian calendar.
///
/// Source: Hinnant, chrono-compatible low-level date algorithms, `days_from_civil`.
pub(crate) fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) || !(1900..=2200).contains(&year) {
        return None;
    }
    let y = if month <= 2 { year - 1 } else { year };
    let era = y.div_euclid(400);
    let year_of_era = y - era * 400;
    let day_of_year = (153 * (month + if month > 2 { -3 } else { 9 }) + 2) / 5 + day - 1;
    Some(era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719_468)
}

/// Year, month and day of days since 1970-01-01. Source: Hinnant, `civil_from_days`.
pub(crate) fn civil(days: i64) -> (i64, i64, i64) {
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let day_of_era = z - era * 146_097;
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let mp = (5 * day_of_year + 2) / 153;
    let month = if mp < 10 { mp + 3 } else { mp - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    (year, month, day_of_year - (153 * mp + 2) / 5 + 1)
}

/// Nanoseconds of `h:m`, `h:m:s` or `h:m:s.f`, where the decimal sign may be a comma.
fn time_of_day(text: &str) -> Option<i64> {
    let (text, noon) = match text.to_ascii_lowercase() {
        t if t.ends_with("am") => (t[..t.len() - 2].trim_end().to_owned(), Some(0)),
        t if t.ends_with("pm") => (t[..t.len() - 2].trim_end().to_owned(), Some(12)),
        t => (t.trim_end_matches('z').to_owned(), None),
    };
    let mut parts = text.split(':');
    let hour: i64 = parts.next().and_then(two_digits)?;
    let minute: i64 = parts.next().and_then(two_digits)?;
    let seconds = parts.next().unwrap_or("0");
    let (whole, fraction) = seconds.split_once(['.', ',']).unwrap_or((seconds, ""));
    let second = two_digits(whole)?;
    if parts.next().is_some() || fraction.len() > 9 || !fraction.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let hour = match noon {
        Some(offset) if (1..=12).contains(&hour) => hour % 12 + offset,
        Some(_) => return None,
        None => hour,
    };
    if hour > 24 || minute > 59 || second > 60 {
        return None;
    }
    let fraction: i64 = format!("{fraction:0<9}").parse().ok()?;
    Some(((hour * 60 + minute) * 60 + second) * 1_000_000_000 + fraction)
}

fn two_digits(text: &str) -> Option<i64> {
    let text = text.trim();
    ((1..=2).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

/// The date or time of a cell: `2024-01-31T10:00:00.010`, `31.01.2024 10:00`, `10:00:00,010`, `1/31/2024`.
pub(crate) fn parse(text: &str) -> Option<Stamp> {
    // Most cells are numbers: they have none of these.
    if !text.as_bytes().get(1..)?.iter().any(|b| matches!(b, b':' | b'-' | b'/' | b'.')) || !text.is_ascii() {
        return None;
    }
    if !text.contains(':') && text.matches(['-', '/', '.']).count() != 2 {
        return None;
    }
    let (first, rest) = match text.split_once(['T', ' ']) {
        Some((a, b)) if !a.contains(':') => (a, Some(b.trim())),
        _ => (text, None),
    };
    if first.contains(':') {
        let nanoseconds = Some(time_of_day(text)?);
        return Some(Stamp { days: None, unsure_date: None, nanoseconds });
    }
    let sign = ['-', '/', '.'].into_iter().find(|s| first.matches(*s).count() == 2)?;
    let parts: Vec<i64> = first.split(sign).map(|p| p.parse().ok()).collect::<Option<_>>()?;
    let [a, b, c] = parts[..] else { return None };
    let year_first = first.split(sign).next().is_some_and(|p| p.len() == 4);
    let (days, unsure_date) = match (year_first, sign) {
        (true, _) => (Some(days(a, b, c)?), None),
        (false, '.') => (Some(days(c, b, a)?), None),
        _ => {
            days(c, a, b).or_else(|| days(c, b, a))?;
            (None, Some([a, b, c]))
        }
    };
    let nanoseconds = match rest {
        Some(time) => Some(time_of_day(time)?),
        None => None,
    };
    Some(Stamp { days, unsure_date, nanoseconds })
}

/// Nanoseconds from one stamp to another. `None` if one has a part that the other has not, or the date is not sure.
pub(crate) fn between(from: &Stamp, to: &Stamp) -> Option<i64> {
    const DAY: i64 = 86_400_000_000_000;
    let days = match (from.days, to.days) {
        (Some(a), Some(b)) => b - a,
        (None, None) if from.unsure_date == to.unsure_date => 0,
        _ => return None,
    };
    let nanoseconds = match (from.nanoseconds, to.nanoseconds) {
        (Some(a), Some(b)) => b - a,
        (None, None) => 0,
        _ => return None,
    };
    days.checked_mul(DAY)?.checked_add(nanoseconds)
}

#[cfg(test)]
mod tests {
    use super::{between, civil, parse};

    #[test]
    fn stamps_are_apart_by_exact_times() {
        for (a, b, apart) in [
            ("2024-01-01T00:00:00.000", "2024-01-01T00:00:00.010", 10_000_000),
            ("2024-02-28 23:59:59.5", "2024-02-29 00:00:00", 500_000_000),
            ("31.12.2023 23:59:59,000", "01.01.2024 00:00:00,250", 1_250_000_000),
            ("10:00:00", "10:00:01.5", 1_500_000_000),
            ("3/4/2024 11:59:59 AM", "3/4/2024 12:00:00 PM", 1_000_000_000),
        ] {
            let stamp = |t| parse(t).expect(t);
            assert_eq!(between(&stamp(a), &stamp(b)), Some(apart), "{a} {b}");
        }
        for days in [-20_000, -1, 0, 59, 60, 19_782, 30_000] {
            let (y, m, d) = civil(days);
            assert_eq!(super::days(y, m, d), Some(days));
        }
        // Another date whose order of day and month is not sure.
        let stamp = |t| parse(t).expect(t);
        assert_eq!(between(&stamp("3/4/2024 23:59:59"), &stamp("3/5/2024 00:00:00")), None);
        for no in ["1.5", "-1.5", "1.5e-3", "1-2", "a:b", "1:2:3:4", "13.45", "99/99/2024", "x", "1.2.3", ""] {
            assert!(parse(no).is_none(), "{no}");
        }
    }
}
