//! Every format: a known series is written with spellings by chance, and is read back or refused; files that are changed by
//! chance are read rightly, refused, or read with a note.

#![allow(clippy::print_stdout, clippy::unwrap_used, unreachable_pub)]

mod support;

use hysteron_recordings::unit::{Quantity, unit};
use hysteron_recordings::{Clock, FORMATS, Series, UserStatements};
use support::{File, Known, Random, WRITERS};

/// Formats that state no unit or no step, so that the test says them.
fn told(format: &str, k: &Known) -> UserStatements {
    let unit = matches!(format, "NumPy" | "MATLAB" | "SAC" | "miniSEED" | "Tcl list" | "counted list")
        .then(|| k.unit.to_owned());
    UserStatements { unit, dt: (format == "NumPy").then_some(k.dt), ..UserStatements::default() }
}

/// Values in SI units and the step of the channel of a quantity.
fn channel<'a>(all: &'a [Series], k: &Known, told: &UserStatements) -> Option<(Vec<f64>, f64, &'a Series)> {
    let known = unit(k.unit).expect("a unit");
    let s = all
        .iter()
        .find(|s| s.quantity == Some(known.quantity))
        .or_else(|| all.first().filter(|s| s.quantity.is_none()))?;
    let u = s.unit.or_else(|| told.unit.as_deref().and_then(unit))?;
    Some((s.values.iter().map(|x| u.factor * x).collect(), s.clock.dt()?, s))
}

/// Half of the last digit of the formats that write fewer than seven, as a share of the peak.
fn tolerance(format: &str) -> f64 {
    // GeoNet: two decimals in eight characters.
    if format == "GeoNet" { 3e-6 } else { 1e-6 }
}

#[test]
fn a_known_series_is_read_back_in_every_format() {
    let mut random = Random(1);
    for (format, write) in WRITERS {
        let mut read = 0;
        for _ in 0..60 {
            let k = Known::new(&mut random, 200);
            let Some(file) = write(&k, &mut random) else { continue };
            let bytes = &file.bytes;
            let shown = || String::from_utf8_lossy(&bytes[..bytes.len().min(600)]).into_owned();
            let m = file.read(bytes).unwrap_or_else(|e| panic!("{format}: {e}\n{}", shown()));
            assert_eq!(m.format.name, *format, "{}", shown());
            let told = told(format, &k);
            let all = m.series(&told).unwrap_or_else(|e| panic!("{format}: {e}\n{}", shown()));
            let (values, dt, s) = channel(&all, &k, &told).unwrap_or_else(|| panic!("{format}: {all:?}\n{}", shown()));
            let factor = unit(k.unit).expect("a unit").factor;
            let peak = factor * k.values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            assert_eq!(values.len(), k.values.len(), "{format}\n{}", shown());
            for (a, b) in values.iter().zip(&k.values) {
                assert!(
                    (a - factor * b).abs() <= tolerance(format) * peak,
                    "{format}: {a} for {}\n{}",
                    factor * b,
                    shown()
                );
            }
            assert!((dt / k.dt - 1.0).abs() < 1e-6, "{format}: dt {dt} for {}\n{}", k.dt, shown());
            assert!(s.origin.bytes.end <= bytes.len().max(m_text_len(bytes)), "{format}: {:?}", s.origin);
            read += 1;
        }
        assert!(read >= 10, "{format}: only {read} files");
    }
}

/// Origins of compressed files are those of the unpacked text.
fn m_text_len(bytes: &[u8]) -> usize {
    64 * bytes.len()
}

#[test]
fn every_format_has_a_writer() {
    for f in FORMATS {
        assert!(WRITERS.iter().any(|(name, _)| *name == f.name), "{} has none", f.name);
        assert!(!f.recognised_by.is_empty() && !f.states.is_empty() && !f.description.is_empty());
    }
}

/// A file with one change by chance in its data, or anywhere.
fn mutated(file: &File, everywhere: bool, random: &mut Random) -> Vec<u8> {
    let mut bytes = file.bytes.clone();
    let from = if everywhere { 0 } else { file.data };
    if from >= bytes.len() {
        return bytes;
    }
    let at = from + random.below(bytes.len() - from);
    match random.below(6) {
        0 => bytes[at] = random.of(b"0123456789.,-+eEx \t\n;#\"{}\\\xff\x00"),
        1 => {
            bytes.remove(at);
        }
        2 => bytes.insert(at, random.of(b"0123456789.,-+eEx \t\n;#\"{}\\\xff\x00")),
        3 => bytes.truncate(at),
        4 => {
            // A line is doubled.
            let start = bytes[..at].iter().rposition(|b| *b == b'\n').map_or(from, |i| i + 1).max(from);
            let end = bytes[at..].iter().position(|b| *b == b'\n').map_or(bytes.len(), |i| at + i + 1);
            let line = bytes[start..end].to_vec();
            bytes.splice(start..start, line);
        }
        _ => {
            let word = random.of(&["nan", "page break", "1e999", "--", "inf", "\n\n", "1.2.3"]);
            bytes.splice(at..at, word.bytes());
        }
    }
    bytes
}

/// Samples that differ by more than the last digits from those that were written.
fn changed(values: &[f64], k: &Known) -> usize {
    let factor = unit(k.unit).expect("a unit").factor;
    let peak = factor * k.values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    values.iter().zip(&k.values).filter(|(a, b)| (**a - factor * **b).abs() > 1e-5 * peak || a.is_nan()).count()
}

/// Counts of files that were read, read with a note, and refused.
fn mutations(count: usize, seed: u64) -> [usize; 3] {
    let mut random = Random(seed);
    let mut outcome = [0; 3];
    for i in 0..count {
        let (format, write) = WRITERS[i % WRITERS.len()];
        let k = Known::of("cm/s2", 294.0, 0.01, 120);
        let Some(file) = write(&k, &mut random) else { continue };
        let everywhere = random.below(3) == 0;
        let bytes = mutated(&file, everywhere, &mut random);
        let told = told(format, &k);
        let shown = || format!("{format}\n{}", String::from_utf8_lossy(&bytes));
        let read = file.read(&bytes).and_then(|m| m.accelerations(&told, false).map(|c| (c, m)));
        let Ok((channels, m)) = read else {
            outcome[2] += 1;
            continue;
        };
        let noted = !m.notes.is_empty() || !channels.notes.is_empty();
        outcome[usize::from(noted)] += 1;
        assert!(channels.channels.iter().all(|c| c.values.iter().all(|x| x.is_finite())), "{}", shown());
        if everywhere || noted || m.format.name != format {
            continue;
        }
        // The data alone were changed, and nothing is said about it: quantity, unit and step are as written. One sample may
        // be another number; a sample more or less is one that the change has made or removed.
        let c = &channels.channels[0];
        assert_eq!(c.unit.quantity, Quantity::Acceleration, "{}", shown());
        assert!((c.dt / k.dt - 1.0).abs() < 1e-3, "{} {}", c.dt, shown());
        let binary = matches!(format, "NumPy" | "MATLAB" | "SAC" | "miniSEED" | "xlsx" | "ods");
        let lines = bytes[file.data.min(bytes.len())..].iter().filter(|b| **b == b'\n').count();
        match c.values.len() {
            n if n == k.values.len() => {
                assert!(
                    changed(&c.values, &k) <= 8 || binary,
                    "{} samples changed\n{}",
                    changed(&c.values, &k),
                    shown()
                );
            }
            // Tables and lists have no count: their rows are those of the file.
            n => assert!(
                matches!(format, "table" | "MTS" | "SeismoSignal" | "Tcl list" | "JSON")
                    && n <= lines.max(n.min(121)) + 9,
                "{n} samples\n{}",
                shown()
            ),
        }
        assert!(matches!(c.series.clock, Clock::Steps { .. }));
    }
    outcome
}

/// `MUTATIONS=10000` makes more.
#[test]
fn changed_files_are_read_rightly_or_refused() {
    let count = std::env::var("MUTATIONS").ok().and_then(|n| n.parse().ok()).unwrap_or(400);
    let [read, noted, refused] = mutations(count, 7);
    println!("{count} files: {read} read, {noted} with a note, {refused} refused");
    assert!(read + noted + refused > count / 2 && refused > count / 10);
}
