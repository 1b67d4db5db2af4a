//! Commands as methods of a model: each name is looked up once.

use crate::answers::Answer;
use crate::domain::Domain;
use crate::errors::OpenSeesError;
use crate::trace;
use hysteron_opensees::effect::{Effect, effect};
use hysteron_opensees::{Command, calls, commands};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use pyo3::{PyTraverseError, PyVisit};
use std::collections::HashMap;
use std::sync::OnceLock;

/// Commands that may take long: Python's other threads go on meanwhile.
const LONG: &[&str] = &["analyze", "eigen", "modalProperties"];

/// A command with what its calls from Python need to know.
pub(crate) struct Entry {
    /// The command.
    pub(crate) command: &'static Command,
    /// Its place among all commands.
    pub(crate) index: usize,
    /// It may take long.
    pub(crate) is_long: bool,
    /// It only asks: what queries give is as before.
    pub(crate) asks: bool,
    /// Its last words are gathered into lists.
    pub(crate) is_block: bool,
    /// Python's object for its answer.
    pub(crate) answer: Answer,
}

impl Entry {
    /// The command of a name.
    pub(crate) fn of(name: &str) -> PyResult<&'static Self> {
        static KNOWN: OnceLock<HashMap<&'static str, Entry>> = OnceLock::new();
        let all = || {
            let known = commands().filter_map(|c| calls::command(c.name));
            known.enumerate().map(|(i, command)| (command.name, Self::new(command, i))).collect()
        };
        let known = KNOWN.get_or_init(all).get(name);
        known.ok_or_else(|| OpenSeesError::new_err(format!("unknown command \"{name}\"")))
    }

    fn new(command: &'static Command, index: usize) -> Self {
        let name = command.name;
        Self {
            command,
            index,
            is_long: LONG.contains(&name),
            asks: effect(command, None) == Effect::Asks,
            is_block: name.starts_with("block"),
            answer: Answer::of(name),
        }
    }
}

/// Returns true for a command that answers and leaves the model as it is.
#[pyfunction]
pub(crate) fn asks(name: &str) -> PyResult<bool> {
    Ok(Entry::of(name)?.asks)
}

// A command as an attribute of the class of models. Its text is that of the command alone.
#[allow(missing_docs)]
#[pyclass(frozen, module = "hysteron._hysteron")]
pub(crate) struct Method {
    entry: &'static Entry,
    doc: String,
}

#[pymethods]
impl Method {
    // Without a text: it would stand in the place of that of the command.
    #[new]
    #[pyo3(text_signature = None)]
    fn new(name: &str, doc: String) -> PyResult<Self> {
        Ok(Self { entry: Entry::of(name)?, doc })
    }

    fn __get__(slf: &Bound<'_, Self>, model: &Bound<'_, PyAny>, _class: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        if model.is_none() {
            return Ok(slf.clone().into_any().unbind());
        }
        let model = model.cast::<Domain>()?.clone().unbind();
        let method = slf.clone().unbind();
        let bound = BoundMethod { entry: slf.get().entry, model, method };
        Ok(Py::new(slf.py(), bound)?.into_any())
    }

    #[pyo3(signature = (model, *args, **keywords))]
    fn __call__(
        &self,
        model: &Bound<'_, Domain>,
        args: &Bound<'_, PyTuple>,
        keywords: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Py<PyAny>> {
        call(self.entry, model, args, keywords)
    }

    #[getter]
    fn __signature__(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        signature(py, self.entry, true)
    }

    #[getter]
    fn __name__(&self) -> &str {
        self.entry.command.name
    }

    #[getter]
    fn __qualname__(&self) -> String {
        format!("Model.{}", self.entry.command.name)
    }

    #[getter]
    fn __doc__(&self) -> &str {
        &self.doc
    }
}

/// Call a command, whose words may be given by their names in its usage.
fn call(
    entry: &'static Entry,
    model: &Bound<'_, Domain>,
    args: &Bound<'_, PyTuple>,
    keywords: Option<&Bound<'_, PyDict>>,
) -> PyResult<Py<PyAny>> {
    let py = model.py();
    let (name, mut placed) = (entry.command.name, None);
    if let Some(keywords) = keywords.filter(|k| !k.is_empty()) {
        let all = py.import("hysteron._keywords")?.call_method1("place", (name, args, keywords))?;
        placed = Some(all.cast_into::<PyTuple>()?);
    }
    let args = placed.as_ref().unwrap_or(args);
    match trace::taken(model, name, || Ok(args.clone().unbind())) {
        Some(answer) => answer,
        None => model.get().enter(py, entry, args),
    }
}

/// Signature by the usage of a command.
fn signature(py: Python<'_>, entry: &Entry, with_model: bool) -> PyResult<Py<PyAny>> {
    let made = py.import("hysteron._keywords")?.call_method1("signature", (entry.command.name, with_model))?;
    Ok(made.unbind())
}

// No text of its own: Python's help would take it for that of each command.
#[allow(missing_docs)]
#[pyclass(frozen, module = "hysteron._hysteron")]
pub(crate) struct BoundMethod {
    entry: &'static Entry,
    model: Py<Domain>,
    method: Py<Method>,
}

#[pymethods]
impl BoundMethod {
    #[pyo3(signature = (*args, **keywords))]
    fn __call__(
        &self,
        py: Python<'_>,
        args: &Bound<'_, PyTuple>,
        keywords: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Py<PyAny>> {
        call(self.entry, self.model.bind(py), args, keywords)
    }

    /// Python's help takes what has this for a routine.
    fn __get__(slf: &Bound<'_, Self>, _model: &Bound<'_, PyAny>, _class: &Bound<'_, PyAny>) -> Py<PyAny> {
        slf.clone().into_any().unbind()
    }

    #[getter]
    fn __signature__(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        signature(py, self.entry, false)
    }

    fn __repr__(&self) -> String {
        format!("<command {} of a model>", self.entry.command.name)
    }

    #[getter]
    fn __self__(&self, py: Python<'_>) -> Py<Domain> {
        self.model.clone_ref(py)
    }

    #[getter]
    fn __name__(&self) -> &str {
        self.entry.command.name
    }

    #[getter]
    fn __qualname__(&self) -> String {
        format!("Model.{}", self.entry.command.name)
    }

    #[getter]
    fn __doc__(&self) -> &str {
        &self.method.get().doc
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(&self.model)
    }
}
