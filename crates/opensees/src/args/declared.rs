//! Numbers that are read by their declarations.

use super::Args;
use crate::Tcl;
use crate::text::{Arg, Domain};
use hysteron_tcl::Exception;

impl Args<'_> {
    /// A number of the domain that is declared.
    pub(crate) fn read(&mut self, interp: &mut Tcl, arg: &Arg) -> Result<f64, Exception> {
        let what = arg.meaning;
        match arg.domain {
            Some(Domain::Positive) => self.positive(what),
            Some(Domain::NotNegative) => self.not_negative(what),
            Some(Domain::UsuallyPositive) => self.usually_positive(interp, what),
            Some(Domain::UsuallyNotNegative) => self.usually_not_negative(interp, what),
            Some(Domain::Ratio) => {
                let x = self.not_negative(what)?;
                if x < 1.0 { Ok(x) } else { Err(self.refuse(format!("{what} is {x}"), "expected 0 to below 1")) }
            }
            Some(Domain::Whole) => self.int(what).map(f64::from),
            Some(Domain::Number) | None => self.float(what),
        }
    }

    /// Numbers one after the other.
    pub(crate) fn read_all<const N: usize>(
        &mut self,
        interp: &mut Tcl,
        args: &[Arg; N],
    ) -> Result<[f64; N], Exception> {
        let mut out = [0.0; N];
        for (x, arg) in out.iter_mut().zip(args) {
            *x = self.read(interp, arg)?;
        }
        Ok(out)
    }

    /// A number, where the next word is one.
    pub(crate) fn read_optional(&mut self, interp: &mut Tcl, arg: &Arg) -> Result<Option<f64>, Exception> {
        if self.at_number() { self.read(interp, arg).map(Some) } else { Ok(None) }
    }
}
