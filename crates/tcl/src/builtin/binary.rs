//! `binary format` and `binary scan`. Bytes are characters up to 255.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("binary", |core, call| dispatch(core, call, SUBS))];

const SUBS: &[(&str, CoreFn)] = &[("decode", decode), ("encode", encode), ("format", format), ("scan", scan)];

/// More than this at once is refused.
const MAX_BYTES: usize = 1 << 28;

/// Number of items.
#[derive(Clone, Copy, PartialEq)]
enum Count {
    One,
    Number(usize),
    All,
}

/// The fields of a format: letter, whether unsigned, count.
fn fields(text: &str) -> Result<Vec<(char, bool, Count)>, Exception> {
    let mut fields = vec![];
    let mut chars = text.chars().peekable();
    while let Some(letter) = chars.next() {
        if letter.is_whitespace() {
            continue;
        }
        let unsigned = chars.next_if_eq(&'u').is_some();
        let mut digits = String::new();
        while let Some(d) = chars.next_if(char::is_ascii_digit) {
            digits.push(d);
        }
        let count = match digits.parse::<usize>() {
            Ok(n) if n > MAX_BYTES => return Err(Exception::error("too large a count in binary format")),
            Ok(n) => Count::Number(n),
            Err(_) if chars.next_if_eq(&'*').is_some() => Count::All,
            Err(_) => Count::One,
        };
        fields.push((letter, unsigned, count));
    }
    Ok(fields)
}

fn bytes_of(value: &Value) -> Vec<u8> {
    value.as_str().chars().map(|c| c as u32 as u8).collect()
}

fn to_value(bytes: &[u8]) -> Value {
    Value::from(bytes.iter().map(|b| *b as char).collect::<String>())
}

/// Size of a number field, and whether its first byte is the greatest; none for other fields.
fn number_field(letter: char) -> Option<(usize, bool, bool)> {
    let native = cfg!(target_endian = "big");
    Some(match letter {
        'c' => (1, false, false),
        's' => (2, false, false),
        'S' => (2, true, false),
        't' => (2, native, false),
        'i' => (4, false, false),
        'I' => (4, true, false),
        'n' => (4, native, false),
        'w' => (8, false, false),
        'W' => (8, true, false),
        'm' => (8, native, false),
        'r' => (4, false, true),
        'R' => (4, true, true),
        'f' => (4, native, true),
        'q' => (8, false, true),
        'Q' => (8, true, true),
        'd' => (8, native, true),
        _ => return None,
    })
}

fn bad_field(letter: char) -> Exception {
    Exception::error(format!("bad field specifier \"{letter}\""))
}

fn format(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "binary format formatString ?arg ...?")?;
    let mut out: Vec<u8> = vec![];
    let mut at = 0;
    let mut args = call.from(3).iter();
    let put = |out: &mut Vec<u8>, at: &mut usize, bytes: &[u8]| {
        if out.len() < *at + bytes.len() {
            out.resize(*at + bytes.len(), 0);
        }
        out[*at..*at + bytes.len()].copy_from_slice(bytes);
        *at += bytes.len();
    };
    for (letter, _, count) in fields(&call.arg(2).as_str())? {
        let number = match count {
            Count::Number(n) => n,
            _ => 1,
        };
        match letter {
            'x' if count == Count::All => {
                return Err(Exception::error("cannot use \"*\" in format string with \"x\""));
            }
            'x' => {
                put(&mut out, &mut at, &vec![0; number]);
                continue;
            }
            'X' => {
                at = if count == Count::All { 0 } else { at.saturating_sub(number) };
                continue;
            }
            '@' => {
                at = match count {
                    Count::All => out.len(),
                    _ => number,
                };
                if out.len() < at {
                    out.resize(at, 0);
                }
                continue;
            }
            _ => {}
        }
        let missing = || Exception::error("not enough arguments for all format specifiers");
        if !"aAbBhH".contains(letter) && number_field(letter).is_none() {
            return Err(bad_field(letter));
        }
        let value = args.next().ok_or_else(missing)?;
        match letter {
            'a' | 'A' => {
                let mut bytes = bytes_of(value);
                if count != Count::All {
                    bytes.resize(number, if letter == 'a' { 0 } else { b' ' });
                }
                put(&mut out, &mut at, &bytes);
            }
            'b' | 'B' | 'h' | 'H' => {
                let bytes = pack(letter, value, if count == Count::All { None } else { Some(number) })?;
                put(&mut out, &mut at, &bytes);
            }
            _ => {
                let (size, big, float) = number_field(letter).ok_or_else(|| bad_field(letter))?;
                let items = match count {
                    Count::One => vec![value.clone()],
                    _ => {
                        let list = value.to_list()?;
                        let wanted = if count == Count::All { list.len() } else { number };
                        if list.len() < wanted {
                            return Err(Exception::error("number of elements in list does not match count"));
                        }
                        list[..wanted].to_vec()
                    }
                };
                for item in items {
                    let raw = if !float {
                        item.to_wide()?.to_le_bytes()
                    } else if size == 4 {
                        let single = (item.to_f64()? as f32).to_le_bytes();
                        let [a, b, c, d] = single;
                        [a, b, c, d, 0, 0, 0, 0]
                    } else {
                        item.to_f64()?.to_le_bytes()
                    };
                    let mut bytes = raw[..size].to_vec();
                    if big {
                        bytes.reverse();
                    }
                    put(&mut out, &mut at, &bytes);
                }
            }
        }
        if out.len() > MAX_BYTES {
            return Err(Exception::error("binary string is too long"));
        }
    }
    Ok(to_value(&out))
}

/// Digits of base 2 or 16 as bytes; capital letters put the first digit highest.
fn pack(letter: char, value: &Value, count: Option<usize>) -> Result<Vec<u8>, Exception> {
    let hex = matches!(letter, 'h' | 'H');
    let (base, per_byte, bits) = if hex { (16, 2, 4) } else { (2, 8, 1) };
    let text = value.as_str();
    let count = count.unwrap_or_else(|| text.chars().count());
    let mut bytes = vec![0u8; count.div_ceil(per_byte)];
    for (i, c) in text.chars().take(count).enumerate() {
        let Some(digit) = c.to_digit(base) else {
            let what = if hex { "hexadecimal" } else { "binary" };
            let message = format!("expected {what} string but got \"{text}\" instead");
            return Err(Exception::error(message));
        };
        let place = i % per_byte;
        let shift = if letter.is_uppercase() { per_byte - 1 - place } else { place } * bits;
        bytes[i / per_byte] |= (digit as u8) << shift;
    }
    Ok(bytes)
}

fn unpack(letter: char, bytes: &[u8], count: usize) -> String {
    let hex = matches!(letter, 'h' | 'H');
    let (per_byte, bits, mask) = if hex { (2, 4, 15) } else { (8, 1, 1) };
    let digit = |i: usize| {
        let place = i % per_byte;
        let shift = if letter.is_uppercase() { per_byte - 1 - place } else { place } * bits;
        let byte = bytes.get(i / per_byte).copied().unwrap_or(0);
        char::from_digit(u32::from(byte >> shift & mask), 16).unwrap_or('0')
    };
    (0..count).map(digit).collect()
}

fn scan(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "binary scan value formatString ?varName ...?")?;
    let bytes = bytes_of(call.arg(2));
    let mut at = 0;
    let mut names = call.from(4).iter();
    let mut done = 0i64;
    for (letter, unsigned, count) in fields(&call.arg(3).as_str())? {
        let number = match count {
            Count::Number(n) => n,
            _ => 1,
        };
        match letter {
            'x' => {
                at = if count == Count::All { bytes.len() } else { (at + number).min(bytes.len()) };
                continue;
            }
            'X' => {
                at = if count == Count::All { 0 } else { at.saturating_sub(number) };
                continue;
            }
            '@' => {
                at = if count == Count::All { bytes.len() } else { number.min(bytes.len()) };
                continue;
            }
            _ => {}
        }
        if !"aAbBhH".contains(letter) && number_field(letter).is_none() {
            return Err(bad_field(letter));
        }
        let Some(name) = names.next() else {
            return Err(Exception::error("not enough arguments for all format specifiers"));
        };
        let rest = bytes.get(at..).unwrap_or_default();
        let taken = match letter {
            'a' | 'A' => take_text(letter, rest, count, number),
            'b' | 'B' | 'h' | 'H' => {
                let per_byte = if matches!(letter, 'h' | 'H') { 2 } else { 8 };
                let wanted = if count == Count::All { rest.len() * per_byte } else { number };
                let size = wanted.div_ceil(per_byte);
                rest.get(..size).map(|part| (size, Value::from(unpack(letter, part, wanted))))
            }
            _ => take_numbers(letter, unsigned, rest, count, number),
        };
        let Some((size, value)) = taken else { break };
        at += size;
        let name = VarName::of(name);
        core.assign(&name, value)?;
        done += 1;
    }
    Ok(Value::from(done))
}

fn take_text(letter: char, rest: &[u8], count: Count, number: usize) -> Option<(usize, Value)> {
    let size = if count == Count::All { rest.len() } else { number };
    let mut part = rest.get(..size)?;
    if letter == 'A' {
        while let [before @ .., b' ' | 0] = part {
            part = before;
        }
    }
    Some((size, to_value(part)))
}

fn take_numbers(letter: char, unsigned: bool, rest: &[u8], count: Count, number: usize) -> Option<(usize, Value)> {
    let (size, big, float) = number_field(letter)?;
    let wanted = if count == Count::All { rest.len() / size } else { number };
    let part = rest.get(..size.checked_mul(wanted)?)?;
    let mut values = part.chunks_exact(size).map(|chunk| {
        let mut raw = [0u8; 8];
        for (i, b) in chunk.iter().enumerate() {
            raw[if big { size - 1 - i } else { i }] = *b;
        }
        let whole = u64::from_le_bytes(raw);
        match (float, size) {
            (true, 4) => Value::from(f64::from(f32::from_bits(whole as u32))),
            (true, _) => Value::from(f64::from_bits(whole)),
            (false, 8) if unsigned => Value::from(num_bigint::BigInt::from(whole)),
            (false, _) if unsigned => Value::from(whole as i64),
            (false, 1) => Value::from(i64::from(whole as u8 as i8)),
            (false, 2) => Value::from(i64::from(whole as u16 as i16)),
            (false, 4) => Value::from(i64::from(whole as u32 as i32)),
            _ => Value::from(whole as i64),
        }
    });
    let value = if count == Count::One { values.next()? } else { Value::list(values) };
    Some((part.len(), value))
}

const BASE64: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

fn encode(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "binary encode format ?-option value ...? data")?;
    let data = call.arg(call.len() - 1);
    let bytes = bytes_of(data);
    if kind(call)? == Kind::Hex {
        return Ok(Value::from(bytes.iter().map(|b| format!("{b:02x}")).collect::<String>()));
    }
    let (mut most, mut wrap) = (0, "\n".to_owned());
    for i in (3..call.len() - 1).step_by(2) {
        match call.choose(i, "option", &["-maxlen", "-wrapchar"], false)? {
            0 => most = usize::try_from(call.arg(i + 1).to_int()?).unwrap_or(0),
            _ => wrap = call.arg(i + 1).as_str().into_owned(),
        }
    }
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let letter = BASE64[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { letter as char } else { '=' });
        }
    }
    if most == 0 {
        return Ok(Value::from(text));
    }
    let mut out = String::new();
    for (i, c) in text.chars().enumerate() {
        if i > 0 && i % most == 0 {
            out.push_str(&wrap);
        }
        out.push(c);
    }
    Ok(Value::from(out))
}

fn decode(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "binary decode format ?-option value ...? data")?;
    let data = call.arg(call.len() - 1);
    if kind(call)? == Kind::Hex {
        return Ok(to_value(&pack('H', data, None)?));
    }
    let text = data.as_str();
    let mut out = vec![];
    let (mut bits, mut count) = (0u32, 0);
    for c in text.bytes().filter(|b| !b.is_ascii_whitespace() && *b != b'=') {
        let Some(value) = BASE64.iter().position(|b| *b == c) else {
            let message = format!("invalid base64 character \"{}\"", c as char);
            return Err(Exception::error(message).at(call.span(call.len() - 1), ""));
        };
        bits = bits << 6 | value as u32;
        count += 6;
        if count >= 8 {
            count -= 8;
            out.push((bits >> count) as u8);
            bits &= (1 << count) - 1;
        }
    }
    Ok(to_value(&out))
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Base64,
    Hex,
}

fn kind(call: &Call<'_>) -> Result<Kind, Exception> {
    match &*call.arg(2).as_str() {
        "hex" => Ok(Kind::Hex),
        "base64" => Ok(Kind::Base64),
        other => {
            let message = format!("binary {} {other}: only base64 and hex are supported", call.arg(1));
            Err(call.error_at(2, message, "not supported"))
        }
    }
}
