//! Open files of a script, under names like `file3`.

use std::io::{self, Seek as _, SeekFrom, Write as _};

use super::console::Console;
use super::files::Stream;

/// Bytes that are written only when there are this many.
const BUFFER: usize = 16 * 1024;

/// End of line of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Translation {
    Auto,
    Lf,
    CrLf,
    Cr,
    /// Bytes as they are.
    Binary,
}

/// Encoding of characters as bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Utf8,
    /// One byte a character; `binary` too.
    Latin1,
    Ascii,
}

/// When output is passed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Buffering {
    Full,
    Line,
    None,
}

/// Target of a channel.
pub(crate) enum Target {
    Stdin,
    Stdout,
    Stderr,
    File(Box<dyn Stream>),
}

/// An open file, or one of the standard channels.
pub(crate) struct Channel {
    target: Target,
    pub(crate) readable: bool,
    pub(crate) writable: bool,
    append: bool,
    pub(crate) input_translation: Translation,
    pub(crate) output_translation: Translation,
    pub(crate) encoding: Encoding,
    /// True if `fconfigure` reports the encoding as `binary`.
    pub(crate) binary: bool,
    pub(crate) buffering: Buffering,
    /// A byte at which reading ends.
    pub(crate) eof_char: Option<u8>,
    /// Read from the file, not yet asked for by the script.
    input: Vec<u8>,
    /// First byte of `input` that is still to be given.
    taken: usize,
    /// True at the end of the file.
    exhausted: bool,
    pub(crate) eof: bool,
    output: Vec<u8>,
}

impl Channel {
    pub(crate) fn new(target: Target, readable: bool, writable: bool, append: bool) -> Self {
        let buffering = match target {
            Target::Stderr => Buffering::None,
            Target::Stdout => Buffering::Line,
            _ => Buffering::Full,
        };
        Channel {
            target,
            readable,
            writable,
            append,
            input_translation: Translation::Auto,
            output_translation: Translation::Lf,
            encoding: Encoding::Utf8,
            binary: false,
            buffering,
            eof_char: None,
            input: vec![],
            taken: 0,
            exhausted: false,
            eof: false,
            output: vec![],
        }
    }

    /// Write text; it may wait in the buffer.
    pub(crate) fn write(&mut self, text: &str, console: &mut dyn Console) -> io::Result<()> {
        match &mut self.target {
            Target::Stdout => console.out(text),
            Target::Stderr => console.err(text),
            Target::Stdin => return Err(io::ErrorKind::PermissionDenied.into()),
            Target::File(_) => {
                self.sync_position()?;
                self.encode(text);
                let line = self.buffering == Buffering::Line && text.contains('\n');
                if self.output.len() >= BUFFER || line || self.buffering == Buffering::None {
                    self.flush()?;
                }
            }
        }
        Ok(())
    }

    fn encode(&mut self, text: &str) {
        let newline: &[u8] = match self.output_translation {
            Translation::CrLf => b"\r\n",
            Translation::Cr => b"\r",
            _ => b"\n",
        };
        if self.encoding == Encoding::Utf8 && newline == b"\n" {
            self.output.extend_from_slice(text.as_bytes());
            return;
        }
        for c in text.chars() {
            match (c, self.encoding) {
                ('\n', _) => self.output.extend_from_slice(newline),
                (c, Encoding::Utf8) => self.output.extend_from_slice(c.encode_utf8(&mut [0; 4]).as_bytes()),
                // Tcl writes the low byte of a character to a binary channel, and `?` where an encoding lacks it.
                (c, _) if self.binary => self.output.push(c as u32 as u8),
                (c, Encoding::Latin1) => self.output.push(u8::try_from(c as u32).unwrap_or(b'?')),
                (c, Encoding::Ascii) => self.output.push(if c.is_ascii() { c as u8 } else { b'?' }),
            }
        }
    }

    /// Pass on what waits in the buffer.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        if let Target::File(stream) = &mut self.target
            && !self.output.is_empty()
        {
            let bytes = std::mem::take(&mut self.output);
            stream.write_all(&bytes)?;
            stream.flush()?;
            self.output = bytes;
            self.output.clear();
        }
        Ok(())
    }

    /// Before writing after reading: the file must stand where the script believes it does.
    fn sync_position(&mut self) -> io::Result<()> {
        if self.input.len() > self.taken || self.exhausted {
            let ahead = (self.input.len() - self.taken) as i64;
            if let Target::File(stream) = &mut self.target {
                stream.seek(SeekFrom::Current(-ahead))?;
            }
            self.forget_input();
        }
        Ok(())
    }

    fn forget_input(&mut self) {
        self.input.clear();
        self.taken = 0;
        self.exhausted = false;
        self.eof = false;
    }

    /// Read all that the file has.
    fn fill(&mut self) -> io::Result<()> {
        self.flush()?;
        if self.taken > 0 {
            self.input.drain(..self.taken);
            self.taken = 0;
        }
        if !self.exhausted {
            if let Target::File(stream) = &mut self.target {
                self.input.extend(super::files::read_whole(&mut **stream)?);
            }
            if let Some(c) = self.eof_char
                && let Some(at) = self.input.iter().position(|b| *b == c)
            {
                self.input.truncate(at);
            }
            self.exhausted = true;
        }
        Ok(())
    }

    fn rest(&self) -> &[u8] {
        &self.input[self.taken..]
    }

    fn ready(&mut self) -> io::Result<()> {
        if self.taken >= self.input.len() || !self.exhausted {
            // At the end of the file more may have come since.
            self.exhausted = false;
            self.fill()?;
        }
        Ok(())
    }

    /// The next line without its end; `None` at the end of the file.
    pub(crate) fn read_line(&mut self) -> io::Result<Option<String>> {
        self.ready()?;
        let rest = self.rest();
        if rest.is_empty() {
            self.eof = true;
            return Ok(None);
        }
        let ends = |b: &u8| match self.input_translation {
            Translation::Auto => matches!(b, b'\n' | b'\r'),
            Translation::Cr => *b == b'\r',
            _ => *b == b'\n',
        };
        let mut from = 0;
        let (length, end) = loop {
            match rest[from..].iter().position(ends).map(|at| from + at) {
                None => break (rest.len(), 0),
                Some(at) if rest[at] == b'\r' && self.input_translation == Translation::Auto => {
                    break (at, if rest.get(at + 1) == Some(&b'\n') { 2 } else { 1 });
                }
                Some(at) if self.input_translation == Translation::CrLf => {
                    if at > 0 && rest[at - 1] == b'\r' {
                        break (at - 1, 2);
                    }
                    from = at + 1;
                }
                Some(at) => break (at, 1),
            }
        };
        let line = self.decode(&rest[..length]);
        self.taken += length + end;
        self.eof = end == 0;
        Ok(Some(line))
    }

    /// All that is left, or so many characters of it.
    pub(crate) fn read(&mut self, limit: Option<usize>) -> io::Result<String> {
        self.ready()?;
        let rest = self.rest();
        let Some(limit) = limit else {
            let text = self.decode_lines(rest);
            self.taken = self.input.len();
            self.eof = true;
            return Ok(text);
        };
        let mut text = String::new();
        let mut used = 0;
        for _ in 0..limit {
            let left = &rest[used..];
            let length = match left {
                [] => break,
                [b'\r', b'\n', ..] if matches!(self.input_translation, Translation::Auto | Translation::CrLf) => 2,
                [b, ..] if self.encoding == Encoding::Utf8 => utf8_length(*b).min(left.len()),
                _ => 1,
            };
            text.push_str(&self.decode_lines(&left[..length]));
            used += length;
        }
        self.eof = used == rest.len() && text.chars().count() < limit;
        self.taken += used;
        Ok(text)
    }

    fn decode(&self, bytes: &[u8]) -> String {
        match self.encoding {
            Encoding::Utf8 => match std::str::from_utf8(bytes) {
                Ok(text) => text.to_owned(),
                // Bytes that are no UTF-8 are taken as Latin-1, as Tcl does.
                Err(_) => bytes
                    .utf8_chunks()
                    .flat_map(|c| c.valid().chars().chain(c.invalid().iter().map(|b| *b as char)))
                    .collect(),
            },
            Encoding::Latin1 | Encoding::Ascii => bytes.iter().map(|b| *b as char).collect(),
        }
    }

    fn decode_lines(&self, bytes: &[u8]) -> String {
        let text = self.decode(bytes);
        match self.input_translation {
            Translation::Auto if text.contains('\r') => text.replace("\r\n", "\n").replace('\r', "\n"),
            Translation::CrLf => text.replace("\r\n", "\n"),
            Translation::Cr => text.replace('\r', "\n"),
            _ => text,
        }
    }

    /// Place in the file as the script sees it.
    pub(crate) fn tell(&mut self) -> io::Result<i64> {
        let pending = self.output.len() as i64;
        let ahead = self.rest().len() as i64;
        match &mut self.target {
            Target::File(stream) if self.append && pending > 0 => Ok(stream.seek(SeekFrom::End(0))? as i64 + pending),
            Target::File(stream) => Ok(stream.stream_position()? as i64 - ahead + pending),
            _ => Ok(-1),
        }
    }

    pub(crate) fn seek(&mut self, to: SeekFrom) -> io::Result<()> {
        self.flush()?;
        let to = match to {
            SeekFrom::Current(by) => SeekFrom::Current(by.saturating_sub(self.rest().len() as i64)),
            other => other,
        };
        match &mut self.target {
            Target::File(stream) => stream.seek(to)?,
            _ => return Err(io::ErrorKind::InvalidInput.into()),
        };
        self.forget_input();
        Ok(())
    }

    /// Cut the file here, or at a length.
    pub(crate) fn truncate(&mut self, length: Option<u64>) -> io::Result<()> {
        self.flush()?;
        let length = match length {
            Some(l) => l,
            None => self.tell()?.max(0) as u64,
        };
        match &mut self.target {
            Target::File(stream) => stream.set_len(length),
            _ => Err(io::ErrorKind::InvalidInput.into()),
        }
    }
}

fn utf8_length(first: u8) -> usize {
    match first {
        0xc2..=0xdf => 2,
        0xe0..=0xef => 3,
        0xf0..=0xf4 => 4,
        _ => 1,
    }
}

/// The channels under their names.
pub(crate) struct Channels {
    open: Vec<(String, Channel)>,
}

impl Default for Channels {
    fn default() -> Self {
        let standard = [
            ("stdin", Channel::new(Target::Stdin, true, false, false)),
            ("stdout", Channel::new(Target::Stdout, false, true, false)),
            ("stderr", Channel::new(Target::Stderr, false, true, false)),
        ];
        Channels { open: standard.into_iter().map(|(n, c)| (n.to_owned(), c)).collect() }
    }
}

impl Channels {
    pub(crate) fn get(&mut self, name: &str) -> Option<&mut Channel> {
        self.open.iter_mut().find(|(n, _)| n == name).map(|(_, c)| c)
    }

    /// Take in a channel and name it with the lowest free number, as the system numbers open files.
    pub(crate) fn add(&mut self, channel: Channel) -> String {
        let name = (3..)
            .map(|n| format!("file{n}"))
            .find(|n| self.open.iter().all(|(o, _)| o != n))
            .unwrap_or_else(|| "file".to_owned());
        self.open.push((name.clone(), channel));
        name
    }

    pub(crate) fn remove(&mut self, name: &str) -> Option<Channel> {
        let at = self.open.iter().position(|(n, _)| n == name)?;
        Some(self.open.remove(at).1)
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.open.iter().map(|(n, _)| n.as_str())
    }

    /// Flush all channels. At the end of a script errors can no longer be reported.
    pub(crate) fn flush_all(&mut self) {
        for (_, channel) in &mut self.open {
            let _ = channel.flush();
        }
    }
}

impl Drop for Channels {
    fn drop(&mut self) {
        self.flush_all();
    }
}
