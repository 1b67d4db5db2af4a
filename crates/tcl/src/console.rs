//! Destination of a script's output.

use std::cell::RefCell;
use std::rc::Rc;

/// Receiver of the text that a script writes to `stdout` and `stderr`.
pub trait Console {
    /// Text for `stdout`.
    fn out(&mut self, text: &str);
    /// Text for `stderr`.
    fn err(&mut self, text: &str);
}

/// A console that drops the text.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Console for Silent {
    fn out(&mut self, _: &str) {}

    fn err(&mut self, _: &str) {}
}

/// A console that keeps the text. Clones share it.
#[derive(Clone, Debug, Default)]
pub struct Recorded {
    written: Rc<RefCell<(String, String)>>,
}

impl Recorded {
    /// Text written to `stdout` so far.
    pub fn out(&self) -> String {
        self.written.borrow().0.clone()
    }

    /// Text written to `stderr` so far.
    pub fn err(&self) -> String {
        self.written.borrow().1.clone()
    }
}

impl Console for Recorded {
    fn out(&mut self, text: &str) {
        self.written.borrow_mut().0.push_str(text);
    }

    fn err(&mut self, text: &str) {
        self.written.borrow_mut().1.push_str(text);
    }
}
