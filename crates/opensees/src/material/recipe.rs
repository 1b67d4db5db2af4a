//! Parameters of every uniaxial material: the material is made again from its words with another number.

use super::{Kind, parameter_names};
use crate::Tcl;
use crate::args::{Args, number_names};
use crate::recipes::{OwnWord, as_refusal, with_definitions};
use hysteron_engine::analysis::Options;
use hysteron_engine::material::{Material, Recipe, SharedUniaxial};
use hysteron_engine::model::Definitions;
use hysteron_engine::parameter::ParameterError;
use hysteron_tcl::{Call, Exception, Value};
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
    /// Places of the numbers among the words, with their names, once they have been asked for.
    places: Arc<OnceLock<Vec<(usize, String)>>>,
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
            places: Arc::default(),
        }
    }

    /// The material of some words, and the names of its numbers with their places.
    fn make(&self, words: &[OwnWord]) -> Result<(Material, Vec<(usize, String)>), Exception> {
        let definitions = self.definitions.as_deref().cloned().unwrap_or_default();
        let texts: Vec<String> = words.iter().map(ToString::to_string).collect();
        with_definitions(&self.options, definitions, |interp| self.make_in(interp, &texts))
    }

    fn make_in(&self, interp: &mut Tcl, words: &[String]) -> Result<(Material, Vec<(usize, String)>), Exception> {
        let values: Vec<Value> = words.iter().map(|w| Value::from(w.as_str())).collect();
        let call = Call::of(&values).noting();
        let mut args = Args::new(&call, self.kind.usage);
        args.skip_to(FIRST);
        let material = (self.kind.make)(interp, &mut args)?;
        Ok((material, number_names(self.kind.usage, words, &call.notes().numbers)))
    }

    /// Places of the numbers among the words, with their names.
    fn places(&self) -> &[(usize, String)] {
        // These words have made the material before.
        self.places.get_or_init(|| self.make(&self.words).map_or_else(|_| vec![], |(_, names)| names))
    }

    /// Places of the numbers that a name stands for, with their signs.
    fn places_of(&self, name: &str) -> Vec<(usize, f64)> {
        let places = self.places();
        let place = |name: &str| places.iter().find(|(_, n)| n == name).map(|(i, _)| *i);
        if let Some(i) = place(name) {
            return vec![(i, 1.0)];
        }
        let others = parameter_names::numbers_of(self.kind.names[0], name);
        others.into_iter().filter_map(|(number, sign)| Some((place(&number)?, sign))).collect()
    }
}

impl fmt::Debug for WordsOfMaterial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.words.iter().enumerate().try_for_each(|(i, word)| write!(f, "{}{word}", if i > 0 { " " } else { "" }))
    }
}

impl Recipe for WordsOfMaterial {
    fn numbers(&self) -> Vec<(String, f64)> {
        self.places().iter().filter_map(|(i, name)| Some((name.clone(), self.words[*i].number()?))).collect()
    }

    fn number(&self, name: &str) -> Option<f64> {
        let (place, sign) = *self.places_of(name).first()?;
        self.words[place].number().map(|x| sign * x)
    }

    fn with_number(&self, name: &str, value: f64) -> Result<(SharedUniaxial, Arc<dyn Recipe>), ParameterError> {
        let places = self.places_of(name);
        if places.is_empty() {
            return Err(ParameterError::Unknown);
        }
        let mut words = self.words.clone();
        places.into_iter().for_each(|(place, sign)| words[place] = OwnWord::Double(sign * value));
        let (material, _) = self.make(&words).map_err(as_refusal)?;
        let (definitions, places) = (self.definitions.clone(), self.places.clone());
        let recipe = Self { kind: self.kind, words, definitions, options: self.options.clone(), places };
        Ok((material.law().clone(), Arc::new(recipe)))
    }
}
