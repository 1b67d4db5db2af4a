//! From text to commands, words and substitutions.

use std::cell::Cell;
use std::rc::Rc;

use super::ast::{Command, Index, ParseError, Part, Script, Unit, VarRef, Word, WordKind};
use super::escape::backslash;
use super::inline::Inline;
use super::origin::Origin;
use super::stack;
use super::stretch::MIN_SHARED;
use super::value::Value;
use super::vars::VarName;

/// Limit of nested brackets and parentheses in one text.
pub(crate) const MAX_NESTING: usize = 1000;

/// A letter, digit or underscore: what names of variables and functions are made of.
pub(crate) fn is_word_byte(b: u8) -> bool {
    b.is_ascii_alphanumeric() || b == b'_'
}

/// Parse a whole text as a script.
pub(crate) fn script(unit: &Rc<Unit>) -> Script {
    let mut lexer = Lexer::new(unit);
    let (commands, error) = lexer.commands(false);
    Script { unit: unit.clone(), commands, error }
}

/// Substitutions that `subst` makes.
#[derive(Clone, Copy)]
pub(crate) struct Substitutions {
    pub(crate) backslashes: bool,
    pub(crate) commands: bool,
    pub(crate) variables: bool,
}

const ALL: Substitutions = Substitutions { backslashes: true, commands: true, variables: true };

/// End of a row of parts.
#[derive(Clone, Copy, PartialEq)]
enum Stop {
    /// At a blank or the end of the command; in brackets also at the closing one.
    Word {
        nested: bool,
    },
    Quote,
    Paren,
    End,
}

/// Text being collected, with the places where bytes went missing.
#[derive(Default)]
struct Collected {
    text: String,
    start: usize,
    shifts: Vec<(u32, u32)>,
}

impl Collected {
    fn push_raw(&mut self, raw: &str, at: usize) {
        if self.text.is_empty() && self.shifts.is_empty() {
            self.start = at;
        }
        self.text.push_str(raw);
    }

    /// A sequence of `length` bytes that became one character.
    fn push_replaced(&mut self, c: char, at: usize, length: usize) {
        if self.text.is_empty() && self.shifts.is_empty() {
            self.start = at;
        }
        self.text.push(c);
        let lost = (at + length - self.start).saturating_sub(self.text.len());
        self.shifts.push((self.text.len() as u32, lost as u32));
    }
}

/// A place in a text that is being parsed.
pub(crate) struct Lexer<'a> {
    unit: &'a Rc<Unit>,
    text: &'a str,
    pub(crate) pos: usize,
    depth: usize,
}

impl<'a> Lexer<'a> {
    pub(crate) fn new(unit: &'a Rc<Unit>) -> Self {
        Self { unit, text: &unit.text, pos: 0, depth: 0 }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.pos).copied()
    }

    fn peek_at(&self, ahead: usize) -> Option<u8> {
        self.text.as_bytes().get(self.pos + ahead).copied()
    }

    fn origin(&self) -> Option<&Origin> {
        self.unit.origin.as_ref()
    }

    fn error(&self, message: impl Into<String>, start: usize, end: usize, label: &'static str) -> ParseError {
        ParseError {
            message: message.into(),
            start: start as u32,
            end: end.min(self.text.len()) as u32,
            label,
            help: None,
            never_closed: false,
        }
    }

    /// The error for what is still open at the end of the text.
    fn open(&self, message: &str, start: usize, end: usize, label: &'static str) -> ParseError {
        ParseError { never_closed: true, ..self.error(message, start, end, label) }
    }

    /// Skip blanks and continued lines between words.
    fn skip_blanks(&mut self) {
        loop {
            match self.peek() {
                Some(b' ' | b'\t' | b'\r' | 0x0b | 0x0c) => self.pos += 1,
                Some(b'\\') if self.peek_at(1) == Some(b'\n') => self.pos += 2,
                _ => return,
            }
        }
    }

    fn skip_comment(&mut self) {
        while let Some(b) = self.peek() {
            match b {
                b'\n' => return,
                b'\\' => self.pos += 2,
                _ => self.pos += 1,
            }
        }
        self.pos = self.pos.min(self.text.len());
    }

    /// Parse commands to the end of the text or, nested, to the closing bracket.
    fn commands(&mut self, nested: bool) -> (Vec<Command>, Option<ParseError>) {
        let mut commands = Vec::new();
        loop {
            self.skip_blanks();
            match self.peek() {
                None => return (commands, None),
                Some(b'\n' | b';') => self.pos += 1,
                Some(b'#') => self.skip_comment(),
                Some(b']') if nested => return (commands, None),
                Some(_) => match self.command(nested) {
                    Ok(command) => commands.push(command),
                    Err(e) => return (commands, Some(e)),
                },
            }
        }
    }

    fn at_command_end(&self, nested: bool) -> bool {
        match self.peek() {
            None | Some(b'\n' | b';') => true,
            Some(b']') => nested,
            Some(_) => false,
        }
    }

    fn command(&mut self, nested: bool) -> Result<Command, ParseError> {
        let start = self.pos;
        let mut end = self.pos;
        let mut words = Vec::new();
        while !self.at_command_end(nested) {
            words.push(self.word(nested)?);
            end = self.pos;
            self.skip_blanks();
        }
        let inline = Inline::of(&words);
        let (form, is_flat) = (inline.number(), inline.is_flat(&words));
        let (start, end) = (start as u32, end as u32);
        let span = self.unit.span(start, end);
        Ok(Command { words: words.into(), start, end, span, found: Cell::default(), inline, form, is_flat })
    }

    fn word(&mut self, nested: bool) -> Result<Word, ParseError> {
        let start = self.pos;
        let is_end = |b: Option<u8>| matches!(b, None | Some(b' ' | b'\t' | b'\r' | 0x0b | 0x0c | b'\n' | b';'));
        let expand = self.text[self.pos..].starts_with("{*}") && !is_end(self.peek_at(3));
        if expand {
            self.pos += 3;
        }
        let kind = match self.peek() {
            Some(b'{') => {
                let value = self.braced()?;
                self.must_end(nested, "close-brace")?;
                WordKind::Literal(value)
            }
            Some(b'"') => {
                let parts = self.quoted()?;
                self.must_end(nested, "close-quote")?;
                parts
            }
            _ => self.parts(Stop::Word { nested }, ALL)?,
        };
        Ok(Word { kind, start: start as u32, end: self.pos as u32, expand })
    }

    /// After a closing brace or quote there must be a blank or the end of the command.
    fn must_end(&mut self, nested: bool, after: &str) -> Result<(), ParseError> {
        match self.peek() {
            Some(b' ' | b'\t' | b'\r' | 0x0b | 0x0c) => Ok(()),
            Some(b'\\') if self.peek_at(1) == Some(b'\n') => Ok(()),
            _ if self.at_command_end(nested) => Ok(()),
            _ => {
                let message = format!("extra characters after {after}");
                let rest = &self.text[self.pos..];
                let length = rest.find(|c: char| c.is_whitespace() || c == ';').unwrap_or(rest.len());
                Err(self.error(message, self.pos, self.pos + length, "a blank or the end of the command belongs here"))
            }
        }
    }

    /// A braced text at the current place.
    pub(crate) fn braced(&mut self) -> Result<Value, ParseError> {
        let open = self.pos;
        let bytes = self.text.as_bytes();
        let mut collected = Collected { start: open + 1, ..Collected::default() };
        let mut taken = open + 1;
        let mut depth = 1usize;
        let mut i = open + 1;
        while let Some(&b) = bytes.get(i) {
            match b {
                b'{' => depth += 1,
                b'}' => {
                    depth -= 1;
                    if depth == 0 {
                        self.pos = i + 1;
                        // Only texts of files: a text made at run time would be kept by each of its words.
                        if taken == open + 1 && i - taken >= MIN_SHARED && self.origin().is_some() {
                            let origin = self.origin().map(|o| o.slice(taken, i));
                            return Ok(Value::shared(self.unit.text.part(taken..i), origin));
                        }
                        collected.push_raw(&self.text[taken..i], taken);
                        return Ok(self.literal(collected));
                    }
                }
                b'\\' if bytes.get(i + 1) == Some(&b'\n') => {
                    collected.push_raw(&self.text[taken..i], taken);
                    let (length, c) = backslash(self.text, i);
                    collected.push_replaced(c, i, length);
                    i += length;
                    taken = i;
                    continue;
                }
                b'\\' => i += 1,
                _ => {}
            }
            i += 1;
        }
        let mut error = self.open("missing close-brace", open, open + 1, "this brace is never closed");
        if brace_in_comment(&self.text[open..]) {
            error.message.push_str(": possible unbalanced brace in comment");
            error.help = Some("braces count in comments too");
        }
        Err(error)
    }

    fn literal(&self, collected: Collected) -> Value {
        let Collected { text, start, mut shifts } = collected;
        shifts.retain(|s| (s.0 as usize) < text.len());
        let origin = self.origin().map(|o| o.part(start as u32, text.len() as u32, &shifts));
        Value::literal(text, origin)
    }

    /// A quoted text at the current place.
    pub(crate) fn quoted(&mut self) -> Result<WordKind, ParseError> {
        let open = self.pos;
        self.pos += 1;
        let kind = self.parts(Stop::Quote, ALL)?;
        if self.peek() != Some(b'"') {
            return Err(self.open("missing \"", open, open + 1, "this quote is never closed"));
        }
        self.pos += 1;
        Ok(kind)
    }

    /// The whole text as `subst` takes it. What is wrong comes with the parts before it.
    pub(crate) fn template(&mut self, which: Substitutions) -> (Vec<Part>, Option<ParseError>) {
        let mut parts = Vec::new();
        let mut collected = Collected::default();
        let error = self.collect(Stop::End, which, &mut parts, &mut collected).err();
        if !collected.text.is_empty() {
            parts.push(Part::Text(collected.text.into()));
        }
        (parts, error)
    }

    fn parts(&mut self, stop: Stop, which: Substitutions) -> Result<WordKind, ParseError> {
        let mut parts = Vec::new();
        let mut collected = Collected { start: self.pos, ..Collected::default() };
        self.collect(stop, which, &mut parts, &mut collected)?;
        if parts.is_empty() {
            return Ok(WordKind::Literal(self.literal(collected)));
        }
        if !collected.text.is_empty() {
            parts.push(Part::Text(collected.text.into()));
        } else if parts.len() == 1 {
            return Ok(match parts.pop() {
                Some(Part::Var(v)) => WordKind::Var(v),
                Some(Part::Script(s)) => WordKind::Script(s),
                Some(Part::Text(t)) => WordKind::Literal(Value::from(&*t)),
                None => WordKind::Literal(Value::EMPTY),
            });
        }
        Ok(WordKind::Parts(parts.into()))
    }

    fn collect(
        &mut self,
        stop: Stop,
        which: Substitutions,
        parts: &mut Vec<Part>,
        collected: &mut Collected,
    ) -> Result<(), ParseError> {
        let mut taken = self.pos;
        let flush = |collected: &mut Collected, parts: &mut Vec<Part>| {
            let text = std::mem::take(collected).text;
            if !text.is_empty() {
                parts.push(Part::Text(text.into()));
            }
        };
        while let Some(b) = self.peek() {
            let ends = match (b, stop) {
                (b' ' | b'\t' | b'\r' | 0x0b | 0x0c | b'\n' | b';', Stop::Word { .. }) => true,
                (b']', Stop::Word { nested }) => nested,
                (b'"', Stop::Quote) | (b')', Stop::Paren) => true,
                _ => false,
            };
            if ends {
                break;
            }
            match b {
                b'\\' if which.backslashes => {
                    if self.peek_at(1) == Some(b'\n') && matches!(stop, Stop::Word { .. }) {
                        break;
                    }
                    collected.push_raw(&self.text[taken..self.pos], taken);
                    let (length, c) = backslash(self.text, self.pos);
                    collected.push_replaced(c, self.pos, length);
                    self.pos += length;
                    taken = self.pos;
                }
                b'$' if which.variables => {
                    let before = self.pos;
                    collected.push_raw(&self.text[taken..before], taken);
                    taken = before;
                    match self.variable()? {
                        Some(var) => {
                            flush(collected, parts);
                            parts.push(Part::Var(var));
                            taken = self.pos;
                        }
                        None => self.pos += 1,
                    }
                }
                b'[' if which.commands => {
                    collected.push_raw(&self.text[taken..self.pos], taken);
                    let script = self.bracketed()?;
                    flush(collected, parts);
                    parts.push(Part::Script(script));
                    taken = self.pos;
                }
                _ => self.pos += 1,
            }
        }
        self.pos = self.pos.min(self.text.len());
        collected.push_raw(&self.text[taken..self.pos], taken);
        Ok(())
    }

    /// A script in brackets at the current place.
    pub(crate) fn bracketed(&mut self) -> Result<Rc<Script>, ParseError> {
        let open = self.pos;
        self.deeper(open)?;
        self.pos += 1;
        let (commands, error) = stack::grow(|| self.commands(true));
        self.depth -= 1;
        if let Some(e) = error {
            return Err(e);
        }
        if self.peek() != Some(b']') {
            return Err(self.open("missing close-bracket", open, open + 1, "this bracket is never closed"));
        }
        self.pos += 1;
        Ok(Rc::new(Script { unit: self.unit.clone(), commands, error: None }))
    }

    fn deeper(&mut self, at: usize) -> Result<(), ParseError> {
        self.depth += 1;
        if self.depth > MAX_NESTING {
            let message = "too many nested evaluations (infinite loop?)";
            return Err(self.error(message, at, at + 1, "nested too deep"));
        }
        Ok(())
    }

    /// The variable at a dollar sign; none where the dollar stands for itself.
    pub(crate) fn variable(&mut self) -> Result<Option<VarRef>, ParseError> {
        let start = self.pos;
        if self.peek_at(1) == Some(b'{') {
            let from = start + 2;
            let Some(length) = self.text[from..].find('}') else {
                let label = "this brace is never closed";
                return Err(self.open("missing close-brace for variable name", start, from, label));
            };
            self.pos = from + length + 1;
            let name = VarName::parse(&self.text[from..from + length]);
            let index = name.element.clone().map(Index::Text);
            return Ok(Some(VarRef { name, index, start: start as u32, end: self.pos as u32 }));
        }
        let mut end = start + 1;
        let bytes = self.text.as_bytes();
        loop {
            match bytes.get(end) {
                Some(&b) if is_word_byte(b) => end += 1,
                Some(b':') if bytes.get(end + 1) == Some(&b':') => {
                    while bytes.get(end) == Some(&b':') {
                        end += 1;
                    }
                }
                _ => break,
            }
        }
        let name = &self.text[start + 1..end];
        if bytes.get(end) != Some(&b'(') {
            if name.is_empty() {
                return Ok(None);
            }
            self.pos = end;
            return Ok(Some(VarRef { name: VarName::simple(name), index: None, start: start as u32, end: end as u32 }));
        }
        self.deeper(start)?;
        self.pos = end + 1;
        let kind = stack::grow(|| self.parts(Stop::Paren, ALL))?;
        self.depth -= 1;
        if self.peek() != Some(b')') {
            return Err(self.open("missing )", end, end + 1, "this parenthesis is never closed"));
        }
        self.pos += 1;
        let index = match kind {
            WordKind::Literal(v) => Index::Text(v.to_text()),
            WordKind::Var(v) => Index::Parts([Part::Var(v)].into()),
            WordKind::Script(s) => Index::Parts([Part::Script(s)].into()),
            WordKind::Parts(p) => Index::Parts(Vec::from(p).into()),
        };
        let name = VarName::simple(name);
        Ok(Some(VarRef { name, index: Some(index), start: start as u32, end: self.pos as u32 }))
    }
}

/// Returns true if a comment may hold the brace that is not closed: `#` after a blank and `{` later on its line.
fn brace_in_comment(text: &str) -> bool {
    let bytes = text.as_bytes();
    let mut open = false;
    for i in (1..bytes.len()).rev() {
        match bytes[i] {
            b'{' => open = true,
            b'\n' => open = false,
            b'#' if open && super::number::is_space(bytes[i - 1]) => return true,
            _ => {}
        }
    }
    false
}

/// Result of `info complete`: true if nothing is left open at the end of the text.
pub(crate) fn is_complete(text: &str) -> bool {
    let unit = Rc::new(Unit { text: text.into(), origin: None });
    match &script(&unit).error {
        Some(e) => !e.never_closed,
        None => true,
    }
}
