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
    "sectionWeight",
    "testNorm",
    "testNorms",
];

/// Command whose answer is a list also where an element has no such response.
const LISTED_NOTHING: &str = "eleResponse";

/// Commands whose one number openseespy gives as a list.
const LISTED_NUMBERS: &[&str] = &["getNDF", "getNDM", "getNumElements", "sensSectionForce"];

/// Commands that answer nothing in openseespy.
const SILENT: &[&str] = &["computeGradients", "responseSpectrumAnalysis"];

/// Kind of the answer of a command in Python.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Answer {
    /// The answer as in Tcl; `None` where it is empty.
    Plain,
    /// A list, even where it is empty.
    List,
    /// The same, and where the element asked has no such response.
    ListOrNothing,
    /// A list, even of one number.
    ListedNumber,
    /// Nothing.
    Silent,
    /// A dictionary of lists.
    Table,
    /// Tags, which come as responses: doubles.
    Tags,
}

impl Answer {
    /// Of a command by its name.
    pub(crate) fn of(command: &str) -> Self {
        match command {
            "modalProperties" => Self::Table,
            "sectionTag" => Self::Tags,
            LISTED_NOTHING => Self::ListOrNothing,
            _ if LISTED_NUMBERS.contains(&command) => Self::ListedNumber,
            _ if SILENT.contains(&command) => Self::Silent,
            _ if LISTS.contains(&command) => Self::List,
            _ => Self::Plain,
        }
    }

    /// The answer of openseespy where an element does not have what is asked.
    pub(crate) fn nothing(self, py: Python<'_>) -> Py<PyAny> {
        if self == Self::ListOrNothing { PyList::empty(py).into_any().unbind() } else { py.None() }
    }

    /// The answer as an object of Python.
    pub(crate) fn object(self, py: Python<'_>, value: &Value) -> PyResult<Py<PyAny>> {
        match (value.form(), self) {
            (Form::Empty, Self::List | Self::ListOrNothing | Self::Tags) => Ok(PyList::empty(py).into_any().unbind()),
            (Form::Empty, _) | (_, Self::Silent) => Ok(py.None()),
            (Form::List(pairs), Self::Table) => {
                let dict = PyDict::new(py);
                for pair in pairs.chunks_exact(2) {
                    dict.set_item(pair[0].as_str(), list(py, &pair[1])?)?;
                }
                Ok(dict.into_any().unbind())
            }
            (Form::Double(tag), Self::Tags) => Ok((tag as i64).into_pyobject(py)?.into_any().unbind()),
            (Form::List(tags), Self::Tags) => {
                let tags = tags.iter().map(|t| t.to_f64().unwrap_or_default() as i64);
                Ok(PyList::new(py, tags.collect::<Vec<_>>())?.into_any().unbind())
            }
            (Form::Int(_) | Form::Double(_), Self::ListedNumber) => list(py, value),
            _ => object(py, value),
        }
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
