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
        let precision = self.precision.min(40);
        let digits = if self.scientific { precision } else { precision.max(1) - 1 };
        let mut text = Digits { bytes: [0; 64], len: 0 };
        if write!(text, "{value:.digits$e}").is_err() {
            return;
        }
        let text = std::str::from_utf8(&text.bytes[..text.len]).unwrap_or("");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let exponent: i32 = exponent.parse().unwrap_or(0);
        if self.scientific {
            out.extend_from_slice(mantissa.as_bytes());
            push_exponent(exponent, out);
            return;
        }
        let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |m| ("-", m));
        let all = mantissa.bytes().filter(|b| *b != b'.');
        // Trailing zeros are not written.
        let kept = digits + 1 - mantissa.bytes().rev().filter(|b| *b != b'.').take_while(|b| *b == b'0').count();
        let kept = kept.max(1);
        out.extend_from_slice(sign.as_bytes());
        if exponent < -4 || exponent > digits as i32 {
            for (i, d) in all.take(kept).enumerate() {
                if i == 1 {
                    out.push(b'.');
                }
                out.push(d);
            }
            push_exponent(exponent, out);
        } else if exponent < 0 {
            out.extend_from_slice(b"0.");
            (1..-exponent).for_each(|_| out.push(b'0'));
            all.take(kept).for_each(|d| out.push(d));
        } else {
            let whole = exponent as usize + 1;
            for (i, d) in all.take(kept.max(whole)).enumerate() {
                if i == whole {
                    out.push(b'.');
                }
                out.push(d);
            }
        }
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
        let mut s = String::new();
        Style { precision: 4, scientific: true }.push(-12345.678, &mut s);
        assert_eq!(s, "-1.2346e+04");
    }
}
