//! Asks the commands themselves for the meaning of their arguments: a command from which a word is missing says what it
//! expected there, and one that is given a wrong word says what the word may be.

use super::script::{Ran, Script};
use super::usage::MatrixMask;
use hysteron::run::End;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Response of a command to its words.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// A word is missing; its meaning.
    Missing(String),
    /// A word is wrong: the message, and what was expected.
    Refused(String, String),
    /// Nothing: it took all of them.
    Taken,
}

/// A model in which nearly every command has what it needs, under tags from 1 on; `ndm` and `ndf` follow.
const PARTS: &str = "
uniaxialMaterial Elastic 1 1.; uniaxialMaterial Elastic 2 1.; uniaxialMaterial Elastic 3 1.; uniaxialMaterial Elastic 4 1.
frictionModel Coulomb 1 0.1; frictionModel Coulomb 2 0.1; frictionModel Coulomb 3 0.1
nDMaterial ElasticIsotropic 1 1. 0.2
timeSeries Linear 1; timeSeries Linear 2; pattern Plain 1 1 {}
parameter 1";

const SPACE: &str = "model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 0 0 1; node 3 1 0 0; node 4 1 0 1; fix 1 1 1 1 1 1 1
geomTransf Linear 1 1 0 0; section Elastic 1 1. 1. 1. 1. 1. 1.; section ElasticMembranePlateSection 1 1. 0.2 1.
uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 9 9 9 9 -dir 1 2 3 4 5 6; mass 2 1 1 1 1 1 1";

const PLANE: &str = "model basic -ndm 2 -ndf 3
node 1 0 0; node 2 0 1; node 3 1 0; node 4 1 1; fix 1 1 1 1
geomTransf Linear 1; section Elastic 1 1. 1. 1.
uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 9 -dir 1 2 3; mass 2 1 1 1";

const FLAT: &str = "model basic -ndm 2 -ndf 2
node 1 0 0; node 2 1 0; node 3 1 1; node 4 0 1; node 5 0.5 0; node 6 1 0.5; node 7 0.5 1; node 8 0 0.5; node 9 0.5 0.5; fix 1 1 1
section Elastic 1 1. 1. 1.; uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 -dir 1 2; mass 2 1 1";

const SOLID: &str = "model basic -ndm 3 -ndf 3
node 1 0 0 0; node 2 1 0 0; node 3 1 1 0; node 4 0 1 0; node 5 0 0 1; node 6 1 0 1; node 7 1 1 1; node 8 0 1 1; fix 1 1 1 1
node 11 0.5 0 0; node 12 0.5 0.5 0; node 13 0 0.5 0; node 14 0 0 0.5; node 15 0 0.5 0.5; node 16 0.5 0 0.5
section Elastic 1 1. 1. 1. 1. 1. 1.; uniaxialMaterial Elastic 9 1.; element zeroLength 1 1 2 -mat 9 9 -dir 1 2; mass 2 1 1 1";

/// The models in which a command is tried.
pub const MODELS: [&str; 4] = [SPACE, PLANE, FLAT, SOLID];

/// Words that may be right where one is wanted, the likeliest first.
const WORDS: &[&str] = &[
    "1",
    "2",
    "7",
    "0.5",
    "3",
    "-1",
    "-2",
    "100",
    "4",
    "1.5",
    "-1.5",
    "x",
    "P",
    "{1 2}",
    "on",
    "linear",
    "hold",
    "round",
    "HDR3",
    "disp",
    "force",
    "NormDispIncr",
    "X0.6",
    "{}",
];

/// Models after which the words of a command are tried.
pub fn say(model: &str, words: &[String]) -> Said {
    thread_local! {
        static ANSWERS: RefCell<BTreeMap<(String, Vec<String>), Said>> = const { RefCell::new(BTreeMap::new()) };
    }
    let key = (model.to_owned(), words.to_owned());
    if let Some(said) = ANSWERS.with(|a| a.borrow().get(&key).cloned()) {
        return said;
    }
    let said = said(&run(model, words));
    ANSWERS.with(|a| a.borrow_mut().insert(key, said.clone()));
    said
}

/// The model after the words of a command.
pub fn run(model: &str, words: &[String]) -> Ran {
    Script::default().run(&format!("{model}\n{PARTS}\n{}\n", words.join(" ")))
}

fn said(ran: &Ran) -> Said {
    match &ran.end {
        End::Rejected(d) | End::Raised(d) => {
            let what = d.message.split_once(": the ").and_then(|(_, m)| m.strip_suffix(" is missing"));
            match what {
                Some(what) => Said::Missing(what.to_owned()),
                None => Said::Refused(d.message.clone(), d.label.clone()),
            }
        }
        _ => match ran.warnings().iter().find_map(|d| taken_for(&d.message)) {
            Some(what) => Said::Missing(what.to_owned()),
            None => Said::Taken,
        },
    }
}

/// Meaning of a word that OpenSees has a default for where it is missing, from the warning.
fn taken_for(message: &str) -> Option<&str> {
    Some(message.split_once(": the ")?.1.split_once(" is missing and is taken for ")?.0)
}

/// True if the model was not made to its end.
pub fn ended_with_error(ran: &Ran) -> bool {
    matches!(ran.end, End::Rejected(_) | End::Raised(_))
}

/// The usage that a command shows for these words, and the names that may stand in the place of the last one.
pub fn help(model: &str, words: &[String]) -> (Option<String>, Vec<String>) {
    let ran = run(model, words);
    let (End::Rejected(d) | End::Raised(d)) = &ran.end else { return (None, vec![]) };
    let find = |head: &str| d.help.iter().find_map(|h| h.strip_prefix(head)).map(str::to_owned);
    let known = find("known: ").map(|k| k.split(' ').map(str::to_owned).collect());
    (find("usage: "), known.unwrap_or_default())
}

/// Meaning and kind of value of an argument.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Meaning {
    /// In the words of the command.
    pub what: String,
    /// For instance `number > 0`; empty if any word will do.
    pub value: String,
}

/// Meanings by the option that an argument follows (empty for none) and its name.
pub type Meanings = BTreeMap<(String, String), Meaning>;

/// Goes through the words of a usage, and keeps what the command says of each.
pub struct Walk<'a> {
    model: &'a str,
    /// Words taken so far.
    pub words: Vec<String>,
    option: String,
    pub found: Meanings,
}

impl<'a> Walk<'a> {
    pub fn new(model: &'a str, words: Vec<String>) -> Self {
        Self { model, words, option: String::new(), found: Meanings::new() }
    }

    /// Take required parts in their order; then the optional ones, each from where it stands.
    pub fn take(&mut self, parts: &[MatrixMask]) {
        let mut later: Vec<&[MatrixMask]> = vec![];
        for part in parts {
            match part {
                MatrixMask::Optional(inner) => later.push(inner),
                MatrixMask::Argument(name) => self.argument(name),
                MatrixMask::Word(word) => self.word(word),
                MatrixMask::Repeated | MatrixMask::Either => {}
            }
        }
        for inner in later {
            let (words, option) = (self.words.clone(), self.option.clone());
            self.take(inner);
            // Options are tried one by one; arguments by position need those before them.
            let by_position = matches!(inner.first(), Some(MatrixMask::Argument(_)));
            if !by_position || say(self.model, &self.words) != Said::Taken {
                (self.words, self.option) = (words, option);
            }
        }
    }

    /// A word as it is; of several (`a|b`) the first.
    fn word(&mut self, word: &str) {
        let first = word.split('|').next().unwrap_or(word);
        if first.starts_with('-') {
            self.option = first.to_owned();
        }
        self.words.push(first.to_owned());
    }

    fn with(&self, word: &str) -> Said {
        let mut words = self.words.clone();
        words.push(word.to_owned());
        say(self.model, &words)
    }

    fn argument(&mut self, name: &str) {
        let wrong = self.with("wrong!");
        let what = match say(self.model, &self.words) {
            Said::Missing(what) => Some(what),
            // An optional number is asked for only where a number stands.
            _ => match self.with("Inf") {
                Said::Refused(message, _) => message.strip_suffix(" is not finite").map(str::to_owned),
                _ => None,
            },
        };
        if let Some(what) = what {
            let label = match &wrong {
                Said::Refused(_, label) => label.clone(),
                _ => match self.with("Inf") {
                    Said::Refused(_, label) => label,
                    _ => String::new(),
                },
            };
            let value = value_of(&label, &what);
            let key = (self.option.clone(), name.to_owned());
            self.found.entry(key).or_insert(Meaning { what, value });
        }
        let word = self.right(&wrong);
        self.words.push(word.to_owned());
    }

    /// A word that may stand next: one with which the command goes on, or one that gets the refusal most words get, which
    /// is then not about the word.
    fn right(&self, wrong: &Said) -> &'static str {
        let mut refusals: BTreeMap<String, (usize, &'static str)> = BTreeMap::new();
        for word in WORDS {
            match self.with(word) {
                Said::Missing(_) | Said::Taken => return word,
                refused if refused == *wrong => {}
                Said::Refused(message, _) => refusals.entry(message).or_insert((0, word)).0 += 1,
            }
        }
        let most = refusals.into_values().max_by_key(|(n, _)| *n);
        most.map_or("1", |(_, word)| word)
    }
}

/// `number > 0` of "expected the yield stress, a number greater than 0".
fn value_of(label: &str, what: &str) -> String {
    let rest = label.strip_prefix(&format!("expected the {what}, ")).unwrap_or("");
    match rest {
        "a number" => "number",
        "a number greater than 0" => "number > 0",
        "a number not less than 0" => "number ≥ 0",
        "a whole number" => "whole number",
        other => other,
    }
    .to_owned()
}
