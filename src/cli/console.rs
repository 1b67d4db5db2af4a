//! Output of a script.

use super::print::{write_err, write_out};
use super::progress::ProgressLine;
use hysteron::tcl::Console;

/// The terminal: `puts` goes to standard output, the rest to standard error.
pub(super) struct Terminal {
    progress: ProgressLine,
}

impl Terminal {
    pub(super) fn new(progress: ProgressLine) -> Self {
        Self { progress }
    }
}

impl Console for Terminal {
    fn out(&mut self, text: &str) {
        // A closed pipe does not stop an analysis; the exit status tells of it.
        self.progress.suspend(|| write_out(text));
    }

    fn err(&mut self, text: &str) {
        self.progress.suspend(|| write_err(text));
    }
}

/// Prints what a script prints to standard error, each line behind the name of the script.
pub(super) struct PrefixedOutput {
    prefix: String,
    /// The current line has begun.
    in_line: bool,
}

impl PrefixedOutput {
    pub(super) fn new(script: &str) -> Self {
        Self { prefix: format!("{script} prints: "), in_line: false }
    }

    fn print(&mut self, text: &str) {
        for line in text.split_inclusive('\n') {
            let prefix = if self.in_line { "" } else { &self.prefix };
            eprint!("{prefix}{line}");
            self.in_line = !line.ends_with('\n');
        }
    }
}

impl Console for PrefixedOutput {
    fn out(&mut self, text: &str) {
        self.print(text);
    }

    fn err(&mut self, text: &str) {
        self.print(text);
    }
}
