//! Commands made of sub-commands: those of the language, and those of a script's own (`namespace ensemble`).

use std::rc::Rc;

use super::command::{Call, CmdId, CoreFn, Imp, Place};
use super::core::{Core, NsId};
use super::error::Exception;
use super::interp::Interp;
use super::value::Value;
use crate::diagnostic;

/// Index of the sub-command that word 1 names or abbreviates.
pub(crate) fn choose_sub<'n>(
    call: &Call<'_>,
    names: impl Iterator<Item = &'n str> + Clone,
) -> Result<usize, Exception> {
    if call.len() < 2 {
        return Err(call.wrong_args(&format!("{} subcommand ?arg ...?", call.name())));
    }
    let word = call.arg(1).as_str();
    find(&word, names.clone()).ok_or_else(|| unknown(&word, names).at(call.span(1), "no such subcommand"))
}

fn find<'n>(word: &str, names: impl Iterator<Item = &'n str> + Clone) -> Option<usize> {
    if let Some(at) = names.clone().position(|n| n == word) {
        return Some(at);
    }
    let mut matches = names.enumerate().filter(|(_, n)| !word.is_empty() && n.starts_with(word));
    match (matches.next(), matches.next()) {
        (Some((at, _)), None) => Some(at),
        _ => None,
    }
}

/// `a`, `a, or b`, `a, b, or c`.
fn listed(names: &[&str]) -> String {
    match names {
        [most @ .., last] if !most.is_empty() => format!("{}, or {last}", most.join(", ")),
        names => names.concat(),
    }
}

fn unknown<'n>(word: &str, names: impl Iterator<Item = &'n str>) -> Exception {
    let names: Vec<&str> = names.collect();
    let message = format!("unknown or ambiguous subcommand \"{word}\": must be {}", listed(&names));
    let near = diagnostic::nearest(word, names.iter().copied()).map(str::to_owned);
    Exception::coded(message, &["TCL", "LOOKUP", "SUBCOMMAND", word]).suggest(word, near)
}

/// Pass a call on to the sub-command that its word 1 names.
pub(crate) fn dispatch(core: &mut Core, call: &Call<'_>, table: &[(&'static str, CoreFn)]) -> Result<Value, Exception> {
    let at = choose_sub(call, table.iter().map(|s| s.0))?;
    match table.get(at) {
        Some((_, function)) => function(core, call),
        None => Ok(Value::EMPTY),
    }
}

/// An ensemble of a script's own.
#[derive(Clone, Debug)]
pub(crate) struct Ensemble {
    pub(crate) ns: NsId,
    /// Sub-commands and what stands in their place; taken from the exports of the namespace where empty.
    pub(crate) map: Vec<(Value, Value)>,
    pub(crate) subcommands: Vec<Value>,
    pub(crate) prefixes: bool,
    pub(crate) unknown: Value,
}

impl Core {
    /// The sub-commands of an ensemble, in alphabetical order, with what stands in their place.
    pub(crate) fn ensemble_map(&self, ensemble: &Ensemble) -> Vec<(String, Value)> {
        let target = |name: &str| Value::list([Value::from(self.qualified(ensemble.ns, name))]);
        let mapped = |name: &str| ensemble.map.iter().find(|(k, _)| k.as_str() == name).map(|(_, v)| v.clone());
        let mut all: Vec<(String, Value)> = if !ensemble.subcommands.is_empty() {
            let names = ensemble.subcommands.iter().map(|v| v.as_str().into_owned());
            names.map(|n| (mapped(&n).unwrap_or_else(|| target(&n)), n)).map(|(v, n)| (n, v)).collect()
        } else if !ensemble.map.is_empty() {
            ensemble.map.iter().map(|(k, v)| (k.as_str().into_owned(), v.clone())).collect()
        } else {
            let ns = self.ns(ensemble.ns);
            let exported = |name: &str| ns.exports.iter().any(|p| super::glob::matches(p, name));
            let names = ns.commands.iter().map(|(k, _)| &**k).filter(|k| exported(k));
            names.map(|n| (n.to_owned(), target(n))).collect()
        };
        all.sort_by(|a, b| a.0.cmp(&b.0));
        all
    }
}

impl<H> Interp<H> {
    pub(crate) fn call_ensemble(
        &mut self,
        id: CmdId,
        ensemble: &Rc<Ensemble>,
        mut argv: Vec<Value>,
        place: Option<Place<'_>>,
    ) -> Result<Value, Exception> {
        let word = argv.get(1).map(|w| w.as_str().into_owned());
        let Some(word) = word else {
            let e = Call::new(&argv, place).usage(1, "subcommand ?arg ...?");
            return Err(self.failed(e, argv, place));
        };
        let map = self.core.ensemble_map(ensemble);
        let names = map.iter().map(|(n, _)| n.as_str());
        let found = match names.clone().position(|n| n == word) {
            Some(at) => Some(at),
            None if ensemble.prefixes => find(&word, names.clone()),
            None => None,
        };
        let target = match found.and_then(|at| map.get(at)) {
            Some((_, target)) => target.to_list()?,
            None if !ensemble.unknown.is_empty() => {
                let mut words = ensemble.unknown.to_list()?.to_vec();
                words.extend_from_slice(&argv);
                let target = self.eval_words(&words)?.to_list()?;
                if target.is_empty() {
                    // The handler may have made the sub-command known; this is the last try.
                    let now = self.core.ensemble_of(id).unwrap_or_else(|| ensemble.clone());
                    let last = Rc::new(Ensemble { unknown: Value::EMPTY, ..Ensemble::clone(&now) });
                    return self.call_ensemble(id, &last, argv, place);
                }
                target
            }
            None => {
                let e = if map.is_empty() {
                    let ns = self.core.ns(ensemble.ns).full.clone();
                    let text =
                        format!("unknown subcommand \"{word}\": namespace {} does not export any commands", &*ns);
                    Exception::coded(text, &["TCL", "LOOKUP", "SUBCOMMAND", &word])
                } else if ensemble.prefixes {
                    unknown(&word, names)
                } else {
                    let names: Vec<&str> = names.collect();
                    let text = format!("unknown subcommand \"{word}\": must be {}", listed(&names));
                    Exception::coded(text, &["TCL", "LOOKUP", "SUBCOMMAND", &word])
                };
                return Err(self.failed(e.at(place.and_then(|p| p.word(1)), "no such subcommand"), argv, place));
            }
        };
        let called = crate::list::join(&argv[..2]);
        let inner = crate::list::join(target.iter());
        argv.splice(0..2, target.iter().cloned());
        if let Err(e) = self.core.enter() {
            return Err(self.failed(e, argv, place));
        }
        let result = self.invoke_words(argv, place);
        self.core.calls.levels -= 1;
        // The message of a wrong number of words names the ensemble as it was called.
        result.map_err(|e| {
            e.map_error(|e| {
                let start = format!("wrong # args: should be \"{inner}");
                if let Some(rest) = e.result.as_str().strip_prefix(&start) {
                    let message = format!("wrong # args: should be \"{called}{rest}");
                    e.diagnostic.message.clone_from(&message);
                    e.result = Value::from(message);
                }
            })
        })
    }

    /// Call other words in place of the first.
    pub(crate) fn call_alias(
        &mut self,
        words: &[Value],
        mut argv: Vec<Value>,
        place: Option<Place<'_>>,
    ) -> Result<Value, Exception> {
        argv.splice(0..1, words.iter().cloned());
        if let Err(e) = self.core.enter() {
            return Err(self.failed(e, argv, place));
        }
        // The target is looked up in the global namespace.
        let found = words.first().and_then(|w| self.core.find_command_from(NsId::GLOBAL, &w.as_str()));
        let result = match found {
            Some(id) => self.invoke_command(id, argv, place),
            None => self.invoke(argv, None),
        };
        self.core.calls.levels -= 1;
        result
    }

    /// Call words that are no longer those of the script.
    fn invoke_words(&mut self, argv: Vec<Value>, place: Option<Place<'_>>) -> Result<Value, Exception> {
        let Some(name) = argv.first() else { return Ok(Value::EMPTY) };
        match self.core.find_command(&name.as_str()) {
            Some(id) => self.invoke_command(id, argv, place),
            None => self.invoke(argv, None),
        }
    }
}

impl Core {
    /// The ensemble behind a command, if it is one.
    pub(crate) fn ensemble_of(&self, id: CmdId) -> Option<Rc<Ensemble>> {
        match &self.table.commands[self.origin_of(id).0 as usize].imp {
            Imp::Ensemble(e) => Some(e.clone()),
            _ => None,
        }
    }
}
