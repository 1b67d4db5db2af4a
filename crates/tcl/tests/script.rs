//! The Tcl interpreter: conformance with tclsh 8.6, places of errors, and properties.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "script/api.rs"]
mod api;
#[path = "script/conformance.rs"]
mod conformance;
#[path = "script/limits.rs"]
mod limits;
#[path = "script/lookalikes.rs"]
mod lookalikes;
#[path = "script/places.rs"]
mod places;
#[path = "script/properties.rs"]
mod properties;

use hysteron_tcl::{Exception, Interp, MemoryFiles, Recorded, ScriptError, Value};

/// An interpreter with files in memory whose output is kept.
fn interp() -> (Interp<()>, Recorded, MemoryFiles) {
    let console = Recorded::default();
    let files = MemoryFiles::default();
    (Interp::new((), Box::new(console.clone()), Box::new(files.clone())), console, files)
}

/// The result of a script, which must not fail.
fn value(script: &str) -> String {
    match interp().0.eval_str("test.tcl", script) {
        Ok(v) => v.as_str().into_owned(),
        Err(e) => panic!("{script}: {e:?}"),
    }
}

/// The error of a script, which must fail.
fn error(interp: &mut Interp<()>, script: &str) -> Box<ScriptError> {
    match interp.eval_str("test.tcl", script) {
        Err(Exception::Error(e)) => e,
        Ok(v) => panic!("no error but {v}: {script}"),
        Err(e) => panic!("{script}: {e:?}"),
    }
}

/// The elements of a list.
fn elements(list: &Value) -> Vec<String> {
    list.to_list().unwrap().iter().map(|v| v.as_str().into_owned()).collect()
}
