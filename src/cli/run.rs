//! What the sub-commands do.

use super::args::{Arguments, Care, Command, Switches};
use super::bearing::bearing;
use super::console::Terminal;
use super::files::{NoFiles, SystemFiles};
use super::loops::loops;
use super::messages::Messages;
use super::progress::Bar;
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

/// Carry out the command line; the exit status.
pub(crate) fn main() -> i32 {
    match Arguments::parse().command {
        Command::Run { switches: run, care, model, args } => script(&run, Mode::Run, &care, &model, &args),
        Command::Check { switches: s, model, .. } if model.ends_with(".toml") => {
            super::study::check(Path::new(&model), s.compat, s.strict)
        }
        Command::Check { switches: run, model, args } => script(&run, Mode::Check, &Care::default(), &model, &args),
        Command::Bearing(test) => bearing(&test),
        Command::Calibrate(args) => super::calibrate::calibrate(&args),
        Command::Diagnose(args) => super::diagnose::run(&args),
        Command::Loops(a) => print(loops(&a)),
        Command::Commands { command } => print(usages(command.as_deref())),
    }
}

/// Print what a sub-command has found out, or why it could not.
pub(super) fn print(result: Result<String, String>) -> i32 {
    match result {
        Ok(text) => {
            // A reader that has gone away is no reason to complain.
            let _ = std::io::stdout().write_all(text.as_bytes());
            0
        }
        Err(message) => {
            eprintln!("error: {message}");
            2
        }
    }
}

/// How commands are used: all of them, or the kinds of one.
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
pub(super) fn script(run: &Switches, mode: Mode, care: &Care, model: &str, args: &[String]) -> i32 {
    let bar = Bar::new();
    let options = Options {
        compat: run.compat.is_some(),
        ladder: care.ladder.then(RecoveryStrategy::default),
        dense: None,
        refine: care.refine,
    };
    let settings = Settings { mode, strict: run.strict, options };
    let console = Terminal::new(bar.clone());
    let outputs: Box<dyn Outputs> = if mode == Mode::Run { Box::new(SystemFiles) } else { Box::new(NoFiles) };
    let files: Box<dyn Files> =
        if mode == Mode::Run { Box::new(OsFiles) } else { Box::new(OverlayFiles::new(Box::new(OsFiles))) };
    let mut run = Run::new(settings, Box::new(console), files, outputs);
    run.interp.host.set_progress(Box::new(bar.steps()));
    let aside = bar.clone();
    let mut shown = Shown::default();
    run.interp.host.on_warning(Box::new(move |warning, sources| {
        if shown.wants(warning) {
            aside.aside(|| eprintln!("{}\n", Messages::new().render(warning, sources)));
        }
    }));
    on_interrupt(&run.interp.interrupt);
    let end = run.script(model, args);
    bar.clear();
    tell_end(&end, &run.interp);
    if run.interp.host.check.skipped_analyses {
        eprintln!("note: the analyses were not rehearsed, since a definition was rejected");
    }
    summarise(&run.interp);
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

/// How often a warning from one place has been shown.
#[derive(Default)]
struct Shown(BTreeMap<(Option<(u32, u32)>, String), usize>);

impl Shown {
    /// Warnings from one place are shown three times in full.
    fn wants(&mut self, w: &Diagnostic) -> bool {
        let place = w.span.map(|s: Span| (s.start, s.end));
        let count = self.0.entry((place, w.label.clone())).or_default();
        *count += 1;
        *count <= 3
    }
}

/// Tell how a script ended, where that is worth it.
pub(super) fn tell_end(end: &End, interp: &Tcl) {
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

/// Everything again that was told on the way, a line each, so that nothing is overlooked.
fn summarise(interp: &Tcl) {
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
