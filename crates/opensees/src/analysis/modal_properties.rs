//! `modalProperties`.

use crate::args::Args;
use crate::effect::Effect;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, print_error};
use hysteron_engine::analysis::{ModalProperties, cumulative};
use hysteron_engine::number_format::Style;
use hysteron_tcl::diagnostic::Absent;
use hysteron_tcl::{Call, OpenMode, Value};
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::io::Write as _;

const FILE: Arg = Arg::of("-file", "file", "name of the file");

pub(crate) const COMMANDS: &[Command] = &[Command::new("modalProperties", USAGE, modal_properties)
    .arguments(&[FILE])
    .about("Computes participation factors and effective masses of the modes.")
    .leaving(Effect::Nothing)];

const USAGE: &str = "modalProperties <-print> <-file $file> <-unorm> <-return>";

fn modal_properties(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let (mut print, mut file, mut unit, mut give) = (false, None, false, false);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-print" => print = true,
            "-unorm" => unit = true,
            "-return" => give = true,
            "-file" => file = Some((a.word(FILE.meaning)?.into_owned(), a.last_span())),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let engine = &interp.host.engine;
    let Some(modes) = engine.modes() else {
        let e = a.refuse_at(call.span(0), "there are no modes", "expected a command \"eigen\" before");
        return Err(e.absent(Absent::new(things::MODE, "")));
    };
    let ndm = engine.model().nodes.first().map_or(0, hysteron_engine::model::Node::ndm);
    if engine.model().nodes.iter().any(|n| n.ndm() != ndm) {
        let message = "modalProperties: the nodes have different numbers of dimensions";
        return Err(a.refuse_at(call.span(0), message, "expected a model in the plane or in space"));
    }
    let properties = ModalProperties::new(engine.model(), modes, unit);
    if print {
        print_error(interp, &report(&properties));
    }
    if let Some((name, span)) = file {
        let path = interp.absolute(&name);
        let mode = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
        let written = interp.files.open(&path, mode).and_then(|mut f| f.write_all(report(&properties).as_bytes()));
        written.map_err(|e| a.refuse_at(span, format!("cannot write \"{name}\": {e}"), "cannot write here"))?;
    }
    Ok(if give { dictionary(&properties) } else { Value::EMPTY })
}

/// Names of the directions.
fn directions(ndm: usize) -> &'static [&'static str] {
    match ndm {
        1 => &["MX"],
        2 => &["MX", "MY", "RMZ"],
        _ => &["MX", "MY", "MZ", "RMX", "RMY", "RMZ"],
    }
}

/// λ, ω, frequency and period of a mode.
fn speeds(lambda: f64) -> [f64; 4] {
    let omega = lambda.sqrt();
    let frequency = omega / (2.0 * PI);
    [lambda, omega, frequency, 1.0 / frequency]
}

/// The properties by name, as OpenSees' `-return` gives them: lists over the modes; ratios are percentages.
fn dictionary(p: &ModalProperties) -> Value {
    let list = |values: &mut dyn Iterator<Item = f64>| Value::list(values.map(Value::from));
    let mut out: Vec<Value> = vec![];
    let mut put = |name: String, values: Value| out.extend([Value::from(name), values]);
    put("domainSize".to_owned(), list(&mut std::iter::once(p.ndm as f64)));
    for (i, name) in ["eigenLambda", "eigenOmega", "eigenFrequency", "eigenPeriod"].into_iter().enumerate() {
        put(name.to_owned(), list(&mut p.lambda.iter().map(|l| speeds(*l)[i])));
    }
    put("totalMass".to_owned(), list(&mut p.total_mass.iter().copied()));
    put("totalFreeMass".to_owned(), list(&mut p.free_mass.iter().copied()));
    put("centerOfMass".to_owned(), list(&mut p.center.iter().copied()));
    let ratios = p.ratios();
    for (name, rows, scale) in [
        ("partiFactor", &p.factors, 1.0),
        ("partiMass", &p.masses, 1.0),
        ("partiMassesCumu", &cumulative(&p.masses), 1.0),
        ("partiMassRatios", &ratios, 100.0),
        ("partiMassRatiosCumu", &cumulative(&ratios), 100.0),
    ] {
        // Those of the plane come first.
        let directions = directions(p.ndm).iter().enumerate();
        let (plane, space): (Vec<_>, Vec<_>) = directions.partition(|(_, d)| ["MX", "MY", "RMZ"].contains(d));
        for (i, direction) in plane.into_iter().chain(space) {
            put(format!("{name}{direction}"), list(&mut rows.iter().map(|r| scale * r[i])));
        }
    }
    Value::list(out)
}

/// Numbers in columns of 14 characters; those that are only round-off beside `largest` are zero.
fn columns(values: impl IntoIterator<Item = f64>, largest: f64) -> String {
    let tolerance = (1e-12 * largest).max(1e-16);
    let mut out = String::new();
    for x in values {
        let mut text = String::new();
        Style::default().push(if x.abs() > tolerance { x } else { 0.0 }, &mut text);
        let _ = write!(out, "{text:>14}");
    }
    out
}

fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |max: f64, x| max.max(x.abs()))
}

/// The title of a table with a line of names.
fn head(out: &mut String, title: &str, comments: &[&str], names: &[&str]) {
    let _ = writeln!(out, "* {title}:");
    comments.iter().for_each(|c| {
        let _ = writeln!(out, "# {c}");
    });
    let line = |cell: &dyn Fn(&str) -> String| names.iter().map(|n| cell(n)).collect::<String>();
    let _ = writeln!(out, "#{}", line(&|n| format!("{n:>14}")));
    let _ = writeln!(out, "#{}", line(&|_| " -------------".to_owned()));
}

/// OpenSees' report.
fn report(p: &ModalProperties) -> String {
    let mut out = format!(
        "# MODAL ANALYSIS REPORT\n\n* 1. DOMAIN SIZE:\n# This is the size of the problem: 1 for 1D problems, 2 for 2D \
         problems, 3 for 3D problems.\n{}\n\n\n",
        p.ndm
    );
    head(&mut out, "2. EIGENVALUE ANALYSIS", &[], &["MODE", "LAMBDA", "OMEGA", "FREQUENCY", "PERIOD"]);
    for (i, lambda) in p.lambda.iter().enumerate() {
        let _ = writeln!(out, " {:>14}{}", i + 1, columns(speeds(*lambda), 0.0));
    }
    let names = directions(p.ndm);
    let axes = &["X", "Y", "Z"][..p.ndm.min(3)];
    let what = "The total masses (translational and rotational) of the structure";
    for (title, comments, names, values) in [
        (
            "3. TOTAL MASS OF THE STRUCTURE",
            &[what, "including the masses at fixed DOFs (if any)."][..],
            names,
            &p.total_mass,
        ),
        (
            "4. TOTAL FREE MASS OF THE STRUCTURE",
            &[what, "including only the masses at free DOFs."],
            names,
            &p.free_mass,
        ),
        ("5. CENTER OF MASS", &["The center of mass of the structure, calculated from free masses."], axes, &p.center),
    ] {
        out.push_str("\n\n");
        head(&mut out, title, comments, names);
        let _ = writeln!(out, " {}", columns(values.iter().copied(), largest(values)));
    }
    let ratios = p.ratios();
    let with_mode = [&["MODE"], names].concat();
    for (title, comments, rows, scale) in [
        (
            "6. MODAL PARTICIPATION FACTORS",
            &[
                "The participation factor for a certain mode 'a' in a certain direction 'i'",
                "indicates how strongly displacement along (or rotation about)",
                "the global axes is represented in the eigenvector of that mode.",
            ][..],
            &p.factors,
            1.0,
        ),
        ("7. MODAL PARTICIPATION MASSES", &["The modal participation masses for each mode."], &p.masses, 1.0),
        (
            "8. MODAL PARTICIPATION MASSES (cumulative)",
            &["The cumulative modal participation masses for each mode."],
            &cumulative(&p.masses),
            1.0,
        ),
        (
            "9. MODAL PARTICIPATION MASS RATIOS (%)",
            &["The modal participation mass ratios (%) for each mode."],
            &ratios,
            100.0,
        ),
        (
            "10. MODAL PARTICIPATION MASS RATIOS (%) (cumulative)",
            &["The cumulative modal participation mass ratios (%) for each mode."],
            &cumulative(&ratios),
            100.0,
        ),
    ] {
        out.push_str("\n\n");
        head(&mut out, title, comments, &with_mode);
        let top = scale * largest(rows.iter().flatten());
        for (i, row) in rows.iter().enumerate() {
            let _ = writeln!(out, " {:>14}{}", i + 1, columns(row.iter().map(|x| scale * x), top));
        }
    }
    out.push_str("\n\n");
    out
}
