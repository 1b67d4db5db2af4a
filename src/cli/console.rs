//! The script's own output.

use super::progress::Bar;
use hysteron::tcl::Console;
use std::io::Write;

/// The terminal: `puts` goes to standard output, the rest to standard error.
pub(super) struct Terminal {
    out: std::io::BufWriter<std::io::Stdout>,
    bar: Bar,
}

impl Terminal {
    pub(super) fn new(bar: Bar) -> Self {
        Self { out: std::io::BufWriter::new(std::io::stdout()), bar }
    }
}

impl Console for Terminal {
    fn out(&mut self, text: &str) {
        // A reader that has gone away is no reason to stop an analysis.
        self.bar.aside(|| {
            let _ = self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush());
        });
    }

    fn err(&mut self, text: &str) {
        self.bar.aside(|| {
            let _ = self.out.flush();
            let _ = std::io::stderr().write_all(text.as_bytes());
        });
    }
}
