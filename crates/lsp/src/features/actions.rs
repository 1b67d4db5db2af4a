//! Changes that put findings right.

use crate::buffer::View;
use crate::finding::Finding;
use lsp_types::{CodeAction, CodeActionKind, CodeActionOrCommand, Range, TextEdit, Uri, WorkspaceEdit};
use std::collections::HashMap;

/// The actions for findings within a range.
// The type of the protocol has addresses as keys.
#[allow(clippy::mutable_key_type)]
pub(crate) fn actions(view: &View<'_>, range: Range) -> Vec<CodeActionOrCommand> {
    let Some(known) = view.known else { return vec![] };
    let Some(text) = known.checked.texts.get(view.path) else { return vec![] };
    let shift = crate::text::Shift::between(text, view.text());
    let (from, to) = (view.buffer.text.offset(range.start), view.buffer.text.offset(range.end));
    let action = |f: &Finding| {
        let (place, near) = f.replacement.as_ref().filter(|(place, _)| place.path == view.path)?;
        let whole = (shift.forward(f.place.start)?, shift.forward(f.place.end)?);
        let (start, end) = (shift.forward(place.start)?, shift.forward(place.end)?);
        if whole.1 < from || to < whole.0 {
            return None;
        }
        let edit = TextEdit { range: view.buffer.text.range(start, end), new_text: near.clone() };
        let changes: HashMap<Uri, Vec<TextEdit>> = HashMap::from([(view.buffer.uri.clone(), vec![edit])]);
        let edit = Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() });
        let (title, kind) = (format!("Replace by {near}"), Some(CodeActionKind::QUICKFIX));
        Some(CodeActionOrCommand::CodeAction(CodeAction {
            title,
            kind,
            edit,
            is_preferred: Some(true),
            ..CodeAction::default()
        }))
    };
    known.checked.findings.iter().filter_map(action).collect()
}
