//! The text of a buffer, with positions of the protocol (line and UTF-16 units, from 0) and places in bytes.

use lsp_types::{Position, Range, TextDocumentContentChangeEvent};
use std::sync::Arc;

/// A text with its lines. Line ends are single line feeds, whatever the editor has: no position changes by that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Text {
    text: Arc<str>,
    /// First byte of each line.
    lines: Vec<usize>,
}

impl Text {
    /// A text.
    pub(crate) fn new(text: &str) -> Self {
        let text = if text.contains('\r') { text.replace("\r\n", "\n").replace('\r', "\n") } else { text.to_owned() };
        let mut lines = vec![0];
        lines.extend(text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i + 1));
        Self { text: text.into(), lines }
    }

    /// The whole text, shared.
    pub(crate) fn shared(&self) -> Arc<str> {
        self.text.clone()
    }

    /// The whole text.
    pub(crate) fn as_str(&self) -> &str {
        &self.text
    }

    /// Number of lines, at least 1.
    pub(crate) fn line_count(&self) -> usize {
        self.lines.len()
    }

    /// A line without its end; empty behind the last.
    pub(crate) fn line(&self, n: usize) -> &str {
        self.text.get(self.line_range(n)).unwrap_or_default()
    }

    /// Bytes of a line without its end.
    pub(crate) fn line_range(&self, n: usize) -> std::ops::Range<usize> {
        let Some(&start) = self.lines.get(n) else { return self.text.len()..self.text.len() };
        start..self.lines.get(n + 1).map_or(self.text.len(), |next| next - 1)
    }

    /// Number of the line of a byte.
    pub(crate) fn line_of(&self, at: usize) -> usize {
        self.lines.partition_point(|l| *l <= at).saturating_sub(1)
    }

    /// Byte of a position. One behind the end of its line is the end of the line.
    pub(crate) fn offset(&self, p: Position) -> usize {
        let range = self.line_range(p.line as usize);
        let mut units = 0;
        for (i, c) in self.text[range.clone()].char_indices() {
            if units >= p.character as usize {
                return range.start + i;
            }
            units += c.len_utf16();
        }
        range.end
    }

    /// Position of a byte.
    pub(crate) fn position(&self, at: usize) -> Position {
        let at = at.min(self.text.len());
        let line = self.line_of(at);
        let before = self.text.get(self.lines[line]..at).unwrap_or_default();
        Position::new(line as u32, before.chars().map(char::len_utf16).sum::<usize>() as u32)
    }

    /// Range of bytes from `start` to before `end`.
    pub(crate) fn range(&self, start: usize, end: usize) -> Range {
        Range::new(self.position(start), self.position(end))
    }

    /// The text after a change by the editor.
    pub(crate) fn changed(&self, change: &TextDocumentContentChangeEvent) -> Self {
        let Some(range) = change.range else { return Self::new(&change.text) };
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        let (start, end) = (start.min(end), start.max(end));
        Self::new(&[&self.text[..start], &change.text, &self.text[end..]].concat())
    }
}

/// Where the bytes of an earlier text are in a later one: both begin and end alike, and differ between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shift {
    prefix: usize,
    old_end: usize,
    new_end: usize,
}

impl Shift {
    /// Between two texts.
    pub(crate) fn between(old: &str, new: &str) -> Self {
        let same = |a: &u8, b: &u8| a == b;
        let alike = old.bytes().zip(new.bytes()).take_while(|(a, b)| same(a, b)).count();
        let room = old.len().min(new.len()) - alike;
        let tail = old.bytes().rev().zip(new.bytes().rev()).take(room).take_while(|(a, b)| same(a, b)).count();
        if alike == old.len() && alike == new.len() {
            return Self { prefix: usize::MAX, old_end: usize::MAX, new_end: usize::MAX };
        }
        Self { prefix: alike, old_end: old.len() - tail, new_end: new.len() - tail }
    }

    /// Byte of the later text that was at a byte of the earlier; none for one that was changed.
    pub(crate) fn forward(self, at: usize) -> Option<usize> {
        moved(at, self.prefix, self.old_end, self.new_end)
    }

    /// Byte of the earlier text that is at a byte of the later; none for one that was changed.
    pub(crate) fn back(self, at: usize) -> Option<usize> {
        moved(at, self.prefix, self.new_end, self.old_end)
    }
}

fn moved(at: usize, prefix: usize, from_end: usize, to_end: usize) -> Option<usize> {
    match at {
        at if at <= prefix => Some(at),
        at if at >= from_end => Some(at - from_end + to_end),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Shift, Text};
    use lsp_types::{Position, Range, TextDocumentContentChangeEvent};

    #[test]
    fn positions_count_units_of_utf_16() {
        let text = Text::new("a\u{e9}\u{1d6fc}b\r\nnode 1\rlast");
        assert_eq!((text.line_count(), text.line(1), text.line(2), text.line(9)), (3, "node 1", "last", ""));
        for at in text.as_str().char_indices().map(|(i, _)| i).chain([text.as_str().len()]) {
            assert_eq!(text.offset(text.position(at)), at);
        }
        assert_eq!(text.position(7), Position::new(0, 4));
        assert_eq!(text.offset(Position::new(0, 99)), 8);
        assert_eq!(text.offset(Position::new(99, 0)), text.as_str().len());
    }

    #[test]
    fn a_change_replaces_a_range() {
        let change =
            |range, text: &str| TextDocumentContentChangeEvent { range, range_length: None, text: text.into() };
        let range = Range::new(Position::new(0, 5), Position::new(1, 1));
        let text = Text::new("node 1\n2 0\n").changed(&change(Some(range), "77"));
        assert_eq!(text.as_str(), "node 77 0\n");
        assert_eq!(text.changed(&change(None, "x\r\n")).as_str(), "x\n");
        let wrong = Range::new(Position::new(7, 0), Position::new(0, 0));
        assert_eq!(text.changed(&change(Some(wrong), "")).as_str(), "");
    }

    #[test]
    fn bytes_beside_a_change_move_with_it() {
        let shift = Shift::between("node 1 0 0", "node 123 0 0");
        assert_eq!((shift.forward(0), shift.forward(6), shift.forward(9)), (Some(0), Some(6), Some(11)));
        assert_eq!((shift.back(7), shift.back(8), shift.back(11)), (None, Some(6), Some(9)));
        let same = Shift::between("ab", "ab");
        assert_eq!((same.forward(1), same.back(2)), (Some(1), Some(2)));
    }
}
