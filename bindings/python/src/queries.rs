//! Queries that loops make, without words: their arguments are numbers.

use crate::domain::{Domain, Inner};
use crate::errors::OpenSeesError;
use hysteron_engine::analysis::State;
use hysteron_engine::model::{ElementId, NodeId};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyList, PyString, PyTuple};

/// Values of a node: all of them, or the one of a degree of freedom. `None` where the words need a closer look.
fn pick(py: Python<'_>, values: &[f64], dof: Option<i32>) -> Option<PyResult<Py<PyAny>>> {
    match dof {
        None => Some(PyList::new(py, values).map(|l| l.into_any().unbind())),
        Some(dof) => {
            let x = values.get(usize::try_from(dof).ok()?.checked_sub(1)?)?;
            Some(Ok(PyFloat::new(py, *x).into_any().unbind()))
        }
    }
}

/// One or two whole numbers.
fn numbers(args: &Bound<'_, PyTuple>) -> Option<(i32, Option<i32>)> {
    let number = |i| args.get_borrowed_item(i).ok()?.extract::<i32>().ok();
    match args.len() {
        1 => Some((number(0)?, None)),
        2 => Some((number(0)?, Some(number(1)?))),
        _ => None,
    }
}

impl Domain {
    fn node_field(
        &self,
        py: Python<'_>,
        name: &str,
        args: &Bound<'_, PyTuple>,
        field: fn(&State) -> &[f64],
    ) -> PyResult<Py<PyAny>> {
        self.of_node(py, name, args, |inner, node| {
            let session = inner.session();
            let dofs = session.node_dofs(node);
            Some(&field(session.engine.state())[dofs])
        })
    }

    /// Values of a node by the quick way, or else by the command.
    fn of_node(
        &self,
        py: Python<'_>,
        name: &str,
        args: &Bound<'_, PyTuple>,
        values: impl for<'a> FnOnce(&'a mut Inner, NodeId) -> Option<&'a [f64]>,
    ) -> PyResult<Py<PyAny>> {
        if let Some((tag, dof)) = numbers(args) {
            let mut inner = self.hold()?;
            if let Some(node) = inner.session().engine.model().node(tag)
                && let Some(found) = values(&mut inner, node).and_then(|v| pick(py, v, dof))
            {
                return found;
            }
        }
        self._call(py, name, args)
    }

    fn element(&self, inner: &mut Inner, tag: i32) -> Option<ElementId> {
        inner.session().engine.model().element(tag)
    }

    /// A response with a command of its own.
    fn named(&self, py: Python<'_>, name: &str, args: &Bound<'_, PyTuple>, response: &str) -> PyResult<Py<PyAny>> {
        if let Some((tag, column)) = numbers(args) {
            let mut inner = self.hold()?;
            if let Some(element) = self.element(&mut inner, tag)
                && let Some(values) = inner.session().element_response(element, &[response])
                && let Some(found) = pick(py, &values, column)
            {
                return found;
            }
        }
        self._call(py, name, args)
    }
}

#[pymethods]
impl Domain {
    /// Displacements of a node: `nodeDisp(node)`, or one of them: `nodeDisp(node, dof)`.
    #[pyo3(name = "nodeDisp", signature = (*args))]
    fn node_disp(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.node_field(py, "nodeDisp", args, |s| &s.disp)
    }

    /// Velocities of a node: `nodeVel(node)`, or one of them: `nodeVel(node, dof)`.
    #[pyo3(name = "nodeVel", signature = (*args))]
    fn node_vel(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.node_field(py, "nodeVel", args, |s| &s.vel)
    }

    /// Accelerations of a node: `nodeAccel(node)`, or one of them: `nodeAccel(node, dof)`.
    #[pyo3(name = "nodeAccel", signature = (*args))]
    fn node_accel(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.node_field(py, "nodeAccel", args, |s| &s.accel)
    }

    /// Reactions at a node: `nodeReaction(node)`, or one of them: `nodeReaction(node, dof)`.
    #[pyo3(name = "nodeReaction", signature = (*args))]
    fn node_reaction(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.of_node(py, "nodeReaction", args, |inner, node| {
            if inner.reactions.is_none() {
                inner.reactions = inner.session().reactions().ok();
            }
            let dofs = inner.session().node_dofs(node);
            inner.reactions.as_ref()?.get(dofs)
        })
    }

    /// Time of the committed state, or the load factor of a static analysis.
    #[pyo3(name = "getTime")]
    fn get_time(&self) -> PyResult<f64> {
        Ok(self.hold()?.session().engine.state().time)
    }

    /// Global force of an element: `eleForce(element)`, or one of its values: `eleForce(element, number)`.
    #[pyo3(name = "eleForce", signature = (*args))]
    fn ele_force(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.named(py, "eleForce", args, "force")
    }

    /// Basic force of an element: `basicForce(element)`, or one of its values: `basicForce(element, number)`.
    #[pyo3(name = "basicForce", signature = (*args))]
    fn basic_force(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        self.named(py, "basicForce", args, "basicForce")
    }

    /// A response of an element by its name: `eleResponse(element, 'force')`; empty if it has none of that name.
    #[pyo3(name = "eleResponse", signature = (*args))]
    fn ele_response(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        let word = |i: usize| -> Option<String> {
            let item = args.get_borrowed_item(i).ok()?;
            match item.cast::<PyString>() {
                Ok(text) => Some(text.to_cow().ok()?.trim().to_owned()),
                Err(_) => Some(item.extract::<i64>().ok()?.to_string()),
            }
        };
        if args.len() >= 2
            && let Some(tag) = args.get_borrowed_item(0).ok().and_then(|t| t.extract::<i32>().ok())
            && let Some(words) = (1..args.len()).map(word).collect::<Option<Vec<String>>>()
        {
            let mut inner = self.hold()?;
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            if let Some(element) = self.element(&mut inner, tag) {
                match inner.session().element_response(element, &words) {
                    Some(values) => return Ok(PyList::new(py, values)?.into_any().unbind()),
                    None => drop(inner),
                }
                // OpenSees has no message here, and programs that show models ask for what may not be there.
                return match self._call(py, "eleResponse", args) {
                    Err(e) if e.is_instance_of::<OpenSeesError>(py) => {
                        crate::outputs::warn(py, &e.value(py).to_string(), 1)?;
                        Ok(PyList::empty(py).into_any().unbind())
                    }
                    other => other,
                };
            }
        }
        self._call(py, "eleResponse", args)
    }
}
