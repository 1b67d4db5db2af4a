//! `sdfResponse`: an elastic-plastic system of one degree of freedom under a series of forces.

use crate::args::Args;
use crate::effect::Effect;
use crate::load::series::series_of_words;
use crate::text::{Arg, Domain};
use crate::{Command, Outcome, Tcl, ignore_unknown};
use hysteron_engine::analysis::{SingleDegree, SingleDegreeResponse, SingleDegreeSpan};
use hysteron_tcl::{Call, Value};

const SYSTEM: [Arg; 5] = [
    Arg::positive("m", "mass m"),
    Arg::not_negative("zeta", "damping ratio zeta"),
    Arg::positive("k", "stiffness k"),
    Arg::positive("Fy", "yield force Fy"),
    Arg::not_negative("alpha", "hardening ratio alpha"),
];
const DT: Arg = Arg::positive("dt", "step dt");
const RESIDUAL: Arg = Arg::of("-uresid", "u", "residual displacement").within(Domain::Number);
const LARGEST: Arg = Arg::of("-umaxprev", "u", "earlier largest displacement").within(Domain::Number);
const END: Arg = Arg::of("-tend", "t", "time of the end").within(Domain::Number);

pub(crate) const COMMANDS: &[Command] = &[Command::new("sdfResponse", USAGE, respond)
    .about(
        "Returns the largest and the last displacement, the plastic one, the largest acceleration and its time of \
         an elastic-plastic system of one degree of freedom under a series of forces.",
    )
    .arguments(&[
        SYSTEM[0],
        SYSTEM[1],
        SYSTEM[2],
        SYSTEM[3],
        SYSTEM[4],
        Arg::whole("dtF", "step of the forces in the file"),
        Arg::new("file", "file of forces"),
        Arg::whole("series", "tag of a time series of forces"),
        DT,
        RESIDUAL,
        LARGEST,
        END,
    ])
    .leaving(Effect::Nothing)];

const USAGE: &str = "sdfResponse $m $zeta $k $Fy $alpha $dtF $file $dt or $m $zeta $k $Fy $alpha $series $dt \
                     <-uresid $u> <-umaxprev $u> <-tend $t>";

/// Steps at most: a step that is too short would never end.
const MAX_STEPS: f64 = 1e8;

fn respond(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let [mass, damping, stiffness, yield_force, hardening] = a.numbers(&SYSTEM)?;
    if hardening >= 1.0 {
        return Err(a.refuse(format!("a hardening ratio of {hardening}"), "expected less than 1"));
    }
    // A step, a file and a step, or a tag and a step.
    let numbers = a.ahead().take_while(|v| !v.as_str().starts_with('-')).count();
    let force = if numbers > 2 {
        let step = a.value("step dtF of the file")?;
        let file = a.value("file of forces")?;
        series_of_words(interp, &[Value::from("Path"), Value::from("-dt"), step, Value::from("-filePath"), file])?
    } else {
        a.of(&interp.host.builder.definitions.series)?.0
    };
    let dt = a.number(&DT)?;
    let (series, mut end) = (a.last_span(), force.end());
    let mut span = SingleDegreeSpan { dt, end: 0.0, residual: 0.0, largest: 0.0 };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-uresid" | "-uresidual" => span.residual = a.number(&RESIDUAL)?,
            "-umaxprev" => span.largest = a.number(&LARGEST)?,
            "-tend" => end = Some(a.number(&END)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    span.end =
        end.ok_or_else(|| a.refuse_at(series, "the series of forces has no end", "expected -tend $t behind it"))?;
    if (span.end - force.start()) / dt > MAX_STEPS {
        return Err(a.refuse(format!("more than {MAX_STEPS:.0e} steps"), "expected a longer step dt"));
    }
    let system = SingleDegree { mass, damping, stiffness, yield_force, hardening };
    let SingleDegreeResponse { largest, end, plastic, acceleration, time } = system.response(&*force, &span);
    let found = [largest, end, plastic, acceleration, time];
    if found.iter().any(|x| !x.is_finite()) {
        return Err(a.refuse("the response is not finite", "expected a shorter step dt or smaller forces"));
    }
    Ok(Value::list(found.into_iter().map(Value::from)))
}
