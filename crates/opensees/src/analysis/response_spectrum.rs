//! `responseSpectrumAnalysis`: a step for each mode with its largest displacements.

use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, warn};
use hysteron_engine::analysis::ModalProperties;
use hysteron_engine::series::Series;
use hysteron_tcl::diagnostic::{Absent, Diagnostic};
use hysteron_tcl::{Call, Exception, Value};
use std::f64::consts::TAU;

const PERIODS: Arg = Arg::of("-Tn", "periods", "periods").within(Domain::NotNegative);
const ACCELERATIONS: Arg = Arg::of("-Sa", "accelerations", "accelerations").within(Domain::NotNegative);
const MODE: Arg = Arg::of("-mode", "mode", "number of the only mode").within(Domain::Count);

pub(crate) const COMMANDS: &[Command] = &[Command::new("responseSpectrumAnalysis", USAGE, response_spectrum)
    .about(
        "Makes a step for each mode with its largest displacements under a response spectrum. The script combines \
         the modes.",
    )
    .arguments(&[
        Arg::thing("series", things::SERIES),
        Arg::thing("direction", things::SERIES),
        PERIODS,
        ACCELERATIONS,
        Arg::of("-scale", "factor", "has no effect in OpenSees either"),
        MODE,
    ])];

const USAGE: &str = "responseSpectrumAnalysis $series $direction | $direction -Tn $periods -Sa $accelerations \
                     <-scale $factor> <-mode $mode>";

/// A spectrum: a series over the period, or points.
enum Spectrum {
    Series(Series),
    Points(Vec<f64>, Vec<f64>),
}

impl Spectrum {
    /// Acceleration at a period: between points linear, beyond them that of the last one.
    fn at(&self, period: f64) -> f64 {
        match self {
            Self::Series(series) => series.factor(period),
            Self::Points(t, s) => match t.partition_point(|x| *x < period) {
                0 => s[0],
                i if i == t.len() => s[i - 1],
                i => s[i - 1] + (s[i] - s[i - 1]) * (period - t[i - 1]) / (t[i] - t[i - 1]),
            },
        }
    }
}

/// The numbers behind an option: words, or one word that is a list.
fn numbers(a: &mut Args<'_>, arg: &Arg) -> Result<Vec<f64>, Exception> {
    let what = arg.meaning;
    let mut out = vec![];
    while a.at_number() {
        out.push(a.number(arg)?);
    }
    if out.is_empty() && a.left() > 0 {
        let word = a.word(what)?.into_owned();
        for number in word.split_whitespace() {
            let value = number.parse::<f64>().ok().filter(|x| *x >= 0.0 && x.is_finite());
            out.push(value.ok_or_else(|| a.refuse(format!("{what}: \"{number}\""), "expected numbers, not negative"))?);
        }
    }
    if out.is_empty() { Err(a.refuse(format!("{what} are missing"), "expected numbers")) } else { Ok(out) }
}

fn response_spectrum(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let has_points = a.ahead().any(|w| matches!(w.as_str().as_ref(), "-Tn" | "-Sa"));
    let series = match has_points {
        true => None,
        false => Some(a.of(&interp.host.builder.definitions.series)?.0),
    };
    let engine = &interp.host.engine;
    let Some(modes) = engine.modes() else {
        let e = a.refuse_at(call.span(0), "there are no modes", "expected a command \"eigen\" before");
        return Err(e.absent(Absent::new(things::MODE, "")));
    };
    let properties = ModalProperties::new(engine.model(), modes, false);
    let (lambda, shapes) = (modes.lambda.clone(), modes.shapes.clone());
    let ndf = properties.factors.first().map_or(0, Vec::len);
    let direction = a.dof("direction", ndf)?;
    let (mut periods, mut accelerations, mut only) = (vec![], vec![], None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-Tn" => periods = numbers(&mut a, &PERIODS)?,
            "-Sa" => accelerations = numbers(&mut a, &ACCELERATIONS)?,
            "-scale" => {
                a.float("factor")?;
                let message = "OpenSees takes -scale and does not use it: multiply the accelerations";
                warn(interp, Diagnostic::warning(&checks::words::UNUSED_WORD, message).at(a.last_span(), "not used"))?;
            }
            "-damp" => drop(a.float("damping")?),
            "-mode" => only = Some(a.count(&MODE)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let spectrum = match series {
        Some(series) => Spectrum::Series(series),
        None if periods.len() != accelerations.len() => {
            let message = format!("there are {} periods, but {} accelerations", periods.len(), accelerations.len());
            return Err(a.refuse_at(call.span(0), message, "expected as many"));
        }
        None if periods.windows(2).any(|w| w[0] >= w[1]) => {
            return Err(a.refuse_at(call.span(0), "the periods do not increase", "expected rising periods"));
        }
        None => Spectrum::Points(periods, accelerations),
    };
    if only.is_some_and(|m| m == 0 || m > lambda.len()) {
        let message = format!("there is no mode {}: there are {}", only.unwrap_or(0), lambda.len());
        return Err(a.refuse_at(call.span(0), message, "expected a mode that \"eigen\" has found"));
    }
    for (i, shape) in shapes.iter().enumerate() {
        if only.is_some_and(|m| m != i + 1) || lambda[i] <= 0.0 {
            continue;
        }
        let period = TAU / lambda[i].sqrt();
        let factor = properties.factors[i][direction] * spectrum.at(period) / lambda[i];
        let session = &mut interp.host;
        let imposed = session.engine.impose(|displacements, model| {
            for n in &model.nodes {
                let pressure = |dof: usize| ndf == 6 && n.ndf == 4 && dof == 3;
                for dof in (0..n.ndf.min(ndf)).filter(|d| !pressure(*d)) {
                    displacements[n.offset + dof] = factor * shape[n.offset + dof];
                }
            }
        });
        imposed.map_err(|e| call.error_at(0, e.to_string(), ""))?;
        let done = session.output.recorders.record(&mut session.engine);
        done.map_err(|e| call.error_at(0, e.to_string(), ""))?;
    }
    Ok(Value::from(0i64))
}
