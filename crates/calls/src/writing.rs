//! The call that is being written before a place, which need not be complete.

use crate::imports::Imports;
use crate::token::{Kind, Token, Tokens};
use hysteron_opensees::calls;

/// A call up to the cursor, or the name of a command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpenCall<'a> {
    /// Name of the command and its whole arguments, without quotes; empty while the name is being written.
    pub words: Vec<&'a str>,
    /// The word at the cursor up to there, without a quote.
    pub partial: &'a str,
    /// The cursor stands in quotes.
    pub is_quoted: bool,
}

/// An argument without its quotes.
pub fn bare(word: &str) -> &str {
    let inner = |mark: char| word.strip_prefix(mark).and_then(|w| w.strip_suffix(mark));
    inner('\'').or_else(|| inner('"')).unwrap_or(word)
}

/// The call before a byte of a text; `None` where no command is called there.
pub fn open_call(text: &str, at: usize) -> Option<OpenCall<'_>> {
    let before = text.get(..at)?;
    let whole = Imports::of(text, &Tokens::of(text));
    let tokens = Tokens::of(before);
    let line = tokens.lines.last()?;
    let all = &tokens.all[line.tokens.clone()];
    let last = all.last()?;
    let is_at_end = last.at.end == at;
    if is_at_end && last.kind == Kind::Name && all.len() > 1 {
        if let Some(name) = whole.written(before, all, all.len() - 1) {
            return Some(OpenCall { words: vec![], partial: name, is_quoted: false });
        }
    } else if is_at_end && word(before, last) == "." && whole.is_alias(before, &all[..all.len() - 1]) {
        return Some(OpenCall { words: vec![], partial: "", is_quoted: false });
    }
    let mut open: Vec<usize> = vec![];
    for (i, t) in all.iter().enumerate().filter(|(_, t)| t.kind == Kind::Sign) {
        match word(before, t) {
            "(" | "[" | "{" => open.push(i),
            ")" | "]" | "}" => drop(open.pop()),
            _ => {}
        }
    }
    let called = |i: &usize| {
        let name = i.checked_sub(1).filter(|_| word(before, &all[*i]) == "(")?;
        Some((*i, calls::command(whole.called(before, all, name)?)?.name))
    };
    let (bracket, name) = open.iter().rev().find_map(called)?;
    let (mut words, mut depth, mut begin) = (vec![name], 0_usize, bracket + 1);
    for (i, t) in all.iter().enumerate().skip(bracket + 1) {
        match word(before, t) {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth = depth.saturating_sub(1),
            "," if depth == 0 => {
                let part = all.get(begin..i).filter(|p| !p.is_empty());
                words.extend(part.map(|p| bare(&before[p[0].at.start..p[p.len() - 1].at.end])));
                begin = i + 1;
            }
            _ => {}
        }
    }
    let rest = all.get(begin).map_or("", |t| &before[t.at.start..]);
    let is_quoted = rest.starts_with(['\'', '"']) && bare(rest) == rest;
    let partial = if is_quoted { &rest[1..] } else { rest };
    // What is whole and has a blank behind it is no beginning of a word.
    let partial = if is_quoted { partial } else { partial.trim_end() };
    let is_open = is_quoted || before.ends_with(partial);
    Some(OpenCall { words, partial: if is_open { partial } else { "" }, is_quoted })
}

fn word<'a>(text: &'a str, t: &Token) -> &'a str {
    &text[t.at.clone()]
}

#[cfg(test)]
mod tests {
    use super::open_call;

    fn parts(text: &str) -> Option<(Vec<&str>, &str, bool)> {
        open_call(text, text.len()).map(|c| (c.words, c.partial, c.is_quoted))
    }

    #[test]
    fn the_innermost_call_of_a_command_is_found() {
        let text = |line: &str| format!("import openseespy.opensees as ops\nx = 1\n{line}");
        let found = |line: &str| {
            let text = text(line);
            parts(&text).map(|(w, p, q)| (w.join(" "), p.to_owned(), q))
        };
        let some = |words: &str, partial: &str, quoted: bool| Some((words.to_owned(), partial.to_owned(), quoted));
        assert_eq!(found("ops."), some("", "", false));
        assert_eq!(found("ops.ele"), some("", "ele", false));
        assert_eq!(found("ops.element("), some("element", "", false));
        assert_eq!(found("ops.element('tru"), some("element", "tru", true));
        assert_eq!(found("ops.element('truss', 1, *[1, 2], "), some("element truss 1 *[1, 2]", "", false));
        assert_eq!(found("a = ops.nodeDisp(float(x), 2"), some("nodeDisp float(x)", "2", false));
        assert_eq!(found("print(x, "), None);
        assert_eq!(found("ops.node(1, 2)\nx = "), None);
        assert_eq!(parts("import math\nmath.sqrt("), None);
    }
}
