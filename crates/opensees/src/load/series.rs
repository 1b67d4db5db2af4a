//! `timeSeries`.

use super::motion_file::{self, FILE_OPTIONS, FileOptions, FileSeries};
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, kind, slips, warn};
use hysteron_engine::series::{Constant, Linear, Path, PathTimes, Pulse, Rectangular, Series, Triangle, Trig, Wave};
use hysteron_recordings::{Clock, Measured, UserStatements};
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const ZERO_SHIFT: Arg = Arg::of("-zeroShift", "z", "zero shift").within(Domain::Number);
const WIDTH: Arg = Arg::of("-width", "w", "width of the pulse as a fraction of the period").within(Domain::Number);
const START_TIME: Arg = Arg::of("-startTime", "t", "start time").within(Domain::Number);

const TAG: Arg = Arg::whole("tag", "tag of the time series");
const FACTOR_C: Arg = Arg::of("-factor", "c", "factor").within(Domain::Number);
const T_START: Arg = Arg::number("tStart", "start tStart");
const T_END: Arg = Arg::number("tEnd", "end tEnd");
const PERIOD: Arg = Arg::positive("period", "period");
const SHIFT: Arg = Arg::of("-shift", "shift", "phase shift").within(Domain::Number);
const DT: Arg = Arg::of("-dt", "dt", "step of time dt").within(Domain::Positive);
const FILE_MOTION_FILE: Arg = Arg::of("-fileMotion", "file", "name of a measured file");

pub(crate) const COMMANDS: &[Command] = &[Command::new("timeSeries", "timeSeries $kind $tag ...", time_series)
    .about("Makes a factor that varies with time.")
    .arguments(&[TAG, ZERO_SHIFT, WIDTH])
    .defining(&[things::SERIES], 2)
    .with_kinds(|| kind::usages(KINDS))];

/// A kind of series, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<Series, Exception>>;

const WAVE: &str = "timeSeries Trig|Triangle $tag $tStart $tEnd $period <-factor $c> <-shift $shift> <-zeroShift $z>";

const KINDS: &[Kind] = &[
    Kind {
        names: &["Constant", "ConstantSeries"],
        usage: "timeSeries Constant $tag <-factor $c>",
        text: Text::new("A constant factor.").arguments(&[FACTOR_C]),
        make: constant,
    },
    Kind {
        names: &["Linear", "LinearSeries"],
        usage: "timeSeries Linear $tag <-factor $c>",
        text: Text::new("A factor that grows with time.").arguments(&[FACTOR_C]),
        make: linear,
    },
    Kind {
        names: &["Trig", "TrigSeries", "Sine", "SineSeries"],
        usage: WAVE,
        text: Text::new("A sine between two times.").arguments(&[T_START, T_END, PERIOD, FACTOR_C, SHIFT]),
        make: trig,
    },
    Kind {
        names: &["Triangle", "TriangleSeries"],
        usage: WAVE,
        text: Text::new("A triangular wave between two times.").arguments(&[T_START, T_END, PERIOD, FACTOR_C, SHIFT]),
        make: triangle,
    },
    Kind {
        names: &["Rectangular"],
        usage: "timeSeries Rectangular $tag $tStart $tEnd <-factor $c>",
        text: Text::new("A constant factor between two times.").arguments(&[T_START, T_END, FACTOR_C]),
        make: rectangular,
    },
    Kind {
        names: &["Pulse", "PulseSeries"],
        usage: "timeSeries Pulse $tag $tStart $tEnd $period <-width $w> <-shift $shift> <-factor $c> <-zeroShift $z>",
        text: Text::new("A rectangular wave between two times.").arguments(&[T_START, T_END, PERIOD, SHIFT, FACTOR_C]),
        make: pulse,
    },
    Kind {
        names: &["Path", "Series"],
        usage: "timeSeries Path $tag -dt $dt -values {...} | -dt $dt -filePath $file | -time {...} -values {...} | \
                -fileTime $file -filePath $file | -fileMotion $file <-dt $dt> <-channel $name> <-quantity $word> \
                <-unit $unit> <-layout $word> <-to $unit> <-factor $c> <-useLast> <-prependZero> <-startTime $t>",
        text: Text::new("A factor given by points, interpolated linearly.").arguments(&[
            DT,
            Arg::flag("-values", "values, with `-dt` at equal steps, with `-time` at these times"),
            Arg::of("-filePath", "file", "file of values"),
            Arg::of("-fileTime", "file", "file of times"),
            FILE_MOTION_FILE,
            Arg::of("-channel", "name", "name or number of the channel"),
            Arg::of("-quantity", "word", "quantity"),
            Arg::of("-unit", "unit", "unit"),
            Arg::of("-layout", "word", "layout"),
            Arg::of("-to", "unit", "unit"),
            Arg::of("-factor", "c", "factor").within(Domain::Number),
            START_TIME,
        ]),
        make: path,
    },
];

fn time_series(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "timeSeries $kind $tag ...");
    let kind = take_kind(&mut a)?;
    interp.host.note_kind("timeSeries", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let series = (kind.make)(interp, &mut a)?;
    if !interp.host.builder.definitions.series.add(tag, series) {
        return Err(a.exists_at(span, things::SERIES, tag));
    }
    Ok(Value::EMPTY)
}

fn take_kind(a: &mut Args<'_>) -> Result<&'static Kind, Exception> {
    kind::take(a, "kind of time series", "time series", KINDS.iter())
}

/// Returns true if a word begins with the name of a kind of series.
pub(crate) fn names_kind(word: &Value) -> bool {
    let first = word.to_list().ok().and_then(|list| list.first().cloned());
    first.is_some_and(|name| KINDS.iter().any(|k| k.names.contains(&name.as_str().as_ref())))
}

/// A series by its tag, or given in place: a name (`Linear`) or a list (`{Series -dt 0.01 -filePath gm.txt}`).
pub(crate) fn series_of(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    if a.at_number() {
        return a.of(&interp.host.builder.definitions.series).map(|(s, _)| s);
    }
    let value = a.value("time series")?;
    let list = value.to_list().map_err(|_| a.refuse("not a time series", "expected a tag, a name or a list"))?;
    // The words of a list have no places of their own.
    let span = a.last_span();
    series_of_words(interp, &list).map_err(|e| e.at(span, "expected a time series"))
}

/// A series by the words behind its tag.
pub(crate) fn series_of_words(interp: &mut Tcl, list: &[Value]) -> Result<Series, Exception> {
    let mut words = vec![Value::from("timeSeries")];
    words.extend(list.iter().cloned());
    let inner = Call::of(&words);
    let mut b = Args::new(&inner, "a time series in place: {Series -dt $dt -filePath $file -factor $c}");
    let kind = take_kind(&mut b)?;
    (kind.make)(interp, &mut b)
}

fn factor_only(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let mut factor = 1.0;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" => factor = a.number(&FACTOR_C)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(factor)
}

fn constant(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    Ok(Arc::new(Constant { factor: factor_only(interp, a)? }))
}

fn linear(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    Ok(Arc::new(Linear { factor: factor_only(interp, a)? }))
}

/// Warn where a series ends before it begins: it is zero at all times.
fn warn_of_end(interp: &mut Tcl, a: &Args<'_>, start: f64, end: f64) -> Result<(), Exception> {
    if end > start {
        return Ok(());
    }
    let d = Diagnostic::warning(
        &checks::load::EMPTY_SERIES,
        format!("the time series ends at {end} but begins at {start}: it is zero"),
    );
    warn(interp, d.at(a.last_span(), format!("expected tEnd, greater than {start}")))
}

/// Times, period, and the options of the periodic series; also the width of a pulse.
fn wave(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Wave, f64), Exception> {
    let start = a.number(&T_START)?;
    let end = a.number(&T_END)?;
    warn_of_end(interp, a, start, end)?;
    let period = a.number(&PERIOD)?;
    let mut w = Wave { start, end, period, shift: 0.0, factor: 1.0, zero_shift: 0.0 };
    let mut width = 0.5;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" => w.factor = a.number(&FACTOR_C)?,
            "-shift" | "-phaseShift" => w.shift = a.number(&SHIFT)?,
            "-zeroShift" => w.zero_shift = a.number(&ZERO_SHIFT)?,
            "-width" | "-pulseWidth" => {
                width = a.number(&WIDTH)?;
                if !(0.0..=1.0).contains(&width) {
                    let d = Diagnostic::warning(
                        &checks::load::EMPTY_SERIES,
                        format!("the width of the pulse is {width}: it never begins or never ends"),
                    );
                    warn(interp, d.at(a.last_span(), "expected a fraction, 0 to 1"))?;
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok((w, width))
}

fn trig(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    let (w, _) = wave(interp, a)?;
    if w.zero_shift.abs() > w.factor.abs() {
        return Err(a.refuse("the zero shift is greater than the factor", "such a sine never is zero"));
    }
    Ok(Arc::new(Trig::new(w)))
}

fn triangle(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    Ok(Arc::new(Triangle(wave(interp, a)?.0)))
}

fn pulse(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    let (wave, width) = wave(interp, a)?;
    Ok(Arc::new(Pulse { wave, width }))
}

fn rectangular(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    let start = a.number(&T_START)?;
    let end = a.number(&T_END)?;
    warn_of_end(interp, a, start, end)?;
    Ok(Arc::new(Rectangular { start, end, factor: factor_only(interp, a)? }))
}

fn path(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Series, Exception> {
    let (mut values, mut times, mut dt) = (None, None, None);
    let (mut factor, mut start, mut use_last, mut prepend) = (1.0, 0.0, false, false);
    let (command, mut pairs) = (a.last_span(), None);
    let (mut measured, mut of_file) = (None, FileOptions::default());
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-dt" | "-dT" => dt = Some(a.number(&DT)?),
            "-values" => values = Some(numbers(interp, a, "value")?),
            "-time" => times = Some((numbers(interp, a, "time")?, a.last_span())),
            "-filePath" => {
                values = Some(file(interp, a)?);
                pairs = Some(a.last_span()).filter(|_| file_has_pairs(interp, &a.last_word()));
            }
            "-fileTime" => times = Some((file(interp, a)?, a.last_span())),
            "-file" => {
                let pairs = file(interp, a)?;
                times = Some((pairs.iter().copied().step_by(2).collect(), a.last_span()));
                values = Some(pairs.iter().copied().skip(1).step_by(2).collect());
            }
            "-fileMotion" => {
                let name = a.word(FILE_MOTION_FILE.meaning)?.into_owned();
                measured = Some((name, a.last_span()));
            }
            word if FILE_OPTIONS.contains(&word) => drop(of_file.take(word, a)?),
            "-factor" => factor = a.number(&FACTOR_C)?,
            "-useLast" => use_last = true,
            "-prependZero" => prepend = true,
            "-startTime" | "-tStart" => start = a.number(&START_TIME)?,
            // An old script may give the tag as an option.
            "-tag" => drop(a.int("tag")?),
            _ => ignore_unknown(interp, a)?,
        }
    }
    if let Some((name, span)) = measured {
        if let Some(other) = [values.is_some(), times.is_some()].iter().position(|given| *given) {
            let what = ["values", "times"][other];
            let message = format!("a measured file has its own {what}");
            return Err(a.refuse_at(span, message, "expected -fileMotion alone"));
        }
        of_file.dt = dt;
        let read = motion_file::read(interp, a, (&name, span), &of_file)?;
        let shift = PathShift { factor, start, use_last, prepend };
        let series = measured_path(&read, &shift).map_err(|e| a.refuse_at(span, e, "expected equal steps of time"))?;
        read.note(interp, &series, name);
        return Ok(series);
    }
    if values.as_ref().is_some_and(Vec::is_empty) && dt.is_some() && interp.host.follows(&[slips::EMPTY_PATH]) {
        warn(
            interp,
            Diagnostic::warning(&checks::load::EMPTY_SERIES, "the path has no values: it is zero")
                .at(command, "expected values"),
        )?;
        values = Some(vec![0.0; 2]);
    }
    let Some(mut values) = values.filter(|v| !v.is_empty()) else {
        return Err(a.refuse_at(command, "the path has no values", "expected -values or -filePath"));
    };
    if let [value] = values[..] {
        let d = Diagnostic::warning(&checks::load::EMPTY_SERIES, format!("the path has a single value, {value}"));
        warn(interp, d.at(command, "expected two or more"))?;
    }
    if prepend {
        values.insert(0, 0.0);
    }
    match (times, dt) {
        (Some((mut times, span)), _) => {
            if times.len() != values.len() {
                let message = format!("{} times but {} values", times.len(), values.len());
                return Err(a.refuse_at(span, message, "expected a time for each value"));
            }
            if let Some(i) = times.windows(2).position(|w| w[1] < w[0]) {
                let message = format!("the times go back: {} after {}", times[i + 1], times[i]);
                let d = Diagnostic::warning(&checks::load::TIMES_GO_BACK, message)
                    .at(span, "expected times that do not decrease");
                warn(interp, d.help("of the points behind an earlier time only the last before the next time counts"))?;
                (times, values) = forward(&times, &values);
            }
            Ok(Arc::new(PathTimes { times, values, factor, use_last }))
        }
        (None, Some(dt)) => {
            if let Some(span) = pairs {
                let message =
                    format!("the file has two columns, times and values, read as one of {} values", values.len());
                let d =
                    Diagnostic::warning(&checks::load::TWO_COLUMNS, message).at(span, "expected one column of values");
                warn(interp, d.help("\"-file\" in its place takes times and values, and so does \"motionFile\""))?;
            }
            Ok(Arc::new(Path { values, dt, factor, use_last, start }))
        }
        (None, None) => Err(a.refuse_at(command, "the path has no times", "expected -dt, -time or -fileTime")),
    }
}

/// Options of a path that change its values or its times.
struct PathShift {
    factor: f64,
    start: f64,
    use_last: bool,
    prepend: bool,
}

/// The path of a measured series: at equal steps from the start time, or at the times of the file.
fn measured_path(read: &FileSeries, shift: &PathShift) -> Result<Series, String> {
    let PathShift { factor, start, use_last, prepend } = *shift;
    let mut values = read.values.clone();
    match &read.clock {
        Clock::Steps { dt, .. } => {
            if prepend {
                values.insert(0, 0.0);
            }
            Ok(Arc::new(Path { values, dt: *dt, factor, use_last, start }))
        }
        Clock::Times(_) if prepend => Err("-prependZero has no step: the steps of the file differ".into()),
        Clock::Times(times) => {
            let times = times.iter().map(|t| start + t).collect();
            Ok(Arc::new(PathTimes { times, values, factor, use_last }))
        }
        Clock::Unknown => Err("the file gives no step of time".into()),
    }
}

/// Numbers in words of their own or in a list. OpenSees leaves out a word that is no list of numbers.
fn numbers(interp: &Tcl, a: &mut Args<'_>, what: &str) -> Result<Vec<f64>, Exception> {
    let numbers = a.floats(what)?;
    match a.next_is_no_list("numbers, with blanks between them").filter(|_| !interp.host.follows(&[])) {
        Some(e) => Err(e),
        None => Ok(numbers),
    }
}

/// The path as OpenSees walks along it while the time grows: to the first point that is not before the time. Between such a
/// point and the one in front of it the path is straight.
fn forward(times: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut t, mut v) = (vec![times[0]], vec![values[0]]);
    let mut latest = times[0];
    for i in 1..times.len() {
        if times[i] < latest {
            continue;
        }
        if times[i - 1] < latest && times[i] > latest {
            let share = (latest - times[i - 1]) / (times[i] - times[i - 1]);
            t.push(latest);
            v.push(values[i - 1] + (values[i] - values[i - 1]) * share);
        }
        latest = times[i];
        t.push(latest);
        v.push(values[i]);
    }
    (t, v)
}

/// The numbers of a file, as far as they go.
fn file(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Vec<f64>, Exception> {
    let name = a.word("name of a file")?.into_owned();
    let span = a.last_span();
    let text = crate::read_text(interp, &name).map_err(|e| a.unreadable(a.last_span(), &name, &e))?;
    if let Some(values) = interp.host.number_files.find(&name, &text) {
        return Ok(values);
    }
    let mut out = vec![];
    for word in text.split_ascii_whitespace() {
        match word.parse::<f64>() {
            Ok(x) if x.is_finite() => out.push(x),
            _ => {
                report_non_number(interp, &name, &text, word, out.len(), span)?;
                return Ok(out);
            }
        }
    }
    interp.host.number_files.remember(&name, &text, &out);
    Ok(out)
}

/// Rows from which on two columns are told from a table of a few numbers.
const MIN_ROWS: usize = 10;
/// Relative difference of the steps of a column of times, which are rounded.
const STEP_TOLERANCE: f64 = 0.01;

/// Returns true if a file has two columns, the first of which rises in equal steps.
fn file_has_pairs(interp: &mut Tcl, name: &str) -> bool {
    let Ok(text) = crate::read_text(interp, name) else { return false };
    let row = |line: &str| -> Option<f64> {
        let mut words = line.split_ascii_whitespace();
        let (time, value) = (words.next()?.parse().ok()?, words.next()?.parse::<f64>());
        (value.is_ok() && words.next().is_none()).then_some(time)
    };
    let rows = text.lines().filter(|line| !line.trim().is_empty());
    let Some(times) = rows.map(row).collect::<Option<Vec<f64>>>().filter(|t| t.len() >= MIN_ROWS) else { return false };
    let step = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    step > 0.0 && times.windows(2).all(|w| (w[1] - w[0] - step).abs() <= STEP_TOLERANCE * step)
}

/// Report a word of a file that is no number: an error at the start of the file, else a warning.
///
/// OpenSees leaves out the rest of the file without a message.
fn report_non_number(
    interp: &mut Tcl,
    name: &str,
    text: &str,
    word: &str,
    read: usize,
    span: Option<Span>,
) -> Result<(), Exception> {
    let at = (word.as_ptr() as usize - text.as_ptr() as usize) as u32;
    let source = interp.sources.add(name, text);
    let place = Span { source, start: at, end: at + word.len() as u32 };
    let mut d = if read == 0 {
        let d = Diagnostic::error(format!("\"{name}\" does not begin with a number: \"{word}\""));
        let series = Measured::read(name, text.as_bytes()).and_then(|m| m.series(&UserStatements::default()));
        let has_step = series.is_ok_and(|all| all.iter().any(|s| s.clock.dt().is_some()));
        d.help(if has_step {
            format!("\"motionFile $series {name}\" reads this file of a ground motion with its step of time")
        } else {
            "remove the header lines, or read the file with a procedure of your own".into()
        })
    } else {
        let message = format!("\"{name}\" is read up to \"{word}\" only, which is not a number ({read} numbers read)");
        Diagnostic::warning(&checks::load::PARTLY_READ, message)
    };
    d = d.at(Some(place), "expected a number");
    if let Some(span) = span {
        d.callers.push(hysteron_tcl::diagnostic::Caller { what: format!("file \"{name}\""), span });
    }
    if read == 0 { Err(Exception::diagnosed(d)) } else { warn(interp, d) }
}
