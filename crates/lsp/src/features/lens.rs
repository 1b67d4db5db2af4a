//! Lenses over a script: run it, look at it, check it; over a bearing: plot its loop.

use crate::buffer::View;
use crate::check::FileKind;
use crate::script::Script;
use hysteron_engine::model::Tag;
use hysteron_opensees::index::CalledCommand;
use hysteron_opensees::{may_isolate, things};
use lsp_types::{CodeLens, Command, Range};
use serde_json::{Value as Json, json};

/// Bearings over which a lens stands.
const MAX_BEARINGS: usize = 200;

/// The lenses of a file. The editor has the commands: it opens a terminal with `hysteron`.
pub(crate) fn lenses(view: &View<'_>) -> Vec<CodeLens> {
    let kind = FileKind::of(view.path, view.text());
    let commands: &[(&str, &str)] = match kind {
        FileKind::Script => &[("Run", "run"), ("View", "view"), ("Check", "check")],
        FileKind::Study => &[("Check", "check"), ("Calibrate", "calibrate"), ("Diagnose", "diagnose")],
        FileKind::Isolation => &[("Check", "check"), ("Run all analyses", "isolate")],
        FileKind::Plan => &[("Check", "check"), ("Run all cases", "batch")],
        FileKind::Python if view.script().is_some() => &[("Check", "check")],
        FileKind::Python | FileKind::Other => &[],
    };
    let of_file = commands
        .iter()
        .map(|(title, word)| lens(Range::default(), (*title).to_owned(), vec![json!(word), json!(view.path)]));
    let script = view.script().filter(|_| kind == FileKind::Script);
    of_file.chain(script.into_iter().flat_map(|script| bearings(view, script))).collect()
}

fn lens(range: Range, title: String, arguments: Vec<Json>) -> CodeLens {
    let command = Command { title, command: "hysteron.command".to_owned(), arguments: Some(arguments) };
    CodeLens { range, command: Some(command), data: None }
}

/// A lens over each command that makes a bearing.
fn bearings(view: &View<'_>, script: &Script) -> Vec<CodeLens> {
    let of = |c: &CalledCommand| {
        let tag = bearing(script, c)?;
        let range = view.location(&script.place(c.span)?)?.range;
        let arguments = vec![json!("bearing"), json!(view.path), json!(tag)];
        Some(lens(Range { end: range.start, ..range }, format!("Plot the loop of bearing {tag}"), arguments))
    };
    script.commands(view.path).filter_map(of).take(MAX_BEARINGS).collect()
}

/// The tag of the bearing that a command has made first.
fn bearing(script: &Script, command: &CalledCommand) -> Option<Tag> {
    let (_, tag) = command.defines.iter().find(|(kind, _)| *kind == things::ELEMENT)?;
    let (tag, model) = (tag.parse().ok()?, &script.index.models.get(command.model)?.model);
    let entry = model.elements.get(model.element(tag)?.0)?;
    (may_isolate(entry) && entry.nodes.len() == 2).then_some(tag)
}
