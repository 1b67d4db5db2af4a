//! Form of a value: what it is made of, for hosts whose values have types.

use super::list::List;
use super::number::Number;
use super::value::{Rep, Value};

/// Form in which a value was made.
#[derive(Clone)]
pub enum Form<'a> {
    /// The empty text, list or dictionary.
    Empty,
    /// An integer.
    Int(i64),
    /// A double.
    Double(f64),
    /// A text, or an integer beyond 64 bits.
    Text(std::borrow::Cow<'a, str>),
    /// A list.
    List(List),
    /// A dictionary: keys and values in turn.
    Dict(List),
}

impl Value {
    /// Form in which the value was made. A number that was read from a text is a text.
    ///
    /// ```
    /// use hysteron_tcl::{Form, Value};
    /// assert!(matches!(Value::from(0.5).form(), Form::Double(0.5)));
    /// assert!(matches!(Value::from("0.5").form(), Form::Text(_)));
    /// ```
    pub fn form(&self) -> Form<'_> {
        match &self.0 {
            Rep::Empty => Form::Empty,
            Rep::Int(i) => Form::Int(*i),
            Rep::Double(d) => Form::Double(d.get()),
            Rep::Big(_) | Rep::Str(_) => Form::Text(self.as_str()),
            Rep::List(l) => Form::List(List(l.clone())),
            Rep::Dict(d) => Form::Dict(d.to_list()),
        }
    }
}

impl Value {
    /// The text as a double, where it is one: [`Value::to_f64`] without a message.
    #[inline]
    pub fn as_f64(&self) -> Option<f64> {
        let x = match &self.0 {
            Rep::Int(i) => *i as f64,
            Rep::Double(d) => d.get(),
            Rep::Empty => return None,
            _ => self.number()?.to_f64(),
        };
        (!x.is_nan()).then_some(x)
    }

    /// The text as an integer of 64 bits, where it is one: [`Value::to_i64`] without a message.
    #[inline]
    pub fn as_i64(&self) -> Option<i64> {
        match &self.0 {
            Rep::Int(i) => Some(*i),
            Rep::Empty | Rep::Double(_) => None,
            _ => match self.number()? {
                Number::Int(i) => Some(i),
                Number::Big(_) | Number::Double(_) => None,
            },
        }
    }
}
