//! Definitions, references and new names of things, procedures, variables and files.

use crate::buffer::{View, WordAt};
use crate::script::{Place, Script};
use crate::uri;
use hysteron_opensees::index::Mention;
use lsp_types::{Location, Position, Range, TextEdit, Uri, WorkspaceEdit};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Places that define what the word around a byte names.
pub(crate) fn definitions(view: &View<'_>, at: usize) -> Vec<Location> {
    if let Some(file) = sourced_file(view, at) {
        return vec![file];
    }
    let of_things = used_places(view, at, |m| m.defines);
    if !of_things.is_empty() {
        return of_things;
    }
    let Some(name) = name_at(view, at) else { return vec![] };
    places_of(view, &name, true)
}

/// All places of what the word around a byte names.
pub(crate) fn references(view: &View<'_>, at: usize, with_definitions: bool) -> Vec<Location> {
    let of_things = used_places(view, at, |m| with_definitions || !m.defines);
    if !of_things.is_empty() {
        return of_things;
    }
    let Some(name) = name_at(view, at) else { return vec![] };
    let mut all = places_of(view, &name, false);
    if with_definitions {
        all.extend(places_of(view, &name, true));
    }
    sorted(all)
}

/// Ranges in this file of what the word around a byte names.
pub(crate) fn highlights(view: &View<'_>, at: usize) -> Vec<Range> {
    let own = references(view, at, true).into_iter();
    own.filter(|l| l.uri.as_str() == view.buffer.uri.as_str()).map(|l| l.range).collect()
}

fn sorted(mut all: Vec<Location>) -> Vec<Location> {
    let key = |l: &Location| (l.uri.as_str().to_owned(), l.range.start.line, l.range.start.character);
    all.sort_by_key(key);
    all.dedup();
    all
}

/// Places of the things that the word around a byte names or defines.
fn used_places(view: &View<'_>, at: usize, wanted: impl Fn(&Mention) -> bool) -> Vec<Location> {
    let Some((script, things)) = things_at(view, at) else { return vec![] };
    let mut places: BTreeSet<Place> = BTreeSet::new();
    for thing in &things {
        let uses = script.uses(thing).filter(|m| wanted(m));
        places.extend(uses.filter_map(|m| script.place(m.span)));
    }
    sorted(places.iter().filter_map(|p| view.location(p)).collect())
}

fn things_at<'a>(view: &View<'a>, at: usize) -> Option<(&'a Script, Vec<&'a Mention>)> {
    let script = view.script()?;
    Some((script, script.mentions_at(view.path, view.checked(at)?)))
}

/// The file that a command `source` names.
fn sourced_file(view: &View<'_>, at: usize) -> Option<Location> {
    let word = view.word_at(at).filter(|w| w.word == 1)?;
    if view.written(word.command).first() != Some(&"source") {
        return None;
    }
    let text = view.text().get(word.start..word.end)?.trim_matches(['"', '{', '}']);
    let path = uri::joined(uri::folder(view.path), text);
    let is_there = view.buffers.contains_key(&path) || hysteron_files::info(&path).is_ok_and(|i| i.is_file());
    let uri = uri::from_path(&path).filter(|_| is_there)?;
    Some(Location { uri, range: Range::default() })
}

/// A name that the text itself defines.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Name {
    Procedure(String),
    /// A variable, with the procedure that it belongs to; none for one of the whole script.
    Variable {
        name: String,
        owner: Option<String>,
    },
}

/// Commands that give a variable a value, and the word with its name.
const SETTERS: [(&str, usize); 6] =
    [("set", 1), ("incr", 1), ("append", 1), ("lappend", 1), ("foreach", 1), ("pset", 1)];

/// The procedure or variable that the word around a byte names.
fn name_at(view: &View<'_>, at: usize) -> Option<Name> {
    let syntax = view.buffer.syntax();
    let around = |v: &&hysteron_tcl::WrittenVariable| v.start <= at && at <= v.end;
    if let Some(v) = syntax.variables.iter().filter(around).min_by_key(|v| v.end - v.start) {
        return Some(variable(view, &v.name, v.command));
    }
    let word = view.word_at(at)?;
    let written = view.written(word.command);
    let text = *written.get(word.word)?;
    let head = written.first().copied().unwrap_or_default();
    match word {
        WordAt { word: 1, .. } if head == "proc" => Some(Name::Procedure(text.to_owned())),
        WordAt { word: 0, .. } => Some(Name::Procedure(text.to_owned())),
        WordAt { word: n, .. } if SETTERS.contains(&(head, n)) => Some(variable(view, text, word.command)),
        _ => None,
    }
}

/// A variable as a command sees it.
fn variable(view: &View<'_>, name: &str, command: usize) -> Name {
    let is_global = name.starts_with("::");
    let owner = if is_global { None } else { owner(view, command) };
    Name::Variable { name: name.trim_start_matches("::").to_owned(), owner }
}

/// The procedure in whose body a command stands.
fn owner(view: &View<'_>, command: usize) -> Option<String> {
    let commands = &view.buffer.syntax().commands;
    let mut at = commands.get(command)?.parent;
    while let Some(i) = at {
        let words = view.written(i);
        if words.len() > 3 && words[0] == "proc" {
            return Some(words[1].to_owned());
        }
        at = commands.get(i)?.parent;
    }
    None
}

/// Places of a name in all open files of the script: those that define it, or those that use it.
fn places_of(view: &View<'_>, name: &Name, defining: bool) -> Vec<Location> {
    let belongs = |path: &&String| *path == view.path || view.script().is_some_and(|s| s.text(path).is_some());
    let mut all = vec![];
    for (path, buffer) in view.buffers.iter().filter(|(path, _)| belongs(path)) {
        let own = View::new(path, buffer, view.buffers, view.known);
        let found = spans_of(&own, name, defining);
        all.extend(
            found
                .into_iter()
                .map(|(start, end)| Location { uri: buffer.uri.clone(), range: buffer.text.range(start, end) }),
        );
    }
    sorted(all)
}

fn spans_of(view: &View<'_>, name: &Name, defining: bool) -> Vec<(usize, usize)> {
    let syntax = view.buffer.syntax();
    let text = view.text();
    let mut spans = vec![];
    for (i, c) in syntax.commands.iter().enumerate() {
        let word = |n: usize| c.words.get(n).and_then(|w| text.get(w.0..w.1)).unwrap_or_default();
        match name {
            Name::Procedure(p) if defining && word(0) == "proc" && word(1) == p => spans.push(c.words[1]),
            Name::Procedure(p) if !defining && word(0) == p => spans.push(c.words[0]),
            Name::Variable { name: v, .. } if defining => {
                let sets = |(head, n): &(&str, usize)| word(0) == *head && word(*n).trim_start_matches("::") == v;
                if let Some((_, n)) = SETTERS.iter().find(|s| sets(s)).filter(|_| variable(view, v, i) == *name) {
                    spans.push(c.words[*n]);
                }
            }
            _ => {}
        }
    }
    if let (Name::Variable { .. }, false) = (name, defining) {
        let same = |v: &&hysteron_tcl::WrittenVariable| variable(view, &v.name, v.command) == *name;
        spans.extend(syntax.variables.iter().filter(same).map(|v| (v.start, v.end)));
    }
    spans
}

/// Range of a word that can have another name.
pub(crate) fn renamable(view: &View<'_>, at: usize) -> Option<Range> {
    let word = view.word_at(at)?;
    let literal = view.text().get(word.start..word.end)?;
    let is_tag = literal.parse::<i64>().is_ok() && things_at(view, at).is_some_and(|(_, t)| t.len() == 1);
    let is_procedure = matches!(name_at(view, at), Some(Name::Procedure(p)) if defined(view, &p));
    (is_tag || is_procedure).then(|| view.buffer.text.range(word.start, word.end))
}

fn defined(view: &View<'_>, procedure: &str) -> bool {
    !places_of(view, &Name::Procedure(procedure.to_owned()), true).is_empty()
}

/// The changes that give a thing another tag, or a procedure another name.
///
/// # Errors
/// The word is no tag and no procedure, the new name is taken or has no meaning, or a place computes the tag.
pub(crate) fn rename(view: &View<'_>, at: usize, new: &str) -> Result<WorkspaceEdit, String> {
    renamable(view, at).ok_or("only a tag that is written as a number, or a procedure, can be renamed here")?;
    match name_at(view, at) {
        Some(Name::Procedure(name)) if defined(view, &name) => {
            let is_plain = !new.is_empty() && new.chars().all(|c| c.is_alphanumeric() || "_:.-".contains(c));
            if !is_plain {
                return Err(format!("\"{new}\" is no plain name of a procedure"));
            }
            if super::words::command(new).is_some() || defined(view, new) {
                return Err(format!("there is a command \"{new}\" already"));
            }
            let name = Name::Procedure(name);
            let places = places_of(view, &name, true).into_iter().chain(places_of(view, &name, false));
            Ok(edit(places.map(|l| (l.uri, l.range)), new))
        }
        _ => renumbered(view, at, new),
    }
}

/// The changes that give a thing another tag.
fn renumbered(view: &View<'_>, at: usize, new: &str) -> Result<WorkspaceEdit, String> {
    let none = || "nothing with a tag is here".to_owned();
    let (script, things) = things_at(view, at).ok_or_else(none)?;
    let [thing] = things[..] else { return Err(none()) };
    if new.parse::<i32>().is_err() {
        return Err(format!("\"{new}\" is no tag: expected a whole number"));
    }
    let is_taken = |m: &&Mention| m.kind == thing.kind && m.tag == new && m.model == thing.model && m.defines;
    if script.index.mentions.iter().any(|m| is_taken(&m)) {
        return Err(format!("the tag {new} is taken by another {}", thing.kind));
    }
    let mut places = vec![];
    for m in script.uses(thing) {
        let place = script.place(m.span).ok_or_else(none)?;
        let text = script.text(&place.path).and_then(|t| t.get(place.start..place.end)).unwrap_or_default();
        let location = view.location(&place).ok_or("the text has changed since it was checked: try again")?;
        if text != thing.tag {
            let Position { line, .. } = location.range.start;
            let file = uri::file_name(&place.path);
            return Err(format!("{file}, line {}: the tag {} is given by {text}", line + 1, thing.tag));
        }
        places.push((location.uri, location.range));
    }
    Ok(edit(places.into_iter(), new))
}

// The type of the protocol has addresses as keys.
#[allow(clippy::mutable_key_type)]
fn edit(places: impl Iterator<Item = (Uri, Range)>, new: &str) -> WorkspaceEdit {
    let mut by_file: BTreeMap<String, (Uri, Vec<TextEdit>)> = BTreeMap::new();
    for (uri, range) in places {
        let edits = &mut by_file.entry(uri.as_str().to_owned()).or_insert_with(|| (uri, vec![])).1;
        let change = TextEdit { range, new_text: new.to_owned() };
        if !edits.contains(&change) {
            edits.push(change);
        }
    }
    let changes: HashMap<Uri, Vec<TextEdit>> = by_file.into_values().collect();
    WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
}
