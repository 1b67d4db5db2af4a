//! `defaultUnits`: variables with the sizes of units.

use crate::args::Args;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown};
use hysteron_tcl::{Call, Exception, Value};
use std::f64::consts::PI;

const TEMP_UNIT: Arg = Arg::of("-temp", "unit", "unit of temperature");

pub(crate) const COMMANDS: &[Command] = &[Command::new("defaultUnits", USAGE, default_units)
    .about("Sets variables with the sizes of units: `$kip`, `$in`, `$ksi`, `$g` and others.")
    .arguments(&[TEMP_UNIT, Arg::flag("-force", "unit of force"), Arg::flag("-length", "unit of length")])];

const USAGE: &str = "defaultUnits -force lb|kip|N|kN|MN|kgf|tonf -length in|ft|mm|cm|m -time sec|msec <-temp $unit>";

/// Newtons in a pound.
const POUND: f64 = 4.448_221_615_260_5;
/// Metres in an inch.
const INCH: f64 = 0.0254;
/// Standard gravity, in metres by second squared.
const GRAVITY: f64 = 9.806_65;
/// Gravity as OpenSees has it, in feet by second squared.
const GRAVITY_IN_FEET: f64 = 32.174_049;

/// Names of units of force, and newtons in each.
const FORCES: &[(&[&str], f64)] = &[
    (&["lb", "lbs", "lbf"], POUND),
    (&["kip", "kips"], 1e3 * POUND),
    (&["N", "Newton"], 1.0),
    (&["kN", "KN", "kn", "kNewton"], 1e3),
    (&["MN", "mN", "mn"], 1e6),
    (&["kgf"], GRAVITY),
    (&["tonf"], 1e3 * GRAVITY),
];
/// Names of units of length, and metres in each.
const LENGTHS: &[(&[&str], f64)] = &[
    (&["in", "inch"], INCH),
    (&["ft", "feet"], 12.0 * INCH),
    (&["mm"], 1e-3),
    (&["cm"], 1e-2),
    (&["m", "meter"], 1.0),
];
/// Names of units of time, and seconds in each.
const TIMES: &[(&[&str], f64)] = &[(&["sec", "Sec"], 1.0), (&["msec", "mSec"], 1e-3)];

/// Size of the unit that the next word names.
fn unit(a: &mut Args<'_>, what: &str, known: &'static [(&'static [&'static str], f64)]) -> Result<f64, Exception> {
    let name = a.word(&format!("unit of {what}"))?;
    match known.iter().find(|(names, _)| names.contains(&name.as_ref())) {
        Some((_, size)) => Ok(*size),
        None => Err(a.unknown_kind(&format!("unit of {what}"), known.iter().map(|(names, _)| names[0]))),
    }
}

fn default_units(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let (mut force, mut length, mut time) = (None, None, None);
    while let Some(option) = a.option() {
        match option.to_ascii_lowercase().as_str() {
            "-force" => force = Some(unit(&mut a, "force", FORCES)?),
            "-length" => length = Some(unit(&mut a, "length", LENGTHS)?),
            "-time" => time = Some(unit(&mut a, "time", TIMES)?),
            "-temp" | "-temperature" => drop(a.word(TEMP_UNIT.meaning)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let missing = |what: &str| {
        a.refuse_at(call.span(0), format!("the unit of {what} is missing"), "expected -force, -length and -time")
    };
    let force = force.ok_or_else(|| missing("force"))?;
    let length = length.ok_or_else(|| missing("length"))?;
    let time = time.ok_or_else(|| missing("time"))?;
    finish(interp, &a)?;
    for (name, value) in variables(force, length, time) {
        interp.set_var(name, Value::from(value))?;
    }
    Ok(Value::EMPTY)
}

/// Variables of OpenSees with their values in the units chosen: newtons, metres and seconds in each.
fn variables(force: f64, length: f64, time: f64) -> Vec<(&'static str, f64)> {
    let (n, m, sec) = (1.0 / force, 1.0 / length, 1.0 / time);
    let (lb, kip, inch, ft) = (POUND * n, 1e3 * POUND * n, INCH * m, 12.0 * INCH * m);
    let (mm, cm, kg) = (1e-3 * m, 1e-2 * m, n * sec * sec / m);
    vec![
        ("lb", lb),
        ("lbf", lb),
        ("kip", kip),
        ("N", n),
        ("Newton", n),
        ("kN", 1e3 * n),
        ("kNewton", 1e3 * n),
        ("MN", 1e6 * n),
        ("kgf", GRAVITY * n),
        ("tonf", 1e3 * GRAVITY * n),
        ("in", inch),
        ("inch", inch),
        ("ft", ft),
        ("mm", mm),
        ("cm", cm),
        ("m", m),
        ("meter", m),
        ("sec", sec),
        ("msec", 1e-3 * sec),
        ("g", GRAVITY_IN_FEET * ft / (sec * sec)),
        ("kg", kg),
        ("Mg", 1e3 * kg),
        ("slug", lb * sec * sec / ft),
        ("Pa", n / (m * m)),
        ("kPa", 1e3 * n / (m * m)),
        ("MPa", 1e6 * n / (m * m)),
        ("psi", lb / (inch * inch)),
        ("ksi", kip / (inch * inch)),
        ("psf", lb / (ft * ft)),
        ("ksf", kip / (ft * ft)),
        ("pcf", lb / (ft * ft * ft)),
        ("in2", inch.powi(2)),
        ("ft2", ft.powi(2)),
        ("mm2", mm.powi(2)),
        ("cm2", cm.powi(2)),
        ("m2", m.powi(2)),
        ("in4", inch.powi(4)),
        ("ft4", ft.powi(4)),
        ("mm4", mm.powi(4)),
        ("cm4", cm.powi(4)),
        ("m4", m.powi(4)),
        ("pi", PI),
        ("PI", PI),
    ]
}
