//! Calls of procedures.

use std::rc::Rc;

use super::command::{Param, Place, Proc};
use super::core::{CallSite, Callee, Core, Frame, NsId};
use super::error::{Exception, Returned};
use super::eval::script_of;
use super::interp::Interp;
use super::table::Table;
use super::text::Text;
use super::value::Value;
use super::vars::{Slot, VarName};
use crate::check::WRONG_ARGUMENTS;

impl Proc {
    /// A procedure from the words of `proc`.
    pub(crate) fn new(ns: NsId, params: &Value, body: &Value) -> Result<Proc, Exception> {
        let specs = params.to_list()?;
        let mut list = Vec::with_capacity(specs.len());
        for spec in specs.iter() {
            let fields = spec.to_list()?;
            let refuse =
                |message: String| Exception::coded(message, &["TCL", "OPERATION", "PROC", "FORMALARGUMENTFORMAT"]);
            let (param, default) = match &*fields {
                [param] => (param, None),
                [param, default] => (param, Some(default.clone())),
                [] => return Err(refuse("argument with no name".to_owned())),
                _ => return Err(refuse(format!("too many fields in argument specifier \"{spec}\""))),
            };
            let text = param.as_str();
            if text.is_empty() {
                return Err(refuse("argument with no name".to_owned()));
            }
            if text.ends_with(')') && text.contains('(') {
                return Err(refuse(format!("formal parameter \"{text}\" is an array element")));
            }
            if text.contains("::") {
                return Err(refuse(format!("formal parameter \"{text}\" is not a simple name")));
            }
            list.push(Param { name: VarName::simple(&text), default });
        }
        let variadic = list.last().is_some_and(|p| &*p.name.text == "args");
        let distinct = list.iter().enumerate().all(|(i, p)| list[..i].iter().all(|q| *q.name.tail != *p.name.tail));
        Ok(Proc { ns, params: list, variadic, distinct, body: body.clone(), script: script_of(body) })
    }

    /// The parameters as `wrong # args` shows them.
    fn usage(&self) -> String {
        let shown = self.params.iter().enumerate().map(|(i, p)| {
            let name = &*p.name.text;
            match &p.default {
                _ if self.variadic && i + 1 == self.params.len() => "?arg ...?".to_owned(),
                Some(_) => format!("?{name}?"),
                None => name.to_owned(),
            }
        });
        shown.collect::<Vec<_>>().join(" ")
    }
}

impl<H> Interp<H> {
    pub(crate) fn call_proc(
        &mut self,
        proc: &Rc<Proc>,
        argv: Vec<Value>,
        place: Option<Place<'_>>,
    ) -> Result<Value, Exception> {
        let name = |words: &[Value]| words.first().map_or_else(|| Text::from(""), Value::to_text);
        self.call_body(
            proc,
            argv,
            1,
            place,
            |words| quoted(&name(words)),
            |words, line| {
                let name = name(words);
                let shown: String = name.chars().take(60).collect();
                let dots = if name.chars().count() > 60 { "..." } else { "" };
                format!("procedure \"{shown}{dots}\" line {line}")
            },
        )
    }

    /// Call a procedure or lambda. `skip`: how many words stand before the arguments.
    pub(crate) fn call_body(
        &mut self,
        proc: &Rc<Proc>,
        argv: Vec<Value>,
        skip: usize,
        place: Option<Place<'_>>,
        shown: impl FnOnce(&[Value]) -> String,
        trace: impl FnOnce(&[Value], usize) -> String,
    ) -> Result<Value, Exception> {
        let mut vars = self.core.take_vars();
        if !bind(proc, argv.get(skip..).unwrap_or_default(), &mut vars) {
            self.core.give_vars(vars);
            let params = proc.usage();
            let blank = if params.is_empty() { "" } else { " " };
            let message = format!("wrong # args: should be \"{}{blank}{params}\"", shown(&argv));
            let span = place.and_then(|p| p.whole());
            let e = Exception::coded(message, &["TCL", "WRONGARGS"]).by(&WRONG_ARGUMENTS).at(span, "");
            return Err(self.failed(e, argv, place));
        }
        if let Err(e) = self.core.enter() {
            return Err(self.failed(e, argv, place));
        }
        let span = place.and_then(|p| p.whole()).or(self.core.calls.site);
        let caller = self.core.calls.active;
        let frame = Frame {
            ns: proc.ns,
            vars,
            is_proc: true,
            level: self.core.calls.frames[caller].level + 1,
            caller,
            words: argv,
        };
        let outer_site = self.core.calls.site;
        self.core.calls.sites.push(CallSite { what: Callee::Proc(self.core.calls.frames.len()), span });
        self.core.calls.frames.push(frame);
        self.core.calls.active = self.core.calls.frames.len() - 1;
        let compiled = std::mem::replace(&mut self.core.calls.compiled, true);
        let result = self.run(&proc.script);
        self.core.calls.compiled = compiled;
        let words = match self.core.calls.frames.pop() {
            Some(frame) => {
                self.core.give_vars(frame.vars);
                frame.words
            }
            None => vec![],
        };
        self.core.calls.active = caller;
        self.core.calls.sites.pop();
        self.core.calls.site = outer_site;
        self.core.calls.levels -= 1;
        let result = match result {
            Err(Exception::Return(value)) => Ok(value),
            Err(Exception::ReturnWith(returned)) => leave(*returned),
            Err(Exception::Break) => Err(outside_of_loop("break")),
            Err(Exception::Continue) => Err(outside_of_loop("continue")),
            other => other,
        };
        match result {
            Ok(value) => {
                self.core.give_words(words);
                match self.core.calls.tailcall.take() {
                    Some(argv) => self.eval_words(&argv),
                    None => Ok(value),
                }
            }
            Err(Exception::Error(e)) => {
                let body = proc.body.origin().map(|o| o.span(0, proc.body.as_str().len() as u32));
                let line = self.core.line_within(&e, body);
                let e = Exception::Error(e).trace(|_| trace(&words, line));
                let e = self.core.settle_place(e, place);
                let e = self.core.trace_command(e, place, Some(&words));
                self.core.give_words(words);
                Err(e)
            }
            Err(other) => {
                self.core.give_words(words);
                Err(other)
            }
        }
    }
}

/// Tcl's error for `break` and `continue` with no loop around them.
pub(crate) fn outside_of_loop(what: &str) -> Exception {
    Exception::coded(format!("invoked \"{what}\" outside of a loop"), &["TCL", "RESULT", "UNEXPECTED"])
}

fn quoted(name: &str) -> String {
    let mut out = String::new();
    super::list::write_element(&mut out, name, true);
    out
}

/// Outcome of a procedure after a `return` with options.
pub(crate) fn leave(mut returned: Returned) -> Result<Value, Exception> {
    if returned.level > 1 {
        returned.level -= 1;
        return Err(Exception::ReturnWith(Box::new(returned)));
    }
    finish(returned)
}

/// Outcome of a command once all levels are left.
pub(crate) fn finish(returned: Returned) -> Result<Value, Exception> {
    let Returned { value, code, options, .. } = returned;
    let result = Exception::from_code(code, value);
    result.map_err(|e| {
        e.map_error(|e| {
            for (key, value) in options {
                match &*key.as_str() {
                    "-errorcode" => e.error_code = Some(value),
                    "-errorinfo" => {
                        e.error_info = value.as_str().into_owned();
                        e.traced = false;
                    }
                    "-errorline" | "-errorstack" => {}
                    _ => e.options.push((key, value)),
                }
            }
        })
    })
}

/// Put the arguments of a call into variables; false if their number is wrong.
fn bind(proc: &Proc, args: &[Value], vars: &mut Table<Slot>) -> bool {
    let fixed = proc.params.len() - usize::from(proc.variadic);
    if args.len() > fixed && !proc.variadic {
        return false;
    }
    for (i, param) in proc.params.iter().enumerate() {
        let value = if proc.variadic && i == fixed {
            Value::list(args.get(fixed..).unwrap_or_default().iter().cloned())
        } else {
            match args.get(i).or(param.default.as_ref()) {
                Some(value) => value.clone(),
                None => return false,
            }
        };
        if proc.distinct {
            vars.push(param.name.tail.clone(), param.name.hash, Slot::Scalar(value));
            continue;
        }
        // Of two parameters with the same name the first counts.
        let slot = vars.entry_or(&param.name.tail, param.name.hash, Slot::default);
        if !slot.exists() {
            *slot = Slot::Scalar(value);
        }
    }
    true
}

impl Core {
    /// The frame that a level means (`1`, `#0`); none if the word is no level.
    pub(crate) fn find_level(&self, word: &str) -> Option<Result<usize, Exception>> {
        let bad = || Exception::coded(format!("bad level \"{word}\""), &["TCL", "LOOKUP", "LEVEL", word]);
        let here = self.frame().level;
        let target = match word.strip_prefix('#') {
            Some(absolute) => match absolute.parse::<usize>() {
                Ok(n) => n,
                Err(_) => return Some(Err(bad())),
            },
            None if word.starts_with(|c: char| c.is_ascii_digit()) => match word.parse::<usize>() {
                Ok(up) if up <= here => here - up,
                _ => return Some(Err(bad())),
            },
            None => return None,
        };
        Some(self.frame_at(target).ok_or_else(bad))
    }

    /// The frame of an absolute level.
    pub(crate) fn frame_at(&self, level: usize) -> Option<usize> {
        let mut at = self.calls.active;
        while self.calls.frames[at].level != level {
            if at == 0 {
                return None;
            }
            at = self.calls.frames[at].caller;
        }
        Some(at)
    }
}
