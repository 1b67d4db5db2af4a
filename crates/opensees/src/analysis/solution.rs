//! The parts of an analysis: `constraints numberer system test`.

use crate::args::Args;
use crate::checks;
use crate::kind::{self, Kind};
use crate::text::{Arg, Domain, Text};
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::analysis::{MatrixTerms, Measure, Norm, Test};
use hysteron_engine::assembly::Handler;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const PENALTY_ALPHA_S: Arg =
    Arg::of_domain("alphaS", "penalty alphaS of single-point constraints", Domain::UsuallyNotNegative);
const PENALTY_ALPHA_M: Arg =
    Arg::of_domain("alphaM", "penalty alphaM of multi-point constraints", Domain::UsuallyNotNegative);
const LAGRANGE_ALPHA_S: Arg = Arg::number("alphaS", "factor alphaS");
const LAGRANGE_ALPHA_M: Arg = Arg::number("alphaM", "factor alphaM");
const ITERATIONS: Arg = Arg::count("iterations", "largest number of iterations");
const TOL_DISP: Arg = Arg::of_domain("tolDisp", "tolerance", Domain::UsuallyNotNegative);
const TOL_UNBALANCE: Arg = Arg::not_negative("tolUnbalance", "tolerance of the unbalance");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("constraints", CONSTRAINTS, constraints)
        .arguments(&[PENALTY_ALPHA_S, PENALTY_ALPHA_M])
        .about("Chooses how constraints are enforced.")
        .with_kinds(|| kind::usages(HANDLERS)),
    Command::new("numberer", NUMBERER, numberer)
        .about("Chooses the order of the equations. Every name is accepted.")
        .with_kinds(|| kind::usages(NUMBERERS)),
    Command::new("system", SYSTEM, system)
        .about("Chooses the solver. Every name is accepted; see [Solvers](../conventions.md#solvers).")
        .with_kinds(|| kind::usages(SYSTEMS)),
    Command::new("test", TEST, test)
        .about("Chooses the test of convergence.")
        .arguments(&[
            TOL_DISP.called("tolerance"),
            ITERATIONS.called("maxIterations"),
            Arg::number("printFlag", "what the test prints, 0 to 5"),
            Arg::number("norm", "norm: 0 largest, 1 sum, 2 square root of the sum of squares"),
        ])
        .with_kinds(|| kind::usages(TESTS)),
];

const CONSTRAINTS: &str = "constraints Plain | Transformation | Penalty $alphaS $alphaM | Lagrange <$alphaS $alphaM>";
const NUMBERER: &str = "numberer Plain | RCM | AMD";
const SYSTEM: &str = "system BandGeneral | BandSPD | ProfileSPD | SparseGeneral | UmfPack | FullGeneral | ...";
const TEST: &str = "test $kind $tolerance $maxIterations <$printFlag> <$norm>";

type MakeHandler = fn(&mut Tcl, &mut Args<'_>) -> Result<Handler, Exception>;

const HANDLERS: &[Kind<MakeHandler>] = &[
    Kind::named(&["Plain"], "constraints Plain", |_, _| Ok(Handler::Plain)),
    // `Auto` chooses penalties; eliminating is exact and as general.
    Kind::named(&["Transformation", "Auto"], "constraints Transformation", transformation),
    Kind {
        names: &["Penalty"],
        usage: "constraints Penalty $alphaS $alphaM",
        text: Text::new("Constraints by stiff springs of given penalty factors.")
            .arguments(&[PENALTY_ALPHA_S, PENALTY_ALPHA_M]),
        make: penalty,
    },
    Kind {
        names: &["Lagrange"],
        usage: "constraints Lagrange <$alphaS $alphaM>",
        text: Text::new("Constraints by Lagrange multipliers, each one more equation.")
            .arguments(&[LAGRANGE_ALPHA_S, LAGRANGE_ALPHA_M]),
        make: lagrange,
    },
];

fn transformation(_: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    while a.option().is_some() {}
    Ok(Handler::Transformation)
}

fn penalty(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    let single = penalty_of(interp, a, &PENALTY_ALPHA_S)?;
    let multi = penalty_of(interp, a, &PENALTY_ALPHA_M)?;
    Ok(Handler::Penalty { single, multi })
}

/// A penalty. One of 0 gives the matrices of the model without its constraints, which some programs ask for.
fn penalty_of(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    let (x, what) = (a.read(interp, arg)?, arg.meaning);
    if x == 0.0 {
        let message = format!("{what} is 0: the analysis does without them");
        let d = Diagnostic::warning(&checks::analysis::NO_PENALTY, message);
        warn(interp, d.at(a.last_span(), "as in OpenSees"))?;
    }
    Ok(x)
}

fn lagrange(_: &mut Tcl, a: &mut Args<'_>) -> Result<Handler, Exception> {
    let single = a.optional_number(&LAGRANGE_ALPHA_S)?.unwrap_or(1.0);
    Ok(Handler::Lagrange { single, multi: a.optional_number(&LAGRANGE_ALPHA_M)?.unwrap_or(1.0) })
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
    Kind::named(&["Plain", "ParallelPlain"], "numberer Plain", ()),
    Kind::named(&["RCM", "ParallelRCM"], "numberer RCM", ()),
    Kind::named(&["AMD"], "numberer AMD", ()),
];

/// The numbering is our own: it fits the solver.
fn numberer(_: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, NUMBERER);
    kind::take(&mut a, "kind of numberer", "numberer", NUMBERERS.iter())?;
    Ok(Value::EMPTY)
}

/// Systems with the terms that their matrix holds in OpenSees.
const SYSTEMS: &[Kind<MatrixTerms>] = &[
    Kind::named(&["BandGeneral", "BandGEN", "BandGen"], "system BandGeneral", MatrixTerms::OfElements),
    Kind::named(&["BandSPD"], "system BandSPD", MatrixTerms::OfElements),
    Kind::named(&["ProfileSPD", "SProfileSPD", "ParallelProfileSPD"], "system ProfileSPD", MatrixTerms::OfElements),
    Kind::named(
        &["SparseGeneral", "SparseGEN", "SparseGen", "SuperLU", "Sparse"],
        "system SparseGeneral",
        MatrixTerms::OfElements,
    ),
    Kind::named(&["SparseSPD", "SparseSYM"], "system SparseSPD", MatrixTerms::OfElements),
    Kind::named(&["UmfPack", "Umfpack"], "system UmfPack", MatrixTerms::OfElements),
    Kind::named(&["FullGeneral", "FullGen"], "system FullGeneral", MatrixTerms::All),
    Kind::named(&["Diagonal", "MPIDiagonal"], "system Diagonal", MatrixTerms::Diagonal),
    Kind::named(&["Mumps"], "system Mumps", MatrixTerms::OfElements),
    Kind::named(&["Petsc"], "system Petsc", MatrixTerms::OfElements),
    Kind::named(&["Itpack"], "system Itpack", MatrixTerms::OfElements),
    Kind::named(&["CuSP"], "system CuSP", MatrixTerms::OfElements),
    Kind::named(&["PFEM"], "system PFEM", MatrixTerms::OfElements),
];

/// The solver is our own: it fits the size and the symmetry of the equations.
fn system(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SYSTEM);
    let matrix_terms = kind::take(&mut a, "kind of system", "system of equations", SYSTEMS.iter())?.make;
    interp.host.parts.matrix_terms = Some(matrix_terms);
    interp.host.engine.change_setup(|s| s.matrix_terms = matrix_terms);
    Ok(Value::EMPTY)
}

const TESTS: &[Kind<Measure>] = &[
    Kind {
        names: &["NormDispIncr"],
        usage: "test NormDispIncr $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Compares the norm of the displacement correction with the tolerance."),
        make: Measure::DispIncr,
    },
    Kind {
        names: &["NormUnbalance"],
        usage: "test NormUnbalance $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Compares the norm of the unbalanced forces with the tolerance."),
        make: Measure::Unbalance,
    },
    Kind {
        names: &["EnergyIncr"],
        usage: "test EnergyIncr $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Compares half the product of correction and unbalanced forces with the tolerance."),
        make: Measure::Energy,
    },
    Kind {
        names: &["RelativeNormDispIncr"],
        usage: "test RelativeNormDispIncr $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new(
            "Compares the norm of the displacement correction with the tolerance times that of the first correction of \
             the step.",
        ),
        make: Measure::RelativeDispIncr,
    },
    Kind {
        names: &["RelativeNormUnbalance"],
        usage: "test RelativeNormUnbalance $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new(
            "Compares the norm of the unbalanced forces with the tolerance times that of the first iteration.",
        ),
        make: Measure::RelativeUnbalance,
    },
    Kind {
        names: &["RelativeEnergyIncr"],
        usage: "test RelativeEnergyIncr $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Compares the energy increment with the tolerance times that of the first iteration."),
        make: Measure::RelativeEnergy,
    },
    Kind {
        names: &["RelativeTotalNormDispIncr"],
        usage: "test RelativeTotalNormDispIncr $tolerance $maxIterations <$printFlag> <$norm>",
        text: Text::new(
            "Compares the norm of the displacement correction with the tolerance times the sum of these norms over the \
             step.",
        ),
        make: Measure::RelativeTotalDispIncr,
    },
    Kind {
        names: &["FixedNumIter"],
        usage: "test FixedNumIter $iterations <$printFlag> <$norm>",
        text: Text::new("Makes a given number of iterations and accepts their result.").arguments(&[ITERATIONS]),
        make: Measure::FixedIterations,
    },
    Kind {
        names: &["NormDispAndUnbalance"],
        usage: "test NormDispAndUnbalance $tolDisp $tolUnbalance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Passes if both the correction and the unbalanced forces are within their tolerances.")
            .arguments(&[TOL_DISP, TOL_UNBALANCE]),
        make: Measure::DispAndUnbalance,
    },
    Kind {
        names: &["NormDispOrUnbalance"],
        usage: "test NormDispOrUnbalance $tolDisp $tolUnbalance $maxIterations <$printFlag> <$norm>",
        text: Text::new("Passes if the correction or the unbalanced forces are within their tolerance.")
            .arguments(&[TOL_DISP, TOL_UNBALANCE]),
        make: Measure::DispOrUnbalance,
    },
];

/// Largest number of iterations of the test that OpenSees takes where a script has none.
const DEFAULT_ITERATIONS: usize = 25;

/// OpenSees makes one iteration whatever the number is.
fn iterations(interp: &mut Tcl, a: &mut Args<'_>) -> Result<usize, Exception> {
    let n = a.int(ITERATIONS.meaning)?;
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
    let tolerance = if *measure == Measure::FixedIterations { 0.0 } else { a.read(interp, &TOL_DISP)? };
    let second = if two { a.number(&TOL_UNBALANCE)? } else { tolerance };
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
