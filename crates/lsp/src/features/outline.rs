//! The parts of a script, and what of it can be folded.

use crate::buffer::View;
use hysteron_opensees::index::{CalledCommand, Mention};
use lsp_types::{DocumentSymbol, FoldingRange, FoldingRangeKind, SymbolKind};
use std::collections::BTreeMap;

/// Tags that the name of a loop lists.
const MAX_TAGS: usize = 4;

/// The outline of a file: its things by kind, and its procedures.
pub(crate) fn symbols(view: &View<'_>) -> Vec<DocumentSymbol> {
    let mut groups: BTreeMap<String, Vec<DocumentSymbol>> = BTreeMap::new();
    for (kind, symbol) in things(view) {
        groups.entry(kind.to_owned()).or_default().push(symbol);
    }
    let procedures = procedures(view);
    if !procedures.is_empty() {
        groups.insert("procedure".to_owned(), procedures);
    }
    let mut all: Vec<DocumentSymbol> = groups.into_iter().filter_map(|(kind, of_kind)| group(&kind, of_kind)).collect();
    all.sort_by_key(|s| s.range.start.line);
    all
}

/// A symbol with others in it.
fn group(kind: &str, mut children: Vec<DocumentSymbol>) -> Option<DocumentSymbol> {
    children.sort_by_key(|s| (s.range.start.line, s.range.start.character));
    let (first, last) =
        (children.first()?.range, children.iter().map(|c| c.range.end).max_by_key(|p| (p.line, p.character))?);
    let range = lsp_types::Range::new(first.start, last);
    let detail = Some(children.len().to_string());
    Some(symbol(kind.to_owned(), detail, SymbolKind::NAMESPACE, range, first, Some(children)))
}

#[allow(deprecated)]
fn symbol(
    name: String,
    detail: Option<String>,
    kind: SymbolKind,
    range: lsp_types::Range,
    selection_range: lsp_types::Range,
    children: Option<Vec<DocumentSymbol>>,
) -> DocumentSymbol {
    DocumentSymbol { name, detail, kind, tags: None, deprecated: None, range, selection_range, children }
}

/// Commands that define things, each once, with the tags of all its calls.
fn things<'a>(view: &View<'a>) -> Vec<(&'static str, DocumentSymbol)> {
    let Some(script) = view.script() else { return vec![] };
    let mut by_place: BTreeMap<(u32, u32), Vec<&'a Mention>> = BTreeMap::new();
    for m in script.mentions(view.path).filter(|m| m.defines) {
        by_place.entry((m.span.start, m.span.end)).or_default().push(m);
    }
    let text = &view.buffer.text;
    let mut all = vec![];
    for c in script.commands(view.path) {
        let (_, at) = c.command.definition();
        let Some(span) = c.words.get(at).and_then(|w| w.span).filter(|_| at > 0) else { continue };
        let Some(mentions) = by_place.remove(&(span.start, span.end)) else { continue };
        let places = [c.span.start, c.span.end, span.start, span.end].map(|at| view.current(at as usize));
        let [Some(start), Some(end), Some(name), Some(name_end)] = places else { continue };
        let kind = mentions[0].kind;
        let name = symbol(
            named(kind, &mentions),
            Some(kind_word(c)),
            SymbolKind::OBJECT,
            text.range(start, end),
            text.range(name, name_end),
            None,
        );
        all.push((kind, name));
    }
    all
}

/// `node 1`, `node 1 2 3 4 ... 40`.
fn named(kind: &str, mentions: &[&Mention]) -> String {
    let mut tags: Vec<&str> = mentions.iter().filter(|m| m.kind == kind).map(|m| m.tag.as_str()).collect();
    tags.dedup();
    match tags[..] {
        [.., last] if tags.len() > MAX_TAGS => format!("{kind} {} ... {last}", tags[..MAX_TAGS - 1].join(" ")),
        _ => format!("{kind} {}", tags.join(" ")),
    }
}

/// The kind that a command makes, where it has kinds.
fn kind_word(c: &CalledCommand) -> String {
    let has_kinds = !c.command.kinds().is_empty();
    c.words.get(1).filter(|_| has_kinds).map(|w| w.value.clone()).unwrap_or_default()
}

fn procedures(view: &View<'_>) -> Vec<DocumentSymbol> {
    let text = view.text();
    let found = view.buffer.syntax().commands.iter().filter_map(|c| {
        let [head, name, parameters, ..] = c.words[..] else { return None };
        let word = |w: (usize, usize)| text.get(w.0..w.1).unwrap_or_default();
        let range = view.buffer.text.range(c.start, c.end);
        let at = view.buffer.text.range(name.0, name.1);
        let detail = Some(word(parameters).to_owned());
        (word(head) == "proc" && !word(name).is_empty())
            .then(|| symbol(word(name).to_owned(), detail, SymbolKind::FUNCTION, range, at, None))
    });
    found.collect()
}

/// Bodies and comments of several lines.
pub(crate) fn foldings(view: &View<'_>) -> Vec<FoldingRange> {
    // Blocks of Python are the editor's own.
    if view.buffer.is_python() {
        return vec![];
    }
    let text = &view.buffer.text;
    let mut all: BTreeMap<u32, FoldingRange> = BTreeMap::new();
    let mut fold = |first: usize, last: usize, kind: FoldingRangeKind| {
        if last > first {
            let (start_line, end_line) = (first as u32, last as u32);
            let range = FoldingRange { start_line, end_line, kind: Some(kind), ..FoldingRange::default() };
            let known = all.entry(start_line).or_insert_with(|| range.clone());
            known.end_line = known.end_line.max(end_line);
        }
    };
    for c in &view.buffer.syntax().commands {
        for (start, end) in &c.words {
            let braced = view.text().get(*start..*end).is_some_and(|w| w.starts_with('{') && w.ends_with('}'));
            if braced {
                // The line of the closing brace stays.
                fold(text.line_of(*start), text.line_of(*end).saturating_sub(1), FoldingRangeKind::Region);
            }
        }
    }
    let is_comment = |n: usize| text.line(n).trim_start().starts_with('#');
    let mut n = 0;
    while n < text.line_count() {
        let first = n;
        while n < text.line_count() && is_comment(n) {
            n += 1;
        }
        fold(first, n.saturating_sub(1), FoldingRangeKind::Comment);
        n = n.max(first + 1);
    }
    all.into_values().collect()
}
