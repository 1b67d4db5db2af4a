//! Parameters of every uniaxial material: the material is made again from its words with another number.

use super::Kind;
use crate::Tcl;
use crate::args::{Args, number_names};
use crate::recipes::{OwnWord, as_refusal, with_definitions};
use hysteron_engine::analysis::Options;
use hysteron_engine::material::{Material, Recipe, SharedUniaxial};
use hysteron_engine::model::Definitions;
use hysteron_engine::parameter::ParameterError;
use hysteron_tcl::{Call, CallNotes, Exception, Value};
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Word of `uniaxialMaterial` that follows its tag.
const FIRST: usize = 3;

/// The words that a material was made from.
pub(super) struct WordsOfMaterial {
    kind: &'static Kind,
    /// Words of the call, the name of the command being the first.
    words: Vec<OwnWord>,
    /// Definitions that the words name.
    definitions: Option<Box<Definitions>>,
    /// Options of the session: the law may follow OpenSees where it errs.
    options: Options,
    /// The numbers, once they have been asked for.
    numbers: OnceLock<Numbers>,
}

/// The words of a material with the numbers that were left out, and the places of all numbers with their names.
#[derive(Default)]
struct Numbers {
    words: Vec<OwnWord>,
    places: Vec<(usize, String)>,
}

impl Numbers {
    /// Places of the numbers that a name stands for, with their signs: the name in the usage line, and OpenSees' name.
    fn places_of(&self, kind: &Kind, name: &str) -> Vec<(usize, f64)> {
        let names = std::iter::once((name.to_owned(), 1.0)).chain(kind.text.numbers_of(name));
        let place = |name: &String| self.places.iter().find(|(_, n)| n == name).map(|(i, _)| *i);
        names.filter_map(|(number, sign)| Some((place(&number)?, sign))).collect()
    }
}

impl WordsOfMaterial {
    /// The words of a call that has made a material.
    pub(super) fn of(interp: &Tcl, kind: &'static Kind, call: &Call<'_>, args: &Args<'_>) -> Self {
        let definitions = &interp.host.builder.definitions;
        Self {
            kind,
            words: (0..call.len()).map(|i| OwnWord::of(call.arg(i))).collect(),
            definitions: (!args.taken.is_empty()).then(|| Box::new(definitions.only(&args.taken))),
            options: interp.host.engine.options.clone(),
            numbers: OnceLock::new(),
        }
    }

    /// The material of some words, and notes about them.
    fn make(&self, words: &[OwnWord]) -> Result<(Material, CallNotes), Exception> {
        let definitions = self.definitions.as_deref().cloned().unwrap_or_default();
        let values: Vec<Value> = words.iter().map(|w| Value::from(w.to_string().as_str())).collect();
        with_definitions(&self.options, definitions, |interp| {
            let call = Call::of(&values).noting();
            let mut args = Args::new(&call, self.kind.usage);
            args.skip_to(FIRST);
            Ok(((self.kind.make)(interp, &mut args)?, call.notes()))
        })
    }

    fn numbered(&self) -> &Numbers {
        // These words have made the material before.
        self.numbers.get_or_init(|| self.number_words().unwrap_or_default())
    }

    fn number_words(&self) -> Result<Numbers, Exception> {
        let (mut words, mut notes) = (self.words.clone(), self.make(&self.words)?.1);
        if !notes.omitted.is_empty() {
            notes.omitted.iter().rev().for_each(|(at, value)| words.insert(*at, OwnWord::Double(*value)));
            notes = self.make(&words)?.1;
        }
        let texts: Vec<String> = words.iter().map(ToString::to_string).collect();
        let places = number_names(self.kind.usage, &texts, &notes.numbers);
        Ok(Numbers { words, places })
    }
}

impl fmt::Debug for WordsOfMaterial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.words.iter().enumerate().try_for_each(|(i, word)| write!(f, "{}{word}", if i > 0 { " " } else { "" }))
    }
}

impl Recipe for WordsOfMaterial {
    fn numbers(&self) -> Vec<(String, f64)> {
        let Numbers { words, places } = self.numbered();
        places.iter().filter_map(|(i, name)| Some((name.clone(), words[*i].number()?))).collect()
    }

    fn number(&self, name: &str) -> Option<f64> {
        let numbers = self.numbered();
        let (place, sign) = *numbers.places_of(self.kind, name).first()?;
        numbers.words[place].number().map(|x| sign * x)
    }

    fn with_number(&self, name: &str, value: f64) -> Result<(SharedUniaxial, Arc<dyn Recipe>), ParameterError> {
        let Numbers { words, places } = self.numbered();
        let changed = self.numbered().places_of(self.kind, name);
        if changed.is_empty() {
            return Err(ParameterError::Unknown);
        }
        let mut words = words.clone();
        changed.into_iter().for_each(|(place, sign)| words[place] = OwnWord::Double(sign * value));
        let (material, _) = self.make(&words).map_err(as_refusal)?;
        let (definitions, options) = (self.definitions.clone(), self.options.clone());
        let numbers = Numbers { words: words.clone(), places: places.clone() };
        let recipe = Self { kind: self.kind, words, definitions, options, numbers: OnceLock::from(numbers) };
        Ok((material.law().clone(), Arc::new(recipe)))
    }
}
