//! Python's objects for the answers of commands.

use hysteron_tcl::{Form, Value};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Commands whose answer is a list, even where it is empty.
const LISTS: &[&str] = &[
    "basicDeformation",
    "basicForce",
    "basicStiffness",
    "eigen",
    "eleForce",
    "eleNodes",
    "eleResponse",
    "getConstrainedDOFs",
    "getConstrainedNodes",
    "getCrdTransfTags",
    "getEleClassTags",
    "getEleLoadClassTags",
    "getEleLoadData",
    "getEleLoadTags",
    "getEleTags",
    "getFixedDOFs",
    "getFixedNodes",
    "getNodeLoadData",
    "getNodeLoadTags",
    "getNodeTags",
    "getParamTags",
    "getPatterns",
    "getRetainedDOFs",
    "getRetainedNodes",
    "localForce",
    "nodeDOFs",
    "sectionDeformation",
    "sectionFlexibility",
    "sectionForce",
    "sectionLocation",
    "sectionStiffness",
    "sectionTag",
    "sectionWeight",
    "testNorm",
    "testNorms",
];

/// Commands whose whole number openseespy gives as a list.
const LISTED_NUMBERS: &[&str] = &["getNDF", "getNDM", "getNumElements"];

/// Commands that answer nothing in openseespy.
const SILENT: &[&str] = &["responseSpectrumAnalysis"];

/// The answer of a command as an object of Python.
pub(crate) fn answer(py: Python<'_>, command: &str, value: &Value) -> PyResult<Py<PyAny>> {
    match value.form() {
        Form::Empty if LISTS.contains(&command) => Ok(PyList::empty(py).into_any().unbind()),
        Form::Empty => Ok(py.None()),
        _ if SILENT.contains(&command) => Ok(py.None()),
        Form::List(pairs) if command == "modalProperties" => {
            let dict = PyDict::new(py);
            for pair in pairs.chunks_exact(2) {
                dict.set_item(pair[0].as_str(), list(py, &pair[1])?)?;
            }
            Ok(dict.into_any().unbind())
        }
        // Tags of sections come as responses, which are doubles.
        Form::Double(tag) if command == "sectionTag" => Ok((tag as i64).into_pyobject(py)?.into_any().unbind()),
        Form::List(tags) if command == "sectionTag" => {
            let tags = tags.iter().map(|t| t.to_f64().unwrap_or_default() as i64);
            Ok(PyList::new(py, tags.collect::<Vec<_>>())?.into_any().unbind())
        }
        Form::Int(_) if LISTED_NUMBERS.contains(&command) => list(py, value),
        _ => object(py, value),
    }
}

fn list(py: Python<'_>, value: &Value) -> PyResult<Py<PyAny>> {
    match value.form() {
        Form::List(_) => object(py, value),
        Form::Empty => Ok(PyList::empty(py).into_any().unbind()),
        _ => Ok(PyList::new(py, [object(py, value)?])?.into_any().unbind()),
    }
}

fn object(py: Python<'_>, value: &Value) -> PyResult<Py<PyAny>> {
    Ok(match value.form() {
        Form::Empty => "".into_pyobject(py)?.into_any().unbind(),
        Form::Int(i) => i.into_pyobject(py)?.into_any().unbind(),
        Form::Double(d) => d.into_pyobject(py)?.into_any().unbind(),
        Form::Text(text) => text.into_pyobject(py)?.into_any().unbind(),
        Form::List(items) | Form::Dict(items) => {
            let items = items.iter().map(|v| object(py, v)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, items)?.into_any().unbind()
        }
    })
}
