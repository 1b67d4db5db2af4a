//! Texts of the reference about a command or a kind, which stand in its row.

mod any_command;

/// Meaning of an argument or an option that the messages of the command do not tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arg {
    /// Option that the argument follows, or that this is; empty for an argument by position.
    pub option: &'static str,
    /// Name in the usage, without its dollar; of several behind an option the first. Empty for an option alone.
    pub name: &'static str,
    /// Meaning of it, or of all arguments behind the option.
    pub meaning: &'static str,
}

impl Arg {
    /// An argument by position.
    pub(crate) const fn new(name: &'static str, meaning: &'static str) -> Self {
        Self { option: "", name, meaning }
    }

    /// The arguments behind an option.
    pub(crate) const fn of(option: &'static str, name: &'static str, meaning: &'static str) -> Self {
        Self { option, name, meaning }
    }

    /// An option without arguments.
    pub(crate) const fn flag(option: &'static str, meaning: &'static str) -> Self {
        Self { option, name: "", meaning }
    }
}

/// Sentence about a command or a kind, meanings of its arguments, and a call of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// One sentence or two; empty for a kind that its name describes.
    pub about: &'static str,
    /// Arguments of its own.
    pub arguments: &'static [Arg],
    /// Arguments that related kinds share.
    pub shared: &'static [Arg],
    /// Words that make a thing of the kind, where its usage alone does not lead to one; empty elsewhere.
    pub example: &'static str,
}

/// Sentence about a command that does nothing.
pub const WITHOUT_EFFECT: &str = "Accepted without effect.";

impl Text {
    /// Nothing but the name.
    pub(crate) const NONE: Self = Self::new("");

    pub(crate) const fn new(about: &'static str) -> Self {
        Self { about, arguments: &[], shared: &[], example: "" }
    }

    /// The same text with words that make a thing of the kind.
    pub(crate) const fn example(mut self, words: &'static str) -> Self {
        self.example = words;
        self
    }

    /// The same text with meanings of arguments.
    pub(crate) const fn arguments(mut self, arguments: &'static [Arg]) -> Self {
        self.arguments = arguments;
        self
    }

    /// The same text with meanings of arguments that related kinds share.
    pub(crate) const fn sharing(mut self, arguments: &'static [Arg]) -> Self {
        self.shared = arguments;
        self
    }

    /// Meaning of an argument, or of an option alone.
    pub(crate) fn meaning(&self, option: &str, name: &str) -> Option<&'static str> {
        meaning(self.arguments.iter().chain(self.shared), option, name)
    }
}

/// Meaning of an argument of any command.
pub(crate) fn meaning_of_any(option: &str, name: &str) -> Option<&'static str> {
    meaning(any_command::ANY_COMMAND, option, name)
}

fn meaning(arguments: impl IntoIterator<Item = &'static Arg>, option: &str, name: &str) -> Option<&'static str> {
    arguments.into_iter().find(|a| a.option == option && a.name == name).map(|a| a.meaning)
}
