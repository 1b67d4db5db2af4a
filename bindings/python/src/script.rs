//! `run` and `check` of scripts in Tcl.

use crate::outputs::{Files, Shared, Signals, Text, hold};
use hysteron_engine::analysis::{Options, RecoveryStrategy};
use hysteron_engine::record::{Memory, Output, RecordError};
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{FileFormat, Mode, Outputs};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron_tcl::{OsFiles, OverlayFiles};
use pyo3::prelude::*;
use std::path::Path;

/// A message about a script, with its place.
#[pyclass(frozen, get_all, module = "hysteron._hysteron")]
#[derive(Clone)]
pub(crate) struct Message {
    /// `error`, `warning` or `note`.
    severity: &'static str,
    /// Description in one sentence.
    text: String,
    /// Name of the file, if the message is about one.
    file: Option<String>,
    /// Line from 1.
    line: Option<usize>,
    /// Column in characters from 1.
    column: Option<usize>,
    /// Words that were expected.
    expected: String,
    /// Hints, such as the nearest known name.
    help: Vec<String>,
}

#[pymethods]
impl Message {
    fn __repr__(&self) -> String {
        format!("<{self}>")
    }

    fn __str__(&self) -> String {
        self.to_string()
    }
}

impl std::fmt::Display for Message {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let (Some(file), Some(line), Some(column)) = (&self.file, self.line, self.column) {
            write!(f, "{file}:{line}:{column}: ")?;
        }
        write!(f, "{}: {}", self.severity, self.text)?;
        if !self.expected.is_empty() {
            write!(f, " ({})", self.expected)?;
        }
        self.help.iter().try_for_each(|h| write!(f, "\n  {h}"))
    }
}

impl Message {
    fn new(d: &Diagnostic, sources: &SourceMap) -> Self {
        let place = d.span.map(|s| sources.location(s));
        Self {
            severity: match d.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "note",
            },
            text: d.message.clone(),
            file: place.as_ref().map(|p| p.name.to_string()),
            line: place.as_ref().map(|p| p.line),
            column: place.as_ref().map(|p| p.column),
            expected: d.label.clone(),
            help: d.help.clone(),
        }
    }
}

/// Outcome of a script.
#[pyclass(frozen, get_all, module = "hysteron._hysteron")]
pub(crate) struct ScriptResult {
    /// Exit status: 0 done, 1 the analysis failed, 2 the input is wrong.
    status: i32,
    /// Text that the script has put out.
    out: String,
    /// Text for the error stream.
    err: String,
    /// Messages in their order.
    messages: Vec<Message>,
}

#[pymethods]
impl ScriptResult {
    fn __bool__(&self) -> bool {
        self.status == 0
    }

    fn __repr__(&self) -> String {
        format!("<ScriptResult status={} messages={}>", self.status, self.messages.len())
    }
}

/// Recorders that keep no file.
struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

/// Run a script in Tcl from a file; `args` become `$argv`.
#[pyfunction]
#[pyo3(signature = (script, args = vec![], *, strict = false, compat = false, ladder = false))]
pub(crate) fn run(
    py: Python<'_>,
    script: std::path::PathBuf,
    args: Vec<Bound<'_, PyAny>>,
    strict: bool,
    compat: bool,
    ladder: bool,
) -> PyResult<ScriptResult> {
    let args = args.iter().map(|a| Ok(a.str()?.to_string())).collect::<PyResult<Vec<_>>>()?;
    execute(py, &script, &args, Mode::Run, strict, compat, ladder)
}

/// Check a script in Tcl: each mistake is a message, and no analysis is run.
#[pyfunction]
#[pyo3(signature = (script, args = vec![], *, strict = false, compat = false))]
pub(crate) fn check(
    py: Python<'_>,
    script: std::path::PathBuf,
    args: Vec<Bound<'_, PyAny>>,
    strict: bool,
    compat: bool,
) -> PyResult<ScriptResult> {
    let args = args.iter().map(|a| Ok(a.str()?.to_string())).collect::<PyResult<Vec<_>>>()?;
    execute(py, &script, &args, Mode::Check, strict, compat, false)
}

fn execute(
    py: Python<'_>,
    script: &Path,
    args: &[String],
    mode: Mode,
    strict: bool,
    compat: bool,
    ladder: bool,
) -> PyResult<ScriptResult> {
    let raised: Shared<Option<PyErr>> = Shared::default();
    let ladder = ladder.then(RecoveryStrategy::default);
    let options = Options { compat, ladder, dense: None, ..Options::default() };
    let result = py.detach(|| {
        let text = Text::default();
        let settings = Settings { mode, strict, options };
        let console = Box::new(text.clone());
        let mut run = match mode {
            Mode::Run => Run::new(settings, console, Box::new(OsFiles), Box::new(Files::default())),
            Mode::Check => {
                Run::new(settings, console, Box::new(OverlayFiles::new(Box::new(OsFiles))), Box::new(NoFiles))
            }
        };
        let interrupt = run.interp.interrupt.clone();
        let signals = Signals::new(raised.clone(), interrupt, Shared::default());
        run.interp.host.set_progress(Box::new(signals));
        let end = run.script(&script.to_string_lossy(), args);
        let sources = &run.interp.core.sources;
        let mut messages: Vec<Message> = run.interp.core.warnings.iter().map(|d| Message::new(d, sources)).collect();
        if let End::Rejected(d) | End::Raised(d) = &end {
            messages.push(Message::new(d, sources));
        }
        let is_wrong = mode == Mode::Check && messages.iter().any(|m| m.severity == "error");
        let (out, err) = text.take();
        ScriptResult { status: if is_wrong { 2 } else { end.status() }, out, err, messages }
    });
    match hold(&raised).take() {
        Some(e) => Err(e),
        None => Ok(result),
    }
}
