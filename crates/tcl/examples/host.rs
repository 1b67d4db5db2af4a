//! A host with a command of its own: `load $node $force` puts forces on nodes, and refuses those that are not there.
//!
//! Run it with `cargo run -p hysteron-tcl --example host`. The script has a mistake: the message shows the word.
#![allow(clippy::print_stdout)]

use std::collections::BTreeMap;

use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};
use hysteron_tcl::{Call, Exception, Interp, MemoryFiles, Recorded, Value};

const SCRIPT: &str = "\
node 1
node 2
proc storey {tag force} {
    load $tag [expr {$force / 2.0}]
}
storey 2 100
storey 3 50
";

/// Force on each node.
type Forces = BTreeMap<i64, f64>;

/// `node $tag`.
fn node(interp: &mut Interp<Forces>, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() != 2 {
        return Err(call.usage(1, "tag"));
    }
    interp.host.insert(call.arg(1).to_i64()?, 0.0);
    Ok(Value::EMPTY)
}

/// `load $node $force`.
fn load(interp: &mut Interp<Forces>, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() != 3 {
        return Err(call.usage(1, "node force"));
    }
    let (tag, force) = (call.arg(1).to_i64()?, call.arg(2).to_f64()?);
    let Some(total) = interp.host.get_mut(&tag) else {
        let known: Vec<String> = interp.host.keys().map(i64::to_string).collect();
        let error = Diagnostic::error(format!("there is no node {tag}"))
            .at(call.span(1), "expected the tag of a node")
            .help(format!("defined: {}", known.join(" ")));
        return Err(call.refuse(1, error));
    };
    *total += force;
    Ok(Value::EMPTY)
}

/// A message with the line of the script and a mark under the word.
fn show(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let mut out = format!("error: {}\n", diagnostic.message);
    if let Some(span) = diagnostic.span {
        let at = sources.location(span);
        let text = sources.text(span.source);
        let line = text.lines().nth(at.line - 1).unwrap_or_default();
        let mark = " ".repeat(at.column - 1) + &"^".repeat(sources.snippet(span).chars().count());
        out += &format!("  at {at}\n    {line}\n    {mark} {}\n", diagnostic.label);
    }
    for caller in &diagnostic.callers {
        out += &format!("  in {}, called at {}\n", caller.what, sources.location(caller.span));
    }
    for help in &diagnostic.help {
        out += &format!("  {help}\n");
    }
    out
}

fn main() {
    let mut interp = Interp::new(Forces::new(), Box::new(Recorded::default()), Box::new(MemoryFiles::default()));
    interp.register("node", node);
    interp.register("load", load);
    match interp.eval_str("frame.tcl", SCRIPT) {
        Err(Exception::Error(error)) => print!("{}", show(&error.diagnostic, &interp.sources)),
        outcome => println!("{outcome:?}"),
    }
    println!("forces: {:?}", interp.host);
}
