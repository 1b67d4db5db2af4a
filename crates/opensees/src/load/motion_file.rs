//! Time series from measured files: `motionFile`, and `timeSeries Path -fileMotion`.

use crate::args::Args;
use crate::checks;
use crate::host::Mode;
use crate::{Command, Outcome, Tcl, ignore_option, warn};
use hysteron_engine::series::{self, Path};
use hysteron_recordings::unit::{self, Quantity, Unit};
use hysteron_recordings::{Clock, Measured, Series, Told};
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

pub(crate) const COMMANDS: &[Command] = &[Command::new("motionFile", USAGE, motion_file)];

const USAGE: &str = "lassign [motionFile $series $file <-factor $c> <-dt $dt> <-useLast> <-channel $name> <-quantity \
                     $word> <-unit $unit> <-to $unit>] dt npts: a measured file of any format that hysteron recording \
                     reads; a time series in the unit of the file, or in that of -to";

/// Options that say what a measured file does not, and what is taken from it.
pub(super) const FILE_OPTIONS: [&str; 4] = ["-channel", "-quantity", "-unit", "-to"];

const OPTIONS: &[&str] = &["-factor", "-dt", "-useLast", "-channel", "-quantity", "-unit", "-to"];

/// What a command says about a measured file.
#[derive(Default)]
pub(super) struct FileOptions {
    /// Step of a file without one.
    pub(super) dt: Option<f64>,
    channel: Option<String>,
    quantity: Option<Quantity>,
    /// Unit of a file without one.
    unit: Option<Unit>,
    /// Unit of the values of the series.
    to: Option<Unit>,
}

impl FileOptions {
    /// Take one of [`FILE_OPTIONS`]; false if the option is none of them.
    pub(super) fn take(&mut self, option: &str, a: &mut Args<'_>) -> Result<bool, Exception> {
        match option {
            "-channel" => self.channel = Some(a.word("name or number of the channel")?.into_owned()),
            "-quantity" => {
                let word = a.word("quantity")?.into_owned();
                let expected = "expected acceleration, velocity, displacement, ...";
                let of =
                    Quantity::named(&word).ok_or_else(|| a.refuse(format!("\"{word}\" is no quantity"), expected))?;
                self.quantity = Some(of);
            }
            "-unit" => self.unit = Some(take_unit(a)?),
            "-to" => self.to = Some(take_unit(a)?),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

fn take_unit(a: &mut Args<'_>) -> Result<Unit, Exception> {
    let word = a.word("unit")?.into_owned();
    unit::unit(&word).ok_or_else(|| {
        let near = unit::nearest_name(&word).map_or(String::new(), |n| format!("; did you mean {n}?"));
        a.refuse(format!("\"{word}\" is no unit{near}"), "expected a unit such as g, m/s2, in/s2")
    })
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

/// Read one channel of a measured file.
pub(super) fn read(
    interp: &mut Tcl,
    a: &Args<'_>,
    (name, span): (&str, Option<Span>),
    options: &FileOptions,
) -> Result<FileSeries, Exception> {
    let path = interp.absolute(name);
    let bytes = interp.files.read(&path);
    let bytes = bytes.map_err(|e| a.refuse_at(span, format!("cannot read \"{name}\": {e}"), "expected a file"))?;
    let told = Told { dt: options.dt, ..Told::default() };
    let read = Measured::read(name, &bytes).and_then(|m| Ok((m.series(&told)?, m)));
    let (all, measured) =
        read.map_err(|e| a.refuse_at(span, format!("\"{name}\": {e}"), "expected a measured file"))?;
    let refuse = |e: String| a.refuse_at(span, format!("\"{name}\": {e}"), "expected one channel");
    let series = chosen(all, options).map_err(refuse)?;
    if series.clock == Clock::Unknown {
        let message = format!("\"{name}\" gives no step of time; {}", measured.shown_header());
        return Err(a.refuse_at(span, message, "expected -dt after it"));
    }
    if let Some(i) = series.values.iter().position(|x| !x.is_finite()) {
        return Err(refuse(format!("value {} is missing or not finite", i + 1)));
    }
    for note in &measured.notes {
        warn(interp, Diagnostic::warning(&checks::load::RECORDING_NOTE, format!("\"{name}\": {note}")).at(span, ""))?;
    }
    let no_quantity = options.quantity.is_none() && options.to.is_none();
    let other = series.quantity.filter(|q| no_quantity && matches!(q, Quantity::Velocity | Quantity::Length));
    if let Some(q) = other {
        let message = format!("\"{name}\" holds {} and no accelerations", q.words());
        let warning = Diagnostic::warning(&checks::load::NO_ACCELERATIONS, message)
            .at(span, "")
            .help(format!("-quantity {} says that it is meant", q.word()));
        warn(interp, warning)?;
    }
    converted(series, options).map_err(refuse)
}

/// The samples in the unit that is asked for.
fn converted(series: Series, options: &FileOptions) -> Result<FileSeries, String> {
    let stated = |q: Quantity| format!("the file says {}", q.word());
    if let (Some(q), Some(said)) = (series.quantity, options.quantity.filter(|q| series.quantity != Some(*q))) {
        return Err(format!("{}, and is told to be {}", stated(q), said.word()));
    }
    if let (Some(q), Some(said)) = (series.quantity, options.unit.filter(|u| series.quantity != Some(u.quantity))) {
        return Err(format!("{}, and {} is {}", stated(q), said.name, said.quantity));
    }
    if let (Some(of_file), Some(said)) = (series.unit, options.unit)
        && of_file.factor != said.factor
    {
        return Err(format!("the file gives the unit {}, and is told {}", of_file.name, said.name));
    }
    let unit = series.unit.or(options.unit);
    let mut values = series.values;
    if let Some(to) = options.to {
        let from = unit.ok_or_else(|| {
            let word = &series.unit_name;
            let what =
                if word.is_empty() { "gives no unit".to_owned() } else { format!("has the unknown unit \"{word}\"") };
            format!("the file {what}, which -to needs: say it by -unit")
        })?;
        let conversion = from.conversion(&to);
        let (factor, offset) = conversion
            .ok_or_else(|| format!("{} is {}, and {} is {}", from.name, from.quantity, to.name, to.quantity))?;
        values.iter_mut().for_each(|x| *x = factor * *x + offset);
    }
    let in_g = options.to.or(unit).is_some_and(|u| u.name == "g");
    Ok(FileSeries { values, clock: series.clock, in_g })
}

fn motion_file(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let tag = a.int("tag of the time series")?;
    let tag_span = a.last_span();
    let name = a.word("name of the file")?.into_owned();
    let span = a.last_span();
    let (mut factor, mut use_last, mut options) = (1.0, false, FileOptions::default());
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" | "-fact" => factor = a.float("factor")?,
            "-dt" => options.dt = Some(a.positive("step of time dt")?),
            "-useLast" => use_last = true,
            word if FILE_OPTIONS.contains(&word) => drop(options.take(word, &mut a)?),
            _ => ignore_option(interp, &mut a, OPTIONS)?,
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
        return Err(a.refuse_at(tag_span, format!("there is a time series {tag} already"), "expected a new tag"));
    }
    Ok(Value::list([Value::from(dt), Value::from(count as i64)]))
}

/// The channel of a name or number; else that of the quantity, and of accelerations if none is said.
fn chosen(all: Vec<Series>, options: &FileOptions) -> Result<Series, String> {
    let label = |(i, s): (usize, &Series)| if s.name.is_empty() { (i + 1).to_string() } else { s.name.clone() };
    let names = all.iter().enumerate().map(label).collect::<Vec<_>>().join(", ");
    let of_name = |word: &str| {
        let named = all.iter().position(|s| s.name == word || s.direction == word);
        named.or_else(|| word.parse::<usize>().ok()?.checked_sub(1).filter(|i| *i < all.len()))
    };
    let at = match options.channel.as_deref() {
        Some(word) => of_name(word).ok_or_else(|| format!("there is no channel \"{word}\": they are {names}"))?,
        None => {
            let to = options.to.map(|u| u.quantity);
            let wanted = options.quantity.or(to).unwrap_or(Quantity::Acceleration);
            let of: Vec<usize> = (0..all.len()).filter(|i| all[*i].quantity == Some(wanted)).collect();
            match (&of[..], all.len()) {
                ([one], _) => *one,
                (_, 1) => 0,
                // Channels of a record follow each other: the first is the one that a single name means.
                ([first, ..], _) if all[*first].origin.column.is_none() => *first,
                _ => return Err(format!("there are {} channels: say -channel with one of {names}", all.len())),
            }
        }
    };
    all.into_iter().nth(at).ok_or_else(|| "there is no channel".to_owned())
}
