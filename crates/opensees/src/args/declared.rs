//! Numbers that are read by their declarations.

use super::Args;
use crate::Tcl;
use crate::text::{Arg, Domain};
use hysteron_tcl::Exception;

impl Args<'_> {
    /// A number of the domain that is declared. What only OpenSees takes is for the session to judge.
    pub(crate) fn read(&mut self, interp: &mut Tcl, arg: &Arg) -> Result<f64, Exception> {
        let Some(domain) = arg.domain.filter(|domain| domain.is_usual()) else { return self.number(arg) };
        let what = arg.meaning;
        let x = self.float(what)?;
        if !domain.holds(x) {
            self.doubt(interp, format!("{what} is {x}"), format!("expected the {what}, {}", domain.expected()))?;
        }
        Ok(x)
    }

    /// The same without a session: what only OpenSees takes is refused.
    pub(crate) fn number(&mut self, arg: &Arg) -> Result<f64, Exception> {
        let what = arg.meaning;
        match arg.domain.unwrap_or(Domain::Number) {
            Domain::Count => self.count(arg).map(|n| n as f64),
            Domain::Whole | Domain::Tag => self.int(what).map(f64::from),
            domain => self.within(&what, domain),
        }
    }

    /// A number that is one of several, counted from 1: the message of an error names it.
    pub(crate) fn nth_number(&mut self, arg: &Arg, i: usize) -> Result<f64, Exception> {
        self.within(&format_args!("{} {i}", arg.meaning), arg.domain.unwrap_or(Domain::Number))
    }

    /// Numbers that have been read as a list, each in its domain. The error points at the last word taken.
    pub(crate) fn judge(&self, args: &[&Arg], numbers: &[f64]) -> Result<(), Exception> {
        for (arg, x) in args.iter().zip(numbers) {
            let (what, domain) = (arg.meaning, arg.domain.unwrap_or(Domain::Number));
            if !domain.holds(*x) {
                let label = format!("expected the {what}, {}", domain.expected());
                return Err(self.out_of_range(format!("{what} is {x}"), label));
            }
        }
        Ok(())
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

    /// The same without a session: what only OpenSees takes is refused.
    pub(crate) fn numbers<const N: usize>(&mut self, args: &[Arg; N]) -> Result<[f64; N], Exception> {
        let mut out = [0.0; N];
        for (x, arg) in out.iter_mut().zip(args) {
            *x = self.number(arg)?;
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
