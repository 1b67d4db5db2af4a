//! `format`.

use nom::branch::alt;
use nom::bytes::complete::{tag, take_while, take_while1};
use nom::character::complete::{anychar, char};
use nom::combinator::opt;
use nom::sequence::{preceded, terminated};
use nom::{IResult, Parser};
use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive as _};

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::expr::arith::big;
use crate::number::Number;
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("format", format_command)];

/// Fields wider than this are refused: nobody wants gigabytes of blanks.
const MAX_WIDTH: i64 = 1 << 28;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Amount {
    Star,
    Number(i64),
}

/// One `%` specifier.
#[derive(Debug)]
struct Spec {
    position: Option<usize>,
    left: bool,
    plus: bool,
    space: bool,
    zero: bool,
    alternate: bool,
    width: Option<Amount>,
    precision: Option<Amount>,
    size: Size,
    conversion: char,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Size {
    Short,
    Wide,
    Big,
}

fn number(s: &str) -> IResult<&str, i64> {
    take_while1(|c: char| c.is_ascii_digit()).map(|d: &str| d.parse().unwrap_or(i64::MAX)).parse(s)
}

/// Specifier after a `%`.
fn spec(s: &str) -> IResult<&str, Spec> {
    let amount = |s| alt((char('*').map(|_| Amount::Star), number.map(Amount::Number))).parse(s);
    let (s, position) = opt(terminated(number, char('$'))).parse(s)?;
    let (s, flags) = take_while(|c| matches!(c, '-' | '+' | ' ' | '0' | '#')).parse(s)?;
    let (s, width) = opt(amount).parse(s)?;
    let (s, precision) = opt(preceded(char('.'), opt(amount))).parse(s)?;
    let size = alt((tag("ll").map(|_| Size::Big), tag("l").map(|_| Size::Wide), tag("h").map(|_| Size::Short)));
    let (s, size) = opt(size).parse(s)?;
    let (s, conversion) = opt(anychar).parse(s)?;
    let has = |flag: char| flags.contains(flag);
    let spec = Spec {
        position: position.map(|p| usize::try_from(p).unwrap_or(usize::MAX)),
        left: has('-'),
        plus: has('+'),
        space: has(' '),
        zero: has('0'),
        alternate: has('#'),
        width,
        precision: precision.map(|p| p.unwrap_or(Amount::Number(0))),
        size: size.unwrap_or(Size::Wide),
        conversion: conversion.unwrap_or('\0'),
    };
    Ok((s, spec))
}

fn refuse(message: &str, code: &str) -> Exception {
    Exception::coded(message, &["TCL", "FORMAT", code])
}

fn incomplete() -> Exception {
    refuse("format string ended in middle of field specifier", "INCOMPLETE")
}

fn format_command(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "format formatString ?arg ...?")?;
    format(&call.arg(1).as_str(), call.from(2)).map(Value::from)
}

/// Write values by a format.
fn format(template: &str, args: &[Value]) -> Result<String, Exception> {
    let mut out = String::with_capacity(template.len() + 16);
    let mut rest = template;
    let mut next = 0;
    let mut positional: Option<bool> = None;
    while let Some(at) = rest.find('%') {
        out.push_str(&rest[..at]);
        rest = &rest[at + 1..];
        if let Some(after) = rest.strip_prefix('%') {
            out.push('%');
            rest = after;
            continue;
        }
        let Ok((after, spec)) = spec(rest) else {
            return Err(incomplete());
        };
        rest = after;
        let by_position = spec.position.is_some();
        if positional.is_some_and(|p| p != by_position) {
            return Err(refuse("cannot mix \"%\" and \"%n$\" conversion specifiers", "MIXEDSPECTYPES"));
        }
        positional = Some(by_position);
        if let Some(position) = spec.position {
            next = position.wrapping_sub(1);
        }
        let missing = || {
            if by_position {
                refuse("\"%n$\" argument index out of range", "INDEXRANGE")
            } else {
                refuse("not enough arguments for all format specifiers", "FIELDVARMISMATCH")
            }
        };
        let mut take = || {
            let value = args.get(next).ok_or_else(missing)?;
            next += 1;
            Ok::<(&Value, bool), Exception>((value, next < args.len()))
        };
        let mut amount = |amount: Option<Amount>| match amount {
            None => Ok(None),
            Some(Amount::Number(n)) => Ok(Some(n)),
            Some(Amount::Star) => match take()? {
                // The value itself must follow.
                (_, false) => Err(missing()),
                (value, true) => Ok::<_, Exception>(Some(value.to_int()?)),
            },
        };
        let width = amount(spec.width)?.unwrap_or(0);
        let precision = amount(spec.precision)?.map(|p| p.max(0));
        if width.abs() > MAX_WIDTH || precision.is_some_and(|p| p > MAX_WIDTH) {
            return Err(refuse("max size for a Tcl value (2147483647 bytes) exceeded", "TOOLONG"));
        }
        let field = Field {
            left: spec.left || width < 0,
            width: width.unsigned_abs() as usize,
            precision: precision.map(|p| p as usize),
            spec: &spec,
        };
        let (value, _) = take()?;
        if spec.conversion == '\0' {
            return Err(incomplete());
        }
        if !"diuoxXbcsfeEgG".contains(spec.conversion) {
            let message = format!("bad field specifier \"{}\"", spec.conversion);
            return Err(refuse(&message, "BADTYPE"));
        }
        if spec.conversion == 'u' && spec.size == Size::Big {
            return Err(refuse("unsigned bignum format is invalid", "BADUNSIGNED"));
        }
        field.write(value, &mut out)?;
    }
    out.push_str(rest);
    Ok(out)
}

struct Field<'a> {
    spec: &'a Spec,
    left: bool,
    width: usize,
    precision: Option<usize>,
}

impl Field<'_> {
    fn write(&self, value: &Value, out: &mut String) -> Result<(), Exception> {
        match self.spec.conversion {
            's' => {
                let text = value.as_str();
                match self.precision {
                    Some(p) => self.pad("", &text.chars().take(p).collect::<String>(), self.spec.zero, out),
                    None => self.pad("", &text, self.spec.zero, out),
                }
            }
            'c' => {
                let code = value.to_int()?;
                let c = char::from_u32(code as u32).unwrap_or(char::REPLACEMENT_CHARACTER);
                self.pad("", c.encode_utf8(&mut [0; 4]), self.spec.zero, out);
            }
            'd' | 'i' | 'u' | 'o' | 'x' | 'X' | 'b' => self.integer(value, out)?,
            _ => self.float(value.to_f64()?, out),
        }
        Ok(())
    }

    /// Fill up to the width, between the sign and the digits if with zeros.
    fn pad(&self, sign: &str, body: &str, zeros: bool, out: &mut String) {
        let length = sign.chars().count() + body.chars().count();
        let fill = self.width.saturating_sub(length);
        let fill_with = |c: char| std::iter::repeat_n(c, fill);
        if zeros && self.left && matches!(self.spec.conversion, 's' | 'c') {
            // Tcl fills texts with zeros on either side.
            out.push_str(body);
            out.extend(fill_with('0'));
            return;
        }
        if zeros {
            out.push_str(sign);
            out.extend(fill_with('0'));
            out.push_str(body);
        } else if self.left {
            out.push_str(sign);
            out.push_str(body);
            out.extend(fill_with(' '));
        } else {
            out.extend(fill_with(' '));
            out.push_str(sign);
            out.push_str(body);
        }
    }

    fn integer(&self, value: &Value, out: &mut String) -> Result<(), Exception> {
        let spec = self.spec;
        let signed = matches!(spec.conversion, 'd' | 'i');
        let number = value.to_integer()?;
        let whole = big(&number);
        // Narrow to the size that is asked for, as C does.
        let low = || {
            let mask = BigInt::from(u64::MAX);
            (&whole & mask).to_u64().unwrap_or_default()
        };
        let (negative, digits): (bool, String) = match spec.size {
            Size::Big => (whole.is_negative(), self.digits(&Number::Big(whole.abs().into()))),
            size => {
                let bits = match size {
                    Size::Short => low() as u16 as i16 as i64,
                    _ => low() as i64,
                };
                if signed {
                    (bits < 0, bits.unsigned_abs().to_string())
                } else {
                    let unsigned = match size {
                        Size::Short => bits as u16 as u64,
                        _ => bits as u64,
                    };
                    (false, self.digits(&Number::Big(BigInt::from(unsigned).into())))
                }
            }
        };
        let mut digits = digits;
        let is_zero = digits == "0";
        if spec.alternate && spec.conversion == 'o' && !is_zero {
            digits.insert(0, '0');
        }
        if let Some(precision) = self.precision {
            let missing = precision.saturating_sub(digits.len());
            digits.insert_str(0, &"0".repeat(missing));
        }
        let mut sign = String::new();
        if signed || spec.size == Size::Big {
            sign.push_str(match (negative, spec.plus, spec.space) {
                (true, _, _) => "-",
                (_, true, _) => "+",
                (_, _, true) => " ",
                _ => "",
            });
        }
        if spec.alternate && !is_zero {
            sign.push_str(match spec.conversion {
                'x' => "0x",
                'X' => "0X",
                'b' => "0b",
                _ => "",
            });
        }
        self.pad(&sign, &digits, spec.zero && self.precision.is_none(), out);
        Ok(())
    }

    fn digits(&self, n: &Number) -> String {
        let n = big(n);
        match self.spec.conversion {
            'o' => format!("{n:o}"),
            'x' => format!("{n:x}"),
            'X' => format!("{n:X}"),
            'b' => format!("{n:b}"),
            _ => n.to_string(),
        }
    }

    fn float(&self, d: f64, out: &mut String) {
        let spec = self.spec;
        let sign = match (d.is_sign_negative() && !d.is_nan(), spec.plus, spec.space) {
            (true, _, _) => "-",
            (_, true, _) => "+",
            (_, _, true) => " ",
            _ => "",
        };
        let size = d.abs();
        let upper = spec.conversion.is_ascii_uppercase();
        if !size.is_finite() {
            let text = if size.is_nan() { "nan" } else { "inf" };
            let text = if upper { text.to_uppercase() } else { text.to_owned() };
            self.pad(sign, &text, false, out);
            return;
        }
        let mut text = match spec.conversion {
            'f' => fixed(size, self.precision.unwrap_or(6), spec.alternate),
            'e' | 'E' => exponential(size, self.precision.unwrap_or(6), spec.alternate),
            _ => general(size, self.precision.unwrap_or(6).max(1), spec.alternate),
        };
        if upper {
            text = text.to_uppercase();
        }
        self.pad(sign, &text, spec.zero && !self.left, out);
    }
}

/// Powers of ten below which numbers of 53 bits times the power fit 128 bits.
const TENS: [u64; 16] = [
    1,
    10,
    100,
    1_000,
    10_000,
    100_000,
    1_000_000,
    10_000_000,
    100_000_000,
    1_000_000_000,
    10_000_000_000,
    100_000_000_000,
    1_000_000_000_000,
    10_000_000_000_000,
    100_000_000_000_000,
    1_000_000_000_000_000,
];

/// The size of a number times a power of ten, rounded to an integer, halves to even. `None` where it needs more than 64
/// bits.
fn scaled(d: f64, power: u64) -> Option<u64> {
    const FRACTION: u32 = 52;
    let (bits, bias) = (d.to_bits() & !(1 << 63), 1075);
    let exponent = (bits >> FRACTION) as i32;
    let fraction = bits & ((1 << FRACTION) - 1);
    if exponent == 0 {
        return (fraction == 0).then_some(0);
    }
    // d = mantissa / 2^shift.
    let (mantissa, shift) = (fraction | 1 << FRACTION, bias - exponent);
    let product = u128::from(mantissa) * u128::from(power);
    let rounded = match shift {
        ..=-12 => return None,
        ..=0 => product << -shift,
        1..=120 => {
            let (whole, rest, half) = (product >> shift, product & ((1 << shift) - 1), 1 << (shift - 1));
            whole + u128::from(rest > half || (rest == half && whole & 1 == 1))
        }
        _ => 0,
    };
    u64::try_from(rounded).ok()
}

fn fixed(d: f64, precision: usize, point: bool) -> String {
    let mut text = match TENS.get(precision).and_then(|power| Some((power, scaled(d, *power)?))) {
        Some((power, number)) if precision > 0 => format!("{}.{:0precision$}", number / power, number % power),
        _ => format!("{d:.precision$}"),
    };
    if point && precision == 0 {
        text.push('.');
    }
    text
}

fn exponential(d: f64, precision: usize, point: bool) -> String {
    let text = format!("{d:.precision$e}");
    let Some((mantissa, exponent)) = text.split_once('e') else { return text };
    let point = if point && precision == 0 { "." } else { "" };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    format!("{mantissa}{point}e{}{:02}", if exponent < 0 { '-' } else { '+' }, exponent.abs())
}

fn general(d: f64, precision: usize, keep_zeros: bool) -> String {
    let most = precision - 1;
    let text = format!("{d:.most$e}");
    let exponent: i64 = text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let text = if exponent < -4 || exponent >= precision as i64 {
        exponential(d, most, keep_zeros)
    } else {
        fixed(d, (most as i64 - exponent).max(0) as usize, keep_zeros)
    };
    if keep_zeros || !text.contains('.') {
        return text;
    }
    let (number, exponent) = match text.split_once('e') {
        Some((n, e)) => (n, format!("e{e}")),
        None => (text.as_str(), String::new()),
    };
    let number = number.trim_end_matches('0').trim_end_matches('.');
    format!("{number}{exponent}")
}

#[cfg(test)]
mod tests {
    use super::fixed;

    /// Text of the standard library, for numbers on and beside the boundaries of rounding.
    #[test]
    fn fixed_digits_are_rounded_exactly() {
        let mut bits = 0x9E37_79B9_7F4A_7C15u64;
        for i in 0..100_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let short = (bits >> 40) as f64 / [1.0, 8.0, 1e3, 1e6, 1e12][i % 5];
            let value = match i % 3 {
                0 => f64::from_bits(bits >> 1),
                1 => short,
                _ => f64::from_bits(short.to_bits() + i as u64 % 5),
            };
            if value.is_finite() && value < 1e30 {
                for precision in [0, 1, 2, 4, 6, 12, 15, 17] {
                    assert_eq!(fixed(value, precision, false), format!("{value:.precision$}"), "{value:e} {precision}");
                }
            }
        }
    }
}
