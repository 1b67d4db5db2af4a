//! `fconfigure` and `encoding`: how bytes and text belong together.

use super::channel::{channel, usage};
use crate::channel::{Buffering, Channel, Encoding, Translation};
use crate::command::Call;
use crate::core::Core;
use crate::ensemble::choose_sub;
use crate::error::Exception;
use crate::value::Value;

pub(super) fn make_binary(channel: &mut Channel) {
    channel.encoding = Encoding::Latin1;
    channel.binary = true;
    channel.input_translation = Translation::Lf;
    channel.output_translation = Translation::Lf;
    channel.eof_char = None;
}

const OPTIONS: [&str; 6] = ["-blocking", "-buffering", "-buffersize", "-encoding", "-eofchar", "-translation"];

fn translation_name(translation: Translation) -> &'static str {
    match translation {
        Translation::Auto => "auto",
        Translation::CrLf => "crlf",
        Translation::Cr => "cr",
        Translation::Lf | Translation::Binary => "lf",
    }
}

/// The value of an option.
fn option(channel: &Channel, name: &str) -> Value {
    match name {
        "-blocking" => Value::from(1i64),
        "-buffering" => Value::from(match channel.buffering {
            Buffering::Full => "full",
            Buffering::Line => "line",
            Buffering::None => "none",
        }),
        "-buffersize" => Value::from(4096i64),
        "-encoding" => Value::from(match channel.encoding {
            _ if channel.binary => "binary",
            Encoding::Utf8 => "utf-8",
            Encoding::Latin1 => "iso8859-1",
            Encoding::Ascii => "ascii",
        }),
        "-eofchar" => {
            let one = channel.eof_char.map(|c| Value::from((c as char).to_string())).unwrap_or_default();
            match (channel.readable, channel.writable) {
                (true, true) => Value::list([one, Value::EMPTY]),
                (false, _) => Value::list([Value::EMPTY]),
                _ => one,
            }
        }
        _ => {
            let input = translation_name(channel.input_translation);
            let output = translation_name(channel.output_translation);
            match (channel.readable, channel.writable) {
                (true, true) => Value::list([input, output].map(Value::from)),
                (true, false) => Value::from(input),
                _ => Value::from(output),
            }
        }
    }
}

pub(super) fn configure(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if call.len() <= at || (call.len() > at + 2 && (call.len() - at).is_multiple_of(2)) {
        return Err(usage(call, at, "channelId ?-option value ...?"));
    }
    let bad_option = |word: usize| {
        let message = format!(
            "bad option \"{}\": should be one of -blocking, -buffering, -buffersize, -encoding, -eofchar, or -translation",
            call.arg(word)
        );
        Exception::error(message).at(call.span(word), "")
    };
    let find = |word: usize| {
        let text = call.arg(word).as_str();
        let mut fitting = OPTIONS.iter().filter(|o| text.len() > 1 && o.starts_with(&*text));
        let exact = OPTIONS.iter().find(|o| **o == text);
        exact.or(match (fitting.next(), fitting.next()) {
            (Some(one), None) => Some(one),
            _ => None,
        })
    };
    let channel = channel(core, call, at)?;
    match call.len() - at {
        1 => return Ok(Value::list(OPTIONS.iter().flat_map(|o| [Value::from(*o), option(channel, o)]))),
        2 => {
            let name = find(at + 1).ok_or_else(|| bad_option(at + 1))?;
            return Ok(option(channel, name));
        }
        _ => {}
    }
    for word in (at + 1..call.len()).step_by(2) {
        let name = find(word).ok_or_else(|| bad_option(word))?;
        set_option(channel, name, call, word + 1)?;
    }
    Ok(Value::EMPTY)
}

fn set_option(channel: &mut Channel, name: &str, call: &Call<'_>, word: usize) -> Result<(), Exception> {
    let value = call.arg(word);
    let text = value.as_str();
    let bad = |message: String| call.error_at(word, message, "");
    match name {
        "-blocking" => {
            let code = Value::list(["TCL", "VALUE", "BOOLEAN"].map(Value::from));
            value.to_bool().map_err(|e| e.with_code(code))?;
        }
        "-buffersize" => {
            value.to_i64()?;
        }
        "-buffering" => {
            channel.buffering = match &*text {
                "full" => Buffering::Full,
                "line" => Buffering::Line,
                "none" => Buffering::None,
                _ => return Err(bad("bad value for -buffering: must be one of full, line, or none".to_owned())),
            }
        }
        "-encoding" => {
            channel.binary = text == "binary" || text.is_empty();
            channel.encoding = match &*text {
                "utf-8" => Encoding::Utf8,
                "binary" | "" | "iso8859-1" | "cp1252" => Encoding::Latin1,
                "ascii" => Encoding::Ascii,
                _ => return Err(unknown_encoding(&text).at(call.span(word), "")),
            }
        }
        "-eofchar" => {
            let first = value.to_list()?.first().map(|v| v.as_str().into_owned()).unwrap_or_default();
            channel.eof_char = first.bytes().next();
        }
        _ => {
            let words = value.to_list()?;
            let mut sides = vec![];
            for side in words.iter() {
                sides.push(match &*side.as_str() {
                    "auto" => Translation::Auto,
                    "binary" => Translation::Binary,
                    "lf" => Translation::Lf,
                    "cr" => Translation::Cr,
                    "crlf" | "platform" if side.as_str() == "crlf" || cfg!(windows) => Translation::CrLf,
                    "platform" => Translation::Lf,
                    _ => {
                        let list = "auto, binary, cr, lf, crlf, or platform";
                        return Err(bad(format!("bad value for -translation: must be one of {list}")));
                    }
                });
            }
            let (input, output) = match *sides {
                [both] => (both, both),
                [input, output] => (input, output),
                _ => {
                    let message = "bad value for -translation: must be a one or two element list";
                    return Err(bad(message.to_owned()));
                }
            };
            if input == Translation::Binary || output == Translation::Binary {
                make_binary(channel);
            }
            let plain = |t: Translation, auto: Translation| match t {
                Translation::Auto => auto,
                Translation::Binary => Translation::Lf,
                t => t,
            };
            channel.input_translation = plain(input, Translation::Auto);
            channel.output_translation = plain(output, if cfg!(windows) { Translation::CrLf } else { Translation::Lf });
        }
    }
    Ok(())
}

fn unknown_encoding(name: &str) -> Exception {
    Exception::coded(format!("unknown encoding \"{name}\""), &["TCL", "LOOKUP", "ENCODING", name])
}

pub(super) fn encoding(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let names = ["convertfrom", "convertto", "dirs", "names", "system"];
    match choose_sub(call, names.into_iter())? {
        at @ (0 | 1) => {
            call.expect(3..=4, &format!("encoding {} ?encoding? data", names[at]))?;
            let name = if call.len() == 4 { call.arg(2).as_str() } else { "utf-8".into() };
            let data = call.arg(call.len() - 1).as_str();
            match (&*name, at) {
                ("utf-8", 0) => {
                    let bytes: Vec<u8> = data.chars().map(|c| c as u32 as u8).collect();
                    Ok(Value::from(String::from_utf8_lossy(&bytes).into_owned()))
                }
                ("utf-8", _) => Ok(Value::from(data.bytes().map(|b| b as char).collect::<String>())),
                ("iso8859-1" | "ascii" | "binary", 0) => Ok(call.arg(call.len() - 1).clone()),
                ("iso8859-1" | "ascii" | "binary", _) => {
                    let limit = if name == "ascii" { 0x80 } else { 0x100 };
                    let narrow = data.chars().map(|c| if u32::from(c) < limit { c } else { '?' });
                    Ok(Value::from(narrow.collect::<String>()))
                }
                _ => Err(unknown_encoding(&name).at(call.span(2), "")),
            }
        }
        3 => {
            call.expect(2..=2, "encoding names").map(|()| Value::list(["utf-8", "iso8859-1", "ascii"].map(Value::from)))
        }
        4 => Ok(if call.len() > 2 { Value::EMPTY } else { Value::from("utf-8") }),
        _ => Ok(Value::EMPTY),
    }
}
