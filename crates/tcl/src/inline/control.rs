//! `if`, `while`, `for`, `foreach` and `return` without a call.

use std::rc::Rc;

use super::super::ast::{Command, Script};
use super::super::error::Exception;
use super::super::eval::script_of;
use super::super::expr::compile;
use super::super::interp::Interp;
use super::super::list::List;
use super::super::value::{Rep, Value};
use super::super::vars::VarName;
use super::{Body, Clause, Loop, Test, literal};
use crate::diagnostic::Span;

impl<H> Interp<H> {
    /// The truth of a condition.
    #[inline]
    fn inline_test(&mut self, script: &Script, command: &Command, test: &Test) -> Result<bool, Exception> {
        let truth = match test.expr.get() {
            Some(expr) => self.holds(expr),
            None => self.first_test(command, test),
        };
        truth.map_err(|e| {
            let span = command.words.get(test.word).and_then(|w| script.unit.span(w.start, w.end));
            self.control_failed(e.at(span, ""), script, command)
        })
    }

    #[cold]
    fn first_test(&mut self, command: &Command, test: &Test) -> Result<bool, Exception> {
        let value = literal(command, test.word);
        if let Rep::Int(_) = value.0 {
            return self.condition(value);
        }
        let expr = compile(value)?;
        self.holds(test.expr.get_or_init(|| expr))
    }

    /// Run a body; `what` is how `$errorInfo` calls it.
    #[inline]
    fn inline_body(&mut self, command: &Command, body: &Body, what: &str) -> Result<Value, Exception> {
        self.deeper(|interp| interp.nested_body(command, body, what))
    }

    /// As [`Interp::inline_body`], where the caller counts as a level.
    #[inline]
    fn nested_body(&mut self, command: &Command, body: &Body, what: &str) -> Result<Value, Exception> {
        let text = literal(command, body.word);
        let script = body.script.get_or_init(|| script_of(text));
        let compiled = std::mem::replace(&mut self.core.calls.compiled, true);
        let result = self.run_here(script);
        self.core.calls.compiled = compiled;
        result.map_err(|e| {
            let e = self.core.settle_place(e, None);
            self.core.trace_body(e, text, what)
        })
    }

    #[inline(never)]
    pub(super) fn inline_if(
        &mut self,
        script: &Script,
        command: &Command,
        clauses: &[Clause],
    ) -> Result<Value, Exception> {
        for Clause { test, body } in clauses {
            let what = match test {
                None => "\"if\" else script",
                Some(test) if self.inline_test(script, command, test)? => "\"if\" then script",
                Some(_) => continue,
            };
            return self.inline_body(command, body, what).map_err(|e| self.control_failed(e, script, command));
        }
        Ok(Value::EMPTY)
    }

    #[inline(never)]
    pub(super) fn inline_loop(&mut self, script: &Script, command: &Command, words: &Loop) -> Result<Value, Exception> {
        if let Some(start) = &words.start {
            let started = self.inline_body(command, start, "\"for\" initial command");
            started.map_err(|e| self.control_failed(e, script, command))?;
        }
        self.deeper(|interp| interp.turns(script, command, words))
    }

    /// The turns of a loop.
    fn turns(&mut self, script: &Script, command: &Command, words: &Loop) -> Result<Value, Exception> {
        let Loop { test, next, body, .. } = words;
        let what = if next.is_some() { "\"for\" body" } else { "\"while\" body" };
        while self.inline_test(script, command, test)? {
            let turn = self.core.tick().and_then(|()| self.turn(command, body, what));
            let goes_on = turn.and_then(|goes_on| match next {
                Some(next) if goes_on => match self.nested_body(command, next, "\"for\" loop-end command") {
                    Ok(_) => Ok(true),
                    Err(Exception::Break) => Ok(false),
                    Err(e) => Err(e),
                },
                _ => Ok(goes_on),
            });
            if !goes_on.map_err(|e| self.control_failed(e, script, command))? {
                break;
            }
        }
        Ok(Value::EMPTY)
    }

    /// Run the body of a loop once; false where it ends the loop.
    #[inline]
    fn turn(&mut self, command: &Command, body: &Body, what: &str) -> Result<bool, Exception> {
        match self.nested_body(command, body, what) {
            Ok(_) | Err(Exception::Continue) => Ok(true),
            Err(Exception::Break) => Ok(false),
            Err(e) => Err(e),
        }
    }

    #[inline(never)]
    pub(super) fn inline_foreach(
        &mut self,
        script: &Script,
        command: &Command,
        names: &[Rc<VarName>],
        body: &Body,
    ) -> Result<Value, Exception> {
        let list = self.inline_word(script, command, 2)?;
        let Ok(items) = list.to_list() else {
            let words = [0, 1].map(|i| literal(command, i).clone()).into_iter();
            return self.call_inlined(script, command, words.chain([list, literal(command, 3).clone()]));
        };
        drop(list);
        let place = command.words.get(1).and_then(|w| script.unit.span(w.start, w.end));
        let done = self.deeper(|interp| interp.each(command, (names, place), &items, body));
        done.map_err(|e| self.control_failed(e, script, command))
    }

    fn each(
        &mut self,
        command: &Command,
        (names, place): (&[Rc<VarName>], Option<Span>),
        items: &List,
        body: &Body,
    ) -> Result<Value, Exception> {
        for round in 0..items.len().div_ceil(names.len()) {
            self.core.tick()?;
            for (i, name) in names.iter().enumerate() {
                let value = items.get(round * names.len() + i).cloned().unwrap_or_default();
                self.core.assign(name, value).map_err(|e| e.at(place, ""))?;
            }
            if !self.turn(command, body, "\"foreach\" body")? {
                break;
            }
        }
        Ok(Value::EMPTY)
    }

    #[inline(never)]
    pub(super) fn inline_return(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        Err(Exception::Return(self.inline_word(script, command, 1)?))
    }
}
