//! Responses of elements.

use super::opensees::probe;
use super::{Group, Missing, RecordError, Source};
use crate::analysis::{Engine, Recorded};
use crate::material::Slot;
use crate::model::{ElementId, Tag};
use crate::probe::Probe;
use crate::section::SectionSlot;
use crate::series::Series;

/// A response of some elements.
#[derive(Debug)]
pub struct ElementResponse {
    /// Elements by tag; `None` for all of them.
    elements: Option<Vec<Tag>>,
    /// State variables of the recorder command that name the response.
    words: Vec<String>,
    /// Columns of the response from 0; empty for all.
    columns: Vec<usize>,
    found: Vec<(ElementId, Tag, Response)>,
    values: Vec<f64>,
    disp: Vec<f64>,
}

/// Responses that have been found by name, since loops use the same ones again and again.
#[derive(Debug, Default)]
pub struct Known {
    /// Of the model that they belong to.
    revision: u64,
    found: Vec<KnownResponse>,
}

#[derive(Debug)]
struct KnownResponse {
    element: ElementId,
    words: Vec<String>,
    path: Vec<u32>,
    columns: usize,
}

impl Known {
    /// Largest number of responses that are remembered.
    const MOST: usize = 64;

    fn find(&mut self, engine: &Engine, id: ElementId, words: &[&str]) -> Option<&KnownResponse> {
        if self.revision != engine.model().revision() || self.found.len() > Self::MOST {
            self.found.clear();
            self.revision = engine.model().revision();
        }
        let at = match self.found.iter().position(|known| known.element == id && known.words == words) {
            Some(at) => at,
            None => {
                let probe = probe(engine, id, words)?;
                let (columns, words) = (probe.len(), words.iter().map(|w| (*w).to_owned()).collect());
                self.found.push(KnownResponse { element: id, words, path: probe.path, columns });
                self.found.len() - 1
            }
        };
        self.found.get(at)
    }
}

#[derive(Debug)]
enum Response {
    /// The global force.
    Force(Vec<String>),
    /// A response of the element's own.
    Probe(Probe),
}

impl Response {
    fn labels(&self) -> &[String] {
        match self {
            Self::Force(labels) => labels,
            Self::Probe(p) => &p.labels,
        }
    }

    /// Append the response of an element in the committed state; `disp` is a buffer for its displacements.
    fn append(&self, engine: &Engine, id: ElementId, disp: &mut Vec<f64>, out: &mut Vec<f64>) {
        match self {
            Self::Force(_) => engine.element_force(id, out),
            Self::Probe(p) => {
                let snapshot = engine.snapshot(id, disp);
                let start = out.len();
                out.resize(start + p.len(), 0.0);
                engine.model().elements[id.0].element.read(&p.path, &snapshot, &mut out[start..]);
            }
        }
    }
}

/// Names of parts of elements and sections that have responses.
const PARTS: [&str; 5] = ["section", "fiber", "material", "fiberData", "centroid"];

/// A word of a response that an element does not know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misspelled {
    /// Index among the words.
    pub index: usize,
    /// Names that would end a response at its place.
    pub known: Vec<&'static str>,
    /// Names that fit in its place with or without the words behind it, to suggest the nearest.
    pub fitting: Vec<&'static str>,
}

/// Names of the global force.
const FORCE: [&str; 5] = ["force", "forces", "globalForce", "globalForces", "globalforces"];

impl ElementResponse {
    /// Of elements (all of them for `None`), by the words that name it; only some columns of it if any are given.
    pub fn new(elements: Option<Vec<Tag>>, words: Vec<String>, columns: Vec<usize>) -> Self {
        Self { elements, words, columns, found: vec![], values: vec![], disp: vec![] }
    }

    fn answer(&self, engine: &Engine, id: ElementId) -> Option<Response> {
        let element = &engine.model().elements[id.0].element;
        let words: Vec<&str> = self.words.iter().map(String::as_str).collect();
        // A joint has a response of its own by the name of the global force.
        let own = probe(engine, id, &words).map(Response::Probe);
        if own.is_none() && words.first().is_some_and(|w| FORCE.contains(w)) {
            return Some(Response::Force(element.force_labels()));
        }
        own
    }

    /// Names that an element knows besides those common to all, to suggest the nearest to a misspelled one.
    pub fn names(engine: &Engine, id: ElementId) -> impl Iterator<Item = &'static str> + use<> {
        let own = engine.model().elements[id.0].element.probe_names();
        FORCE[..4].iter().copied().chain(own)
    }

    /// The first of some words that no response of an element has at its place, where the element does not know them.
    pub fn misspelled(engine: &Engine, id: ElementId, words: &[&str]) -> Misspelled {
        let vocabulary: Vec<&'static str> = Self::names(engine, id)
            .chain(PARTS.iter().chain(SectionSlot::RESPONSES).copied())
            .chain(crate::probe::Response::names(Slot::RESPONSES))
            .collect();
        let known_after = |i: usize| -> Vec<&'static str> {
            let ends = |word: &&&str| Self::is_known(engine, id, &[&words[..i], &[**word]].concat());
            vocabulary.iter().filter(ends).copied().collect()
        };
        // Words are understood up to the last place where another word would end a response.
        let last = words.len().saturating_sub(1);
        let understood = (1..=last).rev().map(|i| (i, known_after(i))).find(|(_, known)| !known.is_empty());
        let (index, known) = understood.unwrap_or_else(|| (0, Self::names(engine, id).collect()));
        let repaired = |word: &&&'static str| {
            let mut whole = words.to_vec();
            if let Some(w) = whole.get_mut(index) {
                *w = **word;
            }
            Self::is_known(engine, id, &whole)
        };
        let fitting = vocabulary.iter().filter(repaired).chain(&known).copied();
        Misspelled { index, known: known.clone(), fitting: fitting.collect() }
    }

    /// Returns true if an element has a response of that name.
    pub fn is_known(engine: &Engine, id: ElementId, words: &[&str]) -> bool {
        words.first().is_some_and(|w| FORCE.contains(w)) || probe(engine, id, words).is_some()
    }

    /// Value of the response of one element in the committed state; `None` where it has none of that name.
    pub fn evaluate(engine: &Engine, id: ElementId, words: &[&str], known: &mut Known) -> Option<Vec<f64>> {
        let mut values = vec![];
        let own = || probe(engine, id, words).is_some();
        if words.first().is_some_and(|w| FORCE.contains(w)) && !own() {
            engine.element_force(id, &mut values);
            return Some(values);
        }
        let KnownResponse { path, columns, .. } = known.find(engine, id, words)?;
        let mut disp = vec![];
        let snapshot = engine.snapshot(id, &mut disp);
        values.resize(*columns, 0.0);
        engine.model().elements[id.0].element.read(path, &snapshot, &mut values);
        Some(values)
    }

    fn chosen(&self, n: usize) -> impl Iterator<Item = usize> + '_ {
        let all = self.columns.is_empty();
        (0..n).filter(move |_| all).chain(self.columns.iter().copied().filter(move |c| !all && *c < n))
    }
}

impl Source for ElementResponse {
    fn find(&mut self, engine: &Engine, missing: &mut Vec<Missing>) -> Result<(), RecordError> {
        let model = engine.model();
        let wanted: Vec<Tag> = self.elements.clone().unwrap_or_else(|| model.element_tags().collect());
        self.found.clear();
        for tag in wanted {
            let Some(id) = model.element(tag) else {
                missing.push(Missing::Element(tag));
                continue;
            };
            match self.answer(engine, id) {
                Some(answer) => self.found.push((id, tag, answer)),
                None => missing.push(Missing::Response {
                    words: self.words.join(" "),
                    element: tag,
                    class: model.elements[id.0].element.class().name,
                }),
            }
        }
        if let Some(width) = self.found.iter().map(|(_, _, answer)| answer.labels().len()).max() {
            let beyond = self.columns.iter().filter(|c| **c >= width);
            let column = |c: &usize| Missing::Column { column: c + 1, words: self.words.join(" "), width };
            missing.extend(beyond.map(column));
        }
        Ok(())
    }

    fn labels(&self) -> Vec<String> {
        let label = |tag: Tag, l: &String| format!("element {tag} {l}");
        self.found
            .iter()
            .flat_map(|(_, tag, a)| self.chosen(a.labels().len()).map(move |i| label(*tag, &a.labels()[i])))
            .collect()
    }

    fn groups(&self, engine: &Engine) -> Vec<Group> {
        const ENDS: [&str; 4] = ["node1", "node2", "node3", "node4"];
        let model = engine.model();
        let group = |(id, tag, answer): &(ElementId, Tag, Response)| {
            let entry = &model.elements[id.0];
            let mut attributes = vec![("eleType", entry.element.class().name.to_owned()), ("eleTag", tag.to_string())];
            attributes.extend(ENDS.into_iter().zip(entry.nodes.iter().map(|n| model.nodes[n.0].tag.to_string())));
            let labels = answer.labels();
            let columns = self.chosen(labels.len()).map(|i| labels[i].clone()).collect();
            Group { name: "ElementOutput", attributes, place: None, columns }
        };
        self.found.iter().map(group).collect()
    }

    fn numbers(&self, engine: &Engine) -> Option<Vec<(Recorded, Option<Series>)>> {
        let mut numbers = vec![];
        for (id, _, answer) in &self.found {
            let e = &engine.model().elements[id.0];
            if !matches!(answer, Response::Force(_)) || e.element.undamped().is_some() {
                return None;
            }
            numbers.extend(self.chosen(e.force.len()).map(|i| (Recorded::Force(e.force.start + i), None)));
        }
        Some(numbers)
    }

    fn row(&mut self, engine: &mut Engine, row: &mut Vec<f64>) -> Result<(), RecordError> {
        let found = std::mem::take(&mut self.found);
        for (id, _, answer) in &found {
            if self.columns.is_empty() {
                answer.append(engine, *id, &mut self.disp, row);
            } else {
                self.values.clear();
                answer.append(engine, *id, &mut self.disp, &mut self.values);
                row.extend(self.chosen(self.values.len()).map(|i| self.values[i]));
            }
        }
        self.found = found;
        Ok(())
    }
}
