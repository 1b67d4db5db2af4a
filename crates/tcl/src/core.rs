//! State of an interpreter except the host and its commands: variables, namespaces, channels, texts.

use std::cell::Cell;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::channel::Channels;
use super::command::Definition;
use super::console::Console;
use super::error::Exception;
use super::files::Files;
use super::inline::InlinedCommands;
use super::lookalike;
use super::namespace::Namespace;
use super::table::Table;
use super::text::Text;
use super::value::Value;
use super::vars::Slot;
use crate::diagnostic::{Caller, Diagnostic, SourceMap, Span, WarningKind};

/// Number of a namespace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct NsId(pub(crate) u32);

impl NsId {
    pub(crate) const GLOBAL: NsId = NsId(0);
}

/// Scope of variable names.
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
pub(crate) struct CallSite {
    pub(crate) what: Callee,
    pub(crate) span: Option<Span>,
}

/// Callee of a call site.
#[derive(Debug)]
pub(crate) enum Callee {
    /// By the index of its frame, which has the words of the call.
    Proc(usize),
    Source(Text),
}

/// A script in another language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForeignScript {
    /// Name of the language.
    pub language: &'static str,
    /// Bytes of the text that show it.
    pub place: Range<usize>,
    /// How such a script is run.
    pub help: String,
}

/// State of an interpreter except its host. An [`Interp`](super::Interp) dereferences to it.
pub struct Core {
    /// Receiver of the output of `puts`.
    pub console: Box<dyn Console>,
    /// The files that a script sees.
    pub files: Box<dyn Files>,
    /// Is called where others may look at what the script has done: before it waits, and where it flushes its output.
    pub on_pause: Option<Box<dyn FnMut()>>,
    /// The texts read so far, to locate messages in.
    pub sources: SourceMap,
    /// Warnings in the order in which they came up first.
    pub warnings: Vec<Diagnostic>,
    /// A command runs once more: its warnings of before are not counted again.
    pub is_repeat: bool,
    /// Index of the warning of each kind and place.
    warned: HashMap<WarningKind, usize>,
    /// Returns the label of the message about an unknown command that another program knows.
    pub unknown_command_label: fn(&str) -> Option<&'static str>,
    /// Recognises a script in another language, by its name and its text, before any command of it runs.
    pub is_foreign: fn(&str, &str) -> Option<ForeignScript>,
    /// Set this, from any thread, to stop the script before its next command.
    pub interrupt: Arc<AtomicBool>,
    /// Number of commands that may still run; no limit if `None`.
    pub budget: Option<u64>,
    /// Time at which the script stops before its next command, but for a few thousand commands; no limit if `None`.
    pub deadline: Option<Instant>,
    /// A second flag that stops the script, within a few thousand commands: that of a group of scripts.
    pub group_interrupt: Option<Arc<AtomicBool>>,
    /// Place of the command at which the script was stopped.
    pub stopped_at: Option<Span>,
    pub(crate) calls: CallStack,
    pub(crate) table: CommandTable,
    /// Significant digits of doubles; 0: as many as it takes.
    pub(crate) precision: usize,
    /// State of `rand`.
    pub(crate) seed: Option<i64>,
    pub(crate) channels: Channels,
    /// Current folder; `None` where it is that of the files at any time.
    pub(crate) cwd: Option<String>,
    /// Files read so far: their text and its parsed form.
    pub(crate) loaded: HashMap<String, (Arc<str>, Value)>,
    pub(crate) packages: Packages,
    spare: Spare,
}

/// Calls and scripts under way.
pub(crate) struct CallStack {
    pub(crate) frames: Vec<Frame>,
    /// Index of the frame in which names are looked up now.
    pub(crate) active: usize,
    /// Number of `catch` and `try` under way.
    pub(crate) catching: usize,
    /// Number of calls under way, as Tcl counts them.
    pub(crate) levels: usize,
    /// Number of nested scripts under way.
    pub(crate) depth: usize,
    /// Number of commands that have run.
    pub(crate) command_count: u64,
    /// True if Tcl would have compiled the present script. Only `$errorInfo` depends on it.
    pub(crate) compiled: bool,
    /// The innermost command that has a place.
    pub(crate) site: Option<Span>,
    pub(crate) sites: Vec<CallSite>,
    /// Results of `info script`, innermost last.
    pub(crate) scripts: Vec<Value>,
    /// Words of a command to run in place of the procedure that asked for it.
    pub(crate) tailcall: Option<Vec<Value>>,
}

impl CallStack {
    fn new() -> Self {
        let global =
            Frame { ns: NsId::GLOBAL, vars: Table::default(), is_proc: false, level: 0, caller: 0, words: vec![] };
        CallStack {
            frames: vec![global],
            active: 0,
            catching: 0,
            levels: 0,
            depth: 0,
            command_count: 0,
            compiled: false,
            site: None,
            sites: vec![],
            scripts: vec![],
            tailcall: None,
        }
    }
}

/// Namespaces with their variables, and the commands.
pub(crate) struct CommandTable {
    pub(crate) namespaces: Vec<Namespace>,
    pub(crate) commands: Vec<Definition>,
    /// Changes whenever a name may mean another command. Other interpreters of the thread have other numbers, unless
    /// they have the same commands.
    pub(crate) epoch: u32,
    /// Commands of the language that run without being called.
    pub(crate) inlined: InlinedCommands,
}

impl CommandTable {
    fn new() -> Self {
        CommandTable {
            namespaces: vec![Namespace::global()],
            commands: vec![],
            epoch: fresh_epoch(),
            inlined: InlinedCommands::default(),
        }
    }

    /// A copy whose variables are its own.
    pub(crate) fn copied(&self) -> Self {
        CommandTable {
            namespaces: self.namespaces.iter().map(Namespace::copied).collect(),
            commands: self.commands.clone(),
            epoch: self.epoch,
            inlined: self.inlined,
        }
    }
}

/// Packages of `package`.
#[derive(Default)]
pub(crate) struct Packages {
    /// Packages provided, and their versions.
    pub(crate) provided: Table<Value>,
    /// Packages that a script could provide: name, version, script.
    pub(crate) offered: Vec<[Value; 3]>,
}

/// Memory of finished calls, used again.
#[derive(Default)]
struct Spare {
    words: Vec<Vec<Value>>,
    vars: Vec<Table<Slot>>,
    text: String,
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
    /// Let the host show others what the script has done.
    pub(crate) fn pause(&mut self) {
        if let Some(on_pause) = &mut self.on_pause {
            on_pause();
        }
    }

    /// A name may mean another command from now on.
    pub(crate) fn renew_epoch(&mut self) {
        self.table.epoch = fresh_epoch();
    }

    pub(crate) fn new(console: Box<dyn Console>, files: Box<dyn Files>) -> Self {
        let cwd = files.current_dir();
        Core {
            console,
            files,
            sources: SourceMap::default(),
            warnings: vec![],
            on_pause: None,
            is_repeat: false,
            warned: HashMap::new(),
            unknown_command_label: |_| None,
            is_foreign: |_, _| None,
            interrupt: Arc::default(),
            budget: None,
            deadline: None,
            group_interrupt: None,
            stopped_at: None,
            calls: CallStack::new(),
            table: CommandTable::new(),
            precision: 0,
            seed: None,
            channels: Channels::default(),
            cwd: Some(cwd),
            loaded: HashMap::new(),
            packages: Packages::default(),
            spare: Spare::default(),
        }
    }

    /// Take the current folder of the files for that of the script from now on: the host may change it.
    pub fn follow_current_dir(&mut self) {
        self.cwd = None;
    }

    /// Called before each command.
    #[inline]
    pub(crate) fn tick(&mut self) -> Result<(), Exception> {
        self.calls.command_count += 1;
        if let Some(left) = &mut self.budget {
            match left.checked_sub(1) {
                Some(less) => *left = less,
                None => return Err(Exception::Interrupted),
            }
        }
        // Reading the clock takes longer than a small command.
        let late = self.calls.command_count & 0xfff == 0 && self.is_late();
        if late || self.interrupt.load(Ordering::Relaxed) {
            return Err(Exception::Interrupted);
        }
        Ok(())
    }

    #[cold]
    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|d| Instant::now() > d)
            || self.group_interrupt.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// An empty row for words, reused.
    pub(crate) fn take_words(&mut self) -> Vec<Value> {
        self.spare.words.pop().unwrap_or_default()
    }

    pub(crate) fn give_words(&mut self, mut words: Vec<Value>) {
        words.clear();
        // A rare long command must not keep its memory for ever.
        if words.capacity() <= 64 && self.spare.words.len() < 256 {
            self.spare.words.push(words);
        }
    }

    /// An empty text to put others together in, reused.
    pub(crate) fn take_buffer(&mut self) -> String {
        std::mem::take(&mut self.spare.text)
    }

    pub(crate) fn give_buffer(&mut self, mut text: String) {
        text.clear();
        // A rare long text must not keep its memory for ever.
        if text.capacity() <= 4096 {
            self.spare.text = text;
        }
    }

    pub(crate) fn take_vars(&mut self) -> Table<Slot> {
        self.spare.vars.pop().unwrap_or_default()
    }

    pub(crate) fn give_vars(&mut self, mut vars: Table<Slot>) {
        vars.clear();
        if self.spare.vars.len() < 64 {
            self.spare.vars.push(vars);
        }
    }

    pub(crate) fn frame(&self) -> &Frame {
        &self.calls.frames[self.calls.active]
    }

    /// Add a warning. Without a place it points at the command that runs; the callers are added.
    ///
    /// A warning of a kind that came from this place before is counted there. Returns the warning if it is the first.
    pub fn warn(&mut self, mut warning: Diagnostic) -> Option<&Diagnostic> {
        if warning.span.is_none() {
            warning.span = self.calls.site;
        }
        if let Some(at) = self.warned.get(&warning.kind()).copied().filter(|at| *at < self.warnings.len()) {
            self.warnings[at].count += usize::from(!self.is_repeat);
            return None;
        }
        if warning.callers.is_empty() {
            warning.callers = self.callers();
        }
        self.add_help(&mut warning);
        self.warned.insert(warning.kind(), self.warnings.len());
        self.warnings.push(warning);
        self.warnings.last()
    }

    /// Forget the warnings so far.
    pub fn clear_warnings(&mut self) {
        self.warnings.clear();
        self.warned.clear();
    }

    /// Add what the text around the place of a message explains.
    pub(crate) fn add_help(&self, message: &mut Diagnostic) {
        let Some(span) = message.span else { return };
        for line in lookalike::around(&self.sources, span) {
            if !message.help.contains(&line) {
                message.help.push(line);
            }
        }
    }

    /// The calls under way, innermost first.
    pub fn callers(&self) -> Vec<Caller> {
        let caller = |site: &CallSite| {
            let what = match &site.what {
                Callee::Proc(frame) => {
                    let words = self.calls.frames.get(*frame).map_or(&[][..], |f| &f.words);
                    format!("proc \"{}\"", words.first().unwrap_or(&Value::EMPTY))
                }
                Callee::Source(path) => format!("source \"{}\"", &**path),
            };
            Some(Caller { what, span: site.span? })
        };
        self.calls.sites.iter().rev().filter_map(caller).collect()
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
