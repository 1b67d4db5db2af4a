//! `hysteron commands`: the reference of the commands of scripts, on a terminal.

use hysteron::diagnostic::nearest;
use hysteron::lsp::reference::{Section, by_name, cells, section};
use hysteron::opensees::{self, KindUsage};

/// Columns of a line.
const WIDTH: usize = 80;
/// Columns of the names of arguments; the meaning of a longer one begins on a line of its own.
const NAME_WIDTH: usize = 26;

/// Usage of all commands, the kinds of one command, or everything about one command or kind.
///
/// # Errors
///
/// A message with the nearest known name.
pub(super) fn usages(words: &[String]) -> Result<String, String> {
    let text = match words {
        [] => opensees::commands().map(|c| c.usage_line() + "\n").collect(),
        [name] => about(name),
        [command, kind, ..] => about_kind(Some(command), kind),
    };
    if !text.is_empty() {
        return Ok(text);
    }
    let [.., name] = words else { return Ok(text) };
    let mut known: Vec<&str> = opensees::commands().map(|c| c.name).collect();
    known.extend(all_kinds().flat_map(|(_, kind)| kind.names.iter().copied()));
    let wanted = words.join(" ");
    Err(match nearest(name, known) {
        Some(near) => format!("there is no command \"{wanted}\": did you mean \"{near}\"?"),
        None => format!("there is no command \"{wanted}\""),
    })
}

/// Each kind with the command that makes it.
fn all_kinds() -> impl Iterator<Item = (&'static str, KindUsage)> {
    opensees::commands().flat_map(|c| c.kinds().into_iter().map(|kind| (c.name, kind)))
}

/// The kinds of a command, or everything about a command or a kind; empty if nothing has the name.
fn about(name: &str) -> String {
    let kinds: String = opensees::kinds(name).iter().map(|kind| format!("{}\n", kind.usage)).collect();
    if !kinds.is_empty() {
        return kinds;
    }
    match opensees::commands().find(|c| c.name == name) {
        Some(c) => match section(name) {
            Some(s) => render(s, &c.usage_line()),
            None => c.usage_line() + "\n",
        },
        None => about_kind(None, name),
    }
}

/// Everything about the kinds of a name, of one command or of all; empty if there is none.
fn about_kind(command: Option<&str>, name: &str) -> String {
    let is_of = |c: &str| command.is_none_or(|wanted| wanted == c);
    let mut texts: Vec<String> = vec![];
    for (c, kind) in all_kinds().filter(|(c, kind)| is_of(c) && kind.names.contains(&name)) {
        let full = format!("{c} {}", kind.names[0]);
        texts.push(match (section(&full), section(c)) {
            (Some(s), _) => render(s, kind.usage),
            (None, Some(family)) => {
                let text = indented(&plain(family.summary()));
                format!("{}\n{}", wrapped(kind.usage, 0, 4), blank_before(&text))
            }
            (None, None) => format!("{}\n", kind.usage),
        });
    }
    if texts.is_empty() {
        // Amendments have no table of kinds.
        let ends =
            |full: &str| full.contains(" ... ") && full.ends_with(&format!(" {name}")) && is_of(first_word(full));
        let found = by_name().iter().filter(|(n, _)| ends(n)).map(|(n, s)| render(s, n));
        texts.extend(found);
    }
    texts.join("\n")
}

fn first_word(text: &str) -> &str {
    text.split(' ').next().unwrap_or_default()
}

/// Usage, what it is, its arguments, and what else the reference says.
fn render(section: &Section, usage: &str) -> String {
    let (mut before, mut rows, mut after): (Vec<String>, String, Vec<String>) = Default::default();
    let mut is_code = false;
    for line in &section.lines {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if line.starts_with('|') {
            rows += &cells(line).map(|row| argument(&row)).unwrap_or_default();
        } else if !is_code && !line.is_empty() {
            let texts = if rows.is_empty() { &mut before } else { &mut after };
            texts.push(indented(&plain(line)));
        }
    }
    let mut out = format!("{}\n", wrapped(usage, 0, 4));
    for text in [before.concat(), rows, after.concat()] {
        out += &blank_before(&text);
    }
    out
}

fn blank_before(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("\n{text}") }
}

/// A row of a table of arguments: name, meaning and value.
fn argument(row: &[String]) -> String {
    let cell = |i: usize| row.get(i).map(|c| plain(c)).unwrap_or_default();
    let (name, meaning, value) = (cell(0), cell(1), cell(2));
    let text = if value.is_empty() { meaning } else { format!("{meaning} ({value})") };
    let text = wrapped(&text, 2 + NAME_WIDTH, 2 + NAME_WIDTH);
    if name.chars().count() < NAME_WIDTH {
        format!("  {name:NAME_WIDTH$}{}\n", text.trim_start())
    } else {
        format!("  {name}\n{text}\n")
    }
}

pub(super) fn indented(text: &str) -> String {
    format!("{}\n", wrapped(text, 2, 2))
}

/// Text in lines of at most [`WIDTH`] columns; the first is indented by `first`, the others by `rest`.
pub(super) fn wrapped(text: &str, first: usize, rest: usize) -> String {
    let mut out = " ".repeat(first);
    let mut column = first;
    for (i, word) in text.split_whitespace().enumerate() {
        let width = word.chars().count();
        if i > 0 && column + 1 + width > WIDTH {
            out = format!("{out}\n{}", " ".repeat(rest));
            column = rest;
        } else if i > 0 {
            out.push(' ');
            column += 1;
        }
        out += word;
        column += width;
    }
    out
}

/// Text without the marks of Markdown: code, links and formulas.
fn plain(text: &str) -> String {
    let mut out = String::new();
    let (mut is_code, mut is_formula) = (false, false);
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        match c {
            '`' => is_code = !is_code,
            _ if is_code => out.push(c),
            '$' => is_formula = !is_formula,
            '\\' | '{' | '}' if is_formula => {}
            // The address of a link.
            ']' if rest.as_str().starts_with('(') => {
                rest.by_ref().find(|c| *c == ')');
            }
            '[' if rest.as_str().contains("](") => {}
            _ => out.push(c),
        }
    }
    out
}
