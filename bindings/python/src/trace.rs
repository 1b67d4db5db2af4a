//! Calls that a function of Python makes in place of the model: the recorder of a model as a script.

use crate::domain::Domain;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, ThreadId};

/// The function that takes the calls, and the thread whose calls it takes.
static HOOK: Mutex<Option<(ThreadId, Py<PyAny>)>> = Mutex::new(None);
/// Calls look here first: most programs record nothing.
static IS_SET: AtomicBool = AtomicBool::new(false);

/// Let a function take the calls that this thread makes of models: `hook(model, name, args)`; None ends it.
#[pyfunction]
#[pyo3(signature = (hook))]
pub(crate) fn record_calls(hook: Option<Py<PyAny>>) {
    IS_SET.store(hook.is_some(), Ordering::Relaxed);
    let new = hook.map(|h| (thread::current().id(), h));
    // The one before is let go without the lock: its end may be a call of Python's.
    let _before = std::mem::replace(&mut *HOOK.lock().unwrap_or_else(std::sync::PoisonError::into_inner), new);
}

/// Returns true if calls of a thread are recorded.
pub(crate) fn is_on() -> bool {
    IS_SET.load(Ordering::Relaxed)
}

/// The answer of the hook to a call; `None` where the model answers itself.
pub(crate) fn taken(
    model: &Bound<'_, Domain>,
    name: &str,
    args: impl FnOnce() -> PyResult<Py<PyTuple>>,
) -> Option<PyResult<Py<PyAny>>> {
    if !is_on() {
        return None;
    }
    let py = model.py();
    let hook = {
        let hook = HOOK.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        hook.as_ref().filter(|(thread, _)| *thread == thread::current().id()).map(|(_, h)| h.clone_ref(py))
    }?;
    Some(args().and_then(|args| hook.call1(py, (model, name, args))))
}
