//! An `amend element` command of a script, taken apart.

use std::collections::BTreeMap;

/// The words of an `amend element` command.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Amendment {
    /// Tags of the elements.
    pub(super) tags: Vec<i32>,
    /// Kind of the amendment.
    pub(super) kind: String,
    /// Options with the words that follow them, as they are written.
    options: BTreeMap<String, Vec<String>>,
    /// Values of the added parameters, by the word `$name`.
    values: BTreeMap<String, f64>,
}

impl Amendment {
    /// The parts of a command; `None` if its tags are no numbers. `values` are those of the script's parameters by name.
    pub(super) fn parse(words: &[&str], values: &BTreeMap<String, f64>) -> Option<Self> {
        let rest = words.strip_prefix(&["amend", "element"])?;
        let tags: Vec<i32> = rest.iter().map_while(|w| w.parse().ok()).collect();
        let (kind, rest) = rest.get(tags.len()..)?.split_first()?;
        let mut out = Self { kind: (*kind).to_owned(), ..Self::default() };
        out.values = values.iter().map(|(name, v)| (format!("${name}"), *v)).collect();
        let mut option = None;
        for word in rest {
            if word.starts_with('-') && word[1..].starts_with(char::is_alphabetic) {
                out.options.insert((*word).to_owned(), vec![]);
                option = Some(*word);
            } else if let Some(values) = option.and_then(|o| out.options.get_mut(o)) {
                values.push((*word).to_owned());
            }
        }
        (!tags.is_empty()).then_some(Self { tags, ..out })
    }

    /// The same of one element.
    pub(super) fn of_element(&self, tag: i32) -> Self {
        Self { tags: vec![tag], ..self.clone() }
    }

    /// Returns true if the command has an option.
    pub(super) fn has(&self, option: &str) -> bool {
        self.options.contains_key(option)
    }

    /// Words of an option.
    pub(super) fn words(&self, option: &str) -> &[String] {
        self.options.get(option).map_or(&[], Vec::as_slice)
    }

    /// First word of an option, as it is written, or a default.
    pub(super) fn text(&self, option: &str, default: &str) -> String {
        self.words(option).first().map_or(default, String::as_str).to_owned()
    }

    /// Value of an option's first word, a number or a parameter; `None` where it is another expression.
    pub(super) fn number(&self, option: &str) -> Option<f64> {
        let word = self.words(option).first()?;
        word.parse().ok().or_else(|| self.values.get(word).copied())
    }

    /// Directions of option `-dir`.
    pub(super) fn directions(&self) -> Vec<usize> {
        self.words("-dir").iter().filter_map(|w| w.parse().ok()).collect()
    }

    /// The single direction, or a reason why two directions together have no standard form.
    pub(super) fn one_direction(&self, law: &str) -> Result<usize, String> {
        match self.directions()[..] {
            [one] => Ok(one),
            _ => Err(format!("{law} that acts in two directions together has no standard command in OpenSees")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Amendment;
    use std::collections::BTreeMap;

    #[test]
    fn tags_kind_and_options_are_taken_apart() {
        let words = ["amend", "element", "3", "4", "gap", "-at", "$hy_gap", "-side", "-1", "-dir", "1", "2"];
        let values = BTreeMap::from([("hy_gap".to_owned(), 0.3)]);
        let a = Amendment::parse(&words, &values).expect("an amendment");
        assert_eq!((&a.tags[..], a.kind.as_str(), a.directions()), (&[3, 4][..], "gap", vec![1, 2]));
        assert_eq!((a.number("-at"), a.number("-side"), a.text("-power", "1")), (Some(0.3), Some(-1.0), "1".into()));
        assert!(a.one_direction("contact").is_err() && Amendment::parse(&words[..2], &values).is_none());
    }
}
