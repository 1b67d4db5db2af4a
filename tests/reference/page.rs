//! Pages of the reference: commands by family, each with its usage and a table of its arguments.

use super::response;
use super::usage::{self, Row};
use hysteron::opensees::{AMENDMENTS, Arg, Command, Domain, KindUsage, WITHOUT_EFFECT, commands, commands_on};
use std::fmt::Write as _;

/// A page.
pub struct Page {
    pub name: &'static str,
    pub title: &'static str,
    /// Text before the commands.
    pub intro: &'static str,
}

pub use super::pages::PAGES;

/// Texts that are missing: sentences, and meanings of arguments that neither a row nor a message tells.
pub type Blanks = Vec<String>;

/// The text of a page, and what is missing in it.
pub fn text(page: &Page) -> (String, Blanks) {
    let mut out =
        format!("# {}\n\n<!-- Written by tests/reference.rs from the commands themselves. -->\n\n", page.title);
    if !page.intro.is_empty() {
        let _ = writeln!(out, "{}\n", page.intro);
    }
    let mut blanks = vec![];
    let (idle, mut left): (Vec<&Command>, Vec<&Command>) =
        commands_on(page.name).partition(|c| c.text.about == WITHOUT_EFFECT);
    while let Some(first) = left.first().copied() {
        let alike: Vec<&Command> = left.iter().copied().filter(|c| c.usage == first.usage).collect();
        left.retain(|c| c.usage != first.usage);
        let names: Vec<String> = alike.iter().map(|c| format!("`{}`", c.name)).collect();
        let _ = writeln!(out, "## {}\n", names.join(", "));
        about(&mut out, alike.iter().map(|c| (c.name.to_owned(), c.text.about)), &mut blanks);
        command(&mut out, first, &mut blanks);
    }
    if !idle.is_empty() {
        let names: Vec<String> = idle.iter().map(|c| format!("`{}`", c.name)).collect();
        let _ = writeln!(out, "## Without effect\n\nThese are accepted and do nothing: {}.", names.join(", "));
    }
    (out.trim_end().to_owned() + "\n", blanks)
}

/// One sentence about each command or kind that shares a heading.
fn about(out: &mut String, named: impl Iterator<Item = (String, &'static str)>, blanks: &mut Blanks) {
    let mut said: Vec<&str> = vec![];
    for (name, text) in named {
        if text.is_empty() {
            blanks.push(format!("{name}: no sentence about it"));
        } else if !said.contains(&text) {
            said.push(text);
        }
    }
    if !said.is_empty() {
        let _ = writeln!(out, "{}\n", said.join(" "));
    }
}

fn command(out: &mut String, c: &Command, blanks: &mut Blanks) {
    if c.name == "amend" {
        return amend(out, c, blanks);
    }
    let kinds = c.kinds();
    // Kinds that have a usage of their own get a heading each, the others a line.
    let bare = |usage: &str| usage == c.usage_line() || !usage.contains(['$', '<']);
    let own: Vec<&KindUsage> = kinds.iter().filter(|k| !bare(k.usage)).collect();
    if own.is_empty() || !names_kinds(c.usage) {
        usage_of(out, &c.usage_line(), blanks);
    } else {
        let _ = writeln!(out, "```tcl\n{}\n```\n", c.usage_line());
    }
    let listed: Vec<&KindUsage> = kinds.iter().filter(|k| bare(k.usage)).collect();
    list(out, &listed);
    let mut done: Vec<&str> = vec![];
    for KindUsage { usage, .. } in &own {
        if done.contains(usage) {
            continue;
        }
        done.push(usage);
        let alike: Vec<&KindUsage> = own.iter().copied().filter(|k| k.usage == *usage).collect();
        let full = |k: &KindUsage| format!("{} {}", c.name, k.names[0]);
        let heading: Vec<String> = alike.iter().map(|k| format!("`{}`", full(k))).collect();
        let _ = writeln!(out, "### {}\n", heading.join(", "));
        about(out, alike.iter().map(|k| (full(k), k.text.about)), blanks);
        usage_of(out, usage, blanks);
        other_names(out, &alike);
        responses(out, c.name, alike[0], blanks);
    }
}

/// The names under which a kind is known too.
fn other_names(out: &mut String, kinds: &[&KindUsage]) {
    for kind in kinds.iter().filter(|k| k.names.len() > 1) {
        let names: Vec<String> = kind.names[1..].iter().map(|n| format!("`{n}`")).collect();
        let _ = writeln!(out, "Other names of `{}`: {}.\n", kind.names[0], names.join(", "));
    }
}

/// The responses of a kind that recorders take.
fn responses(out: &mut String, command: &str, kind: &KindUsage, blanks: &mut Blanks) {
    let Some(names) = response::of(command, kind.text.example) else { return };
    let names: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
    if names.is_empty() {
        blanks.push(format!("{command} {}: no example that makes one", kind.names[0]));
    } else {
        let _ = writeln!(out, "Recorders take: {}.\n", names.join(", "));
    }
}

/// True if a usage only says that kinds follow.
fn names_kinds(usage: &str) -> bool {
    usage.contains("$kind") || usage.ends_with("...") || usage.contains("... <options>")
}

/// Names of kinds without arguments of their own, with what they are where that is known.
fn list(out: &mut String, kinds: &[&KindUsage]) {
    if kinds.is_empty() {
        return;
    }
    if kinds.iter().any(|k| !k.text.about.is_empty()) {
        out.push_str("| kind | |\n| --- | --- |\n");
        for kind in kinds {
            let _ = writeln!(out, "| `{}` | {} |", kind.names[0], kind.text.about);
        }
        out.push('\n');
    } else {
        let names: Vec<String> = kinds.iter().map(|k| format!("`{}`", k.names[0])).collect();
        let _ = writeln!(out, "Known names: {}.\n", names.join(", "));
    }
}

/// A usage and the table of its arguments.
fn usage_of(out: &mut String, usage: &str, blanks: &mut Blanks) {
    let _ = writeln!(out, "```tcl\n{usage}\n```\n");
    let parts = usage::parse(usage);
    let mut rows = usage::rows(&parts);
    if let Some(first) = usage.split(' ').nth(1).filter(|w| w.contains('|')) {
        // The kind itself, where one usage serves several.
        rows.retain(|r| r.shown != first);
    }
    if rows.is_empty() {
        return;
    }
    out.push_str("| argument | meaning | value |\n| --- | --- | --- |\n");
    let mut before: Option<String> = None;
    for row in rows {
        let (what, value) = match more_of(before.as_deref(), &row) {
            true => ("more of the same".to_owned(), String::new()),
            false => explained(usage, &row, blanks),
        };
        before = row.arguments.last().cloned();
        let shown = if row.optional { format!("<{}>", row.shown) } else { row.shown.clone() };
        let _ = writeln!(out, "| `{}` | {} | {} |", shown.replace('|', "\\|"), what.replace('|', "\\|"), value);
    }
    out.push('\n');
}

/// True for `$dof2 ...` after `$dof1`.
fn more_of(before: Option<&str>, row: &Row) -> bool {
    let stem = |name: &str, end: char| name.strip_suffix(end).map(str::to_owned);
    let (Some(before), [name]) = (before, row.arguments.as_slice()) else { return false };
    row.shown.ends_with("...")
        && row.option.is_empty()
        && stem(before, '1').is_some()
        && stem(before, '1') == stem(name, '2')
}

/// Meaning and value of a row, as they are declared.
fn explained(usage: &str, row: &Row, blanks: &mut Blanks) -> (String, String) {
    let Some(arg) = declared_for(usage, row) else {
        let name = row.arguments.first().map_or("", String::as_str);
        blanks.push(format!("{usage}: no meaning of {} {name}", row.option));
        return Default::default();
    };
    let all = [vec![arg], further(usage, row)].concat();
    let mut meanings: Vec<String> = all.iter().map(|arg| arg.told().into_owned() + &of_parameter(arg)).collect();
    let mut domains: Vec<&str> = all.iter().filter_map(|arg| Some(arg.domain?.told())).collect();
    meanings.dedup();
    domains.dedup();
    (meanings.join("; "), domains.join("; "))
}

/// OpenSees' names of a number in `parameter`, where it has others.
fn of_parameter(arg: &Arg) -> String {
    let shown = |name: &&str| match name.strip_prefix('-') {
        Some(opposite) => format!("-`{opposite}`"),
        None => format!("`{name}`"),
    };
    let names: Vec<String> = arg.parameters.iter().map(shown).collect();
    if names.is_empty() { String::new() } else { format!("; in `parameter` also {}", names.join(", ")) }
}

/// The command of a usage, and its kind.
fn made_by(usage: &str) -> Option<(&'static Command, Option<KindUsage>)> {
    let mut head = usage::command(usage).split(' ');
    let name = head.next()?;
    let command = commands().find(|c| c.name == name)?;
    // One usage may serve several kinds.
    let word = head.next().and_then(|word| word.split('|').next());
    let kind = word.and_then(|word| command.kinds().into_iter().find(|k| k.names.contains(&word)));
    Some((command, kind))
}

/// The argument of a row of a usage, where the command or its kind declares it.
fn declared_for(usage: &str, row: &Row) -> Option<&'static Arg> {
    let (command, kind) = made_by(usage)?;
    command.argument(kind, &row.option, row.arguments.first().map_or("", String::as_str))
}

/// The further arguments behind an option, where they are declared too.
fn further(usage: &str, row: &Row) -> Vec<&'static Arg> {
    let Some((command, kind)) = made_by(usage).filter(|_| !row.option.is_empty()) else { return vec![] };
    row.arguments.iter().skip(1).filter_map(|name| command.argument(kind, &row.option, name)).collect()
}

/// Declared arguments that the usage of their command or kind does not have.
pub fn undeclared() -> Vec<String> {
    let mut out = vec![];
    for c in commands() {
        let own = usage_rows(c.usage);
        let kinds = c.kinds();
        let of_kinds: Vec<Vec<Row>> = kinds.iter().map(|k| usage_rows(k.usage)).collect();
        let all: Vec<&Row> = own.iter().chain(of_kinds.iter().flatten()).collect();
        out.extend(c.text.arguments.iter().filter(|a| !all.iter().any(|r| is_of(r, a))).map(|a| told(c.name, a)));
        for (kind, rows) in kinds.iter().zip(&of_kinds) {
            let unknown = kind.text.arguments.iter().filter(|a| !rows.iter().any(|r| is_of(r, a)));
            out.extend(unknown.map(|a| told(kind.names[0], a)));
        }
    }
    out
}

fn usage_rows(usage: &str) -> Vec<Row> {
    usage::rows(&usage::parse(usage))
}

/// True if an argument is declared for a row of a usage.
fn is_of(row: &Row, arg: &Arg) -> bool {
    let names = if row.option.is_empty() { &row.arguments[..row.arguments.len().min(1)] } else { &row.arguments };
    row.option == arg.option && if arg.name.is_empty() { names.is_empty() } else { names.iter().any(|n| n == arg.name) }
}

fn told(name: &str, arg: &Arg) -> String {
    format!("{name}\t{}\t{}", arg.option, arg.name)
}

/// `amend`: its kinds have options only.
fn amend(out: &mut String, c: &Command, blanks: &mut Blanks) {
    usage_of(out, &c.usage_line(), blanks);
    for kind in AMENDMENTS.iter().filter(|k| !k.about.is_empty()) {
        let _ = writeln!(out, "### `amend element ... {}`\n\n{}\n", kind.name, kind.about);
        out.push_str("| option | meaning | value |\n| --- | --- | --- |\n");
        for option in kind.options {
            let shown = format!("{} ${}", option.arg.option, option.arg.name);
            let shown = if option.default.is_none() { shown } else { format!("<{shown}>") };
            let _ = writeln!(
                out,
                "| `{shown}` | {} | {} |",
                option.arg.meaning,
                option.arg.domain.map_or("", Domain::told)
            );
        }
        out.push('\n');
    }
}
