//! Flags: whole numbers that switch something on or off.

use super::Args;
use crate::checks::words;
use crate::{Tcl, warn};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::fmt::Display;

impl Args<'_> {
    /// A flag: 0 is off, 1 is on. Another number is on as in OpenSees, with a warning.
    pub(crate) fn switch(&mut self, interp: &mut Tcl, what: &str) -> Result<bool, Exception> {
        self.switch_as(interp, &what)
    }

    /// The same for one of several, counted from 1.
    pub(crate) fn nth_switch(&mut self, interp: &mut Tcl, what: &str, i: usize) -> Result<bool, Exception> {
        self.switch_as(interp, &format_args!("{what} {i}"))
    }

    fn switch_as(&mut self, interp: &mut Tcl, what: &dyn Display) -> Result<bool, Exception> {
        let flag = self.int_as(what)?;
        self.judge_switch(interp, what, flag, flag != 0)
    }

    /// A flag that may be left out. Another number than 0 and 1 is off as in OpenSees, with a warning.
    pub(crate) fn optional_switch(&mut self, interp: &mut Tcl, what: &str) -> Result<Option<bool>, Exception> {
        let Some(flag) = self.optional_int(what)? else { return Ok(None) };
        self.judge_switch(interp, &what, flag, flag == 1).map(Some)
    }

    fn judge_switch(&self, interp: &mut Tcl, what: &dyn Display, flag: i32, on: bool) -> Result<bool, Exception> {
        if !matches!(flag, 0 | 1) {
            let message = format!("{what} is {flag} and counts as {}", u8::from(on));
            warn(interp, Diagnostic::warning(&words::NO_FLAG, message).at(self.last_span(), "expected 0 or 1"))?;
        }
        Ok(on)
    }
}
