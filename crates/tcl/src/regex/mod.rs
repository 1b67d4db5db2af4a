//! Tcl's regular expressions on top of other engines.
//!
//! A pattern is translated to the syntax of `regex-automata`, or of `fancy-regex` where it has back references or
//! lookahead. Tcl looks for the leftmost match and, there, for the longest one, or for the shortest if the first
//! quantifier is lazy. These engines take the match that the pattern tries first. A second automaton, which sees all ways
//! to match, therefore decides the end of a match. Differences from Tcl:
//!
//! - Within a match, parentheses take what the pattern tries first: `(a|ab)(bc|c)` on `abc` gives `a bc`, not `ab c`.
//! - With back references or lookahead, the match too is what the pattern tries first.
//! - Collating elements of more than one character, equivalence classes other than of a character with itself, and the
//!   basic regular expressions of `(?b)` are refused.

mod bracket;
mod translate;

use std::cell::RefCell;
use std::rc::Rc;

use regex_automata::hybrid::dfa::{Cache as LazyCache, DFA};
use regex_automata::nfa::thompson::pikevm::PikeVM;
use regex_automata::util::syntax;
use regex_automata::{Anchored, HalfMatch, Input, MatchKind, meta};

use super::error::Exception;
use super::text::Cache;
use super::value::Value;

/// The options of `regexp` that change what a pattern means.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Flags {
    pub(crate) nocase: bool,
    pub(crate) expanded: bool,
    /// `.` and `[^…]` do not match a newline.
    pub(crate) line_stop: bool,
    /// `^` and `$` match at newlines.
    pub(crate) line_anchor: bool,
    /// No special characters at all.
    pub(crate) literal: bool,
}

/// A compiled pattern.
#[derive(Debug)]
pub(crate) struct Regex {
    flags: Flags,
    engine: Engine,
    /// True if a search must not look at the text before its start.
    anchored: bool,
    /// Number of capturing parentheses.
    pub(crate) groups: usize,
}

#[derive(Debug)]
enum Engine {
    Plain(Box<Plain>),
    Fancy(Box<fancy_regex::Regex>),
}

#[derive(Debug)]
struct Plain {
    /// Finds where a match starts and what is in the parentheses.
    first: meta::Regex,
    /// The same, for a match whose end is known.
    to_end: meta::Regex,
    ends: Option<Ends>,
    longest: bool,
}

/// Finds the ends of all matches from a place on.
#[derive(Debug)]
struct Ends {
    fast: Option<(DFA, RefCell<LazyCache>)>,
    thorough: PikeVM,
}

/// Bytes of the match and of each parenthesis.
pub(crate) type Groups = Vec<Option<(usize, usize)>>;

fn failed(why: impl std::fmt::Display) -> Exception {
    Exception::coded(format!("couldn't compile regular expression pattern: {why}"), &["REGEXP", "REFUSED", "pattern"])
}

/// The compiled form of a pattern, kept with it.
pub(crate) fn compile(pattern: &Value, flags: Flags) -> Result<Rc<Regex>, Exception> {
    let obj = pattern.str_obj();
    let known = obj.cached(|c| match c {
        Cache::Regex(r) if r.flags == flags => Some(r.clone()),
        _ => None,
    });
    if let Some(regex) = known {
        return Ok(regex);
    }
    let regex = Rc::new(Regex::new(&pattern.as_str(), flags)?);
    obj.set_cache(Cache::Regex(regex.clone()));
    Ok(regex)
}

impl Regex {
    fn new(pattern: &str, flags: Flags) -> Result<Regex, Exception> {
        let translated = translate::translate(pattern, flags)?;
        let text = &translated.text;
        let engine = if translated.fancy {
            Engine::Fancy(Box::new(fancy_regex::Regex::new(text).map_err(failed)?))
        } else {
            let syntax = syntax::Config::new();
            let build = |text: &str| meta::Builder::new().syntax(syntax).build(text).map_err(failed);
            let ends = if translated.simple { None } else { Some(Ends::new(text, syntax)?) };
            Engine::Plain(Box::new(Plain {
                first: build(text)?,
                to_end: build(&format!("(?:{text})\\z"))?,
                ends,
                longest: translated.longest,
            }))
        };
        Ok(Regex { flags, engine, anchored: translated.anchored, groups: translated.groups })
    }

    /// The first match from a byte on.
    pub(crate) fn find(&self, text: &str, start: usize) -> Result<Option<Groups>, Exception> {
        if self.anchored && start > 0 {
            let found = self.search(text.get(start..).unwrap_or_default(), 0)?;
            let moved = |g: Option<(usize, usize)>| g.map(|(s, e)| (s + start, e + start));
            return Ok(found.map(|groups| groups.into_iter().map(moved).collect()));
        }
        self.search(text, start)
    }

    fn search(&self, text: &str, start: usize) -> Result<Option<Groups>, Exception> {
        match &self.engine {
            Engine::Plain(plain) => Ok(plain.find(text, start)),
            Engine::Fancy(regex) => {
                let found = regex
                    .captures_from_pos(text, start)
                    .map_err(|e| Exception::error(format!("error while matching regular expression: {e}")))?;
                let Some(found) = found else { return Ok(None) };
                Ok(Some((0..=self.groups).map(|i| found.get(i).map(|m| (m.start(), m.end()))).collect()))
            }
        }
    }
}

impl Ends {
    fn new(text: &str, syntax: syntax::Config) -> Result<Ends, Exception> {
        let config = DFA::config().match_kind(MatchKind::All).unicode_word_boundary(true);
        let fast = DFA::builder().configure(config).syntax(syntax).build(text).ok().map(|dfa| {
            let cache = RefCell::new(dfa.create_cache());
            (dfa, cache)
        });
        let config = PikeVM::config().match_kind(MatchKind::All);
        let thorough = PikeVM::builder().configure(config).syntax(syntax).build(text).map_err(failed)?;
        Ok(Ends { fast, thorough })
    }

    fn find(&self, text: &str, start: usize, longest: bool) -> Option<usize> {
        let input = Input::new(text).range(start..).anchored(Anchored::Yes).earliest(!longest);
        if let Some((dfa, cache)) = &self.fast
            && let Ok(end) = dfa.try_search_fwd(&mut cache.borrow_mut(), &input)
        {
            return end.as_ref().map(HalfMatch::offset);
        }
        let mut cache = self.thorough.create_cache();
        let mut slots = [None, None];
        self.thorough.search_slots(&mut cache, &input, &mut slots);
        slots[1].map(|s| s.get())
    }
}

impl Plain {
    fn find(&self, text: &str, start: usize) -> Option<Groups> {
        let mut found = self.first.create_captures();
        self.first.search_captures(&Input::new(text).range(start..), &mut found);
        let whole = found.get_match()?;
        let end = self.ends.as_ref().and_then(|e| e.find(text, whole.start(), self.longest));
        if let Some(end) = end
            && end != whole.end()
        {
            let mut exact = self.to_end.create_captures();
            let upto = text.get(..end).unwrap_or(text);
            let input = Input::new(upto).range(whole.start()..).anchored(Anchored::Yes);
            self.to_end.search_captures(&input, &mut exact);
            if exact.is_match() {
                found = exact;
            }
        }
        Some((0..found.group_len()).map(|i| found.get_group(i).map(|s| (s.start, s.end))).collect())
    }
}
