//! `open`, `puts`, `gets`, `read` and the other commands on channels; `chan` is another name for them.

use std::io::{self, SeekFrom};

use super::channel_options;
use crate::channel::{Channel, Target};
use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::choose_sub;
use crate::error::Exception;
use crate::files::{OpenMode, posix};
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[
    ("chan", chan),
    ("close", |core, call| close(core, call, 1)),
    ("encoding", channel_options::encoding),
    ("eof", |core, call| eof(core, call, 1)),
    ("fblocked", |core, call| blocked(core, call, 1)),
    ("fconfigure", |core, call| channel_options::configure(core, call, 1)),
    ("fcopy", |core, call| copy(core, call, 1)),
    ("fileevent", |_, call| no_events(call)),
    ("flush", |core, call| flush(core, call, 1)),
    ("gets", |core, call| gets(core, call, 1)),
    ("open", open),
    ("puts", |core, call| puts(core, call, 1)),
    ("read", |core, call| read(core, call, 1)),
    ("seek", |core, call| seek(core, call, 1)),
    ("tell", |core, call| tell(core, call, 1)),
];

/// A command whose first argument is the word with this number.
type At = fn(&mut Core, &Call<'_>, usize) -> Result<Value, Exception>;

fn chan(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let subs: [(&str, At); 19] = [
        ("blocked", blocked),
        ("close", close),
        ("configure", channel_options::configure),
        ("copy", copy),
        ("create", |_, call, _| no_events(call)),
        ("eof", eof),
        ("event", |_, call, _| no_events(call)),
        ("flush", flush),
        ("gets", gets),
        ("names", |core, _, _| Ok(Value::list(core.channels.names().map(Value::from)))),
        ("pending", |_, _, _| Ok(Value::from(0i64))),
        ("pipe", |_, call, _| no_events(call)),
        ("pop", |_, call, _| no_events(call)),
        ("postevent", |_, call, _| no_events(call)),
        ("push", |_, call, _| no_events(call)),
        ("puts", puts),
        ("read", read),
        ("seek", seek),
        ("tell", tell),
    ];
    let names = subs.iter().map(|s| s.0).chain(std::iter::once("truncate"));
    match subs.get(choose_sub(call, names)?) {
        Some((_, function)) => function(core, call, 2),
        None => truncate(core, call),
    }
}

fn no_events(call: &Call<'_>) -> Result<Value, Exception> {
    let message = format!("{}: channels with events or programs behind them are not supported", call.name());
    Err(call.error_at(0, message, "not supported"))
}

/// The usage of a command, with the words as it was called.
pub(super) fn usage(call: &Call<'_>, at: usize, rest: &str) -> Exception {
    call.usage(at, rest)
}

/// The channel that a word names.
pub(super) fn channel<'c>(core: &'c mut Core, call: &Call<'_>, word: usize) -> Result<&'c mut Channel, Exception> {
    let name = call.arg(word).as_str();
    match core.channels.get(&name) {
        Some(channel) => Ok(channel),
        None => {
            let message = format!("can not find channel named \"{name}\"");
            Err(Exception::coded(message, &["TCL", "LOOKUP", "CHANNEL", &name]).at(call.span(word), "no open file"))
        }
    }
}

fn must(call: &Call<'_>, word: usize, can: bool, what: &str) -> Result<(), Exception> {
    if can {
        return Ok(());
    }
    let message = format!("channel \"{}\" wasn't opened for {what}", call.arg(word));
    Err(Exception::error(message).at(call.span(word), ""))
}

fn puts(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    let words = call.from(at);
    let dashed = words.first().is_some_and(|w| w.as_str() == "-nonewline");
    let (newline, target, text) = match words {
        [text] => (true, None, text),
        [_, text] if dashed => (false, None, text),
        [_, text] => (true, Some(at), text),
        [_, _, text] if dashed => (false, Some(at + 1), text),
        // An old form still accepted.
        [_, text, last] if last.as_str() == "nonewline" => (false, Some(at), text),
        _ => return Err(usage(call, at, "?-nonewline? ?channelId? string")),
    };
    let mut line = String::new();
    text.write_to(&mut line);
    if newline {
        line.push('\n');
    }
    match target {
        None => core.console.out(&line),
        Some(word) => {
            let name = call.arg(word).as_str();
            let Some(channel) = core.channels.get(&name) else {
                return channel(core, call, word).map(|_| Value::EMPTY);
            };
            must(call, word, channel.writable, "writing")?;
            channel
                .write(&line, core.console.as_mut())
                .map_err(|e| posix(&e, |why| format!("error writing \"{name}\": {why}")))?;
        }
    }
    Ok(Value::EMPTY)
}

fn gets(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if !(at + 1..=at + 2).contains(&call.len()) {
        return Err(usage(call, at, "channelId ?varName?"));
    }
    let channel = channel(core, call, at)?;
    must(call, at, channel.readable, "reading")?;
    let line =
        channel.read_line().map_err(|e| posix(&e, |why| format!("error reading \"{}\": {why}", call.arg(at))))?;
    let Some(name) = call.get(at + 1) else { return Ok(Value::from(line.unwrap_or_default())) };
    let length = line.as_ref().map_or(-1, |l| l.chars().count() as i64);
    let name = VarName::of(name);
    core.assign(&name, Value::from(line.unwrap_or_default()))?;
    Ok(Value::from(length))
}

fn read(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    let words = call.from(at);
    let trim = words.len() == 2 && words.first().is_some_and(|w| w.as_str() == "-nonewline");
    let (word, limit) = match words {
        [_, _] if trim => (at + 1, None),
        [_] => (at, None),
        [_, limit] => {
            let channel = channel(core, call, at)?;
            must(call, at, channel.readable, "reading")?;
            let old_form = limit.as_str() == "nonewline";
            let number = limit.to_i64().ok().and_then(|n| usize::try_from(n).ok());
            if !old_form && number.is_none() {
                let message = format!("expected non-negative integer but got \"{limit}\"");
                return Err(Exception::coded(message, &["TCL", "VALUE", "NUMBER"]).at(call.span(at + 1), ""));
            }
            (at, number)
        }
        _ => {
            let words = call.from(0)[..at].iter().map(|w| w.as_str().into_owned()).collect::<Vec<_>>().join(" ");
            return Err(call.wrong_args(&format!("{words} channelId ?numChars?\" or \"{words} ?-nonewline? channelId")));
        }
    };
    let channel = channel(core, call, word)?;
    must(call, word, channel.readable, "reading")?;
    let mut text =
        channel.read(limit).map_err(|e| posix(&e, |why| format!("error reading \"{}\": {why}", call.arg(word))))?;
    if trim && text.ends_with('\n') {
        text.pop();
    }
    Ok(Value::from(text))
}

fn open(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=4, "open fileName ?access? ?permissions?")?;
    let name = call.arg(1).as_str();
    if name.starts_with('|') {
        let code = Value::list(["HYSTERON", "REFUSED", "open"].map(Value::from));
        let message = format!("open \"{name}\": a script cannot start other programs");
        return Err(call.error_at(1, message, "refused").with_code(code));
    }
    let (mode, binary) = access(call)?;
    let full = core.absolute(&name);
    let mut stream = core
        .files
        .open(&full, mode)
        .map_err(|e| posix(&e, |why| format!("couldn't open \"{name}\": {why}")).at(call.span(1), ""))?;
    if mode.append {
        let _ = stream.seek(SeekFrom::End(0));
    }
    let mut channel = Channel::new(Target::File(stream), mode.read, mode.write, mode.append);
    if binary {
        channel_options::make_binary(&mut channel);
    }
    Ok(Value::from(core.channels.add(channel)))
}

/// The access mode: `r`, `w+`, `ab`, or a list like `{WRONLY CREAT TRUNC}`.
fn access(call: &Call<'_>) -> Result<(OpenMode, bool), Exception> {
    let Some(word) = call.get(2) else { return Ok((OpenMode { read: true, ..OpenMode::default() }, false)) };
    let text = word.as_str();
    let mut mode = OpenMode::default();
    if text.starts_with(|c: char| c.is_ascii_lowercase()) {
        let letters: String = text.chars().skip(1).collect();
        let bad = || {
            let message = format!("illegal access mode \"{text}\"");
            Exception::error(message).at(call.span(2), "")
        };
        let (plus, binary) = match letters.as_str() {
            "" => (false, false),
            "b" => (false, true),
            "+" => (true, false),
            "b+" | "+b" => (true, true),
            _ => return Err(bad()),
        };
        match text.chars().next() {
            Some('r') => mode.read = true,
            Some('w') => (mode.write, mode.create, mode.truncate) = (true, true, true),
            Some('a') => (mode.write, mode.create, mode.append) = (true, true, true),
            _ => return Err(bad()),
        }
        mode.read |= plus;
        mode.write |= plus;
        return Ok((mode, binary));
    }
    let mut binary = false;
    let mut direction = false;
    for flag in word.to_list()?.iter() {
        match &*flag.as_str() {
            "RDONLY" => (mode.read, direction) = (true, true),
            "WRONLY" => (mode.write, direction) = (true, true),
            "RDWR" => (mode.read, mode.write, direction) = (true, true, true),
            "APPEND" => mode.append = true,
            "BINARY" => binary = true,
            "CREAT" => mode.create = true,
            "EXCL" => mode.exclusive = true,
            "TRUNC" => mode.truncate = true,
            "NOCTTY" | "NONBLOCK" => {}
            other => {
                let list = "RDONLY, WRONLY, RDWR, APPEND, BINARY, CREAT, EXCL, NOCTTY, NONBLOCK, or TRUNC";
                let message = format!("invalid access mode \"{other}\": must be {list}");
                return Err(Exception::error(message).at(call.span(2), ""));
            }
        }
    }
    if !direction {
        let message = "access mode must include either RDONLY, WRONLY, or RDWR";
        return Err(Exception::error(message).at(call.span(2), ""));
    }
    mode.exclusive &= mode.create;
    Ok((mode, binary))
}

fn close(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if !(at + 1..=at + 2).contains(&call.len()) {
        return Err(usage(call, at, "channelId ?direction?"));
    }
    channel(core, call, at)?;
    let name = call.arg(at).as_str();
    if let Some(mut closed) = core.channels.remove(&name) {
        closed.flush().map_err(|e| posix(&e, |why| format!("error closing \"{name}\": {why}")))?;
    }
    Ok(Value::EMPTY)
}

fn eof(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if call.len() != at + 1 {
        return Err(usage(call, at, "channelId"));
    }
    Ok(Value::from(channel(core, call, at)?.eof))
}

fn blocked(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if call.len() != at + 1 {
        return Err(usage(call, at, "channelId"));
    }
    let channel = channel(core, call, at)?;
    must(call, at, channel.readable, "reading")?;
    Ok(Value::from(false))
}

fn flush(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if call.len() != at + 1 {
        return Err(usage(call, at, "channelId"));
    }
    core.pause();
    let channel = channel(core, call, at)?;
    must(call, at, channel.writable, "writing")?;
    channel.flush().map_err(|e| posix(&e, |why| format!("error flushing \"{}\": {why}", call.arg(at))))?;
    Ok(Value::EMPTY)
}

fn seek(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if !(at + 2..=at + 3).contains(&call.len()) {
        return Err(usage(call, at, "channelId offset ?origin?"));
    }
    channel(core, call, at)?;
    let offset = call.arg(at + 1).to_wide()?;
    let from = match call.get(at + 2) {
        None => 0,
        Some(_) => call.choose(at + 2, "origin", &["start", "current", "end"], false)?,
    };
    let to = match from {
        1 => SeekFrom::Current(offset),
        2 => SeekFrom::End(offset),
        _ => match u64::try_from(offset) {
            Ok(offset) => SeekFrom::Start(offset),
            Err(_) => {
                let e = io::ErrorKind::InvalidInput.into();
                return Err(posix(&e, |why| format!("error during seek on \"{}\": {why}", call.arg(at))));
            }
        },
    };
    let channel = channel(core, call, at)?;
    channel.seek(to).map_err(|e| posix(&e, |why| format!("error during seek on \"{}\": {why}", call.arg(at))))?;
    Ok(Value::EMPTY)
}

fn tell(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    if call.len() != at + 1 {
        return Err(usage(call, at, "channelId"));
    }
    Ok(Value::from(channel(core, call, at)?.tell().unwrap_or(-1)))
}

fn truncate(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=4, "chan truncate channelId ?length?")?;
    let length = match call.get(3) {
        None => None,
        Some(length) => match u64::try_from(length.to_i64()?) {
            Ok(length) => Some(length),
            Err(_) => return Err(call.error_at(3, "cannot truncate to negative length of file", "")),
        },
    };
    let channel = channel(core, call, 2)?;
    must(call, 2, channel.writable, "writing")?;
    channel
        .truncate(length)
        .map_err(|e| posix(&e, |why| format!("error during truncate on \"{}\": {why}", call.arg(2))))?;
    Ok(Value::EMPTY)
}

fn copy(core: &mut Core, call: &Call<'_>, at: usize) -> Result<Value, Exception> {
    let size = match call.from(at) {
        [_, _] => None,
        [_, _, option, size] if option.as_str() == "-size" => usize::try_from(size.to_i64()?).ok(),
        [_, _, option, _] if option.as_str() == "-command" => return no_events(call),
        _ => return Err(usage(call, at, "input output ?-size size? ?-command callback?")),
    };
    let input = channel(core, call, at)?;
    must(call, at, input.readable, "reading")?;
    let text = input.read(size).map_err(|e| posix(&e, |why| format!("error reading \"{}\": {why}", call.arg(at))))?;
    let name = call.arg(at + 1).as_str();
    let Some(output) = core.channels.get(&name) else { return channel(core, call, at + 1).map(|_| Value::EMPTY) };
    must(call, at + 1, output.writable, "writing")?;
    output
        .write(&text, core.console.as_mut())
        .map_err(|e| posix(&e, |why| format!("error writing \"{name}\": {why}")))?;
    Ok(Value::from(text.chars().count()))
}
