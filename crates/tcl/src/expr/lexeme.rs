//! The smallest parts of an expression.

use super::super::lexer::is_word_byte;
use super::super::number;
use super::{Binary, Unary};

/// Kind of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lexeme {
    Start,
    End,
    Number,
    Bareword,
    Quoted,
    Braced,
    Variable,
    /// An operand that is handed in.
    Slot,
    Script,
    Function,
    Open,
    Close,
    Comma,
    Question,
    Colon,
    And,
    Or,
    Unary(Unary),
    Binary(Binary),
    Invalid,
    Incomplete,
}

impl Lexeme {
    pub(super) fn precedence(self) -> u8 {
        match self {
            Lexeme::End => 1,
            Lexeme::Start => 1,
            Lexeme::Close => 2,
            Lexeme::Open => 3,
            Lexeme::Comma => 4,
            Lexeme::Question | Lexeme::Colon => 5,
            Lexeme::Or => 6,
            Lexeme::And => 7,
            Lexeme::Binary(b) => match b {
                Binary::BitOr => 8,
                Binary::BitXor => 9,
                Binary::BitAnd => 10,
                Binary::Eq | Binary::Ne | Binary::StrEq | Binary::StrNe | Binary::In | Binary::NotIn => 11,
                Binary::Lt | Binary::Gt | Binary::Le | Binary::Ge => 12,
                Binary::Shl | Binary::Shr => 13,
                Binary::Add | Binary::Sub => 14,
                Binary::Mul | Binary::Div | Binary::Mod => 15,
                Binary::Pow => 16,
            },
            _ => 17,
        }
    }
}

pub(super) fn byte(text: &str, at: usize) -> Option<u8> {
    text.as_bytes().get(at).copied()
}

pub(super) fn skip_blanks(text: &str, mut at: usize) -> usize {
    loop {
        match byte(text, at) {
            Some(b) if number::is_space(b) => at += 1,
            Some(b'\\') if byte(text, at + 1) == Some(b'\n') => at += 2,
            _ => return at,
        }
    }
}

/// Kind and length of what stands at a place.
pub(super) fn lexeme(text: &str, at: usize) -> (Lexeme, usize) {
    use Lexeme as L;
    let Some(b) = byte(text, at) else { return (L::End, 0) };
    let next = byte(text, at + 1);
    let two = |follow: u8, long: Lexeme, short: Lexeme| if next == Some(follow) { (long, 2) } else { (short, 1) };
    match b {
        b'[' => (L::Script, 1),
        b'{' => (L::Braced, 1),
        b'(' => (L::Open, 1),
        b')' => (L::Close, 1),
        b'$' => (L::Variable, 1),
        b'"' => (L::Quoted, 1),
        super::template::SLOT => (L::Slot, 1),
        b',' => (L::Comma, 1),
        b'?' => (L::Question, 1),
        b':' => (L::Colon, 1),
        b'/' => (L::Binary(Binary::Div), 1),
        b'%' => (L::Binary(Binary::Mod), 1),
        b'+' => (L::Binary(Binary::Add), 1),
        b'-' => (L::Binary(Binary::Sub), 1),
        b'^' => (L::Binary(Binary::BitXor), 1),
        b'~' => (L::Unary(Unary::BitNot), 1),
        b'*' => two(b'*', L::Binary(Binary::Pow), L::Binary(Binary::Mul)),
        b'&' => two(b'&', L::And, L::Binary(Binary::BitAnd)),
        b'|' => two(b'|', L::Or, L::Binary(Binary::BitOr)),
        b'=' => two(b'=', L::Binary(Binary::Eq), L::Incomplete),
        b'!' => two(b'=', L::Binary(Binary::Ne), L::Unary(Unary::Not)),
        b'<' if next == Some(b'<') => (L::Binary(Binary::Shl), 2),
        b'<' => two(b'=', L::Binary(Binary::Le), L::Binary(Binary::Lt)),
        b'>' if next == Some(b'>') => (L::Binary(Binary::Shr), 2),
        b'>' => two(b'=', L::Binary(Binary::Ge), L::Binary(Binary::Gt)),
        b'.' | b'0'..=b'9' | b'i' | b'I' | b'n' | b'N' => number_or_word(text, at),
        b if is_word_byte(b) => word(text, at, at),
        _ => (L::Invalid, text[at..].chars().next().map_or(1, char::len_utf8)),
    }
}

/// Operators that are words.
fn word_operator(text: &str, at: usize) -> Option<Lexeme> {
    if byte(text, at + 2).is_some_and(|b| b.is_ascii_alphabetic()) {
        return None;
    }
    Some(Lexeme::Binary(match text.as_bytes().get(at..at + 2)? {
        b"eq" => Binary::StrEq,
        b"ne" => Binary::StrNe,
        b"in" => Binary::In,
        b"ni" => Binary::NotIn,
        _ => return None,
    }))
}

fn number_or_word(text: &str, at: usize) -> (Lexeme, usize) {
    if let Some(operator) = word_operator(text, at) {
        return (operator, 2);
    }
    let Some((length, _)) = number::prefix(&text[at..]) else {
        return match byte(text, at) {
            Some(b'.') => (Lexeme::Invalid, 1),
            _ => word(text, at, at),
        };
    };
    let end = at + length;
    if !byte(text, end).is_some_and(is_word_byte) {
        return (Lexeme::Number, length);
    }
    // Digits right before letters: a number, if it holds what no word does or an operator follows; else a word.
    let pure_word = text.as_bytes()[at..end].iter().all(|b| is_word_byte(*b));
    if !pure_word || word_operator(text, end).is_some() {
        return (Lexeme::Number, length);
    }
    word(text, at, end)
}

fn word(text: &str, at: usize, from: usize) -> (Lexeme, usize) {
    if from == at
        && let Some(operator) = word_operator(text, at)
    {
        return (operator, 2);
    }
    let rest = &text.as_bytes()[from..];
    let length = rest.iter().take_while(|b| is_word_byte(**b)).count();
    (Lexeme::Bareword, from - at + length)
}
