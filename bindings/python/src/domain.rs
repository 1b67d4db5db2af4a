//! A model with its state and analysis, as Python sees it.

use crate::errors::{OpenSeesError, Place};
use crate::messages::render;
use crate::methods::Entry;
use crate::outputs::{self, Files, MEMORY, Shared, Signals, Text, hold};
use crate::owned::Owned;
use crate::words::words;
use hysteron_engine::analysis::{Options, RecoveryStrategy, Threads};
use hysteron_opensees::checks::output::NO_RESPONSE;
use hysteron_opensees::run::{Run, Settings};
use hysteron_opensees::{Continued, Mode, Session};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Exception, OsFiles, Value};
use hysteron_view::Units;
use numpy::PyArray2;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{PyInt, PyTuple};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, MutexGuard, TryLockError};

/// Steps times elements up to which an analysis is so short that other threads do not notice it.
const MAX_HELD_WORK: usize = 200;

/// A model with its state and analysis: each command of OpenSees by `_call`, and fast queries.
#[pyclass(frozen, subclass, module = "hysteron._hysteron")]
pub(crate) struct Domain {
    inner: Mutex<Inner>,
    text: Text,
    files: Files,
    warned: Shared<Vec<Diagnostic>>,
    raised: Shared<Option<PyErr>>,
    /// Function of Python that is told of steps.
    told: Shared<Option<Py<PyAny>>>,
}

/// Parts of a model that one thread at a time uses.
pub(crate) struct Inner {
    owned: Owned,
    /// Reactions at all degrees of freedom of the present state, once they have been asked for.
    pub(crate) reactions: Option<Vec<f64>>,
    recorded: usize,
}

impl Inner {
    pub(crate) fn session(&mut self) -> &mut Session {
        &mut self.owned.run().interp.host
    }

    /// Returns true if an analysis of so many steps is shorter than the change between two threads.
    fn is_short(&mut self, steps: usize) -> bool {
        let engine = &self.session().engine;
        steps.saturating_mul(engine.model().elements.len()) <= MAX_HELD_WORK && engine.options.ladder.is_none()
    }
}

impl Domain {
    /// Hold the model.
    pub(crate) fn hold(&self) -> PyResult<MutexGuard<'_, Inner>> {
        self.inner.try_lock().map_err(|e| match e {
            TryLockError::WouldBlock => PyRuntimeError::new_err("the model is in use: an analysis runs, or a command"),
            TryLockError::Poisoned(_) => PyRuntimeError::new_err("the model is not usable after an internal error"),
        })
    }

    /// Call a command with Python's arguments.
    pub(crate) fn enter(
        &self,
        py: Python<'_>,
        entry: &'static Entry,
        args: &Bound<'_, PyTuple>,
    ) -> PyResult<Py<PyAny>> {
        let words = words(entry, args)?;
        if entry.is_long { self.long_command(py, entry, words) } else { self.command(py, entry, words) }
    }

    /// Call a command with words.
    pub(crate) fn command(&self, py: Python<'_>, entry: &'static Entry, mut words: Vec<Value>) -> PyResult<Py<PyAny>> {
        let mut inner = self.hold()?;
        inner.owned.put_name(entry, &mut words);
        if !entry.asks {
            inner.reactions = None;
        }
        let run = inner.owned.run();
        run.interp.interrupt.store(false, Ordering::Relaxed);
        let outcome = run.call(entry.command, &words);
        let is_accepted = outcome.is_ok();
        let result = self.finish(py, &mut inner, entry, &words, outcome);
        // The name is shared with the model: its references are counted while the model is held.
        if is_accepted {
            inner.owned.log.add(entry.command, words);
        }
        result
    }

    /// Make steps of an analysis: without a look at the words, and holding Python's interpreter, where it is short and goes on
    /// from the last call.
    pub(crate) fn continue_analysis(
        &self,
        py: Python<'_>,
        entry: &'static Entry,
        steps: usize,
        dt: Option<f64>,
        all: impl FnOnce() -> PyResult<Vec<Value>>,
    ) -> PyResult<Py<PyAny>> {
        let mut inner = self.hold()?;
        if !inner.is_short(steps) {
            drop(inner);
            return self.long_command(py, entry, all()?);
        }
        inner.reactions = None;
        let run = inner.owned.run();
        run.interp.interrupt.store(false, Ordering::Relaxed);
        match run.continue_analysis(steps, dt) {
            Some(Continued::Silent) => {
                if !inner.owned.log.again(steps, dt) {
                    let mut words = all()?;
                    inner.owned.put_name(entry, &mut words);
                    inner.owned.log.add(entry.command, words);
                }
                Ok(PyInt::new(py, 0).into_any().unbind())
            }
            Some(Continued::Told(done)) => {
                let mut words = all()?;
                inner.owned.put_name(entry, &mut words);
                let outcome = inner.owned.run().conclude(done, &words);
                let is_interrupted = matches!(outcome, Err(Exception::Interrupted));
                let result = self.finish(py, &mut inner, entry, &words, outcome);
                inner.owned.log.analysed(entry.command, words, is_interrupted);
                result
            }
            None => {
                drop(inner);
                self.command(py, entry, all()?)
            }
        }
    }

    /// The same for a command that may take long.
    fn long_command(&self, py: Python<'_>, entry: &'static Entry, mut words: Vec<Value>) -> PyResult<Py<PyAny>> {
        let mut inner = self.hold()?;
        inner.reactions = None;
        inner.owned.run().interp.interrupt.store(false, Ordering::Relaxed);
        let owned = &mut inner.owned;
        owned.put_name(entry, &mut words);
        owned.set_words(words);
        py.detach(|| owned.call(entry.command));
        let (words, outcome) = owned.take();
        let (is_accepted, is_interrupted) = (outcome.is_ok(), matches!(outcome, Err(Exception::Interrupted)));
        let result = self.finish(py, &mut inner, entry, &words, outcome);
        if is_accepted || is_interrupted {
            inner.owned.log.analysed(entry.command, words, is_interrupted);
        }
        result
    }

    /// Give out text and warnings, and the answer or the error.
    fn finish(
        &self,
        py: Python<'_>,
        inner: &mut Inner,
        entry: &'static Entry,
        words: &[Value],
        outcome: Result<Value, Exception>,
    ) -> PyResult<Py<PyAny>> {
        let interp = &mut inner.owned.run().interp;
        let warned = std::mem::take(&mut *hold(&self.warned));
        interp.core.clear_warnings();
        let numbers = interp.host.call_numbers();
        let render = |d: &Diagnostic| render(d, words, numbers, &interp.core.sources);
        let mut warned: Vec<String> = warned.iter().map(&render).collect();
        let result = match outcome {
            Ok(value) => entry.answer.object(py, &value),
            // openseespy has no message here, and programs that show models ask for what may not be there.
            Err(Exception::Error(e)) if e.diagnostic.check.is_some_and(|c| c.code == NO_RESPONSE.code) => {
                warned.push(render(&e.diagnostic));
                Ok(entry.answer.nothing(py))
            }
            Err(Exception::Error(e)) => {
                let d = &e.diagnostic;
                let place = match d.span {
                    Some(span) if !numbers.is_call(span) => Place::in_file(d, &interp.core.sources),
                    _ => Place::of_call(py, d),
                };
                Err(place.error(py, render(d)))
            }
            Err(Exception::Interrupted) => Err(self.interruption()),
            Err(_) => Err(OpenSeesError::new_err(format!("{}: ended by a command of its body", entry.command.name))),
        };
        self.text.flush(py)?;
        warned.iter().try_for_each(|w| outputs::warn(py, w))?;
        result
    }

    /// Make the calls that another model was told, so that this one is like it.
    fn made_like(&self, py: Python<'_>, other: &Self) -> PyResult<()> {
        let (log, state) = {
            let mut other = other.hold()?;
            if let Some(reason) = other.owned.log.lost() {
                return Err(OpenSeesError::new_err(format!("copy: the model cannot be made again: {reason}")));
            }
            (other.owned.log.anew(), other.session().engine.state().clone())
        };
        let mut inner = self.hold()?;
        inner.owned.run().interp.interrupt.store(false, Ordering::Relaxed);
        inner.owned.log = log;
        let owned = &mut inner.owned;
        py.detach(|| owned.make_again());
        let made = owned.take_made_again();
        owned.run().interp.core.clear_warnings();
        // The model that was told has given the messages.
        hold(&self.warned).clear();
        self.text.take();
        match made {
            Ok(()) if *inner.session().engine.state() == state => Ok(()),
            Ok(()) => Err(OpenSeesError::new_err(
                "copy: the calls of the model, made again, lead to another state: has a file that they read changed?",
            )),
            Err((_, Exception::Interrupted)) => Err(self.interruption()),
            Err((command, e)) => {
                let why = match &e {
                    Exception::Error(e) => e.diagnostic.message.as_str(),
                    _ => "it ends early",
                };
                Err(OpenSeesError::new_err(format!("copy: {command}, called again, is not accepted: {why}")))
            }
        }
    }

    fn interruption(&self) -> PyErr {
        let raised = hold(&self.raised).take();
        raised.unwrap_or_else(|| PyRuntimeError::new_err("the analysis was interrupted"))
    }
}

#[pymethods]
impl Domain {
    #[new]
    #[pyo3(signature = (*, strict = false, compat = false, ladder = false, **_more))]
    fn new(strict: bool, compat: bool, ladder: bool, _more: Option<&Bound<'_, pyo3::types::PyDict>>) -> Self {
        let options = Options {
            compat,
            ladder: ladder.then(RecoveryStrategy::default),
            threads: Threads::of_machine(),
            ..Options::default()
        };
        let (text, files) = (Text::default(), Files::at_once());
        let settings = Settings { mode: Mode::Run, strict, options };
        let mut run = Run::for_calls(settings, Box::new(text.clone()), Box::new(OsFiles), Box::new(files.clone()));
        let (warned, raised): (Shared<Vec<Diagnostic>>, Shared<Option<PyErr>>) = Default::default();
        let into = warned.clone();
        run.interp.host.on_warning(Box::new(move |d, _| hold(&into).push(d.clone())));
        let interrupt = run.interp.interrupt.clone();
        let told = Shared::default();
        let signals = Signals::new(raised.clone(), interrupt, Arc::clone(&told));
        run.interp.host.set_progress(Box::new(signals));
        let inner = Inner { owned: Owned::new(run), reactions: None, recorded: 0 };
        Self { inner: Mutex::new(inner), text, files, warned, raised, told }
    }

    /// Call a command of OpenSees by its name.
    #[pyo3(signature = (name, *args))]
    pub(crate) fn _call(&self, py: Python<'_>, name: &str, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.enter(py, Entry::of(name)?, args)
    }

    /// Keep in memory what a recorder of these words would write; the number of the recorder.
    #[pyo3(signature = (kind, *args))]
    fn _record(&self, py: Python<'_>, kind: &str, args: &Bound<'_, PyTuple>) -> PyResult<(i64, String)> {
        let name = {
            let mut inner = self.hold()?;
            inner.recorded += 1;
            format!("{MEMORY}{}", inner.recorded)
        };
        let recorder = Entry::of("recorder")?;
        let mut all = words(recorder, args)?;
        all.splice(1..1, [Value::from(kind), Value::from("-file"), Value::from(name.as_str()), Value::from("-time")]);
        let tag = self.command(py, recorder, all)?;
        Ok((tag.extract(py)?, name))
    }

    /// Rows of a recorder in memory, which is removed: the times, then the columns.
    fn _recorded<'py>(&self, py: Python<'py>, tag: i64, name: &str) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.command(py, Entry::of("remove")?, vec![Value::EMPTY, Value::from("recorder"), Value::from(tag)])?;
        let rows = self.files.take(name);
        PyArray2::from_vec2(py, &rows).map_err(|e| PyRuntimeError::new_err(e.to_string()))
    }

    /// Tell a function of the steps of analyses: it takes the number of steps since its last call. None ends it.
    fn _tell_steps(&self, function: Option<Py<PyAny>>) {
        // The one before is let go without the lock: its end may be a call of Python's.
        let _before = std::mem::replace(&mut *hold(&self.told), function);
    }

    /// Make the calls that another model was told.
    fn _make_like(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<()> {
        self.made_like(py, other.get())
    }

    /// Keep the motion from here on for a page.
    fn _watch(&self) -> PyResult<()> {
        self.hold()?.owned.watch();
        Ok(())
    }

    /// A page that shows the motion; `None` without nodes.
    fn _page(&self, title: &str, force: &str, length: &str, modes: usize) -> PyResult<Option<String>> {
        let units = Units { force: force.into(), length: length.into() };
        Ok(self.hold()?.owned.page(title, &units, modes))
    }

    /// Finish the recorders: their files are complete.
    fn _finish(&self) -> PyResult<()> {
        self.hold()?.session().finish().map_err(|e| OpenSeesError::new_err(e.to_string()))
    }
}
