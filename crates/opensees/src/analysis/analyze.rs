//! Analyses: `analysis analyze eigen` and what goes with them.

use super::failure::failure_message;
use super::numerics;
use super::plausibility;
use crate::args::Args;
use crate::checkpoint;
use crate::checks;
use crate::host::Mode;
use crate::model::parameter_change;
use crate::output::collapse;
use crate::parameter::sensitivity;
use crate::session::{Parts, Session};
use crate::slips;
use crate::text::{Arg, Domain, Text, WITHOUT_EFFECT};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind, warn};
use hysteron_engine::analysis::algorithm::{Algorithm, Newton, TangentChoice};
use hysteron_engine::analysis::integrator::Form;
use hysteron_engine::analysis::integrator::{Adaptive, Integrator, LoadControl, Newmark};
use hysteron_engine::analysis::{
    Cause, Failure, Kind, Measure, ModeRequest, ModesError, Problem, RecoveryStrategy, Setup, TangentMix, Test,
};
use hysteron_engine::assembly::Handler;
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Severity, Span};
use hysteron_tcl::{Call, Exception, Value};

const DT: Arg = Arg::positive("dt", "step of time dt");
/// The step of an integrator whose steps take no time.
const DT_OR_0: Arg = DT.within(Domain::NotNegative);
const DT_MIN: Arg = Arg::positive("dtMin", "smallest step dtMin");
const DT_MAX: Arg = Arg::positive("dtMax", "largest step dtMax");
const ITERATIONS: Arg = Arg::count("Jd", "number of iterations wanted");

const COUNT: Arg = Arg::count("count", "number of modes");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("analysis", ANALYSIS, analysis)
        .about("Makes the analysis of the chosen parts.")
        .defining(&[things::ANALYSIS], 0)
        .with_kinds(|| kind::usages(KINDS)),
    Command::new("analyze", ANALYZE, analyze)
        .about("Makes steps; returns 0 or a negative [code](../conventions.md#return-values-of-analyze).")
        .arguments(&[
            Arg::new("steps", "number of steps"),
            DT,
            DT_MIN,
            DT_MAX,
            Arg::new("iterations", "iterations wanted"),
        ]),
    Command::new("eigen", EIGEN, eigen)
        .about("Computes modes; returns the eigenvalues, squares of the circular frequencies.")
        .arguments(&[COUNT, Arg::new("solver", "name of OpenSees' solver, accepted")]),
    Command::new("wipeAnalysis", "wipeAnalysis", wipe_analysis).about("Removes the analysis and keeps the model."),
    Command::new("reset", "reset", reset).about("Returns to the state at the start."),
    Command::new("revertToStart", "revertToStart", reset).about("Returns to the state at the start."),
    Command::new("initialize", "initialize", initialize).about(WITHOUT_EFFECT),
    Command::new("ladder", LADDER, ladder)
        .about("Turns the remedies for failed steps on or off, as `--ladder` does.")
        .own(),
];

const ANALYSIS: &str = "analysis Static | Transient | VariableTransient";
const ANALYZE: &str = "analyze $steps (static), analyze $steps $dt (transient) or \
                       analyze $steps $dt $dtMin $dtMax $iterations (variable transient)";
const EIGEN: &str = "eigen <$solver> <-generalized | -standard> <-findLargest> $count";
const LADDER: &str = "ladder on | off: try other algorithms and shorter steps before a step fails";

/// Commits the model as it is where there is an analysis, so that recorders write a row.
fn initialize(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let session = &mut interp.host;
    if session.kind().is_some() {
        let done = session.output.recorders.record(&mut session.engine);
        done.map_err(|e| call.error_at(0, e.to_string(), ""))?;
    }
    Ok(Value::EMPTY)
}

/// A kind of analysis. `variable`: steps of time may change their length.
#[derive(Clone, Copy)]
struct AnalysisKind {
    kind: Kind,
    variable: bool,
}

const KINDS: &[kind::Kind<AnalysisKind>] = &[
    kind::Kind {
        names: &["Static"],
        usage: "analysis Static",
        text: Text::new("Steps of the load factor or of a displacement."),
        make: AnalysisKind { kind: Kind::Static, variable: false },
    },
    kind::Kind {
        names: &["Transient"],
        usage: "analysis Transient",
        text: Text::new("Steps in time."),
        make: AnalysisKind { kind: Kind::Transient, variable: false },
    },
    kind::Kind {
        names: &["VariableTransient", "VariableTimeStepTransient", "TransientWithVariableTimeStep"],
        usage: "analysis VariableTransient",
        text: Text::new("Steps in time whose length follows the iterations."),
        make: AnalysisKind { kind: Kind::Transient, variable: true },
    },
];

fn analysis(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ANALYSIS);
    let AnalysisKind { kind, variable } = kind::take(&mut a, "kind of analysis", "analysis", KINDS.iter())?.make;
    // It silences messages of OpenSees that are not made here.
    a.flag("-noWarnings");
    // `-numSublevels` and the like: substepping is asked for with `ladder`.
    finish(interp, &a)?;
    set_up(&mut interp.host, kind, variable, Handler::Plain);
    Ok(Value::EMPTY)
}

/// Make an analysis of the parts that have been given, and of OpenSees' defaults.
fn set_up(session: &mut Session, kind: Kind, variable: bool, default_handler: Handler) {
    let old = session.engine.take_setup();
    let parts = std::mem::take(&mut session.parts);
    let Parts { handler, test, algorithm, integrator, print, matrix_terms, .. } = parts;
    // Parts that were given for an analysis serve the next one too, unless new ones are given.
    let old_terms = old.as_ref().map(|s| s.matrix_terms);
    let (old_algorithm, old_integrator, old_test, old_handler) = match old {
        Some(s) => (Some(s.algorithm), Some(s.integrator), Some(s.test), Some(s.handler)),
        None => (None, None, None, None),
    };
    let fits = |i: &dyn Integrator| i.is_static() == (kind == Kind::Static);
    let (integrator, kept) = match integrator {
        Some(i) if fits(&*i) => (Some(i), None),
        other => (old_integrator.filter(|i| fits(&**i)), other),
    };
    let integrator = integrator.unwrap_or_else(|| default_integrator(kind));
    let algorithm = algorithm.or(old_algorithm).unwrap_or_else(default_algorithm);
    let test = test.or(old_test).unwrap_or_else(|| Test::new(Measure::Unbalance, 1e-6, 25));
    let handler = handler.or(old_handler).unwrap_or(default_handler);
    let matrix_terms = matrix_terms.or(old_terms).unwrap_or_default();
    session.output.recorders.print = print;
    session.parts = Parts {
        handler: Some(handler),
        test: Some(test.clone()),
        integrator: kept,
        print,
        matrix_terms: Some(matrix_terms),
        algorithm: None,
        variable_steps: variable,
    };
    session.engine.set_up(Setup { kind, handler, algorithm, integrator, test, matrix_terms });
}

fn default_integrator(kind: Kind) -> Box<dyn Integrator> {
    match kind {
        Kind::Static => Box::new(LoadControl::new(1.0, Adaptive::fixed(1.0))),
        Kind::Transient => Box::new(Newmark::new(0.5, 0.25, Form::Displacement)),
    }
}

fn default_algorithm() -> Box<dyn Algorithm> {
    Box::new(Newton::new(TangentChoice::Always(TangentMix::CURRENT)))
}

fn analyze(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ANALYZE);
    let Some(kind) = interp.host.kind() else {
        // OpenSees warns, and goes on.
        let d = Diagnostic::warning(&checks::analysis::NO_ANALYSIS, "analyze: there is no analysis")
            .absent(Absent::new(things::ANALYSIS, ""))
            .help(format!("usage: {ANALYZE}"));
        warn(interp, d.at(call.span(0), "expected a command \"analysis\" before: returns -1"))?;
        return Ok(Value::from(-1i64));
    };
    if interp.host.ends_at_analysis {
        return Err(Exception::Exit(0));
    }
    let hook = if kind == Kind::Transient { interp.host.before_transient.take() } else { None };
    if let Some(hook) = hook {
        hook(interp)?;
    }
    let steps = a.int("number of steps")?;
    if steps < 0 {
        return Err(a.refuse(format!("the number of steps is {steps}"), "expected a number that is not negative"));
    }
    let elapses = interp.host.engine.setup().is_none_or(|s| s.integrator.elapses());
    let dt = match kind {
        Kind::Transient if elapses => a.number(&DT)?,
        Kind::Transient => a.number(&DT_OR_0)?,
        Kind::Static => 0.0,
    };
    let lengths = if interp.host.parts.variable_steps && a.left() > 0 { Some(step_lengths(&mut a)?) } else { None };
    if kind == Kind::Transient {
        finish(interp, &a)?;
    }
    if let Some((spring, column)) = interp.host.engine.model().unwatched() {
        let message = format!("the limit curve of element {spring} cannot watch element {column}");
        return Err(a.refuse_at(call.span(0), message, "expected a frame element with its nodes in the model"));
    }
    let can_wait = lengths.is_none()
        && interp.host.mode == Mode::Run
        && interp.host.changes.is_empty()
        && interp.host.derived.is_none();
    let course = interp.host.course.as_mut();
    if course.is_some_and(|course| course.begin_analysis((steps as usize, dt), can_wait)) {
        let session = &mut interp.host;
        session.output.recorders.start(&mut session.engine);
        return Ok(Value::from(0i64));
    }
    checkpoint::before_analysis(interp, call)?;
    warn_of_plain(interp, call.span(0))?;
    warn_of_pseudo_time(interp, call.span(0))?;
    if !interp.host.output.recorders.repeats() {
        plausibility::before(interp, dt, call.span(0))?;
    }
    sensitivity::begin(interp);
    let session = &mut interp.host;
    session.note_checked(kind, dt);
    session.builder.loads_time = None;
    let done = match session.mode {
        // Messages of an analysis of a wrong model follow from the mistake in the model.
        Mode::Check if session.check.rejected => {
            session.check.waits_for_results = true;
            session.check.pass_over(0);
            Ok(())
        }
        Mode::Check => {
            session.check.waits_for_results = true;
            session.overview.before_analysis(&mut session.engine);
            let done = session.engine.rehearse(steps as usize, dt);
            session.overview.after_analysis(&session.engine, call.span(0));
            done
        }
        Mode::Run => {
            session.output.recorders.print = session.parts.print;
            session.output.recorders.end = session.engine.excitation_end();
            let (engine, steps) = (&mut session.engine, steps as usize);
            session.output.recorders.start(engine);
            session.output.recorders.isolator_damping.begin(engine);
            session.output.recorders.backbones.begin(engine);
            match lengths {
                lengths if !session.changes.is_empty() => parameter_change::analyze(interp, call, steps, dt, lengths)?,
                Some(lengths) => engine.analyze_variable(steps, dt, lengths, &mut session.output.recorders),
                None if session.output.recorders.journal.is_some() => {
                    match checkpoint::analyze(engine, &mut session.output.recorders, steps, dt) {
                        Ok(done) => done,
                        Err(why) => return Err(a.refuse_at(call.span(0), format!("checkpoint: {why}"), "")),
                    }
                }
                None => engine.analyze(steps, dt, &mut session.output.recorders),
            }
        }
    };
    collapse::note_removed(interp, call)?;
    let shown = interp.host.output.recorders.pause();
    shown.map_err(|e| call.error_at(0, e.to_string(), ""))?;
    conclude(interp, call, done)
}

/// Give the messages about an analysis that has been made, and its code.
pub(crate) fn conclude(interp: &mut Tcl, call: &Call<'_>, done: Result<(), Failure>) -> Outcome {
    let printed = std::mem::take(&mut interp.host.output.recorders.printed);
    if !printed.is_empty() {
        crate::print_error(interp, &printed);
    }
    warn_of_missing(interp)?;
    checkpoint::warn_of_end(interp, call)?;
    if !interp.host.output.recorders.repeats() {
        numerics::warn_of_numerics(interp, call.span(0))?;
        if done.is_ok() {
            plausibility::after(interp, call.span(0))?;
        }
    }
    match done {
        Ok(()) => {
            interp.host.last_failure = None;
            Ok(Value::from(0i64))
        }
        Err(failure) if failure.cause == Cause::Interrupted => Err(Exception::Interrupted),
        Err(failure) => {
            let mut d = failure_message(&interp.host, &failure, call.span(0));
            // A check has found what a run would stumble over. In a run the script sees the code; it may have a
            // remedy, so `--strict` makes no error of it.
            if interp.host.mode == Mode::Check {
                d.severity = Severity::Error;
            }
            let code = failure.code;
            if interp.is_discarded(call) && interp.host.mode == Mode::Run {
                interp.host.ignored_failure.get_or_insert_with(|| failure.clone());
                d = d.help("nothing looks at the result of this command: the script goes on without these steps");
                if interp.host.strict {
                    d.severity = Severity::Error;
                    return Err(Exception::diagnosed(d));
                }
            }
            interp.host.last_failure = Some(failure);
            crate::report(interp, d);
            Ok(Value::from(i64::from(code)))
        }
    }
}

/// Warn of nodes, elements and responses that recorders ask for in vain. In a check, recorders look them up here.
pub(crate) fn warn_of_missing(interp: &mut Tcl) -> Result<(), Exception> {
    let Session { engine, output, check, mode, .. } = &mut interp.host;
    if *mode == Mode::Check {
        output.recorders.look_up(engine);
    }
    let missing = output.recorders.missing(|absent| check.holds_back(absent));
    missing.into_iter().try_for_each(|m| warn(interp, m))
}

/// Smallest and largest step of time, and the iterations that a step should take.
fn step_lengths(a: &mut Args<'_>) -> Result<Adaptive, Exception> {
    let min = a.number(&DT_MIN)?;
    let max = a.number(&DT_MAX)?;
    if max < min {
        return Err(a.refuse(format!("the largest step is {max}"), format!("expected at least the smallest, {min}")));
    }
    Ok(Adaptive { desired_iterations: a.count(&ITERATIONS)?, min, max })
}

/// Warn, once, of constraints that OpenSees' `Plain` handler does not follow and ours does.
fn warn_of_plain(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    let engine = &interp.host.engine;
    let told = interp.host.warnings.has(&checks::analysis::PLAIN_CONSTRAINTS);
    if told
        || interp.host.follows(&[slips::PLAIN_IMPOSED, slips::PLAIN_CONSTRAINTS])
        || !engine.setup().is_some_and(|s| s.handler == Handler::Plain)
    {
        return Ok(());
    }
    let model = engine.model();
    let name = |n: hysteron_engine::model::NodeId| model.nodes[n.0].tag;
    let moved = model.patterns.values().flat_map(|p| &p.motions).find(|m| m.value != 0.0);
    let moved = moved.map(|m| format!("the imposed motion of node {}", name(m.node)));
    let tied = model.multi_points.iter().find(|m| !m.is_identity());
    let tied = tied.map(|m| format!("the constraint of node {} to node {}", name(m.constrained), name(m.retained)));
    let Some(what) = moved.or(tied) else { return Ok(()) };
    interp.host.warnings.note(&checks::analysis::PLAIN_CONSTRAINTS);
    let message = format!("OpenSees' handler Plain leaves out {what}; here it is followed");
    let d = Diagnostic::warning(&checks::analysis::PLAIN_CONSTRAINTS, message)
        .at(span, "expected \"constraints Transformation\" before this");
    warn(interp, d)
}

/// Warn, once, of laws that depend on time in an analysis whose steps are ruled by something else.
fn warn_of_pseudo_time(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    if interp.host.warnings.has(&checks::analysis::PSEUDO_TIME) {
        return Ok(());
    }
    let engine = &interp.host.engine;
    let Some(integrator) = engine.setup().map(|s| &s.integrator).filter(|i| !i.elapses()) else { return Ok(()) };
    let Some(e) = engine.model().elements.iter().find(|e| e.element.traits().elapses) else { return Ok(()) };
    let what = format!("{} {}", e.element.class().name, e.tag);
    let name = integrator.name();
    interp.host.warnings.note(&checks::analysis::PSEUDO_TIME);
    let message = format!("no time passes under {name}: the dashpots of {what} stay where they are");
    let d = Diagnostic::warning(&checks::analysis::PSEUDO_TIME, message)
        .at(span, "expected LoadControl, whose load factor is the time");
    warn(interp, d.help("an imposed displacement (sp) over a Path series goes at the rate of that path"))
}

const SOLVERS: &[&str] = &[
    "-genBandArpack",
    "-fullGenLapack",
    "-symmBandLapack",
    "-symmGenLapack",
    "-generalized",
    "-standard",
    "-frequency",
    "-findLargest",
];

/// Share of the largest eigenvalue that is round-off.
const ROUND_OFF: f64 = 1e-18;

/// Modes that a check answers for without a model. A script that asks for more gets the message of a run.
const MAX_PASSED_OVER: usize = 10_000;

fn eigen(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, EIGEN);
    let (mut problem, mut largest, mut lapack) = (Problem::Generalized, false, false);
    while a.left() > 1 {
        let option = a.word("option")?;
        match option.trim_start_matches('-') {
            "fullGenLapack" | "fullGenLapackEigen" => lapack = true,
            "genBandArpack"
            | "genBandArpackEigen"
            | "symmBandLapack"
            | "symmBandLapackEigen"
            | "symmGenLapack"
            | "symmGenLapackEigen"
            | "UmfPack" => {}
            "generalized" | "frequency" => problem = Problem::Generalized,
            "standard" => problem = Problem::Standard,
            "findLargest" => largest = true,
            _ => {
                let d = Diagnostic::warning(
                    &checks::words::UNKNOWN_OPTION,
                    format!("eigen: \"{}\" is not an option and is ignored", a.last_word()),
                );
                warn(interp, d.at(a.last_span(), format!("expected one of {}", SOLVERS.join(" "))))?;
            }
        }
    }
    let count = a.count(&COUNT)?;
    let span = a.last_span();
    if interp.host.mode == Mode::Check {
        interp.host.overview.note_analysis(call.span(0));
    }
    // OpenSees makes a transient analysis where there is none. In Python it is gone after the command.
    if interp.host.kind().is_none() && !interp.host.called_by_host {
        set_up(&mut interp.host, Kind::Transient, false, Handler::Transformation);
    }
    if interp.host.mode == Mode::Check && interp.host.check.rejected {
        interp.host.check.waits_for_results = true;
        let count = count.min(MAX_PASSED_OVER);
        interp.host.check.pass_over(count);
        return Ok(Value::list((0..count).map(|_| Value::from(1.0))));
    }
    lapack &= interp.host.follows(&[slips::EIGEN_LAPACK]);
    let engine = &mut interp.host.engine;
    if let Some(handler) = interp.host.parts.handler {
        engine.default_handler = handler;
    }
    match engine.find_modes(ModeRequest { count, problem, largest, lapack }) {
        Ok(modes) => {
            let (mut lambda, rigid) = (modes.lambda.clone(), modes.rigid);
            // Degrees of freedom without stiffness leave round-off, of either sign.
            let top = lambda.iter().filter(|l| **l < f64::MAX).fold(0.0f64, |m, l| m.max(l.abs()));
            lambda.iter_mut().filter(|l| l.abs() < ROUND_OFF * top).for_each(|l| *l = 0.0);
            if lapack && largest {
                let d = Diagnostic::warning(
                    &checks::words::UNUSED_WORD,
                    "eigen: -fullGenLapack takes no notice of -findLargest in OpenSees",
                );
                warn(interp, d.at(call.span(0), "the smallest eigenvalues are given"))?;
            }
            if let Some(n) = lambda.iter().position(|l| *l == f64::MAX) {
                let d = Diagnostic::warning(
                    &checks::analysis::FEW_MODES,
                    format!("eigen: the model has only {n} modes: the others are infinite"),
                );
                warn(interp, d.at(span, "expected no more"))?;
            }
            if rigid > 0 {
                let message = format!("eigen: {rigid} modes move the model as a rigid body or a mechanism");
                let d = Diagnostic::warning(&checks::analysis::RIGID_MODES, message)
                    .at(span, "their eigenvalue is given as 0: they have no period");
                warn(interp, d.help("a model that is held everywhere has none"))?;
            }
            Ok(Value::list(lambda.into_iter().map(Value::from)))
        }
        Err(ModesError::Failure(f)) => Err(a.refuse_at(call.span(0), format!("eigen: {f}"), "")),
        Err(e @ ModesError::NotFound) => Err(a.refuse_at(call.span(0), format!("eigen: {e}"), "")),
        Err(e @ ModesError::TooFew { .. }) => Err(a.refuse_at(span, format!("eigen: {e}"), "expected no more")),
    }
}

fn wipe_analysis(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    finish(interp, &Args::new(call, "wipeAnalysis"))?;
    interp.host.engine.wipe_analysis();
    interp.host.parts = Parts { variable_steps: interp.host.parts.variable_steps, ..Parts::default() };
    Ok(Value::EMPTY)
}

fn reset(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    interp.host.builder.loads_time = None;
    interp.host.engine.reset();
    Ok(Value::EMPTY)
}

fn ladder(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, LADDER);
    let on = match a.word("on or off")?.as_ref() {
        "on" => true,
        "off" => false,
        _ => return Err(a.unknown_name("state of the ladder", ["on", "off"])),
    };
    finish(interp, &a)?;
    interp.host.engine.options.ladder = on.then(RecoveryStrategy::default);
    Ok(Value::EMPTY)
}
