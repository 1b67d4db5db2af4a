//! Exceptions.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyUserWarning};

create_exception!(hysteron, OpenSeesError, PyException, "A command is rejected: the text says what is wrong.");
create_exception!(
    hysteron,
    OpenSeesWarning,
    PyUserWarning,
    "A command goes on, but the result may not be what was meant."
);
