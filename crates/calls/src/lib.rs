//! Calls of OpenSees in files of Python. Nothing is run: calls whose arguments are literal are read from the text and checked as
//! the commands of a script are.
//!
//! [`read`] finds the calls; [`check`] checks them. What depends on the state of the model is told only as far as all calls before
//! are known: they stand in a straight line, and their arguments are literal.

#![forbid(unsafe_code)]

mod check;
mod constants;
mod imports;
mod literal;
mod reader;
mod token;
mod writing;

pub use check::{Checked, Settings, check};
pub use imports::Module;
pub use reader::{Argument, FoundCall, Reading, Unclosed, read};
pub use writing::{OpenCall, bare, open_call};
