//! A measured file: its format, its header, its channels.

use crate::archive::{gunzip, is_gzip};
use crate::content::Content;
use crate::fault::Fault;
use crate::format::{Beside, FORMATS, Format, Input, unsupported};
use crate::sheet::Sheet;
use crate::text::decode;
use std::borrow::Cow;

/// A file that has been read.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Name of the file without folders.
    pub file: String,
    /// Its format.
    pub format: &'static Format,
    /// Lines of its header, as read.
    pub header: Vec<String>,
    /// What was left out or taken otherwise than it is written.
    pub notes: Vec<String>,
    pub(crate) content: Content,
    /// Bytes of the file, unpacked.
    pub(crate) size: usize,
    /// Its text, for the places of faults; empty for binary files.
    pub(crate) text: String,
}

impl Measured {
    /// Read a file from its bytes. The format is seen from them; the name helps where they leave it open.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, Fault> {
        Self::read_with_text(name, bytes, &|_| None).map_err(|e| e.0)
    }

    /// As [`Measured::read`]; `beside` gives the bytes of another file of the same folder, which some headers name.
    ///
    /// # Errors
    /// What is wrong with the files, and where.
    pub fn read_beside(name: &str, bytes: &[u8], beside: Beside<'_>) -> Result<Self, Fault> {
        Self::read_with_text(name, bytes, beside).map_err(|e| e.0)
    }

    /// As [`Measured::read`]; a fault comes with the text that its place is in.
    pub(crate) fn read_with_text(name: &str, bytes: &[u8], beside: Beside<'_>) -> Result<Self, Box<(Fault, String)>> {
        let short = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let bare = |f: Fault| Box::new((f, String::new()));
        let unpacked;
        let (short, bytes) = if is_gzip(bytes) {
            unpacked = gunzip(bytes).map_err(|e| bare(Fault::new(e)))?;
            (short.strip_suffix(".gz").unwrap_or(short), unpacked.as_slice())
        } else {
            (short, bytes)
        };
        let find = |input: &Input<'_>| FORMATS.iter().find(|f| f.recognises(input));
        let binary = Input::new(short, bytes, "", beside);
        // A binary format is recognised without the text; the others all need one.
        let of_bytes = FORMATS[..BINARY].iter().find(|f| f.recognises(&binary));
        let text = match of_bytes {
            Some(_) => Cow::Borrowed(""),
            // A binary file of a kind that is not read has no text to look at.
            None => decode(bytes).map_err(|e| bare(unsupported::refusal(&binary).unwrap_or(e)))?,
        };
        let input = Input::new(short, bytes, &text, beside);
        let format = of_bytes.or_else(|| find(&input)).ok_or_else(|| bare(Fault::new("is of no known format")))?;
        if let Some(fault) = unsupported::refusal(&input).filter(|_| format.name == FORMATS[FORMATS.len() - 1].name) {
            return Err(Box::new((fault, text.into_owned())));
        }
        let mut content = format.read(&input).map_err(|f| Box::new((f, text.clone().into_owned())))?;
        locate(&mut content, short, &text, bytes.len());
        let (header, notes) = match &mut content {
            Content::Table(sheet) => (sheet.header.clone(), std::mem::take(&mut sheet.notes)),
            Content::Series { header, notes, .. } => (std::mem::take(header), std::mem::take(notes)),
        };
        let size = bytes.len();
        Ok(Self { file: short.to_owned(), format, header, notes, content, size, text: text.into_owned() })
    }

    /// The table as it is written, if the file is one.
    pub fn sheet(&self) -> Option<&Sheet> {
        if let Content::Table(sheet) = &self.content { Some(sheet) } else { None }
    }

    /// The header as read, for a message; empty if there is none.
    pub fn shown_header(&self) -> String {
        let names = self
            .sheet()
            .filter(|s| s.named)
            .map(|s| s.columns.iter().map(|c| c.cell.as_str()).collect::<Vec<_>>().join(", "));
        let lines: Vec<&str> = self.header.iter().map(|l| l.trim()).filter(|l| !l.is_empty()).collect();
        let text = names.unwrap_or_else(|| lines.iter().rev().take(3).rev().copied().collect::<Vec<_>>().join(" / "));
        if text.is_empty() {
            "there is no header".into()
        } else {
            format!("the header is \"{}\"", crate::number::shown(&text))
        }
    }
}

/// Formats at the begin of [`FORMATS`] that are no text.
const BINARY: usize = 6;

/// Give each channel its file and its bytes.
fn locate(content: &mut Content, file: &str, text: &str, size: usize) {
    let Content::Series { series, .. } = content else { return };
    let mut starts: Option<Vec<usize>> = None;
    for s in series {
        s.origin.file = file.to_owned();
        if !s.origin.bytes.is_empty() {
            continue;
        }
        if text.is_empty() || s.origin.lines.is_empty() {
            s.origin.bytes = 0..size;
            continue;
        }
        let starts = starts
            .get_or_insert_with(|| std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect());
        let at = |line: usize| starts.get(line.saturating_sub(1)).copied().unwrap_or(text.len());
        s.origin.bytes = at(s.origin.lines.start)..at(s.origin.lines.end);
    }
}
