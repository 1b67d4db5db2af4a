//! `motionFile`: a time series from a file of a ground motion.

use crate::args::Args;
use crate::files::motion;
use crate::session::Mode;
use crate::{Command, Outcome, Tcl, ignore_option, read_text};
use hysteron_engine::series::{Path, Series};
use hysteron_tcl::{Call, Value};
use std::sync::Arc;

pub(crate) const COMMANDS: &[Command] = &[Command::new("motionFile", USAGE, motion_file)];

const USAGE: &str = "lassign [motionFile $series $file <-factor $c> <-dt $dt> <-useLast>] dt npts: PEER AT2, CSMIP V2, or \
                     one column of values, or two of times and values; a time series in the unit of the file";

/// Lines of a header that name the unit of a record.
const HEADER_LINES: usize = 6;

fn motion_file(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let tag = a.int("tag of the time series")?;
    let tag_span = a.last_span();
    let name = a.word("name of the file")?.into_owned();
    let span = a.last_span();
    let (mut factor, mut given, mut use_last) = (1.0, None, false);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factor" | "-fact" => factor = a.float("factor")?,
            "-dt" => given = Some(a.positive("step of time dt")?),
            "-useLast" => use_last = true,
            _ => ignore_option(interp, &mut a, &["-factor", "-dt", "-useLast"])?,
        }
    }
    let text = read_text(interp, &name)
        .map_err(|e| a.refuse_at(span, format!("cannot read \"{name}\": {e}"), "expected a file"))?;
    let m =
        motion::parse(&text).map_err(|e| a.refuse_at(span, format!("\"{name}\": {e}"), "expected a ground motion"))?;
    let Some(dt) = given.or(m.dt) else {
        return Err(a.refuse_at(span, format!("\"{name}\" gives no step of time"), "expected -dt after it"));
    };
    let count = m.values.len();
    let series: Series = Arc::new(Path { values: m.values, dt, factor, use_last, start: 0.0 });
    let says_g = text.lines().take(HEADER_LINES).any(|line| line.to_ascii_uppercase().contains("UNITS OF G"));
    if says_g && interp.host.mode == Mode::Check {
        interp.host.overview.records_in_g.push((series.clone(), name));
    }
    if !interp.host.builder.definitions.series.add(tag, series) {
        return Err(a.refuse_at(tag_span, format!("there is a time series {tag} already"), "expected a new tag"));
    }
    Ok(Value::list([Value::from(dt), Value::from(count as i64)]))
}
