//! Words that elements were made from, and sessions in which things are made again: their warnings are dropped.

use crate::{Mode, NoFiles, Session, Tcl};
use hysteron_engine::analysis::Options;
use hysteron_engine::element::Element;
use hysteron_engine::model::Definitions;
use hysteron_engine::parameter::{NewValue, ParameterError};
use hysteron_tcl::{Exception, Form, Interp, MemoryFiles, Silent, Value};
use std::cell::Cell;
use std::fmt;
use std::sync::Arc;

/// A word as it was given, which shares nothing with the value of the call: numbers are texts only once they are read again.
#[derive(Clone)]
pub(crate) enum OwnWord {
    /// A whole number.
    Int(i64),
    /// A number.
    Double(f64),
    /// Any other word.
    Text(String),
}

impl OwnWord {
    /// Of a word of a call.
    pub(crate) fn of(word: &Value) -> Self {
        match word.form() {
            Form::Int(i) => Self::Int(i),
            Form::Double(x) => Self::Double(x),
            _ => Self::Text(word.as_str().into_owned()),
        }
    }

    /// The number that the word is, if it is one.
    pub(crate) fn number(&self) -> Option<f64> {
        match self {
            Self::Int(i) => Some(*i as f64),
            Self::Double(x) => Some(*x),
            Self::Text(text) => Value::from(text.as_str()).as_f64(),
        }
    }
}

impl fmt::Display for OwnWord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(i) => write!(f, "{i}"),
            Self::Double(x) => write!(f, "{}", Value::from(*x)),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// The words that an element between two nodes was made from.
#[derive(Clone)]
pub(crate) struct WordsOfElement {
    /// Words of the call, the name of the command being the first.
    pub(crate) words: Vec<Value>,
    /// Displacements of its nodes when it was made.
    pub(crate) disp: Vec<f64>,
    /// The element as the model holds it. Another in its place was not made from these words alone.
    pub(crate) made: Arc<dyn Element>,
    /// Changes by parameters of the element itself since.
    pub(crate) changes: Vec<(Vec<String>, NewValue)>,
}

impl WordsOfElement {
    /// The words as texts, which share nothing with the values of the call: the element may be made again in another session.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.words.iter().map(|w| w.as_str().into_owned()).collect()
    }
}

thread_local! {
    /// The session of this thread. A new one takes ten times as long as a material.
    static SCRATCH: Cell<Option<Tcl>> = const { Cell::new(None) };
}

fn new_session() -> Tcl {
    let session = Session::new(Options::default(), Mode::Run, false, Box::new(NoFiles));
    Interp::new(session, Box::new(Silent), Box::new(MemoryFiles::default()))
}

fn with_session<T>(work: impl FnOnce(&mut Tcl) -> T) -> T {
    let mut session = SCRATCH.take().unwrap_or_else(new_session);
    let result = work(&mut session);
    session.clear_warnings();
    SCRATCH.set(Some(session));
    result
}

/// Works in a session that knows some definitions alone.
pub(crate) fn with_definitions<T>(options: &Options, definitions: Definitions, work: impl FnOnce(&mut Tcl) -> T) -> T {
    with_session(|session| {
        session.host.engine.options = options.clone();
        session.host.builder.definitions = definitions;
        work(session)
    })
}

/// Works on the model and the definitions of a session.
pub(crate) fn in_scratch<T>(interp: &mut Tcl, work: impl FnOnce(&mut Tcl) -> T) -> T {
    with_session(|session| {
        std::mem::swap(&mut session.host.engine, &mut interp.host.engine);
        std::mem::swap(&mut session.host.builder, &mut interp.host.builder);
        let result = work(session);
        std::mem::swap(&mut session.host.engine, &mut interp.host.engine);
        std::mem::swap(&mut session.host.builder, &mut interp.host.builder);
        result
    })
}

/// The error of a command as the refusal of a parameter.
pub(crate) fn as_refusal(e: Exception) -> ParameterError {
    ParameterError::Refused(match e {
        Exception::Error(e) => e.diagnostic.message,
        _ => "it cannot be made".to_owned(),
    })
}
