//! The open files, and what is known of them.

use crate::check::{Checked, FileKind};
use crate::line::{self, LineBefore};
use crate::python;
use crate::script::{Place, Script};
use crate::text::{Shift, Text};
use crate::uri;
use hysteron_tcl::Syntax;
use lsp_types::{Location, Range, Uri};
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// An open file.
pub(crate) struct Buffer {
    pub(crate) uri: Uri,
    pub(crate) version: i32,
    pub(crate) text: Text,
    syntax: OnceLock<Syntax>,
}

impl Buffer {
    pub(crate) fn new(uri: Uri, version: i32, text: Text) -> Self {
        Self { uri, version, text, syntax: OnceLock::new() }
    }

    /// Its commands and variables as they are written.
    pub(crate) fn syntax(&self) -> &Syntax {
        self.syntax.get_or_init(|| match self.is_python() {
            true => python::syntax(self.text.as_str()),
            false => Syntax::of(self.text.as_str()),
        })
    }

    /// Returns true if the file is one of Python.
    pub(crate) fn is_python(&self) -> bool {
        self.uri.as_str().ends_with(".py")
    }
}

/// Results of the checks of a root.
#[derive(Default)]
pub(crate) struct Known {
    pub(crate) checked: Checked,
    /// The last index of a text that could be read to its end.
    pub(crate) script: Option<Arc<Script>>,
}

/// A place in a script as an editor asks for it: all that is known there.
pub(crate) struct View<'a> {
    pub(crate) path: &'a str,
    pub(crate) buffer: &'a Buffer,
    pub(crate) buffers: &'a BTreeMap<String, Buffer>,
    pub(crate) known: Option<&'a Known>,
    shift: Shift,
}

/// A word of a command as it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct WordAt {
    /// Number of the command among those of the text.
    pub(crate) command: usize,
    /// Number of the word, the name being 0.
    pub(crate) word: usize,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

impl<'a> View<'a> {
    pub(crate) fn new(
        path: &'a str,
        buffer: &'a Buffer,
        buffers: &'a BTreeMap<String, Buffer>,
        known: Option<&'a Known>,
    ) -> Self {
        let checked = known.and_then(|k| k.script.as_deref()).and_then(|s| s.text(path));
        let text = buffer.text.as_str();
        let shift = Shift::between(checked.map_or(text, |t| t), text);
        Self { path, buffer, buffers, known, shift }
    }

    pub(crate) fn script(&self) -> Option<&'a Script> {
        self.known?.script.as_deref()
    }

    pub(crate) fn text(&self) -> &'a str {
        self.buffer.text.as_str()
    }

    /// Returns true if the file is a script.
    pub(crate) fn is_script(&self) -> bool {
        FileKind::of(self.path, self.text()) == FileKind::Script
    }

    /// Returns true if the file has commands: it is a script, or one of Python.
    pub(crate) fn has_commands(&self) -> bool {
        self.is_script() || self.buffer.is_python()
    }

    /// The command that is being written before a byte; in a file of Python there may be none.
    pub(crate) fn line_before(&self, at: usize) -> Option<LineBefore<'a>> {
        match self.buffer.is_python() {
            true => python::before(self.text(), at),
            false => Some(line::before(self.text(), at)),
        }
    }

    /// Byte of the checked text that is at a byte of this one.
    pub(crate) fn checked(&self, at: usize) -> Option<usize> {
        self.shift.back(at)
    }

    /// Byte of this text that was at a byte of the checked one.
    pub(crate) fn current(&self, at: usize) -> Option<usize> {
        self.shift.forward(at)
    }

    /// The word around a byte, in the innermost command there.
    pub(crate) fn word_at(&self, at: usize) -> Option<WordAt> {
        let commands = &self.buffer.syntax().commands;
        let around = |(_, c): &(usize, &hysteron_tcl::WrittenCommand)| c.start <= at && at <= c.end;
        let (command, c) = commands.iter().enumerate().filter(around).min_by_key(|(_, c)| c.end - c.start)?;
        let (word, &(start, end)) = c.words.iter().enumerate().find(|(_, w)| w.0 <= at && at <= w.1)?;
        Some(WordAt { command, word, start, end })
    }

    /// The word that a command in brackets stands in.
    pub(crate) fn bracket_around(&self, word: &WordAt) -> Option<WordAt> {
        let commands = &self.buffer.syntax().commands;
        let command = commands.get(word.command)?.parent?;
        let within = |w: &(usize, usize)| w.0 < word.start && word.end < w.1;
        let (number, &(start, end)) = commands.get(command)?.words.iter().enumerate().find(|(_, w)| within(w))?;
        let is_bracket = self.text().get(start..end)?.starts_with('[');
        is_bracket.then_some(WordAt { command, word: number, start, end })
    }

    /// The words of a command as they are written.
    pub(crate) fn written(&self, command: usize) -> Vec<&'a str> {
        let text = self.text();
        let words = self.buffer.syntax().commands.get(command).map(|c| c.words.as_slice()).unwrap_or_default();
        let word = |(a, b): &(usize, usize)| text.get(*a..*b).unwrap_or_default();
        let bare = |w| if self.buffer.is_python() { python::bare(word(w)) } else { word(w) };
        words.iter().map(bare).collect()
    }

    /// Range of a place in the editor.
    pub(crate) fn location(&self, place: &Place) -> Option<Location> {
        let (uri, range) = match self.buffers.get(&place.path) {
            Some(open) => {
                let own = View::new(&place.path, open, self.buffers, self.known);
                let (start, end) = (own.current(place.start)?, own.current(place.end)?);
                (open.uri.clone(), open.text.range(start, end))
            }
            None => (uri::from_path(&place.path)?, self.closed_range(place)?),
        };
        Some(Location { uri, range })
    }

    fn closed_range(&self, place: &Place) -> Option<Range> {
        let text = self.script().and_then(|s| s.text(&place.path));
        let text = text.or_else(|| self.known?.checked.texts.get(&place.path))?;
        Some(Text::new(text).range(place.start, place.end))
    }
}
