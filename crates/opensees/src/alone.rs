//! An element between two nodes alone: the commands that make it, with what they name, taken out of a script.

use crate::index::{CalledCommand, Definition, Index, IndexedModel, Mention};
use crate::things;
use hysteron_engine::model::Tag;
use hysteron_tcl::Value;
use hysteron_tcl::diagnostic::Span;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Words of `element` before its first node.
const FIRST_NODE: usize = 3;
/// Tags that an error lists.
const MAX_TAGS: usize = 8;

/// A script that makes an element of another script alone, as element 1 between nodes 1 and 2: the nodes with their
/// coordinates, and the definitions that the words of the element name. The index keeps definitions.
///
/// # Errors
/// No call makes an element of the tag, it does not join two nodes, or it is amended afterwards.
pub fn element_alone(index: &Index, tag: Tag) -> Result<String, String> {
    let is_it = |d: &&Definition| d.things.iter().any(|(kind, t)| *kind == things::ELEMENT && *t == tag.to_string());
    let found = index.definitions.iter().enumerate().rev().find(|(_, d)| is_it(d));
    let (at, element) = found.ok_or_else(|| no_element(index, tag))?;
    let model = &index.models.get(element.model).ok_or_else(|| no_element(index, tag))?.model;
    let entry = model.element(tag).map(|id| &model.elements[id.0]);
    let nodes = entry.map(|e| e.nodes.as_slice()).unwrap_or_default();
    let &[i, j] = nodes else { return Err(format!("element {tag} does not join two nodes: a test moves one of two")) };
    let (i, j) = (&model.nodes[i.0], &model.nodes[j.0]);
    let asked = if i.ndm() == 2 { 3 } else { 6 };
    if i.ndf != asked {
        return Err(format!("the nodes of element {tag} have {} degrees of freedom: a test needs {asked}", i.ndf));
    }
    if is_amended(index, tag) {
        return Err(format!("element {tag} is amended, which is not taken along: amend it in a script of its own"));
    }
    let mut words = element.words.clone();
    let named: Vec<Option<i64>> =
        (0..2).map(|k| words.get(FIRST_NODE + k).and_then(|w| Value::from(w.as_str()).as_i64())).collect();
    if named != [Some(i64::from(i.tag)), Some(i64::from(j.tag))] {
        return Err(format!("the words of element {tag} do not begin with its two nodes"));
    }
    for (place, word) in [(FIRST_NODE - 1, "1"), (FIRST_NODE, "1"), (FIRST_NODE + 1, "2")] {
        word.clone_into(&mut words[place]);
    }
    let mut out = format!("model BasicBuilder -ndm {} -ndf {}\n", i.ndm(), i.ndf);
    for (name, node) in [(1, i), (2, j)] {
        let coords: Vec<String> = node.coords.iter().map(ToString::to_string).collect();
        let _ = writeln!(out, "node {name} {}", coords.join(" "));
    }
    for d in needed(&index.definitions[..at], element) {
        let _ = writeln!(out, "{}", command(&d.words));
    }
    let _ = writeln!(out, "{}", command(&words));
    Ok(out)
}

/// Returns true if a command amends an element: it names the element, and adds to what is there.
fn is_amended(index: &Index, tag: Tag) -> bool {
    let amends = |c: &&CalledCommand| c.command.name == "amend";
    let spans: Vec<Span> = index.commands.iter().filter(amends).map(|c| c.span).collect();
    let within = |m: &Mention, c: &Span| c.source == m.span.source && c.start <= m.span.start && m.span.end <= c.end;
    let names_it = |m: &&Mention| m.kind == things::ELEMENT && m.tag == tag.to_string();
    index.mentions.iter().filter(names_it).any(|m| spans.iter().any(|c| within(m, c)))
}

/// Definitions that one names, and those that these name, in the order of their calls.
fn needed<'a>(before: &'a [Definition], of: &Definition) -> Vec<&'a Definition> {
    let is_definition = |kind: &str| kind != things::NODE && kind != things::ELEMENT;
    let mut wanted: BTreeSet<(&'static str, String)> = of.names.iter().cloned().collect();
    let mut found = vec![];
    for d in before.iter().rev().filter(|d| d.model == of.model) {
        let mine = |thing: &&(&'static str, String)| is_definition(thing.0) && wanted.contains(*thing);
        let mine: Vec<_> = d.things.iter().filter(mine).collect();
        if mine.is_empty() {
            continue;
        }
        mine.into_iter().for_each(|thing| {
            wanted.remove(thing);
        });
        wanted.extend(d.names.iter().cloned());
        found.push(d);
    }
    found.reverse();
    found
}

/// The words of a command as a line of a script.
fn command(words: &[String]) -> String {
    Value::list(words.iter().map(|w| Value::from(w.as_str()))).as_str().into_owned()
}

fn no_element(index: &Index, tag: Tag) -> String {
    let tags = |m: &IndexedModel| m.model.elements.iter().map(|e| e.tag.to_string()).collect::<Vec<_>>();
    let all: Vec<String> = index.models.iter().rev().flat_map(tags).collect();
    let more = if all.len() > MAX_TAGS { ", ..." } else { "" };
    let known = match &all[..all.len().min(MAX_TAGS)] {
        [] => "it has no elements".to_owned(),
        some => format!("its elements are {}{more}", some.join(", ")),
    };
    format!("the script makes no element {tag}: {known}")
}
