//! Runs a Tcl script as `tclsh FILE ARG...` does, without the commands of the engine: for comparing with tclsh.
#![allow(clippy::print_stdout, clippy::print_stderr, clippy::exit)]

use std::io::Write as _;

use hysteron_tcl::{Console, Exception, Interp, OsFiles, Value};

struct Terminal;

impl Console for Terminal {
    fn out(&mut self, text: &str) {
        let _ = std::io::stdout().write_all(text.as_bytes());
    }

    fn err(&mut self, text: &str) {
        let _ = std::io::stderr().write_all(text.as_bytes());
    }
}

fn main() {
    let mut args = std::env::args().skip(1);
    let Some(path) = args.next() else {
        eprintln!("usage: tclsh FILE ARG...");
        std::process::exit(2);
    };
    let mut interp = Interp::new((), Box::new(Terminal), Box::new(OsFiles));
    let rest: Vec<Value> = args.map(Value::from).collect();
    let told = interp
        .set_global("argc", rest.len())
        .and_then(|()| interp.set_global("argv", rest))
        .and_then(|()| interp.set_global("argv0", path.as_str()));
    let status = match told.and_then(|()| interp.eval_file(&path)) {
        Ok(_) => 0,
        Err(Exception::Exit(code)) => code,
        Err(Exception::Error(e)) => {
            eprintln!("{}", e.error_info);
            let d = &e.diagnostic;
            match d.span {
                Some(span) => {
                    let word = interp.sources.snippet(span);
                    eprintln!("{}: {} [{word}] {} {:?}", interp.sources.location(span), d.message, d.label, d.help);
                }
                None => eprintln!("{}", d.message),
            }
            for caller in &d.callers {
                eprintln!("  in {} at {}", caller.what, interp.sources.location(caller.span));
            }
            1
        }
        Err(other) => {
            eprintln!("{other:?}");
            1
        }
    };
    let _ = std::io::stdout().flush();
    std::process::exit(status);
}
