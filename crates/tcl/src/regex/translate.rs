//! From Tcl's syntax of regular expressions to that of the engines.

use std::iter::Peekable;
use std::str::Chars;

use super::Flags;
use crate::error::Exception;

/// A translated pattern.
pub(super) struct Translated {
    pub(super) text: String,
    pub(super) groups: usize,
    /// True if only the backtracking engine can match it.
    pub(super) fancy: bool,
    /// True for the longest of the matches, false for the shortest.
    pub(super) longest: bool,
    /// True if there is only one way to match from a given place.
    pub(super) simple: bool,
    /// True if it has `\A`, which matches at the start of the search.
    pub(super) anchored: bool,
}

pub(super) fn refuse(why: &str, code: &str) -> Exception {
    let message = format!("couldn't compile regular expression pattern: {why}");
    Exception::coded(message, &["REGEXP", &format!("REG_{code}"), why])
}

fn not_balanced_paren() -> Exception {
    refuse("parentheses () not balanced", "EPAREN")
}

pub(super) fn bad_escape() -> Exception {
    refuse("invalid escape \\ sequence", "EESCAPE")
}

pub(super) fn translate(pattern: &str, flags: Flags) -> Result<Translated, Exception> {
    let (pattern, flags) = director(pattern, flags)?;
    let mut t = Translator {
        chars: pattern.chars().peekable(),
        flags,
        out: String::from(if flags.nocase { "(?si)" } else { "(?s)" }),
        groups: 0,
        open: 0,
        highest_reference: 0,
        fancy: false,
        simple: true,
        anchored: false,
    };
    if flags.line_anchor {
        t.out.push_str("(?m)");
    }
    if flags.literal {
        t.out.push_str(&escape(pattern));
        return Ok(Translated { text: t.out, groups: 0, fancy: false, longest: true, simple: true, anchored: false });
    }
    let longest = t.alternatives()?;
    if t.chars.peek().is_some() {
        return Err(not_balanced_paren());
    }
    if t.highest_reference > t.groups {
        return Err(refuse("invalid backreference number", "ESUBREG"));
    }
    Ok(Translated {
        text: t.out,
        groups: t.groups,
        fancy: t.fancy,
        longest: longest.unwrap_or(true),
        simple: t.simple,
        anchored: t.anchored,
    })
}

/// `***:`, `***=` and `(?letters)` at the start.
fn director(pattern: &str, mut flags: Flags) -> Result<(&str, Flags), Exception> {
    if let Some(rest) = pattern.strip_prefix("***=") {
        flags.literal = true;
        return Ok((rest, flags));
    }
    let rest = match pattern.strip_prefix("***") {
        Some(rest) => rest.strip_prefix(':').ok_or_else(|| refuse("quantifier operand invalid", "BADRPT"))?,
        None => pattern,
    };
    let letters = rest.strip_prefix("(?").and_then(|r| r.split_once(')'));
    let Some((letters, after)) = letters.filter(|(l, _)| !l.is_empty() && l.chars().all(|c| c.is_ascii_alphabetic()))
    else {
        return Ok((rest, flags));
    };
    for letter in letters.chars() {
        match letter {
            'c' => flags.nocase = false,
            'i' => flags.nocase = true,
            'm' | 'n' => (flags.line_stop, flags.line_anchor) = (true, true),
            'p' => (flags.line_stop, flags.line_anchor) = (true, false),
            'w' => (flags.line_stop, flags.line_anchor) = (false, true),
            's' => (flags.line_stop, flags.line_anchor) = (false, false),
            'q' => flags.literal = true,
            't' => flags.expanded = false,
            'x' => flags.expanded = true,
            'e' => {}
            _ => return Err(refuse("invalid embedded option", "BADOPT")),
        }
    }
    Ok((after, flags))
}

fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        push_literal(&mut out, c);
    }
    out
}

pub(super) fn push_literal(out: &mut String, c: char) {
    if c.is_ascii_punctuation() {
        out.push('\\');
    }
    match c {
        // Some engines do not know these backslashed.
        '"' | '\'' | ',' | '/' | ':' | ';' | '=' | '@' | '_' | '`' | '%' | '!' | '<' | '>' => {
            out.pop();
            out.push(c);
        }
        c => out.push(c),
    }
}

pub(super) struct Translator<'a> {
    pub(super) chars: Peekable<Chars<'a>>,
    pub(super) flags: Flags,
    pub(super) out: String,
    groups: usize,
    open: usize,
    highest_reference: usize,
    fancy: bool,
    simple: bool,
    anchored: bool,
}

/// Preference for a long match (true) or a short one (false); `None` without a choice.
pub(super) type Preference = Option<bool>;

impl Translator<'_> {
    fn skip_blanks(&mut self) {
        if !self.flags.expanded {
            return;
        }
        while let Some(&c) = self.chars.peek() {
            if c == '#' {
                while self.chars.next_if(|c| *c != '\n').is_some() {}
            } else if c.is_whitespace() {
                self.chars.next();
            } else {
                return;
            }
        }
    }

    fn alternatives(&mut self) -> Result<Preference, Exception> {
        let mut preference = self.branch()?;
        while self.chars.next_if_eq(&'|').is_some() {
            self.out.push('|');
            self.branch()?;
            preference = Some(true);
            self.simple = false;
        }
        Ok(preference)
    }

    fn branch(&mut self) -> Result<Preference, Exception> {
        let mut preference = None;
        let mut choices = 0;
        loop {
            self.skip_blanks();
            match self.chars.peek() {
                None | Some('|') => break,
                Some(')') if self.open > 0 => break,
                _ => {}
            }
            let own = self.quantified()?;
            if own.is_some() {
                choices += 1;
            }
            preference = preference.or(own);
        }
        // With two things to choose from, taking more of the first may leave less for the second.
        if choices > 1 {
            self.simple = false;
        }
        Ok(preference)
    }

    fn quantified(&mut self) -> Result<Preference, Exception> {
        let from = self.out.len();
        let atom = self.atom()?;
        self.skip_blanks();
        let (text, fixed) = match self.chars.peek() {
            Some('*') => ("*".to_owned(), false),
            Some('+') => ("+".to_owned(), false),
            Some('?') => ("?".to_owned(), false),
            Some('{') => match self.bound()? {
                Some((text, fixed)) => (text, fixed),
                None => return Ok(atom.preference),
            },
            _ => return Ok(atom.preference),
        };
        if !text.starts_with('{') {
            self.chars.next();
        }
        if !atom.repeatable {
            return Err(refuse("quantifier operand invalid", "BADRPT"));
        }
        if atom.preference.is_some() {
            self.simple = false;
        }
        if atom.wrap {
            self.out.insert_str(from, "(?:");
            self.out.push(')');
        }
        self.out.push_str(&text);
        let lazy = self.chars.next_if_eq(&'?').is_some();
        if lazy {
            self.out.push('?');
            self.simple = false;
        }
        if matches!(self.chars.peek(), Some('*' | '+' | '?')) || (self.chars.peek() == Some(&'{') && self.bound_ahead())
        {
            return Err(refuse("quantifier operand invalid", "BADRPT"));
        }
        Ok(if fixed { atom.preference } else { Some(!lazy) })
    }

    fn bound_ahead(&self) -> bool {
        let mut ahead = self.chars.clone();
        ahead.next();
        ahead.next().is_some_and(|c| c.is_ascii_digit())
    }

    /// `{m}`, `{m,}`, `{m,n}`; none where the brace stands for itself.
    fn bound(&mut self) -> Result<Option<(String, bool)>, Exception> {
        if !self.bound_ahead() {
            return Ok(None);
        }
        self.chars.next();
        let mut text = String::from("{");
        while let Some(c) = self.chars.next_if(|c| c.is_ascii_digit() || *c == ',') {
            text.push(c);
        }
        if self.chars.next() != Some('}') {
            return Err(if self.chars.peek().is_none() {
                refuse("braces {} not balanced", "EBRACE")
            } else {
                refuse("invalid repetition count(s)", "BADBR")
            });
        }
        let numbers: Vec<Option<u32>> = text[1..].split(',').map(|n| n.parse().ok()).collect();
        let valid = match *numbers {
            [Some(m)] => m <= 255,
            [Some(m), None] => m <= 255 && text.ends_with(','),
            [Some(m), Some(n)] => m <= n && n <= 255,
            _ => false,
        };
        if !valid {
            return Err(refuse("invalid repetition count(s)", "BADBR"));
        }
        text.push('}');
        Ok(Some((text, numbers.len() == 1)))
    }

    fn atom(&mut self) -> Result<Atom, Exception> {
        let single = Atom { preference: None, repeatable: true, wrap: false };
        let constraint = Atom { repeatable: false, ..single };
        let Some(c) = self.chars.next() else { return Ok(single) };
        match c {
            '(' => self.group(),
            '[' => self.bracket(),
            '.' => {
                self.out.push_str(if self.flags.line_stop { "[^\\n]" } else { "." });
                Ok(single)
            }
            '^' | '$' => {
                self.out.push(c);
                Ok(constraint)
            }
            '\\' => self.escape(),
            '*' | '+' | '?' => Err(refuse("quantifier operand invalid", "BADRPT")),
            '{' if self.chars.peek().is_some_and(char::is_ascii_digit) => {
                Err(refuse("quantifier operand invalid", "BADRPT"))
            }
            // A closing parenthesis without an opening one.
            ')' => Err(not_balanced_paren()),
            c => {
                push_literal(&mut self.out, c);
                Ok(single)
            }
        }
    }

    fn group(&mut self) -> Result<Atom, Exception> {
        let mut repeatable = true;
        if self.chars.next_if_eq(&'?').is_some() {
            match self.chars.next() {
                Some(':') => self.out.push_str("(?:"),
                Some(c @ ('=' | '!')) => {
                    self.out.push_str("(?");
                    self.out.push(c);
                    self.fancy = true;
                    repeatable = false;
                }
                Some('#') => {
                    // A comment.
                    while self.chars.next_if(|c| *c != ')').is_some() {}
                    self.chars.next();
                    self.out.push_str("(?:)");
                    return Ok(Atom { preference: None, repeatable: false, wrap: false });
                }
                _ => return Err(refuse("quantifier operand invalid", "BADRPT")),
            }
        } else {
            self.groups += 1;
            self.out.push('(');
        }
        self.open += 1;
        if self.open > 200 {
            return Err(refuse("regular expression is too complex", "ETOOBIG"));
        }
        let preference = self.alternatives()?;
        self.open -= 1;
        if self.chars.next() != Some(')') {
            return Err(not_balanced_paren());
        }
        self.out.push(')');
        Ok(Atom { preference, repeatable, wrap: !repeatable })
    }

    fn hex(&mut self, most: usize) -> Option<char> {
        let mut value = 0u32;
        let mut count = 0;
        while count < most
            && let Some(digit) = self.chars.peek().and_then(|c| c.to_digit(16))
        {
            value = (value << 4 | digit) & 0xff_ffff;
            count += 1;
            self.chars.next();
        }
        if count == 0 { None } else { char::from_u32(value) }
    }

    /// An escape that stands for one character.
    pub(super) fn escaped_char(&mut self, c: char) -> Result<Option<char>, Exception> {
        Ok(Some(match c {
            'a' => '\u{7}',
            'b' => '\u{8}',
            'B' => '\\',
            'c' => char::from(self.chars.next().ok_or_else(bad_escape)? as u32 as u8 & 0x1f),
            'e' => '\u{1b}',
            'f' => '\u{c}',
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            'v' => '\u{b}',
            'u' => self.hex(4).ok_or_else(bad_escape)?,
            'U' => self.hex(8).ok_or_else(bad_escape)?,
            'x' => self.hex(255).ok_or_else(bad_escape)?,
            '0' => {
                let mut value = 0;
                let mut digits = 0;
                while digits < 2
                    && let Some(d) = self.chars.peek().and_then(|c| c.to_digit(8))
                {
                    value = value * 8 + d;
                    digits += 1;
                    self.chars.next();
                }
                char::from_u32(value).ok_or_else(bad_escape)?
            }
            c if !c.is_alphanumeric() => c,
            _ => return Ok(None),
        }))
    }

    fn escape(&mut self) -> Result<Atom, Exception> {
        let single = Atom { preference: None, repeatable: true, wrap: false };
        let Some(c) = self.chars.next() else { return Err(bad_escape()) };
        let class = match c {
            'd' => "\\d",
            'D' => "\\D",
            's' => "\\s",
            'S' => "\\S",
            'w' => "\\w",
            'W' => "\\W",
            _ => "",
        };
        if !class.is_empty() {
            self.out.push_str(class);
            return Ok(single);
        }
        let constraint = match c {
            'A' => "\\A",
            'Z' => "\\z",
            'y' => "\\b",
            'Y' => "\\B",
            'm' => "\\b{start}",
            'M' => "\\b{end}",
            _ => "",
        };
        self.anchored |= c == 'A';
        if !constraint.is_empty() {
            self.out.push_str(constraint);
            return Ok(Atom { repeatable: false, ..single });
        }
        if ('1'..='9').contains(&c) {
            let mut number = c as usize - '0' as usize;
            while let Some(d) = self.chars.peek().and_then(|c| c.to_digit(10))
                && number * 10 + (d as usize) <= self.groups
            {
                number = number * 10 + d as usize;
                self.chars.next();
            }
            self.highest_reference = self.highest_reference.max(number);
            self.fancy = true;
            self.out.push_str(&format!("(?:\\{number})"));
            return Ok(single);
        }
        match self.escaped_char(c)? {
            Some(c) => {
                push_literal(&mut self.out, c);
                Ok(single)
            }
            None => Err(bad_escape()),
        }
    }
}

/// Something that a quantifier may follow.
#[derive(Clone, Copy)]
pub(super) struct Atom {
    pub(super) preference: Preference,
    pub(super) repeatable: bool,
    /// Returns true if a quantifier needs parentheses around it.
    pub(super) wrap: bool,
}
