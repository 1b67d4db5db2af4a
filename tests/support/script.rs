//! Runs scripts in memory.
#![allow(dead_code)]

use hysteron::analysis::{Options, WorkCounts};
use hysteron::diagnostic::Diagnostic;
use hysteron::opensees::lockstep::Course;
use hysteron::opensees::{FileFormat, Mode, Outputs, Tcl};
use hysteron::record::{Memory, Output, RecordError};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{Files, MemoryFiles, Recorded};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

/// Recorders' tables by file name.
#[derive(Clone, Default)]
pub struct Tables(Rc<RefCell<BTreeMap<String, Memory>>>);

impl Tables {
    /// The rows of all recorders so far, taken out.
    pub fn take(&self) -> BTreeMap<String, Vec<Vec<f64>>> {
        self.0.borrow().iter().map(|(name, m)| (name.clone(), m.take())).collect()
    }
}

impl Outputs for Tables {
    fn create(&mut self, name: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        let memory = Memory::default();
        self.0.borrow_mut().insert(name.to_owned(), memory.clone());
        Ok(Box::new(memory))
    }
}

/// A script that has been run.
pub struct Ran {
    pub end: End,
    pub out: String,
    pub err: String,
    pub interp: Tcl,
    pub tables: BTreeMap<String, Vec<Vec<f64>>>,
    pub work: WorkCounts,
}

impl Ran {
    /// Numbers that the script has put out, separated by blanks.
    pub fn numbers(&self) -> Vec<f64> {
        self.out.split_whitespace().map(|w| w.parse().unwrap_or_else(|_| panic!("no number: {w}"))).collect()
    }

    /// The script must have come to its end.
    pub fn done(self) -> Self {
        assert!(matches!(self.end, End::Done), "{:?}\n{}{}", self.end, self.out, self.err);
        self
    }

    pub fn warnings(&self) -> &[Diagnostic] {
        &self.interp.warnings
    }

    /// The error that ended the script.
    pub fn error(&self) -> &Diagnostic {
        match &self.end {
            End::Rejected(d) | End::Raised(d) => d,
            other => panic!("no error but {other:?}"),
        }
    }
}

pub struct Script {
    pub options: Options,
    pub mode: Mode,
    pub strict: bool,
    files: MemoryFiles,
}

impl Default for Script {
    fn default() -> Self {
        Self { options: Options::default(), mode: Mode::Run, strict: false, files: MemoryFiles::default() }
    }
}

impl Script {
    pub fn compat() -> Self {
        Self { options: Options { compat: true, ..Options::default() }, ..Self::default() }
    }

    /// A file that the script may read, by its path from the script's folder.
    pub fn with_file(self, name: &str, text: &str) -> Self {
        self.files.insert(&format!("{}/{name}", self.files.current_dir().trim_end_matches('/')), text);
        self
    }

    pub fn run(self, text: &str) -> Ran {
        self.run_with(text, |_| ())
    }

    /// The run of a script whose course is followed, before it begins, with its console and its tables.
    pub fn ready(self, text: &str, course: Option<Course>) -> (Run, Recorded, Tables) {
        let Self { options, mode, strict, files } = self.with_file("model.tcl", text);
        let (console, tables) = (Recorded::default(), Tables::default());
        let settings = Settings { mode, strict, options };
        let (to, made) = (Box::new(console.clone()), Box::new(tables.clone()));
        (Run::with_course(settings, course, to, Box::new(files), made), console, tables)
    }

    /// The same after something has been done to the interpreter.
    pub fn run_with(self, text: &str, prepare: impl FnOnce(&mut Run)) -> Ran {
        let (mut run, console, tables) = self.ready(text, None);
        prepare(&mut run);
        let end = run.script("model.tcl", &[]);
        let work = run.work_counts();
        let tables = tables.take();
        Ran { end, out: console.out(), err: console.err(), interp: run.interp, tables, work }
    }
}

/// Run a script that must come to its end.
pub fn run(text: &str) -> Ran {
    Script::default().run(text).done()
}
