//! `motionFile`: a time series from a measured file.

use crate::args::Args;
use crate::host::Mode;
use crate::{Command, Outcome, Tcl, ignore_option, warn};
use hysteron_engine::series::{self, Path};
use hysteron_recordings::unit::Quantity;
use hysteron_recordings::{Measured, Series, Told};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Value};
use std::sync::Arc;

pub(crate) const COMMANDS: &[Command] = &[Command::new("motionFile", USAGE, motion_file)];

const USAGE: &str = "lassign [motionFile $series $file <-factor $c> <-dt $dt> <-useLast> <-channel $name> <-quantity \
                     $word>] dt npts: a measured file of any format that hysteron recording reads; a time series in the \
                     unit of the file";

const OPTIONS: &[&str] = &["-factor", "-dt", "-useLast", "-channel", "-quantity"];

fn motion_file(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let tag = a.int("tag of the time series")?;
    let tag_span = a.last_span();
    let name = a.word("name of the file")?.into_owned();
    let span = a.last_span();
    let (mut factor, mut given, mut use_last) = (1.0, None, false);
    let (mut channel, mut quantity) = (None, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" | "-fact" => factor = a.float("factor")?,
            "-dt" => given = Some(a.positive("step of time dt")?),
            "-useLast" => use_last = true,
            "-channel" => channel = Some(a.word("name or number of the channel")?.into_owned()),
            "-quantity" => {
                let word = a.word("quantity")?.into_owned();
                let expected = "expected acceleration, velocity, displacement, ...";
                let of =
                    Quantity::named(&word).ok_or_else(|| a.refuse(format!("\"{word}\" is no quantity"), expected))?;
                quantity = Some(of);
            }
            _ => ignore_option(interp, &mut a, OPTIONS)?,
        }
    }
    let path = interp.absolute(&name);
    let bytes = interp.files.read(&path);
    let bytes = bytes.map_err(|e| a.refuse_at(span, format!("cannot read \"{name}\": {e}"), "expected a file"))?;
    let told = Told { dt: given, ..Told::default() };
    // A step beside that of the file replaces it; one beside rounded times explains them.
    let of =
        |m: &Measured| m.series(&Told::default()).or_else(|e| if given.is_some() { m.series(&told) } else { Err(e) });
    let read = Measured::read(&name, &bytes).and_then(|m| Ok((of(&m)?, m)));
    let (all, measured) =
        read.map_err(|e| a.refuse_at(span, format!("\"{name}\": {e}"), "expected a measured file"))?;
    let refuse = |a: &Args<'_>, e: String| a.refuse_at(span, format!("\"{name}\": {e}"), "expected one channel");
    let series = chosen(all, channel.as_deref(), quantity).map_err(|e| refuse(&a, e))?;
    let Some(dt) = given.or(series.clock.dt()) else {
        let message = match measured.accelerations(&told, false) {
            Err(e) if e.message.contains("equal steps") => format!("\"{name}\": {e}"),
            _ => format!("\"{name}\" gives no step of time"),
        };
        return Err(a.refuse_at(span, message, "expected -dt after it"));
    };
    if let Some(i) = series.values.iter().position(|x| !x.is_finite()) {
        return Err(refuse(&a, format!("value {} is missing or not finite", i + 1)));
    }
    let other = series.quantity.filter(|q| quantity.is_none() && matches!(q, Quantity::Velocity | Quantity::Length));
    if let Some(q) = other {
        let message = format!("\"{name}\" holds {} and no accelerations", q.words());
        let warning =
            Diagnostic::warning(message).at(span, "").help(format!("-quantity {} says that it is meant", q.word()));
        warn(interp, warning)?;
    }
    let count = series.values.len();
    let in_g = series.unit.is_some_and(|u| u.name == "g");
    let series: series::Series = Arc::new(Path { values: series.values, dt, factor, use_last, start: 0.0 });
    if in_g && interp.host.mode == Mode::Check {
        interp.host.overview.records_in_g.push((series.clone(), name));
    }
    if !interp.host.builder.definitions.series.add(tag, series) {
        return Err(a.refuse_at(tag_span, format!("there is a time series {tag} already"), "expected a new tag"));
    }
    Ok(Value::list([Value::from(dt), Value::from(count as i64)]))
}

/// The channel of a name or number; else that of the quantity, and of accelerations if none is said.
fn chosen(all: Vec<Series>, channel: Option<&str>, quantity: Option<Quantity>) -> Result<Series, String> {
    let label = |(i, s): (usize, &Series)| if s.name.is_empty() { (i + 1).to_string() } else { s.name.clone() };
    let names = all.iter().enumerate().map(label).collect::<Vec<_>>().join(", ");
    let of_name = |word: &str| {
        let named = all.iter().position(|s| s.name == word || s.direction == word);
        named.or_else(|| word.parse::<usize>().ok()?.checked_sub(1).filter(|i| *i < all.len()))
    };
    let at = match channel {
        Some(word) => of_name(word).ok_or_else(|| format!("there is no channel \"{word}\": they are {names}"))?,
        None => {
            let wanted = quantity.unwrap_or(Quantity::Acceleration);
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
