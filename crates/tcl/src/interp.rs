//! The interpreter as its host sees it.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use super::builtin;
use super::command::{Call, CommandFn, CoreFn, Imp};
use super::console::Console;
use super::core::{CallSite, Callee, CommandTable, Core, ForeignScript, NsId};
use super::encoding::decode;
use super::error::Exception;
use super::files::{Files, posix};
use super::origin::Origin;
use super::proc::outside_of_loop;
use super::text::Text;
use super::value::Value;
use crate::diagnostic::{Diagnostic, SourceId, Span};

/// Handler of an error at the top level of a script.
pub type OnError<H> = fn(&mut Interp<H>, Exception) -> Result<Value, Exception>;

/// Observer of the commands of the host. A value takes the place of the command.
pub type BeforeCommand<H> = fn(&mut Interp<H>, &Call<'_>) -> Result<Option<Value>, Exception>;

/// A Tcl interpreter. The documentation of the crate has an example.
pub struct Interp<H> {
    /// State that the commands of the host work on.
    pub host: H,
    /// Variables, files, console and warnings.
    pub core: Core,
    pub(crate) functions: Vec<CommandFn<H>>,
    /// Handler of errors at the top level of the script. It returns the error to end the script, or a value to
    /// go on with the next command. `None` ends the script.
    pub on_error: Option<OnError<H>>,
    /// Is called before each command of the host, by whatever name a script calls it.
    pub before_command: Option<BeforeCommand<H>>,
    /// Number of functions that are Tcl's own: those of the host come after them.
    own_functions: usize,
}

/// The commands and variables of an interpreter, for others that begin with the same.
///
/// To register a few hundred commands takes longer than many a script: a host that makes an interpreter for each run
/// copies a vocabulary instead.
pub struct Vocabulary<H> {
    table: CommandTable,
    functions: Vec<CommandFn<H>>,
    own_functions: usize,
}

thread_local! {
    /// Files by path, as interpreters of this thread ran them last: the number of the source, and the parsed text.
    static PARSED: RefCell<HashMap<String, (SourceId, Value)>> = RefCell::default();
}

/// Number of parsed files that a thread keeps.
const MAX_PARSED_FILES: usize = 64;

impl<H> Deref for Interp<H> {
    type Target = Core;
    fn deref(&self) -> &Core {
        &self.core
    }
}

impl<H> DerefMut for Interp<H> {
    fn deref_mut(&mut self) -> &mut Core {
        &mut self.core
    }
}

impl<H> Interp<H> {
    /// An interpreter with the commands and variables of Tcl.
    pub fn new(host: H, console: Box<dyn Console>, files: Box<dyn Files>) -> Self {
        let mut interp = Self::with_functions(host, Core::new(console, files), vec![], 0);
        builtin::install(&mut interp);
        interp.own_functions = interp.functions.len();
        builtin::variables(&mut interp.core);
        interp
    }

    /// An interpreter with the commands and variables that another one had.
    pub fn with_vocabulary(
        host: H,
        console: Box<dyn Console>,
        files: Box<dyn Files>,
        vocabulary: &Vocabulary<H>,
    ) -> Self {
        let mut core = Core::new(console, files);
        core.table = vocabulary.table.copied();
        Self::with_functions(host, core, vocabulary.functions.clone(), vocabulary.own_functions)
    }

    fn with_functions(host: H, core: Core, functions: Vec<CommandFn<H>>, own_functions: usize) -> Self {
        Interp { host, core, functions, on_error: None, before_command: None, own_functions }
    }

    /// Call a function: one of the host after its observer, which may take its place.
    #[inline]
    pub(crate) fn call_numbered(&mut self, number: u32, call: &Call<'_>) -> Result<Value, Exception> {
        if let Some(before) = self.before_command.filter(|_| number as usize >= self.own_functions)
            && let Some(value) = before(self, call)?
        {
            return Ok(value);
        }
        self.functions[number as usize](self, call)
    }

    /// Its commands and variables as they are now.
    pub fn vocabulary(&self) -> Vocabulary<H> {
        let own_functions = self.own_functions;
        Vocabulary { table: self.core.table.copied(), functions: self.functions.clone(), own_functions }
    }

    /// Register a command of the host. It replaces one of the same name.
    pub fn register(&mut self, name: &str, function: CommandFn<H>) {
        self.functions.push(function);
        let imp = Imp::Full(self.functions.len() as u32 - 1);
        let name = name.trim_start_matches(':');
        // Calibrations make an interpreter for each evaluation, and most names have no namespace to look for.
        let (ns, tail) = match name.contains(':') {
            false => (NsId::GLOBAL, name.into()),
            true => self.core.place_for(&format!("::{name}")),
        };
        self.core.define(ns, &tail, imp);
    }

    pub(crate) fn register_core(&mut self, name: &str, function: CoreFn) {
        let (ns, tail) = self.core.place_for(name);
        self.core.define(ns, &tail, Imp::Core(function));
    }

    /// Run a script from a file, in the current namespace and with the current variables.
    ///
    /// A `return` at its top level ends it. Buffers of open files are written at the end.
    ///
    /// # Errors
    /// [`Exception::Error`] for a file that cannot be read and for an error of the script; [`Exception::Exit`] and
    /// [`Exception::Interrupted`] where the script ends early.
    pub fn eval_file(&mut self, path: &str) -> Result<Value, Exception> {
        let result = self.source(path, path);
        self.core.channels.flush_all();
        host_result(result)
    }

    /// Run a script from a text; messages call it by `name`.
    ///
    /// # Errors
    /// As [`Interp::eval_file`].
    pub fn eval_str(&mut self, name: &str, text: &str) -> Result<Value, Exception> {
        let script = self.core.take_text(name, text);
        let result = self.top_level(&script, name);
        self.core.channels.flush_all();
        host_result(result)
    }

    /// Evaluate a body in the scope of the command that received it, as `pattern … { … }` does.
    ///
    /// # Errors
    /// Each end of the body other than a value, `break` and `return` included. A command hands it on.
    pub fn eval_value(&mut self, body: &Value) -> Result<Value, Exception> {
        let compiled = std::mem::replace(&mut self.core.calls.compiled, true);
        let result = self.eval_body(body);
        self.core.calls.compiled = compiled;
        result
    }

    /// The command `source`: `shown` is the path as the script wrote it.
    pub(crate) fn source(&mut self, path: &str, shown: &str) -> Result<Value, Exception> {
        let full = self.core.absolute(path);
        let bytes = self.core.files.read(&full);
        let bytes = bytes.map_err(|e| posix(&e, |why| format!("couldn't read file \"{shown}\": {why}")))?;
        let mut text = decode(bytes).map_err(|encoding| {
            Exception::error(format!("couldn't read file \"{shown}\": its text is encoded in {encoding}"))
                .help("save it as UTF-8, which every editor can do")
        })?;
        if text.contains('\r') {
            text = text.replace("\r\n", "\n").replace('\r', "\n");
        }
        if let Some(end) = text.find('\u{1a}') {
            text.truncate(end);
        }
        let known = self.core.loaded.get(&full).filter(|(t, _)| **t == *text).map(|(_, v)| v.clone());
        let script = match known {
            Some(script) => script,
            None => {
                if let Some(foreign) = (self.core.is_foreign)(shown, &text) {
                    return Err(self.core.refuse_foreign(shown, &text, foreign));
                }
                let script = self.core.parsed_before(&full, shown, &text);
                self.core.loaded.insert(full, (Arc::from(text), script.clone()));
                script
            }
        };
        self.top_level(&script, shown)
    }

    /// Run a text that stands for itself.
    fn top_level(&mut self, script: &Value, name: &str) -> Result<Value, Exception> {
        // Tcl counts the command `source` but not the script that a program starts with.
        let nested = !self.core.calls.scripts.is_empty();
        if nested {
            self.core.enter()?;
        }
        let compiled = std::mem::replace(&mut self.core.calls.compiled, false);
        let site = self.core.calls.site.take();
        self.core.calls.sites.push(CallSite { what: Callee::Source(Text::from(name)), span: site });
        self.core.calls.scripts.push(Value::from(name));
        let result = self.eval_body(script);
        self.core.calls.scripts.pop();
        self.core.calls.sites.pop();
        self.core.calls.site = site;
        self.core.calls.compiled = compiled;
        self.core.calls.levels -= usize::from(nested);
        match result {
            Err(Exception::Return(v)) => Ok(v),
            Err(Exception::ReturnWith(r)) => super::proc::leave(*r),
            Err(e @ Exception::Error(_)) => {
                let shown: String = name.chars().take(150).collect();
                Err(e.trace(|line| format!("file \"{shown}\" line {line}")))
            }
            other => other,
        }
    }
}

/// Turn the end of a script into the host's result: only errors and `exit` remain.
fn host_result(result: Result<Value, Exception>) -> Result<Value, Exception> {
    match result {
        Err(Exception::Return(v) | Exception::Other(_, v)) => Ok(v),
        Err(Exception::ReturnWith(r)) => Ok(r.value),
        Err(Exception::Break) => Err(outside_of_loop("break")),
        Err(Exception::Continue) => Err(outside_of_loop("continue")),
        other => other,
    }
}

impl Core {
    /// A text to run, in its parsed form if an interpreter of this thread has run the same file.
    ///
    /// The file must have had the same number among the sources. A host may run a script thousands of times.
    fn parsed_before(&mut self, path: &str, name: &str, text: &str) -> Value {
        PARSED.with_borrow_mut(|parsed| {
            let source = self.sources.next();
            if let Some((of, script)) = parsed.get(path)
                && *of == source
                && *script.as_str() == *text
            {
                self.sources.add(name, text);
                return script.clone();
            }
            let script = self.take_text(name, text);
            if parsed.len() >= MAX_PARSED_FILES {
                parsed.clear();
            }
            parsed.insert(path.to_owned(), (source, script.clone()));
            script
        })
    }

    /// The error for a script in another language.
    fn refuse_foreign(&mut self, name: &str, text: &str, foreign: ForeignScript) -> Exception {
        let source = self.sources.add(name, text);
        let (start, end) = (foreign.place.start as u32, foreign.place.end as u32);
        let message = format!("\"{name}\" is a script in {}", foreign.language);
        let d = Diagnostic::error(message).at(Some(Span { source, start, end }), "expected a script in Tcl");
        Exception::diagnosed(d.help(foreign.help))
    }

    /// Add a text as a source of its own.
    fn take_text(&mut self, name: &str, text: &str) -> Value {
        let source = self.sources.add(name, text);
        Value::placed(text, Origin::whole(source))
    }

    /// Set a variable of the global namespace, for instance `argv` or `env(HOME)`.
    ///
    /// # Errors
    /// A scalar under the name of an array, an array under the name of a scalar, or a namespace that does not exist.
    pub fn set_global(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Exception> {
        let active = std::mem::replace(&mut self.calls.active, 0);
        let result = self.set_var(name, value);
        self.calls.active = active;
        result
    }
}
