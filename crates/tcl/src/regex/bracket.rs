//! Sets of characters in brackets.

use super::translate::{Atom, Translator, bad_escape, push_literal, refuse};
use crate::error::Exception;

impl Translator<'_> {
    pub(super) fn bracket(&mut self) -> Result<Atom, Exception> {
        let unbalanced = || refuse("brackets [] not balanced", "EBRACK");
        let rest: String = self.chars.clone().take(6).collect();
        for (word, boundary) in [("[:<:]]", "\\b{start}"), ("[:>:]]", "\\b{end}")] {
            if rest == word {
                self.chars.nth(5);
                self.out.push_str(boundary);
                return Ok(Atom { preference: None, repeatable: false, wrap: false });
            }
        }
        let negated = self.chars.next_if_eq(&'^').is_some();
        let mut set = String::new();
        let mut first = true;
        loop {
            let Some(c) = self.chars.next() else { return Err(unbalanced()) };
            if c == ']' && !first {
                break;
            }
            first = false;
            let Some(low) = self.bracket_item(c, &mut set)? else { continue };
            let mut ahead = self.chars.clone();
            let is_range = ahead.next() == Some('-') && ahead.next().is_some_and(|c| c != ']');
            push_literal(&mut set, low);
            if !is_range {
                continue;
            }
            self.chars.next();
            let Some(c) = self.chars.next() else { return Err(unbalanced()) };
            let mut class = String::new();
            let Some(high) = self.bracket_item(c, &mut class)? else {
                return Err(refuse("invalid character range", "ERANGE"));
            };
            if high < low {
                return Err(refuse("invalid character range", "ERANGE"));
            }
            set.push('-');
            push_literal(&mut set, high);
        }
        if negated && self.flags.line_stop {
            set.push_str("\\n");
        }
        self.out.push_str(if negated { "[^" } else { "[" });
        self.out.push_str(&set);
        self.out.push(']');
        Ok(Atom { preference: None, repeatable: true, wrap: false })
    }

    /// One character in brackets; none where a class was put in.
    fn bracket_item(&mut self, c: char, set: &mut String) -> Result<Option<char>, Exception> {
        match c {
            '\\' => {
                let Some(c) = self.chars.next() else { return Err(bad_escape()) };
                match c {
                    'd' | 's' | 'w' => {
                        set.push('\\');
                        set.push(c);
                        Ok(None)
                    }
                    'D' | 'S' | 'W' => Err(bad_escape()),
                    c => self.escaped_char(c)?.map(Some).ok_or_else(bad_escape),
                }
            }
            '[' if matches!(self.chars.peek(), Some(':' | '.' | '=')) => {
                let Some(kind) = self.chars.next() else { return Err(bad_escape()) };
                let mut name = String::new();
                loop {
                    match self.chars.next() {
                        Some(c) if c == kind && self.chars.peek() == Some(&']') => break,
                        Some(c) => name.push(c),
                        None => return Err(refuse("brackets [] not balanced", "EBRACK")),
                    }
                }
                self.chars.next();
                if kind == ':' {
                    set.push_str(class(&name)?);
                    return Ok(None);
                }
                let mut letters = name.chars();
                match (letters.next(), letters.next()) {
                    (Some(c), None) => Ok(Some(c)),
                    _ => Err(refuse("invalid collating element", "ECOLLATE")),
                }
            }
            c => Ok(Some(c)),
        }
    }
}

/// A named class of characters.
fn class(name: &str) -> Result<&'static str, Exception> {
    Ok(match name {
        "alnum" => "\\p{Alphabetic}\\p{Nd}",
        "alpha" => "\\p{Alphabetic}",
        "ascii" => "\\x00-\\x7f",
        "blank" => " \\t",
        "cntrl" => "\\p{Cc}",
        "digit" => "\\d",
        "graph" => "[[:graph:]]",
        "lower" => "\\p{Lowercase}",
        "print" => "[[:print:]]",
        "punct" => "[\\p{P}]",
        "space" => "\\s",
        "upper" => "\\p{Uppercase}",
        "word" => "\\w",
        "xdigit" => "0-9A-Fa-f",
        _ => return Err(refuse("invalid character class", "ECTYPE")),
    })
}
