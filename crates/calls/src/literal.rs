//! Values of expressions that are literal, or computed from such.

use crate::token::{Kind, Token};
use hysteron_tcl::Value;
use std::collections::BTreeMap;
use std::ops::Range;

/// A value of Python.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Literal {
    Int(i64),
    Float(f64),
    Text(String),
    /// A list or a tuple, each item with its place.
    List(Vec<(Literal, Range<usize>)>),
}

/// Depth of brackets that are looked into.
const MAX_DEPTH: usize = 40;
/// Digits of an integer power.
const MAX_POWER: i64 = 64;

impl Literal {
    /// The words that it stands for in a call; the items of a list one by one.
    pub(crate) fn words(&self, at: &Range<usize>, out: &mut Vec<(Value, Range<usize>)>) {
        match self {
            Self::Int(i) => out.push((Value::from(*i), at.clone())),
            Self::Float(x) => out.push((Value::from(*x), at.clone())),
            // As openseespy takes them: `'-dof '` is an option.
            Self::Text(t) => out.push((Value::from(t.trim_matches(|c: char| c.is_ascii_whitespace())), at.clone())),
            Self::List(items) => items.iter().for_each(|(item, at)| item.words(at, out)),
        }
    }

    fn number(&self) -> Option<f64> {
        match self {
            Self::Int(i) => Some(*i as f64),
            Self::Float(x) => Some(*x),
            _ => None,
        }
    }
}

/// A reader of expressions in a stretch of tokens.
pub(crate) struct Expression<'a> {
    pub(crate) text: &'a str,
    pub(crate) tokens: &'a [Token],
    pub(crate) at: usize,
    pub(crate) constants: &'a BTreeMap<String, Literal>,
    /// Names of modules that have `pi`.
    pub(crate) modules: &'a [String],
}

impl<'a> Expression<'a> {
    /// The value of the whole stretch; `None` where it is not known.
    pub(crate) fn whole(mut self) -> Option<Literal> {
        let mut value = self.sum(0)?;
        if self.sees(",") {
            // A tuple without brackets.
            let first = self.tokens.first()?.at.start..self.tokens[self.at - 1].at.end;
            let mut items = vec![(value, first)];
            while self.take(",") && self.at < self.tokens.len() {
                items.push(self.item(0)?);
            }
            value = Literal::List(items);
        }
        (self.at == self.tokens.len()).then_some(value)
    }

    fn sees(&self, sign: &str) -> bool {
        self.tokens.get(self.at).is_some_and(|t| t.kind == Kind::Sign && &self.text[t.at.clone()] == sign)
    }

    fn take(&mut self, sign: &str) -> bool {
        let there = self.sees(sign);
        self.at += usize::from(there);
        there
    }

    fn item(&mut self, depth: usize) -> Option<(Literal, Range<usize>)> {
        let start = self.tokens.get(self.at)?.at.start;
        let value = self.sum(depth)?;
        Some((value, start..self.tokens[self.at - 1].at.end))
    }

    fn sum(&mut self, depth: usize) -> Option<Literal> {
        let mut value = self.product(depth)?;
        loop {
            let sign = ["+", "-"].into_iter().find(|s| self.take(s));
            let Some(sign) = sign else { return Some(value) };
            let right = self.product(depth)?;
            value = match (sign, &value, &right) {
                ("+", Literal::Text(a), Literal::Text(b)) => Literal::Text(format!("{a}{b}")),
                _ => computed(sign, &value, &right)?,
            };
        }
    }

    fn product(&mut self, depth: usize) -> Option<Literal> {
        let mut value = self.signed(depth)?;
        loop {
            let sign = ["*", "/", "//", "%"].into_iter().find(|s| self.take(s));
            let Some(sign) = sign else { return Some(value) };
            value = computed(sign, &value, &self.signed(depth)?)?;
        }
    }

    fn signed(&mut self, depth: usize) -> Option<Literal> {
        if depth > MAX_DEPTH {
            return None;
        }
        if self.take("-") {
            return computed("-", &Literal::Int(0), &self.signed(depth + 1)?).map(|v| match v {
                // 0 - 0.0 has no sign.
                Literal::Float(0.0) => Literal::Float(-0.0),
                v => v,
            });
        }
        if self.take("+") {
            return self.signed(depth + 1);
        }
        let base = self.atom(depth)?;
        if self.take("**") { computed("**", &base, &self.signed(depth + 1)?) } else { Some(base) }
    }

    fn atom(&mut self, depth: usize) -> Option<Literal> {
        let token = self.tokens.get(self.at)?;
        let word = &self.text[token.at.clone()];
        self.at += 1;
        match token.kind {
            Kind::Number => number(word),
            Kind::Text => {
                let mut whole = text(word)?;
                while let Some(next) = self.tokens.get(self.at).filter(|t| t.kind == Kind::Text) {
                    whole += &text(&self.text[next.at.clone()])?;
                    self.at += 1;
                }
                Some(Literal::Text(whole))
            }
            Kind::Name if self.modules.iter().any(|m| m == word) && self.take(".") => {
                let name = self.tokens.get(self.at).map(|t| &self.text[t.at.clone()]);
                self.at += 1;
                (name == Some("pi")).then_some(Literal::Float(std::f64::consts::PI))
            }
            Kind::Name => self.constants.get(word).cloned(),
            Kind::Sign => match word {
                "(" => self.bracket(")", depth),
                "[" => self.bracket("]", depth),
                _ => None,
            },
        }
    }

    /// Content of brackets: a value, or a list of them.
    fn bracket(&mut self, close: &str, depth: usize) -> Option<Literal> {
        if depth > MAX_DEPTH {
            return None;
        }
        let (mut items, mut is_list) = (vec![], close == "]");
        while !self.take(close) {
            items.push(self.item(depth + 1)?);
            if self.take(",") {
                is_list = true;
            } else if !self.sees(close) {
                return None;
            }
        }
        match (is_list, items.len()) {
            (false, 1) => items.pop().map(|(value, _)| value),
            _ => Some(Literal::List(items)),
        }
    }
}

/// A number as Python writes it; none for one that is not real.
fn number(word: &str) -> Option<Literal> {
    let plain: String = word.chars().filter(|c| *c != '_').collect();
    let lower = plain.to_ascii_lowercase();
    for (prefix, radix) in [("0x", 16), ("0o", 8), ("0b", 2)] {
        if let Some(digits) = lower.strip_prefix(prefix) {
            return i64::from_str_radix(digits, radix).ok().map(Literal::Int);
        }
    }
    if plain.bytes().all(|b| b.is_ascii_digit()) {
        return plain.parse().ok().map(Literal::Int);
    }
    let is_decimal = plain.bytes().all(|b| b.is_ascii_digit() || b".eE+-".contains(&b));
    plain.parse().ok().filter(|x: &f64| is_decimal && x.is_finite()).map(Literal::Float)
}

/// The text in quotes; none for one that is computed or is made of bytes.
fn text(word: &str) -> Option<String> {
    let quote = word.find(['"', '\''])?;
    let prefix = word[..quote].to_ascii_lowercase();
    if prefix.contains(['f', 'b']) {
        return None;
    }
    let rest = &word[quote..];
    let mark = if rest.starts_with("'''") || rest.starts_with("\"\"\"") { 3 } else { 1 };
    let inner = rest.get(mark..).and_then(|r| r.strip_suffix(&rest[..mark]))?;
    if prefix.contains('r') || !inner.contains('\\') {
        return Some(inner.to_owned());
    }
    let (mut out, mut chars) = (String::new(), inner.chars());
    while let Some(c) = chars.next() {
        match (c, if c == '\\' { chars.next() } else { None }) {
            ('\\', Some('n')) => out.push('\n'),
            ('\\', Some('t')) => out.push('\t'),
            ('\\', Some('\n')) => {}
            ('\\', Some(c @ ('\\' | '\'' | '"'))) => out.push(c),
            ('\\', _) => return None,
            _ => out.push(c),
        }
    }
    Some(out)
}

/// The value of an operation on numbers, as Python computes it.
fn computed(sign: &str, a: &Literal, b: &Literal) -> Option<Literal> {
    if let (Literal::Int(a), Literal::Int(b)) = (a, b) {
        let (a, b) = (*a, *b);
        let exact = match sign {
            "+" => a.checked_add(b),
            "-" => a.checked_sub(b),
            "*" => a.checked_mul(b),
            "//" => a.checked_div_euclid(b).filter(|_| b > 0),
            "%" => a.checked_rem_euclid(b).filter(|_| b > 0),
            "**" if (0..=MAX_POWER).contains(&b) => a.checked_pow(u32::try_from(b).ok()?),
            _ => None,
        };
        if exact.is_some() || !matches!(sign, "/" | "**") || sign == "**" && b >= 0 {
            return exact.map(Literal::Int);
        }
    }
    let (a, b) = (a.number()?, b.number()?);
    let x = match sign {
        "+" => a + b,
        "-" => a - b,
        "*" => a * b,
        "/" if b != 0.0 => a / b,
        "**" => a.powf(b),
        _ => return None,
    };
    x.is_finite().then_some(Literal::Float(x))
}

#[cfg(test)]
mod tests {
    use super::{Expression, Literal};
    use crate::token::Tokens;
    use std::collections::BTreeMap;

    fn value(text: &str) -> Option<Literal> {
        let tokens = Tokens::of(text);
        let constants = BTreeMap::from([("L".to_owned(), Literal::Float(2.5)), ("n".to_owned(), Literal::Int(3))]);
        Expression { text, tokens: &tokens.all, at: 0, constants: &constants, modules: &["math".to_owned()] }.whole()
    }

    #[test]
    fn numbers_are_computed_as_in_python() {
        for (text, expected) in [
            ("-2**2", Literal::Int(-4)),
            ("7/2", Literal::Float(3.5)),
            ("7//2*L", Literal::Float(7.5)),
            ("2**-1", Literal::Float(0.5)),
            ("1_000 + 0x10", Literal::Int(1016)),
            ("(1 + n)*2", Literal::Int(8)),
            ("-1.5e3", Literal::Float(-1500.0)),
            ("math.pi", Literal::Float(std::f64::consts::PI)),
            ("'-do' \"f\"", Literal::Text("-dof".into())),
            ("r'a\\n'", Literal::Text("a\\n".into())),
            ("7 % 4", Literal::Int(3)),
        ] {
            assert_eq!(value(text), Some(expected), "{text}");
        }
        for text in
            ["x", "f'{x}'", "1/0", "3j", "a(1)", "[i for i in n]", "1 if n else 2", "L[0]", "", "(1,", "1 2", "b'x'"]
        {
            assert_eq!(value(text), None, "{text}");
        }
    }

    #[test]
    fn lists_have_the_places_of_their_items() {
        let Some(Literal::List(items)) = value("[1, -2.5, (n, 'a')]") else { panic!("no list") };
        let places: Vec<_> = items.iter().map(|(_, at)| at.clone()).collect();
        assert_eq!(places, [1..2, 4..8, 10..18]);
        assert!(matches!(value("1, 2"), Some(Literal::List(l)) if l.len() == 2));
    }
}
