//! Keys of a study, from the schema that the reference has.

use crate::buffer::View;
use crate::check::FileKind;
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

/// The keys of the table in whose part of the text a line is.
fn keys(view: &View<'_>, line: usize) -> Option<&'static serde_json::Map<String, Json>> {
    let heading = (0..=line).rev().map(|n| view.buffer.text.line(n).trim()).find(|l| l.starts_with('['));
    let name = heading.map_or("", |h| h.trim_matches(['[', ']']).trim());
    let mut table = schema();
    for key in name.split('.').filter(|k| !k.is_empty()) {
        table = resolved(table.pointer(&format!("/properties/{key}"))?);
    }
    table.get("properties")?.as_object()
}

fn is_study(view: &View<'_>) -> bool {
    FileKind::of(view.path, view.text()) == FileKind::Study
}

/// What a key says, with its values.
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
    if !is_study(view) {
        return None;
    }
    let line = view.buffer.text.line_of(at);
    let text = view.buffer.text.line(line);
    let own = view.buffer.text.line_range(line);
    let name = text.split('=').next()?.trim();
    let start = own.start + text.find(name).filter(|_| !name.is_empty())?;
    if name.starts_with('[') || at < start || at > start + name.len() {
        return None;
    }
    let value = format!("**{name}** {}", described(keys(view, line)?.get(name)?));
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
    Some(Hover { contents, range: Some(view.buffer.text.range(start, start + name.len())) })
}

/// The keys, or the values of a key, that may be written at a byte.
pub(crate) fn completion(view: &View<'_>, at: usize) -> Vec<CompletionItem> {
    if !is_study(view) {
        return vec![];
    }
    let line = view.buffer.text.line_of(at);
    let before = view.text().get(view.buffer.text.line_range(line).start..at).unwrap_or_default();
    let Some(keys) = keys(view, line) else { return vec![] };
    let item = |label: String, kind, detail: String| CompletionItem {
        label,
        kind: Some(kind),
        detail: (!detail.is_empty()).then_some(detail),
        ..CompletionItem::default()
    };
    match before.split_once('=') {
        None => keys.iter().map(|(k, v)| item(k.clone(), CompletionItemKind::PROPERTY, described(v))).collect(),
        Some((key, _)) => {
            let values = keys.get(key.trim()).and_then(|k| k.get("enum")).and_then(Json::as_array);
            let of = |v: &Json| item(v.to_string(), CompletionItemKind::VALUE, String::new());
            values.into_iter().flatten().map(of).collect()
        }
    }
}
