//! Index of a checked script, for editors: what its commands took their words for, what they define and what they name.

use crate::Command;
use hysteron_engine::model::{Definitions, Model};
use hysteron_tcl::Call;
use hysteron_tcl::diagnostic::Span;
use std::collections::{HashMap, HashSet};

/// Calls at one place whose names are looked at. A loop of an analysis names the same things every time.
const MAX_CALLS_AT_PLACE: u32 = 20_000;
/// Names and definitions that are kept.
const MAX_MENTIONS: usize = 400_000;
/// Characters of a value that are kept.
const MAX_VALUE: usize = 80;
/// Nodes and elements up to which a model is kept.
const MAX_MODEL: usize = 100_000;

/// A place that defines or names a thing.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Mention {
    /// Kind of thing, in the words of messages.
    pub kind: &'static str,
    /// Its tag.
    pub tag: String,
    /// The word: a tag, or what gives it.
    pub span: Span,
    /// The command defines the thing. Others name it.
    pub defines: bool,
    /// Number of the model among [`Index::models`]: `wipe` begins another.
    pub model: usize,
}

/// A word of a command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CalledWord {
    /// Its place; none for one that has no text of its own.
    pub span: Option<Span>,
    /// Its value in the first call.
    pub value: String,
    /// What the command took it for; empty where it does not say.
    pub meaning: String,
}

/// A command of a script, with its words in its first call.
pub struct CalledCommand {
    /// The command.
    pub command: &'static Command,
    /// Place of the whole command.
    pub span: Span,
    /// Its words, the name being the first.
    pub words: Vec<CalledWord>,
    /// Number of calls.
    pub count: u32,
    /// Kinds of things that it defines, with their tags in the first call.
    pub defines: Vec<(&'static str, String)>,
    /// Number of the model.
    pub model: usize,
}

/// A call that defines things, with all its words.
pub struct Definition {
    /// The things: kinds and tags.
    pub things: Vec<(&'static str, String)>,
    /// The words of the call, the name of the command being the first.
    pub words: Vec<String>,
    /// Things that the words name.
    pub names: Vec<(&'static str, String)>,
    /// Number of the model.
    pub model: usize,
}

/// A model at its end, with the definitions beside it.
#[derive(Clone, Debug)]
pub struct IndexedModel {
    /// Nodes, elements, constraints and patterns.
    pub model: Model,
    /// Materials, sections and the like.
    pub definitions: Definitions,
}

/// Index of a script.
#[derive(Default)]
pub struct Index {
    /// The commands, in the order of their first calls.
    pub commands: Vec<CalledCommand>,
    /// What is defined and named, each place and thing once.
    pub mentions: Vec<Mention>,
    /// The models, the last of which may still be built.
    pub models: Vec<IndexedModel>,
    /// Every call that defines things, in their order, where they are kept.
    pub definitions: Vec<Definition>,
    /// Keep [`Index::definitions`].
    pub keeps_definitions: bool,
    by_place: HashMap<Span, usize>,
    known: HashSet<Mention>,
}

impl Index {
    /// Note a call whose command has been run; `done` if it was not rejected.
    pub(crate) fn note(&mut self, command: &'static Command, call: &Call<'_>, done: bool) {
        let Some(span) = call.whole_span() else { return };
        let model = self.models.len();
        let notes = call.notes();
        if self.keeps_definitions && done && command.defines.1 > 0 {
            let words = (0..call.len()).map(|i| call.arg(i).as_str().into_owned()).collect();
            let names = notes.names.iter().map(|(_, kind, tag)| (*kind, tag.clone())).collect();
            self.definitions.push(Definition { things: defined(command, call), words, names, model });
        }
        let count = match self.by_place.get(&span) {
            Some(i) => {
                self.commands[*i].count += 1;
                self.commands[*i].count
            }
            None => {
                self.by_place.insert(span, self.commands.len());
                let shown = |i| call.arg(i).as_str().chars().take(MAX_VALUE).collect();
                let word = |i| CalledWord { span: call.span(i), value: shown(i), meaning: String::new() };
                let mut words: Vec<CalledWord> = (0..call.len()).map(word).collect();
                for (i, meaning) in notes.meanings {
                    if let Some(word) = words.get_mut(i) {
                        word.meaning = meaning;
                    }
                }
                let defines = if done { defined(command, call) } else { vec![] };
                self.commands.push(CalledCommand { command, span, words, count: 1, defines, model });
                1
            }
        };
        if count > MAX_CALLS_AT_PLACE || self.mentions.len() > MAX_MENTIONS {
            return;
        }
        let tag_span = call.span(command.defines.1).filter(|_| done && command.defines.1 > 0);
        for (kind, tag) in tag_span.map(|_| defined(command, call)).unwrap_or_default() {
            let span = tag_span.unwrap_or(span);
            self.mention(Mention { kind, tag, span, defines: true, model });
        }
        for (span, kind, tag) in notes.names {
            self.mention(Mention { kind, tag, span, defines: false, model });
        }
    }

    fn mention(&mut self, mention: Mention) {
        if self.known.insert(mention.clone()) {
            self.mentions.push(mention);
        }
    }

    /// The script forgets its model, or ends.
    pub(crate) fn close_model(&mut self, model: &Model, definitions: &Definitions) {
        let is_small = model.nodes.len() + model.elements.len() <= MAX_MODEL;
        let kept = if is_small { model.clone() } else { Model::default() };
        self.models.push(IndexedModel { model: kept, definitions: definitions.clone() });
    }
}

/// Kinds of things that a call defines, with their tags.
fn defined(command: &Command, call: &Call<'_>) -> Vec<(&'static str, String)> {
    let (kinds, at) = command.defines;
    let tag = call.get(at).filter(|_| at > 0).and_then(hysteron_tcl::Value::as_i64);
    tag.into_iter().flat_map(|tag| kinds.iter().map(move |kind| (*kind, tag.to_string()))).collect()
}
