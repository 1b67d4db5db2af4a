//! Numbers as Tcl writes and reads them.

use std::borrow::Cow;
use std::fmt::{self, Write as _};
use std::rc::Rc;

use nom::branch::alt;
use nom::bytes::complete::{tag_no_case, take_while, take_while1};
use nom::character::complete::{char, one_of};
use nom::combinator::{opt, recognize};
use nom::sequence::{delimited, preceded};
use nom::{IResult, Parser};
use num_bigint::{BigInt, Sign};
use num_traits::{Num as _, ToPrimitive};

/// A number of any of Tcl's kinds.
#[derive(Clone, Debug)]
pub(crate) enum Number {
    Int(i64),
    Big(Rc<BigInt>),
    Double(f64),
}

impl Number {
    pub(crate) fn to_f64(&self) -> f64 {
        match self {
            Number::Int(i) => *i as f64,
            Number::Big(b) => big_to_f64(b),
            Number::Double(d) => *d,
        }
    }
}

/// A double by its bits: with nothing but integers and pointers in it, a value is passed in registers, which makes loops
/// a third faster.
#[derive(Clone, Copy)]
pub(crate) struct Bits(u64);

impl From<f64> for Bits {
    #[inline]
    fn from(d: f64) -> Self {
        Bits(d.to_bits())
    }
}

impl fmt::Debug for Bits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.get().fmt(f)
    }
}

impl Bits {
    #[inline]
    pub(crate) fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// Nearest double, infinite where the integer is out of range.
pub(crate) fn big_to_f64(big: &BigInt) -> f64 {
    big.to_f64().unwrap_or(if big.sign() == Sign::Minus { f64::NEG_INFINITY } else { f64::INFINITY })
}

/// Blank for Tcl's number and list parsers.
pub(crate) fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c)
}

/// Without the blanks around.
pub(crate) fn trim(text: &str) -> &str {
    text.trim_matches(|c: char| c.is_ascii() && is_space(c as u8))
}

fn digits(s: &str) -> IResult<&str, &str> {
    take_while1(|c: char| c.is_ascii_digit()).parse(s)
}

/// `12.`, `12.5`, `.5`, `1e5`, `1.e-5`: what is a double by its form.
fn decimal(s: &str) -> IResult<&str, &str> {
    let exponent = |s| recognize((one_of("eE"), opt(one_of("+-")), digits)).parse(s);
    let more = |s| take_while(|c: char| c.is_ascii_digit()).parse(s);
    alt((
        recognize((digits, char('.'), more, opt(exponent))),
        recognize((char('.'), digits, opt(exponent))),
        recognize((digits, exponent)),
    ))
    .parse(s)
}

/// `0x1f`, `0o17`, `0b101`: base and digits.
fn prefixed(s: &str) -> IResult<&str, (u32, &str)> {
    let (rest, base) = preceded(char('0'), one_of("xXoObB")).parse(s)?;
    let base = match base {
        'x' | 'X' => 16,
        'o' | 'O' => 8,
        _ => 2,
    };
    let (rest, digits) = take_while1(|c: char| c.is_digit(base)).parse(rest)?;
    Ok((rest, (base, digits)))
}

fn special(s: &str) -> IResult<&str, f64> {
    let nan_bits = delimited(char('('), take_while1(|c: char| c.is_ascii_hexdigit()), char(')'));
    alt((
        alt((tag_no_case("infinity"), tag_no_case("inf"))).map(|_| f64::INFINITY),
        (tag_no_case("nan"), opt(nan_bits)).map(|_| f64::NAN),
    ))
    .parse(s)
}

fn integer(negative: bool, base: u32, digits: &str) -> Number {
    match i64::from_str_radix(digits, base) {
        Ok(i) => Number::Int(if negative { -i } else { i }),
        Err(_) => {
            let big = BigInt::from_str_radix(digits, base).unwrap_or_default();
            from_big(if negative { -big } else { big })
        }
    }
}

/// As small a kind as holds it.
pub(crate) fn from_big(big: BigInt) -> Number {
    match big.to_i64() {
        Some(i) => Number::Int(i),
        None => Number::Big(Rc::new(big)),
    }
}

/// The longest number at the start of a text, without leading blanks: its length in bytes and its value.
pub(crate) fn prefix(text: &str) -> Option<(usize, Number)> {
    let negative = text.starts_with('-');
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let length = |rest: &str| text.len() - rest.len();
    let double = |d: f64| Number::Double(if negative { -d } else { d });
    let first = unsigned.bytes().next()?;
    if !first.is_ascii_digit() && first != b'.' {
        return special(unsigned).ok().map(|(rest, d)| (length(rest), double(d)));
    }
    if let Ok((rest, (base, digits))) = prefixed(unsigned) {
        return Some((length(rest), integer(negative, base, digits)));
    }
    if let Ok((rest, form)) = decimal(unsigned) {
        return Some((length(rest), double(form.parse().ok()?)));
    }
    let (rest, all) = digits(unsigned).ok()?;
    if all.len() == 1 || !all.starts_with('0') {
        return Some((length(rest), integer(negative, 10, all)));
    }
    // A leading zero means octal; the number ends before the first digit that is none.
    let octal = all.bytes().take_while(|b| (b'0'..=b'7').contains(b)).count();
    Some((length(rest) - (all.len() - octal), integer(negative, 8, &all[..octal])))
}

/// A text that is one number, blanks around it allowed.
pub(crate) fn parse(text: &str) -> Option<Number> {
    let text = trim(text);
    if let Some(i) = plain_int(text) {
        return Some(Number::Int(i));
    }
    match prefix(text)? {
        (length, number) if length == text.len() => Some(number),
        _ => None,
    }
}

/// The integer of a text that is written exactly as Tcl would write that integer.
pub(crate) fn plain_int(text: &str) -> Option<i64> {
    let bytes = text.as_bytes();
    let (negative, digits) = match bytes {
        [b'-', rest @ ..] => (true, rest),
        _ => (false, bytes),
    };
    match digits {
        [b'0'] if !negative => return Some(0),
        [b'1'..=b'9', ..] if digits.len() <= 18 => {}
        _ => return None,
    }
    let mut value = 0i64;
    for &b in digits {
        if !b.is_ascii_digit() {
            return None;
        }
        value = value * 10 + i64::from(b - b'0');
    }
    Some(if negative { -value } else { value })
}

/// A text that should have been a number but has a digit 8 or 9 after a leading zero.
pub(crate) fn looks_like_bad_octal(text: &str) -> bool {
    let text = trim(text);
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    // Tcl also accepts the 0o prefix here.
    let digits = match unsigned.as_bytes() {
        [b'0', b'o' | b'O', rest @ ..] => rest,
        [b'0', rest @ ..] => rest,
        _ => return false,
    };
    !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) && digits.iter().any(|b| *b >= b'8')
}

/// The shortest text that reads back as the same double.
pub(crate) fn write_double(out: &mut String, d: f64) {
    let size = d.abs();
    if (1e-4..1e17).contains(&size) {
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(d);
        if !text.as_bytes().contains(&b'e') {
            out.push_str(text);
            return;
        }
        let start = out.len();
        let _ = write!(out, "{d}");
        if !out.as_bytes()[start..].contains(&b'.') {
            out.push_str(".0");
        }
    } else if !write_special(out, d) {
        if d == 0.0 {
            out.push_str(if d.is_sign_negative() { "-0.0" } else { "0.0" });
        } else {
            let mut buffer = zmij::Buffer::new();
            let text = buffer.format_finite(d);
            // Sizes from 1e-5 have no exponent there.
            let form = if text.as_bytes().contains(&b'e') { Cow::Borrowed(text) } else { format!("{d:e}").into() };
            let sign = form.bytes().position(|b| b == b'e').map_or(0, |e| e + 1);
            out.push_str(&form[..sign]);
            if !matches!(form.as_bytes().get(sign), Some(b'-' | b'+')) {
                out.push('+');
            }
            out.push_str(&form[sign..]);
        }
    }
}

fn write_special(out: &mut String, d: f64) -> bool {
    match () {
        () if d.is_nan() => out.push_str("NaN"),
        () if d.is_infinite() => out.push_str(if d > 0.0 { "Inf" } else { "-Inf" }),
        () => return false,
    }
    true
}

/// With at most `precision` significant digits, as with `tcl_precision` set.
pub(crate) fn write_double_rounded(out: &mut String, d: f64, precision: usize) {
    if write_special(out, d) {
        return;
    }
    let form = format!("{:.*e}", precision.max(1) - 1, d);
    let Some((mantissa, exponent)) = form.split_once('e') else { return };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", mantissa),
    };
    let mut digits: String = mantissa.chars().filter(|c| *c != '.').collect();
    let kept = digits.trim_end_matches('0').len().max(1);
    digits.truncate(kept);
    out.push_str(sign);
    if d == 0.0 {
        out.push_str("0.0");
    } else if !(-4..=16).contains(&exponent) {
        out.push_str(&digits[..1]);
        if digits.len() > 1 {
            out.push('.');
            out.push_str(&digits[1..]);
        }
        let _ = write!(out, "e{}{:02}", if exponent < 0 { '-' } else { '+' }, exponent.abs());
    } else if exponent < 0 {
        out.push_str("0.");
        out.extend(std::iter::repeat_n('0', (-exponent - 1) as usize));
        out.push_str(&digits);
    } else {
        let whole = exponent as usize + 1;
        if digits.len() <= whole {
            out.push_str(&digits);
            out.extend(std::iter::repeat_n('0', whole - digits.len()));
            out.push_str(".0");
        } else {
            out.push_str(&digits[..whole]);
            out.push('.');
            out.push_str(&digits[whole..]);
        }
    }
}

/// Boolean words, any unambiguous abbreviation of them, in any case.
pub(crate) fn boolean_word(text: &str) -> Option<bool> {
    let lower = text.to_ascii_lowercase();
    let is = |word: &str, least: usize| lower.len() >= least && word.starts_with(&lower);
    match () {
        () if lower.is_empty() => None,
        () if is("yes", 1) || is("true", 1) || is("on", 2) => Some(true),
        () if is("no", 1) || is("false", 1) || is("off", 2) => Some(false),
        () => None,
    }
}
