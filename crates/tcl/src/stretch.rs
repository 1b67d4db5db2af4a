//! Texts that are stretches of longer ones.
//!
//! The body of an `if` within the body of a `proc` is a part of both texts. A copy for each would take memory as the square of
//! their nesting.

use std::ops::{Deref, Range};
use std::sync::Arc;

use super::origin::Origin;
use super::text::StrObj;
use super::value::{Rep, Value};

/// Bytes from which a word shares the text that it stands in. A shorter one is copied: it may outlive the text.
pub(crate) const MIN_SHARED: usize = 128;

/// A stretch of a shared text.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    whole: Arc<str>,
    start: u32,
    end: u32,
}

impl Stretch {
    /// The part at a range of bytes.
    pub(crate) fn part(&self, range: Range<usize>) -> Self {
        let start = self.start + range.start as u32;
        Stretch { whole: self.whole.clone(), start, end: start + range.len() as u32 }
    }
}

impl Deref for Stretch {
    type Target = str;
    fn deref(&self) -> &str {
        &self.whole[self.start as usize..self.end as usize]
    }
}

impl From<&str> for Stretch {
    fn from(text: &str) -> Self {
        Stretch { whole: text.into(), start: 0, end: text.len() as u32 }
    }
}

impl Value {
    /// A text that is a part of a longer one, with its place in a script.
    pub(crate) fn shared(text: Stretch, origin: Option<Origin>) -> Value {
        Value(Rep::Str(StrObj::shared(text, origin)))
    }

    /// A text with its place in a script, even where it is a number.
    pub(crate) fn placed(text: &str, origin: Origin) -> Value {
        Value(Rep::Str(StrObj::shared(text.into(), Some(origin))))
    }
}

/// A text of its own, or a stretch of a shared one.
#[derive(Clone, Debug)]
pub(crate) enum Chars {
    Own(String),
    Shared(Stretch),
}

impl Chars {
    /// The text as one of its own, to be changed.
    pub(crate) fn own(&mut self) -> &mut String {
        if let Chars::Shared(stretch) = self {
            *self = Chars::Own((**stretch).to_owned());
        }
        match self {
            Chars::Own(text) => text,
            Chars::Shared(_) => unreachable!("just made its own"),
        }
    }
}

impl Deref for Chars {
    type Target = str;
    fn deref(&self) -> &str {
        match self {
            Chars::Own(text) => text,
            Chars::Shared(stretch) => stretch,
        }
    }
}
