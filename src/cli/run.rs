//! Dispatch of the commands, and the commands `run`, `check` and `commands`.

use super::args::{Arguments, Command, ScriptArgs, StepArgs};
use super::bearing::bearing;
use super::console::Terminal;
use super::files::{NoFiles, SystemFiles};
use super::loops::loops;
use super::messages::Messages;
use super::progress::ProgressLine;
use clap::Parser;
use hysteron::analysis::{Options, RecoveryStrategy};
use hysteron::diagnostic::{Diagnostic, Severity, Span, nearest};
use hysteron::opensees::{self, Mode, Outputs, Tcl};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{Files, OsFiles, OverlayFiles};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Run the command of the command line; the exit status.
pub(crate) fn main() -> i32 {
    match Arguments::parse().command {
        Command::Run { script: s, steps, model, args } => script(&s, Mode::Run, &steps, &model, &args),
        Command::Check { script: s, model, .. } if model.ends_with(".toml") => {
            super::study::check(Path::new(&model), s.compat, s.strict)
        }
        Command::Check { script: s, model, args } => script(&s, Mode::Check, &StepArgs::default(), &model, &args),
        Command::Bearing(args) => bearing(&args),
        Command::Init(args) => super::study::init(&args),
        Command::Calibrate(args) => super::calibrate::calibrate(&args),
        Command::Diagnose(args) => super::diagnose::run(&args),
        Command::Loops(args) => print(loops(&args)),
        Command::Commands { command } => print(usages(command.as_deref())),
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

/// Usage of all commands, or the kinds of one.
fn usages(command: Option<&str>) -> Result<String, String> {
    let Some(name) = command else {
        return Ok(opensees::commands().map(|c| c.usage_line() + "\n").collect());
    };
    let kinds: String = opensees::kinds(name).iter().map(|k| format!("{k}\n")).collect();
    if !kinds.is_empty() {
        return Ok(kinds);
    }
    match opensees::commands().find(|c| c.name == name) {
        Some(c) => Ok(c.usage_line() + "\n"),
        None => Err(match nearest(name, opensees::commands().map(|c| c.name)) {
            Some(near) => format!("there is no command \"{name}\": did you mean \"{near}\"?"),
            None => format!("there is no command \"{name}\""),
        }),
    }
}

/// Run or check a script; the exit status.
pub(super) fn script(script: &ScriptArgs, mode: Mode, steps: &StepArgs, model: &str, args: &[String]) -> i32 {
    let progress = ProgressLine::new();
    let options = Options {
        compat: script.compat.is_some(),
        ladder: steps.ladder.then(RecoveryStrategy::default),
        dense: None,
        refine: steps.refine,
    };
    let settings = Settings { mode, strict: script.strict, options };
    let console = Terminal::new(progress.clone());
    let outputs: Box<dyn Outputs> = if mode == Mode::Run { Box::new(SystemFiles) } else { Box::new(NoFiles) };
    let files: Box<dyn Files> =
        if mode == Mode::Run { Box::new(OsFiles) } else { Box::new(OverlayFiles::new(Box::new(OsFiles))) };
    let mut run = Run::new(settings, Box::new(console), files, outputs);
    run.interp.host.set_progress(Box::new(progress.steps()));
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
    if run.interp.host.check.skipped_analyses {
        eprintln!("note: the analyses were not rehearsed, since a definition was rejected");
    }
    print_warning_summary(&run.interp);
    let rejected = mode == Mode::Check && run.interp.warnings.iter().any(|w| w.severity == Severity::Error);
    if rejected { 2 } else { end.status() }
}

/// Set a flag when the user interrupts; a second interrupt ends the program at once.
pub(super) fn on_interrupt(flag: &Arc<AtomicBool>) {
    let flag = flag.clone();
    let handled = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            #[expect(clippy::exit, reason = "the first interrupt was not enough")]
            std::process::exit(130);
        }
    });
    if let Err(e) = handled {
        eprintln!("note: interrupts are not caught: {e}");
    }
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

/// Print all warnings again, one line each, so that none is overlooked.
fn print_warning_summary(interp: &Tcl) {
    let messages = Messages::new();
    let mut lines: Vec<(String, usize)> = vec![];
    for w in &interp.warnings {
        let kind = if w.severity == Severity::Error { "error" } else { "warning" };
        let line = format!("{kind}: {}", messages.line(w, &interp.sources));
        match lines.iter_mut().find(|(l, _)| *l == line) {
            Some((_, n)) => *n += 1,
            None => lines.push((line, 1)),
        }
    }
    if lines.is_empty() {
        return;
    }
    let count = |severity| interp.warnings.iter().filter(|w| w.severity == severity).count();
    let plural = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
    let totals = [(count(Severity::Error), "error"), (count(Severity::Warning), "warning")];
    let totals: Vec<String> = totals.iter().filter(|t| t.0 > 0).map(|t| plural(t.0, t.1)).collect();
    eprintln!("{}:", totals.join(", "));
    for (line, n) in lines.iter().take(30) {
        let times = if *n > 1 { format!(" ({n} times)") } else { String::new() };
        eprintln!("  {line}{times}");
    }
    if lines.len() > 30 {
        eprintln!("  ... and {} more", lines.len() - 30);
    }
}
