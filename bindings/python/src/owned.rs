//! A model that one thread at a time uses.

use crate::log::CallLog;
use crate::methods::Entry;
use hysteron_opensees::Command;
use hysteron_opensees::run::Run;
use hysteron_tcl::{Exception, Value};
use hysteron_view::{Collector, Observer, Units, page};

/// An interpreter with all that it works on, which may be handed from thread to thread.
pub(crate) struct Owned {
    run: Run,
    words: Vec<Value>,
    /// Names of the commands that have been called, by their place among all.
    names: Vec<Value>,
    outcome: Option<Result<Value, Exception>>,
    /// Keeps the motion for a page, once that has been asked for.
    observer: Option<Observer>,
    /// Calls that have made the model.
    pub(crate) log: CallLog,
    /// Outcome of making the calls of another model, with the name of the command that is not accepted.
    made_again: Result<(), (&'static str, Exception)>,
}

impl Owned {
    pub(crate) fn new(run: Run) -> Self {
        Self {
            run,
            words: vec![],
            names: vec![],
            outcome: None,
            observer: None,
            log: CallLog::default(),
            made_again: Ok(()),
        }
    }

    pub(crate) fn run(&mut self) -> &mut Run {
        &mut self.run
    }

    /// Keep the motion from here on.
    pub(crate) fn watch(&mut self) {
        let observer = Observer::new(0);
        self.run.interp.host.observe_motion(Box::new(observer.clone()));
        self.observer = Some(observer);
    }

    /// A page that shows the motion so far, or the committed state where it is not kept; `None` without nodes.
    pub(crate) fn page(&mut self, title: &str, units: &Units, modes: usize) -> Option<String> {
        let collector = self.observer.as_ref().map_or_else(Collector::default, Observer::collected).with_modes(modes);
        let models = collector.models.max(1);
        let motion = collector.finish(&mut self.run.interp.host.engine)?;
        Some(page(&motion, title, units, models))
    }

    /// The name of a command as the first of the words of its call.
    pub(crate) fn put_name(&mut self, entry: &Entry, words: &mut [Value]) {
        if self.names.len() <= entry.index {
            self.names.resize(entry.index + 1, Value::EMPTY);
        }
        let name = &mut self.names[entry.index];
        if name.is_empty() {
            *name = Value::from(entry.command.name);
        }
        if let Some(first) = words.first_mut() {
            *first = name.clone();
        }
    }

    /// Keep the words of the next call.
    pub(crate) fn set_words(&mut self, words: Vec<Value>) {
        self.words = words;
    }

    /// Call a command with the words, and keep its outcome.
    pub(crate) fn call(&mut self, command: &'static Command) {
        self.outcome = Some(self.run.call(command, &self.words));
    }

    /// Make the calls of the log, which are those of another model.
    pub(crate) fn make_again(&mut self) {
        self.made_again = self.log.make(&mut self.run);
    }

    /// Outcome of making the calls of another model.
    pub(crate) fn take_made_again(&mut self) -> Result<(), (&'static str, Exception)> {
        std::mem::replace(&mut self.made_again, Ok(()))
    }

    /// Words and outcome of the last call.
    pub(crate) fn take(&mut self) -> (Vec<Value>, Result<Value, Exception>) {
        (std::mem::take(&mut self.words), self.outcome.take().unwrap_or(Ok(Value::EMPTY)))
    }
}

// SAFETY: The values of an interpreter count their references without locks, so that all references to one must stay
// with one thread at a time. `Run::for_calls` makes an interpreter that shares no value with the thread's other interpreters:
// - Variables that the host sets or reads by name have texts of their own (`VarName::of_host` of the crate `hysteron-tcl`). Names in
//   scripts are shared by a thread, but no text is run as a script here: a command that has a body in Tcl refuses one from a host.
// - For the same reason the thread's store of parsed files has no part in it.
// - The list of the recorders' files is shared by the session and the files of this interpreter alone.
// The observer and its copy in the run are used under the same lock. The log has words of this interpreter's calls, or copies of
// another one's that share nothing with them (`CallLog::anew`). Words are made, and answers taken apart, while the lock of
// `Domain` is held; none is kept outside. The lock orders the threads.
unsafe impl Send for Owned {}
