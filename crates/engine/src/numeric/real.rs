//! Numbers of one model, or of several side by side, for formulas that are written once.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::wide::{WIDTH, Wide};
use std::ops::{Add, AddAssign, BitAnd, Div, Mul, Neg, Not, Sub, SubAssign};

/// A number of one model, or of several side by side. Formulas choose between numbers in place of branches.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + Neg<Output = Self>
{
    /// An answer for each model.
    type Flags: Copy + PartialEq + BitAnd<Output = Self::Flags> + Not<Output = Self::Flags>;
    /// All models.
    const ALL: Self::Flags;
    /// No model.
    const NONE: Self::Flags;
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;

    /// The same number in all models.
    fn of(x: f64) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The larger of two numbers; no number where one is none.
    fn larger(self, other: Self) -> Self;
    /// `then` where this one is greater than `than`, else `otherwise`.
    fn where_greater(self, than: Self, then: Self, otherwise: Self) -> Self;
    /// `then` where this one equals `other`, else `otherwise`.
    fn where_equal(self, other: Self, then: Self, otherwise: Self) -> Self;
    /// Models in which this one is greater than `other`, or one of them is no number.
    fn exceeds(self, other: Self) -> Self::Flags;
    /// A function that is no vector instruction, of the models that want it.
    fn one_by_one(self, wanted: Self::Flags, f: fn(f64) -> f64) -> Self;
}

impl Real for f64 {
    type Flags = bool;
    const ALL: bool = true;
    const NONE: bool = false;
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other || self.is_nan() { self } else { other }
    }
    #[inline(always)]
    fn where_greater(self, than: Self, then: Self, otherwise: Self) -> Self {
        if self > than { then } else { otherwise }
    }
    #[inline(always)]
    fn where_equal(self, other: Self, then: Self, otherwise: Self) -> Self {
        if self == other { then } else { otherwise }
    }
    #[inline(always)]
    #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "true where one is no number")]
    fn exceeds(self, other: Self) -> bool {
        !(self <= other)
    }
    #[inline(always)]
    fn one_by_one(self, wanted: bool, f: fn(f64) -> f64) -> Self {
        if wanted { f(self) } else { 0.0 }
    }
}

impl Real for Wide {
    type Flags = super::wide::Flags;
    const ALL: Self::Flags = Self::Flags::MAX;
    const NONE: Self::Flags = 0;
    const ZERO: Self = Self::all(0.0);
    const ONE: Self = Self::all(1.0);

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self::all(x)
    }
    #[inline(always)]
    fn abs(mut self) -> Self {
        for x in &mut self.0 {
            *x = x.abs();
        }
        self
    }
    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for x in &mut self.0 {
            *x = x.sqrt();
        }
        self
    }
    #[inline(always)]
    fn larger(mut self, other: Self) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = x.larger(y);
        }
        self
    }
    #[inline(always)]
    fn where_greater(mut self, than: Self, then: Self, otherwise: Self) -> Self {
        for i in 0..WIDTH {
            self.0[i] = self.0[i].where_greater(than.0[i], then.0[i], otherwise.0[i]);
        }
        self
    }
    #[inline(always)]
    fn where_equal(mut self, other: Self, then: Self, otherwise: Self) -> Self {
        for i in 0..WIDTH {
            self.0[i] = self.0[i].where_equal(other.0[i], then.0[i], otherwise.0[i]);
        }
        self
    }
    #[inline(always)]
    fn exceeds(self, other: Self) -> Self::Flags {
        !self.at_most(other)
    }
    /// Evaluated once where all models have the same number, as of displacements that are imposed on all.
    #[inline(always)]
    fn one_by_one(self, wanted: Self::Flags, f: fn(f64) -> f64) -> Self {
        let first = self.0[0].to_bits();
        let mut differ = 0;
        for i in 0..WIDTH {
            differ |= self.0[i].to_bits() ^ first;
        }
        if differ == 0 { Self::all(f(self.0[0])) } else { self.each(wanted, f) }
    }
}
