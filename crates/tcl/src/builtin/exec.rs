//! Commands that are refused: a script cannot start other programs, load machine code or reach the network.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[
    ("exec", programs),
    ("load", |_, call| refused(call, "a script cannot load machine code")),
    ("pid", |_, call| refused(call, "a script cannot see processes")),
    ("socket", |_, call| refused(call, "a script cannot reach the network")),
    ("unload", |_, call| refused(call, "a script cannot load machine code")),
];

fn refused(call: &Call<'_>, why: &str) -> Result<Value, Exception> {
    let code = Value::list(["HYSTERON", "REFUSED", &call.name()].map(Value::from));
    Err(call.error_at(0, format!("{}: {why}", call.name()), "refused").with_code(code))
}

fn programs(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    refused(call, "a script cannot start other programs")
}
