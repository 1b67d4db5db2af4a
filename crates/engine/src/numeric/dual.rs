//! Numbers that carry their derivative.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with its derivative by one variable: what is computed with it is differentiated on the way, so that the
/// tangent of an algorithm is that of the algorithm and not of the equations behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number that does not depend on the variable.
    #[inline]
    pub fn constant(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }

    /// Its absolute value.
    #[inline]
    pub fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    /// A power of a number that is not negative. At zero the derivative of a power with an exponent less than one is
    /// infinite; it is taken for zero there.
    #[inline]
    pub fn powf(self, exponent: Self) -> Self {
        if self.value <= 0.0 {
            let slope = if exponent.value == 1.0 { self.slope } else { 0.0 };
            return Self { value: if exponent.value == 0.0 { 1.0 } else { 0.0 }, slope };
        }
        let value = self.value.powf(exponent.value);
        let mut slope = exponent.value * value / self.value * self.slope;
        if exponent.slope != 0.0 {
            slope += value * self.value.ln() * exponent.slope;
        }
        Self { value, slope }
    }

    /// The exponential.
    #[inline]
    pub fn exp(self) -> Self {
        let value = self.value.exp();
        Self { value, slope: value * self.slope }
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, slope: self.slope + o.slope }
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, slope: self.slope - o.slope }
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self { value: self.value * o.value, slope: self.value * o.slope + self.slope * o.value }
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self { value, slope: (self.slope - value * o.slope) / o.value }
    }
}

impl Mul<Dual> for f64 {
    type Output = Dual;
    #[inline]
    fn mul(self, o: Dual) -> Dual {
        Dual { value: self * o.value, slope: self * o.slope }
    }
}
