//! Calls of OpenSees in a text, with what is known of their arguments, and of the order in which they run.

use crate::constants::bindings;
use crate::imports::{BUILTINS, Imports, Module, path};
use crate::literal::{Expression, Literal};
use crate::token::{Kind, Token, Tokens};
use hysteron_opensees::calls;
use hysteron_tcl::Value;
use std::collections::BTreeMap;
use std::ops::Range;

/// An argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// Its place.
    pub at: Range<usize>,
    /// The words that it stands for, with their places; `None` where they are not known.
    pub words: Option<Vec<(Value, Range<usize>)>>,
}

/// A call of a command.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundCall {
    /// Name of the command.
    pub name: String,
    /// Place of the name.
    pub name_at: Range<usize>,
    /// Place of the call, from the name to the closing bracket.
    pub at: Range<usize>,
    /// The arguments.
    pub arguments: Vec<Argument>,
    /// All calls before are known, and this one is made after them, once.
    pub in_order: bool,
    /// An error of the call may be meant: it stands in `try`.
    pub may_fail: bool,
}

/// A bracket or a text that is never closed.
pub type Unclosed = Range<usize>;

/// The calls of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Module that the commands come from.
    pub module: Module,
    /// The calls, in the order of the text.
    pub calls: Vec<FoundCall>,
    /// All calls of the file are known, in the order in which they are made.
    pub is_complete: bool,
    /// The bracket or quote that is never closed.
    pub unclosed: Option<Unclosed>,
}

/// Keywords, behind which a bracket is no call.
const KEYWORDS: [&str; 22] = [
    "if", "elif", "else", "for", "while", "in", "not", "and", "or", "is", "return", "yield", "assert", "del", "lambda",
    "with", "import", "from", "raise", "except", "await", "case",
];

/// Keywords that begin a block.
const BLOCKS: [&str; 14] = [
    "if", "elif", "else", "for", "while", "def", "class", "with", "try", "except", "finally", "async", "match", "case",
];

/// Words within an expression after which a call need not be made once.
const CONDITIONS: [&str; 5] = ["lambda", "for", "if", "and", "or"];

/// Functions that end the program.
const ENDS: [&str; 3] = ["exit", "quit", "_exit"];

/// Kind of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Block {
    /// `if __name__ == "__main__":` is run once, where it stands.
    Main,
    /// Its statements run several times or not at all.
    Branch,
    /// The body of a function: it runs where the function is called.
    Function,
    /// The same, and errors are caught.
    Try,
}

/// Read the calls of a text; `None` where it imports neither module.
pub fn read(text: &str) -> Option<Reading> {
    let tokens = Tokens::of(text);
    let imports = Imports::of(text, &tokens);
    let module = imports.module?;
    let counts = bindings(text, &tokens);
    let mut walk = Walk {
        text,
        tokens: &tokens,
        imports: &imports,
        counts,
        constants: BTreeMap::new(),
        calls: vec![],
        is_known: true,
        is_complete: true,
        is_ended: false,
    };
    walk.lines();
    let (calls, is_complete) = (walk.calls, walk.is_complete);
    Some(Reading { module, calls, is_complete, unclosed: tokens.unclosed })
}

struct Walk<'a> {
    text: &'a str,
    tokens: &'a Tokens,
    imports: &'a Imports,
    counts: BTreeMap<String, usize>,
    constants: BTreeMap<String, Literal>,
    calls: Vec<FoundCall>,
    /// All calls up to here are known.
    is_known: bool,
    is_complete: bool,
    /// The program has ended.
    is_ended: bool,
}

impl<'a> Walk<'a> {
    fn word(&self, t: &Token) -> &'a str {
        &self.text[t.at.clone()]
    }

    fn lines(&mut self) {
        let mut blocks: Vec<(usize, Block)> = vec![];
        let tokens = self.tokens;
        for line in &tokens.lines {
            blocks.retain(|(indent, _)| *indent < line.indent);
            let all = &tokens.all[line.tokens.clone()];
            if self.imports.unknown.contains(&line.tokens.start) {
                self.lose();
            }
            let first = self.word(&all[0]);
            let mut body = 0;
            let is_soft = matches!(first, "match" | "case");
            if BLOCKS.contains(&first) && (!is_soft || self.ends_with_colon(all)) {
                let block = self.block(all);
                body = self.head_end(all);
                blocks.push((line.indent, block));
                // The head runs where the block stands, but for that of a definition; loops run it again.
                let head = if matches!(first, "def" | "class" | "async") { body } else { 0 };
                let outer = &blocks[..blocks.len() - 1];
                let outer: Vec<Block> = outer.iter().map(|(_, b)| *b).chain([Block::Branch]).collect();
                self.statement(&all[head..body], &outer);
            }
            let kinds: Vec<Block> = blocks.iter().map(|(_, b)| *b).collect();
            let mut depth = 0_usize;
            let statements = all[body..].split(|t| {
                match self.text.get(t.at.clone()) {
                    Some("(" | "[" | "{") => depth += 1,
                    Some(")" | "]" | "}") => depth = depth.saturating_sub(1),
                    Some(";") => return depth == 0,
                    _ => {}
                }
                false
            });
            let statements: Vec<&[Token]> = statements.collect();
            statements.into_iter().for_each(|s| self.statement(s, &kinds));
        }
    }

    fn ends_with_colon(&self, all: &[Token]) -> bool {
        all.last().is_some_and(|t| self.word(t) == ":")
    }

    /// Number of tokens up to the colon of the head.
    fn head_end(&self, all: &[Token]) -> usize {
        let mut depth = 0_usize;
        for (i, t) in all.iter().enumerate() {
            match self.word(t) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth = depth.saturating_sub(1),
                ":" if depth == 0 && !all[..i].iter().any(|t| self.word(t) == "lambda") => return i + 1,
                _ => {}
            }
        }
        all.len()
    }

    fn block(&self, all: &[Token]) -> Block {
        let words: Vec<&str> = all.iter().take(5).map(|t| self.word(t)).collect();
        match words[..] {
            ["if", "__name__", "==", _, ":"] => Block::Main,
            ["try", ..] => Block::Try,
            ["def", ..] | ["async", "def", ..] => Block::Function,
            _ => Block::Branch,
        }
    }

    /// The state of the model is not known from here.
    fn lose(&mut self) {
        (self.is_known, self.is_complete) = (false, false);
    }

    fn statement(&mut self, all: &[Token], blocks: &[Block]) {
        // A part of an expression may run later, several times or not at all.
        let is_plain = !all.iter().any(|t| CONDITIONS.contains(&self.word(t)));
        let is_straight = is_plain && blocks.iter().all(|b| *b == Block::Main);
        let may_fail = blocks.contains(&Block::Try);
        let before = (self.is_known, self.is_complete);
        let mut i = 0;
        while i < all.len() && !self.is_ended {
            if all[i].kind == Kind::Name && all.get(i + 1).is_some_and(|t| self.word(t) == "(") {
                self.call(all, i, is_straight, may_fail);
            }
            i += 1;
        }
        if is_straight {
            self.assignment(all);
        }
        // A function that is called loses the state at its call.
        if blocks.contains(&Block::Function) {
            (self.is_known, self.is_complete) = before;
        }
    }

    /// `name = value` or `name: type = value`, for a name that the file binds once.
    fn assignment(&mut self, all: &[Token]) {
        let Some(first) = all.first().filter(|t| t.kind == Kind::Name) else { return };
        let equals = match all.get(1).map(|t| self.word(t)) {
            Some("=") => 1,
            Some(":") => all.iter().position(|t| self.word(t) == "=").unwrap_or(all.len()),
            _ => return,
        };
        let name = self.word(first);
        if self.counts.get(name) != Some(&1) || self.imports.own.contains(name) {
            return;
        }
        if let Some(value) = self.value(all.get(equals + 1..).unwrap_or_default()) {
            let is_mutable = all.get(equals + 1).is_some_and(|t| self.word(t) == "[");
            if !(is_mutable && matches!(value, Literal::List(_))) {
                self.constants.insert(name.to_owned(), value);
            }
        }
    }

    fn value(&self, tokens: &[Token]) -> Option<Literal> {
        let modules = &self.imports.harmless;
        Expression { text: self.text, tokens, at: 0, constants: &self.constants, modules }.whole()
    }

    /// The call whose last name is a token.
    fn call(&mut self, all: &[Token], i: usize, is_straight: bool, may_fail: bool) {
        let name = self.word(&all[i]);
        let before = i.checked_sub(1).map_or("", |j| self.word(&all[j]));
        if KEYWORDS.contains(&name) || matches!(before, "def" | "class") {
            return;
        }
        let Some(command) = self.imports.called(self.text, all, i).map(str::to_owned) else {
            if !self.is_harmless_call(all, i) {
                if is_straight && ENDS.contains(&name) {
                    self.is_ended = true;
                }
                self.lose();
            }
            return;
        };
        let Some(close) = self.closing(all, i + 1) else { return self.lose() };
        let arguments = self.arguments(&all[i + 2..close]);
        let is_literal = arguments.iter().all(|a| a.words.is_some());
        let known = calls::command(&command);
        // A model that is begun anew is known again.
        if is_straight && command == "wipe" && is_literal {
            self.is_known = true;
        }
        let in_order = self.is_known && is_straight && is_literal && !may_fail;
        let looks = command == "analyze" || known.is_some_and(calls::only_looks);
        let is_block = command.starts_with("block");
        if !in_order && !looks || known.is_none() || is_block {
            self.lose();
        }
        let at = all[i].at.start..all[close].at.end;
        let in_order = in_order && !is_block;
        self.calls.push(FoundCall { name: command, name_at: all[i].at.clone(), at, arguments, in_order, may_fail });
    }

    /// Returns true if a call of something else calls no command that changes a model.
    fn is_harmless_call(&self, all: &[Token], i: usize) -> bool {
        let name = self.word(&all[i]);
        if ENDS.contains(&name) {
            return false;
        }
        if i == 0 || self.word(&all[i - 1]) != "." {
            let is_own = self.imports.own.contains(name);
            return !is_own && (BUILTINS.contains(&name) || self.imports.harmless.iter().any(|m| m == name));
        }
        let Some(path) = path(self.text, all, i) else { return !self.imports.has_classes };
        let base = path.split('.').next().unwrap_or_default();
        if self.imports.harmless.iter().any(|m| m == base) {
            return true;
        }
        // A method of a variable: of a list, a file, a figure.
        let is_module = self.imports.aliases.iter().any(|a| a.split('.').next() == Some(base));
        !is_module && !self.imports.has_classes && self.counts.contains_key(base)
    }

    /// The bracket that closes the one at a token.
    fn closing(&self, all: &[Token], open: usize) -> Option<usize> {
        let mut depth = 0_usize;
        for (i, t) in all.iter().enumerate().skip(open) {
            match self.word(t) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(i);
                    }
                }
                _ => {}
            }
        }
        None
    }

    fn arguments(&self, all: &[Token]) -> Vec<Argument> {
        let mut depth = 0_usize;
        let parts = all.split(|t| {
            match self.text.get(t.at.clone()) {
                Some("(" | "[" | "{") => depth += 1,
                Some(")" | "]" | "}") => depth = depth.saturating_sub(1),
                Some(",") => return depth == 0,
                _ => {}
            }
            false
        });
        parts.filter(|p| !p.is_empty()).map(|p| self.argument(p)).collect()
    }

    fn argument(&self, tokens: &[Token]) -> Argument {
        let at = tokens[0].at.start..tokens[tokens.len() - 1].at.end;
        let is_named = tokens.len() > 1 && self.word(&tokens[1]) == "=";
        let is_spread = self.word(&tokens[0]) == "*";
        let value = if is_named { None } else { self.value(&tokens[usize::from(is_spread)..]) };
        let value = value.filter(|v| !is_spread || matches!(v, Literal::List(_)));
        let words = value.map(|value| {
            let mut words = vec![];
            // Items that stand elsewhere have the place of the name.
            value.words(&at, &mut words);
            words.iter_mut().filter(|(_, w)| w.start < at.start || at.end < w.end).for_each(|(_, w)| *w = at.clone());
            words
        });
        Argument { at, words }
    }
}
