//! Pages of the reference: commands by family, each with its usage and a table of its arguments.

use super::probe::{self, MODELS, Meaning, Meanings, Walk};
use super::response;
use super::usage::{self, MatrixMask, Row};
use hysteron::opensees::{
    AMENDMENTS, Arg, Command, Domain, KindUsage, Text, WITHOUT_EFFECT, commands, commands_on, kinds,
};
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
    let mut kinds = kinds_of(c.name);
    // `eleLoad` knows options, not kinds.
    kinds.retain(|k| !k.name().starts_with('-'));
    // Kinds that have a usage of their own get a heading each, the others a line.
    let bare = |usage: &str| usage == c.usage_line() || !usage.contains(['$', '<']);
    let own: Vec<&Kind> = kinds.iter().filter(|k| !bare(&k.usage)).collect();
    if own.is_empty() || !names_kinds(c.usage) {
        usage_of(out, &c.usage_line(), blanks);
    } else {
        let _ = writeln!(out, "```tcl\n{}\n```\n", c.usage_line());
    }
    let listed: Vec<&Kind> = kinds.iter().filter(|k| bare(&k.usage)).collect();
    list(out, &listed);
    let mut done: Vec<&str> = vec![];
    for Kind { usage, .. } in &own {
        if done.contains(&usage.as_str()) {
            continue;
        }
        done.push(usage);
        let alike: Vec<&Kind> = own.iter().copied().filter(|k| k.usage == *usage).collect();
        let full = |k: &Kind| format!("{} {}", c.name, k.name());
        let heading: Vec<String> = alike.iter().map(|k| format!("`{}`", full(k))).collect();
        let _ = writeln!(out, "### {}\n", heading.join(", "));
        about(out, alike.iter().map(|k| (full(k), k.text.about)), blanks);
        usage_of(out, usage, blanks);
        other_names(out, &alike);
        responses(out, c.name, alike[0], blanks);
    }
}

/// The names under which a kind is known too.
fn other_names(out: &mut String, kinds: &[&Kind]) {
    for kind in kinds.iter().filter(|k| k.names.len() > 1) {
        let names: Vec<String> = kind.names[1..].iter().map(|n| format!("`{n}`")).collect();
        let _ = writeln!(out, "Other names of `{}`: {}.\n", kind.name(), names.join(", "));
    }
}

/// The responses of a kind that recorders take.
fn responses(out: &mut String, command: &str, kind: &Kind, blanks: &mut Blanks) {
    let Some(names) = response::of(command, &kind.usage, kind.text.example) else { return };
    let names: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
    if names.is_empty() {
        blanks.push(format!("{command} {}: no example that makes one", kind.name()));
    } else {
        let _ = writeln!(out, "Recorders take: {}.\n", names.join(", "));
    }
}

/// True if a usage only says that kinds follow.
fn names_kinds(usage: &str) -> bool {
    usage.contains("$kind") || usage.ends_with("...") || usage.contains("... <options>")
}

/// Names of kinds without arguments of their own, with what they are where that is known.
fn list(out: &mut String, kinds: &[&Kind]) {
    if kinds.is_empty() {
        return;
    }
    if kinds.iter().any(|k| !k.text.about.is_empty()) {
        out.push_str("| kind | |\n| --- | --- |\n");
        for kind in kinds {
            let _ = writeln!(out, "| `{}` | {} |", kind.name(), kind.text.about);
        }
        out.push('\n');
    } else {
        let names: Vec<String> = kinds.iter().map(|k| format!("`{}`", k.name())).collect();
        let _ = writeln!(out, "Known names: {}.\n", names.join(", "));
    }
}

/// A kind that a command makes.
struct Kind {
    /// The preferred name first.
    names: Vec<String>,
    usage: String,
    text: Text,
}

impl Kind {
    fn name(&self) -> &str {
        &self.names[0]
    }
}

/// The kinds of a command, each with its usage.
fn kinds_of(command: &str) -> Vec<Kind> {
    let listed = kinds(command);
    if !listed.is_empty() {
        let owned = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect();
        let kind = |k: KindUsage| Kind { names: owned(k.names), usage: k.usage.to_owned(), text: k.text };
        return listed.into_iter().map(kind).collect();
    }
    let words = |kind: &str| vec![command.to_owned(), kind.to_owned()];
    let (_, names) = probe::help(MODELS[0], &words("wrong!"));
    names
        .into_iter()
        .map(|name| {
            let usage = probe::help(MODELS[0], &words(&name)).0;
            // The usage of the command as a whole says nothing of this kind.
            let own = usage.filter(|u| u.contains(&name));
            let usage = own.unwrap_or_else(|| format!("{command} {name}"));
            Kind { names: vec![name], usage, text: Text::default() }
        })
        .collect()
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
    let is_declared = |r: &Row| declared_for(usage, r).is_some_and(|a| a.domain.is_some() || r.arguments.is_empty());
    let found = if rows.iter().all(is_declared) { Meanings::new() } else { meanings(usage, &parts) };
    out.push_str("| argument | meaning | value |\n| --- | --- | --- |\n");
    let mut before: Option<String> = None;
    for row in rows {
        let (what, value) = match more_of(before.as_deref(), &row) {
            true => ("more of the same".to_owned(), String::new()),
            false => explained(usage, &row, &found, blanks),
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

/// Meaning and value of a row: the declared one, else that of the messages.
fn explained(usage: &str, row: &Row, found: &Meanings, blanks: &mut Blanks) -> (String, String) {
    let name = row.arguments.first().map_or("", String::as_str);
    if let Some(arg) = declared_for(usage, row) {
        let of_messages = || found.get(&(row.option.clone(), name.to_owned())).map(|m| m.value.clone());
        let value = arg.domain.map(|d| d.told().to_owned()).or_else(of_messages);
        return (arg.meaning.to_owned() + &of_parameter(arg), value.unwrap_or_default());
    }
    let of = |name: &String| found.get(&(row.option.clone(), name.clone())).cloned();
    let known: Vec<Meaning> = row.arguments.iter().filter_map(of).collect();
    if row.arguments.is_empty() || known.len() < row.arguments.len() {
        blanks.push(format!("{usage}: no meaning of {} {name}", row.option));
    }
    let mut whats: Vec<String> = known.iter().map(|m| m.what.clone()).collect();
    whats.dedup();
    let mut values: Vec<String> = known.iter().map(|m| m.value.clone()).filter(|v| !v.is_empty()).collect();
    values.dedup();
    (whats.join("; "), values.join("; "))
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

/// The argument of a row of a usage, where the command or its kind declares it.
fn declared_for(usage: &str, row: &Row) -> Option<&'static Arg> {
    let mut head = usage::command(usage).split(' ');
    let name = head.next()?;
    let command = commands().find(|c| c.name == name)?;
    let kind = head.next().and_then(|word| command.kinds().into_iter().find(|k| k.names.contains(&word)));
    command.argument(kind, &row.option, row.arguments.first().map_or("", String::as_str))
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
    row.option == arg.option && row.arguments.first().map_or("", String::as_str) == arg.name
}

fn told(name: &str, arg: &Arg) -> String {
    format!("{name}\t{}\t{}", arg.option, arg.name)
}

/// Explanations of the arguments by the command, from the model in which it gives most of them.
fn meanings(usage: &str, parts: &[MatrixMask]) -> Meanings {
    let head = usage::command(usage).split(' ').next().unwrap_or_default().to_owned();
    let forms: Vec<&[MatrixMask]> = parts.split(|p| *p == MatrixMask::Either).collect();
    let mut all = Meanings::new();
    let wanted: usize = usage::rows(parts).iter().map(|r| r.arguments.len()).sum();
    for model in MODELS {
        if all.len() >= wanted {
            break;
        }
        let mut prefixes: Vec<Vec<MatrixMask>> = vec![vec![]];
        for form in &forms {
            let mut best = Meanings::new();
            for prefix in &prefixes {
                let mut walk = Walk::new(model, vec![head.clone()]);
                walk.take(&[prefix.as_slice(), form].concat());
                let names = parts_names(parts);
                walk.found.retain(|(_, name), m| !is_of_another(&m.what, name, &names));
                if walk.found.len() > best.len() {
                    best = walk.found;
                }
            }
            // A later form may go on from any place of the first.
            if prefixes.len() == 1 {
                prefixes = (0..=form.len()).map(|n| form[..n].to_vec()).collect();
            }
            for (key, meaning) in best {
                all.entry(key).or_insert(meaning);
            }
        }
    }
    all
}

fn parts_names(parts: &[MatrixMask]) -> Vec<String> {
    usage::rows(parts).into_iter().flat_map(|r| r.arguments).collect()
}

/// True if a meaning ends with the symbol of another argument: in this model the form has another order.
fn is_of_another(what: &str, name: &str, names: &[String]) -> bool {
    let last = what.rsplit(' ').next().unwrap_or_default();
    let symbol = last.len() <= 2 || last.contains(|c: char| c.is_ascii_digit() || c.is_ascii_uppercase());
    symbol && last != name && names.iter().any(|n| n == last)
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
