//! Texts of the reference about a command or a kind, which stand in its row.

/// Sentence about a command or a kind, and a call of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// One sentence or two; empty for a kind that its name describes.
    pub about: &'static str,
    /// Words that make a thing of the kind, where its usage alone does not lead to one; empty elsewhere.
    pub example: &'static str,
}

/// Sentence about a command that does nothing.
pub const WITHOUT_EFFECT: &str = "Accepted without effect.";

impl Text {
    /// Nothing but the name.
    pub(crate) const NONE: Self = Self::new("");

    pub(crate) const fn new(about: &'static str) -> Self {
        Self { about, example: "" }
    }

    /// The same text with words that make a thing of the kind.
    pub(crate) const fn example(mut self, words: &'static str) -> Self {
        self.example = words;
        self
    }
}
