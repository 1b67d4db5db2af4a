//! The user's script with the edits of a proposal, and with fitted values in its `pset` commands.

use super::proposal::{Proposal, TextEdit};
use super::variant::Variant;
use crate::inspect::insertion::{InsertionPoint, insert};

/// Text of `corrected.tcl` at values of all parameters of a variant.
///
/// `value_places` are byte ranges of the values of the user's own parameters in `text`.
pub(crate) fn repaired_script(
    text: &str,
    value_places: &[Option<(usize, usize)>],
    point: &InsertionPoint,
    variant: &Variant,
    values: &[f64],
) -> String {
    let (own, added) = variant.split(values);
    let places = value_places.iter().zip(own).filter_map(|(p, v)| p.map(|(start, end)| (start, end, v)));
    let fitted = places.map(|(start, end, value)| TextEdit { start, end, text: format!("{value:?}") });
    edited_script(text, point, variant.proposal.as_ref(), added, fitted.collect())
}

/// A script with the edits and commands of a proposal at values of its parameters, and with further edits.
pub(crate) fn edited_script(
    text: &str,
    point: &InsertionPoint,
    proposal: Option<&Proposal>,
    values: &[f64],
    mut edits: Vec<TextEdit>,
) -> String {
    if let Some((p, at)) = proposal.and_then(|p| Some((p, p.declared_at?))) {
        let line = text[..at].rfind('\n').map_or(0, |i| i + 1);
        // Commands in front of the first edited one on its line stay in front of it.
        let at = if text[line..at].trim().is_empty() { line } else { at };
        edits.push(TextEdit { start: at, end: at, text: p.declarations(values).join("\n") + "\n" });
        edits.extend(p.option_edits.iter().cloned());
    }
    edits.retain(|e| text.get(e.start..e.end).is_some());
    edits.sort_by_key(|e| (e.start, e.end));
    let moved = |byte: usize| {
        let before = edits.iter().filter(|e| e.start < byte);
        before.fold(byte, |byte, e| byte + e.text.len() - (e.end - e.start))
    };
    let point = match point {
        InsertionPoint::At(byte) => InsertionPoint::At(moved(*byte)),
        InsertionPoint::FirstAnalyze => InsertionPoint::FirstAnalyze,
    };
    let mut out = text.to_owned();
    // From the end on, so that earlier places stay valid.
    for e in edits.iter().rev() {
        out.replace_range(e.start..e.end, &e.text);
    }
    match proposal {
        Some(p) if !p.commands.is_empty() => insert(&out, &point, &p.inserted_commands(values)),
        _ => out,
    }
}
