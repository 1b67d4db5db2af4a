//! Dispatch of the commands, and the commands `run` and `check`.

use super::args::{Arguments, CheckArgs, Command, ScriptArgs, StepArgs};
use super::bearing::bearing;
use super::calibrate::INPUT_ERROR;
use super::console::{NoOutput, PrefixedOutput, Terminal};
use super::files::{NoFiles, SystemFiles};
use super::help;
use super::loops::loops;
use super::messages::Messages;
use super::output_folder::OutputFolder;
use super::progress::ProgressLine;
use super::script_check::{self, print_summary};
use super::signals::on_interrupt;
use clap::FromArgMatches as _;
use hysteron::analysis::{Options, RecoveryStrategy};
use hysteron::diagnostic::{Diagnostic, Severity, Span};
use hysteron::opensees::{Mode, Outputs, Tcl};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{Console, Files, OsFiles, OverlayFiles};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::Path;

/// Run the command of the command line; the exit status.
pub(crate) fn main() -> i32 {
    let arguments = Arguments::from_arg_matches(&help::command().get_matches()).unwrap_or_else(|e| e.exit());
    match arguments.command {
        Command::Run { script: s, steps, out, model, args } => run(&s, &steps, out.as_deref(), &model, &args),
        Command::Check(args) if args.model.ends_with(".toml") => {
            super::study::check(Path::new(&args.model), args.script.compat, args.script.strict, args.json)
        }
        Command::Check(args) => check(&args),
        Command::Bearing(args) => bearing(&args),
        Command::Init(args) => super::init::init(&args),
        Command::Calibrate(args) => super::calibrate::calibrate(&args),
        Command::Diagnose(args) => super::diagnose::run(&args),
        Command::Loops(args) => print(loops(&args)),
        Command::Prototype(args) => print(super::prototype::prototype(&args)),
        Command::Isolate(args) => super::isolate::isolate(&args),
        Command::Motions(args) => print(super::motions::motions(&args)),
        Command::Commands { names } => print(super::commands::usages(&names)),
        Command::Completions { shell } => print(Ok(help::completions(shell))),
        Command::Man { folder } => print(help::man(&folder)),
    }
}

/// Print the result of a command, or its error; the exit status.
pub(super) fn print(result: Result<String, String>) -> i32 {
    match result {
        Ok(text) => {
            // A closed pipe is no error.
            let _ = std::io::stdout().write_all(text.as_bytes());
            0
        }
        Err(message) => {
            eprintln!("error: {message}");
            2
        }
    }
}

/// Run a script; the exit status.
pub(super) fn run(script: &ScriptArgs, steps: &StepArgs, out: Option<&Path>, model: &str, args: &[String]) -> i32 {
    let progress = ProgressLine::new();
    let (files, outputs): (Box<dyn Files>, Box<dyn Outputs>) = match out.map(OutputFolder::new) {
        None => (Box::new(OsFiles), Box::new(SystemFiles)),
        Some(Ok(folder)) => (Box::new(folder.clone()), Box::new(folder)),
        Some(Err(e)) => {
            eprintln!("error: cannot make {}: {e}", out.unwrap_or(Path::new("")).display());
            return INPUT_ERROR;
        }
    };
    let console = Terminal::new(progress.clone());
    let mut run = Run::new(settings(script, steps, Mode::Run), Box::new(console), files, outputs);
    run.interp.host.set_progress(Box::new(progress.steps()));
    let end = execute(&mut run, &progress, model, args);
    print_summary(&run.interp);
    end.status()
}

/// Check a script; the exit status.
fn check(args: &CheckArgs) -> i32 {
    let progress = ProgressLine::new();
    // Numbers that the script prints are not the results of an analysis.
    let console: Box<dyn Console> =
        if args.show_output { Box::new(PrefixedOutput::new(&args.model)) } else { Box::new(NoOutput) };
    let files = OverlayFiles::new(Box::new(OsFiles));
    let settings = settings(&args.script, &StepArgs::default(), Mode::Check);
    let mut run = Run::new(settings, console, Box::new(files), Box::new(NoFiles));
    let end = execute(&mut run, &progress, &args.model, &args.args);
    if run.interp.host.check.skipped_analyses {
        eprintln!("note: the analyses were not rehearsed, since a definition was rejected");
    }
    print_summary(&run.interp);
    let is_rejected = run.interp.warnings.iter().any(|w| w.severity == Severity::Error);
    let status = if is_rejected { INPUT_ERROR } else { end.status() };
    if args.json {
        let last = match &end {
            End::Rejected(d) | End::Raised(d) => Some(&**d),
            _ => None,
        };
        return print(Ok(script_check::json(&args.model, &run.interp, last))).max(status);
    }
    if status == 0 {
        let warnings = run.interp.warnings.len();
        let found = if warnings == 0 { "no mistakes".into() } else { format!("no errors, {warnings} warnings") };
        return print(Ok(format!("{}: {found}\n", args.model)));
    }
    status
}

fn settings(script: &ScriptArgs, steps: &StepArgs, mode: Mode) -> Settings {
    let options = Options {
        compat: script.compat.is_some(),
        ladder: steps.ladder.then(RecoveryStrategy::default),
        dense: None,
        refine: steps.refine,
    };
    Settings { mode, strict: script.strict, options }
}

/// Run or check a script, and print its messages.
fn execute(run: &mut Run, progress: &ProgressLine, model: &str, args: &[String]) -> End {
    let line = progress.clone();
    let mut counts = WarningCounts::default();
    run.interp.host.on_warning(Box::new(move |warning, sources| {
        if counts.is_shown(warning) {
            line.suspend(|| eprintln!("{}\n", Messages::new().render(warning, sources)));
        }
    }));
    on_interrupt(&run.interp.interrupt);
    let end = run.script(model, args);
    progress.clear();
    print_end(&end, &run.interp);
    end
}

/// Number of warnings from each location and label.
#[derive(Default)]
struct WarningCounts(BTreeMap<(Option<(u32, u32)>, String), usize>);

impl WarningCounts {
    /// Count a warning. Returns true for the first three of a location, which are shown in full.
    fn is_shown(&mut self, w: &Diagnostic) -> bool {
        let location = w.span.map(|s: Span| (s.start, s.end));
        let count = self.0.entry((location, w.label.clone())).or_default();
        *count += 1;
        *count <= 3
    }
}

/// Print the end of a script that did not just succeed.
pub(super) fn print_end(end: &End, interp: &Tcl) {
    let messages = Messages::new();
    match end {
        End::Rejected(d) | End::Raised(d) => eprintln!("{}", messages.render(d, &interp.sources)),
        End::Failed(f) => eprintln!("error: the last analysis failed: {f}"),
        End::Interrupted => eprintln!("interrupted: what was recorded so far has been kept"),
        End::Enough(None) => eprintln!("note: the check was ended: the script waits for results that only a run has"),
        End::Enough(Some(d)) => {
            let place = messages.line(d, &interp.sources);
            eprintln!("note: the check ends where the script needs results of the analysis: {place}");
        }
        End::Done | End::Exit(_) => {}
    }
}
