//! Origin of a text: the map from its bytes to those of a file.

use std::rc::Rc;

use crate::diagnostic::{SourceId, Span};

/// A text is a stretch of a source, but for places where a backslash sequence was replaced.
#[derive(Clone, Debug)]
pub(crate) struct Origin {
    source: SourceId,
    start: u32,
    /// From which byte of the text on how many more bytes the source has had, cumulated.
    shifts: Option<Rc<[(u32, u32)]>>,
}

impl Origin {
    /// The whole of a source.
    pub(crate) fn whole(source: SourceId) -> Self {
        Origin { source, start: 0, shifts: None }
    }

    fn map(&self, at: u32) -> u32 {
        let shift = match &self.shifts {
            None => 0,
            Some(shifts) => match shifts.partition_point(|&(from, _)| from <= at) {
                0 => 0,
                n => shifts[n - 1].1,
            },
        };
        self.start + at + shift
    }

    /// The place of a stretch of the text.
    pub(crate) fn span(&self, start: u32, end: u32) -> Span {
        Span { source: self.source, start: self.map(start), end: self.map(end) }
    }

    /// The origin of a part of the text, taken as it is.
    pub(crate) fn slice(&self, start: usize, end: usize) -> Origin {
        self.part(start as u32, (end - start) as u32, &[])
    }

    /// The origin of a word that starts at `start` of this text, is `length` bytes long and lost some bytes by `shifts`.
    pub(crate) fn part(&self, start: u32, length: u32, shifts: &[(u32, u32)]) -> Origin {
        let base = self.map(start);
        let own = |at: u32| match shifts.partition_point(|&(from, _)| from <= at) {
            0 => at,
            n => at + shifts[n - 1].1,
        };
        let mut breaks: Vec<u32> = shifts.iter().map(|s| s.0).collect();
        if let Some(outer) = &self.shifts {
            // Outer shifts lie between the escapes of the word or at them; each is brought back to a byte of the word.
            for &(from, _) in outer.iter().filter(|s| s.0 > start) {
                let within = from - start;
                let lost = shifts.iter().rev().find(|s| s.0 + s.1 <= within).map_or(0, |s| s.1);
                if within - lost < length {
                    breaks.push(within - lost);
                }
            }
            breaks.sort_unstable();
            breaks.dedup();
        }
        if breaks.is_empty() {
            return Origin { source: self.source, start: base, shifts: None };
        }
        let table = breaks.into_iter().map(|at| (at, self.map(start + own(at)) - base - at)).collect();
        Origin { source: self.source, start: base, shifts: Some(table) }
    }
}
