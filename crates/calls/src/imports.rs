//! Imports of a file, and the commands that its names call.

use crate::token::{Kind, Line, Token, Tokens};
use hysteron_opensees::{calls, opensees_names};
use std::collections::{BTreeMap, BTreeSet};

/// The module that a file takes its commands from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Module {
    /// `openseespy.opensees`.
    OpenSeesPy,
    /// `hysteron.opensees`.
    Hysteron,
}

/// Functions of Python that call no command.
pub(crate) const BUILTINS: [&str; 30] = [
    "print",
    "len",
    "range",
    "float",
    "int",
    "str",
    "abs",
    "min",
    "max",
    "sum",
    "round",
    "list",
    "tuple",
    "dict",
    "set",
    "zip",
    "enumerate",
    "open",
    "sorted",
    "isinstance",
    "format",
    "type",
    "bool",
    "reversed",
    "any",
    "all",
    "map",
    "pow",
    "divmod",
    "repr",
];

/// Modules whose functions call no command that changes a model.
const MODULES: [&str; 33] = [
    "numpy",
    "math",
    "matplotlib",
    "os",
    "sys",
    "time",
    "scipy",
    "pandas",
    "opsvis",
    "vfo",
    "json",
    "csv",
    "pathlib",
    "datetime",
    "random",
    "copy",
    "itertools",
    "functools",
    "re",
    "warnings",
    "cmath",
    "collections",
    "typing",
    "string",
    "shutil",
    "glob",
    "pickle",
    "tqdm",
    "seaborn",
    "plotly",
    "IPython",
    "__future__",
    "dataclasses",
];

/// Imports of a file.
#[derive(Debug, Default)]
pub(crate) struct Imports {
    pub(crate) module: Option<Module>,
    /// Names of the module of commands, with dots.
    pub(crate) aliases: Vec<String>,
    /// Commands that are imported by name: what the file calls them, and their name.
    commands: BTreeMap<String, String>,
    /// All commands are imported by their names.
    is_star: bool,
    /// Names of modules that call no command, and of what comes from them.
    pub(crate) harmless: Vec<String>,
    /// Names that the file defines.
    pub(crate) own: BTreeSet<String>,
    /// Lines, by their first token, that import a module which may call commands.
    pub(crate) unknown: BTreeSet<usize>,
    pub(crate) has_classes: bool,
}

fn module_of(path: &str) -> Option<Module> {
    match path {
        "openseespy.opensees" => Some(Module::OpenSeesPy),
        "hysteron.opensees" => Some(Module::Hysteron),
        _ => None,
    }
}

impl Imports {
    pub(crate) fn of(text: &str, tokens: &Tokens) -> Self {
        let mut out = Self::default();
        for line in &tokens.lines {
            let all = &tokens.all[line.tokens.clone()];
            for statement in all.split(|t| &text[t.at.clone()] == ";") {
                let words: Vec<&str> = statement.iter().map(|t| &text[t.at.clone()]).collect();
                match words[..] {
                    ["import", ..] => out.modules(&words[1..], line),
                    ["from", ..] => out.names(&words[1..], line),
                    ["def" | "class", name, ..] | ["async", "def", name, ..] => {
                        out.has_classes |= words[0] == "class";
                        out.own.insert(name.to_owned());
                    }
                    _ => {}
                }
            }
        }
        out
    }

    /// `import a.b as c, d`.
    fn modules(&mut self, words: &[&str], line: &Line) {
        for one in words.split(|w| *w == ",") {
            let end = one.iter().position(|w| *w == "as").unwrap_or(one.len());
            let path = one[..end].concat();
            let name = one.get(end + 1).map_or(path.as_str(), |n| n).to_owned();
            if let Some(module) = module_of(&path) {
                self.module.get_or_insert(module);
                self.aliases.push(name);
            } else if is_harmless(&path) {
                self.harmless.push(name.split('.').next().unwrap_or_default().to_owned());
            } else {
                self.unknown.insert(line.tokens.start);
            }
        }
    }

    /// `from a.b import c as d, e` or `from a.b import *`.
    fn names(&mut self, words: &[&str], line: &Line) {
        let Some(at) = words.iter().position(|w| *w == "import") else { return };
        let path = words[..at].concat();
        let names = words[at + 1..].iter().filter(|w| !matches!(**w, "(" | ")")).copied().collect::<Vec<_>>();
        for one in names.split(|w| *w == ",").filter(|one| !one.is_empty()) {
            let (name, own) = (one[0], one.get(2).copied().unwrap_or(one[0]));
            let inner = module_of(&format!("{path}.{name}"));
            if let Some(module) = inner {
                self.module.get_or_insert(module);
                self.aliases.push(own.to_owned());
            } else if let Some(module) = module_of(&path) {
                self.module.get_or_insert(module);
                match name {
                    "*" => self.is_star = true,
                    _ => _ = self.commands.insert(own.to_owned(), name.to_owned()),
                }
            } else if is_harmless(&path) {
                self.harmless.push(own.to_owned());
            } else {
                self.unknown.insert(line.tokens.start);
            }
        }
    }
}

/// Names with dots that end at a token; none where they begin with another expression.
pub(crate) fn path(text: &str, all: &[Token], i: usize) -> Option<String> {
    let word = |t: &Token| text[t.at.clone()].to_owned();
    let mut at = i;
    while at >= 2 && word(&all[at - 1]) == "." && all[at - 2].kind == Kind::Name {
        at -= 2;
    }
    if at > 0 && word(&all[at - 1]) == "." {
        return None;
    }
    Some(all[at..=i].iter().map(word).collect())
}

impl Imports {
    /// The command that is called by the name at a token, where it is one.
    pub(crate) fn called<'a>(&'a self, text: &'a str, all: &[Token], i: usize) -> Option<&'a str> {
        let name = all.get(i).filter(|t| t.kind == Kind::Name).map(|t| &text[t.at.clone()])?;
        if let Some(name) = self.written(text, all, i) {
            let is_name = !name.starts_with(|c: char| c.is_uppercase() || c == '_') || calls::command(name).is_some();
            return is_name.then_some(name);
        }
        if i > 0 && &text[all[i - 1].at.clone()] == "." || self.own.contains(name) {
            return None;
        }
        if let Some(command) = self.commands.get(name) {
            return Some(command);
        }
        let is_known = || calls::command(name).is_some() || opensees_names::has_command(name);
        (self.is_star && !BUILTINS.contains(&name) && is_known()).then_some(name)
    }

    /// The name at a token behind the name of the module.
    pub(crate) fn written<'a>(&self, text: &'a str, all: &[Token], i: usize) -> Option<&'a str> {
        let dot = i.checked_sub(1).filter(|j| &text[all[*j].at.clone()] == ".")?;
        self.is_alias(text, &all[..dot]).then(|| &text[all[i].at.clone()])
    }

    /// Returns true if tokens end with a name of the module.
    pub(crate) fn is_alias(&self, text: &str, all: &[Token]) -> bool {
        let last = all.len().checked_sub(1).and_then(|i| path(text, all, i));
        last.is_some_and(|path| self.aliases.contains(&path))
    }
}

fn is_harmless(path: &str) -> bool {
    let first = path.split('.').next().unwrap_or_default();
    MODULES.contains(&first) || path.starts_with("openseespy.post") || path == "openseespy" || path == "hysteron"
}
