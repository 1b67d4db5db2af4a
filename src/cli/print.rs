//! Printing that neither panics nor loses an error.
//!
//! The macros of the standard library panic where an output is full or closed. These note the first error of standard output,
//! which the exit status then tells of. Standard error has nowhere to tell of its own errors.

use std::io::Write as _;
use std::sync::OnceLock;

/// The first error of standard output.
static FAILURE: OnceLock<String> = OnceLock::new();

/// Write to standard output.
pub(super) fn write_out(text: &str) {
    let mut out = std::io::stdout().lock();
    if let Err(e) = out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        let _ = FAILURE.set(e.to_string());
    }
}

/// Write to standard error.
pub(super) fn write_err(text: &str) {
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// The exit status, given that of the command: results that could not be printed are an error.
pub(super) fn status(status: i32) -> i32 {
    let Some(error) = FAILURE.get() else { return status };
    eprintln!("error: cannot write to standard output: {error}");
    if status == 0 { 1 } else { status }
}

macro_rules! print {
    ($($text:tt)*) => { $crate::cli::print::write_out(&format!($($text)*)) };
}

macro_rules! println {
    ($($text:tt)*) => { $crate::cli::print::write_out(&(format!($($text)*) + "\n")) };
}

macro_rules! eprint {
    ($($text:tt)*) => { $crate::cli::print::write_err(&format!($($text)*)) };
}

macro_rules! eprintln {
    ($($text:tt)*) => { $crate::cli::print::write_err(&(format!($($text)*) + "\n")) };
}
