//! Tables of the kinds of a family: one row a kind.

use crate::args::Args;
use crate::text::Text;
use hysteron_tcl::Exception;

/// A kind of a family, for instance `Steel01` of `uniaxialMaterial`: one row of the family's table.
pub(crate) struct Kind<F> {
    /// Names of the kind, the preferred one first.
    pub(crate) names: &'static [&'static str],
    /// Usage of the family's command with this kind.
    pub(crate) usage: &'static str,
    /// Its text in the reference.
    pub(crate) text: Text,
    /// The kind itself, or the function that makes it from the words after its name.
    pub(crate) make: F,
}

/// Names, usage and text of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KindUsage {
    /// Names of the kind, the preferred one first.
    pub names: &'static [&'static str],
    /// Usage of the family's command with this kind.
    pub usage: &'static str,
    /// Its text in the reference.
    pub text: Text,
}

impl<F> Kind<F> {
    /// A kind that its name describes.
    pub(crate) const fn named(names: &'static [&'static str], usage: &'static str, make: F) -> Self {
        Self { names, usage, text: Text::NONE, make }
    }

    /// Names, usage and text.
    pub(crate) fn described(&self) -> KindUsage {
        KindUsage { names: self.names, usage: self.usage, text: self.text }
    }
}

/// Names, usage and text of each kind of a table.
pub(crate) fn usages<F: 'static>(kinds: &'static [Kind<F>]) -> Vec<KindUsage> {
    kinds.iter().map(Kind::described).collect()
}

/// Take the name of a kind, and set the usage of that kind for the messages to come.
///
/// `what` names the word, `family` the thing that is made.
pub(crate) fn take<F: 'static>(
    args: &mut Args<'_>,
    what: &str,
    family: &str,
    kinds: impl Iterator<Item = &'static Kind<F>> + Clone,
) -> Result<&'static Kind<F>, Exception> {
    let name = args.word(what)?;
    let Some(kind) = kinds.clone().find(|k| k.names.contains(&name.as_ref())) else {
        return Err(args.unknown_kind(family, kinds.flat_map(|k| k.names.iter().copied())));
    };
    args.usage(kind.usage);
    Ok(kind)
}
