//! Words of a command from Python's arguments: numbers stay numbers, and sequences are flattened.

use crate::errors::OpenSeesError;
use crate::methods::Entry;
use hysteron_tcl::Value;
use numpy::{PyArrayDyn, PyArrayMethods as _, PyUntypedArray};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyList, PyString, PyTuple};

/// Depth of sequences within sequences.
const MAX_DEPTH: usize = 16;

/// The words of a call: a place for the name of the command, and its arguments.
pub(crate) fn words(entry: &Entry, args: &Bound<'_, PyTuple>) -> PyResult<Vec<Value>> {
    let name = entry.command.name;
    let mut words = Vec::with_capacity(args.len() + 1);
    words.push(Value::EMPTY);
    for (i, arg) in args.iter_borrowed().enumerate() {
        push(&mut words, &arg, 0).map_err(|e| match e {
            Refused::Python(e) => e,
            Refused::Kind(kind) => OpenSeesError::new_err(format!(
                "{name}: argument {} is {kind}\n  expected a number, a text, or a sequence of them",
                i + 1
            )),
        })?;
    }
    if entry.is_block {
        gather_block(&mut words, if name == "block3D" { 3 } else { 2 });
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
    // Most words are plain numbers, whose types need no call of Python.
    if let Ok(x) = arg.cast_exact::<PyFloat>() {
        words.push(Value::from(x.value()));
    } else if arg.is_exact_instance_of::<PyInt>() {
        words.push(integer(arg)?);
    } else if let Ok(text) = arg.cast::<PyString>() {
        // As openseespy takes them: `'-dof '` is an option.
        words.push(Value::from(text.to_cow()?.trim_matches(|c: char| c.is_ascii_whitespace())));
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
    } else if let Ok(array) = arg.cast::<PyArrayDyn<f64>>()
        && array.data().is_aligned()
    {
        let view = array.try_readonly().map_err(|e| Refused::Kind(e.to_string()))?;
        words.extend(view.as_array().iter().map(|x| Value::from(*x)));
    } else if arg.cast::<PyUntypedArray>().is_ok() {
        push(words, &arg.call_method0("tolist")?, depth + 1)?;
    } else if let Some(index) = special(arg, "__index__")? {
        words.push(integer(&index)?);
    } else if let Some(x) = special(arg, "__float__")? {
        words.push(Value::from(x.extract::<f64>()?));
    } else if let Some(path) = special(arg, "__fspath__")? {
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

/// The answer of a special method; `None` where the type has none. An exception that the method raises is the caller's.
fn special<'py>(arg: &Bound<'py, PyAny>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
    // As Python itself looks for it: in the type.
    if arg.get_type().hasattr(name)? { arg.call_method0(name).map(Some) } else { Ok(None) }
}

fn integer(arg: &Bound<'_, PyAny>) -> Result<Value, Refused> {
    match arg.extract::<i64>() {
        Ok(i) => Ok(Value::from(i)),
        Err(_) => Err(Refused::Kind(format!("the integer {}, which needs more than 64 bits", arg.str()?))),
    }
}

/// Gather the words of `block2D` and `block3D` into the two lists that the commands take: arguments of the elements, and
/// numbers of points with their coordinates.
fn gather_block(words: &mut Vec<Value>, divisions: usize) {
    // Name, divisions, first node, first element, kind of element.
    let corners = 1 << divisions;
    let head = divisions + 4;
    if words.len() <= head {
        return;
    }
    let starts = (head..words.len()).find(|&at| [4, 3].iter().any(|&width| are_points(&words[at..], width, corners)));
    let Some(at) = starts else { return };
    let points = Value::list(words.drain(at..).collect::<Vec<_>>());
    // Options of the command stay between the two lists.
    let option = words.iter().position(|w| w.as_str() == "-numEleNodes");
    let options: Vec<Value> = option.map(|at| words.drain(at..).collect()).unwrap_or_default();
    let arguments = Value::list(words.drain(head..).collect::<Vec<_>>());
    words.push(arguments);
    words.extend(options);
    words.push(points);
}

/// Returns true if the words are rows of a number, rising from 1, and coordinates: at least one for each corner.
fn are_points(words: &[Value], width: usize, corners: usize) -> bool {
    let first = |row: &[Value]| row[0].to_f64().ok();
    words.len() % width == 0
        && words.len() / width >= corners
        && words.chunks(width).enumerate().all(|(i, row)| {
            if i < corners {
                first(row) == Some(i as f64 + 1.0)
            } else {
                first(row).is_some_and(|n| n > corners as f64)
            }
        })
}

#[cfg(test)]
mod tests {
    use super::gather_block;
    use hysteron_tcl::Value;

    #[test]
    fn blocks_have_two_lists() {
        let text = "block2D 8 2 1 1 quad 1.0 PlaneStrain 1 1 0 0 2 4 0 3 4 3 4 0 3";
        let mut words: Vec<Value> = text.split(' ').map(Value::from).collect();
        gather_block(&mut words, 2);
        assert_eq!(words.len(), 8);
        assert_eq!(words[6].as_str(), "1.0 PlaneStrain 1");
        assert_eq!(words[7].as_str(), "1 0 0 2 4 0 3 4 3 4 0 3");
    }
}
