//! The usage of the command that is being written, and the argument at the cursor.

use super::completion::dimensions;
use super::snippet;
use super::words::Called;
use crate::buffer::View;
use crate::line::LineBefore;
use lsp_types::{Documentation, ParameterInformation, ParameterLabel, SignatureHelp, SignatureInformation};

/// The usage of the command before a byte.
pub(crate) fn help(view: &View<'_>, at: usize) -> Option<SignatureHelp> {
    if !view.has_commands() {
        return None;
    }
    let line = view.line_before(at)?;
    let called = Called::of(&line.words)?;
    let usage = called.usage();
    let arguments = called.arguments();
    let meaning = |name: &str| {
        let found = arguments.iter().find(|a| a.name.trim_matches(['<', '>']) == name.trim_matches(['<', '>']));
        found.map(|a| Documentation::String(a.meaning.clone()))
    };
    let form = snippet::form(&usage, dimensions(view.script()));
    let offset = usage.find(form).unwrap_or(0);
    let words = snippet::words(form);
    let mut parameters = vec![];
    for word in &words {
        let start = offset + word.text.as_ptr() as usize - form.as_ptr() as usize;
        let units = |at: usize| usage.get(..at).map_or(0, |t| t.encode_utf16().count() as u32);
        let label = ParameterLabel::LabelOffsets([units(start), units(start + word.text.len())]);
        parameters.push(ParameterInformation { label, documentation: meaning(word.text) });
    }
    let active = active(&line, &words);
    let documentation = called.section().map(|s| Documentation::String(s.summary().to_owned()));
    let signature = SignatureInformation {
        label: usage,
        documentation,
        parameters: Some(parameters),
        active_parameter: active.map(|a| a as u32),
    };
    Some(SignatureHelp {
        signatures: vec![signature],
        active_signature: Some(0),
        active_parameter: active.map(|a| a as u32),
    })
}

/// The word of the usage at the cursor: the option that is being written, or the one at its position.
fn active(line: &LineBefore<'_>, usage: &[snippet::UsageWord<'_>]) -> Option<usize> {
    let option = |word: &str| {
        let is_it = |u: &snippet::UsageWord<'_>| {
            let bare = u.text.trim_matches(['<', '>']);
            bare.split(' ').next() == Some(word)
        };
        usage.iter().position(is_it).filter(|_| word.starts_with('-') && word.parse::<f64>().is_err())
    };
    let last = line.words.iter().rev().take(2).find_map(|w| option(w));
    option(line.partial).or(last).or_else(|| Some(line.words.len()).filter(|at| *at < usage.len()))
}
