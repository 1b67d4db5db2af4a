//! Exceptions, with the place of what is wrong.

use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyUserWarning};
use pyo3::prelude::*;

create_exception!(
    hysteron,
    OpenSeesError,
    PyException,
    "A command is rejected: the text says what is wrong. `file`, `line` and `column` are its place from 1, in the script or in \
     Python's program, and `hint` what may help; each is None where there is none."
);
create_exception!(
    hysteron,
    OpenSeesWarning,
    PyUserWarning,
    "A command goes on, but the result may not be what was meant."
);

/// Attributes of an error.
const ATTRIBUTES: [&str; 4] = ["file", "line", "column", "hint"];

/// Give the attributes to all errors, without values.
pub(crate) fn declare(py: Python<'_>) -> PyResult<()> {
    ATTRIBUTES.iter().try_for_each(|name| py.get_type::<OpenSeesError>().setattr(*name, py.None()))
}

/// Place of what is wrong, and what may help.
#[derive(Clone, Debug, Default)]
pub(crate) struct Place {
    file: Option<String>,
    line: Option<usize>,
    column: Option<usize>,
    hint: Option<String>,
}

impl Place {
    /// Of a diagnostic about a file.
    pub(crate) fn in_file(d: &Diagnostic, sources: &SourceMap) -> Self {
        let at = d.span.map(|s| sources.location(s));
        Self {
            file: at.as_ref().map(|l| l.name.to_string()),
            line: at.as_ref().map(|l| l.line),
            column: at.as_ref().map(|l| l.column),
            hint: hint(d),
        }
    }

    /// Of a diagnostic about a call: the line of Python's program outside of this package.
    pub(crate) fn of_call(py: Python<'_>, d: &Diagnostic) -> Self {
        let (file, line) = caller(py).map(|(file, line, _)| (file, line)).ok().unzip();
        Self { file, line, column: None, hint: hint(d) }
    }

    /// An error with this place.
    pub(crate) fn error(self, py: Python<'_>, text: String) -> PyErr {
        let error = OpenSeesError::new_err(text);
        let value = error.value(py);
        // Attributes of an exception can always be set.
        let _ = value.setattr("file", self.file);
        let _ = value.setattr("line", self.line);
        let _ = value.setattr("column", self.column);
        let _ = value.setattr("hint", self.hint);
        error
    }
}

/// File and line of the first frame outside of this package, and its depth from 1.
pub(crate) fn caller(py: Python<'_>) -> PyResult<(String, usize, usize)> {
    let package = py.import("hysteron")?.getattr("__path__")?.get_item(0)?.extract::<String>()?;
    let mut frame = py.import("sys")?.call_method0("_getframe")?;
    let mut depth = 1;
    loop {
        let file: String = frame.getattr("f_code")?.getattr("co_filename")?.extract()?;
        if !std::path::Path::new(&file).starts_with(&package) {
            return Ok((file, frame.getattr("f_lineno")?.extract()?, depth));
        }
        (frame, depth) = (frame.getattr("f_back")?, depth + 1);
    }
}

/// Label and help of a diagnostic, without the usage.
fn hint(d: &Diagnostic) -> Option<String> {
    let help = d.help.iter().map(String::as_str).filter(|h| !h.starts_with("usage: "));
    let lines: Vec<&str> = std::iter::once(d.label.as_str()).chain(help).filter(|l| !l.is_empty()).collect();
    (!lines.is_empty()).then(|| lines.join("\n"))
}
