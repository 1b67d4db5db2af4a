//! Numbers with as many digits as their uncertainty supports.

/// A number with this many significant digits.
pub fn significant(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    decimals(x, digits as i32 - 1 - exponent(x))
}

/// A number whose last digit is the second significant one of `half_width`: 10987.3 with 35.2 is 10987, and 0.204955 with
/// 0.00226 is 0.2050. Without a half width it has six significant digits.
pub fn with_half_width(x: f64, half_width: f64) -> String {
    if half_width > 0.0 && half_width.is_finite() { decimals(x, 1 - exponent(half_width)) } else { significant(x, 6) }
}

/// Decimal exponent of the leading digit after rounding to two digits: that of 0.0996 is -1, as it becomes 0.10.
fn exponent(x: f64) -> i32 {
    let text = format!("{:.1e}", x.abs());
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// A number rounded to a number of decimals, which is negative for tens, hundreds and so on. Very small and very large
/// numbers have an exponent.
fn decimals(x: f64, decimals: i32) -> String {
    let size = if x == 0.0 { 0 } else { exponent(x) };
    if !(-5..=9).contains(&size) {
        return format!("{:.*e}", (decimals + size).clamp(0, 15) as usize, x);
    }
    if decimals >= 0 {
        return format!("{x:.*}", decimals.min(17) as usize);
    }
    let unit = 10f64.powi(-decimals);
    format!("{:.0}", (x / unit).round() * unit)
}

#[cfg(test)]
mod tests {
    use super::{significant, with_half_width};

    #[test]
    fn digits_follow_the_half_width() {
        for (x, half_width, shown) in [
            (10987.2, 35.2, "10987"),
            (10987.2, 352.0, "10990"),
            (0.204_955, 0.002_26, "0.2050"),
            (2.620_111, 0.030_3, "2.620"),
            (2.620_111, 0.099_6, "2.62"),
            (1.234_4e-9, 2.1e-11, "1.234e-9"),
            (0.0, 0.5, "0.00"),
            (5.0, 0.0, "5.00000"),
        ] {
            assert_eq!(with_half_width(x, half_width), shown, "{x} {half_width}");
        }
        assert_eq!(significant(0.000_124_66, 4), "0.0001247");
        assert_eq!(significant(123_456.0, 2), "120000");
    }
}
