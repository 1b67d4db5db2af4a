//! Numbers of several models side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::lanes::BLOCK;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Models side by side: as many as the widest vector instructions have numbers.
pub const WIDTH: usize = BLOCK;

/// A flag of each of [`WIDTH`] models: a bit, the first one the lowest.
pub type Flags = u8;

/// The flag that is set in all models.
pub const ALL: Flags = Flags::MAX;

/// Returns true if the flag of a model is set.
#[inline(always)]
pub fn is_set(flags: Flags, model: usize) -> bool {
    flags >> model & 1 == 1
}

/// A number of each of [`WIDTH`] models. Where loops run in lanes its operations are vector instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Wide(pub [f64; WIDTH]);

impl Wide {
    /// The same number in all models.
    #[inline(always)]
    pub const fn all(x: f64) -> Self {
        Self([x; WIDTH])
    }

    /// 1 in the models whose flag is set, else 0.
    #[inline(always)]
    pub fn of_flags(flags: Flags) -> Self {
        let mut out = [0.0; WIDTH];
        for i in 0..WIDTH {
            out[i] = if is_set(flags, i) { 1.0 } else { 0.0 };
        }
        Self(out)
    }

    /// Number by number this one where its flag is set, else `otherwise`.
    #[inline(always)]
    pub fn where_flag(self, flags: Flags, otherwise: Self) -> Self {
        let mut out = [0.0; WIDTH];
        for i in 0..WIDTH {
            out[i] = if is_set(flags, i) { self.0[i] } else { otherwise.0[i] };
        }
        Self(out)
    }

    /// Flags of the models in which this one is not greater than `other`, and both are numbers.
    #[inline(always)]
    pub fn at_most(self, other: Self) -> Flags {
        // Bits side by side, which vector instructions join.
        let mut bits = [0u64; WIDTH];
        for i in 0..WIDTH {
            bits[i] = if self.0[i] <= other.0[i] { 1 << i } else { 0 };
        }
        let mut flags = 0;
        for bit in bits {
            flags |= bit;
        }
        flags as Flags
    }

    /// A function of each model that wants it.
    #[inline(never)]
    pub(super) fn each(self, wanted: Flags, f: fn(f64) -> f64) -> Self {
        let mut out = Self::all(0.0);
        for i in 0..WIDTH {
            if is_set(wanted, i) {
                out.0[i] = f(self.0[i]);
            }
        }
        out
    }

    /// Flags of the models in which it is no number.
    #[inline(always)]
    pub fn is_no_number(self) -> Flags {
        !self.at_most(self)
    }
}

macro_rules! by_number {
    ($($name:ident $method:ident),*) => {$(
        impl $name for Wide {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for i in 0..WIDTH {
                    self.0[i] = self.0[i].$method(other.0[i]);
                }
                self
            }
        }
        impl $name<f64> for Wide {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: f64) -> Self {
                for i in 0..WIDTH {
                    self.0[i] = self.0[i].$method(other);
                }
                self
            }
        }
    )*};
}
by_number!(Add add, Sub sub, Mul mul, Div div);

impl AddAssign for Wide {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Wide {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Neg for Wide {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for i in 0..WIDTH {
            self.0[i] = -self.0[i];
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, Wide};
    use crate::numeric::real::Real;

    #[test]
    fn the_larger_of_two_is_no_number_where_one_is_none() {
        let (one, nan) = (Wide::all(1.0), Wide::all(f64::NAN));
        for max in [one.larger(nan), nan.larger(one)] {
            assert!((0..WIDTH).all(|i| max.0[i].is_nan()));
        }
        assert_eq!(one.larger(Wide::all(2.0)).0, [2.0; WIDTH]);
        assert_eq!(Wide::all(3.0).larger(one).0, [3.0; WIDTH]);
    }
}
