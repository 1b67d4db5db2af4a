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
