//! Output of a script.

use super::progress::ProgressLine;
use hysteron::tcl::Console;
use std::io::Write;

/// The terminal: `puts` goes to standard output, the rest to standard error.
pub(super) struct Terminal {
    out: std::io::BufWriter<std::io::Stdout>,
    progress: ProgressLine,
}

impl Terminal {
    pub(super) fn new(progress: ProgressLine) -> Self {
        Self { out: std::io::BufWriter::new(std::io::stdout()), progress }
    }
}

impl Console for Terminal {
    fn out(&mut self, text: &str) {
        // A closed pipe must not stop an analysis.
        self.progress.suspend(|| {
            let _ = self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush());
        });
    }

    fn err(&mut self, text: &str) {
        self.progress.suspend(|| {
            let _ = self.out.flush();
            let _ = std::io::stderr().write_all(text.as_bytes());
        });
    }
}

/// Discards what a script prints.
pub(super) struct NoOutput;

impl Console for NoOutput {
    fn out(&mut self, _: &str) {}

    fn err(&mut self, _: &str) {}
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
