//! `algorithm`.

use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Command, Outcome, Tcl, ignore_unknown, kind, warn};
use hysteron_engine::analysis::TangentMix;
use hysteron_engine::analysis::algorithm::{
    Algorithm, ExpressNewton, LineSearch, Linear, ModifiedNewton, Newton, NewtonLineSearch, SearchKind, TangentChoice,
    Tangents, bfgs, broyden, krylov_newton, secant_newton,
};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const HALL_INITIAL: Arg = Arg::of("-Hall", "initial", "share of the initial tangent").within(Domain::Number);
const HALL_CURRENT: Arg = Arg::of("-Hall", "current", "share of the current tangent").within(Domain::Number);
const CUT_OUT_R1: Arg = Arg::of("-cutOut", "R1", "limit R1 of the scale").within(Domain::Positive);
const CUT_OUT_R2: Arg = Arg::of("-cutOut", "R2", "limit R2 of the added part").within(Domain::Positive);
const CORRECTIONS: Arg = Arg::count("corrections", "number of corrections");

const TOL_TOLERANCE: Arg = Arg::of("-tol", "tolerance", "tolerance of the line search").within(Domain::Positive);
const MAX_ITER_N: Arg = Arg::of("-maxIter", "n", "largest number of steps of the search").within(Domain::Count);
const MIN_ETA_ETA: Arg = Arg::of("-minEta", "eta", "shortest length").within(Domain::Number);
const MAX_ETA_ETA: Arg = Arg::of("-maxEta", "eta", "longest length").within(Domain::Number);
const INCREMENT_TANGENT: Arg = Arg::of("-increment", "tangent", "tangent: current, initial or noTangent");
const ITERATE_TANGENT: Arg = Arg::of("-iterate", "tangent", "tangent: current, initial or noTangent");
const NUM_TERMS_N: Arg = Arg::of("-numTerms", "n", "number of terms").within(Domain::Count);
const COUNT_CORRECTIONS: Arg =
    Arg::of("-count", "corrections", "number of corrections with one tangent").within(Domain::Count);
const MAX_DIM: Arg = Arg::of("-maxDim", "n", "largest dimension of the subspace").within(Domain::Count);
const FACTOR: Arg = Arg::positive("factor", "factor of the stiffness");

pub(crate) const COMMANDS: &[Command] = &[Command::new("algorithm", ALGORITHM, algorithm)
    .arguments(&[MAX_DIM])
    .about("Chooses the solution algorithm of a step.")
    .with_kinds(|| kind::usages(KINDS))];

const ALGORITHM: &str = "algorithm Linear | Newton | ModifiedNewton | NewtonLineSearch | KrylovNewton | SecantNewton | \
                         BFGS | Broyden | ... <options>";

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
                let initial = a.optional_number(&HALL_INITIAL)?.unwrap_or(0.1);
                let current = a.optional_number(&HALL_CURRENT)?.unwrap_or(0.9);
                choice = TangentChoice::Always(TangentMix { current, initial });
            }
            "-secant" | "-Secant" => no_secant(interp, a)?,
            "-factorOnce" | "-FactorOnce" | "-factoronce" => once = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok((choice, once))
}

fn mix(choice: TangentChoice) -> TangentMix {
    match choice {
        TangentChoice::Always(mix) => mix,
        TangentChoice::InitialThenCurrent => TangentMix::INITIAL,
        TangentChoice::CurrentThenInitial => TangentMix::CURRENT,
    }
}

type AlgorithmResult = Result<Box<dyn Algorithm>, Exception>;

/// A kind of algorithm, made from the words after its name.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> AlgorithmResult>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Linear"],
        usage: "algorithm Linear <-initial | -secant> <-factorOnce>",
        text: Text::new("One correction a step.")
            .arguments(&[Arg::flag("-secant", "accepted with a warning: the current tangent is used")]),
        make: |interp, a| {
            let (choice, once) = tangent(interp, a)?;
            Ok(Box::new(Linear::new(mix(choice), once)))
        },
    },
    Kind {
        names: &["Newton"],
        usage: "algorithm Newton <-initial | -initialThenCurrent | -Hall <$initial $current>>",
        text: Text::new("A new tangent in each iteration.").arguments(&[
            Arg::flag(
                "-initialThenCurrent",
                "forms the tangent of the first iteration at the initial state, the others at the current one",
            ),
            HALL_INITIAL,
            HALL_CURRENT,
        ]),
        make: |interp, a| Ok(Box::new(Newton::new(tangent(interp, a)?.0))),
    },
    Kind {
        names: &["ModifiedNewton"],
        usage: "algorithm ModifiedNewton <-initial | -Hall <$initial $current>> <-factorOnce>",
        text: Text::new("One tangent for the whole step.").arguments(&[HALL_INITIAL, HALL_CURRENT]),
        make: |interp, a| {
            let (choice, once) = tangent(interp, a)?;
            Ok(Box::new(ModifiedNewton::new(mix(choice), once)))
        },
    },
    Kind {
        names: &["NewtonLineSearch"],
        usage: "algorithm NewtonLineSearch <-type InitialInterpolated|Bisection|Secant|RegulaFalsi> <-tol $tolerance> \
                <-maxIter $n> <-minEta $eta> <-maxEta $eta>",
        text: Text::new("Newton's method with a search for the length of each correction.").arguments(&[
            Arg::flag("-type", "rule of the line search"),
            TOL_TOLERANCE,
            MAX_ITER_N,
            MIN_ETA_ETA,
            MAX_ETA_ETA,
        ]),
        make: line_search,
    },
    // Miller's acceleration is that of the Krylov subspace (Carlson and Miller, 1998).
    Kind {
        names: &["KrylovNewton", "MillerNewton"],
        usage: "algorithm KrylovNewton <-increment $tangent> <-iterate $tangent> <-maxDim $n> <-factorOnce>",
        text: Text::new("Modified Newton accelerated in a Krylov subspace.")
            .arguments(&[INCREMENT_TANGENT, ITERATE_TANGENT]),
        make: krylov,
    },
    Kind {
        names: &["SecantNewton"],
        usage: "algorithm SecantNewton <-increment $tangent> <-iterate $tangent> <-maxDim $n> <-factorOnce> <-numTerms $n> \
                <-cutOut $R1 $R2>",
        text: Text::new("Modified Newton accelerated by secants.").arguments(&[
            INCREMENT_TANGENT,
            ITERATE_TANGENT,
            NUM_TERMS_N,
            CUT_OUT_R1,
            CUT_OUT_R2,
        ]),
        make: |interp, a| secant(interp, a, false),
    },
    Kind {
        names: &["PeriodicNewton"],
        usage: "algorithm PeriodicNewton <-increment $tangent> <-iterate $tangent> <-maxDim $n> <-factorOnce>",
        text: Text::new("Modified Newton with a new tangent from time to time.")
            .arguments(&[INCREMENT_TANGENT, ITERATE_TANGENT]),
        make: |interp, a| secant(interp, a, true),
    },
    // In OpenSees an accelerated method that does not accelerate.
    Kind {
        names: &["RaphsonNewton"],
        usage: "algorithm RaphsonNewton <-increment $tangent> <-iterate $tangent>",
        text: Text::new("Newton's method whose tangent is formed before the correction of each iteration.")
            .arguments(&[INCREMENT_TANGENT, ITERATE_TANGENT]),
        make: raphson,
    },
    Kind {
        names: &["BFGS"],
        usage: "algorithm BFGS <-initial> <-count $corrections>",
        text: Text::new("The method of Broyden, Fletcher, Goldfarb and Shanno.").arguments(&[COUNT_CORRECTIONS]),
        make: |interp, a| quasi_newton(interp, a).map(|(mix, count)| bfgs(mix, count)),
    },
    Kind {
        names: &["Broyden"],
        usage: "algorithm Broyden <-initial> <-count $corrections>",
        text: Text::new("Broyden's method.").arguments(&[COUNT_CORRECTIONS]),
        make: |interp, a| quasi_newton(interp, a).map(|(mix, count)| broyden(mix, count)),
    },
    Kind {
        names: &["ExpressNewton"],
        usage: "algorithm ExpressNewton <$corrections> <$factor> <-initialTangent | -currentTangent> <-factorOnce>",
        text: Text::new("A fixed number of corrections a step.").arguments(&[CORRECTIONS, FACTOR]),
        make: express,
    },
];

fn raphson(interp: &mut Tcl, a: &mut Args<'_>) -> AlgorithmResult {
    let Tangents { increment, iterate, once, .. } = accelerated(interp, a, false)?.tangents;
    let Some(iterate) = iterate else { return Ok(Box::new(ModifiedNewton::new(increment, once))) };
    Ok(Box::new(Newton::new(if iterate == increment {
        TangentChoice::Always(iterate)
    } else if increment == TangentMix::INITIAL {
        TangentChoice::InitialThenCurrent
    } else {
        TangentChoice::CurrentThenInitial
    })))
}

fn algorithm(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ALGORITHM);
    let kind = kind::take(&mut a, "kind of algorithm", "algorithm", KINDS.iter())?;
    interp.host.note_kind("algorithm", kind.names[0]);
    let made = (kind.make)(interp, &mut a)?;
    // A setup takes its own; the parts keep none, so that `analysis` finds the one of the setup.
    if interp.host.engine.setup().is_some() {
        interp.host.engine.change_setup(|s| s.algorithm = made);
    } else {
        interp.host.parts.algorithm = Some(made);
    }
    Ok(Value::EMPTY)
}

fn line_search(interp: &mut Tcl, a: &mut Args<'_>) -> AlgorithmResult {
    let mut search = LineSearch::new(SearchKind::InitialInterpolated);
    // The old form: a number is the tolerance.
    if let Some(tolerance) = a.optional_number(&TOL_TOLERANCE)? {
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
            "-tol" | "-tolerance" => search.tolerance = a.number(&TOL_TOLERANCE)?,
            "-maxIter" => search.max_iterations = a.count(&MAX_ITER_N)?,
            "-minEta" => search.min_eta = a.number(&MIN_ETA_ETA)?,
            "-maxEta" => search.max_eta = a.number(&MAX_ETA_ETA)?,
            "-pFlag" | "-flag" => drop(a.int("print flag")?),
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(Box::new(NewtonLineSearch::new(search, TangentChoice::Always(TangentMix::CURRENT))))
}

/// Options of the accelerated methods.
struct Accelerated {
    tangents: Tangents,
    terms: usize,
    cut_out: Option<(f64, f64)>,
}

fn accelerated(interp: &mut Tcl, a: &mut Args<'_>, secant: bool) -> Result<Accelerated, Exception> {
    let current = TangentMix::CURRENT;
    let tangents = Tangents { increment: current, iterate: Some(current), period: 3, once: false };
    let mut o = Accelerated { tangents, terms: 2, cut_out: None };
    let t = &mut o.tangents;
    let mut given = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-increment" | "-iterate" => {
                let mix = match a.word(INCREMENT_TANGENT.meaning)?.as_ref() {
                    "current" => Some(TangentMix::CURRENT),
                    "initial" => Some(TangentMix::INITIAL),
                    "noTangent" => None,
                    _ => return Err(a.unknown_name("tangent", ["current", "initial", "noTangent"])),
                };
                if option == "-iterate" {
                    (t.iterate, given) = (mix, true);
                } else {
                    // There is nothing to keep in the first step, and a tangent that is kept is factored once.
                    t.once |= mix.is_none();
                    t.increment = mix.unwrap_or(TangentMix::CURRENT);
                }
            }
            "-maxDim" => {
                // Each dimension keeps two vectors of the model.
                t.period = at_most(a, MAX_CORRECTIONS, &MAX_DIM)?;
            }
            "-factorOnce" | "-FactorOnce" | "-factoronce" | "-factorIncrementOnce" | "-FactorIncrementOnce" => {
                t.once = true;
            }
            "-numTerms" if secant => o.terms = a.count(&NUM_TERMS_N)?,
            "-cutOut" | "-cutout" if secant => {
                o.cut_out = Some((a.number(&CUT_OUT_R1)?, a.number(&CUT_OUT_R2)?));
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    if t.once && !given {
        t.iterate = None;
    }
    // A new tangent in the middle of a step is another one than that of its begin.
    t.once &= t.iterate.is_none();
    Ok(o)
}

fn krylov(interp: &mut Tcl, a: &mut Args<'_>) -> AlgorithmResult {
    let o = accelerated(interp, a, false)?;
    Ok(krylov_newton(o.tangents))
}

/// `SecantNewton`, and with `periodic` the same without its terms.
fn secant(interp: &mut Tcl, a: &mut Args<'_>, periodic: bool) -> AlgorithmResult {
    let o = accelerated(interp, a, !periodic)?;
    let terms = if periodic { 0 } else { o.terms };
    Ok(secant_newton(o.tangents, terms, o.cut_out))
}

/// Largest number of corrections of `BFGS` and `Broyden` with one tangent. Each keeps two vectors of the model.
const MAX_CORRECTIONS: usize = 1000;

/// A count that is bounded.
fn at_most(a: &mut Args<'_>, most: usize, arg: &Arg) -> Result<usize, Exception> {
    let what = arg.meaning;
    match a.count(arg)? {
        n if n <= most => Ok(n),
        n => Err(a.refuse(format!("{what} is {n}"), format!("expected 1 to {most}"))),
    }
}

/// Tangent and count of `BFGS` and `Broyden`.
fn quasi_newton(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(TangentMix, usize), Exception> {
    let (mut mix, mut count) = (TangentMix::CURRENT, 10);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-initial" | "initial" => mix = TangentMix::INITIAL,
            "-current" => mix = TangentMix::CURRENT,
            "-count" => count = a.count(&COUNT_CORRECTIONS)?,
            "-secant" => no_secant(interp, a)?,
            // The number alone is an old form.
            _ if a.last_word().parse::<usize>().is_ok_and(|n| n > 0) => count = a.last_word().parse().unwrap_or(count),
            _ => ignore_unknown(interp, a)?,
        }
    }
    if count > MAX_CORRECTIONS {
        let message = format!("{count} corrections with one tangent take too much memory");
        return Err(a.refuse(message, format!("expected at most {MAX_CORRECTIONS}")));
    }
    Ok((mix, count))
}

fn express(interp: &mut Tcl, a: &mut Args<'_>) -> AlgorithmResult {
    let corrections = if a.at_number() { a.count(&CORRECTIONS)? } else { 2 };
    let factor = if a.at_number() { a.number(&FACTOR)? } else { 1.0 };
    let (mut initial, mut once) = (false, false);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-initialTangent" | "-InitialTangent" | "-initial" | "-Initial" => (initial, once) = (true, true),
            "-currentTangent" | "-CurrentTangent" => initial = false,
            "-factorOnce" | "-FactorOnce" | "-factoronce" => once = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let mix = if initial {
        TangentMix { current: 0.0, initial: factor }
    } else {
        TangentMix { current: factor, initial: 0.0 }
    };
    Ok(Box::new(ExpressNewton::new(corrections, mix, once)))
}

fn no_secant(interp: &mut Tcl, a: &Args<'_>) -> Result<(), Exception> {
    let message = "the secant tangent is not supported: the current tangent is used";
    warn(
        interp,
        Diagnostic::warning(&checks::words::UNUSED_WORD, message)
            .at(a.last_span(), "the results are the same once converged"),
    )
}
