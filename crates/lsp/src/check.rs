//! Checks of scripts, studies, isolation studies and plans, whose files may be open in an editor.

use crate::finding::Finding;
use crate::script::{Paths, Script};
use crate::uri::{file_name, folder, joined};
use hysteron_design::{batch, isolate, review};
use hysteron_engine::analysis::Options;
use hysteron_identify::checks::CHANNEL_DOUBT;
use hysteron_identify::preflight::preflight;
use hysteron_identify::study::{InitialRun, ScriptSimulator, Study};
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{Mode, NoFiles, NumberFiles, Tcl};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};
use hysteron_tcl::{OsFiles, OverlayFiles, Silent, Value};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Texts of the open files by their paths.
pub(crate) type Buffers = BTreeMap<String, Arc<str>>;

/// Bytes of a text up to which it is checked.
const MAX_TEXT: usize = 16 << 20;
/// Variables whose values are kept.
const MAX_VARIABLES: usize = 2000;
/// Characters of a value that are kept.
const MAX_VALUE: usize = 80;

/// A file to be checked, and the limits of the check.
pub(crate) struct Job<'a> {
    /// Path of the script or study.
    pub(crate) root: &'a str,
    pub(crate) buffers: &'a Buffers,
    /// Set to end the check early.
    pub(crate) stop: &'a Arc<AtomicBool>,
    /// Time that it may take.
    pub(crate) limit: Duration,
    /// Reproduce errors of OpenSees.
    pub(crate) compat: bool,
    /// Numbers of files that have been read before.
    pub(crate) numbers: &'a NumberFiles,
}

/// Result of a check.
#[derive(Default)]
pub(crate) struct Checked {
    pub(crate) root: String,
    pub(crate) findings: Vec<Finding>,
    /// Texts that the findings point into, by path; of the other files what is on the disk.
    pub(crate) texts: BTreeMap<String, Arc<str>>,
    /// The index of a script.
    pub(crate) script: Option<Arc<Script>>,
    /// The text could not be read to its end: an earlier index knows more.
    pub(crate) is_cut: bool,
    /// The check was ended early.
    pub(crate) is_stopped: bool,
}

impl Checked {
    /// Files that were read, and those that findings point into.
    pub(crate) fn files(&self) -> impl Iterator<Item = String> {
        self.texts.keys().cloned().chain(self.findings.iter().map(|f| f.place.path.clone()))
    }
}

/// Kinds of files that are checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    Script,
    /// A file of Python, whose calls are those of a script where it imports OpenSees.
    Python,
    Study,
    Isolation,
    Plan,
    /// A file of another program.
    Other,
}

impl FileKind {
    /// Of a file with this name and text.
    pub(crate) fn of(path: &str, text: &str) -> Self {
        if path.ends_with(".py") {
            return Self::Python;
        }
        if !path.ends_with(".toml") {
            return Self::Script;
        }
        // The keys are those of the outermost level; a text that is being written may not be complete.
        let has = |key: &str| {
            let heading = [format!("[[{key}]]"), format!("[[{key}.")];
            text.lines().map(str::trim_start).any(|l| {
                heading.iter().any(|h| l.starts_with(h.as_str()))
                    || l.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
            })
        };
        match () {
            () if has("bearing") => Self::Isolation,
            () if has("scripts") => Self::Plan,
            () if has("model") && (has("run") || has("parameter")) => Self::Study,
            () => Self::Other,
        }
    }
}

impl Job<'_> {
    /// The text of the root: that of the editor, or that of the disk.
    fn text(&self) -> Option<Arc<str>> {
        let open = self.buffers.get(self.root).cloned();
        open.or_else(|| hysteron_files::read_text(self.root).ok().map(Arc::from))
    }

    /// Check the root. `first` receives findings that are there before the longer part of a check.
    pub(crate) fn run(&self, first: &dyn Fn(Checked)) -> Checked {
        let mut checked = Checked { root: self.root.to_owned(), ..Checked::default() };
        let Some(text) = self.text() else { return checked };
        checked.texts.insert(self.root.to_owned(), text.clone());
        if text.len() > MAX_TEXT {
            checked.findings.push(Finding::note(self.root, "the text is too long to be checked while it is written"));
            return checked;
        }
        match FileKind::of(self.root, &text) {
            FileKind::Script => self.script(&mut checked),
            FileKind::Python => self.python(&text, &mut checked),
            FileKind::Study => self.study(&text, &mut checked, first),
            FileKind::Isolation => self.isolation(&text, &mut checked),
            FileKind::Plan => {
                let form = batch::mistake_of_form(&text);
                self.table(form, &mut checked, |path| batch::load(path).map(|plan| plan.notes));
            }
            FileKind::Other => {}
        }
        checked
    }

    /// The files of the disk under those of the editor.
    fn files(&self) -> OverlayFiles {
        let files = OverlayFiles::new(Box::new(OsFiles)).starting_in(folder(self.root));
        self.buffers.iter().fold(files, |files, (path, text)| files.with_text(path, text))
    }

    fn settings(&self) -> Settings {
        let options = Options { compat: self.compat, ..Options::default() };
        Settings { mode: Mode::Check, strict: false, options }
    }

    /// Check the calls of a file of Python.
    fn python(&self, text: &str, checked: &mut Checked) {
        let (files, stop) = (Box::new(self.files()), self.stop.clone());
        let settings = hysteron_calls::Settings { run: self.settings(), files, stop, index: true };
        let Some(found) = hysteron_calls::check(file_name(self.root), text, settings) else { return };
        let hysteron_calls::Checked { mut run, is_cut, .. } = found;
        checked.is_cut = is_cut;
        checked.is_stopped = self.stop.load(Ordering::Relaxed);
        let (interp, mut paths) = (&mut run.interp, Paths::default());
        let finding = |d: &Diagnostic| Finding::new(d, &interp.sources, &mut paths, folder(self.root), self.root);
        checked.findings.extend(interp.warnings.iter().map(finding));
        let index = interp.host.index.take().unwrap_or_default();
        let script = Script::new(*index, BTreeMap::new(), &interp.sources, folder(self.root));
        self.keep_texts(checked, &interp.sources);
        checked.script = Some(Arc::new(script));
    }

    fn script(&self, checked: &mut Checked) {
        let files = self.files();
        let settings = self.settings();
        let mut run = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(NoFiles));
        run.interp.interrupt = self.stop.clone();
        run.interp.host.stop_on(self.stop.clone());
        run.interp.deadline = Some(Instant::now() + self.limit);
        run.interp.host.index = Some(Box::default());
        run.interp.host.number_files = self.numbers.clone();
        let end = run.script(file_name(self.root), &[]);
        let interp = &mut run.interp;
        let mut paths = Paths::default();
        let mut add = |d: &Diagnostic, sources: &SourceMap| {
            let finding = Finding::new(d, sources, &mut paths, folder(self.root), self.root);
            checked.findings.push(finding);
        };
        interp.warnings.iter().for_each(|w| add(w, &interp.sources));
        match &end {
            End::Rejected(d) | End::Raised(d) => add(d, &interp.sources),
            End::Failed(f) | End::Ignored(f) => add(&Diagnostic::error(f.to_string()), &interp.sources),
            End::Enough(Some(d)) => {
                let needs = "the check ends here, where the script needs results of an analysis";
                add(&note_of(Diagnostic::error(needs).place(d.span)), &interp.sources);
            }
            End::Interrupted => {
                checked.is_stopped = true;
                let message = format!("the check was stopped here, after {} s", self.limit.as_secs_f64());
                add(&note_of(Diagnostic::error(message).place(interp.stopped_at)), &interp.sources);
            }
            End::Enough(None) => {
                let used = hysteron_opensees::run::budget_used();
                add(&note_of(Diagnostic::error(used).place(interp.stopped_at)), &interp.sources);
            }
            End::Done | End::Exit(_) => {}
        }
        checked.is_cut = checked.findings.iter().any(|f| f.code == hysteron_tcl::check::NEVER_CLOSED.code);
        let variables = variables(interp);
        let index = interp.host.index.take().unwrap_or_default();
        let script = Script::new(*index, variables, &interp.sources, folder(self.root));
        self.keep_texts(checked, &interp.sources);
        checked.script = Some(Arc::new(script));
    }

    /// Keep the texts of all files that were read.
    fn keep_texts(&self, checked: &mut Checked, sources: &SourceMap) {
        for (name, text) in sources.named_texts() {
            checked.texts.entry(joined(folder(self.root), name)).or_insert_with(|| text.clone());
        }
    }

    fn study(&self, text: &str, checked: &mut Checked, first: &dyn Fn(Checked)) {
        let mut sources = SourceMap::default();
        let (mut paths, at) = (Paths::default(), folder(self.root));
        let mut found = vec![];
        let study = match Study::parse(Path::new(self.root), text, &mut sources) {
            Ok(study) => Arc::new(study),
            Err(d) => {
                checked.findings.push(Finding::new(&d, &sources, &mut paths, at, self.root));
                return;
            }
        };
        let mut add =
            |d: &Diagnostic, sources: &SourceMap| found.push(Finding::new(d, sources, &mut paths, at, self.root));
        study.warnings.iter().for_each(|w| add(w, &sources));
        first(Checked { root: checked.root.clone(), texts: checked.texts.clone(), ..Checked::default() });
        let options = Options { compat: self.compat, ..Options::default() };
        let mut simulator = ScriptSimulator::new(study.clone(), options, self.stop.clone());
        if let Some(open) = self.buffers.get(&joined(at, &study.model)) {
            simulator = simulator.factory().with_file(&study.model, open).simulator();
        }
        match simulator.run_initially(&mut sources) {
            Err(d) => add(&d, &sources),
            Ok(initial) if initial.is_interrupted() => checked.is_stopped = true,
            Ok(initial) => {
                initial.warnings.iter().for_each(|w| add(w, &sources));
                channels(&simulator, &initial, &study).iter().for_each(|d| add(d, &sources));
            }
        }
        checked.is_stopped |= self.stop.load(Ordering::Relaxed);
        checked.findings.append(&mut found);
        self.keep_texts(checked, &sources);
    }

    /// Check an isolation study. Its script runs where the study is what the disk has: what is not saved has its own numbers
    /// checked alone.
    fn isolation(&self, text: &str, checked: &mut Checked) {
        let (path, mut sources) = (Path::new(self.root), SourceMap::default());
        let result = match isolate::mistake_of_text(path, text, &mut sources) {
            Some(d) => Err(d),
            None if !self.is_saved() => return,
            None => isolate::load(path, self.stop, &mut sources).and_then(|study| {
                let agreed = review::periods(&study).agree(&study);
                let agreed = agreed.and_then(|()| review::suite(&study).agree(&study));
                agreed.map_err(|m| study.placed(&m, &mut sources))?;
                Ok(study.notes.iter().chain(&study.agreement.remarks).cloned().collect())
            }),
        };
        checked.is_stopped |= self.stop.load(Ordering::Relaxed);
        let mut paths = Paths::default();
        match result {
            Ok(notes) => self.warn(checked, notes),
            Err(_) if checked.is_stopped => {}
            Err(d) => {
                checked.findings.push(Finding::new(&d, &sources, &mut paths, folder(self.root), self.root));
            }
        }
    }

    /// Returns true if the root is what the disk has.
    fn is_saved(&self) -> bool {
        let saved = hysteron_files::read_text(self.root).unwrap_or_default();
        self.buffers.get(self.root).is_none_or(|open| **open == *saved.replace("\r\n", "\n"))
    }

    /// Warnings without places.
    fn warn(&self, checked: &mut Checked, notes: Vec<String>) {
        let warning = |n: String| Finding {
            severity: hysteron_tcl::diagnostic::Severity::Warning,
            ..Finding::note(self.root, n)
        };
        checked.findings.extend(notes.into_iter().map(warning));
    }

    /// Check a file whose mistakes have no places but those of its form. It is read from the disk: what is not saved has its
    /// form checked alone.
    fn table(
        &self,
        form: Option<(Option<std::ops::Range<usize>>, String)>,
        checked: &mut Checked,
        load: impl FnOnce(&Path) -> Result<Vec<String>, String>,
    ) {
        if let Some((range, message)) = form {
            let mut finding = Finding::error(self.root, message);
            let range = range.unwrap_or_default();
            (finding.place.start, finding.place.end) = (range.start, range.end);
            checked.findings.push(finding);
            return;
        }
        if !self.is_saved() {
            return;
        }
        match load(Path::new(self.root)) {
            Ok(notes) => self.warn(checked, notes),
            Err(message) => checked.findings.push(Finding::error(self.root, message)),
        }
    }
}

/// The same message as information.
fn note_of(mut d: Diagnostic) -> Diagnostic {
    d.severity = hysteron_tcl::diagnostic::Severity::Note;
    d
}

/// Findings about the channels of a study.
fn channels(simulator: &ScriptSimulator, initial: &InitialRun, study: &Study) -> Vec<Diagnostic> {
    // One thread: the editor shares the machine.
    let Ok(checked) = preflight(simulator, initial, 1) else { return vec![] };
    let finding = |f: &hysteron_identify::preflight::Finding| {
        let place = f.runs.first().and_then(|run| study.channel_location(run, &f.channel));
        let d = match f.is_hard {
            true => Diagnostic::error(f.message.clone()).by(&CHANNEL_DOUBT),
            false => Diagnostic::warning(&CHANNEL_DOUBT, f.message.clone()),
        };
        d.at(place, "").help(f.help.clone())
    };
    checked.findings.iter().map(finding).collect()
}

/// Values of the global variables at the end of a script.
fn variables(interp: &Tcl) -> BTreeMap<String, String> {
    let shown = |value: &Value| value.as_str().chars().take(MAX_VALUE).collect();
    interp.globals().into_iter().take(MAX_VARIABLES).map(|(name, value)| (name, shown(&value))).collect()
}
