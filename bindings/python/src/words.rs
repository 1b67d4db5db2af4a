//! Words of a command from Python's arguments: numbers stay numbers, and sequences are flattened.

use crate::errors::OpenSeesError;
use hysteron_tcl::Value;
use numpy::{PyArrayDyn, PyArrayMethods as _, PyUntypedArray};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyList, PyString, PyTuple};

/// Depth of sequences within sequences.
const MAX_DEPTH: usize = 16;

/// The words of a call: the name of the command and its arguments.
pub(crate) fn words(name: &str, args: &Bound<'_, PyTuple>) -> PyResult<Vec<Value>> {
    let mut words = Vec::with_capacity(args.len() + 1);
    words.push(Value::from(name));
    for (i, arg) in args.iter().enumerate() {
        push(&mut words, &arg, 0).map_err(|e| match e {
            Refused::Python(e) => e,
            Refused::Kind(kind) => OpenSeesError::new_err(format!(
                "{name}: argument {} is {kind}\n  expected a number, a text, or a sequence of them",
                i + 1
            )),
        })?;
    }
    Ok(words)
}

enum Refused {
    Python(PyErr),
    /// Description of something that is no word.
    Kind(String),
}

impl From<PyErr> for Refused {
    fn from(e: PyErr) -> Self {
        Self::Python(e)
    }
}

fn push(words: &mut Vec<Value>, arg: &Bound<'_, PyAny>, depth: usize) -> Result<(), Refused> {
    if let Ok(text) = arg.cast::<PyString>() {
        words.push(Value::from(text.to_cow()?.as_ref()));
    } else if let Ok(x) = arg.cast::<PyFloat>() {
        words.push(Value::from(x.value()));
    } else if arg.is_instance_of::<PyInt>() {
        words.push(integer(arg)?);
    } else if depth > MAX_DEPTH {
        return Err(Refused::Kind(format!("nested more than {MAX_DEPTH} deep")));
    } else if let Ok(list) = arg.cast::<PyList>() {
        list.iter().try_for_each(|item| push(words, &item, depth + 1))?;
    } else if let Ok(tuple) = arg.cast::<PyTuple>() {
        tuple.iter().try_for_each(|item| push(words, &item, depth + 1))?;
    } else if let Ok(array) = arg.cast::<PyArrayDyn<f64>>() {
        let view = array.try_readonly().map_err(|e| Refused::Kind(e.to_string()))?;
        words.extend(view.as_array().iter().map(|x| Value::from(*x)));
    } else if arg.cast::<PyUntypedArray>().is_ok() {
        push(words, &arg.call_method0("tolist")?, depth + 1)?;
    } else if let Ok(index) = arg.call_method0("__index__") {
        words.push(integer(&index)?);
    } else if let Ok(x) = arg.call_method0("__float__") {
        words.push(Value::from(x.extract::<f64>()?));
    } else if let Ok(path) = arg.call_method0("__fspath__") {
        words.push(Value::from(path.extract::<String>()?));
    } else if !arg.is_instance_of::<pyo3::types::PyDict>()
        && !arg.is_instance_of::<pyo3::types::PyBytes>()
        && let Ok(items) = arg.try_iter()
    {
        for item in items {
            push(words, &item?, depth + 1)?;
        }
    } else {
        let kind = if arg.is_none() { "None".to_owned() } else { format!("a {}", arg.get_type().name()?) };
        return Err(Refused::Kind(kind));
    }
    Ok(())
}

fn integer(arg: &Bound<'_, PyAny>) -> Result<Value, Refused> {
    match arg.extract::<i64>() {
        Ok(i) => Ok(Value::from(i)),
        Err(_) => Err(Refused::Kind(format!("the integer {}, which needs more than 64 bits", arg.str()?))),
    }
}
