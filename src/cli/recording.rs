//! `hysteron recording`: what a measured file holds; conversions and other forms of it.

use super::files::write_atomically;
use clap::Args;
use hysteron::number_format::without_round_off;
use hysteron::opensees::files::write_whole;
use hysteron::recordings::check::doubts;
use hysteron::recordings::convert::{Baseline, derivative, integral, turned};
use hysteron::recordings::export::{NamedColumn, csv, npz, path_file};
use hysteron::recordings::series::find_channel;
use hysteron::recordings::unit::{self, Quantity, Unit};
use hysteron::recordings::user_statements::unit_of;
use hysteron::recordings::{Clock, Layout, Measured, Series, UserStatements, Way};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Statements of the user about files that do not make them.
#[derive(Args, Clone, Debug)]
pub(super) struct ToldArgs {
    /// Unit of the values of files that do not give one (g, m/s2, cm/s2, in/s2)
    #[arg(long, value_name = "UNIT")]
    unit: Option<String>,
    /// Step of time in s of files that do not give one
    #[arg(long, value_name = "S")]
    dt: Option<f64>,
    /// Quantity of files that do not give one: acceleration, velocity, displacement, force
    #[arg(long, value_name = "NAME")]
    quantity: Option<String>,
    /// What the numbers in a row without names are: columns for channels, wrapped for one channel
    #[arg(long, value_name = "WORD")]
    layout: Option<String>,
    /// Take these channels alone, by name, direction or number from 1
    #[arg(long = "channel", value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    channels: Vec<String>,
}

impl ToldArgs {
    /// What is said.
    pub(super) fn told(&self) -> Result<UserStatements, String> {
        if self.dt.is_some_and(|dt| dt <= 0.0 || !dt.is_finite()) {
            return Err("--dt: expected more than 0".into());
        }
        let layout = self.layout.as_deref().map(Layout::named).transpose()?;
        let (unit, quantity) = (self.unit.clone(), self.quantity.clone());
        Ok(UserStatements { unit, dt: self.dt, quantity, layout, way: Way::CommandLine })
    }

    /// Channels that are wanted; empty for all.
    pub(super) fn channels(&self) -> &[String] {
        &self.channels
    }
}

/// A file, and what becomes of it.
#[derive(Args, Debug)]
pub(super) struct RecordingArgs {
    /// The file: ground motions, tests, sensors, tables; compressed by gzip or not
    #[arg(required_unless_present = "formats")]
    file: Option<PathBuf>,
    #[command(flatten)]
    told: ToldArgs,
    /// Remove this from each channel before other conversions: mean, or line (of least squares)
    #[arg(long, value_name = "WORD")]
    baseline: Option<String>,
    /// Differentiate by central differences
    #[arg(long, conflicts_with = "integrate")]
    differentiate: bool,
    /// Integrate from 0 by the trapezoidal rule
    #[arg(long)]
    integrate: bool,
    /// Multiply the values by this before other conversions, for instance by the sensitivity of an instrument
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    factor: Option<f64>,
    /// Change the sign of the values
    #[arg(long)]
    reverse: bool,
    /// Turn two channels by this angle in degrees from the first towards the second
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    turn: Option<f64>,
    /// Unit of what is shown and written
    #[arg(long, value_name = "UNIT")]
    to: Option<String>,
    /// Write the channels: .csv, .npz, or any other name for the values of one channel alone, as timeSeries Path reads them
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// List the formats instead, with how they are recognised and what they state
    #[arg(long)]
    formats: bool,
}

/// Run the command; the text for standard output.
pub(super) fn recording(a: &RecordingArgs) -> Result<String, String> {
    let Some(file) = a.file.as_ref().filter(|_| !a.formats) else { return Ok(formats()) };
    let shown = file.display();
    let bytes = hysteron_files::read_input(file).map_err(|e| format!("cannot read \"{shown}\": {e}"))?;
    let of_file = |e: String| format!("\"{shown}\": {e}");
    let measured = Measured::read_beside(&file.to_string_lossy(), &bytes, &hysteron_files::read_beside(file));
    let measured = measured.map_err(|e| of_file(e.to_string()))?;
    let told = a.told.told()?;
    let all = measured.stated_series(&told).map_err(|e| of_file(e.to_string()))?;
    measured.notes.iter().for_each(|note| eprintln!("warning: \"{shown}\": {note}"));
    // What is doubtful about accelerations; other series have no such bounds.
    let accelerations = measured.accelerations(&told, false).map(|found| found.channels).unwrap_or_default();
    for doubt in accelerations.iter().flat_map(doubts) {
        eprintln!("warning: \"{shown}\": {doubt}");
    }
    let series = chosen(all, a.told.channels()).map_err(of_file)?;
    let (series, conversions) = converted(a, series).map_err(of_file)?;
    let mut out = header(&measured);
    for (i, (s, conversion)) in series.iter().zip(&conversions).enumerate() {
        out += &describe(s, i, conversion);
    }
    if let Some(path) = &a.out {
        out += &write(path, &series)?;
    }
    Ok(out)
}

/// The formats as a list.
fn formats() -> String {
    hysteron::recordings::FORMATS.iter().fold(String::new(), |mut out, f| {
        let _ = write!(out, "{}\n  recognised by  {}\n  states         {}\n", f.name, f.recognised_by, f.states);
        let _ = writeln!(out, "  description    {}", f.description);
        out
    })
}

/// The channels of these names, directions or numbers.
fn chosen(all: Vec<Series>, which: &[String]) -> Result<Vec<Series>, String> {
    if which.is_empty() {
        return Ok(all);
    }
    let find = |word: &String| Ok(all[find_channel(all.iter(), word)?].clone());
    which.iter().map(find).collect()
}

/// The quantity after a derivative or an integral.
fn next(q: Quantity, differentiate: bool) -> Option<Quantity> {
    let order = [Quantity::Length, Quantity::Velocity, Quantity::Acceleration];
    let at = order.iter().position(|x| *x == q)?;
    let to = if differentiate { at + 1 } else { at.checked_sub(1)? };
    order.get(to).copied()
}

/// The channels after the conversions that are asked for, and a line about these for each.
fn converted(a: &RecordingArgs, mut series: Vec<Series>) -> Result<(Vec<Series>, Vec<String>), String> {
    let baseline = a
        .baseline
        .as_deref()
        .map(|word| Baseline::named(word).ok_or_else(|| format!("--baseline {word}: expected mean or line")));
    let baseline = baseline.transpose()?.unwrap_or_default();
    let sums = a.differentiate || a.integrate || a.turn.is_some() || baseline != Baseline::Kept;
    let mut conversions = vec![];
    for s in &mut series {
        let mut done = vec![];
        if let Some(i) = s.values.iter().position(|x| !x.is_finite()).filter(|_| sums) {
            return Err(format!("value {} of {} is missing or not finite: a conversion needs all", i + 1, s.name));
        }
        if a.differentiate || a.integrate || baseline != Baseline::Kept {
            let (values, removed) = baseline.removed(&s.values, s.unit.map_or("", |u| u.name));
            s.values = values;
            done.push(removed);
        }
        if let Some(factor) = a.factor {
            if factor == 0.0 || !factor.is_finite() {
                return Err(format!("--factor {factor}: expected a number other than 0"));
            }
            s.values.iter_mut().for_each(|x| *x *= factor);
            done.push(format!("multiplied by {factor}"));
        }
        if a.reverse {
            s.values.iter_mut().for_each(|x| *x = -*x);
            done.push("sign changed".into());
        }
        if a.differentiate || a.integrate {
            let dt = s.clock.dt().ok_or("a derivative or an integral needs equal steps of time: add --dt")?;
            let u = s.unit.ok_or("a derivative or an integral needs the unit: add --unit")?;
            let to = next(u.quantity, a.differentiate);
            let to =
                to.and_then(si).ok_or_else(|| format!("{} has no such derivative or integral here", u.quantity))?;
            let values: Vec<f64> = s.values.iter().map(|x| u.factor * x).collect();
            if a.differentiate {
                s.values = derivative(&values, dt);
                done.push("differentiated by central differences".into());
            } else {
                s.values = integral(&values, dt);
                let end = s.values.last().copied().unwrap_or(0.0);
                done.push(format!(
                    "integrated from 0 by the trapezoidal rule; the last value is {end:.4e} {}",
                    to.name
                ));
            }
            s.set_unit(to);
        }
        if let Some(word) = &a.to {
            let to = unit_of(word)?;
            s.values = s.in_unit(to, Way::CommandLine)?;
            s.set_unit(to);
        }
        conversions.push(done);
    }
    if let Some(angle) = a.turn {
        let [x, y] = &mut series[..] else {
            return Err(format!("--turn needs two channels, and there are {}: add --channel", series.len()));
        };
        if x.clock != y.clock || x.unit != y.unit || x.values.len() != y.values.len() {
            return Err("--turn needs two channels of one unit and of the same times".into());
        }
        [x.values, y.values] = turned(&x.values, &y.values, angle);
        for s in [x, y] {
            s.azimuth = None;
            s.direction = format!("turned by {angle}°");
        }
    }
    Ok((series, conversions.iter().map(|done| done.join("; ")).collect()))
}

/// The SI unit of a quantity of motion.
fn si(q: Quantity) -> Option<Unit> {
    unit::all().iter().copied().find(|u| u.quantity == q && u.factor == 1.0)
}

/// Lines of a header that are shown.
const SHOWN_LINES: usize = 20;

fn header(m: &Measured) -> String {
    let mut out = format!("format    {}: {}\n", m.format.name, m.format.recognised_by);
    for line in m.header.iter().map(|l| l.trim_end()).filter(|l| !l.trim().is_empty()).take(SHOWN_LINES) {
        let _ = writeln!(out, "header  | {line}");
    }
    if m.header.len() > SHOWN_LINES {
        let _ = writeln!(out, "header  | ... ({} lines)", m.header.len());
    }
    out
}

fn describe(s: &Series, i: usize, conversion: &str) -> String {
    let name = if s.name.is_empty() { format!("channel {}", i + 1) } else { format!("channel {}: {}", i + 1, s.name) };
    let mut out = format!("\n{name}\n");
    let mut line = |key: &str, value: String| {
        if !value.is_empty() {
            let _ = writeln!(out, "  {key:<10}{value}");
        }
    };
    line("event", s.event.clone());
    line("station", s.station.clone());
    let azimuth = s.azimuth.map_or(String::new(), |a| format!("azimuth {a}°"));
    // The columns of a table have no direction but their name.
    let direction = if s.direction == s.name { String::new() } else { s.direction.clone() };
    line("direction", [direction, azimuth].into_iter().filter(|w| !w.is_empty()).collect::<Vec<_>>().join(", "));
    line("quantity", s.quantity.map_or("not stated: --quantity or --unit says it".into(), |q| q.word().to_owned()));
    let unit = match (s.unit, s.unit_name.as_str()) {
        (Some(u), _) => u.name.to_owned(),
        (None, "") => "not stated: --unit says it".into(),
        (None, word) => format!("\"{word}\", which is not known: --unit says it"),
    };
    line("unit", unit);
    let clock = match &s.clock {
        Clock::Unknown => "not stated: --dt says the step".into(),
        Clock::Steps { start, dt } => format!("from {start} s in steps of {dt} s"),
        Clock::Times(t) => {
            format!("from {} s to {} s, in steps that differ", t.first().unwrap_or(&0.0), t.last().unwrap_or(&0.0))
        }
    };
    line("converted", conversion.to_owned());
    line("times", clock);
    let missing = s.values.iter().filter(|x| x.is_nan()).count();
    let missing = if missing > 0 { format!(", {missing} of them missing") } else { String::new() };
    line("samples", format!("{}{missing}", s.values.len()));
    let lines = &s.origin.lines;
    if !lines.is_empty() {
        let bytes = &s.origin.bytes;
        line("origin", format!("lines {} to {}, bytes {} to {}", lines.start, lines.end - 1, bytes.start, bytes.end));
    }
    let peak = s.peak();
    let at = s.values.iter().position(|x| x.abs() == peak).unwrap_or(0);
    let time = s.clock.time(at).map_or(format!("value {}", at + 1), |t| format!("{t} s"));
    let unit = s.unit.map_or("", |u| u.name);
    line("peak", format!("{} {unit} at {time}", without_round_off(s.values.get(at).copied().unwrap_or(0.0))));
    out + &sketch(&s.values)
}

/// Columns and rows of a sketch.
const WIDTH: usize = 72;
const HEIGHT: usize = 9;

/// A plot of a series in characters.
fn sketch(values: &[f64]) -> String {
    let finite = |v: &[f64]| {
        let all = v.iter().filter(|x| x.is_finite());
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)))
    };
    let (low, high) = finite(values);
    if values.is_empty() || !(high - low).is_finite() || high <= low {
        return String::new();
    }
    let row = |x: f64| (((high - x) / (high - low)) * (HEIGHT - 1) as f64).round() as usize;
    let mut grid = vec![vec![' '; WIDTH.min(values.len())]; HEIGHT];
    let columns = grid[0].len();
    for c in 0..columns {
        let part =
            &values[c * values.len() / columns..((c + 1) * values.len() / columns).max(c * values.len() / columns + 1)];
        let (a, b) = finite(part);
        if a <= b {
            (row(b)..=row(a)).for_each(|r| grid[r][c] = '*');
        }
    }
    grid.iter().fold(String::new(), |mut out, line| {
        let _ = writeln!(out, "  |{}", line.iter().collect::<String>().trim_end());
        out
    })
}

fn write(path: &Path, series: &[Series]) -> Result<String, String> {
    let shown = path.display();
    let first = series.first().ok_or("there is no channel to write")?;
    let n = first.values.len();
    if series.iter().any(|s| s.values.len() != n || s.clock != first.clock) {
        return Err("the channels have other times: choose some with --channel".into());
    }
    let times: Option<Vec<f64>> = (0..n).map(|i| first.clock.time(i)).collect();
    let names: Vec<String> = series.iter().enumerate().map(|(i, s)| label(s, i, series.len())).collect();
    let mut columns: Vec<NamedColumn<'_>> =
        times.iter().map(|values| NamedColumn { name: "time", unit: "s", values }).collect();
    columns.extend(series.iter().zip(&names).map(|(s, name)| NamedColumn {
        name,
        unit: s.unit.map_or(s.unit_name.as_str(), |u| u.name),
        values: &s.values,
    }));
    match path.extension().and_then(|e| e.to_str()) {
        Some("csv") => {
            if times.is_none() {
                return Err("the file gives no step of time: add --dt".into());
            }
            write_atomically(path, &csv(&columns))?;
        }
        Some("npz") => write_whole(path, npz(&columns)).map_err(|e| format!("cannot write {shown}: {e}"))?,
        _ => {
            let [one] = series else {
                return Err(format!(
                    "a file of a Path series has one channel, and there are {}: add --channel",
                    series.len()
                ));
            };
            if let Some(i) = one.values.iter().position(|x| !x.is_finite()) {
                return Err(format!("value {} is missing: a Path series has no gaps", i + 1));
            }
            write_atomically(path, &path_file(&one.values))?;
            let dt = one.clock.dt().map_or("$dt".to_owned(), |dt| dt.to_string());
            return Ok(format!("\nwritten: timeSeries Path $tag -dt {dt} -filePath {shown}\n"));
        }
    }
    Ok(format!("\nwritten: {shown}\n"))
}

/// The name of a channel in a file.
fn label(s: &Series, i: usize, count: usize) -> String {
    match (s.name.is_empty(), s.quantity) {
        (false, Some(q)) if s.origin.column.is_none() => format!("{} {}", s.name, q.word()),
        (false, _) => s.name.clone(),
        (true, Some(q)) if count == 1 => q.word().to_owned(),
        (true, _) => format!("channel {}", i + 1),
    }
}
