//! Commands and kinds by their names, with what the reference says of them.

use crate::reference::{self, Argument, Section};
use hysteron_opensees::{Command, KindUsage, calls};
use hysteron_tcl::{Interp, MemoryFiles, Silent};
use std::sync::OnceLock;

/// Commands of Tcl.
pub(crate) fn tcl_commands() -> &'static [String] {
    static ALL: OnceLock<Vec<String>> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut interp = Interp::new((), Box::new(Silent), Box::new(MemoryFiles::default()));
        let names = interp.eval_str("names", "lsort [info commands]").ok().and_then(|v| v.to_list().ok());
        names.iter().flat_map(|list| list.iter().map(|v| v.as_str().into_owned())).collect()
    })
}

/// A command by the word of a script that calls it.
pub(crate) fn command(word: &str) -> Option<&'static Command> {
    calls::command(word.trim_start_matches("::"))
}

/// The kind of a command that its first word chooses.
pub(crate) fn kind(command: &Command, word: &str) -> Option<KindUsage> {
    command.kinds().into_iter().find(|k| k.names.contains(&word))
}

/// Command and kind of a call, as far as its words say them.
pub(crate) struct Called {
    pub(crate) command: &'static Command,
    pub(crate) kind: Option<KindUsage>,
}

impl Called {
    /// Of words, the first of which is the name.
    pub(crate) fn of(words: &[&str]) -> Option<Self> {
        let command = command(words.first()?)?;
        let kind = words.get(1).and_then(|word| kind(command, word));
        Some(Self { command, kind })
    }

    /// Usage in one line.
    pub(crate) fn usage(&self) -> String {
        self.kind.map_or_else(|| self.command.usage_line(), |k| k.usage.to_owned())
    }

    /// Text of the kind in the reference, or of the command where it has no kind.
    pub(crate) fn section(&self) -> Option<&'static Section> {
        match self.kind {
            Some(kind) => section_of_kind(self.command, kind),
            None => section_of_command(self.command),
        }
    }

    /// Its arguments and options.
    pub(crate) fn arguments(&self) -> Vec<Argument> {
        self.section().map(Section::arguments).unwrap_or_default()
    }
}

/// Text of a kind in the reference; none where its name says all.
pub(crate) fn section_of_kind(command: &Command, kind: KindUsage) -> Option<&'static Section> {
    reference::section(&format!("{} {}", command.name, kind.names[0]))
}

/// Text of a command itself in the reference.
pub(crate) fn section_of_command(command: &Command) -> Option<&'static Section> {
    reference::section(command.name)
}
