//! The commands of a text, one by one, for those who edit scripts.

use super::ast::Unit;
use super::lexer;
use std::rc::Rc;

/// A command of the outermost level of a script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TopLevel {
    /// First byte.
    pub start: usize,
    /// Byte after its last.
    pub end: usize,
    /// Its first word as it is written.
    pub name: String,
    /// First byte of each word, and the byte after its last.
    pub words: Vec<(usize, usize)>,
}

/// The commands of the outermost level, up to the first that cannot be parsed.
pub fn top_level(text: &str) -> Vec<TopLevel> {
    let unit = Rc::new(Unit { text: text.into(), origin: None });
    let script = lexer::script(&unit);
    let command = |c: &super::ast::Command| {
        let name = c.words.first().map_or("", |w| unit.slice(w.start, w.end));
        let words = c.words.iter().map(|w| (w.start as usize, w.end as usize)).collect();
        TopLevel { start: c.start as usize, end: c.end as usize, name: name.to_owned(), words }
    };
    script.commands.iter().map(command).collect()
}
