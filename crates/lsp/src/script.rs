//! What a check has found out about a script: its index, with the places of all files that it reads.

use hysteron_opensees::index::{CalledCommand, Index, Mention};
use hysteron_tcl::diagnostic::{SourceId, SourceMap, Span};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// A stretch of a file, in bytes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    pub(crate) path: String,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

/// Commands and names of a file, by their numbers in the index.
#[derive(Debug, Default)]
struct FileIndex {
    text: Arc<str>,
    commands: Vec<usize>,
    mentions: Vec<usize>,
}

/// Index of a script and of the files that it sources.
pub(crate) struct Script {
    pub(crate) index: Index,
    /// Values of the variables at the end, by name.
    pub(crate) variables: BTreeMap<String, String>,
    paths: HashMap<SourceId, String>,
    files: BTreeMap<String, FileIndex>,
}

/// Absolute paths of the texts of a run, whose names are relative to the folder of its script.
#[derive(Default)]
pub(crate) struct Paths {
    known: HashMap<SourceId, String>,
}

impl Paths {
    /// Place of a span.
    pub(crate) fn place(&mut self, sources: &SourceMap, folder: &str, span: Span) -> Place {
        let path = self.known.entry(span.source).or_insert_with(|| {
            let name = sources.name(span.source);
            crate::uri::joined(folder, &name)
        });
        Place { path: path.clone(), start: span.start as usize, end: span.end as usize }
    }
}

impl Script {
    pub(crate) fn new(index: Index, variables: BTreeMap<String, String>, sources: &SourceMap, folder: &str) -> Self {
        let (mut paths, mut files) = (Paths::default(), BTreeMap::<String, FileIndex>::new());
        let mut file = |span: Span, add: &dyn Fn(&mut FileIndex)| {
            let place = paths.place(sources, folder, span);
            add(files
                .entry(place.path)
                .or_insert_with(|| FileIndex { text: sources.text(span.source), ..FileIndex::default() }));
        };
        for (i, c) in index.commands.iter().enumerate() {
            file(c.span, &|f| f.commands.push(i));
        }
        for (i, m) in index.mentions.iter().enumerate() {
            file(m.span, &|f| f.mentions.push(i));
        }
        Self { index, variables, paths: paths.known, files }
    }

    /// The text of a file as it was checked.
    pub(crate) fn text(&self, path: &str) -> Option<&Arc<str>> {
        self.files.get(path).map(|f| &f.text)
    }

    /// Place of a span of the index.
    pub(crate) fn place(&self, span: Span) -> Option<Place> {
        let path = self.paths.get(&span.source)?.clone();
        Some(Place { path, start: span.start as usize, end: span.end as usize })
    }

    /// Commands of a file, in the order in which they ran first.
    pub(crate) fn commands<'a>(&'a self, path: &str) -> impl Iterator<Item = &'a CalledCommand> + use<'a> {
        self.files.get(path).into_iter().flat_map(|f| f.commands.iter().map(|i| &self.index.commands[*i]))
    }

    /// Names and definitions in a file.
    pub(crate) fn mentions<'a>(&'a self, path: &str) -> impl Iterator<Item = &'a Mention> + use<'a> {
        self.files.get(path).into_iter().flat_map(|f| f.mentions.iter().map(|i| &self.index.mentions[*i]))
    }

    /// What is named or defined by the word around a byte of a file.
    pub(crate) fn mentions_at(&self, path: &str, at: usize) -> Vec<&Mention> {
        let around = |m: &&Mention| m.span.start as usize <= at && at <= m.span.end as usize;
        let all: Vec<&Mention> = self.mentions(path).filter(around).collect();
        let shortest = all.iter().map(|m| m.span.end - m.span.start).min();
        all.into_iter().filter(|m| Some(m.span.end - m.span.start) == shortest).collect()
    }

    /// The command that defines a thing.
    pub(crate) fn definition(&self, thing: &Mention) -> Option<&CalledCommand> {
        let is_same = |m: &&Mention| m.defines && same_thing(m, thing);
        let defined = self.index.mentions.iter().filter(is_same).min_by_key(|m| m.model.abs_diff(thing.model))?;
        let within = |c: &&CalledCommand| {
            let (a, b) = (c.span, defined.span);
            a.source == b.source && a.start <= b.start && b.end <= a.end
        };
        self.index.commands.iter().filter(within).min_by_key(|c| c.span.end - c.span.start)
    }

    /// Places that define or name a thing, in its own model.
    pub(crate) fn uses<'a>(&'a self, thing: &'a Mention) -> impl Iterator<Item = &'a Mention> {
        self.index.mentions.iter().filter(|m| m.model == thing.model && same_thing(m, thing))
    }
}

/// Returns true if two places mean things of one kind and tag.
pub(crate) fn same_thing(a: &Mention, b: &Mention) -> bool {
    a.kind == b.kind && a.tag == b.tag
}
