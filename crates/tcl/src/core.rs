//! The state of an interpreter but for the host and its commands: variables, namespaces, channels, texts.

use std::cell::Cell;
use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::channel::Channels;
use super::command::{CmdId, Definition};
use super::console::Console;
use super::error::Exception;
use super::files::Files;
use super::namespace::Namespace;
use super::table::Table;
use super::text::Text;
use super::value::Value;
use super::vars::Slot;
use crate::diagnostic::{Caller, Diagnostic, SourceMap, Span};

/// Number of a namespace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct NsId(pub(crate) u32);

impl NsId {
    pub(crate) const GLOBAL: NsId = NsId(0);
}

/// Where names of variables are looked up.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) ns: NsId,
    /// Of a procedure; others use the variables of the namespace.
    pub(crate) vars: Table<Slot>,
    pub(crate) is_proc: bool,
    /// As `info level` counts.
    pub(crate) level: usize,
    /// The frame in which the call was made.
    pub(crate) caller: usize,
    /// The words of the call.
    pub(crate) words: Vec<Value>,
}

/// A call under way, for the chain of callers of a message.
#[derive(Debug)]
pub(crate) struct Site {
    pub(crate) what: What,
    pub(crate) span: Option<Span>,
}

/// What was called.
#[derive(Debug)]
pub(crate) enum What {
    Proc(Text),
    Source(Text),
}

/// Everything of an interpreter but its host. An [`super::Interp`] gives access to it as if it were its own.
pub struct Core {
    /// Where `puts` writes.
    pub console: Box<dyn Console>,
    /// The files that a script sees.
    pub files: Box<dyn Files>,
    /// The texts read so far, to locate messages in.
    pub sources: SourceMap,
    /// Warnings in the order in which they came up.
    pub warnings: Vec<Diagnostic>,
    /// Set this, from any thread, to stop the script before its next command.
    pub interrupt: Arc<AtomicBool>,
    /// How many more commands may run; no limit if `None`.
    pub budget: Option<u64>,
    pub(crate) frames: Vec<Frame>,
    /// The frame in which names are looked up now.
    pub(crate) active: usize,
    pub(crate) namespaces: Vec<Namespace>,
    pub(crate) commands: Vec<Definition>,
    /// Changes whenever a name may mean another command; no other interpreter of the thread has had the same, but for one
    /// with the same commands.
    pub(crate) epoch: u32,
    /// Significant digits of doubles; 0: as many as it takes.
    pub(crate) precision: usize,
    /// How many `catch` and `try` are under way.
    pub(crate) catching: usize,
    /// How many calls are under way, as Tcl counts them.
    pub(crate) levels: usize,
    /// How many scripts are under way within one another.
    pub(crate) depth: usize,
    /// How many commands have been run.
    pub(crate) command_count: u64,
    /// Whether Tcl would have compiled the script that runs now; matters to `$errorInfo` only.
    pub(crate) compiled: bool,
    /// The innermost command that has a place.
    pub(crate) site: Option<Span>,
    pub(crate) sites: Vec<Site>,
    /// State of `rand`.
    pub(crate) seed: Option<i64>,
    pub(crate) channels: Channels,
    pub(crate) cwd: String,
    /// What `info script` gives, innermost last.
    pub(crate) scripts: Vec<Value>,
    /// Files read so far: their text and its parsed form.
    pub(crate) loaded: HashMap<String, (Arc<str>, Value)>,
    /// Packages provided, and their versions.
    pub(crate) packages: Table<Value>,
    /// Packages that a script could provide: name, version, script.
    pub(crate) offered: Vec<[Value; 3]>,
    /// Words of a command to run in place of the procedure that asked for it.
    pub(crate) tailcall: Option<Vec<Value>>,
    /// The commands `expr` and `set` of the language, which are carried out without being called.
    pub(crate) inlined: (Option<CmdId>, Option<CmdId>),
    spare_words: Vec<Vec<Value>>,
    spare_vars: Vec<Table<Slot>>,
}

thread_local! {
    static EPOCHS: Cell<u32> = const { Cell::new(0) };
}

/// A number that no interpreter of this thread has had: parsed scripts, which remember what their commands were, are shared.
fn fresh_epoch() -> u32 {
    EPOCHS.with(|last| {
        last.set(last.get().wrapping_add(1));
        last.get()
    })
}

impl Core {
    /// A name may mean another command from now on.
    pub(crate) fn renew_epoch(&mut self) {
        self.epoch = fresh_epoch();
    }

    pub(crate) fn new(console: Box<dyn Console>, files: Box<dyn Files>) -> Self {
        let global =
            Frame { ns: NsId::GLOBAL, vars: Table::default(), is_proc: false, level: 0, caller: 0, words: vec![] };
        let cwd = files.current_dir();
        Core {
            console,
            files,
            sources: SourceMap::default(),
            warnings: vec![],
            interrupt: Arc::default(),
            budget: None,
            frames: vec![global],
            active: 0,
            namespaces: vec![Namespace::global()],
            commands: vec![],
            epoch: fresh_epoch(),
            precision: 0,
            catching: 0,
            levels: 0,
            depth: 0,
            command_count: 0,
            compiled: false,
            site: None,
            sites: vec![],
            seed: None,
            channels: Channels::default(),
            cwd,
            scripts: vec![],
            loaded: HashMap::new(),
            packages: Table::default(),
            offered: vec![],
            tailcall: None,
            inlined: (None, None),
            spare_words: vec![],
            spare_vars: vec![],
        }
    }

    /// Called before each command.
    #[inline]
    pub(crate) fn tick(&mut self) -> Result<(), Exception> {
        self.command_count += 1;
        if let Some(left) = &mut self.budget {
            match left.checked_sub(1) {
                Some(less) => *left = less,
                None => return Err(Exception::Interrupted),
            }
        }
        if self.interrupt.load(Ordering::Relaxed) {
            return Err(Exception::Interrupted);
        }
        Ok(())
    }

    /// An empty row for words, reused.
    pub(crate) fn take_words(&mut self) -> Vec<Value> {
        self.spare_words.pop().unwrap_or_default()
    }

    pub(crate) fn give_words(&mut self, mut words: Vec<Value>) {
        words.clear();
        // A rare long command must not keep its memory for ever.
        if words.capacity() <= 64 && self.spare_words.len() < 256 {
            self.spare_words.push(words);
        }
    }

    pub(crate) fn take_vars(&mut self) -> Table<Slot> {
        self.spare_vars.pop().unwrap_or_default()
    }

    pub(crate) fn give_vars(&mut self, mut vars: Table<Slot>) {
        vars.clear();
        if self.spare_vars.len() < 64 {
            self.spare_vars.push(vars);
        }
    }

    pub(crate) fn frame(&self) -> &Frame {
        &self.frames[self.active]
    }

    /// Warn; the warning points at the command that runs if it points nowhere yet, and tells how it was reached.
    pub fn warn(&mut self, mut warning: Diagnostic) {
        if warning.span.is_none() {
            warning.span = self.site;
        }
        if warning.callers.is_empty() {
            warning.callers = self.callers();
        }
        self.warnings.push(warning);
    }

    /// The calls under way, innermost first.
    pub fn callers(&self) -> Vec<Caller> {
        let caller = |site: &Site| {
            let what = match &site.what {
                What::Proc(name) => format!("proc \"{}\"", &**name),
                What::Source(path) => format!("source \"{}\"", &**path),
            };
            Some(Caller { what, span: site.span? })
        };
        self.sites.iter().rev().filter_map(caller).collect()
    }

    /// A double as `expr` gives it: with `tcl_precision` set, its text has that many digits.
    pub(crate) fn double(&self, d: f64) -> Value {
        if self.precision == 0 {
            return Value::from(d);
        }
        let mut text = String::new();
        super::number::write_double_rounded(&mut text, d, self.precision);
        Value::with_number(text, super::number::Number::Double(d))
    }
}
