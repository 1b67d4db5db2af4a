//! Outcomes of a command other than a value.

use super::value::Value;
use crate::diagnostic::{Absent, Check, Diagnostic, Span};

/// Early end of a command.
#[derive(Debug)]
pub enum Exception {
    /// An error.
    Error(Box<ScriptError>),
    /// `return value`: ends the procedure.
    Return(Value),
    /// `return` with options.
    ReturnWith(Box<Returned>),
    /// `break`
    Break,
    /// `continue`
    Continue,
    /// `return -code 5`: a code of the script's own, with its result.
    Other(i32, Value),
    /// `exit`: the whole script ends with this status.
    Exit(i32),
    /// The interrupt flag was set or the budget of commands is spent; cannot be caught.
    Interrupted,
}

/// Options and value of a `return`.
#[derive(Debug)]
pub struct Returned {
    /// The result.
    pub value: Value,
    /// Return code that takes effect once `level` procedures are left.
    pub code: i32,
    /// Number of procedures still to be left.
    pub level: usize,
    /// Further options, names and values.
    pub options: Vec<(Value, Value)>,
}

/// An error of a script.
#[derive(Debug)]
pub struct ScriptError {
    /// Message with its place in the script.
    pub diagnostic: Diagnostic,
    /// Result of `catch`: Tcl's text for the error.
    pub result: Value,
    /// Value of `$errorInfo`: the result and the commands that were under way.
    pub error_info: String,
    /// Value of `$errorCode`; `NONE` unless it was set.
    pub error_code: Option<Value>,
    /// True if the script raised it itself (`error`, `throw`, `return -code error`): no command was rejected.
    pub raised: bool,
    /// Options of the script's own, from `return -options`.
    pub(crate) options: Vec<(Value, Value)>,
    /// Line of the failing command in the innermost script of the trace.
    pub(crate) line: usize,
    /// Place of that line, to count lines from the start of a body.
    pub(crate) place: Option<Span>,
    /// True once place and callers are final.
    pub(crate) located: bool,
    /// True once the command that failed is in the trace.
    pub(crate) traced: bool,
}

impl ScriptError {
    fn new(result: Value) -> Box<Self> {
        let first_line = result.as_str().lines().next().unwrap_or_default().to_owned();
        Self::with(Diagnostic::error(first_line), result)
    }

    fn with(diagnostic: Diagnostic, result: Value) -> Box<Self> {
        Box::new(ScriptError {
            diagnostic,
            result,
            error_info: String::new(),
            error_code: None,
            raised: false,
            options: vec![],
            line: 1,
            place: None,
            located: false,
            traced: false,
        })
    }
}

impl Exception {
    /// An error with Tcl's text for it.
    pub fn error(message: impl Into<String>) -> Self {
        Exception::Error(ScriptError::new(Value::from(message.into())))
    }

    /// An error of the script's own.
    pub(crate) fn error_value(result: Value) -> Self {
        let mut error = ScriptError::new(result);
        error.raised = true;
        Exception::Error(error)
    }

    /// An error with Tcl's text and code for it.
    pub fn coded(message: impl Into<String>, code: &[&str]) -> Self {
        Self::error(message).with_code(Value::list(code.iter().map(|c| Value::from(*c))))
    }

    /// An error with a diagnostic of its own, whose message is the result of `catch`.
    pub fn diagnosed(diagnostic: Diagnostic) -> Self {
        let result = Value::from(diagnostic.message.as_str());
        Exception::Error(ScriptError::with(diagnostic, result))
    }

    /// Change the error; nothing happens where this is none.
    pub(crate) fn map_error(mut self, change: impl FnOnce(&mut ScriptError)) -> Self {
        if let Exception::Error(e) = &mut self {
            change(e);
        }
        self
    }

    /// Set what `$errorCode` will be.
    pub fn with_code(self, code: Value) -> Self {
        self.map_error(|e| e.error_code = Some(code))
    }

    /// Point at a word, unless the error points somewhere already, and say what was expected there.
    pub fn at(self, span: Option<Span>, label: &str) -> Self {
        self.map_error(|e| {
            if e.diagnostic.span.is_none() {
                e.diagnostic.span = span;
                if e.diagnostic.label.is_empty() {
                    label.clone_into(&mut e.diagnostic.label);
                }
            }
        })
    }

    /// Add a line of help.
    pub fn help(self, help: impl Into<String>) -> Self {
        self.map_error(|e| e.diagnostic.help.push(help.into()))
    }

    /// Name the check that found it.
    pub fn by(self, check: &'static Check) -> Self {
        self.map_error(|e| e.diagnostic.check = Some(check))
    }

    /// Name the thing that it says is missing.
    pub fn absent(self, absent: Absent) -> Self {
        self.map_error(|e| e.diagnostic.absent = Some(absent))
    }

    /// Offer the nearest known name for a word that is wrong.
    pub(crate) fn suggest(self, wrong: &str, near: Option<String>) -> Self {
        self.map_error(|e| e.diagnostic.add_suggestion(wrong, near.as_deref()))
    }

    /// Add a line to what `$errorInfo` will be.
    pub(crate) fn trace(self, line: impl FnOnce(usize) -> String) -> Self {
        self.map_error(|e| {
            if e.error_info.is_empty() {
                e.error_info = e.result.as_str().into_owned();
            }
            let text = line(e.line);
            e.error_info.push_str(&format!("\n    ({text})"));
            // The trace goes on with the command around it.
            e.traced = false;
        })
    }

    /// Outcome of a command for a return code and a result.
    pub(crate) fn from_code(code: i32, value: Value) -> Result<Value, Exception> {
        match code {
            0 => Ok(value),
            1 => Err(Exception::error_value(value)),
            2 => Err(Exception::Return(value)),
            3 => Err(Exception::Break),
            4 => Err(Exception::Continue),
            code => Err(Exception::Other(code, value)),
        }
    }
}
