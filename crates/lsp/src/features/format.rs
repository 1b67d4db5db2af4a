//! Formatting of blanks: those at the ends of lines, and those before commands within bodies. No word changes.

use crate::buffer::View;
use lsp_types::{FormattingOptions, Range, TextEdit};
use std::collections::{BTreeMap, BTreeSet};

/// Words that are bodies of commands of Tcl: the name, and the first word that may be one.
const BODIES: [(&str, usize); 9] = [
    ("if", 2),
    ("while", 2),
    ("for", 4),
    ("foreach", 3),
    ("proc", 3),
    ("namespace", 3),
    ("pattern", 3),
    ("section", 3),
    ("catch", 1),
];

/// The changes that format a file.
pub(crate) fn edits(view: &View<'_>, options: &FormattingOptions) -> Vec<TextEdit> {
    let text = &view.buffer.text;
    let unit = if options.insert_spaces { " ".repeat(options.tab_size.clamp(1, 16) as usize) } else { "\t".to_owned() };
    let (levels, open) = (levels(view), within_words(view));
    let mut edits = vec![];
    for n in 0..text.line_count() {
        let (line, range) = (text.line(n), text.line_range(n));
        let kept = line.trim_end();
        if let Some(level) = levels.get(&n).filter(|_| !kept.is_empty()) {
            let own = kept.len() - kept.trim_start().len();
            let wanted = unit.repeat(*level);
            if kept[..own] != wanted {
                edits.push(TextEdit { range: text.range(range.start, range.start + own), new_text: wanted });
            }
        }
        // A backslash before a blank has a meaning of its own.
        if kept.len() < line.len() && !kept.ends_with('\\') && !open.contains(&n) {
            let start = text.position(range.start + kept.len());
            edits.push(TextEdit { range: Range::new(start, text.position(range.end)), new_text: String::new() });
        }
    }
    edits
}

/// The level of each line that begins a command, is a comment among them, or closes a body. Other lines belong to a word, whose
/// blanks may have a meaning.
fn levels(view: &View<'_>) -> BTreeMap<usize, usize> {
    let text = &view.buffer.text;
    let syntax = view.buffer.syntax();
    let mut levels = BTreeMap::new();
    let mut depths: Vec<Option<usize>> = vec![];
    for (i, c) in syntax.commands.iter().enumerate() {
        // Commands come before those in their words.
        let depth = match c.parent {
            None => Some(0),
            Some(p) => depths[p].filter(|_| is_body(view, p, c.start)).map(|d| d + 1),
        };
        depths.push(depth);
        let Some(depth) = depth else { continue };
        let line = text.line_of(c.start);
        let before = view.text().get(text.line_range(line).start..c.start).unwrap_or_default();
        if before.trim().is_empty() {
            levels.entry(line).or_insert(depth);
        }
        for (start, end) in &c.words {
            let last = text.line_of(*end);
            let closes = last > text.line_of(*start) && text.line(last).trim_start().starts_with('}');
            if closes && is_body(view, i, start + 1) {
                levels.entry(last).or_insert(depth);
            }
        }
    }
    comments(view, &mut levels);
    levels
}

/// Lines whose end stands within a word that is no body: its blanks may have a meaning.
fn within_words(view: &View<'_>) -> BTreeSet<usize> {
    let text = &view.buffer.text;
    let mut lines = BTreeSet::new();
    for (i, c) in view.buffer.syntax().commands.iter().enumerate() {
        for (start, end) in c.words.iter().filter(|w| !is_body(view, i, w.0 + 1)) {
            lines.extend(text.line_of(*start)..text.line_of(*end));
        }
    }
    lines
}

/// Comments take the level of the next command.
fn comments(view: &View<'_>, levels: &mut BTreeMap<usize, usize>) {
    let text = &view.buffer.text;
    let mut n = text.line_count();
    let mut next: Option<usize> = None;
    while n > 0 {
        n -= 1;
        match levels.get(&n) {
            Some(level) => {
                let closes = text.line(n).trim_start().starts_with('}');
                next = Some(level + usize::from(closes));
            }
            None if text.line(n).trim_start().starts_with('#') => {
                if let Some(level) = next {
                    levels.insert(n, level);
                }
            }
            None if text.line(n).trim().is_empty() => {}
            None => next = None,
        }
    }
}

/// Returns true if a byte is within a braced body of a command.
fn is_body(view: &View<'_>, command: usize, at: usize) -> bool {
    let Some(c) = view.buffer.syntax().commands.get(command) else { return false };
    let text = view.text();
    let name = c.words.first().and_then(|w| text.get(w.0..w.1)).unwrap_or_default();
    let Some((_, from)) = BODIES.iter().find(|(n, _)| *n == name) else { return false };
    let around = |(i, w): (usize, &(usize, usize))| {
        i >= *from && w.0 < at && at < w.1 && text.get(w.0..w.1).is_some_and(|t| t.starts_with('{'))
    };
    c.words.iter().enumerate().any(around)
}
