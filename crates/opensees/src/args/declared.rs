//! Numbers that are read by their declarations.

use super::Args;
use crate::Tcl;
use crate::text::{Arg, Domain};
use hysteron_tcl::Exception;

impl Args<'_> {
    /// A number of the domain that is declared. What only OpenSees takes is for the session to judge.
    pub(crate) fn read(&mut self, interp: &mut Tcl, arg: &Arg) -> Result<f64, Exception> {
        match arg.domain {
            Some(Domain::UsuallyPositive) => self.usually_positive(interp, arg.meaning),
            Some(Domain::UsuallyNotNegative) => self.usually_not_negative(interp, arg.meaning),
            _ => self.number(arg),
        }
    }

    /// The same without a session: what only OpenSees takes is refused.
    pub(crate) fn number(&mut self, arg: &Arg) -> Result<f64, Exception> {
        let what = arg.meaning;
        match arg.domain {
            Some(Domain::Positive | Domain::UsuallyPositive) => self.positive(what),
            Some(Domain::NotNegative | Domain::UsuallyNotNegative) => self.not_negative(what),
            Some(Domain::Negative) => self.within(&what, Domain::Negative),
            Some(Domain::Ratio) => {
                let x = self.not_negative(what)?;
                if x < 1.0 { Ok(x) } else { Err(self.refuse(format!("{what} is {x}"), "expected 0 to below 1")) }
            }
            Some(Domain::Fraction) => {
                let x = self.float(what)?;
                let within = (0.0..=1.0).contains(&x);
                if within { Ok(x) } else { Err(self.refuse(format!("{what} is {x}"), "expected a number 0 to 1")) }
            }
            Some(Domain::Whole | Domain::Tag) => self.int(what).map(f64::from),
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

    /// A number, or its value where it is left out.
    pub(crate) fn read_or(&mut self, interp: &mut Tcl, arg: &Arg, value: f64) -> Result<f64, Exception> {
        if self.at_number() {
            return self.read(interp, arg);
        }
        let [value] = self.left_out([value]);
        Ok(value)
    }

    /// Numbers one after the other, or their values where no word is left.
    pub(crate) fn read_all_or<const N: usize>(
        &mut self,
        interp: &mut Tcl,
        args: &[Arg; N],
        values: [f64; N],
    ) -> Result<[f64; N], Exception> {
        if self.left() > 0 { self.read_all(interp, args) } else { Ok(self.left_out(values)) }
    }

    /// Numbers one after the other as long as words are left, and the values of the others.
    pub(crate) fn read_leading<const N: usize>(
        &mut self,
        interp: &mut Tcl,
        args: [&Arg; N],
        mut values: [f64; N],
    ) -> Result<[f64; N], Exception> {
        for (x, arg) in values.iter_mut().zip(args) {
            if self.left() > 0 {
                *x = self.read(interp, arg)?;
            }
        }
        Ok(values)
    }

    /// Values of numbers that are left out: a `parameter` may change them all the same.
    pub(crate) fn left_out<const N: usize>(&self, values: [f64; N]) -> [f64; N] {
        values.iter().for_each(|value| self.call.note_omitted(self.at, *value));
        values
    }

    /// A number, where the next word is one.
    pub(crate) fn read_optional(&mut self, interp: &mut Tcl, arg: &Arg) -> Result<Option<f64>, Exception> {
        if self.at_number() { self.read(interp, arg).map(Some) } else { Ok(None) }
    }

    /// The same without a session.
    pub(crate) fn optional_number(&mut self, arg: &Arg) -> Result<Option<f64>, Exception> {
        if self.at_number() { self.number(arg).map(Some) } else { Ok(None) }
    }
}
