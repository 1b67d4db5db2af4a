//! Where the output of a script goes.

use std::cell::RefCell;
use std::rc::Rc;

/// Receives what a script writes to `stdout` and `stderr`.
pub trait Console {
    /// Text for `stdout`.
    fn out(&mut self, text: &str);
    /// Text for `stderr`.
    fn err(&mut self, text: &str);
}

/// Keeps what is written; clones share it.
#[derive(Clone, Debug, Default)]
pub struct Recorded {
    written: Rc<RefCell<(String, String)>>,
}

impl Recorded {
    /// What was written to `stdout` so far.
    pub fn out(&self) -> String {
        self.written.borrow().0.clone()
    }

    /// What was written to `stderr` so far.
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
