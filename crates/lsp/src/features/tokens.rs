//! Colours by meaning: commands, kinds, options, variables, numbers and comments.

use super::words::Called;
use crate::buffer::View;
use lsp_types::{SemanticToken, SemanticTokenType, SemanticTokens, SemanticTokensLegend};
use std::collections::BTreeMap;

/// Kinds of tokens, in the order of their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Token {
    Command,
    Procedure,
    Kind,
    Option,
    Variable,
    Number,
    Comment,
}

/// The kinds of tokens that the server tells.
pub(crate) fn legend() -> SemanticTokensLegend {
    let token_types = vec![
        SemanticTokenType::FUNCTION,
        SemanticTokenType::METHOD,
        SemanticTokenType::TYPE,
        SemanticTokenType::PROPERTY,
        SemanticTokenType::VARIABLE,
        SemanticTokenType::NUMBER,
        SemanticTokenType::COMMENT,
    ];
    SemanticTokensLegend { token_types, token_modifiers: vec![] }
}

/// The tokens of a file.
pub(crate) fn tokens(view: &View<'_>) -> SemanticTokens {
    // By their first bytes: what is found last counts.
    let mut all: BTreeMap<usize, (usize, Token)> = BTreeMap::new();
    commands(view, &mut all);
    for v in &view.buffer.syntax().variables {
        all.insert(v.start, (v.end, Token::Variable));
    }
    let text = &view.buffer.text;
    for n in 0..text.line_count() {
        let range = text.line_range(n);
        let line = text.line(n);
        if line.trim_start().starts_with('#') {
            all.retain(|at, _| !range.contains(at));
            all.insert(range.start + line.len() - line.trim_start().len(), (range.end, Token::Comment));
        }
    }
    encoded(view, &all)
}

fn commands(view: &View<'_>, all: &mut BTreeMap<usize, (usize, Token)>) {
    let text = view.text();
    let syntax = view.buffer.syntax();
    let procedures: Vec<&str> = syntax
        .commands
        .iter()
        .filter(|c| c.words.len() > 2 && text.get(c.words[0].0..c.words[0].1) == Some("proc"))
        .filter_map(|c| text.get(c.words[1].0..c.words[1].1))
        .collect();
    for (i, c) in syntax.commands.iter().enumerate() {
        let words = view.written(i);
        let called = Called::of(&words);
        let is_tcl = |w: &str| super::words::tcl_commands().iter().any(|c| c == w);
        for (n, (word, (start, end))) in words.iter().zip(&c.words).enumerate() {
            let token = match n {
                0 if called.is_some() || is_tcl(word) => Some(Token::Command),
                0 if procedures.contains(word) => Some(Token::Procedure),
                1 if called.as_ref().is_some_and(|c| c.kind.is_some()) => Some(Token::Kind),
                _ if word.parse::<f64>().is_ok() => Some(Token::Number),
                _ if n > 0 && called.is_some() && word.starts_with('-') && !word.contains(['$', '[']) => {
                    Some(Token::Option)
                }
                _ => None,
            };
            if let Some(token) = token {
                all.insert(*start, (*end, token));
            }
        }
    }
}

/// The tokens in the differences of the protocol; what goes over a line or into the one before is left out.
fn encoded(view: &View<'_>, all: &BTreeMap<usize, (usize, Token)>) -> SemanticTokens {
    let text = &view.buffer.text;
    let (mut data, mut last, mut done) = (vec![], (0, 0), 0);
    for (&start, &(end, token)) in all {
        let (from, to) = (text.position(start), text.position(end));
        if start < done || from.line != to.line || end <= start {
            continue;
        }
        done = end;
        let delta_line = from.line - last.0;
        let delta_start = if delta_line == 0 { from.character - last.1 } else { from.character };
        last = (from.line, from.character);
        let length = to.character - from.character;
        data.push(SemanticToken {
            delta_line,
            delta_start,
            length,
            token_type: token as u32,
            token_modifiers_bitset: 0,
        });
    }
    SemanticTokens { result_id: None, data }
}
