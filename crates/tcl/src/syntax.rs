//! Commands and variables of a text as they are written, for editors. Nothing is run.

use super::ast::{Command, Index, Part, Script, Unit, VarRef, Word, WordKind};
use super::lexer;
use super::stretch::Stretch;
use std::rc::Rc;

/// A command as it is written, at any depth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenCommand {
    /// First byte.
    pub start: usize,
    /// Byte after its last.
    pub end: usize,
    /// First byte of each word, and the byte after its last.
    pub words: Vec<(usize, usize)>,
    /// Number of the command in whose words it stands.
    pub parent: Option<usize>,
}

/// A variable that is read with a dollar sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenVariable {
    /// The dollar sign.
    pub start: usize,
    /// Byte after the name and its index.
    pub end: usize,
    /// Its name without index.
    pub name: String,
    /// Number of the innermost command around it.
    pub command: usize,
}

/// Commands and variables of a text. A braced word is read as a script, whatever it is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Syntax {
    /// The commands, each before those in its words.
    pub commands: Vec<WrittenCommand>,
    /// The variables, in the order of the commands.
    pub variables: Vec<WrittenVariable>,
}

/// Depth of braces that are looked into.
const MAX_DEPTH: usize = 60;
/// Places at which a text that cannot be parsed is taken up again.
const MAX_RESTARTS: usize = 200;

impl Syntax {
    /// Of a text. After what cannot be parsed, it goes on with the next line.
    pub fn of(text: &str) -> Self {
        let mut out = Self::default();
        let (mut from, mut restarts) = (0, 0);
        while let Some(rest) = text.get(from..).filter(|r| !r.is_empty()) {
            let unit = Rc::new(Unit { text: Stretch::from(rest), origin: None });
            let script = lexer::script(&unit);
            out.script(&script, from, None, 0);
            let Some(error) = &script.error else { break };
            restarts += 1;
            let last = script.commands.last().map_or(0, |c| c.end as usize);
            let at = last.max(error.start as usize).min(rest.len());
            match rest.as_bytes()[at..].iter().position(|b| *b == b'\n') {
                Some(line) if restarts < MAX_RESTARTS => from += at + line + 1,
                _ => break,
            }
        }
        out
    }

    fn script(&mut self, script: &Script, base: usize, parent: Option<usize>, depth: usize) {
        script.commands.iter().for_each(|c| self.command(&script.unit, c, base, parent, depth));
    }

    fn command(&mut self, unit: &Rc<Unit>, c: &Command, base: usize, parent: Option<usize>, depth: usize) {
        let number = self.commands.len();
        let words = c.words.iter().map(|w| (base + w.start as usize, base + w.end as usize)).collect();
        let (start, end) = (base + c.start as usize, base + c.end as usize);
        self.commands.push(WrittenCommand { start, end, words, parent });
        c.words.iter().for_each(|w| self.word(unit, w, base, number, depth));
    }

    fn word(&mut self, unit: &Rc<Unit>, word: &Word, base: usize, command: usize, depth: usize) {
        match &word.kind {
            WordKind::Literal(_) => {
                let start = word.start + if word.expand { 3 } else { 0 };
                let inner = unit.slice(start, word.end).strip_prefix('{').and_then(|t| t.strip_suffix('}'));
                let Some(inner) = inner.filter(|_| depth < MAX_DEPTH) else { return };
                let within = Rc::new(Unit { text: Stretch::from(inner), origin: None });
                let script = lexer::script(&within);
                self.script(&script, base + start as usize + 1, Some(command), depth + 1);
            }
            WordKind::Var(v) => self.variable(v, base, command, depth),
            WordKind::Script(s) => self.script(s, base, Some(command), depth + 1),
            WordKind::Parts(parts) => self.parts(parts, base, command, depth),
        }
    }

    fn parts(&mut self, parts: &[Part], base: usize, command: usize, depth: usize) {
        for part in parts {
            match part {
                Part::Text(_) => {}
                Part::Var(v) => self.variable(v, base, command, depth),
                Part::Script(s) => self.script(s, base, Some(command), depth + 1),
            }
        }
    }

    fn variable(&mut self, v: &VarRef, base: usize, command: usize, depth: usize) {
        let (start, end) = (base + v.start as usize, base + v.end as usize);
        self.variables.push(WrittenVariable { start, end, name: v.name.text.to_string(), command });
        if let Some(Index::Parts(parts)) = &v.index {
            self.parts(parts, base, command, depth);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::Syntax;

    #[test]
    fn commands_in_braces_and_brackets_know_their_places() {
        let text = "set a 1\nfor {set i 0} {$i < $a} {incr i} {\n  node $i [expr {$a*2}] 0\n}\n";
        let s = Syntax::of(text);
        let written: Vec<&str> = s.commands.iter().map(|c| &text[c.words[0].0..c.words[0].1]).collect();
        assert_eq!(written, ["set", "for", "set", "$i", "incr", "node", "expr", "$a*2"]);
        let node = &s.commands[5];
        assert_eq!(&text[node.start..node.end], "node $i [expr {$a*2}] 0");
        assert_eq!(node.parent, Some(1));
        let names: Vec<(&str, &str)> = s.variables.iter().map(|v| (v.name.as_str(), &text[v.start..v.end])).collect();
        assert_eq!(names, [("i", "$i"), ("a", "$a"), ("i", "$i"), ("a", "$a")]);
    }

    #[test]
    fn what_is_half_typed_hides_no_later_line() {
        let text = "node 1 0\npattern Plain 1 1 {\nload 1 $P\nnode 2 1\n";
        let s = Syntax::of(text);
        let written: Vec<&str> = s.commands.iter().map(|c| &text[c.start..c.end]).collect();
        assert_eq!(written, ["node 1 0", "load 1 $P", "node 2 1"]);
        assert_eq!(Syntax::of("").commands.len(), 0);
        assert_eq!(Syntax::of("{").commands.len() + Syntax::of("[").commands.len(), 0);
    }
}
