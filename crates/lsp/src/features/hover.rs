//! What the word under the mouse is.

use super::thing::{described, shown};
use super::words::{self, Called};
use crate::buffer::{View, WordAt};
use crate::reference::{Argument, Section};
use hysteron_opensees::index::{CalledCommand, CalledWord};
use lsp_types::{Hover, HoverContents, MarkupContent, MarkupKind};

/// Things that one word may name and that are described: a loop names many.
const MAX_THINGS: usize = 3;
/// Characters of a section that are shown.
const MAX_SECTION: usize = 6000;

/// What is known of the word around a byte.
pub(crate) fn hover(view: &View<'_>, at: usize) -> Option<Hover> {
    if !view.has_commands() {
        return None;
    }
    let mut word = view.word_at(at)?;
    loop {
        let parts = known(view, at, &word);
        if !parts.is_empty() {
            let range = Some(view.buffer.text.range(word.start, word.end));
            let value = parts.join("\n\n---\n\n");
            let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
            return Some(Hover { contents, range });
        }
        // A command in brackets stands for a word of the command around it.
        word = view.bracket_around(&word)?;
    }
}

/// What is known of a word, in parts.
fn known(view: &View<'_>, at: usize, word: &WordAt) -> Vec<String> {
    let written = view.written(word.command);
    let mut parts: Vec<String> = vec![];
    match word.word {
        0 => parts.extend(of_name(view, &written)),
        1 if Called::of(&written).is_some_and(|c| c.kind.is_some()) => return of_kind(&written).into_iter().collect(),
        _ => {}
    }
    parts.extend(of_word(view, word, &written));
    parts.extend(of_variable(view, at, word));
    parts
}

fn cut(section: &Section) -> String {
    let text = section.markdown();
    let cut: String = text.chars().take(MAX_SECTION).collect();
    if cut.len() < text.len() { cut + "\n\n..." } else { cut }
}

/// A command, or a procedure of the script.
fn of_name(view: &View<'_>, written: &[&str]) -> Option<String> {
    let name = written.first()?;
    if let Some(command) = words::command(name) {
        let usage = format!("```tcl\n{}\n```", command.usage_line());
        let section = words::section_of_command(command);
        // The reference of a command with kinds has a table of those without a section of their own.
        return Some(match section {
            Some(section) if section.lines.iter().any(|l| l.starts_with("```tcl")) => cut(section),
            Some(section) => format!("{usage}\n{}", cut(section)),
            None => usage,
        });
    }
    procedure(view, name)
}

/// The head of a procedure.
fn procedure(view: &View<'_>, name: &str) -> Option<String> {
    let commands = &view.buffer.syntax().commands;
    let text = view.text();
    let word = |w: &(usize, usize)| text.get(w.0..w.1).unwrap_or_default();
    let is_it = |c: &&hysteron_tcl::WrittenCommand| {
        c.words.len() > 2 && word(&c.words[0]) == "proc" && word(&c.words[1]) == name
    };
    let found = commands.iter().find(is_it)?;
    Some(format!("```tcl\nproc {name} {}\n```", word(&found.words[2])))
}

fn of_kind(written: &[&str]) -> Option<String> {
    let called = Called::of(written)?;
    let kind = called.kind?;
    Some(match words::section_of_kind(called.command, kind) {
        Some(section) => cut(section),
        None => format!("```tcl\n{}\n```", kind.usage),
    })
}

/// The word as the check has seen it: its meaning, its value, and what it names.
fn of_word(view: &View<'_>, word: &WordAt, written: &[&str]) -> Option<String> {
    let mut lines: Vec<String> = vec![];
    let found = seen(view, word);
    if let Some((command, seen)) = found.filter(|_| word.word > 0) {
        if !seen.meaning.is_empty() {
            lines.push(format!("{}: {}", command.command.name, seen.meaning));
        }
        let text = written.get(word.word).copied().unwrap_or_default();
        if seen.value != text && !text.starts_with(['{', '"']) {
            let first = if command.count > 1 { format!(" (first of {} calls)", command.count) } else { String::new() };
            lines.push(format!("`{text}` = {}{first}", seen.value));
        }
    }
    if found.is_none_or(|(_, seen)| seen.meaning.is_empty()) && word.word > 0 {
        lines.extend(of_option(written, word.word));
    }
    if let (Some(script), Some(at)) = (view.script(), view.checked(word.start)) {
        let things = script.mentions_at(view.path, at + 1);
        let more = things.len().saturating_sub(MAX_THINGS);
        lines.extend(things.iter().take(MAX_THINGS).map(|m| described(script, m)));
        if more > 0 {
            lines.push(format!("... and {more} more"));
        }
    }
    (!lines.is_empty()).then(|| lines.join("\n\n"))
}

/// The word of the index at a word of the text.
fn seen<'a>(view: &View<'a>, word: &WordAt) -> Option<(&'a CalledCommand, &'a CalledWord)> {
    let script = view.script()?;
    let (start, end) = (view.checked(word.start)?, view.checked(word.end)?);
    script.commands(view.path).find_map(|command| {
        let same = |w: &&CalledWord| w.span.is_some_and(|s| (s.start as usize, s.end as usize) == (start, end));
        Some((command, command.words.iter().find(same)?))
    })
}

/// The row of the reference about an option, or about the option before a value.
fn of_option(written: &[&str], word: usize) -> Option<String> {
    let arguments = Called::of(written)?.arguments();
    let row = |text: &str| arguments.iter().find(|a| a.option() == Some(text)).cloned();
    let own = written.get(word).and_then(|text| row(text));
    let before = word.checked_sub(1).and_then(|i| row(written.get(i)?));
    let Argument { name, meaning } = own.or(before)?;
    Some(format!("`{name}` {meaning}"))
}

/// A variable with its value.
fn of_variable(view: &View<'_>, at: usize, word: &WordAt) -> Option<String> {
    let around = |v: &&hysteron_tcl::WrittenVariable| v.start <= at && at <= v.end;
    let variable = view.buffer.syntax().variables.iter().filter(around).min_by_key(|v| v.end - v.start)?;
    // The whole word has been told with its value.
    if (variable.start, variable.end) == (word.start, word.end) && seen(view, word).is_some() {
        return None;
    }
    let value = view.script()?.variables.get(variable.name.trim_start_matches("::"))?;
    Some(format!("`${}` = {value} at the end of the script", variable.name))
}

/// The text of a command for a list of definitions.
pub(crate) fn in_one_line(view: &View<'_>, command: &CalledCommand) -> String {
    let text = view.script().map(|s| shown(s, command)).unwrap_or_default();
    text.lines().next().unwrap_or_default().to_owned()
}
