//! `string is`.

use crate::command::{Call, choose};
use crate::core::Core;
use crate::error::Exception;
use crate::list::next_element;
use crate::number::{self, Number, is_space};
use crate::value::Value;
use crate::vars::VarName;

const CLASSES: [&str; 21] = [
    "alnum",
    "alpha",
    "ascii",
    "control",
    "boolean",
    "digit",
    "double",
    "entier",
    "false",
    "graph",
    "integer",
    "list",
    "lower",
    "print",
    "punct",
    "space",
    "true",
    "upper",
    "wideinteger",
    "wordchar",
    "xdigit",
];

pub(crate) fn is(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "string is class ?-strict? ?-failindex var? str";
    call.expect(4..=7, usage)?;
    let class = CLASSES[choose(&call.arg(2).as_str(), "class", &CLASSES, false).map_err(|e| e.at(call.span(2), ""))?];
    let usage = format!("string is {class} ?-strict? ?-failindex var? str");
    let mut strict = false;
    let mut fail_var = None;
    let mut i = 3;
    while i < call.len() - 1 {
        match call.choose(i, "option", &["-strict", "-failindex"], false)? {
            0 => strict = true,
            _ => {
                i += 1;
                if i >= call.len() - 1 {
                    return Err(call.wrong_args(&usage));
                }
                fail_var = Some(VarName::of(call.arg(i)));
            }
        }
        i += 1;
    }
    let value = call.arg(call.len() - 1);
    let text = value.as_str();
    // Where the text stops to be of the class, in characters; none if it is of the class throughout.
    let fails = if text.is_empty() {
        let empty_is_fine = !strict || class == "list";
        if empty_is_fine { None } else { Some(0) }
    } else {
        failure(class, value, &text)
    };
    if let (Some(at), Some(name)) = (fails, fail_var) {
        core.assign(&name, Value::from(at))?;
    }
    Ok(Value::from(fails.is_none()))
}

fn failure(class: &str, value: &Value, text: &str) -> Option<i64> {
    let chars = |fits: fn(char) -> bool| text.chars().position(|c| !fits(c)).map(|at| at as i64);
    let whole = |fits: bool| if fits { None } else { Some(0) };
    match class {
        "alnum" => chars(|c| c.is_alphanumeric()),
        "alpha" => chars(|c| c.is_alphabetic()),
        "ascii" => chars(|c| c.is_ascii()),
        "control" => chars(|c| c.is_control()),
        "digit" => chars(|c| c.is_ascii_digit() || (!c.is_ascii() && c.is_numeric())),
        "graph" => chars(|c| !c.is_control() && !c.is_whitespace()),
        "lower" => chars(char::is_lowercase),
        "print" => chars(|c| !c.is_control() && (c == ' ' || !matches!(c, '\u{2028}' | '\u{2029}'))),
        "punct" => chars(is_punct),
        "space" => chars(|c| c.is_whitespace() || matches!(c, '\u{180e}' | '\u{200b}' | '\u{2060}' | '\u{feff}')),
        "upper" => chars(char::is_uppercase),
        "wordchar" => chars(|c| c.is_alphanumeric() || c == '_'),
        "xdigit" => chars(|c| c.is_ascii_hexdigit()),
        "boolean" => whole(boolean(value).is_some()),
        "true" => whole(boolean(value) == Some(true)),
        "false" => whole(boolean(value) == Some(false)),
        "double" => number_failure(text, |_| Fit::Yes),
        "entier" => number_failure(text, |n| if matches!(n, Number::Double(_)) { Fit::No } else { Fit::Yes }),
        "integer" | "wideinteger" => {
            let narrow = class == "integer";
            number_failure(text, move |n| match n {
                Number::Double(_) => Fit::No,
                Number::Big(b) if narrow || b.bits() > 64 => Fit::TooLarge,
                Number::Big(_) => Fit::Yes,
                Number::Int(i) if narrow && i.unsigned_abs() > u64::from(u32::MAX) => Fit::TooLarge,
                Number::Int(_) => Fit::Yes,
            })
        }
        _ => list_failure(text),
    }
}

fn boolean(value: &Value) -> Option<bool> {
    match value.number() {
        Some(Number::Int(i @ (0 | 1))) => Some(i == 1),
        Some(_) => None,
        None => value.truth(),
    }
}

fn is_punct(c: char) -> bool {
    match c {
        '$' | '+' | '<' | '=' | '>' | '^' | '`' | '|' | '~' => false,
        c if c.is_ascii() => c.is_ascii_punctuation(),
        c => {
            matches!(c, '\u{a1}' | '\u{a7}' | '\u{ab}' | '\u{b6}' | '\u{b7}' | '\u{bb}' | '\u{bf}' | '\u{2010}'..='\u{2027}' | '\u{2030}'..='\u{205e}' | '\u{3001}'..='\u{3003}')
        }
    }
}

enum Fit {
    Yes,
    No,
    TooLarge,
}

/// Index at which a text ceases to be a number of a kind; -1 if it is one but too large.
fn number_failure(text: &str, fit: impl Fn(&Number) -> Fit) -> Option<i64> {
    if let Some(n) = number::parse(text) {
        match fit(&n) {
            Fit::Yes => return None,
            Fit::TooLarge => return Some(-1),
            Fit::No => {}
        }
    }
    let blanks = text.len() - text.trim_start_matches(|c: char| c.is_ascii() && is_space(c as u8)).len();
    let rest = &text[blanks..];
    let sign = rest.len() - rest.trim_start_matches(['+', '-']).len();
    // The longest start that is a number of the kind: cut a double back to its integer part.
    let good = match number::prefix(rest) {
        Some((length, n)) if matches!(fit(&n), Fit::Yes | Fit::TooLarge) => length,
        Some(_) => rest[sign..].bytes().take_while(u8::is_ascii_digit).count() + sign,
        None => 0,
    };
    let after = rest[good..].bytes().take_while(|b| good > sign && is_space(*b)).count();
    // Where nothing fits, not even the blanks count.
    Some(if good == 0 { 0 } else { (blanks + good + after) as i64 })
}

fn list_failure(text: &str) -> Option<i64> {
    let mut at = 0;
    loop {
        match next_element(text, at) {
            Ok(None) => return None,
            Ok(Some(e)) => at = e.next,
            Err(_) => {
                let blanks = text[at..].bytes().take_while(|b| is_space(*b)).count();
                return Some(text[..at + blanks].chars().count() as i64);
            }
        }
    }
}
