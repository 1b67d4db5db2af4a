//! The parts of an analysis: `constraints numberer system test`.

use crate::args::Args;
use crate::checks;
use crate::kind::{self, Kind};
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::analysis::{MatrixTerms, Measure, Norm, Test};
use hysteron_engine::assembly::Handler;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("constraints", CONSTRAINTS, constraints).with_kinds(|| kind::usages(HANDLERS)),
    Command::new("numberer", NUMBERER, numberer).with_kinds(|| kind::usages(NUMBERERS)),
    Command::new("system", SYSTEM, system).with_kinds(|| kind::usages(SYSTEMS)),
    Command::new("test", TEST, test).with_kinds(|| kind::usages(TESTS)),
];

const CONSTRAINTS: &str = "constraints Plain | Transformation | Penalty $alphaS $alphaM | Lagrange <$alphaS $alphaM>";
const NUMBERER: &str = "numberer Plain | RCM | AMD";
const SYSTEM: &str = "system BandGeneral | BandSPD | ProfileSPD | SparseGeneral | UmfPack | FullGeneral | ...";
const TEST: &str = "test $kind $tolerance $maxIterations <$printFlag> <$norm>";

type MakeHandler = fn(&mut Tcl, &mut Args<'_>) -> Result<Handler, Exception>;

const HANDLERS: &[Kind<MakeHandler>] = &[
    Kind { names: &["Plain"], usage: "constraints Plain", make: |_, _| Ok(Handler::Plain) },
    // `Auto` chooses penalties; eliminating is exact and as general.
    Kind { names: &["Transformation", "Auto"], usage: "constraints Transformation", make: transformation },
    Kind { names: &["Penalty"], usage: "constraints Penalty $alphaS $alphaM", make: penalty },
    Kind { names: &["Lagrange"], usage: "constraints Lagrange <$alphaS $alphaM>", make: lagrange },
];

fn transformation(_: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    while a.option().is_some() {}
    Ok(Handler::Transformation)
}

fn penalty(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    let single = penalty_of(interp, a, "penalty alphaS of single-point constraints")?;
    let multi = penalty_of(interp, a, "penalty alphaM of multi-point constraints")?;
    Ok(Handler::Penalty { single, multi })
}

/// A penalty. One of 0 gives the matrices of the model without its constraints, which some programs ask for.
fn penalty_of(interp: &mut Tcl, a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    let x = a.usually_not_negative(interp, what)?;
    if x == 0.0 {
        let message = format!("{what} is 0: the analysis does without them");
        let d = Diagnostic::warning(&checks::analysis::NO_PENALTY, message);
        warn(interp, d.at(a.last_span(), "as in OpenSees"))?;
    }
    Ok(x)
}

fn lagrange(_: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    let single = a.optional_float("factor alphaS")?.unwrap_or(1.0);
    Ok(Handler::Lagrange { single, multi: a.optional_float("factor alphaM")?.unwrap_or(1.0) })
}

fn constraints(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, CONSTRAINTS);
    let kind = kind::take(&mut a, "kind of constraint handler", "constraint handler", HANDLERS.iter())?;
    let handler = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    interp.host.parts.handler = Some(handler);
    interp.host.engine.change_setup(|s| s.handler = handler);
    Ok(Value::EMPTY)
}

const NUMBERERS: &[Kind<()>] = &[
    Kind { names: &["Plain", "ParallelPlain"], usage: "numberer Plain", make: () },
    Kind { names: &["RCM", "ParallelRCM"], usage: "numberer RCM", make: () },
    Kind { names: &["AMD"], usage: "numberer AMD", make: () },
];

/// The numbering is our own: it fits the solver.
fn numberer(_: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, NUMBERER);
    kind::take(&mut a, "kind of numberer", "numberer", NUMBERERS.iter())?;
    Ok(Value::EMPTY)
}

/// Systems with the terms that their matrix holds in OpenSees.
const SYSTEMS: &[Kind<MatrixTerms>] = &[
    Kind { names: &["BandGeneral", "BandGEN", "BandGen"], usage: "system BandGeneral", make: MatrixTerms::OfElements },
    Kind { names: &["BandSPD"], usage: "system BandSPD", make: MatrixTerms::OfElements },
    Kind {
        names: &["ProfileSPD", "SProfileSPD", "ParallelProfileSPD"],
        usage: "system ProfileSPD",
        make: MatrixTerms::OfElements,
    },
    Kind {
        names: &["SparseGeneral", "SparseGEN", "SparseGen", "SuperLU", "Sparse"],
        usage: "system SparseGeneral",
        make: MatrixTerms::OfElements,
    },
    Kind { names: &["SparseSPD", "SparseSYM"], usage: "system SparseSPD", make: MatrixTerms::OfElements },
    Kind { names: &["UmfPack", "Umfpack"], usage: "system UmfPack", make: MatrixTerms::OfElements },
    Kind { names: &["FullGeneral", "FullGen"], usage: "system FullGeneral", make: MatrixTerms::All },
    Kind { names: &["Diagonal", "MPIDiagonal"], usage: "system Diagonal", make: MatrixTerms::Diagonal },
    Kind { names: &["Mumps"], usage: "system Mumps", make: MatrixTerms::OfElements },
    Kind { names: &["Petsc"], usage: "system Petsc", make: MatrixTerms::OfElements },
    Kind { names: &["Itpack"], usage: "system Itpack", make: MatrixTerms::OfElements },
    Kind { names: &["CuSP"], usage: "system CuSP", make: MatrixTerms::OfElements },
    Kind { names: &["PFEM"], usage: "system PFEM", make: MatrixTerms::OfElements },
];

/// The solver is our own: it fits the size and the symmetry of the equations.
fn system(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SYSTEM);
    let matrix_terms = kind::take(&mut a, "kind of system", "system of equations", SYSTEMS.iter())?.make;
    interp.host.parts.matrix_terms = Some(matrix_terms);
    interp.host.engine.change_setup(|s| s.matrix_terms = matrix_terms);
    Ok(Value::EMPTY)
}

const fn test_of(names: &'static [&'static str], usage: &'static str, make: Measure) -> Kind<Measure> {
    Kind { names, usage, make }
}

const TESTS: &[Kind<Measure>] = &[
    test_of(&["NormDispIncr"], "test NormDispIncr $tolerance $maxIterations <$printFlag> <$norm>", Measure::DispIncr),
    test_of(
        &["NormUnbalance"],
        "test NormUnbalance $tolerance $maxIterations <$printFlag> <$norm>",
        Measure::Unbalance,
    ),
    test_of(&["EnergyIncr"], "test EnergyIncr $tolerance $maxIterations <$printFlag> <$norm>", Measure::Energy),
    test_of(
        &["RelativeNormDispIncr"],
        "test RelativeNormDispIncr $tolerance $maxIterations <$printFlag> <$norm>",
        Measure::RelativeDispIncr,
    ),
    test_of(
        &["RelativeNormUnbalance"],
        "test RelativeNormUnbalance $tolerance $maxIterations <$printFlag> <$norm>",
        Measure::RelativeUnbalance,
    ),
    test_of(
        &["RelativeEnergyIncr"],
        "test RelativeEnergyIncr $tolerance $maxIterations <$printFlag> <$norm>",
        Measure::RelativeEnergy,
    ),
    test_of(
        &["RelativeTotalNormDispIncr"],
        "test RelativeTotalNormDispIncr $tolerance $maxIterations <$printFlag> <$norm>",
        Measure::RelativeTotalDispIncr,
    ),
    test_of(&["FixedNumIter"], "test FixedNumIter $iterations <$printFlag> <$norm>", Measure::FixedIterations),
    test_of(
        &["NormDispAndUnbalance"],
        "test NormDispAndUnbalance $tolDisp $tolUnbalance $maxIterations <$printFlag> <$norm>",
        Measure::DispAndUnbalance,
    ),
    test_of(
        &["NormDispOrUnbalance"],
        "test NormDispOrUnbalance $tolDisp $tolUnbalance $maxIterations <$printFlag> <$norm>",
        Measure::DispOrUnbalance,
    ),
];

/// Largest number of iterations of the test that OpenSees takes where a script has none.
const DEFAULT_ITERATIONS: usize = 25;

/// OpenSees makes one iteration whatever the number is.
fn iterations(interp: &mut Tcl, a: &mut Args<'_>) -> Result<usize, Exception> {
    let n = a.int("largest number of iterations")?;
    if n < 1 {
        let label = "expected the largest number of iterations, at least 1";
        a.doubt(interp, format!("largest number of iterations is {n}"), label)?;
    }
    Ok(n.max(1) as usize)
}

fn test(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, TEST);
    let measure = &kind::take(&mut a, "kind of test", "convergence test", TESTS.iter())?.make;
    let two = matches!(measure, Measure::DispAndUnbalance | Measure::DispOrUnbalance);
    let tolerance =
        if *measure == Measure::FixedIterations { 0.0 } else { a.usually_not_negative(interp, "tolerance")? };
    let second = if two { a.not_negative("tolerance of the unbalance")? } else { tolerance };
    let iterations = if a.left() == 0 && *measure != Measure::FixedIterations {
        let message =
            format!("test: the largest number of iterations is missing and is taken for {DEFAULT_ITERATIONS}");
        warn(
            interp,
            Diagnostic::warning(&checks::words::MISSING_WORD, message)
                .at(a.last_span(), "expected the number after this"),
        )?;
        DEFAULT_ITERATIONS
    } else {
        iterations(interp, &mut a)?
    };
    let mut t = Test::new(*measure, tolerance, iterations);
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
