//! Commands on variables and lists without a call.

use super::super::ast::{Command, Script, Word, WordKind};
use super::super::core::Core;
use super::super::error::Exception;
use super::super::expr::Num;
use super::super::interp::Interp;
use super::super::value::{Rep, Value};
use super::super::vars::VarName;
use super::{Inline, literal};

impl<H> Interp<H> {
    #[inline(never)]
    pub(super) fn inline_set(
        &mut self,
        script: &Script,
        command: &Command,
        name: &VarName,
    ) -> Result<Value, Exception> {
        if let Some(Word { kind: WordKind::Script(inner), .. }) = command.words.get(2)
            && let Some(n) = self.core.bracket_number(inner)
        {
            self.core.tick()?;
            if self.core.set_number(name, n) {
                return Ok(n.into());
            }
        }
        let value = self.inline_word(script, command, 2)?;
        match self.core.assign(name, value.clone()) {
            Ok(()) => Ok(value),
            Err(e) => Err(self.inline_failed(e, script, command)),
        }
    }

    #[inline(never)]
    pub(super) fn inline_incr(
        &mut self,
        script: &Script,
        command: &Command,
        name: &VarName,
    ) -> Result<Value, Exception> {
        if command.words.len() == 2 {
            if let Some(sum) = self.core.increment(name, 1) {
                return Ok(sum);
            }
            return self.call_inlined(script, command, [0, 1].map(|i| literal(command, i).clone()));
        }
        let by = self.inline_word(script, command, 2)?;
        if let Rep::Int(by) = by.0
            && let Some(sum) = self.core.increment(name, by)
        {
            return Ok(sum);
        }
        self.call_inlined(script, command, [literal(command, 0).clone(), literal(command, 1).clone(), by])
    }

    #[inline(never)]
    pub(super) fn inline_lappend(
        &mut self,
        script: &Script,
        command: &Command,
        name: &VarName,
    ) -> Result<Value, Exception> {
        let item = self.inline_word(script, command, 2)?;
        if let Some(list) = self.core.push_item(name, &item) {
            return Ok(list);
        }
        self.call_inlined(script, command, [literal(command, 0).clone(), literal(command, 1).clone(), item])
    }

    #[inline(never)]
    pub(super) fn inline_append(
        &mut self,
        script: &Script,
        command: &Command,
        name: &VarName,
    ) -> Result<Value, Exception> {
        let value = if let Some(Word { kind: WordKind::Parts(parts), .. }) = command.words.get(2) {
            // The parts are put together in a buffer, which spares a text of their own.
            let mut text = self.core.take_buffer();
            let written = self.join_into(&script.unit, parts, &mut text);
            let appended = if written.is_ok() { self.core.append_text(name, &text) } else { None };
            let value = if appended.is_none() { Value::from(text.as_str()) } else { Value::EMPTY };
            self.core.give_buffer(text);
            if let Err(e) = written {
                return Err(self.control_failed(e, script, command));
            }
            if let Some(all) = appended {
                return Ok(all);
            }
            value
        } else {
            let value = self.inline_word(script, command, 2)?;
            if let Rep::Str(_) = value.0
                && let Some(all) = self.core.append_text(name, &value.as_str())
            {
                return Ok(all);
            }
            value
        };
        self.call_inlined(script, command, [literal(command, 0).clone(), literal(command, 1).clone(), value])
    }

    #[inline(never)]
    pub(super) fn inline_item(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        let list = self.inline_word(script, command, 1)?;
        let place = self.inline_word(script, command, 2)?;
        if let Rep::Int(at) = place.0
            && let Ok(at) = u32::try_from(at)
            && let Ok(items) = list.to_list()
        {
            return Ok(items.get(at as usize).cloned().unwrap_or_default());
        }
        self.call_inlined(script, command, [literal(command, 0).clone(), list, place])
    }

    #[inline(never)]
    pub(super) fn inline_length(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        let list = self.inline_word(script, command, 1)?;
        match list.to_list() {
            Ok(items) => Ok(Value::from(items.len())),
            Err(_) => self.call_inlined(script, command, [literal(command, 0).clone(), list]),
        }
    }

    #[inline(never)]
    pub(super) fn inline_characters(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        Ok(Value::from(self.inline_word(script, command, 2)?.char_count()))
    }
}

impl Core {
    /// The number that `[expr {...}]` gives; none where it must be run.
    #[inline]
    fn bracket_number(&self, script: &Script) -> Option<Num> {
        let [only] = &script.commands[..] else { return None };
        let Inline::Expr(expression) = &only.inline else { return None };
        let expr = expression.braced.get()?;
        if self.is_inlined(script, only) { self.number_of(expr, &[]) } else { None }
    }
}
