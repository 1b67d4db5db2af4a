//! Keys of studies, from the schema and the page that the reference has.

use crate::buffer::View;
use crate::check::FileKind;
use crate::reference::cells;
use lsp_types::{CompletionItem, CompletionItemKind, Hover, HoverContents, MarkupContent, MarkupKind};
use serde_json::Value as Json;
use std::sync::OnceLock;

/// The schema of the file of a study.
fn schema() -> &'static Json {
    static SCHEMA: OnceLock<Json> = OnceLock::new();
    SCHEMA.get_or_init(|| {
        serde_json::from_str(include_str!("../../../../docs/reference/study.schema.json")).unwrap_or_default()
    })
}

/// A part of the schema, behind its reference and its items.
fn resolved(mut part: &'static Json) -> &'static Json {
    for _ in 0..8 {
        let next = match (part.get("$ref").and_then(Json::as_str), part.get("items")) {
            (Some(r), _) => schema().pointer(r.trim_start_matches('#')),
            (None, items) => items,
        };
        match next {
            Some(next) => part = next,
            None => break,
        }
    }
    part
}

/// A key of a table.
struct Key {
    name: String,
    /// Its meaning in a sentence or more.
    meaning: String,
    /// Values that it may have, as they are written.
    values: Vec<String>,
}

/// The keys of the table in whose part of the text a line is; none where they are not known.
fn keys(view: &View<'_>, line: usize) -> Vec<Key> {
    let heading = (0..=line).rev().map(|n| view.buffer.text.line(n).trim()).find(|l| l.starts_with('['));
    let table = heading.map_or("", |h| h.split('#').next().unwrap_or_default().trim().trim_matches(['[', ']']).trim());
    match FileKind::of(view.path, view.text()) {
        FileKind::Study => keys_of_schema(table).unwrap_or_default(),
        FileKind::Isolation => keys_of_page(table),
        FileKind::Script | FileKind::Python | FileKind::Plan | FileKind::Other => vec![],
    }
}

/// Keys of a table of a calibration study.
fn keys_of_schema(table: &str) -> Option<Vec<Key>> {
    let mut part = schema();
    for key in table.split('.').filter(|k| !k.is_empty()) {
        part = resolved(part.pointer(&format!("/properties/{key}"))?);
    }
    let values =
        |key: &Json| key.get("enum").and_then(Json::as_array).into_iter().flatten().map(Json::to_string).collect();
    let key = |(name, key): (&String, &Json)| Key { name: name.clone(), meaning: described(key), values: values(key) };
    Some(part.get("properties")?.as_object()?.iter().map(key).collect())
}

/// Keys of a table of an isolation study: the page of the reference has them.
fn keys_of_page(table: &str) -> Vec<Key> {
    const PAGE: &str = include_str!("../../../../docs/reference/isolation-keys.md");
    let is_it = |section: &&str| {
        let heading = section.lines().next().unwrap_or_default();
        let name = heading.split('`').nth(1).map_or("", |h| h.trim_matches(['[', ']']));
        name == table
    };
    let section = PAGE.split("\n## ").skip(1).find(is_it).unwrap_or_default();
    let rows = section.lines().filter_map(cells).filter(|row| row[0].starts_with('`'));
    let key = |row: Vec<String>| {
        let cell = |i: usize| row.get(i).map_or("", String::as_str);
        let needed = if cell(2).is_empty() { "" } else { " It is needed." };
        let meaning = format!("{} ({}){needed}", cell(3), cell(1));
        Key { name: cell(0).trim_matches('`').to_owned(), meaning, values: vec![] }
    };
    rows.map(key).collect()
}

/// What a key of the schema says, with its values.
fn described(key: &Json) -> String {
    let text = |name: &str| key.get(name).map(|v| v.as_str().map_or_else(|| v.to_string(), str::to_owned));
    let mut out = text("description").or_else(|| resolved_text(key)).unwrap_or_default();
    if let Some(values) = key.get("enum").and_then(Json::as_array) {
        let values: Vec<String> = values.iter().map(ToString::to_string).collect();
        out += &format!(" One of {}.", values.join(", "));
    }
    if let Some(own) = text("default") {
        out += &format!(" Default: {own}.");
    }
    out
}

fn resolved_text(key: &Json) -> Option<String> {
    let target = key.get("$ref").or_else(|| key.pointer("/items/$ref"))?.as_str()?;
    let part = schema().pointer(target.trim_start_matches('#'))?;
    part.get("description")?.as_str().map(str::to_owned)
}

/// The key around a byte.
pub(crate) fn hover(view: &View<'_>, at: usize) -> Option<Hover> {
    let line = view.buffer.text.line_of(at);
    let text = view.buffer.text.line(line);
    let own = view.buffer.text.line_range(line);
    let name = text.split('=').next()?.trim();
    let start = own.start + text.find(name).filter(|_| !name.is_empty())?;
    if at < start || at > start + name.len() {
        return None;
    }
    let key = keys(view, line).into_iter().find(|k| k.name == name)?;
    let value = format!("**{name}** {}", key.meaning);
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
    Some(Hover { contents, range: Some(view.buffer.text.range(start, start + name.len())) })
}

/// The keys, or the values of a key, that may be written at a byte.
pub(crate) fn completion(view: &View<'_>, at: usize) -> Vec<CompletionItem> {
    let line = view.buffer.text.line_of(at);
    let before = view.text().get(view.buffer.text.line_range(line).start..at).unwrap_or_default();
    let keys = keys(view, line);
    let item = |label: String, kind, detail: String| CompletionItem {
        label,
        kind: Some(kind),
        detail: (!detail.is_empty()).then_some(detail),
        ..CompletionItem::default()
    };
    match before.split_once('=') {
        None => keys.into_iter().map(|k| item(k.name, CompletionItemKind::PROPERTY, k.meaning)).collect(),
        Some((name, _)) => {
            let key = keys.into_iter().find(|k| k.name == name.trim());
            let values = key.map(|k| k.values).unwrap_or_default();
            values.into_iter().map(|v| item(v, CompletionItemKind::VALUE, String::new())).collect()
        }
    }
}
