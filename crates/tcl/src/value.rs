//! Values: everything is a string, and yet numbers, lists and dictionaries are kept as such until their text is asked for.

use num_bigint::BigInt;
use num_traits::ToPrimitive as _;
use std::borrow::Cow;
use std::cell::{Cell, OnceCell, RefCell};
use std::fmt;
use std::rc::Rc;

use super::dict::{Dict, DictObj};
use super::error::Exception;
use super::list::{self, List, ListObj};
use super::number::{self, Bits, Number};
use super::origin::Origin;
use super::text::{Cache, StrObj, Text};

/// A Tcl value. Cloning copies a reference at most.
///
/// ```
/// use hysteron_tcl::Value;
/// let v = Value::from("1 2 {3 4}");
/// assert_eq!(v.to_list().unwrap().len(), 3);
/// assert_eq!(Value::from(0.1).as_str(), "0.1");
/// ```
#[derive(Clone, Default)]
pub struct Value(pub(crate) Rep);

/// Representation of a value.
#[derive(Clone, Default)]
pub(crate) enum Rep {
    #[default]
    Empty,
    Int(i64),
    Double(Bits),
    Big(Rc<BigInt>),
    Str(Rc<StrObj>),
    List(Rc<ListObj>),
    Dict(Rc<DictObj>),
}

impl Value {
    /// The empty string.
    pub const EMPTY: Value = Value(Rep::Empty);

    /// A text that stands at a known place of a script. Integers and doubles in Tcl's own spelling become numbers at once.
    pub(crate) fn literal(text: String, origin: Option<Origin>) -> Value {
        if let Some(v) = Self::plain_number(&text) {
            return v;
        }
        Value(Rep::Str(StrObj::new(text, origin)))
    }

    fn plain_number(text: &str) -> Option<Value> {
        let first = *text.as_bytes().first()?;
        if !(first.is_ascii_digit() || first == b'-') {
            return None;
        }
        if let Some(i) = number::plain_int(text) {
            return Some(Value::from(i));
        }
        match number::prefix(text)? {
            (length, Number::Double(d)) if length == text.len() && text.len() < 20 => {
                let mut written = String::new();
                number::write_double(&mut written, d);
                (written == text).then(|| Value::from(d))
            }
            _ => None,
        }
    }

    /// A list element; only integers are recognised, since checking the spelling of a double costs more than it saves.
    pub(crate) fn element(text: &str, origin: impl FnOnce() -> Option<Origin>) -> Value {
        match number::plain_int(text) {
            Some(i) => Value::from(i),
            None if text.is_empty() => Value::EMPTY,
            None => Value(Rep::Str(StrObj::new(text.to_owned(), origin()))),
        }
    }

    /// A text whose number is known, for instance a double written with fewer digits than it has.
    pub(crate) fn with_number(text: String, number: Number) -> Value {
        let obj = StrObj::new(text, None);
        obj.set_cache(Cache::Number(number));
        Value(Rep::Str(obj))
    }

    /// The text of the value.
    pub fn as_str(&self) -> Cow<'_, str> {
        match &self.0 {
            Rep::Empty => Cow::Borrowed(""),
            Rep::Str(s) => Cow::Borrowed(&s.text),
            Rep::List(l) => Cow::Borrowed(l.text()),
            Rep::Dict(d) => Cow::Borrowed(d.text()),
            Rep::Int(_) | Rep::Double(_) | Rep::Big(_) => {
                let mut out = String::new();
                self.write_to(&mut out);
                Cow::Owned(out)
            }
        }
    }

    /// Append the text of the value.
    pub fn write_to(&self, out: &mut String) {
        use fmt::Write as _;
        match &self.0 {
            Rep::Int(i) => out.push_str(itoa::Buffer::new().format(*i)),
            Rep::Big(b) => {
                let _ = write!(out, "{b}");
            }
            Rep::Double(d) => number::write_double(out, d.get()),
            Rep::Empty | Rep::Str(_) | Rep::List(_) | Rep::Dict(_) => out.push_str(&self.as_str()),
        }
    }

    /// The text as the key of a table.
    pub(crate) fn to_text(&self) -> Text {
        match &self.0 {
            Rep::Str(s) => Text(s.clone()),
            _ => Text(StrObj::new(self.as_str().into_owned(), None)),
        }
    }

    /// The text, in an object that can remember what it means. Replaces a number or list by its text.
    pub(crate) fn str_obj(&self) -> Rc<StrObj> {
        self.to_text().0
    }

    pub(crate) fn origin(&self) -> Option<&Origin> {
        match &self.0 {
            Rep::Str(s) => s.origin(),
            _ => None,
        }
    }

    /// Returns true if the text is empty.
    pub fn is_empty(&self) -> bool {
        match &self.0 {
            Rep::Empty => true,
            Rep::Str(s) => s.text.is_empty(),
            Rep::List(l) => l.is_empty(),
            Rep::Dict(d) => d.is_empty(),
            Rep::Int(_) | Rep::Double(_) | Rep::Big(_) => false,
        }
    }

    /// Length in characters.
    pub fn char_count(&self) -> usize {
        let s = match &self.0 {
            Rep::Str(s) => s,
            Rep::Int(i) => {
                return i.unsigned_abs().checked_ilog10().map_or(1, |n| n as usize + 1 + usize::from(*i < 0));
            }
            _ => return self.as_str().chars().count(),
        };
        if s.chars.get() == u32::MAX {
            s.chars.set(s.text.chars().count() as u32);
        }
        s.chars.get() as usize
    }

    /// Returns true if every character is one byte, so that indices of characters are those of bytes.
    pub(crate) fn is_ascii(&self) -> bool {
        match &self.0 {
            Rep::Str(s) => self.char_count() == s.text.len(),
            _ => self.as_str().is_ascii(),
        }
    }

    /// The text, to append to; in place where nothing else holds this value.
    pub(crate) fn text_mut(&mut self) -> &mut String {
        // Weak references are never made.
        let unique = matches!(&self.0, Rep::Str(s) if Rc::strong_count(s) == 1);
        if !unique {
            self.0 = Rep::Str(StrObj::new(self.as_str().into_owned(), None));
        }
        match &mut self.0 {
            Rep::Str(s) => match Rc::get_mut(s) {
                Some(obj) => {
                    obj.cache = RefCell::default();
                    obj.origin = None;
                    obj.chars = Cell::new(u32::MAX);
                    obj.text.own()
                }
                None => unreachable!("nothing else holds it"),
            },
            _ => unreachable!("just made a string"),
        }
    }

    /// The number that the text is, if it is one.
    pub(crate) fn number(&self) -> Option<Number> {
        match &self.0 {
            Rep::Int(i) => Some(Number::Int(*i)),
            Rep::Double(d) => Some(Number::Double(d.get())),
            Rep::Big(b) => Some(Number::Big(b.clone())),
            Rep::Str(s) => s.number(),
            Rep::List(l) if l.len() == 1 => number::parse(l.text()),
            Rep::Empty | Rep::List(_) | Rep::Dict(_) => None,
        }
    }

    /// The text as a double.
    ///
    /// # Errors
    /// The text is no number, or not a number (`NaN`).
    pub fn to_f64(&self) -> Result<f64, Exception> {
        match &self.0 {
            Rep::Int(i) => Ok(*i as f64),
            Rep::Double(d) if !d.get().is_nan() => Ok(d.get()),
            _ => match self.number() {
                Some(n) if !n.to_f64().is_nan() => Ok(n.to_f64()),
                Some(_) => Err(not_a_number()),
                None => Err(self.not_a("floating-point number")),
            },
        }
    }

    /// The text as an integer of 64 bits.
    ///
    /// # Errors
    /// The text is no integer, or needs more than 64 bits.
    pub fn to_i64(&self) -> Result<i64, Exception> {
        if let Rep::Int(i) = &self.0 {
            return Ok(*i);
        }
        match self.number() {
            Some(Number::Int(i)) => Ok(i),
            Some(Number::Big(_)) => Err(too_large()),
            Some(Number::Double(_)) | None => {
                let message = format!("expected integer but got \"{self}\"");
                Err(Exception::coded(message, &["TCL", "VALUE", "INTEGER"]))
            }
        }
    }

    /// An integer of 32 bits, with or without a sign, where Tcl takes no others.
    pub(crate) fn to_int(&self) -> Result<i64, Exception> {
        let i = self.to_i64()?;
        if i.unsigned_abs() > u64::from(u32::MAX) { Err(too_large()) } else { Ok(i) }
    }

    /// As [`Value::to_i64`], with the error code of commands that want 64 bits.
    pub(crate) fn to_wide(&self) -> Result<i64, Exception> {
        match self.to_integer()? {
            Number::Int(i) => Ok(i),
            _ => Err(too_large()),
        }
    }

    /// An integer of any size.
    pub(crate) fn to_integer(&self) -> Result<Number, Exception> {
        match self.number() {
            Some(Number::Double(_)) | None => {
                let message = format!("expected integer but got \"{self}\"");
                Err(Exception::coded(message, &["TCL", "VALUE", "NUMBER"]))
            }
            Some(n) => Ok(n),
        }
    }

    pub(crate) fn not_a(&self, kind: &str) -> Exception {
        let text = self.as_str();
        let mut message = format!("expected {kind} but got \"{text}\"");
        if number::looks_like_bad_octal(&text) {
            message.push_str(" (looks like invalid octal number)");
        }
        Exception::coded(message, &["TCL", "VALUE", "NUMBER"])
    }

    /// The text as a boolean: a number, or `true`, `yes`, `on` and their opposites.
    /// # Errors
    /// Any other text.
    pub fn to_bool(&self) -> Result<bool, Exception> {
        match self.truth() {
            Some(b) => Ok(b),
            None if self.number().is_some() => Err(not_a_number()),
            None => Err(self.not_a("boolean value")),
        }
    }

    pub(crate) fn truth(&self) -> Option<bool> {
        match self.number() {
            Some(Number::Int(i)) => Some(i != 0),
            Some(Number::Double(d)) => (!d.is_nan()).then_some(d != 0.0),
            Some(Number::Big(_)) => Some(true),
            None => number::boolean_word(&self.as_str()),
        }
    }

    /// The text as a list.
    ///
    /// # Errors
    /// A brace or quote in the text is not closed, or text follows a closed one.
    pub fn to_list(&self) -> Result<List, Exception> {
        match &self.0 {
            Rep::Empty => Ok(List::default()),
            Rep::List(l) => Ok(List(l.clone())),
            Rep::Dict(d) => Ok(d.to_list()),
            Rep::Int(_) | Rep::Double(_) | Rep::Big(_) => Ok(List::from(vec![self.clone()])),
            Rep::Str(s) => {
                if let Some(l) = s.cached(|c| if let Cache::List(l) = c { Some(l.clone()) } else { None }) {
                    return Ok(l);
                }
                let l = List::from(list::parse(&s.text, s.origin(), s.stretch_if_shared())?);
                s.set_cache(Cache::List(l.clone()));
                Ok(l)
            }
        }
    }

    /// Make this a list of its own and give its elements, to change them.
    pub(crate) fn list_mut(&mut self) -> Result<&mut Vec<Value>, Exception> {
        if !matches!(self.0, Rep::List(_)) {
            let list = self.to_list()?;
            // Gives up the text first, so that the elements it has cached need not be copied.
            self.0 = Rep::Empty;
            self.0 = Rep::List(list.0);
        }
        match &mut self.0 {
            Rep::List(l) => Ok(ListObj::make_mut(l)),
            _ => unreachable!("just made a list"),
        }
    }

    /// The dictionary that the text is.
    pub(crate) fn to_dict(&self) -> Result<Dict, Exception> {
        match &self.0 {
            Rep::Empty => Ok(Dict::default()),
            Rep::Dict(d) => Ok(Dict(d.clone())),
            Rep::List(l) => l.as_dict(),
            Rep::Int(_) | Rep::Double(_) | Rep::Big(_) => Dict::from_list(&self.to_list()?),
            Rep::Str(s) => {
                if let Some(d) = s.cached(|c| if let Cache::Dict(d) = c { Some(Dict(d.clone())) } else { None }) {
                    return Ok(d);
                }
                let d = Dict::from_text(self)?;
                s.set_cache(Cache::Dict(d.0.clone()));
                Ok(d)
            }
        }
    }

    /// Make this a dictionary of its own, to change it.
    pub(crate) fn dict_mut(&mut self) -> Result<&mut super::table::Table<Value>, Exception> {
        if !matches!(self.0, Rep::Dict(_)) {
            let dict = self.to_dict()?;
            self.0 = Rep::Empty;
            self.0 = Rep::Dict(dict.0);
        }
        match &mut self.0 {
            Rep::Dict(d) => Ok(DictObj::make_mut(d)),
            _ => unreachable!("just made a dictionary"),
        }
    }

    /// Returns true if dropping this value may drop others inside it.
    pub(crate) fn is_nested(&self) -> bool {
        match &self.0 {
            Rep::List(_) | Rep::Dict(_) => true,
            Rep::Str(s) => matches!(&*s.cache.borrow(), Cache::List(_)),
            _ => false,
        }
    }

    /// Let go of this value, but hand over the values within if nothing else holds them.
    pub(crate) fn take_apart(self, rest: &mut Vec<Value>) {
        match self.0 {
            Rep::List(l) => {
                if let Ok(mut l) = Rc::try_unwrap(l) {
                    rest.append(&mut l.take_items());
                }
            }
            Rep::Dict(d) => {
                if let Ok(mut d) = Rc::try_unwrap(d) {
                    rest.append(&mut d.take_values());
                }
            }
            Rep::Str(s) => {
                if let Ok(s) = Rc::try_unwrap(s)
                    && let Cache::List(List(l)) = s.cache.take()
                    && let Ok(mut l) = Rc::try_unwrap(l)
                {
                    rest.append(&mut l.take_items());
                }
            }
            _ => {}
        }
    }

    /// A list of values.
    pub fn list(items: impl IntoIterator<Item = Value>) -> Value {
        Value::from(items.into_iter().collect::<Vec<_>>())
    }
}

fn not_a_number() -> Exception {
    Exception::coded("floating point value is Not a Number", &["TCL", "VALUE", "DOUBLE", "NAN"])
}

/// The error for integers beyond 64 bits where only those will do.
pub(crate) fn too_large() -> Exception {
    Exception::coded(
        "integer value too large to represent",
        &["ARITH", "IOVERFLOW", "integer value too large to represent"],
    )
}

impl fmt::Debug for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&*self.as_str(), f)
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.as_str())
    }
}

impl PartialEq for Value {
    fn eq(&self, other: &Value) -> bool {
        match (&self.0, &other.0) {
            (Rep::Int(a), Rep::Int(b)) => a == b,
            _ => self.as_str() == other.as_str(),
        }
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        if text.is_empty() { Value::EMPTY } else { Value(Rep::Str(StrObj::new(text.to_owned(), None))) }
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        if text.is_empty() { Value::EMPTY } else { Value(Rep::Str(StrObj::new(text, None))) }
    }
}

impl From<i64> for Value {
    fn from(i: i64) -> Self {
        Value(Rep::Int(i))
    }
}

impl From<usize> for Value {
    fn from(i: usize) -> Self {
        Value(Rep::Int(i64::try_from(i).unwrap_or(i64::MAX)))
    }
}

impl From<f64> for Value {
    fn from(d: f64) -> Self {
        Value(Rep::Double(d.into()))
    }
}

impl From<bool> for Value {
    fn from(b: bool) -> Self {
        Value(Rep::Int(i64::from(b)))
    }
}

impl From<Vec<Value>> for Value {
    fn from(items: Vec<Value>) -> Self {
        if items.is_empty() { Value::EMPTY } else { Value(Rep::List(ListObj::new(items))) }
    }
}

impl From<BigInt> for Value {
    fn from(big: BigInt) -> Self {
        match big.to_i64() {
            Some(i) => Value::from(i),
            None => Value(Rep::Big(Rc::new(big))),
        }
    }
}

impl From<Number> for Value {
    fn from(n: Number) -> Self {
        match n {
            Number::Int(i) => Value(Rep::Int(i)),
            Number::Big(b) => Value(Rep::Big(b)),
            Number::Double(d) => Value::from(d),
        }
    }
}

/// Text of a list, worked out once.
pub(crate) type LazyText = OnceCell<Box<str>>;
