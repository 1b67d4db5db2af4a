//! Queries that loops make, without words: their arguments are numbers.

use crate::domain::{Domain, Inner};
use crate::many::Tags;
use crate::methods::Entry;
use crate::trace;
use crate::words::words;
use hysteron_engine::analysis::State;
use hysteron_engine::model::{ElementId, NodeId};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use std::sync::OnceLock;

/// An argument that may be left out.
type Arg<'py> = Option<Bound<'py, PyAny>>;

/// Values: all of them, or the one of a number from 1. `None` where the words need a closer look.
fn pick(py: Python<'_>, values: &[f64], number: Option<i32>) -> Option<PyResult<Py<PyAny>>> {
    match number {
        None => Some(PyList::new(py, values).map(|l| l.into_any().unbind())),
        Some(number) => {
            let x = values.get(usize::try_from(number).ok()?.checked_sub(1)?)?;
            Some(Ok(PyFloat::new(py, *x).into_any().unbind()))
        }
    }
}

/// A query with its arguments: a tag, and mostly a number.
struct Asked<'a, 'py> {
    name: &'static str,
    given: Given<'a, 'py>,
}

/// A list of tags.
fn tags(py: Python<'_>, tags: impl Iterator<Item = i32>) -> PyResult<Py<PyAny>> {
    Ok(PyList::new(py, tags.collect::<Vec<_>>())?.into_any().unbind())
}

/// Arguments of a call, of which there are mostly two.
struct Given<'a, 'py> {
    first: &'a Arg<'py>,
    second: &'a Arg<'py>,
    more: &'a Bound<'py, PyTuple>,
}

impl<'py> Given<'_, 'py> {
    /// One or two whole numbers; `None` for anything else.
    fn numbers(&self) -> Option<(i32, Option<i32>)> {
        if !self.more.is_empty() {
            return None;
        }
        let first = self.first.as_ref()?.extract::<i32>().ok()?;
        match &self.second {
            None => Some((first, None)),
            Some(number) => Some((first, Some(number.extract::<i32>().ok()?))),
        }
    }

    /// Many tags, and the number of a value: no argument, or a sequence of tags first. `None` for anything else.
    fn many(&self) -> Option<(Tags, Option<i32>)> {
        if !self.more.is_empty() {
            return None;
        }
        match (self.first, self.second) {
            (None, None) => Some((Tags::ALL, None)),
            (None, Some(_)) => None,
            (Some(first), None) => Some((Tags::of(first)?, None)),
            (Some(first), Some(number)) => Some((Tags::of(first)?, Some(number.extract::<i32>().ok()?))),
        }
    }

    /// Number and length of steps; `None` for anything else.
    fn steps(&self) -> Option<(usize, Option<f64>)> {
        if !self.more.is_empty() {
            return None;
        }
        let steps = self.first.as_ref()?.cast::<PyInt>().ok()?.extract::<usize>().ok()?;
        match &self.second {
            None => Some((steps, None)),
            Some(dt) => Some((steps, Some(dt.cast::<PyFloat>().ok()?.value()))),
        }
    }

    fn all(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let given = [self.first, self.second].into_iter().flatten().cloned().chain(self.more.iter());
        PyTuple::new(py, given.collect::<Vec<_>>())
    }
}

impl Domain {
    /// The command itself, for words that need a closer look.
    fn by_words(&self, py: Python<'_>, asked: &Asked<'_, '_>) -> PyResult<Py<PyAny>> {
        self.enter(py, Entry::of(asked.name)?, &asked.given.all(py)?)
    }

    /// Make steps of an analysis; at once where it goes on from the last call.
    fn analyze_given(&self, py: Python<'_>, given: &Given<'_, '_>) -> PyResult<Py<PyAny>> {
        static ANALYZE: OnceLock<&'static Entry> = OnceLock::new();
        let entry = match ANALYZE.get() {
            Some(entry) => entry,
            None => Entry::of("analyze").map(|e| *ANALYZE.get_or_init(|| e))?,
        };
        match given.steps() {
            Some((steps, dt)) => self.continue_analysis(py, entry, steps, dt, || words(entry, &given.all(py)?)),
            None => self.enter(py, entry, &given.all(py)?),
        }
    }

    /// Values of a node by the quick way, or else by the command.
    fn of_node(
        &self,
        py: Python<'_>,
        asked: &Asked<'_, '_>,
        values: impl for<'a> Fn(&'a mut Inner, NodeId) -> Option<&'a [f64]>,
    ) -> PyResult<Py<PyAny>> {
        if let Some((tag, dof)) = asked.given.numbers() {
            let mut inner = self.hold()?;
            if let Some(node) = inner.session().engine.model().node(tag)
                && let Some(found) = values(&mut inner, node).and_then(|v| pick(py, v, dof))
            {
                return found;
            }
        } else if let Some(many) = asked.given.many() {
            return self.of_nodes(py, asked.name, many, values);
        }
        self.by_words(py, asked)
    }

    fn node_field(&self, py: Python<'_>, asked: &Asked<'_, '_>, field: fn(&State) -> &[f64]) -> PyResult<Py<PyAny>> {
        self.of_node(py, asked, |inner, node| {
            let session = inner.session();
            let dofs = session.node_dofs(node);
            Some(&field(session.engine.state())[dofs])
        })
    }

    fn element(&self, inner: &mut Inner, tag: i32) -> Option<ElementId> {
        inner.session().engine.model().element(tag)
    }

    /// A response with a command of its own.
    fn named(&self, py: Python<'_>, asked: &Asked<'_, '_>, response: &str) -> PyResult<Py<PyAny>> {
        if let Some((tag, column)) = asked.given.numbers() {
            let mut inner = self.hold()?;
            if let Some(element) = self.element(&mut inner, tag)
                && let Some(values) = inner.session().element_response(element, &[response])
                && let Some(found) = pick(py, &values, column)
            {
                return found;
            }
        } else if let Some(many) = asked.given.many() {
            return self.of_elements(py, asked.name, many, &[response]);
        }
        self.by_words(py, asked)
    }
}

/// Queries of a tag and a number, with the function that answers them.
macro_rules! queries {
    ($($(#[doc = $doc:literal])* $function:ident $name:literal $by:ident($($how:expr),*);)*) => {
        #[pymethods]
        impl Domain {
            $(
                $(#[doc = $doc])*
                #[pyo3(name = $name, signature = (tag = None, number = None, /, *more))]
                fn $function<'py>(
                    slf: &Bound<'py, Self>,
                    tag: Arg<'py>,
                    number: Arg<'py>,
                    more: &Bound<'py, PyTuple>,
                ) -> PyResult<Py<PyAny>> {
                    let (py, given) = (slf.py(), Given { first: &tag, second: &number, more });
                    // A script has no arrays: what is asked of many is not recorded.
                    if trace::is_on()
                        && given.many().is_none()
                        && let Some(answer) = trace::taken(slf, $name, || Ok(given.all(py)?.unbind()))
                    {
                        return answer;
                    }
                    slf.get().$by(py, &Asked { name: $name, given }, $($how),*)
                }
            )*
        }
    };
}

queries! {
    /// Displacements of a node: `nodeDisp(node)`, or one of them: `nodeDisp(node, dof)`.
    node_disp "nodeDisp" node_field(|s| &s.disp);
    /// Velocities of a node: `nodeVel(node)`, or one of them: `nodeVel(node, dof)`.
    node_vel "nodeVel" node_field(|s| &s.vel);
    /// Accelerations of a node: `nodeAccel(node)`, or one of them: `nodeAccel(node, dof)`.
    node_accel "nodeAccel" node_field(|s| &s.accel);
    /// Coordinates of a node: `nodeCoord(node)`, or one of them: `nodeCoord(node, direction)`.
    node_coord "nodeCoord" of_node(|inner, node| Some(&inner.session().engine.model().nodes[node.0].coords));
    /// Reactions at a node: `nodeReaction(node)`, or one of them: `nodeReaction(node, dof)`.
    node_reaction "nodeReaction" of_node(|inner, node| {
        if inner.reactions.is_none() {
            inner.reactions = inner.session().reactions().ok();
        }
        let dofs = inner.session().node_dofs(node);
        inner.reactions.as_ref()?.get(dofs)
    });
    /// Global force of an element: `eleForce(element)`, or one of its values: `eleForce(element, number)`.
    ele_force "eleForce" named("force");
    /// Basic force of an element: `basicForce(element)`, or one of its values: `basicForce(element, number)`.
    basic_force "basicForce" named("basicForce");
    /// Basic deformations of an element: `basicDeformation(element)`, or one of them: `basicDeformation(element, number)`.
    basic_deformation "basicDeformation" named("basicDeformation");
    /// Local force of an element: `localForce(element)`, or one of its values: `localForce(element, number)`.
    local_force "localForce" named("localForce");
}

#[pymethods]
impl Domain {
    /// `analyze(steps, dt)`: 0, or the code of the failure.
    ///
    /// With `record`, the histories of responses by name: `record={'roof': ('disp', 4, 1)}` for node 4 and degree of
    /// freedom 1, `('Element', '-ele', 1, 'force')` for the words of a recorder without its file. They are arrays of shape
    /// (rows, columns), or (rows,) for a single column. With `progress`, a bar of tqdm shows the steps, where that is installed.
    #[pyo3(signature = (steps = None, dt = None, /, *more, record = None, progress = false))]
    fn analyze<'py>(
        slf: &Bound<'py, Self>,
        steps: Arg<'py>,
        dt: Arg<'py>,
        more: &Bound<'py, PyTuple>,
        record: Option<Bound<'py, PyDict>>,
        progress: bool,
    ) -> PyResult<Py<PyAny>> {
        let (py, given) = (slf.py(), Given { first: &steps, second: &dt, more });
        if let Some(answer) = trace::taken(slf, "analyze", || Ok(given.all(py)?.unbind())) {
            return answer;
        }
        match record {
            record if progress => Ok(slf.call_method1("_analyze_shown", (given.all(py)?, record))?.unbind()),
            None => slf.get().analyze_given(py, &given),
            Some(record) => Ok(slf.call_method1("_analyze_recorded", (given.all(py)?, record))?.unbind()),
        }
    }

    /// Time of the committed state, or the load factor of a static analysis.
    #[pyo3(name = "getTime")]
    fn get_time<'py>(slf: &Bound<'py, Self>) -> PyResult<Py<PyAny>> {
        let py = slf.py();
        if let Some(answer) = trace::taken(slf, "getTime", || Ok(PyTuple::empty(py).unbind())) {
            return answer;
        }
        let time = slf.get().hold()?.session().engine.state().time;
        Ok(PyFloat::new(py, time).into_any().unbind())
    }

    /// Tags of the nodes, rising.
    #[pyo3(name = "getNodeTags", signature = (*args))]
    fn get_node_tags<'py>(slf: &Bound<'py, Self>, args: &Bound<'py, PyTuple>) -> PyResult<Py<PyAny>> {
        if let Some(answer) = trace::taken(slf, "getNodeTags", || Ok(args.clone().unbind())) {
            return answer;
        }
        slf.get().get_node_tags_by_args(slf.py(), args)
    }

    /// Tags of the elements, rising.
    #[pyo3(name = "getEleTags", signature = (*args))]
    fn get_ele_tags<'py>(slf: &Bound<'py, Self>, args: &Bound<'py, PyTuple>) -> PyResult<Py<PyAny>> {
        if let Some(answer) = trace::taken(slf, "getEleTags", || Ok(args.clone().unbind())) {
            return answer;
        }
        slf.get().get_ele_tags_by_args(slf.py(), args)
    }

    /// Tags of the nodes of an element.
    #[pyo3(name = "eleNodes", signature = (*args))]
    fn ele_nodes<'py>(slf: &Bound<'py, Self>, args: &Bound<'py, PyTuple>) -> PyResult<Py<PyAny>> {
        if let Some(answer) = trace::taken(slf, "eleNodes", || Ok(args.clone().unbind())) {
            return answer;
        }
        slf.get().ele_nodes_by_args(slf.py(), args)
    }

    /// A response of an element by its name: `eleResponse(element, 'force')`; empty if it has none of that name. Of a
    /// sequence of elements an array of shape (elements, values).
    #[pyo3(name = "eleResponse", signature = (*args))]
    fn ele_response<'py>(slf: &Bound<'py, Self>, args: &Bound<'py, PyTuple>) -> PyResult<Py<PyAny>> {
        if let Some((tags, words)) = asked_of_many(args) {
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            return slf.get().of_elements(slf.py(), "eleResponse", (tags, None), &words);
        }
        if let Some(answer) = trace::taken(slf, "eleResponse", || Ok(args.clone().unbind())) {
            return answer;
        }
        slf.get().ele_response_by_args(slf.py(), args)
    }
}

impl Domain {
    fn get_node_tags_by_args(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        if args.is_empty() {
            return tags(py, self.hold()?.session().engine.model().node_tags());
        }
        self.enter(py, Entry::of("getNodeTags")?, args)
    }

    fn get_ele_tags_by_args(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        if args.is_empty() {
            return tags(py, self.hold()?.session().engine.model().element_tags());
        }
        self.enter(py, Entry::of("getEleTags")?, args)
    }

    fn ele_nodes_by_args(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        if args.len() == 1
            && let Ok(tag) = args.get_borrowed_item(0)?.extract::<i32>()
        {
            let mut inner = self.hold()?;
            if let Some(element) = self.element(&mut inner, tag) {
                let model = inner.session().engine.model();
                return tags(py, model.elements[element.0].nodes.iter().map(|n| model.nodes[n.0].tag));
            }
        }
        self.enter(py, Entry::of("eleNodes")?, args)
    }

    fn ele_response_by_args(&self, py: Python<'_>, args: &Bound<'_, PyTuple>) -> PyResult<Py<PyAny>> {
        if let Ok((tag, word)) = args.extract::<(i32, Bound<'_, PyString>)>() {
            let mut inner = self.hold()?;
            if let Some(element) = self.element(&mut inner, tag)
                && let Some(values) = inner.session().element_response(element, &[word.to_cow()?.trim()])
            {
                return Ok(PyList::new(py, values)?.into_any().unbind());
            }
        }
        if let Some(words) = response_words(args)
            && let Ok(tag) = args.get_borrowed_item(0)?.extract::<i32>()
        {
            let mut inner = self.hold()?;
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            if let Some(element) = self.element(&mut inner, tag)
                && let Some(values) = inner.session().element_response(element, &words)
            {
                return Ok(PyList::new(py, values)?.into_any().unbind());
            }
        }
        self.enter(py, Entry::of("eleResponse")?, args)
    }
}

/// The words of a response behind the element; `None` for anything but texts and whole numbers.
fn response_words(args: &Bound<'_, PyTuple>) -> Option<Vec<String>> {
    let word = |item: Bound<'_, PyAny>| -> Option<String> {
        match item.cast::<PyString>() {
            Ok(text) => Some(text.to_cow().ok()?.trim().to_owned()),
            Err(_) => Some(item.extract::<i64>().ok()?.to_string()),
        }
    };
    if args.len() < 2 { None } else { args.iter().skip(1).map(word).collect() }
}

/// Elements in a sequence, and the words of their response.
fn asked_of_many(args: &Bound<'_, PyTuple>) -> Option<(Tags, Vec<String>)> {
    let first = args.get_item(0).ok().filter(|first| !first.is_instance_of::<PyInt>())?;
    Some((Tags::of(&first)?, response_words(args)?))
}
