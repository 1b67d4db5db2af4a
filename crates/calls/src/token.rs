//! Words of a text in Python, with their places.

use std::ops::Range;

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A name or a keyword.
    Name,
    /// A number.
    Number,
    /// A text in quotes, with its prefix.
    Text,
    /// An operator, a bracket, a comma.
    Sign,
}

/// A token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) at: Range<usize>,
}

/// A logical line: its indentation, and its tokens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    pub(crate) indent: usize,
    pub(crate) tokens: Range<usize>,
}

/// Tokens of a text by logical lines.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tokens {
    pub(crate) all: Vec<Token>,
    pub(crate) lines: Vec<Line>,
    /// Place of the bracket or quote that is never closed.
    pub(crate) unclosed: Option<Range<usize>>,
}

/// Signs of two or three bytes.
const LONG_SIGNS: [&str; 23] = [
    "**=", "//=", ">>=", "<<=", "...", "**", "//", ">>", "<<", "<=", ">=", "==", "!=", "->", ":=", "+=", "-=", "*=",
    "/=", "%=", "&=", "|=", "^=",
];

impl Tokens {
    /// Of a text.
    pub(crate) fn of(text: &str) -> Self {
        let mut scanner = Scanner { text, at: 0, out: Self::default(), brackets: vec![], first: 0, indent: 0 };
        while scanner.step() {}
        scanner.end_line();
        if let Some(open) = scanner.brackets.first() {
            scanner.out.unclosed.get_or_insert(*open..open + 1);
        }
        scanner.out
    }
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    out: Tokens,
    /// Places of the open brackets.
    brackets: Vec<usize>,
    /// First token of the line.
    first: usize,
    indent: usize,
}

impl Scanner<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn push(&mut self, kind: Kind, end: usize) {
        if self.first == self.out.all.len() {
            let line = self.text[..self.at].rfind('\n').map_or(0, |i| i + 1);
            self.indent = self.at - line;
        }
        self.out.all.push(Token { kind, at: self.at..end });
        self.at = end;
    }

    fn end_line(&mut self) {
        let tokens = self.first..self.out.all.len();
        if !tokens.is_empty() {
            self.out.lines.push(Line { indent: self.indent, tokens });
        }
        self.first = self.out.all.len();
    }

    /// Take the next token or blank; false at the end.
    fn step(&mut self) -> bool {
        let Some(c) = self.rest().chars().next() else { return false };
        match c {
            '\n' => {
                if self.brackets.is_empty() {
                    self.end_line();
                }
                self.at += 1;
            }
            '\\' if self.rest().starts_with("\\\n") => self.at += 2,
            '#' => self.at += self.rest().find('\n').unwrap_or(self.rest().len()),
            c if c.is_whitespace() => self.at += c.len_utf8(),
            '"' | '\'' => self.text_from(self.at),
            c if c.is_ascii_digit() || c == '.' && self.rest()[1..].starts_with(|d: char| d.is_ascii_digit()) => {
                self.number();
            }
            c if c.is_alphabetic() || c == '_' => {
                let length = self.rest().find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(self.rest().len());
                let is_prefix = length <= 2
                    && self.rest()[..length].chars().all(|c| "rRbBuUfF".contains(c))
                    && self.rest()[length..].starts_with(['"', '\'']);
                match is_prefix {
                    true => self.text_from(self.at + length),
                    false => self.push(Kind::Name, self.at + length),
                }
            }
            c => self.sign(c),
        }
        true
    }

    fn sign(&mut self, c: char) {
        match c {
            '(' | '[' | '{' => self.brackets.push(self.at),
            ')' | ']' | '}' => drop(self.brackets.pop()),
            _ => {}
        }
        let long = LONG_SIGNS.iter().find(|s| self.rest().starts_with(**s));
        self.push(Kind::Sign, self.at + long.map_or(c.len_utf8(), |s| s.len()));
    }

    fn number(&mut self) {
        let bytes = self.rest().as_bytes();
        let mut n = 1;
        while n < bytes.len() {
            let is_exponent_sign = matches!(bytes[n], b'+' | b'-')
                && matches!(bytes[n - 1], b'e' | b'E')
                && !self.rest().starts_with("0x")
                && !self.rest().starts_with("0X");
            if !(bytes[n].is_ascii_alphanumeric() || matches!(bytes[n], b'.' | b'_') || is_exponent_sign) {
                break;
            }
            n += 1;
        }
        self.push(Kind::Number, self.at + n);
    }

    /// A text whose quote is at a byte.
    fn text_from(&mut self, quote: usize) {
        let rest = &self.text[quote..];
        let mark = &rest[..1];
        let triple = mark.repeat(3);
        let (end_mark, is_long) = if rest.starts_with(&triple) { (triple.as_str(), true) } else { (mark, false) };
        let mut i = end_mark.len();
        while let Some(c) = rest[i..].chars().next() {
            if rest[i..].starts_with(end_mark) {
                return self.push(Kind::Text, quote + i + end_mark.len());
            }
            if c == '\n' && !is_long {
                break;
            }
            i += c.len_utf8();
            if c == '\\' {
                i += rest[i..].chars().next().map_or(0, char::len_utf8);
            }
        }
        self.out.unclosed.get_or_insert(quote..quote + end_mark.len());
        // A quote that the line does not close ends with it.
        self.push(Kind::Text, quote + i);
    }
}

#[cfg(test)]
mod tests {
    use super::Tokens;

    fn words(text: &str) -> Vec<Vec<&str>> {
        let tokens = Tokens::of(text);
        let line = |l: &super::Line| tokens.all[l.tokens.clone()].iter().map(|t| &text[t.at.clone()]).collect();
        tokens.lines.iter().map(line).collect()
    }

    #[test]
    fn lines_go_on_in_brackets_and_after_a_backslash() {
        let text = "ops.node(1,  # first\n  2.5e-3, r'a\\b')\nx = 3 \\\n  + .5\n\n'''a\nb'''; y**=2\n";
        assert_eq!(
            words(text),
            [
                vec!["ops", ".", "node", "(", "1", ",", "2.5e-3", ",", "r'a\\b'", ")"],
                vec!["x", "=", "3", "+", ".5"],
                vec!["'''a\nb'''", ";", "y", "**=", "2"],
            ]
        );
        assert_eq!(Tokens::of(text).unclosed, None);
    }

    #[test]
    fn what_is_never_closed_has_a_place() {
        assert_eq!(Tokens::of("a = (1\nb = 2").unclosed, Some(4..5));
        assert_eq!(Tokens::of("a = 'x\nb = 2").unclosed, Some(4..5));
        assert_eq!(words("a = 'x\nb = 2").len(), 2);
        for text in ["\"", "'''", "\\", "0x", "é'", ")", "1.2.3e", "f\"{a}\\", "\u{1d6fc}("] {
            let _ = Tokens::of(text);
        }
    }
}
