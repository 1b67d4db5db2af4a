//! `string`, but for `string is`.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::glob;
use crate::index::{index, range};
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("string", |core, call| dispatch(core, call, SUBS))];

const SUBS: &[(&str, CoreFn)] = &[
    ("bytelength", bytelength),
    ("cat", cat),
    ("compare", compare),
    ("equal", equal),
    ("first", first),
    ("index", string_index),
    ("is", super::string_is::is),
    ("last", last),
    ("length", length),
    ("map", map),
    ("match", string_match),
    ("range", string_range),
    ("repeat", repeat),
    ("replace", replace),
    ("reverse", reverse),
    ("tolower", |_, call| case(call, "tolower", |c| c.to_lowercase().collect())),
    ("totitle", |_, call| totitle(call)),
    ("toupper", |_, call| case(call, "toupper", upper)),
    ("trim", |_, call| trim(call, "trim", true, true)),
    ("trimleft", |_, call| trim(call, "trimleft", true, false)),
    ("trimright", |_, call| trim(call, "trimright", false, true)),
    ("wordend", wordend),
    ("wordstart", wordstart),
];

/// Upper case, character by character: as in Tcl `ß` has none.
fn upper(c: char) -> String {
    let mut up = c.to_uppercase();
    match (up.next(), up.next()) {
        (Some(one), None) => one.to_string(),
        _ => c.to_string(),
    }
}

/// Bytes of the characters from one to another.
fn slice<'t>(value: &Value, text: &'t str, chars: std::ops::Range<usize>) -> &'t str {
    if value.is_ascii() {
        return text.get(chars).unwrap_or_default();
    }
    let byte = |at: usize| text.char_indices().nth(at).map_or(text.len(), |(b, _)| b);
    let start = byte(chars.start);
    &text[start..byte(chars.end).max(start)]
}

fn length(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "string length string")?;
    Ok(Value::from(call.arg(2).char_count()))
}

fn bytelength(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "string bytelength string")?;
    Ok(Value::from(call.arg(2).as_str().len()))
}

fn cat(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let mut out = String::new();
    for word in call.from(2) {
        word.write_to(&mut out);
    }
    Ok(Value::from(out))
}

fn string_index(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "string index string charIndex")?;
    let value = call.arg(2);
    let count = value.char_count();
    let at = index(call.arg(3), count as i64 - 1)?;
    if at < 0 || at >= count as i64 {
        return Ok(Value::EMPTY);
    }
    Ok(Value::from(slice(value, &value.as_str(), at as usize..at as usize + 1)))
}

fn string_range(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=5, "string range string first last")?;
    let value = call.arg(2);
    let chars = range(call.arg(3), call.arg(4), value.char_count())?;
    Ok(Value::from(slice(value, &value.as_str(), chars)))
}

fn replace(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=6, "string replace string first last ?string?")?;
    let value = call.arg(2);
    let count = value.char_count();
    let end = count as i64 - 1;
    let first = index(call.arg(3), end)?;
    let last = index(call.arg(4), end)?;
    if last < 0 || first > end || last < first {
        return Ok(value.clone());
    }
    let text = value.as_str();
    let before = slice(value, &text, 0..first.max(0) as usize);
    let after = slice(value, &text, (last.min(end) + 1) as usize..count);
    Ok(Value::from(format!("{before}{}{after}", call.arg(5))))
}

fn reverse(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "string reverse string")?;
    Ok(Value::from(call.arg(2).as_str().chars().rev().collect::<String>()))
}

fn repeat(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "string repeat string count")?;
    let count = call.arg(3).to_int()?;
    let text = call.arg(2).as_str();
    let count = usize::try_from(count).unwrap_or(0);
    match text.len().checked_mul(count) {
        Some(size) if size < 1 << 31 => Ok(Value::from(text.repeat(count))),
        _ => {
            let message = "result exceeds max size for a Tcl value (2147483647 bytes)";
            Err(Exception::coded(message, &["TCL", "MEMORY"]))
        }
    }
}

/// `?-nocase? ?-length int? string1 string2`: how the two compare.
fn order(call: &Call<'_>, name: &str) -> Result<Ordering, Exception> {
    let usage = format!("string {name} ?-nocase? ?-length int? string1 string2");
    call.expect(4..=7, &usage)?;
    let (mut nocase, mut limit) = (false, None);
    let mut i = 2;
    while i < call.len() - 2 {
        let option = call.arg(i).as_str();
        if option.len() > 1 && "-nocase".starts_with(&*option) {
            nocase = true;
        } else if option.len() > 1 && "-length".starts_with(&*option) {
            i += 1;
            if i >= call.len() - 2 {
                return Err(call.wrong_args(&usage));
            }
            limit = usize::try_from(call.arg(i).to_i64()?).ok();
        } else {
            let message = format!("bad option \"{option}\": must be -nocase or -length");
            let code = ["TCL", "LOOKUP", "INDEX", "option", &option];
            return Err(Exception::coded(message, &code).at(call.span(i), ""));
        }
        i += 1;
    }
    let (a, b) = (call.arg(i).as_str(), call.arg(i + 1).as_str());
    if !nocase && limit.is_none() {
        return Ok(a.cmp(&b));
    }
    let lower = |c: char| if nocase { c.to_lowercase().next().unwrap_or(c) } else { c };
    let limit = limit.unwrap_or(usize::MAX);
    Ok(a.chars().take(limit).map(lower).cmp(b.chars().take(limit).map(lower)))
}

fn compare(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    Ok(Value::from(order(call, "compare")? as i64))
}

fn equal(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    Ok(Value::from(order(call, "equal")?.is_eq()))
}

fn place(byte: Option<usize>, text: &str) -> Value {
    match byte {
        Some(byte) => Value::from(text[..byte].chars().count()),
        None => Value::from(-1i64),
    }
}

fn first(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=5, "string first needleString haystackString ?startIndex?")?;
    let (needle, value) = (call.arg(2).as_str(), call.arg(3));
    let text = value.as_str();
    let count = value.char_count();
    let start = match call.get(4) {
        None => 0,
        Some(start) => index(start, count as i64 - 1)?.max(0) as usize,
    };
    if needle.is_empty() || start >= count {
        return Ok(Value::from(-1i64));
    }
    let skipped = slice(value, &text, 0..start).len();
    Ok(place(text[skipped..].find(&*needle).map(|at| at + skipped), &text))
}

fn last(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=5, "string last needleString haystackString ?startIndex?")?;
    let (needle, value) = (call.arg(2).as_str(), call.arg(3));
    let text = value.as_str();
    let count = value.char_count();
    let end = match call.get(4) {
        None => count as i64,
        Some(end) => index(end, count as i64 - 1)?.min(count as i64 - 1) + 1,
    };
    if needle.is_empty() || end <= 0 {
        return Ok(Value::from(-1i64));
    }
    let head = slice(value, &text, 0..end as usize);
    Ok(place(head.rfind(&*needle), &text))
}

fn map(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "string map ?-nocase? charMap string";
    call.expect(4..=5, usage)?;
    let nocase = call.len() == 5;
    if nocase {
        let option = call.arg(2).as_str();
        if option.len() < 2 || !"-nocase".starts_with(&*option) {
            let message = format!("bad option \"{option}\": must be -nocase");
            let code = ["TCL", "LOOKUP", "INDEX", "option", &option];
            return Err(Exception::coded(message, &code).at(call.span(2), ""));
        }
    }
    let pairs = call.arg(call.len() - 2).to_list()?;
    if pairs.len() % 2 == 1 {
        let code = ["TCL", "OPERATION", "MAP", "UNBALANCED"];
        return Err(Exception::coded("char map list unbalanced", &code).at(call.span(call.len() - 2), ""));
    }
    let text = call.arg(call.len() - 1).as_str();
    let pairs: Vec<(Cow<'_, str>, &Value)> = pairs
        .chunks_exact(2)
        .filter_map(|p| if let [from, to] = p { Some((from.as_str(), to)) } else { None })
        .filter(|(from, _)| !from.is_empty())
        .collect();
    let mut out = String::with_capacity(text.len());
    let mut rest: &str = &text;
    'text: while let Some(c) = rest.chars().next() {
        for (from, to) in &pairs {
            let length =
                if nocase { starts_nocase(rest, from) } else { rest.starts_with(&**from).then_some(from.len()) };
            if let Some(length) = length {
                to.write_to(&mut out);
                rest = &rest[length..];
                continue 'text;
            }
        }
        out.push(c);
        rest = &rest[c.len_utf8()..];
    }
    Ok(Value::from(out))
}

/// Length in bytes of a word at the start of a text, whatever its case.
fn starts_nocase(text: &str, word: &str) -> Option<usize> {
    let mut length = 0;
    let mut chars = text.chars();
    for w in word.chars() {
        let c = chars.next()?;
        if !c.to_lowercase().eq(w.to_lowercase()) {
            return None;
        }
        length += c.len_utf8();
    }
    Some(length)
}

fn string_match(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=5, "string match ?-nocase? pattern string")?;
    if call.len() == 4 {
        return Ok(Value::from(glob::matches(&call.arg(2).as_str(), &call.arg(3).as_str())));
    }
    let option = call.arg(2).as_str();
    if option.len() < 2 || !"-nocase".starts_with(&*option) {
        let message = format!("bad option \"{option}\": must be -nocase");
        let code = ["TCL", "LOOKUP", "INDEX", "option", &option];
        return Err(Exception::coded(message, &code).at(call.span(2), ""));
    }
    Ok(Value::from(glob::matches_nocase(&call.arg(3).as_str(), &call.arg(4).as_str())))
}

/// `string ?first? ?last?`: the text before, in and after the part that is meant.
fn parts(call: &Call<'_>, name: &str) -> Result<(String, String, String), Exception> {
    call.expect(3..=5, &format!("string {name} string ?first? ?last?"))?;
    let value = call.arg(2);
    let text = value.as_str();
    let count = value.char_count();
    let chars = match (call.get(3), call.get(4)) {
        (None, _) => 0..count,
        (Some(first), Some(last)) => range(first, last, count)?,
        (Some(first), None) => {
            let at = index(first, count as i64 - 1)?.max(0) as usize;
            if at < count { at..at + 1 } else { 0..0 }
        }
    };
    if chars.is_empty() {
        return Ok((text.into_owned(), String::new(), String::new()));
    }
    let before = slice(value, &text, 0..chars.start).to_owned();
    let after = slice(value, &text, chars.end..count).to_owned();
    Ok((before, slice(value, &text, chars).to_owned(), after))
}

fn case(call: &Call<'_>, name: &str, convert: fn(char) -> String) -> Result<Value, Exception> {
    let (before, part, after) = parts(call, name)?;
    let converted: String = part.chars().map(convert).collect();
    Ok(Value::from(before + &converted + &after))
}

fn totitle(call: &Call<'_>) -> Result<Value, Exception> {
    let (before, part, after) = parts(call, "totitle")?;
    let mut chars = part.chars();
    let head = chars.next().map(upper).unwrap_or_default();
    Ok(Value::from(before + &head + &chars.as_str().to_lowercase() + &after))
}

/// Characters that `string trim` removes by default.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\0' | '\u{180e}' | '\u{200b}' | '\u{2060}' | '\u{feff}')
}

fn trim(call: &Call<'_>, name: &str, left: bool, right: bool) -> Result<Value, Exception> {
    call.expect(3..=4, &format!("string {name} string ?chars?"))?;
    let text = call.arg(2).as_str();
    let chars = call.get(3).map(Value::as_str);
    let goes = |c: char| chars.as_ref().map_or_else(|| is_blank(c), |set| set.contains(c));
    let mut part: &str = &text;
    if left {
        part = part.trim_start_matches(goes);
    }
    if right {
        part = part.trim_end_matches(goes);
    }
    Ok(if part.len() == text.len() { call.arg(2).clone() } else { Value::from(part) })
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn wordend(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "string wordend string index")?;
    let chars: Vec<char> = call.arg(2).as_str().chars().collect();
    let at = index(call.arg(3), chars.len() as i64 - 1)?.max(0) as usize;
    if at >= chars.len() {
        return Ok(Value::from(chars.len()));
    }
    let word = chars[at..].iter().take_while(|c| is_word(**c)).count();
    Ok(Value::from(at + word.max(1)))
}

fn wordstart(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "string wordstart string index")?;
    let chars: Vec<char> = call.arg(2).as_str().chars().collect();
    let at = index(call.arg(3), chars.len() as i64 - 1)?.min(chars.len() as i64 - 1);
    if at <= 0 {
        return Ok(Value::from(0i64));
    }
    let at = at as usize;
    let word = chars[..=at].iter().rev().take_while(|c| is_word(**c)).count();
    Ok(Value::from(at + 1 - word.max(1)))
}
