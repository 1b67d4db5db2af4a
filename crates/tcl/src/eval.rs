//! Running parsed scripts.

use std::rc::Rc;

use super::ast::{Command, Found, Index, ParseError, Part, Script, Unit, VarRef, WordKind};
use super::command::{Call, CmdId, Imp, Place};
use super::core::Core;
use super::error::{Exception, ScriptError};
use super::interp::Interp;
use super::lexer;
use super::list::List;
use super::number::plain_int;
use super::stack;
use super::text::Cache;
use super::value::{Rep, Value};
use crate::check::{NEVER_CLOSED, UNKNOWN_COMMAND};
use crate::diagnostic::{Absent, COMMAND, Span};

/// Limit of nested calls, as in Tcl.
pub(crate) const MAX_LEVELS: usize = 1000;
/// Limit of nested scripts. A call takes several, for instance one for an `if` in it.
const MAX_DEPTH: usize = 20_000;

/// Tcl's error for calls without end.
pub(crate) fn too_deep() -> Exception {
    Exception::coded("too many nested evaluations (infinite loop?)", &["TCL", "LIMIT", "STACK"])
}

impl Core {
    /// Count a call; the caller subtracts it from `levels` at its end.
    pub(crate) fn enter(&mut self) -> Result<(), Exception> {
        if self.calls.levels >= MAX_LEVELS {
            return Err(too_deep());
        }
        self.calls.levels += 1;
        Ok(())
    }
}

/// The parsed form of a value.
pub(crate) fn script_of(value: &Value) -> Rc<Script> {
    let obj = value.str_obj();
    if let Some(script) = obj.cached(|c| if let Cache::Script(s) = c { Some(s.clone()) } else { None }) {
        return script;
    }
    let unit = Rc::new(Unit { text: obj.stretch(), origin: value.origin().cloned() });
    let script = Rc::new(lexer::script(&unit));
    obj.set_cache(Cache::Script(script.clone()));
    script
}

impl<H> Interp<H> {
    /// Evaluate a value as a script.
    pub(crate) fn eval_body(&mut self, body: &Value) -> Result<Value, Exception> {
        if let Rep::List(list) = &body.0 {
            // A list that never was a text is one command: nothing is to be parsed.
            return self.eval_words(&List(list.clone()));
        }
        let script = script_of(body);
        self.run(&script)
    }

    /// Evaluate a list as one command.
    pub(crate) fn eval_words(&mut self, words: &[Value]) -> Result<Value, Exception> {
        if words.is_empty() {
            return Ok(Value::EMPTY);
        }
        let mut argv = self.core.take_words();
        argv.extend_from_slice(words);
        self.core.tick()?;
        self.deeper(|interp| interp.invoke(argv, None))
    }

    #[inline]
    pub(crate) fn deeper<R>(&mut self, work: impl FnOnce(&mut Self) -> Result<R, Exception>) -> Result<R, Exception> {
        if self.core.calls.depth >= MAX_DEPTH {
            return Err(too_deep());
        }
        self.core.calls.depth += 1;
        let result = stack::grow(|| work(self));
        self.core.calls.depth -= 1;
        result
    }

    /// Run the commands of a script; the result is that of the last one.
    pub(crate) fn run(&mut self, script: &Script) -> Result<Value, Exception> {
        self.deeper(|interp| interp.run_here(script))
    }

    /// As [`Interp::run`], for a script that is not nested deeper than what called it, such as the body of a loop.
    #[inline]
    pub(crate) fn run_here(&mut self, script: &Script) -> Result<Value, Exception> {
        let Some((last, before)) = script.commands.split_last() else { return self.end_of(script, Value::EMPTY) };
        // Drop intermediate results at once: a second owner of a list makes its next change copy it.
        for command in before {
            self.command_or_on(script, command)?;
        }
        let result = self.command_or_on(script, last)?;
        self.end_of(script, result)
    }

    /// The result of a script, whose commands have run.
    #[inline]
    fn end_of(&self, script: &Script, result: Value) -> Result<Value, Exception> {
        match &script.error {
            None => Ok(result),
            Some(error) => Err(self.core.syntax_error(script, error)),
        }
    }

    /// Run a command. An error at top level goes to the host's handler, if it has one.
    fn command_or_on(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        match self.command(script, command) {
            Err(e @ Exception::Error(_)) => self.failed_at_level(e),
            result => result,
        }
    }

    #[cold]
    fn failed_at_level(&mut self, e: Exception) -> Result<Value, Exception> {
        match self.on_error {
            Some(handle) if self.core.calls.depth == 1 => handle(self, e),
            _ => Err(e),
        }
    }

    #[inline]
    fn command(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        self.core.tick()?;
        match self.core.is_inlined(script, command) {
            true => self.inlined(script, command),
            false => self.call_command(script, command),
        }
    }

    /// Run a command by a call.
    #[inline(never)]
    pub(crate) fn call_command(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        let mut argv = self.core.take_words();
        let mut map: Option<Vec<u32>> = None;
        for (i, word) in command.words.iter().enumerate() {
            let value = match &word.kind {
                WordKind::Literal(v) => Ok(v.clone()),
                kind => self.word(script, kind),
            };
            let value = match value {
                Ok(v) => v,
                Err(e) => return Err(self.word_failed(e, script, command, argv)),
            };
            if word.expand {
                let map = map.get_or_insert_with(|| (0..i as u32).collect());
                match value.to_list() {
                    Ok(list) => {
                        map.extend(std::iter::repeat_n(i as u32, list.len()));
                        argv.extend_from_slice(&list);
                    }
                    Err(e) => {
                        let e = e.at(script.unit.span(word.start, word.end), "");
                        return Err(self.word_failed(e, script, command, argv));
                    }
                }
            } else {
                if let Some(map) = &mut map {
                    map.push(i as u32);
                }
                argv.push(value);
            }
        }
        if argv.is_empty() {
            self.core.give_words(argv);
            return Ok(Value::EMPTY);
        }
        self.invoke(argv, Some(Place { script, command, map: map.as_deref() }))
    }

    fn word_failed(&mut self, e: Exception, script: &Script, command: &Command, argv: Vec<Value>) -> Exception {
        self.core.give_words(argv);
        self.control_failed(e, script, command)
    }

    /// The result of a command in brackets.
    fn bracket(&mut self, script: &Script) -> Result<Value, Exception> {
        match &script.commands[..] {
            [only] if only.is_flat => self.command(script, only),
            // In brackets nothing is left open.
            [only] => self.deeper(|interp| interp.command(script, only)),
            _ => self.run(script),
        }
    }

    /// The value of a word.
    pub(crate) fn word(&mut self, script: &Script, kind: &WordKind) -> Result<Value, Exception> {
        match kind {
            WordKind::Literal(v) => Ok(v.clone()),
            WordKind::Var(var) => self.variable(&script.unit, var),
            WordKind::Script(script) => self.bracket(script),
            WordKind::Parts(parts) => self.joined(&script.unit, parts),
        }
    }

    /// The value of `$name` or `$name(index)`.
    pub(crate) fn variable(&mut self, unit: &Unit, var: &VarRef) -> Result<Value, Exception> {
        let result = match &var.index {
            None => match self.core.scalar(&var.name) {
                Some(value) => return Ok(value.clone()),
                None => self.core.read(&var.name, None),
            },
            Some(Index::Text(index)) => self.core.read(&var.name, Some(index)),
            Some(Index::Parts(parts)) => match &**parts {
                [Part::Var(v)] => {
                    let index = self.variable(unit, v)?;
                    self.core.read(&var.name, Some(&index.as_str()))
                }
                parts => {
                    let index = self.join(unit, parts)?;
                    self.core.read(&var.name, Some(&index))
                }
            },
        };
        result.map_err(|e| e.at(unit.span(var.start, var.end), ""))
    }

    /// The value whose text several parts are. Tags and the like, which are integers, become so at once.
    fn joined(&mut self, unit: &Unit, parts: &[Part]) -> Result<Value, Exception> {
        let mut text = self.core.take_buffer();
        let written = self.join_into(unit, parts, &mut text);
        let value = match plain_int(&text) {
            Some(i) => Value::from(i),
            None => Value::from(text.as_str()),
        };
        self.core.give_buffer(text);
        written.map(|()| value)
    }

    /// The text of several parts.
    pub(crate) fn join(&mut self, unit: &Unit, parts: &[Part]) -> Result<String, Exception> {
        let mut text = String::new();
        self.join_into(unit, parts, &mut text)?;
        Ok(text)
    }

    pub(crate) fn join_into(&mut self, unit: &Unit, parts: &[Part], text: &mut String) -> Result<(), Exception> {
        for part in parts {
            match part {
                Part::Text(t) => text.push_str(t),
                Part::Var(v) => match self.core.scalar(&v.name) {
                    Some(value) if v.index.is_none() => value.write_to(text),
                    _ => self.variable(unit, v)?.write_to(text),
                },
                Part::Script(s) => self.bracket(s)?.write_to(text),
            }
        }
        Ok(())
    }

    /// Call the command that the first of some words names.
    pub(crate) fn invoke(&mut self, argv: Vec<Value>, place: Option<Place<'_>>) -> Result<Value, Exception> {
        let Some(id) = self.core.lookup(&argv, place) else { return self.unknown(argv, place) };
        self.invoke_command(id, argv, place)
    }

    pub(crate) fn invoke_command(
        &mut self,
        id: CmdId,
        argv: Vec<Value>,
        place: Option<Place<'_>>,
    ) -> Result<Value, Exception> {
        let result = match &self.core.table.commands[id.0 as usize].imp {
            Imp::Core(function) => function(&mut self.core, &Call::new(&argv, place)),
            Imp::Full(number) => {
                let number = *number;
                let outer = self.core.calls.site;
                if let Some(span) = place.and_then(|p| p.whole()) {
                    self.core.calls.site = Some(span);
                }
                let result = self.call_numbered(number, &Call::new(&argv, place));
                self.core.calls.site = outer;
                result
            }
            Imp::Proc(proc) => {
                let proc = proc.clone();
                return self.call_proc(&proc, argv, place);
            }
            Imp::Import(of) => {
                let of = *of;
                return self.invoke_command(of, argv, place);
            }
            Imp::Ensemble(ensemble) => {
                let ensemble = ensemble.clone();
                return self.deeper(|interp| interp.call_ensemble(id, &ensemble, argv, place));
            }
            Imp::Alias(words) => {
                let words = words.clone();
                return self.deeper(|interp| interp.call_alias(&words, argv, place));
            }
            Imp::Deleted => return self.unknown(argv, place),
        };
        match result {
            Ok(value) => {
                self.core.give_words(argv);
                Ok(value)
            }
            Err(e) => Err(self.failed(e, argv, place)),
        }
    }

    /// Complete an error with where it happened.
    pub(crate) fn failed(&mut self, e: Exception, argv: Vec<Value>, place: Option<Place<'_>>) -> Exception {
        if !matches!(e, Exception::Error(_)) {
            if matches!(e, Exception::Interrupted) && self.core.stopped_at.is_none() {
                self.core.stopped_at = place.and_then(|p| p.whole());
            }
            self.core.give_words(argv);
            return e;
        }
        let e = self.core.blame(e, &argv, place);
        let e = self.core.settle_place(e, place);
        let e = self.core.trace_command(e, place, Some(&argv));
        self.core.give_words(argv);
        e
    }

    /// No command has this name: give it to the script's own `unknown`, if there is one.
    fn unknown(&mut self, mut argv: Vec<Value>, place: Option<Place<'_>>) -> Result<Value, Exception> {
        let ns = self.core.here();
        let handler = self.core.ns(ns).unknown.clone();
        if !handler.is_empty() {
            let prefix = handler.to_list()?;
            argv.splice(0..0, prefix.iter().cloned());
            return self.deeper(|interp| interp.invoke(argv, place));
        }
        if let Some(id) = self.core.find_command("::unknown") {
            argv.insert(0, Value::from("unknown"));
            return self.deeper(|interp| interp.invoke_command(id, argv, place));
        }
        let name = argv.first().map(|v| v.as_str().into_owned()).unwrap_or_default();
        let near = if self.core.calls.catching > 0 { None } else { self.core.nearest_command(&name) };
        let code = ["TCL", "LOOKUP", "COMMAND", &name];
        let e = Exception::coded(format!("invalid command name \"{name}\""), &code);
        let e = e.by(&UNKNOWN_COMMAND).absent(Absent::new(COMMAND, &name));
        let label = (self.core.unknown_command_label)(&name).unwrap_or("no such command");
        let e = e.at(place.and_then(|p| p.word(0)), label).suggest(&name, near);
        Err(self.failed(e, argv, place))
    }
}

impl Core {
    /// The error for a text that is no script.
    fn syntax_error(&self, script: &Script, error: &ParseError) -> Exception {
        let span = script.unit.span(error.start, error.end);
        let mut e = Exception::error(error.message.clone()).at(span, error.label);
        if let Some(help) = error.help {
            e = e.help(help);
        }
        if error.never_closed {
            e = e.by(&NEVER_CLOSED);
        }
        let line = script.unit.line(error.start);
        self.settle_place(e.map_error(|e| e.line = line), None)
    }

    /// The command that the first word names; remembered with the parsed command.
    pub(crate) fn lookup(&self, argv: &[Value], place: Option<Place<'_>>) -> Option<CmdId> {
        let name = argv.first()?;
        let ns = self.here();
        let memory = place.filter(|p| {
            p.map.is_none() && matches!(p.command.words.first().map(|w| &w.kind), Some(WordKind::Literal(_)))
        });
        if let Some(p) = memory {
            let found = p.command.found.get();
            if found.epoch == self.table.epoch && found.namespace == ns.0 {
                return Some(CmdId(found.command));
            }
        }
        let id = self.find_command(&name.as_str())?;
        if let Some(p) = memory {
            p.command.found.set(Found { epoch: self.table.epoch, namespace: ns.0, command: id.0 });
        }
        Some(id)
    }

    /// Point an error that points nowhere at the word it is about: one that the message quotes, the only one, or the name.
    fn blame(&self, e: Exception, argv: &[Value], place: Option<Place<'_>>) -> Exception {
        let Some(place) = place else { return e };
        e.map_error(|e| {
            if e.diagnostic.span.is_some() || e.located {
                return;
            }
            let message = e.result.as_str();
            let quoted = |v: &Value| {
                let text = v.as_str();
                !text.is_empty() && text.len() < 200 && message.contains(&format!("\"{text}\""))
            };
            let no_list = |v: &Value| message.ends_with(" in list") && v.to_list().is_err();
            let about = |i: &usize| argv.get(*i).is_some_and(|v| quoted(v) || no_list(v));
            let word = (1..argv.len()).find(about).unwrap_or(usize::from(argv.len() == 2));
            e.diagnostic.span = place.word(word);
        })
    }

    /// The first time that an error passes a command: host_result where it happened and how that was reached.
    pub(crate) fn settle_place(&self, e: Exception, place: Option<Place<'_>>) -> Exception {
        e.map_error(|e| {
            if e.located {
                return;
            }
            e.located = true;
            if e.diagnostic.span.is_none() {
                e.diagnostic.span = place.and_then(|p| p.whole()).or(self.calls.site);
            }
            if e.diagnostic.callers.is_empty() {
                e.diagnostic.callers = self.callers();
            }
            // A script that catches errors may make many of them.
            if self.calls.catching == 0 {
                self.add_help(&mut e.diagnostic);
                e.diagnostic.help.extend(place.and_then(|p| comment(p, e)));
                e.diagnostic.help.extend(self.lost_backslash(e));
            }
        })
    }

    /// Help about a backslash in the path of a file that is not found.
    fn lost_backslash(&self, e: &ScriptError) -> Option<String> {
        let is_missing = e.error_code.as_ref().is_some_and(|code| code.as_str().starts_with("POSIX ENOENT"));
        let has_backslash = || e.diagnostic.span.is_some_and(|span| self.sources.snippet(span).contains('\\'));
        let help = "a backslash is no part of a path: Tcl takes \\p for p. Write / between folders, under Windows too";
        (is_missing && has_backslash()).then(|| help.into())
    }

    /// Add a command to what `$errorInfo` will be.
    pub(crate) fn trace_command(&self, e: Exception, place: Option<Place<'_>>, argv: Option<&[Value]>) -> Exception {
        e.map_error(|e| {
            if self.calls.compiled && e.traced {
                return;
            }
            e.traced = true;
            let text = match (place, argv) {
                (Some(p), _) => {
                    e.line = p.script.unit.line(p.command.start);
                    e.place = p.whole();
                    std::borrow::Cow::Borrowed(p.script.unit.slice(p.command.start, p.command.end))
                }
                (None, Some(argv)) => {
                    e.line = 1;
                    e.place = None;
                    super::list::join(argv).into()
                }
                (None, None) => return,
            };
            add_command(e, &text);
        })
    }

    /// Line of the failing command within a body that starts at `body`.
    pub(crate) fn line_within(&self, e: &ScriptError, body: Option<Span>) -> usize {
        match (e.place, body) {
            (Some(at), Some(body)) if at.source == body.source && body.start <= at.start && at.start <= body.end => {
                let text = self.sources.snippet(Span { end: at.start, ..body });
                text.bytes().filter(|b| *b == b'\n').count() + 1
            }
            _ => e.line,
        }
    }
}

/// Help about a comment among the words of a command that takes fewer.
fn comment(place: Place<'_>, e: &ScriptError) -> Option<String> {
    let is_count = e.error_code.as_ref().is_some_and(|code| code.as_str().starts_with("TCL WRONGARGS"));
    let unit = &place.script.unit;
    let mut words = place.command.words.iter().skip(1).map(|w| unit.slice(w.start, w.end));
    (is_count && words.any(|w| w.starts_with('#'))).then(|| "a comment after a command begins with \";#\"".into())
}

fn add_command(e: &mut ScriptError, text: &str) {
    let first = e.error_info.is_empty();
    if first {
        e.error_info = e.result.as_str().into_owned();
    }
    e.error_info.push_str(if first { "\n    while executing\n\"" } else { "\n    invoked from within\n\"" });
    match text.char_indices().nth(150) {
        Some((cut, _)) => {
            e.error_info.push_str(&text[..cut]);
            e.error_info.push_str("...");
        }
        None => e.error_info.push_str(text),
    }
    e.error_info.push('"');
}
