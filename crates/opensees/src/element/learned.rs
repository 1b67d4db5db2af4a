//! `amend element $tag learned`: a law with memory, from words of the script or from a file.

use super::amended_place::Place;
use crate::args::Args;
use crate::load::series::series_of;
use crate::{Outcome, Tcl, finish, read_text};
use hysteron_engine::element::amendment::Amendment;
use hysteron_engine::element::amendment::learned::{LawOption, Learned, LearnedLaw, OptionError, Source};
use hysteron_engine::model::ElementId;
use hysteron_tcl::diagnostic::Span;
use hysteron_tcl::{Exception, Value};
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// Options that are not words of the law: a file, and the sources of its channels.
const FILE: &str = "-file";
const SERIES: &str = "-series";

/// Words of a law with their places in the script.
#[derive(Default)]
struct Words {
    options: Vec<LawOption>,
    /// Place of each option, then of its words.
    spans: Vec<Vec<Option<Span>>>,
    sources: Vec<Source>,
    place: Place,
    file: Option<(String, Option<Span>)>,
}

impl Words {
    fn take(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Self, Exception> {
        let mut w = Self::default();
        while let Some(option) = a.option() {
            if w.place.takes(interp, a, &option)? {
                continue;
            }
            match option.as_ref() {
                FILE => {
                    let name = a.word("file of the law")?.into_owned();
                    w.file = Some((name, a.last_span()));
                }
                SERIES => {
                    while a.left() > 0 && !a.at_option() {
                        if a.peek().is_some_and(|x| x == "axial") {
                            a.word("source")?;
                            w.sources.push(Source::Axial);
                        } else {
                            w.sources.push(Source::Series(series_of(interp, a)?));
                        }
                    }
                }
                name => {
                    let (mut words, mut spans) = (vec![], vec![a.last_span()]);
                    while a.left() > 0 && !a.at_option() {
                        words.push(a.word("word of the law")?.into_owned());
                        spans.push(a.last_span());
                    }
                    w.options.push(LawOption { name: name.to_owned(), words });
                    w.spans.push(spans);
                }
            }
        }
        Ok(w)
    }

    fn law(&self, interp: &mut Tcl, a: &Args<'_>) -> Result<LearnedLaw, Exception> {
        if let Some((name, span)) = &self.file {
            if let Some(o) = self.options.first() {
                let message = format!("{} stands beside {FILE}", o.name);
                return Err(a.refuse_at(self.spans[0][0], message, "the file has the whole law"));
            }
            let text = read_text(interp, name).map_err(|e| a.unreadable(*span, name, &e))?;
            return law_of_json(&text)
                .map_err(|e| a.refuse_at(*span, format!("\"{name}\": {e}"), "expected a learned law"));
        }
        LearnedLaw::of_options(&self.options).map_err(|e| {
            let spans = e.option.and_then(|i| self.spans.get(i));
            let span = spans.and_then(|s| s.get(e.word.map_or(0, |w| w + 1)).copied().flatten());
            let name = e.option.map_or("learned", |i| self.options[i].name.as_str());
            a.refuse_at(span.or_else(|| a.last_span()), format!("amend learned, {name}: {}", e.message), "")
        })
    }
}

/// `amend element $tag learned`.
pub(crate) fn learned(interp: &mut Tcl, a: &mut Args<'_>, elements: &[ElementId]) -> Outcome {
    let words = Words::take(interp, a)?;
    let law = words.law(interp, a)?;
    finish(interp, a)?;
    let law = Learned::new(law, words.sources.clone()).map_err(|e| {
        a.refuse(format!("amend learned: {}", e.0), "expected -series with a series or the word axial for each channel")
    })?;
    let law: Arc<dyn Amendment> = Arc::new(law);
    for id in elements {
        words.place.amend(interp, a, *id, &|_| law.clone())?;
    }
    Ok(Value::EMPTY)
}

/// A learned law as JSON: an option of the `amend` command by name, with a list of words, or a list of such lists.
pub fn law_to_json(law: &LearnedLaw) -> String {
    let number = |w: &String| w.parse::<f64>().map_or_else(|_| Json::from(w.as_str()), Json::from);
    let mut map = Map::new();
    for o in law.options() {
        let words = Json::Array(o.words.iter().map(number).collect());
        let list = map.entry(o.name.trim_start_matches('-')).or_insert_with(|| Json::Array(vec![]));
        if let Json::Array(list) = list {
            list.push(words);
        }
    }
    serde_json::to_string_pretty(&Json::Object(map)).unwrap_or_default()
}

/// The law of a text that [`law_to_json`] writes.
///
/// # Errors
/// No JSON of that form, or a law that is refused.
pub fn law_of_json(text: &str) -> Result<LearnedLaw, String> {
    let json: Json = serde_json::from_str(text).map_err(|e| e.to_string())?;
    let Json::Object(map) = json else { return Err("expected an object with the options of the law".into()) };
    let word = |w: &Json| match w {
        Json::String(s) => Ok(s.clone()),
        Json::Number(n) => Ok(n.as_f64().map_or_else(|| n.to_string(), |x| x.to_string())),
        _ => Err(format!("expected a word or a number in place of {w}")),
    };
    let mut options = vec![];
    for (name, lists) in &map {
        let Json::Array(lists) = lists else { return Err(format!("\"{name}\": expected a list")) };
        let is_nested = lists.iter().all(Json::is_array) && !lists.is_empty();
        let lists: Vec<&[Json]> =
            if is_nested { lists.iter().filter_map(Json::as_array).map(Vec::as_slice).collect() } else { vec![lists] };
        for list in lists {
            let words = list.iter().map(word).collect::<Result<_, _>>()?;
            options.push(LawOption { name: format!("-{name}"), words });
        }
    }
    LearnedLaw::of_options(&options).map_err(|OptionError { option, message, .. }| {
        option
            .map_or_else(|| message.clone(), |i| format!("\"{}\": {message}", options[i].name.trim_start_matches('-')))
    })
}

/// A learned law as words of the `amend` command, after `learned`.
pub fn law_to_words(law: &LearnedLaw) -> String {
    let option = |o: LawOption| [vec![o.name], o.words].concat().join(" ");
    law.options().into_iter().map(option).collect::<Vec<_>>().join(" ")
}
