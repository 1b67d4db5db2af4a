//! A script from its file to its outcome.

pub(crate) mod continued;
mod elements;

use crate::course::{self, Course};
use crate::files::live::RecordedFiles;
use crate::model::parameter_change::ScriptStart;
use crate::slips;
use crate::{Mode, Outputs, Session, Tcl};
use crate::{foreign, opensees_names};
use hysteron_engine::analysis::{Failure, Options, WorkCounts};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Console, Exception, Files, Interp, Value, Vocabulary};
use std::cell::OnceCell;

/// Settings of a run.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Run the script for its results, or check it.
    pub mode: Mode,
    /// Warnings are errors.
    pub strict: bool,
    /// Settings of the analyses.
    pub options: Options,
}

/// Outcome of a run.
#[derive(Debug)]
pub enum End {
    /// It came to its end.
    Done,
    /// It came to its end, but its last analysis had failed.
    Failed(Failure),
    /// It came to its end, and never looked at the result of an analysis that had failed.
    Ignored(Failure),
    /// It ended itself with this status.
    Exit(i32),
    /// A command was rejected.
    Rejected(Box<Diagnostic>),
    /// It raised an error of its own.
    Raised(Box<Diagnostic>),
    /// It was interrupted.
    Interrupted,
    /// A check ended early. With the error of a command that needs results of a run, or after as many commands as a check
    /// may run.
    Enough(Option<Box<Diagnostic>>),
}

impl End {
    /// Exit status: 0 done, 1 the analysis failed or the script raised an error of its own, 2 the input is wrong,
    /// 130 interrupted. Of the status that a script ends itself with, the system keeps the last byte: 255 of -1.
    pub fn status(&self) -> i32 {
        match self {
            Self::Done | Self::Enough(_) => 0,
            Self::Failed(_) | Self::Ignored(_) | Self::Raised(_) => 1,
            Self::Exit(n) => n.rem_euclid(256),
            Self::Rejected(_) => 2,
            Self::Interrupted => 130,
        }
    }
}

/// Commands after which a check stops looking: a script that waits for a result would never end.
const CHECK_BUDGET: u64 = 20_000_000;

/// The sentence for a check that ended after as many commands as it may run.
pub fn budget_used() -> String {
    let millions = CHECK_BUDGET / 1_000_000;
    format!("the check was stopped here, after {millions} million commands: a loop needs results or has no end")
}

thread_local! {
    /// The commands that every run begins with.
    static VOCABULARY: OnceCell<Vocabulary<Session>> = const { OnceCell::new() };
}

/// A script with all that it works on.
pub struct Run {
    /// The interpreter.
    pub interp: Tcl,
    /// Files of recorders that were at work when the script was stopped, as it names them. They have whole rows.
    pub partial: Vec<String>,
}

impl Run {
    /// Prepare to run a script.
    pub fn new(
        settings: Settings,
        console: Box<dyn Console>,
        files: Box<dyn Files>,
        outputs: Box<dyn Outputs>,
    ) -> Self {
        Self::with_course(settings, None, console, files, outputs)
    }

    /// Prepare to run a script whose [`Course`] is followed.
    pub fn with_course(
        settings: Settings,
        course: Option<Course>,
        console: Box<dyn Console>,
        files: Box<dyn Files>,
        outputs: Box<dyn Outputs>,
    ) -> Self {
        let Settings { mode, strict, options } = settings;
        let mut session = Session::new(options, mode, strict, outputs);
        session.course = course;
        let live = session.output.recorders.live.clone();
        let files = Box::new(RecordedFiles::new(files, live.clone()));
        let fresh = |session, console, files: Box<RecordedFiles>| {
            let mut interp = Interp::new(session, console, files);
            crate::install(&mut interp);
            interp
        };
        let mut interp = VOCABULARY.with(|known| match (mode, known.get()) {
            (Mode::Run, Some(words)) => Interp::with_vocabulary(session, console, files, words),
            (Mode::Run, None) => {
                let interp = fresh(session, console, files);
                let _ = known.set(interp.vocabulary());
                interp
            }
            (Mode::Check, _) => fresh(session, console, files),
        });
        interp.unknown_command_label = opensees_names::command_label;
        interp.is_foreign = foreign::recognize;
        // Where a file cannot be written, the script is told at its next command that looks.
        interp.on_pause = Some(Box::new(move || drop(live.sync())));
        interp.before_command = course.is_some().then_some(course::before_command);
        if mode == Mode::Check {
            interp.budget = Some(CHECK_BUDGET);
        }
        let interrupt = interp.interrupt.clone();
        interp.host.stop_on(interrupt);
        Self { interp, partial: vec![] }
    }

    /// Run a script; `args` become `$argv`. Recorders are finished in any case.
    pub fn script(&mut self, path: &str, args: &[String]) -> End {
        let result = self.begin(path, args);
        self.close(result)
    }

    /// Run a script up to its end, and leave its recorders open for [`Run::close`].
    ///
    /// # Errors
    /// The exception that ends it.
    pub fn begin(&mut self, path: &str, args: &[String]) -> Result<Value, Exception> {
        let set = |i: &mut Tcl, name: &str, value: Value| i.set_global(name, value);
        let list = Value::list(args.iter().map(|a| Value::from(a.as_str())));
        let known = set(&mut self.interp, "argv0", Value::from(path))
            .and_then(|_| set(&mut self.interp, "argc", Value::from(args.len() as i64)))
            .and_then(|_| set(&mut self.interp, "argv", list));
        known?;
        let globals = self.interp.globals();
        self.interp.host.start = Some(ScriptStart {
            elements: elements::made_elements,
            path: path.to_owned(),
            args: args.to_vec(),
            globals,
        });
        self.interp.eval_file(path)
    }

    /// End a run and finish its recorders.
    pub fn close(&mut self, result: Result<Value, Exception>) -> End {
        let end = self.end_of(result);
        if matches!(end, End::Interrupted) {
            self.partial = self.interp.host.open_files();
        }
        crate::check::finish(&mut self.interp);
        crate::check::warn_of_speeds(&mut self.interp);
        crate::check::report_ranges(&mut self.interp);
        self.interp.host.close_index();
        match (self.interp.host.finish(), end) {
            (Err(e), End::Done | End::Failed(_) | End::Ignored(_)) => {
                End::Raised(Box::new(Diagnostic::error(e.to_string())))
            }
            (_, end) => end,
        }
    }

    /// Counts of the work of the analyses so far.
    pub fn work_counts(&self) -> WorkCounts {
        self.interp.host.engine.work_counts()
    }

    fn end_of(&mut self, result: Result<Value, Exception>) -> End {
        match result {
            // OpenSees ends with status 0 whatever its last analysis did.
            Ok(_) if self.interp.host.follows(&[slips::EXIT_STATUS]) => End::Done,
            Ok(_) => {
                let host = &mut self.interp.host;
                let last = host.last_failure.take();
                last.map(End::Failed).or(host.ignored_failure.take().map(End::Ignored)).unwrap_or(End::Done)
            }
            Err(Exception::Exit(status)) => End::Exit(status),
            Err(Exception::Interrupted) if self.interp.budget == Some(0) => End::Enough(None),
            Err(Exception::Interrupted) => End::Interrupted,
            Err(Exception::Error(e)) if self.interp.host.check.waits_for_results => {
                End::Enough(Some(Box::new(e.diagnostic)))
            }
            Err(Exception::Error(e)) if e.raised => End::Raised(Box::new(e.diagnostic)),
            Err(Exception::Error(e)) => End::Rejected(Box::new(e.diagnostic)),
            Err(_) => End::Done,
        }
    }
}
