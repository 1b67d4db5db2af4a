//! Time series from measured files: `motionFile`, and `timeSeries Path -fileMotion`.

use crate::args::Args;
use crate::checks;
use crate::host::Mode;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, warn};
use hysteron_engine::series::{self, Path};
use hysteron_recordings::series::{channel_names, find_channel};
use hysteron_recordings::unit::{Quantity, Unit};
use hysteron_recordings::user_statements::{self, Key};
use hysteron_recordings::{Beside, Clock, Fault, Layout, Measured, Series, Statement, UserStatements, Way};
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};
use std::cell::RefCell;
use std::sync::Arc;

const MOTION_FILE_SERIES: Arg = Arg::whole("series", "tag of the time series");
const FILE: Arg = Arg::new("file", "name of the file");
const FACTOR_C: Arg = Arg::of("-factor", "c", "factor").within(Domain::Number);
const DT: Arg = Arg::of("-dt", "dt", "step of time dt").within(Domain::Positive);
const CHANNEL_NAME: Arg = Arg::of("-channel", "name", "name or number of the channel");

pub(crate) const COMMANDS: &[Command] = &[Command::new("motionFile", USAGE, motion_file)
    .arguments(&[
        MOTION_FILE_SERIES,
        FILE,
        FACTOR_C,
        DT,
        CHANNEL_NAME,
        Arg::of("-quantity", "word", "quantity"),
        Arg::of("-unit", "unit", "unit"),
        Arg::of("-layout", "word", "layout"),
        Arg::of("-to", "unit", "unit"),
    ])
    .about("Reads a ground motion into a `Path` series and returns the time step and the number of values.")
    .own()];

const USAGE: &str = "lassign [motionFile $series $file <-factor $c> <-dt $dt> <-useLast> <-channel $name> <-quantity \
                     $word> <-unit $unit> <-layout $word> <-to $unit>] dt npts: a measured file of any format that hysteron recording \
                     reads; a time series in the unit of the file, or in that of -to";

/// Options that say what a measured file does not, and what is taken from it.
pub(super) const FILE_OPTIONS: [&str; 5] = ["-channel", "-quantity", "-unit", "-layout", "-to"];

/// What a command says about a measured file.
#[derive(Default)]
pub(super) struct FileOptions {
    /// Step of a file without one.
    pub(super) dt: Option<f64>,
    channel: Option<String>,
    quantity: Option<Quantity>,
    /// Unit of a file without one.
    unit: Option<Unit>,
    layout: Option<Layout>,
    /// Unit of the values of the series.
    to: Option<Unit>,
}

impl FileOptions {
    /// Take one of [`FILE_OPTIONS`]; false if the option is none of them.
    pub(super) fn take(&mut self, option: &str, a: &mut Args<'_>) -> Result<bool, Exception> {
        match option {
            "-channel" => self.channel = Some(a.word(CHANNEL_NAME.meaning)?.into_owned()),
            "-quantity" => self.quantity = Some(take(a, "quantity", user_statements::quantity_of)?),
            "-unit" => self.unit = Some(take(a, "unit", user_statements::unit_of)?),
            "-layout" => self.layout = Some(take(a, "layout", Layout::named)?),
            "-to" => self.to = Some(take(a, "unit", user_statements::unit_of)?),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// Take a word that the reader of measured files understands.
fn take<T>(a: &mut Args<'_>, what: &str, of: fn(&str) -> Result<T, Fault>) -> Result<T, Exception> {
    let word = a.word(what)?.into_owned();
    of(&word).map_err(|fault| a.refuse(fault.message, &fault.expected))
}

/// The samples of a channel and their times.
pub(super) struct FileSeries {
    pub(super) values: Vec<f64>,
    pub(super) clock: Clock,
    /// The values are in g.
    in_g: bool,
}

impl FileSeries {
    /// Remember a record in g for the remarks of `check`.
    pub(super) fn note(&self, interp: &mut Tcl, series: &series::Series, name: String) {
        if self.in_g && interp.host.mode == Mode::Check {
            interp.host.overview.records_in_g.push((series.clone(), name));
        }
    }
}

/// Result of `of` on the bytes of a measured file and of the files beside it.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn measured<T>(interp: &mut Tcl, name: &str, of: impl FnOnce(&[u8], Beside<'_>) -> T) -> std::io::Result<T> {
    let path = interp.absolute(name);
    let bytes = interp.files.read(&path)?;
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let files = RefCell::new(&mut interp.files);
    let beside = |other: &str| files.borrow_mut().read(&format!("{folder}/{other}")).ok();
    Ok(of(&bytes, &beside))
}

/// Read one channel of a measured file.
pub(super) fn read(
    interp: &mut Tcl,
    a: &Args<'_>,
    (name, span): (&str, Option<Span>),
    options: &FileOptions,
) -> Result<FileSeries, Exception> {
    let told = UserStatements { dt: options.dt, layout: options.layout, way: Way::Script, ..UserStatements::default() };
    let read = measured(interp, name, |bytes, beside| {
        let m = Measured::read_beside(name, bytes, beside)?;
        Ok((m.series(&told)?, m))
    });
    let read = read.map_err(|e| a.unreadable(span, name, &e))?;
    let (all, measured) =
        read.map_err(|e: Fault| a.refuse_at(span, format!("\"{name}\": {e}"), "expected a measured file"))?;
    let refuse = |e: Fault| a.refuse_at(span, format!("\"{name}\": {e}"), "expected one channel");
    let series = chosen(all, options).map_err(refuse)?;
    if series.clock == Clock::Unknown {
        return Err(refuse(measured.no_step(told.way)));
    }
    if let Some(i) = series.values.iter().position(|x| !x.is_finite()) {
        return Err(refuse(Fault::new(format!("value {} is missing or not finite", i + 1))));
    }
    for note in &measured.notes {
        warn(interp, Diagnostic::warning(&checks::load::RECORDING_NOTE, format!("\"{name}\": {note}")).at(span, ""))?;
    }
    let no_quantity = options.quantity.is_none() && options.to.is_none();
    let other = series.quantity.filter(|q| no_quantity && matches!(q, Quantity::Velocity | Quantity::Length));
    if let Some(q) = other {
        let message = format!("\"{name}\" holds {} and no accelerations", q.words());
        let key = told.way.spelled(Key::Quantity);
        let warning = Diagnostic::warning(&checks::load::NO_ACCELERATIONS, message)
            .at(span, "")
            .help(format!("{key} {} says that it is meant", q.word()));
        warn(interp, warning)?;
    }
    converted(series, options).map_err(refuse)
}

/// The samples in the unit that is asked for.
fn converted(mut series: Series, options: &FileOptions) -> Result<FileSeries, Fault> {
    Statement::new(options.unit, options.quantity)?.complete(std::slice::from_mut(&mut series))?;
    let in_g = options.to.or(series.unit).is_some_and(|u| u.name == "g");
    let values = match options.to {
        Some(to) => series.in_unit(to, Way::Script)?,
        None => series.values,
    };
    Ok(FileSeries { values, clock: series.clock, in_g })
}

fn motion_file(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let tag = a.int(MOTION_FILE_SERIES.meaning)?;
    let tag_span = a.last_span();
    let name = a.word(FILE.meaning)?.into_owned();
    let span = a.last_span();
    let (mut factor, mut use_last, mut options) = (1.0, false, FileOptions::default());
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" | "-fact" => factor = a.number(&FACTOR_C)?,
            "-dt" => options.dt = Some(a.number(&DT)?),
            "-useLast" => use_last = true,
            word if FILE_OPTIONS.contains(&word) => drop(options.take(word, &mut a)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let mut read = read(interp, &a, (&name, span), &options)?;
    let Some(dt) = read.clock.dt() else {
        let message = format!("\"{name}\" has times at steps that differ, and this command gives one step");
        let help = format!("timeSeries Path {tag} -fileMotion {name} takes the times");
        return Err(a.refuse_at(span, format!("{message}: {help}"), "expected equal steps of time"));
    };
    let values = std::mem::take(&mut read.values);
    let count = values.len();
    let series: series::Series = Arc::new(Path { values, dt, factor, use_last, start: 0.0 });
    read.note(interp, &series, name);
    if !interp.host.builder.definitions.series.add(tag, series) {
        return Err(a.exists_at(tag_span, things::SERIES, tag));
    }
    Ok(Value::list([Value::from(dt), Value::from(count as i64)]))
}

/// The channel of a name or number; else that of the quantity, and of accelerations if none is said.
fn chosen(all: Vec<Series>, options: &FileOptions) -> Result<Series, Fault> {
    let at = match options.channel.as_deref() {
        Some(word) => find_channel(all.iter(), word)?,
        None => {
            let to = options.to.map(|u| u.quantity);
            let wanted = options.quantity.or(to).unwrap_or(Quantity::Acceleration);
            let of: Vec<usize> = (0..all.len()).filter(|i| all[*i].quantity == Some(wanted)).collect();
            match (&of[..], all.len()) {
                ([one], _) => *one,
                (_, 1) => 0,
                _ => {
                    let key = Way::Script.spelled(Key::Channel);
                    let names = channel_names(all.iter());
                    let message = format!("there are {} channels", all.len());
                    return Err(Fault::new(message).expected(format!("say {key} with one of {names}")));
                }
            }
        }
    };
    all.into_iter().nth(at).ok_or_else(|| Fault::new("there is no channel"))
}
