//! Numbers as C++ streams write them.

use std::fmt::Write;

/// Format of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// Significant digits, or digits after the point in scientific notation.
    pub precision: usize,
    /// Always with an exponent.
    pub scientific: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self { precision: 6, scientific: false }
    }
}

/// A number to twelve digits, without the round-off of a sum or a change of units: 17.17 for 17.169999999999884.
pub fn without_round_off(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}

/// A short text on the stack: the longest number of 17 digits takes 24 characters.
struct Digits {
    bytes: [u8; 64],
    len: usize,
}

impl Write for Digits {
    fn write_str(&mut self, s: &str) -> std::fmt::Result {
        let end = self.len + s.len();
        self.bytes.get_mut(self.len..end).ok_or(std::fmt::Error)?.copy_from_slice(s.as_bytes());
        self.len = end;
        Ok(())
    }
}

impl Style {
    /// Append a number: like `%.{precision}g`, or `%.{precision}e` for scientific notation.
    pub fn push(self, value: f64, out: &mut String) {
        let mut bytes = vec![];
        self.push_bytes(value, &mut bytes);
        out.extend(bytes.iter().copied().map(char::from));
    }

    /// The same to bytes; does not allocate beyond the text itself.
    pub fn push_bytes(self, value: f64, out: &mut Vec<u8>) {
        if !value.is_finite() {
            out.extend_from_slice(if value.is_nan() {
                b"nan"
            } else if value > 0.0 {
                b"inf"
            } else {
                b"-inf"
            });
            return;
        }
        if !self.scientific && value == 0.0 {
            return out.extend_from_slice(if value.is_sign_negative() { b"-0" } else { b"0" });
        }
        if !self.scientific {
            let most = self.precision.max(1);
            if let Some((number, exponent)) = scaled(value.abs(), most) {
                return push_scaled(number, most, exponent, value < 0.0, out);
            }
        }
        let precision = self.precision.min(40);
        let digits = if self.scientific { precision } else { precision.max(1) - 1 };
        let Some(number) = Decimal::new(value, digits + 1) else { return };
        if value.is_sign_negative() {
            out.push(b'-');
        }
        let all = &number.digits[..number.len];
        let exponent = number.exponent;
        // Trailing zeros are written in scientific notation only.
        let kept = if self.scientific { digits + 1 } else { number.len };
        let zeros = |n: usize, out: &mut Vec<u8>| out.resize(out.len() + n, b'0');
        if self.scientific || exponent < -4 || exponent > digits as i32 {
            out.push(all[0]);
            if kept > 1 {
                out.push(b'.');
                out.extend_from_slice(&all[1..]);
                zeros(kept - number.len, out);
            }
            push_exponent(exponent, out);
        } else if exponent < 0 {
            out.extend_from_slice(b"0.");
            zeros((-exponent - 1) as usize, out);
            out.extend_from_slice(all);
        } else {
            let whole = exponent as usize + 1;
            if whole >= number.len {
                out.extend_from_slice(all);
                zeros(whole - number.len, out);
            } else {
                out.extend_from_slice(&all[..whole]);
                out.push(b'.');
                out.extend_from_slice(&all[whole..]);
            }
        }
    }
}

/// Most digits that the shortest text of a number decides.
const DECIDED: usize = 14;

/// The decimal logarithm of two as a whole number of parts of two to this power.
const LOG10_2_BITS: u32 = 20;
const LOG10_2_SCALED: i64 = 315_653;

/// Fraction of the last digit within which a scaled number does not decide.
const UNDECIDED: f64 = 1e-9;

/// Powers of ten that are whole numbers of 53 bits times a power of two.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
/// Powers of ten.
const TENS_WHOLE: [u64; DECIDED + 1] = {
    let mut all = [1; DECIDED + 1];
    let mut i = 1;
    while i <= DECIDED {
        all[i] = 10 * all[i - 1];
        i += 1;
    }
    all
};

/// Product of two numbers, and what its rounding left (Dekker, 1971).
fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let (p, (a1, a2), (b1, b2)) = (a * b, split(a), split(b));
    (p, a2 * b2 - (((p - a1 * b1) - a2 * b1) - a1 * b2))
}

/// A number times a power of ten as a sum of two. `None` where the power is too large or too small.
fn scale(value: f64, power: i32) -> Option<(f64, f64)> {
    let ten = *TENS.get(power.unsigned_abs() as usize)?;
    if power >= 0 {
        return Some(exact_product(value, ten));
    }
    let quotient = value / ten;
    let (product, rest) = exact_product(quotient, ten);
    Some((quotient, ((value - product) - rest) / ten))
}

/// A positive number rounded to at most `most` significant digits, as a whole number and the exponent of its first digit, by
/// a product or quotient with a power of ten, whose rounding error is known. `None` near a boundary of rounding, and where
/// the power is not a number of two to the 53rd.
fn scaled(value: f64, most: usize) -> Option<(u64, i32)> {
    let limit = *TENS_WHOLE.get(most)?;
    // The logarithm of two between powers of two is taken as a line below it: the exponent of ten is this or one more.
    let binary = (value.to_bits() >> (52 - LOG10_2_BITS)) as i64 - (1023 << LOG10_2_BITS);
    let mut exponent = ((binary * LOG10_2_SCALED) >> (2 * LOG10_2_BITS)) as i32;
    let (mut high, mut low) = scale(value, most as i32 - 1 - exponent)?;
    if high >= limit as f64 {
        exponent += 1;
        (high, low) = scale(value, most as i32 - 1 - exponent)?;
    }
    let whole = high as u64;
    let part = (high - whole as f64) + low;
    let up = part > 0.5 + UNDECIDED;
    if whole >= limit || whole < limit / 10 || !(up || (UNDECIDED..0.5 - UNDECIDED).contains(&part)) {
        return None;
    }
    let number = whole + u64::from(up);
    Some(if number == limit { (number / 10, exponent + 1) } else { (number, exponent) })
}

/// Longest text of a number of [`DECIDED`] digits, rounded up: sign, point, digits, and an exponent or leading zeros.
const TEXT: usize = 32;

/// Append a number of `most` digits, the first of them of the order of the exponent, as `%g` does. The text is put together
/// at places of a known length and copied once.
fn push_scaled(mut number: u64, most: usize, exponent: i32, negative: bool, out: &mut Vec<u8>) {
    let mut len = most;
    while number.is_multiple_of(10) && len > 1 {
        (number, len) = (number / 10, len - 1);
    }
    let mut text = [b'0'; TEXT];
    text[0] = b'-';
    let start = usize::from(negative);
    let end = if exponent < -4 || exponent >= most as i32 {
        let end = put_with_point(number, len, 1, start, &mut text);
        let size = exponent.unsigned_abs();
        (text[end], text[end + 1]) = (b'e', if exponent < 0 { b'-' } else { b'+' });
        // At least two digits, as in C.
        let places = if size >= 100 { 3 } else { 2 };
        put_digits(u64::from(size), places, end + 2, &mut text);
        end + 2 + places
    } else if exponent < 0 {
        text[start + 1] = b'.';
        // The text is filled with zeros.
        text[start] = b'0';
        let first = start + 1 + exponent.unsigned_abs() as usize;
        put_digits(number, len, first, &mut text);
        first + len
    } else {
        let whole = exponent as usize + 1;
        let end = put_with_point(number, len, whole, start, &mut text);
        // Zeros before the point, which there is none of then.
        if whole > len { start + whole } else { end }
    };
    let before = out.len();
    out.extend_from_slice(&text);
    out.truncate(before + end);
}

/// Puts the digits of a number, a point behind the first `whole` of them if there are more; returns the end.
fn put_with_point(number: u64, len: usize, whole: usize, start: usize, text: &mut [u8; TEXT]) -> usize {
    if whole >= len {
        put_digits(number, len, start, text);
        return start + len;
    }
    put_digits(number, len, start + 1, text);
    text.copy_within(start + 1..start + 1 + whole, start);
    text[start + whole] = b'.';
    start + len + 1
}

/// Puts the last `len` digits of a number.
fn put_digits(mut number: u64, len: usize, start: usize, text: &mut [u8; TEXT]) {
    let (first, pairs) = text[start..start + len].as_rchunks_mut::<2>();
    for pair in pairs.iter_mut().rev() {
        let two = (number % 100) as u8;
        *pair = [b'0' + two / 10, b'0' + two % 10];
        number /= 100;
    }
    first.iter_mut().for_each(|digit| *digit = b'0' + (number % 10) as u8);
}

/// A number rounded to decimal digits: d.ddd times ten to the power of the exponent, without zeros at the end.
struct Decimal {
    digits: [u8; 64],
    len: usize,
    exponent: i32,
}

impl Decimal {
    /// Rounds the size of a finite number to at most `most` significant digits, halves to the even digit.
    fn new(value: f64, most: usize) -> Option<Self> {
        if value == 0.0 {
            let mut zero = Self { digits: [0; 64], len: 1, exponent: 0 };
            zero.digits[0] = b'0';
            return Some(zero);
        }
        let mut decimal = None;
        if most <= DECIDED {
            decimal = Self::parse(zmij::Buffer::new().format_finite(value.abs()).as_bytes())?.rounded(most);
        }
        if decimal.is_none() {
            let mut text = Digits { bytes: [0; 64], len: 0 };
            write!(text, "{:.*e}", most - 1, value.abs()).ok()?;
            decimal = Self::parse(&text.bytes[..text.len]);
        }
        decimal
    }

    /// Digits and exponent of a positive number.
    fn parse(text: &[u8]) -> Option<Self> {
        let mut decimal = Self { digits: [0; 64], len: 0, exponent: 0 };
        // Places from the first digit to the point.
        let (mut whole, mut point, mut zeros) = (0, false, 0);
        for (i, &byte) in text.iter().enumerate() {
            match byte {
                b'.' => point = true,
                b'e' => {
                    decimal.exponent = std::str::from_utf8(&text[i + 1..]).ok()?.parse().ok()?;
                    break;
                }
                b'0' if decimal.len == 0 => zeros += i32::from(point),
                _ => {
                    *decimal.digits.get_mut(decimal.len)? = byte;
                    decimal.len += 1;
                    whole += i32::from(!point);
                }
            }
        }
        decimal.exponent += if whole > 0 { whole - 1 } else { -zeros - 1 };
        decimal.trim();
        Some(decimal)
    }

    fn trim(&mut self) {
        while self.len > 1 && self.digits[self.len - 1] == b'0' {
            self.len -= 1;
        }
    }

    /// The shortest digits of a number rounded to fewer of them. `None` if they do not decide.
    ///
    /// If rounding the number itself gave another result, a boundary of rounding would be between the number and its
    /// shortest digits. The boundary has one digit more than the result, so the shortest digits would not be longer.
    /// They are the boundary itself at most.
    fn rounded(mut self, most: usize) -> Option<Self> {
        if self.len <= most {
            return Some(self);
        }
        let up = self.digits[most] >= b'5';
        if self.digits[most] == b'5' && self.len == most + 1 {
            return None;
        }
        self.len = most;
        if up {
            let nines = self.digits[..most].iter().rev().take_while(|d| **d == b'9').count();
            match (most - nines).checked_sub(1) {
                Some(last) => {
                    self.digits[last] += 1;
                    self.len = last + 1;
                }
                None => {
                    (self.digits[0], self.len) = (b'1', 1);
                    self.exponent += 1;
                }
            }
        }
        self.trim();
        Some(self)
    }
}

/// At least two digits, as in C.
fn push_exponent(exponent: i32, out: &mut Vec<u8>) {
    let size = exponent.unsigned_abs();
    out.extend_from_slice(if exponent < 0 { b"e-" } else { b"e+" });
    let digit = |place: u32| b'0' + (size / place % 10) as u8;
    if size >= 100 {
        out.push(digit(100));
    }
    out.extend([digit(10), digit(1)]);
}

#[cfg(test)]
mod tests {
    use super::Style;

    fn g(value: f64, precision: usize) -> String {
        let mut s = String::new();
        Style { precision, scientific: false }.push(value, &mut s);
        s
    }

    #[test]
    fn like_c() {
        // printf of the C library.
        for (value, precision, text) in [
            (0.0, 6, "0"),
            (-0.0, 6, "-0"),
            (1.0, 6, "1"),
            (0.1, 6, "0.1"),
            (100000.0, 6, "100000"),
            (1e6, 6, "1e+06"),
            (1234567.0, 6, "1.23457e+06"),
            (0.0001, 6, "0.0001"),
            (0.00001, 6, "1e-05"),
            (-1.5e-300, 6, "-1.5e-300"),
            (123.456, 12, "123.456"),
            (1.0 / 3.0, 12, "0.333333333333"),
            (2.5, 1, "2"),
            (999999.5, 6, "1e+06"),
            (0.1, 17, "0.10000000000000001"),
            (f64::NAN, 6, "nan"),
            (f64::NEG_INFINITY, 6, "-inf"),
        ] {
            assert_eq!(g(value, precision), text);
        }
        for (value, text) in [(-12345.678, "-1.2346e+04"), (0.0, "0.0000e+00"), (2.5, "2.5000e+00")] {
            let mut s = String::new();
            Style { precision: 4, scientific: true }.push(value, &mut s);
            assert_eq!(s, text);
        }
    }

    /// Digits of the standard library, and those of numbers on and beside the boundaries of rounding.
    #[test]
    fn digits_are_rounded_exactly() {
        let mut bits = 0x9E37_79B9_7F4A_7C15u64;
        for i in 0..200_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let short = (bits >> 40) as f64 / 10f64.powi((i % 9) + 1);
            let value = match i % 3 {
                0 => f64::from_bits(bits),
                1 => short,
                _ => f64::from_bits((short + 5e-7).to_bits() + u64::from(i as u32 % 5) - 2),
            };
            if !value.is_finite() {
                continue;
            }
            for precision in [0, 3, 5, 9, 13, 15] {
                let mut s = String::new();
                Style { precision, scientific: true }.push(value, &mut s);
                let expected = format!("{value:.precision$e}");
                let (mantissa, exponent) = expected.split_once('e').expect("an exponent");
                let exponent: i32 = exponent.parse().expect("a number");
                let sign = if exponent < 0 { '-' } else { '+' };
                assert_eq!(s, format!("{mantissa}e{sign}{:02}", exponent.abs()), "{value:e} {precision}");
            }
        }
    }
}
