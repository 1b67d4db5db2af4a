//! Heads of columns: names, units, which of them is the time.

use crate::unit::{self, Quantity, Unit};

/// Names of a column of times, in the languages of recorders.
const TIME_NAMES: &[&str] =
    &["time", "t", "zeit", "temps", "tiempo", "tempo", "times", "x_value", "elapsed time", "running time"];

/// Name and unit of `name[unit]` or `name(unit)`. Round brackets count as those of a unit only if it is known: they may
/// be a part of the name.
pub fn name_and_unit(cell: &str) -> (String, String) {
    let cell = cell.trim();
    let split = |open: char, close: char| cell.strip_suffix(close).and_then(|c| c.rsplit_once(open));
    let is_unit = |(name, text): &(&str, &str)| {
        let unit = unit::header_unit(text).filter(|_| !text.trim().starts_with(|c: char| c.is_ascii_digit()));
        // `Acc (N)` is an acceleration towards the north.
        unit.is_some_and(|u| quantity_of_name(name).is_none_or(|q| q == u.quantity || u.quantity == Quantity::Ratio))
    };
    let parts = split('[', ']').or_else(|| split('(', ')').filter(is_unit));
    let (name, unit) = parts.unwrap_or((cell, ""));
    (name.trim().to_owned(), unit.trim().to_owned())
}

/// Name and known unit of a head in any spelling: `acc[g]`, `acc (g)`, `acc_g`, `time_ms`, `Force, kN`.
///
/// A suffix is no unit if the name says another quantity: `acc_m` is a channel m of accelerations.
pub fn known_unit(cell: &str) -> (String, Option<Unit>) {
    let (name, bracketed) = name_and_unit(cell);
    if !bracketed.is_empty() {
        return (name, unit::header_unit(&bracketed));
    }
    let suffix = ['_', ',', '/'].into_iter().find_map(|sign| {
        let at = if sign == '/' { cell.find(" / ").map(|i| i + 1) } else { cell.rfind(sign) }?;
        let (name, word) = (cell[..at].trim(), cell[at + 1..].trim());
        let found = unit::unit(word).filter(|u| u.quantity != Quantity::Ratio)?;
        let said = quantity_of_name(name);
        said.is_none_or(|q| q == found.quantity).then(|| (name.to_owned(), found))
    });
    match suffix {
        Some((name, unit)) if !name.is_empty() => (name, Some(unit)),
        _ => (cell.trim().to_owned(), None),
    }
}

/// The quantity that a name says.
pub(crate) fn quantity_of_name(name: &str) -> Option<Quantity> {
    if is_time_name(name) { Some(Quantity::Time) } else { Quantity::of_head(name) }
}

fn is_time_name(name: &str) -> bool {
    TIME_NAMES.contains(&name.trim().to_lowercase().as_str())
}

/// A name whose first or last word is that of a time: `Total Time`, `Time 1 - default sample rate`.
fn has_time_name(name: &str) -> bool {
    let lower = name.trim().to_lowercase();
    let mut words = lower.split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty());
    let (first, last) = (words.next().unwrap_or_default(), words.next_back());
    let is = |w: &str| w.len() > 1 && TIME_NAMES.contains(&w);
    is(first) || last.is_some_and(is)
}

/// The unit of the time column of a head and of the unit below it: a longer name needs a unit of time.
pub(crate) fn time_column(cell: &str, below: &str) -> Option<Unit> {
    if below.is_empty() {
        let (name, unit) = name_and_unit(cell);
        let longer = || time_unit(&unit).filter(|_| !unit.is_empty() && has_time_name(&name));
        return time_head(cell).or_else(longer);
    }
    let is_time = time_head(cell).is_some() || has_time_name(&name_and_unit(cell).0);
    time_unit(below).filter(|_| is_time)
}

/// The unit of a time, by its name in any case; seconds without a name.
pub(crate) fn time_unit(name: &str) -> Option<Unit> {
    let name = if name.is_empty() { "s".into() } else { name.to_lowercase() };
    unit::header_unit(&name).filter(|u| u.quantity == Quantity::Time)
}

/// The unit of the time column if a cell is the head of one: `time[s]`, `Time (ms)`, `time_min`, `t`.
pub(crate) fn time_head(cell: &str) -> Option<Unit> {
    let (name, unit) = name_and_unit(cell);
    if is_time_name(&name) {
        return time_unit(&unit);
    }
    let (name, unit) = known_unit(cell);
    unit.filter(|u| u.quantity == Quantity::Time && is_time_name(&name))
}

/// A time in seconds. A multiple of 1 ms is divided by 1000, so that 20 ms is 0.02 s to the last bit.
pub(crate) fn seconds(time: f64, unit: &Unit) -> f64 {
    if unit.factor == 1.0 {
        time
    } else if unit.factor < 1.0 {
        time / (1.0 / unit.factor).round()
    } else {
        time * unit.factor
    }
}

/// Units in the row below the header, as `s,kN,mm` or `[s],[kN],[mm]`. `None` if the row is no such row.
pub(crate) fn units_row<'a>(cells: impl Iterator<Item = &'a str>) -> Option<Vec<String>> {
    let bare = |cell: &'a str| {
        let inside = |open, close| cell.strip_prefix(open).and_then(|c: &str| c.strip_suffix(close));
        inside('[', ']').or_else(|| inside('(', ')')).unwrap_or(cell).trim()
    };
    let units: Vec<&str> = cells.map(|c| bare(c.trim())).collect();
    let (first, others) = units.split_first()?;
    let is_text = |u: &&str| u.parse::<f64>().is_err();
    let known = |u: &&str| u.is_empty() || (unit::header_unit(u).is_some() && is_text(u));
    let is_time = if first.is_empty() {
        others.iter().any(|u| !u.is_empty()) && others.iter().all(known)
    } else {
        time_unit(first).is_some() || units.iter().all(known)
    };
    (is_time && others.iter().all(is_text)).then(|| units.iter().map(|u| (*u).to_owned()).collect())
}

#[cfg(test)]
mod tests {
    use super::{known_unit, name_and_unit, seconds, time_column, time_head, units_row};

    #[test]
    fn heads_are_split_into_name_and_unit() {
        for (cell, name, unit) in [
            ("force[kN]", "force", "kN"),
            ("force (kN)", "force", "kN"),
            ("Load(Linear:Load) (kN)", "Load(Linear:Load)", "kN"),
            ("acc [m/s²]", "acc", "m/s²"),
            ("disp(2)", "disp(2)", ""),
            ("strain (left)", "strain (left)", ""),
            ("voltage[V]", "voltage", "V"),
            ("plain", "plain", ""),
            ("T (S)", "T", "S"),
            ("Acc (N)", "Acc (N)", ""),
        ] {
            assert_eq!(name_and_unit(cell), (name.to_owned(), unit.to_owned()), "{cell}");
        }
    }

    #[test]
    fn units_in_any_spelling() {
        for (cell, name, unit) in [
            ("acc_g", "acc", Some("g")),
            ("vel_m/s", "vel", Some("m/s")),
            ("acc_m", "acc_m", None),
            ("time_ms", "time", Some("ms")),
            ("Force, kN", "Force", Some("kN")),
            ("Kraft / kN", "Kraft", Some("kN")),
            ("channel_1", "channel_1", None),
            ("Acceleration [G]", "Acceleration", Some("g")),
            ("sensor[V]", "sensor", None),
        ] {
            let (n, u) = known_unit(cell);
            assert_eq!((n.as_str(), u.map(|u| u.name)), (name, unit), "{cell}");
        }
    }

    #[test]
    fn heads_of_the_time_have_a_unit_of_time() {
        for (cell, name) in [
            ("time[s]", "s"),
            ("Time (ms)", "ms"),
            ("t", "s"),
            ("T [Sec]", "s"),
            ("TIME[min]", "min"),
            ("time_min", "min"),
            ("time[seconds]", "s"),
            ("Zeit[s]", "s"),
        ] {
            assert_eq!(time_head(cell).map(|u| u.name), Some(name), "{cell}");
        }
        assert!(["force", "time[kN]", "", "x[s]", "timer"].iter().all(|c| time_head(c).is_none()));
        let ms = time_head("t[ms]").expect("a time");
        assert_eq!((seconds(20.0, &ms), seconds(26.0, &ms)), (0.02, 0.026));
    }

    #[test]
    fn longer_names_of_times_need_a_unit_of_time() {
        let unit = |cell, below| time_column(cell, below).map(|u| u.name);
        assert_eq!((unit("Total Time (s)", ""), unit("Time 1 - default rate", "ms")), (Some("s"), Some("ms")));
        assert_eq!((unit("Total Time", ""), unit("Total Time", "mm"), unit("timer (s)", "")), (None, None, None));
    }

    #[test]
    fn rows_of_units_are_told_from_rows_of_numbers() {
        assert_eq!(
            units_row(["[s]", "(kN)", "mm"].into_iter()).as_deref(),
            Some(&["s", "kN", "mm"].map(String::from)[..])
        );
        assert!(units_row(["", "kN"].into_iter()).is_some());
        assert!(units_row(["kN", "mm"].into_iter()).is_some());
        for row in [&["0.0", "1"][..], &["s", "1"], &["", ""], &["", "x"], &["kN", "left"]] {
            assert!(units_row(row.iter().copied()).is_none(), "{row:?}");
        }
    }
}
