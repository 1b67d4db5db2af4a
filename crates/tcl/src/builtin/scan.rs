//! `scan`.

use nom::branch::alt;
use nom::bytes::complete::{tag, take_while1};
use nom::character::complete::{anychar, char};
use nom::combinator::opt;
use nom::sequence::terminated;
use nom::{IResult, Parser};
use num_bigint::BigInt;
use num_traits::{Num as _, ToPrimitive as _};

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::number;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("scan", scan)];

#[derive(Debug)]
enum Item {
    /// Any blanks, or none.
    Blanks,
    Literal(char),
    Field(Field),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Size {
    Wide,
    Big,
}

#[derive(Debug)]
struct Field {
    skip: bool,
    position: Option<usize>,
    width: usize,
    size: Size,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// Base; 0: by the prefix of the number.
    Integer(u32),
    Unsigned,
    Float,
    Text,
    Char,
    Count,
    Set {
        negated: bool,
        ranges: Vec<(char, char)>,
    },
}

fn digits(s: &str) -> IResult<&str, usize> {
    take_while1(|c: char| c.is_ascii_digit()).map(|d: &str| d.parse().unwrap_or(usize::MAX)).parse(s)
}

/// Specifier after a `%`.
struct Modifiers {
    skip: bool,
    position: Option<usize>,
    width: usize,
    size: Size,
    /// True if a size was given.
    sized: bool,
    conversion: char,
}

/// Specifier after a `%`, up to the conversion character.
fn modifiers(s: &str) -> IResult<&str, Modifiers> {
    let (s, star) = opt(char('*')).parse(s)?;
    let (s, position) = opt(terminated(digits, char('$'))).parse(s)?;
    let (s, width) = opt(digits).parse(s)?;
    let size = alt((
        tag("ll").map(|_| Size::Big),
        tag("L").map(|_| Size::Big),
        tag("l").map(|_| Size::Wide),
        tag("h").map(|_| Size::Wide),
    ));
    // `h` is taken and means nothing.
    let sized = s.starts_with(['l', 'L']);
    let (s, size) = opt(size).parse(s)?;
    // Where the format ends Tcl sees the byte that ends its strings.
    let (s, conversion) = opt(anychar).map(|c| c.unwrap_or('\0')).parse(s)?;
    let modifiers = Modifiers {
        skip: star.is_some(),
        position,
        width: width.unwrap_or(0),
        size: size.unwrap_or(Size::Wide),
        sized,
        conversion,
    };
    Ok((s, modifiers))
}

fn refuse(message: &str, code: &str) -> Exception {
    Exception::coded(message, &["TCL", "FORMAT", code])
}

fn set(s: &str) -> Result<(&str, Kind), Exception> {
    let unmatched = || refuse("unmatched [ in format string", "BRACKET");
    let (negated, mut s) = match s.strip_prefix('^') {
        Some(rest) => (true, rest),
        None => (false, s),
    };
    let mut ranges = vec![];
    let mut first = true;
    loop {
        let c = s.chars().next().ok_or_else(unmatched)?;
        s = &s[c.len_utf8()..];
        if c == ']' && !first {
            return Ok((s, Kind::Set { negated, ranges }));
        }
        first = false;
        let mut ahead = s.chars();
        match (ahead.next(), ahead.next()) {
            (Some('-'), Some(high)) if high != ']' => {
                ranges.push((c.min(high), c.max(high)));
                s = ahead.as_str();
            }
            _ => ranges.push((c, c)),
        }
    }
}

fn parse(format: &str) -> Result<Vec<Item>, Exception> {
    let mut items = vec![];
    let mut rest = format;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        if c.is_whitespace() {
            items.push(Item::Blanks);
            continue;
        }
        if c != '%' {
            items.push(Item::Literal(c));
            continue;
        }
        if let Some(after) = rest.strip_prefix('%') {
            items.push(Item::Literal('%'));
            rest = after;
            continue;
        }
        let Ok((after, Modifiers { skip, position, width, size, sized, conversion })) = modifiers(rest) else {
            return Err(refuse("bad scan conversion character \"\"", "BADTYPE"));
        };
        rest = after;
        if sized && matches!(conversion, 'c' | 's' | '[' | 'n') {
            let message = format!("field size modifier may not be specified in %{conversion} conversion");
            return Err(refuse(&message, "BADSIZE"));
        }
        let kind = match conversion {
            'd' => Kind::Integer(10),
            'i' => Kind::Integer(0),
            'o' => Kind::Integer(8),
            'x' | 'X' => Kind::Integer(16),
            'b' => Kind::Integer(2),
            'u' => Kind::Unsigned,
            'f' | 'e' | 'E' | 'g' | 'G' => Kind::Float,
            's' => Kind::Text,
            'c' if width > 0 => {
                return Err(refuse("field width may not be specified in %c conversion", "BADWIDTH"));
            }
            'c' => Kind::Char,
            'n' => Kind::Count,
            '[' => {
                let (after, kind) = set(rest)?;
                rest = after;
                kind
            }
            other => {
                return Err(refuse(&format!("bad scan conversion character \"{other}\""), "BADTYPE"));
            }
        };
        if matches!(kind, Kind::Unsigned) && size == Size::Big {
            return Err(refuse("unsigned bignum scans are invalid", "BADUNSIGNED"));
        }
        items.push(Item::Field(Field { skip, position, width, size, kind }));
    }
    Ok(items)
}

/// Check that fields and variables fit each other; gives for each field that is kept the place of its value.
fn places(items: &[Item], variables: usize) -> Result<(Vec<usize>, usize), Exception> {
    let fields: Vec<&Field> =
        items.iter().filter_map(|i| if let Item::Field(f) = i { Some(f) } else { None }).filter(|f| !f.skip).collect();
    let positional = fields.iter().filter(|f| f.position.is_some()).count();
    if positional > 0 && positional < fields.len() {
        return Err(refuse("cannot mix \"%\" and \"%n$\" conversion specifiers", "MIXEDSPECTYPES"));
    }
    if positional == 0 {
        let count = if variables == 0 { fields.len() } else { variables };
        if fields.len() > count {
            return Err(refuse("different numbers of variable names and field specifiers", "FIELDVARMISMATCH"));
        }
        if fields.len() < count {
            return Err(refuse("variable is not assigned by any conversion specifiers", "UNASSIGNED"));
        }
        return Ok(((0..fields.len()).collect(), count));
    }
    let mut seen = vec![];
    for field in &fields {
        let position = field.position.unwrap_or(0);
        if position == 0 || (variables > 0 && position > variables) || position > 10_000 {
            return Err(refuse("\"%n$\" argument index out of range", "INDEXRANGE"));
        }
        if seen.contains(&position) {
            return Err(refuse("variable is assigned by multiple \"%n$\" conversion specifiers", "POLYASSIGNED"));
        }
        seen.push(position);
    }
    let count = if variables == 0 { seen.iter().copied().max().unwrap_or(0) } else { variables };
    if variables > 0 && (1..=variables).any(|p| !seen.contains(&p)) {
        return Err(refuse("variable is not assigned by any conversion specifiers", "UNASSIGNED"));
    }
    Ok((seen.iter().map(|p| p - 1).collect(), count))
}

fn scan(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "scan string format ?varName ...?")?;
    let text = call.arg(1).as_str();
    let items = parse(&call.arg(2).as_str())?;
    let names = call.from(3);
    let (places, count) = places(&items, names.len())?;
    let mut values: Vec<Option<Value>> = vec![None; count];
    let mut places = places.into_iter();
    let mut rest: &str = &text;
    // Whether the text ended before the first conversion, and how many conversions were done.
    let mut ended = false;
    let mut done = 0;
    let mut any = false;
    for item in &items {
        match item {
            Item::Blanks => rest = rest.trim_start(),
            Item::Literal(c) => match rest.strip_prefix(*c) {
                Some(after) => rest = after,
                None => {
                    ended = rest.is_empty();
                    break;
                }
            },
            Item::Field(field) => {
                let place = if field.skip { None } else { places.next() };
                if let Kind::Count = field.kind {
                    if let Some(place) = place {
                        // Tcl counts bytes here.
                        let used = text.len() - rest.len();
                        values[place] = Some(Value::from(used));
                        done += 1;
                    }
                    continue;
                }
                if !matches!(field.kind, Kind::Char | Kind::Set { .. }) {
                    rest = rest.trim_start();
                }
                if rest.is_empty() {
                    ended = true;
                    break;
                }
                let Some((length, value)) = field.take(rest)? else {
                    // A sign alone is where a number ended too early.
                    let lone = match field.kind {
                        Kind::Float => matches!(rest, "-" | "+" | "."),
                        Kind::Set { .. } => false,
                        _ => matches!(rest, "-" | "+"),
                    };
                    ended = lone && field.width == 0;
                    break;
                };
                rest = &rest[length..];
                any = true;
                if let Some(place) = place {
                    values[place] = Some(value);
                    done += 1;
                }
            }
        }
    }
    if names.is_empty() {
        if ended && !any && done == 0 {
            return Ok(Value::EMPTY);
        }
        return Ok(Value::list(values.into_iter().map(Option::unwrap_or_default)));
    }
    for (name, value) in names.iter().zip(values) {
        if let Some(value) = value {
            let name = VarName::of(name);
            core.assign(&name, value)?;
        }
    }
    Ok(Value::from(if ended && !any && done == 0 { -1i64 } else { done }))
}

impl Field {
    /// Number of bytes that the field takes from the start of a text, and their value. None if nothing fits.
    fn take(&self, text: &str) -> Result<Option<(usize, Value)>, Exception> {
        let limited = match self.width {
            0 => text,
            width => text.char_indices().nth(width).map_or(text, |(at, _)| &text[..at]),
        };
        let upto = |length: usize| {
            if length == 0 { None } else { Some((length, Value::from(&limited[..length]))) }
        };
        Ok(match &self.kind {
            Kind::Text => upto(limited.find(char::is_whitespace).unwrap_or(limited.len())),
            Kind::Set { negated, ranges } => {
                let fits = |c: char| ranges.iter().any(|(low, high)| (*low..=*high).contains(&c)) != *negated;
                upto(limited.find(|c| !fits(c)).unwrap_or(limited.len()))
            }
            Kind::Char => limited.chars().next().map(|c| (c.len_utf8(), Value::from(i64::from(u32::from(c))))),
            Kind::Count => None,
            Kind::Float => float_length(limited).and_then(|length| {
                let number = limited[..length].parse::<f64>().ok()?;
                if number.is_nan() { None } else { Some((length, Value::from(number))) }
            }),
            Kind::Integer(base) => self.integer(limited, *base),
            Kind::Unsigned => self.integer(limited, 10).map(|(length, value)| {
                let value = match (value.to_i64(), self.size) {
                    (Ok(i), Size::Wide) if i < 0 => Value::from(BigInt::from(i as u64)),
                    _ => value,
                };
                (length, value)
            }),
        })
    }

    fn integer(&self, text: &str, base: u32) -> Option<(usize, Value)> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let negative = text.starts_with('-');
        let sign = text.len() - unsigned.len();
        let lower: String = unsigned.chars().take(2).collect::<String>().to_ascii_lowercase();
        let after_prefix = |base: u32| {
            let rest = unsigned.get(2..)?;
            rest.starts_with(|c: char| c.is_digit(base)).then_some(rest)
        };
        let (base, digits) = match (base, lower.as_str()) {
            (0 | 16, "0x") => (16, after_prefix(16).unwrap_or(unsigned)),
            (0, _) if unsigned.starts_with('0') => (8, unsigned),
            (0, _) => (10, unsigned),
            (base, _) => (base, unsigned),
        };
        let length = digits.find(|c: char| !c.is_digit(base)).unwrap_or(digits.len());
        if length == 0 {
            return None;
        }
        let size = BigInt::from_str_radix(&digits[..length], base).ok()?;
        let whole = if negative { -size } else { size };
        let used = sign + (unsigned.len() - digits.len()) + length;
        let value = match self.size {
            Size::Big => Value::from(whole),
            Size::Wide => Value::from(whole.to_i64().unwrap_or(if negative { i64::MIN } else { i64::MAX })),
        };
        Some((used, value))
    }
}

/// Length of the number that a float conversion takes.
fn float_length(text: &str) -> Option<usize> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let sign = text.len() - unsigned.len();
    let digits = |s: &str| s.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(unsigned);
    let mut length = whole;
    if unsigned[length..].starts_with('.') {
        let fraction = digits(&unsigned[length + 1..]);
        if whole + fraction == 0 {
            return None;
        }
        length += 1 + fraction;
    }
    if length == 0 {
        return match number::prefix(text) {
            Some((l, number::Number::Double(d))) if !d.is_finite() => Some(l),
            _ => None,
        };
    }
    if unsigned[length..].starts_with(['e', 'E']) {
        let rest = &unsigned[length + 1..];
        let exponent = rest.strip_prefix(['-', '+']).unwrap_or(rest);
        let count = digits(exponent);
        if count > 0 {
            length += 1 + (rest.len() - exponent.len()) + count;
        }
    }
    Some(sign + length)
}
