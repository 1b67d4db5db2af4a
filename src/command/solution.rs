//! The parts of an analysis: `constraints numberer system test algorithm integrator`.

use super::args::Args;
use super::model::node_of;
use super::{Command, Outcome, Tcl, finish, ignore_option, warn};
use crate::analysis::algorithm::{
    Algorithm, KrylovNewton, LineSearch, Linear, ModifiedNewton, Newton, NewtonLineSearch, SearchKind, TangentChoice,
};
use crate::analysis::integrator::{Adaptive, DisplacementControl, Form, Hht, Integrator, LoadControl, Newmark};
use crate::analysis::{Measure, Norm, TangentMix, Test};
use crate::assembly::Handler;
use crate::diagnostic::Diagnostic;
use crate::script::{Call, Exception, Value};

pub(super) const COMMANDS: &[Command] = &[
    Command { name: "constraints", usage: CONSTRAINTS, run: constraints },
    Command { name: "numberer", usage: NUMBERER, run: numberer },
    Command { name: "system", usage: SYSTEM, run: system },
    Command { name: "test", usage: TEST, run: test },
    Command { name: "algorithm", usage: ALGORITHM, run: algorithm },
    Command { name: "integrator", usage: INTEGRATOR, run: integrator },
];

const CONSTRAINTS: &str = "constraints Plain | Transformation | Penalty $alphaS $alphaM | Lagrange <$alphaS $alphaM>";
const NUMBERER: &str = "numberer Plain | RCM | AMD";
const SYSTEM: &str = "system BandGeneral | BandSPD | ProfileSPD | SparseGeneral | UmfPack | FullGeneral | ...";
const TEST: &str = "test $kind $tolerance $maxIterations <$printFlag> <$norm>";
const ALGORITHM: &str = "algorithm Linear | Newton | ModifiedNewton | NewtonLineSearch | KrylovNewton <options>";
const INTEGRATOR: &str = "integrator LoadControl | DisplacementControl | Newmark | HHT ...";

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

/// The tangent that options of an algorithm ask for, and whether it is factored only once.
fn tangent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(TangentChoice, bool), Exception> {
    let (mut choice, mut once) = (TangentChoice::Always(TangentMix::CURRENT), false);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-initial" | "initial" | "-Initial" => choice = TangentChoice::Always(TangentMix::INITIAL),
            "-current" | "-Current" => choice = TangentChoice::Always(TangentMix::CURRENT),
            "-initialThenCurrent" | "-initialCurrent" | "-intialThenCurrent" | "-intialCurrent" => {
                choice = TangentChoice::InitialThenCurrent;
            }
            "-Hall" | "-hall" => {
                let initial = a.optional_float("share of the initial tangent")?.unwrap_or(0.1);
                let current = a.optional_float("share of the current tangent")?.unwrap_or(0.9);
                choice = TangentChoice::Always(TangentMix { current, initial });
            }
            "-secant" | "-Secant" => {
                let message = "the secant tangent is not supported: the current tangent is used";
                warn(
                    interp,
                    Diagnostic::warning(message).at(a.last_span(), "the results are the same once converged"),
                )?;
            }
            "-factorOnce" | "-FactorOnce" | "-factoronce" => once = true,
            _ => ignore_option(interp, a, &["-initial", "-initialThenCurrent", "-Hall", "-factorOnce"])?,
        }
    }
    Ok((choice, once))
}

fn mix(choice: TangentChoice) -> TangentMix {
    match choice {
        TangentChoice::Always(mix) => mix,
        TangentChoice::InitialThenCurrent => TangentMix::INITIAL,
    }
}

fn algorithm(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ALGORITHM);
    let made: Box<dyn Algorithm> = match a.word("kind of algorithm")?.as_ref() {
        "Linear" => {
            let (choice, once) = tangent(interp, &mut a)?;
            Box::new(Linear::new(mix(choice), once))
        }
        "Newton" => Box::new(Newton(tangent(interp, &mut a)?.0)),
        "ModifiedNewton" => {
            let (choice, once) = tangent(interp, &mut a)?;
            Box::new(ModifiedNewton::new(mix(choice), once))
        }
        "NewtonLineSearch" => line_search(interp, &mut a)?,
        "KrylovNewton" => krylov(interp, &mut a)?,
        _ => {
            return Err(a.unknown_name(
                "algorithm",
                ["Linear", "Newton", "ModifiedNewton", "NewtonLineSearch", "KrylovNewton"],
            ));
        }
    };
    // A setup takes its own; the parts keep none, so that `analysis` finds the one of the setup.
    if interp.host.engine.setup().is_some() {
        interp.host.engine.change_setup(|s| s.algorithm = made);
    } else {
        interp.host.parts.algorithm = Some(made);
    }
    Ok(Value::EMPTY)
}

fn line_search(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Box<dyn Algorithm>, Exception> {
    let mut search = LineSearch::new(SearchKind::InitialInterpolated);
    // The old form: a number is the tolerance.
    if let Some(tolerance) = a.optional_float("tolerance of the line search")? {
        search.tolerance = tolerance;
    }
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-type" => {
                search.kind = match a.word("type of the line search")?.as_ref() {
                    "InitialInterpolated" | "LineSearch" => SearchKind::InitialInterpolated,
                    "Bisection" => SearchKind::Bisection,
                    "Secant" => SearchKind::Secant,
                    "RegulaFalsi" => SearchKind::RegulaFalsi,
                    _ => {
                        let known = ["InitialInterpolated", "Bisection", "Secant", "RegulaFalsi"];
                        return Err(a.unknown_name("type of line search", known));
                    }
                };
            }
            "-tol" | "-tolerance" => search.tolerance = a.positive("tolerance of the line search")?,
            "-maxIter" => search.max_iterations = a.count("largest number of steps of the search")?,
            "-minEta" => search.min_eta = a.float("shortest length")?,
            "-maxEta" => search.max_eta = a.float("longest length")?,
            "-pFlag" | "-flag" => drop(a.int("print flag")?),
            _ => ignore_option(interp, a, &["-type", "-tol", "-maxIter", "-minEta", "-maxEta", "-pFlag"])?,
        }
    }
    Ok(Box::new(NewtonLineSearch::new(search, TangentChoice::Always(TangentMix::CURRENT))))
}

fn krylov(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Box<dyn Algorithm>, Exception> {
    let (mut increment, mut iterate, mut dimension) = (TangentMix::CURRENT, Some(TangentMix::CURRENT), 3);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-increment" | "-iterate" => {
                let mix = match a.word("tangent: current, initial or noTangent")?.as_ref() {
                    "current" => Some(TangentMix::CURRENT),
                    "initial" => Some(TangentMix::INITIAL),
                    "noTangent" => None,
                    _ => return Err(a.unknown_name("tangent", ["current", "initial", "noTangent"])),
                };
                if option == "-iterate" { iterate = mix } else { increment = mix.unwrap_or(TangentMix::CURRENT) }
            }
            "-maxDim" => dimension = a.count("largest dimension of the subspace")?,
            _ => ignore_option(interp, a, &["-increment", "-iterate", "-maxDim"])?,
        }
    }
    Ok(Box::new(KrylovNewton::new(increment, iterate, dimension)))
}

/// Numbers after the step of a static integrator: iterations wanted, smallest and largest step.
fn adaptive(a: &mut Args<'_>, step: f64) -> Result<Adaptive, Exception> {
    let Some(desired) = a.optional_int("number of iterations wanted")? else { return Ok(Adaptive::fixed(step)) };
    if desired < 1 {
        return Err(a.refuse(format!("the number of iterations wanted is {desired}"), "expected at least 1"));
    }
    let min = a.optional_float("smallest step")?.unwrap_or(step);
    let max = a.optional_float("largest step")?.unwrap_or(step);
    Ok(Adaptive { desired_iterations: desired as usize, min, max })
}

fn integrator(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, INTEGRATOR);
    let made: Box<dyn Integrator> = match a.word("kind of integrator")?.as_ref() {
        "LoadControl" => {
            a.usage("integrator LoadControl $increment <$iterations $min $max>");
            let step = a.float("increment of the load factor")?;
            Box::new(LoadControl::new(step, adaptive(&mut a, step)?))
        }
        "DisplacementControl" => {
            a.usage("integrator DisplacementControl $node $dof $increment <$iterations $min $max>");
            let node = node_of(interp, &mut a, "tag of the node")?;
            let (ndf, offset) = {
                let n = &interp.host.engine.model().nodes[node.0];
                (n.ndf, n.offset)
            };
            let dof = a.dof("degree of freedom", ndf)?;
            let step = a.float("increment of the displacement")?;
            let adaptive = adaptive(&mut a, step)?;
            let mix = if a.flag("-initial") { TangentMix::INITIAL } else { TangentMix::CURRENT };
            Box::new(DisplacementControl::new(offset + dof, step, adaptive, mix))
        }
        "Newmark" => newmark(interp, &mut a)?,
        "HHT" => {
            a.usage("integrator HHT $alpha <$gamma $beta>");
            let alpha = a.positive("alpha")?;
            match a.optional_float("gamma")? {
                Some(gamma) => Box::new(Hht::new(alpha, gamma, a.positive("beta")?)),
                None => Box::new(Hht::second_order(alpha)),
            }
        }
        _ => return Err(a.unknown_name("integrator", ["LoadControl", "DisplacementControl", "Newmark", "HHT"])),
    };
    finish(interp, &a)?;
    let is_static = made.is_static();
    let fits = interp.host.engine.setup().is_some_and(|s| s.integrator.is_static() == is_static);
    if fits {
        interp.host.engine.change_setup(|s| s.integrator = made);
    } else {
        interp.host.parts.integrator = Some(made);
    }
    Ok(Value::EMPTY)
}

fn newmark(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Box<dyn Integrator>, Exception> {
    a.usage("integrator Newmark $gamma $beta <-form D|V|A>");
    let gamma = a.positive("gamma")?;
    let beta = a.not_negative("beta")?;
    let span = a.last_span();
    let mut form = Form::Displacement;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-form" => {
                form = match a.word("form: D, V or A")?.as_ref() {
                    "D" | "d" => Form::Displacement,
                    "V" | "v" => Form::Velocity,
                    "A" | "a" => Form::Acceleration,
                    _ => return Err(a.unknown_name("form of Newmark's method", ["D", "V", "A"])),
                };
            }
            _ => ignore_option(interp, a, &["-form"])?,
        }
    }
    if beta == 0.0 && form != Form::Acceleration {
        return Err(a.refuse_at(span, "beta is 0: the method is explicit", "expected -form A with it"));
    }
    Ok(Box::new(Newmark::new(gamma, beta, form)))
}
