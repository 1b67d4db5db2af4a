//! Parameters of every element between two nodes: the element is made again from its words with another number.

use super::{Ends, KINDS, Make};
use crate::Tcl;
use crate::args::{Args, number_names};
use crate::recipes::{WordsOfElement, as_refusal, in_scratch};
use crate::text::Domain;
use hysteron_engine::element::Element;
use hysteron_engine::model::Tag;
use hysteron_engine::parameter::{Changed, NewValue, ParameterError};
use hysteron_tcl::{Call, Value};
use std::sync::Arc;

/// Word of `element` that follows its tag.
const FIRST: usize = 3;

/// An element with one number changed.
struct ChangedElement {
    element: Arc<dyn Element>,
    /// Value of the number before.
    before: f64,
    /// Words that it is made from now.
    words: Vec<String>,
}

/// An element, and the places of its numbers among the words with their names.
type NumberedElement = (Arc<dyn Element>, Vec<(usize, String)>);

/// The words that an element has been made from.
pub(super) fn words_of(call: &Call<'_>, ends: &Ends, made: &Arc<dyn Element>) -> WordsOfElement {
    let words = (0..call.len()).map(|i| call.arg(i).clone()).collect();
    WordsOfElement { words, disp: ends.disp.clone(), made: made.clone(), changes: vec![] }
}

/// The element of some words in the model of the session.
fn make(recipe: &WordsOfElement, interp: &mut Tcl, words: &[String]) -> Result<NumberedElement, ParameterError> {
    let kind = KINDS.iter().find(|k| k.names.contains(&words[1].as_str())).ok_or(ParameterError::Unknown)?;
    let Make::TwoNodes(make) = &kind.make else { return Err(ParameterError::Unknown) };
    let values: Vec<Value> = words.iter().map(|w| Value::from(w.as_str())).collect();
    let call = Call::of(&values).noting();
    let mut args = Args::new(&call, kind.usage);
    args.skip_to(FIRST);
    let mut made = || {
        let ends = Ends { disp: recipe.disp.clone(), ..Ends::take(interp, &mut args)? };
        make(interp, &mut args, &ends)
    };
    let mut element = made().map_err(as_refusal)?;
    for (words, value) in &recipe.changes {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        element = element.with_parameter(&words, *value)?.0;
    }
    let names = number_names(kind.usage, words, &call.notes().numbers);
    Ok((element, names))
}

/// An element with a new value of a parameter, and the value before: of the element itself, or of a number among the
/// words that it was made from. No value asks for the present one.
pub(crate) fn with_parameter(interp: &mut Tcl, tag: Tag, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
    let model = interp.host.engine.model();
    let element = model.element(tag).map(|id| model.elements[id.0].element.clone()).ok_or(ParameterError::Unknown)?;
    match element.with_parameter(words, value) {
        Err(ParameterError::Unknown) => {
            made_again(interp, tag, &element, words, value).map(|made| (made.element, made.before))
        }
        changed => changed,
    }
}

/// As [`with_parameter`], and puts the element in its place.
pub(crate) fn set_parameter(interp: &mut Tcl, tag: Tag, words: &[&str], value: NewValue) {
    let model = interp.host.engine.model();
    let Some(id) = model.element(tag) else { return };
    let element = model.elements[id.0].element.clone();
    let (new, words_now) = match element.with_parameter(words, value) {
        Err(ParameterError::Unknown) => match made_again(interp, tag, &element, words, value) {
            Ok(made) => (made.element, Some(made.words)),
            Err(_) => return,
        },
        Ok((new, _)) => (new, None),
        Err(_) => return,
    };
    if let Some(recipe) = interp.host.builder.element_words.get_mut(&tag).filter(|r| Arc::ptr_eq(&r.made, &element)) {
        recipe.made = new.clone();
        match words_now {
            Some(texts) => recipe.words = texts.iter().map(|w| Value::from(w.as_str())).collect(),
            None => recipe.changes.push((words.iter().map(|w| (*w).to_owned()).collect(), value)),
        }
    }
    interp.host.engine.change_model(|model| model.replace_elements([(id, new)]));
}

/// Numbers that an element between two nodes was made from: places among the words of its command, and names.
pub fn numbers_of_element(interp: &mut Tcl, tag: Tag) -> Vec<(usize, String)> {
    let Some(recipe) = interp.host.builder.element_words.remove(&tag) else { return vec![] };
    let made = in_scratch(interp, |interp| make(&recipe, interp, &recipe.texts()));
    interp.host.builder.element_words.insert(tag, recipe);
    made.map_or_else(|_| vec![], |(_, names)| names)
}

/// Domain of a number of an element's own, as its kind declares it.
pub(crate) fn domain_of(interp: &Tcl, tag: Tag, words: &[String]) -> Option<Domain> {
    let ([name], Some(recipe)) = (words, interp.host.builder.element_words.get(&tag)) else { return None };
    let kind = recipe.words.get(1)?.as_str();
    KINDS.iter().find(|k| k.names.contains(&kind.as_ref()))?.text.argument("", name)?.domain
}

/// The element made again with another value of a number of its words.
fn made_again(
    interp: &mut Tcl,
    tag: Tag,
    element: &Arc<dyn Element>,
    words: &[&str],
    value: NewValue,
) -> Result<ChangedElement, ParameterError> {
    let Some(recipe) = interp.host.builder.element_words.remove(&tag) else { return Err(ParameterError::Unknown) };
    let made = if Arc::ptr_eq(&recipe.made, element) {
        in_scratch(interp, |interp| of_recipe(&recipe, interp, &words.join(" "), value))
    } else {
        Err(ParameterError::Unknown)
    };
    interp.host.builder.element_words.insert(tag, recipe);
    made
}

fn of_recipe(
    recipe: &WordsOfElement,
    interp: &mut Tcl,
    name: &str,
    value: NewValue,
) -> Result<ChangedElement, ParameterError> {
    let mut words = recipe.texts();
    let (element, names) = make(recipe, interp, &words)?;
    let place = names.iter().find(|(_, n)| n == name).map(|(i, _)| *i).ok_or(ParameterError::Unknown)?;
    let before = Value::from(words[place].as_str()).as_f64().ok_or(ParameterError::Unknown)?;
    let Some(value) = value.instead_of(before) else { return Ok(ChangedElement { element, before, words }) };
    words[place] = format!("{value:e}");
    let (new, _) = make(recipe, interp, &words)?;
    if new.state_len() != element.state_len() || new.dofs() != element.dofs() {
        return Err(ParameterError::Refused(format!("it keeps another number of state variables with {name}")));
    }
    Ok(ChangedElement { element: new, before, words })
}
