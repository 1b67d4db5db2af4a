//! Queries of many nodes or elements in one call, whose answer is an array.

use crate::domain::{Domain, Inner};
use crate::errors::OpenSeesError;
use crate::methods::Entry;
use hysteron_engine::model::{ElementId, NodeId};
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

/// Tags that a query is about; without tags all that the model has.
pub(crate) struct Tags(Option<Vec<i32>>);

impl Tags {
    /// All that the model has.
    pub(crate) const ALL: Self = Self(None);

    /// Of a sequence of whole numbers; `None` for anything else.
    pub(crate) fn of(argument: &Bound<'_, PyAny>) -> Option<Self> {
        let is_sequence = !argument.is_instance_of::<PyString>() && argument.hasattr("__len__").ok()?;
        if is_sequence { argument.extract().ok().map(|tags| Self(Some(tags))) } else { None }
    }
}

/// Values by rows of one length.
struct Rows<'a> {
    name: &'static str,
    /// A value of each row by its number from 1; otherwise all.
    number: Option<i32>,
    values: Vec<f64>,
    /// Values of a row, with the first tag that has so many.
    width: Option<(usize, i32)>,
    tags: &'a [i32],
}

impl Rows<'_> {
    /// Add the values of a tag; `false` if it has no value of the number.
    fn add(&mut self, tag: i32, row: &[f64]) -> PyResult<bool> {
        if let Some(number) = self.number {
            let at = usize::try_from(number).ok().and_then(|n| n.checked_sub(1));
            let value = at.and_then(|at| row.get(at));
            self.values.extend(value);
            return Ok(value.is_some());
        }
        let (width, first) = *self.width.get_or_insert((row.len(), tag));
        if row.len() != width {
            let name = self.name;
            return Err(OpenSeesError::new_err(format!(
                "{name}: {first} has {width} values and {tag} has {}, which make no array\n  expected tags with as many values, or \
                 the number of a value behind the tags",
                row.len()
            )));
        }
        self.values.extend_from_slice(row);
        Ok(true)
    }

    fn array(self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let array = PyArray1::from_vec(py, self.values);
        match self.number {
            Some(_) => Ok(array.into_any().unbind()),
            None => {
                let width = self.width.map_or(0, |(width, _)| width);
                Ok(array.reshape([self.tags.len(), width])?.into_any().unbind())
            }
        }
    }
}

impl Domain {
    /// Values of nodes: an array of shape (nodes, values), or (nodes,) for a number.
    pub(crate) fn of_nodes(
        &self,
        py: Python<'_>,
        name: &'static str,
        (tags, number): (Tags, Option<i32>),
        values: impl for<'a> Fn(&'a mut Inner, NodeId) -> Option<&'a [f64]>,
    ) -> PyResult<Py<PyAny>> {
        let all = |inner: &mut Inner| inner.session().engine.model().node_tags().collect();
        self.gather(py, name, (tags, number), all, |inner, tag, rows| {
            let Some(node) = inner.session().engine.model().node(tag) else { return Ok(false) };
            values(inner, node).map_or(Ok(false), |row| rows.add(tag, row))
        })
    }

    /// The same of a response of elements.
    pub(crate) fn of_elements(
        &self,
        py: Python<'_>,
        name: &'static str,
        which: (Tags, Option<i32>),
        response: &[&str],
    ) -> PyResult<Py<PyAny>> {
        let all = |inner: &mut Inner| inner.session().engine.model().element_tags().collect();
        self.gather(py, name, which, all, |inner, tag, rows| {
            let Some(element): Option<ElementId> = inner.session().engine.model().element(tag) else {
                return Ok(false);
            };
            let found = inner.session().element_response(element, response);
            found.map_or(Ok(false), |row| rows.add(tag, &row))
        })
    }

    fn gather(
        &self,
        py: Python<'_>,
        name: &'static str,
        (tags, number): (Tags, Option<i32>),
        all: impl FnOnce(&mut Inner) -> Vec<i32>,
        add: impl Fn(&mut Inner, i32, &mut Rows<'_>) -> PyResult<bool>,
    ) -> PyResult<Py<PyAny>> {
        let mut inner = self.hold()?;
        let tags = tags.0.unwrap_or_else(|| all(&mut inner));
        let mut rows = Rows { name, number, values: vec![], width: None, tags: &tags };
        for tag in &tags {
            if !add(&mut inner, *tag, &mut rows)? {
                drop(inner);
                return Err(self.refusal(py, name, *tag, number));
            }
        }
        drop(inner);
        rows.array(py)
    }

    /// The error of the command for a tag that has no such values.
    fn refusal(&self, py: Python<'_>, name: &'static str, tag: i32, number: Option<i32>) -> PyErr {
        let ask = || {
            let words = [tag].into_iter().chain(number);
            // A response that an element lacks is a warning for one element, whose answer is empty.
            if name == "eleResponse" {
                return Ok(());
            }
            self.enter(py, Entry::of(name)?, &PyTuple::new(py, words.collect::<Vec<_>>())?).map(drop)
        };
        let missing = || OpenSeesError::new_err(format!("{name}: {tag} has no such response, or is not in the model"));
        ask().err().unwrap_or_else(missing)
    }
}
