//! Dispatch of the commands, and the commands `run` and `check`.

use super::args::{Arguments, CheckArgs, CheckpointArgs, Command, EvidenceArgs, FolderArgs, ScriptArgs, StepArgs};
use super::balance;
use super::bearing::bearing;
use super::calibrate::INPUT_ERROR;
use super::checkpoint;
use super::console::{PrefixedOutput, Terminal};
use super::files::SystemFiles;
use super::help;
use super::limits::{LimitArgs, exceeded, interrupted_status};
use super::loops::loops;
use super::messages::Messages;
use super::print::write_out;
use super::progress::{ProgressLine, SharedGlance};
use super::review::{self, Ended, Observed};
use super::script_check::{self, print_summary};
use super::signals::on_interrupt;
use clap::FromArgMatches as _;
use hysteron::analysis::{Options, RecoveryStrategy, Threads};
use hysteron::design::batch::is_plan;
use hysteron::design::isolate::is_isolation_study;
use hysteron::diagnostic::Severity;
use hysteron::opensees::files::guard::{Guard, GuardedFiles, GuardedOutputs};
use hysteron::opensees::files::output_folder::OutputFolder;
use hysteron::opensees::{Mode, NoFiles, Outputs, Tcl};
use hysteron::run::{End, Run, Settings, budget_used};
use hysteron::tcl::Silent;
use hysteron::tcl::{Console, Files, OsFiles, OverlayFiles};
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Run the command of the command line; the exit status.
pub(crate) fn main() -> i32 {
    let arguments = Arguments::from_arg_matches(&help::command().get_matches()).unwrap_or_else(|e| e.exit());
    let status = match arguments.command {
        Command::Run { script, steps, limits, folders, evidence, checkpoints, quiet, model, args } => {
            let (script, steps, limits, folders, evidence) = (&script, &steps, &limits, &folders, &evidence);
            let checkpoints = &checkpoints;
            let run_args = RunArgs { script, steps, limits, folders, evidence, checkpoints, quiet };
            match &evidence.view {
                None => run(&run_args, &model, &args),
                Some(page) => super::view::run(&run_args, page, &model, &args),
            }
        }
        Command::View(args) => super::view::view(&args),
        Command::Check(args) if is_isolation_study(Path::new(&args.model)) => super::isolate::check(&args),
        Command::Check(args) if is_plan(Path::new(&args.model)) => super::batch::check(&args),
        Command::Check(args) if args.model.ends_with(".toml") => super::study::check(&args),
        Command::Check(args) if args.model.ends_with(".py") => {
            super::python_check::check(&args).unwrap_or_else(|| check(&args))
        }
        Command::Check(args) => check(&args),
        Command::Bearing(args) => bearing(&args),
        Command::Init(args) => super::init::init(&args),
        Command::Calibrate(args) => super::calibrate::calibrate(&args),
        Command::Diagnose(args) => super::diagnose::run(&args),
        Command::Learn(args) => super::learn::run(&args),
        Command::Loops(args) => print(loops(&args)),
        Command::Prototype(args) => print(super::prototype::prototype(&args)),
        Command::Isolate(args) => super::isolate::isolate(&args),
        Command::Ida(args) => super::fragility::ida(&args),
        Command::Fragility(args) => super::fragility::fragility(&args),
        Command::ResponseSpectrum(args) => super::response_spectrum::response_spectrum(&args),
        Command::Batch(args) => super::batch::batch(&args),
        Command::Recording(args) => print(super::recording::recording(&args)),
        Command::Motions(args) => print(super::motions::motions(&args)),
        Command::Commands { names } => print(super::commands::usages(&names)),
        Command::Explain { code } => print(super::explain::explained(code.as_deref())),
        Command::Lsp(args) => super::lsp::lsp(&args),
        Command::Completions { shell } => print(Ok(help::completions(shell))),
        Command::Man { folder } => print(help::man(&folder)),
    };
    super::print::status(status)
}

/// Print the result of a command, or its error; the exit status.
pub(super) fn print(result: Result<String, String>) -> i32 {
    match result {
        Ok(text) => {
            write_out(&text);
            0
        }
        Err(message) => {
            eprintln!("error: {message}");
            2
        }
    }
}

/// Arguments of a run besides the script.
pub(super) struct RunArgs<'a> {
    pub(super) script: &'a ScriptArgs,
    pub(super) steps: &'a StepArgs,
    pub(super) limits: &'a LimitArgs,
    pub(super) folders: &'a FolderArgs,
    pub(super) evidence: &'a EvidenceArgs,
    pub(super) checkpoints: &'a CheckpointArgs,
    pub(super) quiet: bool,
}

/// Run a script; the exit status.
pub(super) fn run(args: &RunArgs<'_>, model: &str, words: &[String]) -> i32 {
    run_prepared(args, model, words, |_| ()).map_or_else(|status| status, |(status, _)| status)
}

/// Run a script that `prepare` has seen before; the exit status, and the run with its model. The error is the exit status of a
/// run that cannot begin.
pub(super) fn run_prepared(
    args: &RunArgs<'_>,
    model: &str,
    words: &[String],
    prepare: impl FnOnce(&mut Run),
) -> Result<(i32, Run), i32> {
    let progress = ProgressLine::new();
    let (mut files, mut outputs) = guarded(args.folders, model).map_err(|message| {
        eprintln!("error: {message}");
        INPUT_ERROR
    })?;
    let EvidenceArgs { balance, review, .. } = args.evidence;
    let observed = Observed::default();
    if review.is_some() || args.checkpoints.checkpoint.is_some() {
        (files, outputs) = observed.around(files, outputs);
    }
    let console = Terminal::new(progress.clone());
    let mut run = Run::new(settings(args.script, args.steps, Mode::Run), Box::new(console), files, outputs);
    if args.folders.sandbox {
        hide_environment(&mut run.interp);
    }
    if !args.quiet {
        let glance = std::io::stderr().is_terminal().then(SharedGlance::default);
        run.interp.host.set_progress(Box::new(progress.steps(glance.clone())));
        if let Some(glance) = glance {
            run.interp.host.observe_motion(Box::new(glance));
        }
    }
    if balance.is_some() || review.is_some() {
        run.interp.host.balance_energy(matches!(balance, Some(Some(_))));
    }
    let kept = checkpoint::begin(args, model, words, &observed, &mut run).map_err(|message| {
        eprintln!("error: {message}");
        INPUT_ERROR
    })?;
    prepare(&mut run);
    let end = execute(&mut run, &progress, args.limits, model, words);
    if let Some(files) = kept.filter(|_| matches!(end, End::Done | End::Exit(0))) {
        files.remove();
    }
    print_summary(&run.interp);
    let balanced = match (run.interp.host.balances(), balance) {
        (Some(balances), Some(history)) => balance::print(balances, history.as_deref()),
        _ => Ok(()),
    };
    let reviewed = review.as_ref().map_or(Ok(()), |path| {
        review::write(path, args, &observed, &Ended { model, words, end: &end, interp: &run.interp })
    });
    let least = balanced.and(reviewed).map_or_else(
        |message| {
            eprintln!("error: {message}");
            1
        },
        |()| 0,
    );
    Ok((status(&end).max(least), run))
}

/// The exit status of a script.
pub(super) fn status(end: &End) -> i32 {
    match end {
        End::Interrupted => interrupted_status(end.status()),
        _ => end.status(),
    }
}

/// Leave a script no variable of the environment but the folder of the user, which `~` in a path means.
fn hide_environment(interp: &mut Tcl) {
    let script =
        "foreach name [array names ::env] { if {$name ne {HOME}} { unset ::env($name) } }; unset -nocomplain name";
    if interp.eval_str("sandbox", script).is_err() {
        eprintln!("warning: the environment is not hidden from the script");
    }
}

/// Files of a script, and files of its recorders.
pub(super) type FilesAndOutputs = (Box<dyn Files>, Box<dyn Outputs>);

/// Files and recorder files of a script that may write below the current folder and into the folders of the arguments.
pub(super) fn guarded(folders: &FolderArgs, model: &str) -> Result<FilesAndOutputs, String> {
    let cannot = |what: &str, folder: &Path, e: std::io::Error| format!("cannot {what} {}: {e}", folder.display());
    let (files, outputs): FilesAndOutputs = match &folders.out {
        None => (Box::new(OsFiles), Box::new(SystemFiles)),
        Some(out) => {
            let folder = OutputFolder::new(out).map_err(|e| e.to_string())?;
            (Box::new(folder.clone()), Box::new(folder))
        }
    };
    let write = folders.allow_write.iter().chain(&folders.out).map(PathBuf::as_path);
    for folder in &folders.allow_write {
        folder.canonicalize().map_err(|e| cannot("write into", folder, e))?;
    }
    let mut guard = Guard::new(write.chain([Path::new(".")])).map_err(|e| cannot("find", Path::new("."), e))?;
    if folders.sandbox {
        let own = Path::new(model).parent().filter(|p| p.is_dir());
        guard = guard.read_only_below(own).map_err(|e| cannot("find", Path::new(model), e))?;
    }
    let guard = Rc::new(guard);
    Ok((Box::new(GuardedFiles { files, guard: guard.clone() }), Box::new(GuardedOutputs { outputs, guard })))
}

/// Check a script; the exit status.
fn check(args: &CheckArgs) -> i32 {
    let progress = ProgressLine::new();
    // Numbers that the script prints are not the results of an analysis.
    let console: Box<dyn Console> =
        if args.show_output { Box::new(PrefixedOutput::new(&args.model)) } else { Box::new(Silent) };
    let files = OverlayFiles::new(Box::new(OsFiles));
    let settings = settings(&args.script, &StepArgs::default(), Mode::Check);
    let mut run = Run::new(settings, console, Box::new(files), Box::new(NoFiles));
    let end = execute(&mut run, &progress, &args.limits, &args.model, &args.args);
    if run.interp.host.check.skipped_analyses {
        eprintln!("note: the analyses were not rehearsed, since a definition was rejected");
    }
    print_summary(&run.interp);
    let is_rejected = run.interp.warnings.iter().any(|w| w.severity == Severity::Error);
    let status = if is_rejected { INPUT_ERROR } else { status(&end) };
    if args.json {
        let last = match &end {
            End::Rejected(d) | End::Raised(d) => Some(&**d),
            _ => None,
        };
        return print(Ok(script_check::json(&args.model, &run.interp, last))).max(status);
    }
    if status == 0 {
        let facts = script_check::facts(&run.interp);
        return print(Ok(format!("{facts}{}: {}\n", args.model, script_check::found(&run.interp))));
    }
    status
}

pub(super) fn settings(script: &ScriptArgs, steps: &StepArgs, mode: Mode) -> Settings {
    let options = Options {
        compat: script.compat.is_some(),
        ladder: steps.ladder.then(RecoveryStrategy::default),
        dense: None,
        refine: steps.refine,
        threads: steps.threads.map_or_else(Threads::of_machine, |n| Threads::new(n as usize)),
    };
    Settings { mode, strict: script.strict, options }
}

/// Run or check a script, and print its messages.
pub(super) fn execute(run: &mut Run, progress: &ProgressLine, limits: &LimitArgs, model: &str, args: &[String]) -> End {
    let line = progress.clone();
    let mut shown = 0;
    run.interp.host.on_warning(Box::new(move |warning, sources| {
        shown += 1;
        if shown <= MAX_SHOWN {
            line.suspend(|| eprintln!("{}\n", Messages::new().render(warning, sources)));
        }
        if shown == MAX_SHOWN {
            eprintln!("note: {MAX_SHOWN} messages are shown; further ones are counted only");
        }
    }));
    on_interrupt(&run.interp.interrupt);
    limits.enforce(&run.interp.interrupt);
    let end = run.script(model, args);
    progress.clear();
    print_end(&end, &run.interp);
    print_partial(&run.partial);
    end
}

/// Names of files that a message lists.
const MAX_LISTED: usize = 12;

/// Say which recorder files are whole rows of an analysis that was not completed.
fn print_partial(files: &[String]) {
    if files.is_empty() {
        return;
    }
    let more = files.len().saturating_sub(MAX_LISTED);
    let more = if more > 0 { format!(", and {more} more") } else { String::new() };
    eprintln!("partial, with whole rows up to there: {}{more}", files[..files.len().min(MAX_LISTED)].join(", "));
}

/// Messages that are shown in full; more of them help nobody, and each takes the length of its line.
pub(super) const MAX_SHOWN: usize = 200;

/// Print the end of a script that did not just succeed.
pub(super) fn print_end(end: &End, interp: &Tcl) {
    let messages = Messages::new();
    match end {
        End::Rejected(d) | End::Raised(d) => eprintln!("{}", messages.render(d, &interp.sources)),
        End::Failed(f) => eprintln!("error: the last analysis failed: {f}"),
        End::Ignored(f) => eprintln!("error: an analysis failed, and the script went on without a look at it: {f}"),
        End::Interrupted => {
            let place = interp.stopped_at.map(|s| format!(" at {}", interp.sources.location(s))).unwrap_or_default();
            match exceeded() {
                Some(why) => eprintln!("error: stopped{place}: {why}"),
                None => eprintln!("interrupted{place}: what was recorded so far has been kept"),
            }
        }
        End::Enough(None) => {
            let place = interp.stopped_at.map(|s| format!("{}: ", interp.sources.location(s))).unwrap_or_default();
            eprintln!("note: {place}{}", budget_used());
        }
        End::Enough(Some(d)) => {
            let place = messages.line(d, &interp.sources);
            eprintln!("note: the check ends where the script needs results of the analysis: {place}");
        }
        End::Done | End::Exit(_) => {}
    }
}
