//! Texts of the reference about a command or a kind, which stand in its row.

pub(crate) mod any_command;

use std::borrow::Cow;

/// Values that a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Any number.
    Number,
    /// Greater than 0.
    Positive,
    /// Not less than 0.
    NotNegative,
    /// From 0 to below 1.
    Ratio,
    /// From 0 to 1.
    Fraction,
    /// Greater than 0, though OpenSees takes any number.
    UsuallyPositive,
    /// Not less than 0, though OpenSees takes any number.
    UsuallyNotNegative,
    /// Less than 0.
    Negative,
    /// A whole number.
    Whole,
    /// A whole number not less than 1.
    Count,
    /// The tag of a thing that is there; the meaning names its kind.
    Tag,
}

impl Domain {
    /// True for a number of the domain.
    pub(crate) fn holds(self, x: f64) -> bool {
        match self {
            Self::Number | Self::Whole | Self::Tag => true,
            Self::Count => x >= 1.0,
            Self::Positive | Self::UsuallyPositive => x > 0.0,
            Self::NotNegative | Self::UsuallyNotNegative => x >= 0.0,
            Self::Negative => x < 0.0,
            Self::Ratio => (0.0..1.0).contains(&x),
            Self::Fraction => (0.0..=1.0).contains(&x),
        }
    }

    /// A number of the domain, in the words of messages.
    pub(crate) fn expected(self) -> &'static str {
        match self {
            Self::Number => "a number",
            Self::Positive | Self::UsuallyPositive => "a number greater than 0",
            Self::NotNegative | Self::UsuallyNotNegative => "a number not less than 0",
            Self::Negative => "a number less than 0",
            Self::Ratio => "a number from 0 to below 1",
            Self::Fraction => "a number from 0 to 1",
            Self::Whole | Self::Tag => "a whole number",
            Self::Count => "a whole number not less than 1",
        }
    }

    /// True if OpenSees takes numbers outside of it.
    pub(crate) fn is_usual(self) -> bool {
        matches!(self, Self::UsuallyPositive | Self::UsuallyNotNegative)
    }

    /// The domain in the tables of the reference.
    pub fn told(self) -> &'static str {
        match self {
            Self::Fraction => "number, 0 to 1",
            Self::Ratio => "number ≥ 0 and < 1",
            Self::Number | Self::UsuallyPositive | Self::UsuallyNotNegative => "number",
            Self::Positive => "number > 0",
            Self::Negative => "number < 0",
            Self::NotNegative => "number ≥ 0",
            Self::Whole | Self::Tag => "whole number",
            Self::Count => "whole number ≥ 1",
        }
    }
}

/// An argument or an option of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arg {
    /// Option that the argument follows, or that this is; empty for an argument by position.
    pub option: &'static str,
    /// Name in the usage, without its dollar; of several behind an option the first. Empty for an option alone.
    pub name: &'static str,
    /// Meaning of it, or of all arguments behind the option. Of a tag it is the kind of thing: see [`Self::told`].
    pub meaning: &'static str,
    /// Domain of a number; none of other words.
    pub domain: Option<Domain>,
    /// Further names of the number in OpenSees' `parameter`. A name after a minus sets the opposite.
    pub parameters: &'static [&'static str],
}

impl Arg {
    /// An argument by position.
    pub(crate) const fn new(name: &'static str, meaning: &'static str) -> Self {
        Self { option: "", name, meaning, domain: None, parameters: &[] }
    }

    /// The arguments behind an option.
    pub(crate) const fn of(option: &'static str, name: &'static str, meaning: &'static str) -> Self {
        Self { option, name, meaning, domain: None, parameters: &[] }
    }

    /// An option without arguments.
    pub(crate) const fn flag(option: &'static str, meaning: &'static str) -> Self {
        Self { option, name: "", meaning, domain: None, parameters: &[] }
    }

    /// A number of a domain behind an option.
    pub(crate) const fn behind(option: &'static str, meaning: &'static str, domain: Domain) -> Self {
        Self { option, name: "value", meaning, domain: Some(domain), parameters: &[] }
    }

    /// A number of a domain, by position.
    pub(crate) const fn of_domain(name: &'static str, meaning: &'static str, domain: Domain) -> Self {
        Self { option: "", name, meaning, domain: Some(domain), parameters: &[] }
    }

    /// A number, by position.
    pub(crate) const fn number(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::Number)
    }

    /// A number greater than 0, by position.
    pub(crate) const fn positive(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::Positive)
    }

    /// A number not less than 0, by position.
    pub(crate) const fn not_negative(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::NotNegative)
    }

    /// A whole number, by position.
    pub(crate) const fn whole(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::Whole)
    }

    /// A whole number not less than 1, by position.
    pub(crate) const fn count(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::Count)
    }

    /// The tag of a thing of a kind, by position.
    pub(crate) const fn thing(name: &'static str, kind: &'static str) -> Self {
        Self::of_domain(name, kind, Domain::Tag)
    }

    /// The same argument as a number of a domain.
    pub(crate) const fn within(mut self, domain: Domain) -> Self {
        self.domain = Some(domain);
        self
    }

    /// The same argument under another name in the usage.
    pub(crate) const fn called(mut self, name: &'static str) -> Self {
        self.name = name;
        self
    }

    /// The same argument behind an option.
    pub(crate) const fn after(mut self, option: &'static str) -> Self {
        self.option = option;
        self
    }

    /// The meaning in the tables of the reference.
    pub fn told(&self) -> Cow<'static, str> {
        match self.domain {
            Some(Domain::Tag) => format!("tag of a {}", self.meaning).into(),
            _ => self.meaning.into(),
        }
    }

    /// The same argument with further names in OpenSees' `parameter`.
    pub(crate) const fn also(mut self, parameters: &'static [&'static str]) -> Self {
        self.parameters = parameters;
        self
    }

    /// The sign of the number under a further name, if it has that name.
    fn sign_as(&self, name: &str) -> Option<f64> {
        self.parameters.iter().find_map(|p| match p.strip_prefix('-') {
            Some(opposite) => (opposite == name).then_some(-1.0),
            None => (*p == name).then_some(1.0),
        })
    }

    /// A number greater than 0, though OpenSees takes any, by position.
    pub(crate) const fn usually_positive(name: &'static str, meaning: &'static str) -> Self {
        Self::of_domain(name, meaning, Domain::UsuallyPositive)
    }
}

/// Sentence about a command or a kind, meanings of its arguments, and a call of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// One sentence or two; empty for a kind that its name describes.
    pub about: &'static str,
    /// Arguments of its own.
    pub arguments: &'static [Arg],
    /// Further arguments, in groups that are read together or that related kinds share.
    pub groups: &'static [&'static [Arg]],
    /// Words that make a thing of the kind, where its usage alone does not lead to one; empty elsewhere.
    pub example: &'static str,
    /// Of a law with an envelope of points: names of force and deformation in OpenSees' `parameter`, each with that in the
    /// usage.
    pub points: Option<[[&'static str; 2]; 2]>,
    /// True if OpenSees does not have it.
    pub is_own: bool,
}

/// Sentence about a command that does nothing.
pub const WITHOUT_EFFECT: &str = "Accepted without effect.";

impl Text {
    /// Nothing but the name.
    pub(crate) const NONE: Self = Self::new("");

    pub(crate) const fn new(about: &'static str) -> Self {
        Self { about, arguments: &[], groups: &[], example: "", points: None, is_own: false }
    }

    /// The same text of a kind or a command that OpenSees does not have.
    pub(crate) const fn own(mut self) -> Self {
        self.is_own = true;
        self
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

    /// The same text with arguments in groups.
    pub(crate) const fn groups(mut self, groups: &'static [&'static [Arg]]) -> Self {
        self.groups = groups;
        self
    }

    /// The same text of a law whose points have other names in OpenSees' `parameter`.
    pub(crate) const fn points(mut self, names: [[&'static str; 2]; 2]) -> Self {
        self.points = Some(names);
        self
    }

    /// Names in the usage of the numbers that a name in OpenSees' `parameter` stands for, with their signs.
    pub(crate) fn numbers_of(&self, name: &str) -> Vec<(String, f64)> {
        let declared = self.all().filter_map(|arg| Some((arg.name.to_owned(), arg.sign_as(name)?)));
        declared.chain(self.points.iter().flat_map(|names| of_point(names, name))).collect()
    }

    /// All arguments.
    fn all(&self) -> impl Iterator<Item = &'static Arg> {
        self.arguments.iter().chain(self.groups.iter().copied().flatten())
    }

    /// The argument of this name, or the option alone.
    pub(crate) fn argument(&self, option: &str, name: &str) -> Option<&'static Arg> {
        find(self.all(), option, name)
    }
}

/// The numbers of a point of an envelope by their name: `mom2p` is `s2p`, and `mom2` is `s2p` and `s2n` with its sign.
fn of_point(names: &[[&str; 2]; 2], name: &str) -> Vec<(String, f64)> {
    let yield_force = format!("{}1p", names[0][0]);
    let name = if matches!(name, "fy" | "Fy") { &yield_force } else { name };
    let point = names.iter().find_map(|[stem, own]| Some((name.strip_prefix(stem)?, own)));
    match point {
        Some((of, own)) if of.ends_with(['p', 'n']) => vec![(format!("{own}{of}"), 1.0)],
        Some((of, own)) => vec![(format!("{own}{of}p"), 1.0), (format!("{own}{of}n"), -1.0)],
        None => vec![],
    }
}

/// The argument of this name in any command.
pub(crate) fn argument_of_any(option: &str, name: &str) -> Option<&'static Arg> {
    find(any_command::ANY_COMMAND, option, name)
}

fn find(arguments: impl IntoIterator<Item = &'static Arg>, option: &str, name: &str) -> Option<&'static Arg> {
    arguments.into_iter().find(|a| a.option == option && a.name == name)
}

#[cfg(test)]
mod tests {
    use super::Arg;

    /// Names of the arguments of a usage, in its order.
    fn names(usage: &str) -> Vec<&str> {
        let end = |rest: &str| rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        usage.split('$').skip(1).map(|rest| &rest[..end(rest)]).collect()
    }

    /// True if the numbers that are declared stand in a usage, in their order.
    fn are_in_order<'a>(arguments: impl Iterator<Item = &'a Arg>, usage: &str) -> bool {
        let mut names = names(usage).into_iter();
        arguments.filter(|a| a.domain.is_some() && a.option.is_empty()).all(|a| names.any(|n| n == a.name))
    }

    #[test]
    fn numbers_are_declared_in_the_order_of_the_usage() {
        let is_in_order = |kind: &crate::KindUsage| {
            let mut lists = kind.text.groups.iter().copied().chain([kind.text.arguments]);
            lists.all(|list| are_in_order(list.iter(), kind.usage))
        };
        // Further forms have orders of their own.
        let kinds = crate::commands().flat_map(crate::Command::kinds).filter(|k| !k.usage.contains(" or "));
        let wrong: Vec<&str> = kinds.filter(|k| !is_in_order(k)).map(|k| k.usage).collect();
        assert!(wrong.is_empty(), "{wrong:#?}");
        let [fy, e] = ["Fy", "E"].map(|name| Arg::number(name, ""));
        assert!(
            are_in_order([fy, e].iter(), "law $tag $Fy <$E>") && !are_in_order([e, fy].iter(), "law $tag $Fy <$E>")
        );
    }
}
