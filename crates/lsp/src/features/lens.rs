//! Lenses over a script: run it, look at it, check it.

use crate::buffer::View;
use crate::check::FileKind;
use lsp_types::{CodeLens, Command, Range};

/// The lenses of a file. The editor has the commands: it opens a terminal with `hysteron`.
pub(crate) fn lenses(view: &View<'_>) -> Vec<CodeLens> {
    let commands: &[(&str, &str)] = match FileKind::of(view.path, view.text()) {
        FileKind::Script => &[("Run", "run"), ("View", "view"), ("Check", "check")],
        FileKind::Study => &[("Check", "check"), ("Calibrate", "calibrate"), ("Diagnose", "diagnose")],
        FileKind::Isolation => &[("Check", "check"), ("Run all analyses", "isolate")],
        FileKind::Plan => &[("Run all cases", "batch")],
        FileKind::Python if view.script().is_some() => &[("Check", "check")],
        FileKind::Python | FileKind::Other => &[],
    };
    let lens = |(title, word): &(&str, &str)| {
        let arguments = Some(vec![serde_json::json!(word), serde_json::json!(view.path)]);
        let command = Command { title: (*title).to_owned(), command: "hysteron.command".to_owned(), arguments };
        CodeLens { range: Range::default(), command: Some(command), data: None }
    };
    commands.iter().map(lens).collect()
}
