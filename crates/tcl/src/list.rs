//! Lists: reading them from text, writing them with the quoting that Tcl chooses.

use std::cell::OnceCell;
use std::ops::Deref;
use std::rc::Rc;

use super::dict::Dict;
use super::error::Exception;
use super::escape;
use super::number::is_space;
use super::origin::Origin;
use super::stack;
use super::stretch::{MIN_SHARED, Stretch};
use super::value::{LazyText, Rep, Value};

/// The elements of a list and, once it was asked for, its text.
#[derive(Default)]
pub(crate) struct ListObj {
    items: Vec<Value>,
    text: LazyText,
    dict: OnceCell<Dict>,
}

impl ListObj {
    pub(crate) fn new(items: Vec<Value>) -> Rc<Self> {
        Rc::new(Self { items, text: OnceCell::new(), dict: OnceCell::new() })
    }

    pub(crate) fn text(&self) -> &str {
        self.text.get_or_init(|| stack::grow(|| join(&self.items)).into_boxed_str())
    }

    pub(crate) fn as_dict(&self) -> Result<Dict, Exception> {
        if let Some(d) = self.dict.get() {
            return Ok(d.clone());
        }
        let d = Dict::from_list(&self.items)?;
        Ok(self.dict.get_or_init(|| d).clone())
    }

    /// The elements, to change them; copied first where the list is shared.
    pub(crate) fn make_mut(this: &mut Rc<Self>) -> &mut Vec<Value> {
        if Rc::get_mut(this).is_none() {
            *this = Self::new(this.items.clone());
        }
        match Rc::get_mut(this) {
            Some(obj) => {
                obj.text = OnceCell::new();
                obj.dict = OnceCell::new();
                &mut obj.items
            }
            None => unreachable!("just made a list of its own"),
        }
    }
}

impl Deref for ListObj {
    type Target = [Value];
    fn deref(&self) -> &[Value] {
        &self.items
    }
}

impl Drop for ListObj {
    fn drop(&mut self) {
        dismantle(std::mem::take(&mut self.items));
    }
}

/// Let go of values that may be nested deeper than the stack is: take them apart one by one.
pub(crate) fn dismantle(mut waiting: Vec<Value>) {
    if waiting.iter().all(|v| !v.is_nested()) {
        return;
    }
    while let Some(value) = waiting.pop() {
        value.take_apart(&mut waiting);
    }
}

impl ListObj {
    pub(crate) fn take_items(&mut self) -> Vec<Value> {
        std::mem::take(&mut self.items)
    }
}

/// The elements of a list, to look at.
#[derive(Clone, Default)]
pub struct List(pub(crate) Rc<ListObj>);

impl List {
    pub(crate) fn into_value(self) -> Value {
        if self.0.is_empty() { Value::EMPTY } else { Value(Rep::List(self.0)) }
    }
}

impl From<Vec<Value>> for List {
    fn from(items: Vec<Value>) -> Self {
        List(ListObj::new(items))
    }
}

impl Deref for List {
    type Target = [Value];
    fn deref(&self) -> &[Value] {
        &self.0.items
    }
}

/// Position of the next element of a list's text.
pub(crate) struct Element {
    /// Content, without braces or quotes.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// True if backslashes in it are still to be replaced.
    pub(crate) escaped: bool,
    /// Start of the search for the element after it.
    pub(crate) next: usize,
}

/// Find the next element from `at`.
pub(crate) fn next_element(text: &str, at: usize) -> Result<Option<Element>, Exception> {
    let bytes = text.as_bytes();
    let mut i = at;
    while i < bytes.len() && is_space(bytes[i]) {
        i += 1;
    }
    match bytes.get(i) {
        None => Ok(None),
        Some(b'{') => braced(text, i).map(Some),
        Some(b'"') => quoted(text, i).map(Some),
        Some(_) => {
            let start = i;
            let mut escaped = false;
            while i < bytes.len() && !is_space(bytes[i]) {
                if bytes[i] == b'\\' {
                    escaped = true;
                    i += escape::backslash(text, i).0;
                } else {
                    i += 1;
                }
            }
            Ok(Some(Element { start, end: i.min(text.len()), escaped, next: i.min(text.len()) }))
        }
    }
}

fn braced(text: &str, open: usize) -> Result<Element, Exception> {
    let bytes = text.as_bytes();
    let mut depth = 1;
    let mut i = open + 1;
    while i < bytes.len() {
        match bytes[i] {
            b'\\' => i += 1,
            b'{' => depth += 1,
            b'}' => {
                depth -= 1;
                if depth == 0 {
                    end_of_element(text, i + 1, "braces")?;
                    return Ok(Element { start: open + 1, end: i, escaped: false, next: i + 1 });
                }
            }
            _ => {}
        }
        i += 1;
    }
    Err(Exception::coded("unmatched open brace in list", &["TCL", "VALUE", "LIST", "BRACE"]))
}

fn quoted(text: &str, open: usize) -> Result<Element, Exception> {
    let bytes = text.as_bytes();
    let mut escaped = false;
    let mut i = open + 1;
    while i < bytes.len() {
        match bytes[i] {
            b'\\' => {
                escaped = true;
                i += escape::backslash(text, i).0;
                continue;
            }
            b'"' => {
                end_of_element(text, i + 1, "quotes")?;
                return Ok(Element { start: open + 1, end: i, escaped, next: i + 1 });
            }
            _ => {}
        }
        i += 1;
    }
    Err(Exception::coded("unmatched open quote in list", &["TCL", "VALUE", "LIST", "QUOTE"]))
}

/// A blank must follow what closes an element.
fn end_of_element(text: &str, at: usize, what: &str) -> Result<(), Exception> {
    let Some(rest) = text.get(at..).filter(|r| !r.is_empty()) else { return Ok(()) };
    if is_space(rest.as_bytes()[0]) {
        return Ok(());
    }
    let junk: String = rest.chars().take_while(|c| !(c.is_ascii() && is_space(*c as u8))).take(20).collect();
    Err(Exception::coded(
        format!("list element in {what} followed by \"{junk}\" instead of space"),
        &["TCL", "VALUE", "LIST", "JUNK"],
    ))
}

/// Read a list. Elements know their place where the text does; long ones are stretches of `shared`, the same text.
pub(crate) fn parse(text: &str, origin: Option<&Origin>, shared: Option<&Stretch>) -> Result<Vec<Value>, Exception> {
    let mut items = Vec::new();
    let mut at = 0;
    while let Some(e) = next_element(text, at)? {
        let content = &text[e.start..e.end];
        items.push(if e.escaped {
            Value::from(escape::unescape(content))
        } else {
            let origin = || origin.map(|o| o.slice(e.start, e.end));
            match shared.filter(|_| content.len() >= MIN_SHARED) {
                Some(stretch) => Value::shared(stretch.part(e.start..e.end), origin()),
                None => Value::element(content, origin),
            }
        });
        at = e.next;
    }
    Ok(items)
}

#[derive(Clone, Copy, PartialEq)]
enum Quoting {
    Bare,
    Braces,
    /// Backslashes before everything special.
    Escapes,
    /// Backslashes before everything special but braces.
    EscapesButBraces,
}

/// The quoting that Tcl chooses for an element.
fn quoting(text: &str, first: bool) -> Quoting {
    let bytes = text.as_bytes();
    let Some(&head) = bytes.first() else { return Quoting::Braces };
    let mut depth = 0i64;
    let mut bare = true;
    let mut needs_escapes = false;
    let mut prefers_escapes = false;
    let mut prefers_braces = false;
    if head == b'#' && first {
        prefers_braces = true;
    }
    if head == b'{' || head == b'"' {
        bare = false;
        prefers_braces = true;
    }
    let mut i = 0;
    while i < bytes.len() {
        match bytes[i] {
            b'{' => depth += 1,
            b'}' => {
                depth -= 1;
                needs_escapes |= depth < 0;
            }
            b']' | b'"' => {
                bare = false;
                prefers_escapes = true;
            }
            b'[' | b'$' | b';' | b' ' | 0x0c | b'\n' | b'\r' | b'\t' | 0x0b => {
                bare = false;
                prefers_braces = true;
            }
            b'\\' => match bytes.get(i + 1) {
                None => needs_escapes = true,
                Some(b'\n') => {
                    needs_escapes = true;
                    i += 1;
                }
                Some(next) => {
                    if matches!(next, b'{' | b'}' | b'\\') {
                        i += 1;
                    }
                    bare = false;
                    prefers_braces = true;
                }
            },
            _ => {}
        }
        i += 1;
    }
    match () {
        () if needs_escapes || depth != 0 => Quoting::Escapes,
        () if bare && head == b'#' && first => Quoting::Braces,
        () if bare => Quoting::Bare,
        () if prefers_escapes && !prefers_braces => Quoting::EscapesButBraces,
        () => Quoting::Braces,
    }
}

/// Append an element to the text of a list, quoted as needed. `first`: whether it is the first of the list.
pub(crate) fn write_element(out: &mut String, text: &str, first: bool) {
    let quoting = quoting(text, first);
    match quoting {
        Quoting::Bare => out.push_str(text),
        Quoting::Braces => {
            out.push('{');
            out.push_str(text);
            out.push('}');
        }
        Quoting::Escapes | Quoting::EscapesButBraces => {
            let mut rest = text;
            if first && text.starts_with('#') {
                out.push_str("\\#");
                rest = &text[1..];
            }
            for c in rest.chars() {
                match c {
                    '{' | '}' if quoting == Quoting::EscapesButBraces => out.push(c),
                    ']' | '[' | '$' | ';' | ' ' | '\\' | '"' | '{' | '}' => out.extend(['\\', c]),
                    '\u{c}' => out.push_str("\\f"),
                    '\n' => out.push_str("\\n"),
                    '\r' => out.push_str("\\r"),
                    '\t' => out.push_str("\\t"),
                    '\u{b}' => out.push_str("\\v"),
                    c => out.push(c),
                }
            }
        }
    }
}

/// Append any value as an element.
pub(crate) fn write_value(out: &mut String, value: &Value, first: bool) {
    match &value.0 {
        Rep::Int(_) | Rep::Double(_) | Rep::Big(_) => value.write_to(out),
        _ => write_element(out, &value.as_str(), first),
    }
}

/// The text of a list.
pub(crate) fn join<'a>(items: impl IntoIterator<Item = &'a Value>) -> String {
    let mut out = String::new();
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push(' ');
        }
        write_value(&mut out, item, i == 0);
    }
    out
}
