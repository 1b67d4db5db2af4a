//! hysteron for Python: the extension module behind the package `hysteron`.

mod answers;
mod batch;
mod domain;
mod errors;
mod learned;
mod log;
mod many;
mod messages;
mod methods;
mod outputs;
mod owned;
mod queries;
mod recording;
mod script;
mod study;
mod trace;
mod words;

use pyo3::prelude::*;

/// Memory of analyses comes in small pieces; that of Python's own objects is not touched.
#[cfg(not(target_env = "musl"))]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

#[pymodule]
fn _hysteron(m: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = m.py();
    errors::declare(py)?;
    m.add("OpenSeesError", py.get_type::<errors::OpenSeesError>())?;
    m.add("OpenSeesWarning", py.get_type::<errors::OpenSeesWarning>())?;
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add_class::<domain::Domain>()?;
    m.add_class::<methods::Method>()?;
    m.add_class::<methods::BoundMethod>()?;
    m.add_class::<script::ScriptResult>()?;
    m.add_class::<learned::LearnedLaw>()?;
    m.add_class::<study::Study>()?;
    m.add_class::<batch::Plan>()?;
    m.add_class::<script::Message>()?;
    m.add_class::<recording::MeasuredSeries>()?;
    m.add_function(wrap_pyfunction!(recording::read_recording, m)?)?;
    m.add_function(wrap_pyfunction!(script::run, m)?)?;
    m.add_function(wrap_pyfunction!(script::check, m)?)?;
    m.add_function(wrap_pyfunction!(messages::usages, m)?)?;
    m.add_function(wrap_pyfunction!(messages::script_usages, m)?)?;
    m.add_function(wrap_pyfunction!(messages::reference, m)?)?;
    m.add_function(wrap_pyfunction!(messages::usage_in_python, m)?)?;
    m.add_function(wrap_pyfunction!(methods::asks, m)?)?;
    m.add_function(wrap_pyfunction!(trace::record_calls, m)?)?;
    Ok(())
}
