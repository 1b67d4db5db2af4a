//! What may be written at the cursor.

use super::snippet::{Dimensions, of_usage};
use super::thing;
use super::words::{self, Called};
use crate::buffer::View;
use crate::line::LineBefore;
use crate::script::Script;
use hysteron_opensees::index::CalledCommand;
use hysteron_opensees::things;
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionTextEdit, Documentation, InsertTextFormat, MarkupContent, MarkupKind,
    Range, TextEdit,
};
use std::collections::{BTreeMap, BTreeSet};

/// Names that are offered.
const MAX_ITEMS: usize = 3000;
/// Options of commands whose value is a file.
const FILE_OPTIONS: [&str; 4] = ["-file", "-filePath", "-fileTime", "-source"];

/// The items at a byte.
pub(crate) fn items(view: &View<'_>, at: usize) -> Vec<CompletionItem> {
    if !view.has_commands() {
        return vec![];
    }
    // A point belongs to a number of Tcl, and stands before a command of Python.
    let Some(line) = view.line_before(at).filter(|l| !l.partial.ends_with('.')) else { return vec![] };
    let range = view.buffer.text.range(line.start, at);
    let offer = Offer { view, line: &line, range };
    let mut items = offer.all();
    items.truncate(MAX_ITEMS);
    items
}

struct Offer<'a> {
    view: &'a View<'a>,
    line: &'a LineBefore<'a>,
    range: Range,
}

impl Offer<'_> {
    fn all(&self) -> Vec<CompletionItem> {
        let words = &self.line.words;
        if self.line.partial.contains('$') {
            return self.variables();
        }
        let Some(name) = words.first() else { return self.commands() };
        if *name == "source" || words.last().is_some_and(|w| FILE_OPTIONS.contains(w)) {
            return self.files();
        }
        let Some(called) = Called::of(words) else { return vec![] };
        if words.len() == 1 && !called.command.kinds().is_empty() {
            return self.kinds(&called);
        }
        let mut items = vec![];
        if !self.line.partial.is_empty() && !self.line.partial.starts_with('-') {
            items.extend(self.tags());
            items.extend(self.responses());
            return items;
        }
        if self.line.partial.is_empty() {
            items.extend(self.tags());
            items.extend(self.responses());
        }
        items.extend(self.options(&called));
        items
    }

    /// An item that takes the place of the word that is being written.
    fn item(&self, label: &str, kind: CompletionItemKind, detail: String) -> CompletionItem {
        let is_text = !matches!(kind, CompletionItemKind::FUNCTION | CompletionItemKind::REFERENCE);
        let is_bare = !(self.view.buffer.is_python() && is_text) || self.line.is_quoted;
        let new_text = if is_bare { label.to_owned() } else { format!("'{label}'") };
        CompletionItem {
            label: label.to_owned(),
            kind: Some(kind),
            detail: (!detail.is_empty()).then_some(detail),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: self.range, new_text })),
            ..CompletionItem::default()
        }
    }

    fn with_snippet(&self, item: CompletionItem, snippet: &str) -> CompletionItem {
        if snippet.is_empty() || self.view.buffer.is_python() {
            return item;
        }
        let new_text = format!("{} {snippet}", super::snippet::escaped(&item.label));
        let text_edit = Some(CompletionTextEdit::Edit(TextEdit { range: self.range, new_text }));
        CompletionItem { text_edit, insert_text_format: Some(InsertTextFormat::SNIPPET), ..item }
    }

    fn variables(&self) -> Vec<CompletionItem> {
        let text = self.view.text();
        let syntax = self.view.buffer.syntax();
        let mut names: BTreeMap<String, String> = self.view.script().map(|s| s.variables.clone()).unwrap_or_default();
        names.retain(|name, _| !name.starts_with("tcl_"));
        for c in &syntax.commands {
            if let [head, name, ..] = c.words[..]
                && text.get(head.0..head.1).is_some_and(|w| ["set", "foreach", "for", "lappend"].contains(&w))
                && let Some(name) = text.get(name.0..name.1)
                && name.chars().all(|c| c.is_alphanumeric() || c == '_')
            {
                names.entry(name.to_owned()).or_default();
            }
        }
        // What is before the dollar sign stays.
        let dollar = self.line.partial.rfind('$').unwrap_or(0);
        let start = self.view.buffer.text.position(self.line.start + dollar);
        let range = Range::new(start, self.range.end);
        let item = |(name, value): (String, String)| {
            let label = format!("${name}");
            let edit = TextEdit { range, new_text: label.clone() };
            let item = self.item(&label, CompletionItemKind::VARIABLE, value);
            CompletionItem { text_edit: Some(CompletionTextEdit::Edit(edit)), ..item }
        };
        names.into_iter().map(item).collect()
    }

    fn commands(&self) -> Vec<CompletionItem> {
        let dimensions = dimensions(self.view.script());
        let mut seen = BTreeSet::new();
        let own = hysteron_opensees::commands().filter(|c| seen.insert(c.name)).map(|c| {
            let usage = c.usage_line();
            let item = self.item(c.name, CompletionItemKind::FUNCTION, usage.clone());
            let item = CompletionItem { documentation: markdown(c.text.about), ..item };
            let snippet = if c.kinds().is_empty() { of_usage(&usage, 1, dimensions) } else { String::new() };
            self.with_snippet(item, &snippet)
        });
        let mut items: Vec<CompletionItem> = own.collect();
        if self.view.buffer.is_python() {
            return items;
        }
        for name in words::tcl_commands() {
            items.push(self.item(name, CompletionItemKind::KEYWORD, "Tcl".into()));
        }
        for (name, parameters) in self.procedures() {
            items.push(self.item(name, CompletionItemKind::METHOD, format!("proc {name} {parameters}")));
        }
        items
    }

    /// Procedures of the file, with their parameters.
    fn procedures(&self) -> Vec<(&str, &str)> {
        let text = self.view.text();
        let word = |w: (usize, usize)| text.get(w.0..w.1).unwrap_or_default();
        let found = self.view.buffer.syntax().commands.iter().filter_map(|c| match c.words[..] {
            [head, name, parameters, ..] if word(head) == "proc" => Some((word(name), word(parameters))),
            _ => None,
        });
        found.collect()
    }

    fn kinds(&self, called: &Called) -> Vec<CompletionItem> {
        let dimensions = dimensions(self.view.script());
        let item = |kind: &hysteron_opensees::KindUsage| {
            let item = self.item(kind.names[0], CompletionItemKind::CLASS, kind.usage.to_owned());
            let filter_text = Some(kind.names.join(" "));
            let item = CompletionItem { documentation: markdown(kind.text.about), filter_text, ..item };
            self.with_snippet(item, &of_usage(kind.usage, 2, dimensions))
        };
        called.command.kinds().iter().map(item).collect()
    }

    fn options(&self, called: &Called) -> Vec<CompletionItem> {
        let mut seen = BTreeSet::new();
        let item = |a: &crate::reference::Argument| {
            let option = a.option()?;
            let is_new = seen.insert(option.to_owned());
            let detail = format!("{} {}", a.name, a.meaning);
            is_new.then(|| self.item(option, CompletionItemKind::PROPERTY, detail))
        };
        called.arguments().iter().filter_map(item).collect()
    }

    /// Tags of the things that other commands of the kind name at this place; those of all things where there are none.
    fn tags(&self) -> Vec<CompletionItem> {
        let Some(script) = self.view.script().filter(|_| !self.line.is_quoted) else { return vec![] };
        let kinds = self.kinds_named_here(script);
        let mut known: BTreeSet<(&str, i64)> = BTreeSet::new();
        for m in script.index.mentions.iter().filter(|m| m.defines && (kinds.is_empty() || kinds.contains(m.kind))) {
            known.extend(m.tag.parse().ok().map(|tag: i64| (m.kind, tag)));
        }
        let mut defined: BTreeMap<(&str, &str), &CalledCommand> = BTreeMap::new();
        for c in &script.index.commands {
            c.defines.iter().for_each(|(kind, tag)| _ = defined.entry((kind, tag)).or_insert(c));
        }
        let item = |(kind, tag): (&str, i64)| {
            let label = tag.to_string();
            let command = defined.get(&(kind, label.as_str()));
            let detail = command.map(|c| super::hover::in_one_line(self.view, c)).unwrap_or_default();
            let item = self.item(&label, CompletionItemKind::REFERENCE, format!("{kind}: {detail}"));
            CompletionItem { sort_text: Some(format!("{kind}{tag:010}")), ..item }
        };
        known.into_iter().take(MAX_ITEMS).map(item).collect()
    }

    /// Kinds of things that the words at this place name in other calls of the same command and kind.
    fn kinds_named_here(&self, script: &Script) -> BTreeSet<&'static str> {
        let (name, kind) = (self.line.words.first().copied().unwrap_or_default(), self.line.words.get(1));
        let option = self.line.words.last().filter(|w| w.starts_with('-') && w.parse::<f64>().is_err());
        let has_kinds = words::command(name).is_some_and(|c| !c.kinds().is_empty());
        let is_same = |c: &&CalledCommand| {
            c.command.name == name && (!has_kinds || c.words.get(1).map(|w| w.value.as_str()) == kind.copied())
        };
        let mut kinds = BTreeSet::new();
        for c in script.index.commands.iter().filter(is_same).take(50) {
            let place = match option {
                Some(option) => c.words.iter().position(|w| w.value == *option).map(|i| i + 1),
                None => Some(self.line.words.len()),
            };
            let span = place.and_then(|i| c.words.get(i)?.span);
            kinds.extend(script.index.mentions.iter().filter(|m| Some(m.span) == span && !m.defines).map(|m| m.kind));
        }
        kinds
    }

    /// Responses of the elements that a recorder names.
    fn responses(&self) -> Vec<CompletionItem> {
        let words = &self.line.words;
        if !["recorder", "eleResponse"].contains(words.first().unwrap_or(&"")) {
            return vec![];
        }
        let is_recorder = words.first() == Some(&"recorder");
        let named = words.iter().position(|w| *w == "-ele").map_or(1, |i| i + 1);
        let tag = if is_recorder { words.get(named) } else { words.get(1) };
        let model = self.view.script().and_then(|s| s.index.models.last());
        let names = model.zip(tag.and_then(|t| t.parse().ok())).map(|(m, tag)| thing::responses(&m.model, tag));
        let names = names.unwrap_or_default();
        names
            .iter()
            .map(|n| self.item(n, CompletionItemKind::FIELD, format!("response of the {}", things::ELEMENT)))
            .collect()
    }

    /// Files and folders of the folder that is being written.
    fn files(&self) -> Vec<CompletionItem> {
        let written = self.line.partial.trim_start_matches(['"', '{']);
        let (folder, _) = written.rsplit_once('/').unwrap_or(("", written));
        let place = crate::uri::joined(crate::uri::folder(self.view.path), folder);
        let mut names = hysteron_files::list(&place).unwrap_or_default();
        names.retain(|n| !n.starts_with('.'));
        names.sort();
        let lead = if folder.is_empty() { String::new() } else { format!("{folder}/") };
        names.iter().map(|n| self.item(&format!("{lead}{n}"), CompletionItemKind::FILE, String::new())).collect()
    }
}

fn markdown(text: &str) -> Option<Documentation> {
    let content = || MarkupContent { kind: MarkupKind::Markdown, value: text.to_owned() };
    (!text.is_empty()).then(|| Documentation::MarkupContent(content()))
}

/// Dimensions of the last model of a script.
pub(crate) fn dimensions(script: Option<&Script>) -> Option<Dimensions> {
    let kinds = |c: &&CalledCommand| c.command.definition().0.contains(&things::MODEL);
    let command = script?.index.commands.iter().rev().find(kinds)?;
    let after = |name: &str| {
        let at = command.words.iter().position(|w| w.value.eq_ignore_ascii_case(name))?;
        command.words.get(at + 1)?.value.parse::<usize>().ok()
    };
    let ndm = after("-ndm").filter(|n| (1..=3).contains(n))?;
    Some(Dimensions { ndm, ndf: after("-ndf").unwrap_or(ndm * (ndm + 1) / 2) })
}
