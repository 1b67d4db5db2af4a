//! The parts of an analysis: `constraints numberer system test`.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::analysis::{Measure, Norm, Test};
use hysteron_engine::assembly::Handler;
use hysteron_tcl::{Call, Value};

pub(crate) const COMMANDS: &[Command] = &[
    Command { name: "constraints", usage: CONSTRAINTS, run: constraints },
    Command { name: "numberer", usage: NUMBERER, run: numberer },
    Command { name: "system", usage: SYSTEM, run: system },
    Command { name: "test", usage: TEST, run: test },
];

const CONSTRAINTS: &str = "constraints Plain | Transformation | Penalty $alphaS $alphaM | Lagrange <$alphaS $alphaM>";
const NUMBERER: &str = "numberer Plain | RCM | AMD";
const SYSTEM: &str = "system BandGeneral | BandSPD | ProfileSPD | SparseGeneral | UmfPack | FullGeneral | ...";
const TEST: &str = "test $kind $tolerance $maxIterations <$printFlag> <$norm>";

fn constraints(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, CONSTRAINTS);
    let handler = match a.word("kind of constraint handler")?.as_ref() {
        "Plain" => Handler::Plain,
        // `Auto` chooses penalties; eliminating is exact and as general.
        "Transformation" | "Auto" => {
            while a.option().is_some() {}
            Handler::Transformation
        }
        "Penalty" => Handler::Penalty {
            single: a.positive("penalty alphaS of single-point constraints")?,
            multi: a.positive("penalty alphaM of multi-point constraints")?,
        },
        "Lagrange" => {
            let single = a.optional_float("factor alphaS")?.unwrap_or(1.0);
            Handler::Lagrange { single, multi: a.optional_float("factor alphaM")?.unwrap_or(1.0) }
        }
        _ => {
            return Err(
                a.unknown_name("constraint handler", ["Plain", "Transformation", "Penalty", "Lagrange", "Auto"])
            );
        }
    };
    finish(interp, &a)?;
    interp.host.parts.handler = Some(handler);
    interp.host.engine.change_setup(|s| s.handler = handler);
    Ok(Value::EMPTY)
}

/// The numbering is our own: it fits the solver.
fn numberer(_: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, NUMBERER);
    let known = ["Plain", "RCM", "AMD", "ParallelPlain", "ParallelRCM"];
    if !known.contains(&a.word("kind of numberer")?.as_ref()) {
        return Err(a.unknown_name("numberer", known));
    }
    Ok(Value::EMPTY)
}

/// The solver is our own: it fits the size and the symmetry of the equations.
fn system(_: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SYSTEM);
    let known = [
        "BandGeneral",
        "BandGEN",
        "BandGen",
        "BandSPD",
        "ProfileSPD",
        "SProfileSPD",
        "ParallelProfileSPD",
        "SparseGeneral",
        "SparseGEN",
        "SuperLU",
        "SparseSPD",
        "SparseSYM",
        "Sparse",
        "UmfPack",
        "Umfpack",
        "FullGeneral",
        "FullGen",
        "Diagonal",
        "MPIDiagonal",
        "Mumps",
        "Petsc",
        "Itpack",
        "CuSP",
        "PFEM",
    ];
    if !known.contains(&a.word("kind of system")?.as_ref()) {
        return Err(a.unknown_name("system of equations", known));
    }
    Ok(Value::EMPTY)
}

const TESTS: [(&str, Measure); 10] = [
    ("NormDispIncr", Measure::DispIncr),
    ("NormUnbalance", Measure::Unbalance),
    ("EnergyIncr", Measure::Energy),
    ("RelativeNormDispIncr", Measure::RelativeDispIncr),
    ("RelativeNormUnbalance", Measure::RelativeUnbalance),
    ("RelativeEnergyIncr", Measure::RelativeEnergy),
    ("RelativeTotalNormDispIncr", Measure::RelativeTotalDispIncr),
    ("FixedNumIter", Measure::FixedIterations),
    ("NormDispAndUnbalance", Measure::DispAndUnbalance),
    ("NormDispOrUnbalance", Measure::DispOrUnbalance),
];

fn test(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, TEST);
    let name = a.word("kind of test")?;
    let Some((_, measure)) = TESTS.iter().find(|t| t.0 == name) else {
        return Err(a.unknown_name("convergence test", TESTS.map(|t| t.0)));
    };
    let two = matches!(measure, Measure::DispAndUnbalance | Measure::DispOrUnbalance);
    let tolerance = if *measure == Measure::FixedIterations { 0.0 } else { a.not_negative("tolerance")? };
    let second = if two { a.not_negative("tolerance of the unbalance")? } else { tolerance };
    let mut t = Test::new(*measure, tolerance, a.count("largest number of iterations")?);
    t.second_tolerance = second;
    let print = a.optional_int("print flag")?.unwrap_or(0);
    t.accept_unconverged = matches!(print, 5 | 6);
    t.norm = match a.optional_int("kind of norm")? {
        Some(0) => Norm::Max,
        Some(p) if p > 0 => Norm::P(p as u32),
        Some(p) => return Err(a.refuse(format!("the kind of norm is {p}"), "expected 0 for the largest, 1, 2, ...")),
        None => Norm::P(2),
    };
    if matches!(measure, Measure::Unbalance | Measure::DispAndUnbalance | Measure::DispOrUnbalance) {
        t.max_increases = a.optional_int("number of increases allowed")?.filter(|n| *n > 0).map(|n| n as usize);
    }
    if let Some(limit) = a.optional_float("largest norm allowed")? {
        t.max_norm = limit;
    }
    finish(interp, &a)?;
    interp.host.parts.print = print;
    interp.host.parts.test = Some(t.clone());
    interp.host.engine.change_setup(|s| s.test = t);
    Ok(Value::EMPTY)
}
