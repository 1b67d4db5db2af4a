//! Checks of the calls of a file.

use crate::imports::Module;
use crate::reader::{FoundCall, Reading, read};
use hysteron_opensees::calls::{self, PlacedCall};
use hysteron_opensees::checks::words;
use hysteron_opensees::run::{self, Run};
use hysteron_opensees::{Command, Mode, NoFiles, commands, opensees_names, python_usage};
use hysteron_tcl::check::{Check, NEVER_CLOSED, UNKNOWN_COMMAND};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, SourceId, Span, nearest};
use hysteron_tcl::{Exception, Files, Silent, Value};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Settings of a check.
pub struct Settings {
    /// Settings of the commands; the mode is that of a check.
    pub run: run::Settings,
    /// Files that commands read, with the folder that they start from.
    pub files: Box<dyn Files>,
    /// Set to end the check early.
    pub stop: Arc<AtomicBool>,
    /// Make an index of the calls.
    pub index: bool,
}

/// A file whose calls have been checked. The findings are the warnings of the interpreter.
pub struct Checked {
    /// The commands with the model that they made, as far as they were called in order.
    pub run: Run,
    /// All calls were known, and all checks of a script were made.
    pub is_complete: bool,
    /// The text has something that is never closed.
    pub is_cut: bool,
}

/// Dimensions and degrees of freedom of the models in which a call is checked whose model is not known.
const MODELS: [(i64, i64); 6] = [(1, 1), (2, 2), (2, 3), (3, 3), (3, 4), (3, 6)];
/// Stand-ins that one call may need.
const MAX_STAND_INS: usize = 40;
/// Findings that can be told of a call whose model is not known.
static WITHOUT_MODEL: [&Check; 7] = [
    &words::UNKNOWN_KIND,
    &words::NOT_A_NUMBER,
    &words::MISSING_WORD,
    &words::OUT_OF_RANGE,
    &words::UNKNOWN_OPTION,
    &words::WORDS_LEFT_OVER,
    &words::NO_FLAG,
];

/// Check the calls of a text; `None` where it imports no module of commands.
///
/// A call is checked as a command of a script where all calls before are known. Otherwise only those findings are told that a
/// model of any dimension has, with whatever the call names defined.
pub fn check(name: &str, text: &str, settings: Settings) -> Option<Checked> {
    let reading = read(text)?;
    let Settings { run: options, files, stop, index } = settings;
    let options = run::Settings { mode: Mode::Check, ..options };
    let mut run = Run::for_calls(options.clone(), Box::new(Silent), files, Box::new(NoFiles));
    run.interp.interrupt = stop.clone();
    run.interp.host.stop_on(stop.clone());
    run.interp.host.index = index.then(Box::default);
    let source = run.interp.sources.add(name, text);
    let mut checker = Checker { reading: &reading, source, models: vec![], options, found: vec![], stop };
    for call in &reading.calls {
        if checker.stop.load(Ordering::Relaxed) {
            break;
        }
        checker.call(&mut run, call);
    }
    if let Some(open) = &reading.unclosed {
        let message = format!("\"{}\" is never closed", &text[open.clone()]);
        checker.found.push(Diagnostic::error(message).by(&NEVER_CLOSED).place(Some(span(source, open))));
    }
    if reading.is_complete && reading.unclosed.is_none() {
        run.close(Ok(Value::EMPTY));
    } else {
        run.leave();
    }
    let found = checker.found;
    let mut all: Vec<Diagnostic> = std::mem::take(&mut run.interp.warnings);
    all.extend(found);
    all.retain(|d| !is_of_openseespy_alone(&reading, source, d));
    all.sort_by_key(|d| d.span.map_or(0, |s| s.start));
    all.iter_mut().for_each(|d| d.help.iter_mut().for_each(|h| *h = python_usage::help_in_python(h)));
    run.interp.warnings = all;
    Some(Checked { run, is_complete: reading.is_complete, is_cut: reading.unclosed.is_some() })
}

fn span(source: SourceId, at: &std::ops::Range<usize>) -> Span {
    Span { source, start: at.start as u32, end: at.end as u32 }
}

/// Returns true if a finding is about a kind that hysteron lacks, in a file that runs in OpenSees.
fn is_of_openseespy_alone(reading: &Reading, source: SourceId, d: &Diagnostic) -> bool {
    let is_kind = reading.module == Module::OpenSeesPy && d.code() == words::UNKNOWN_KIND.code;
    is_kind
        && reading.calls.iter().any(|c| {
            let mut words = c.arguments.iter().filter_map(|a| a.words.as_ref()).flatten();
            words
                .any(|(word, at)| d.span == Some(span(source, at)) && opensees_names::has_kind(&c.name, &word.as_str()))
        })
}

struct Checker<'a> {
    reading: &'a Reading,
    source: SourceId,
    /// Models in which calls are checked whose model is not known.
    models: Vec<(Run, [String; 5])>,
    options: run::Settings,
    found: Vec<Diagnostic>,
    stop: Arc<AtomicBool>,
}

/// The words of a call with their places, up to the first argument that is not known.
struct Known {
    words: Vec<Value>,
    spans: Vec<Span>,
    whole: Span,
    is_whole: bool,
}

impl Known {
    fn of(call: &FoundCall, source: SourceId) -> Self {
        let mut out = Self {
            words: vec![Value::from(call.name.as_str())],
            spans: vec![span(source, &call.name_at)],
            whole: span(source, &call.at),
            is_whole: call.arguments.iter().all(|a| a.words.is_some()),
        };
        for (word, at) in call.arguments.iter().map_while(|a| a.words.as_ref()).flatten() {
            out.words.push(word.clone());
            out.spans.push(span(source, at));
        }
        out
    }

    fn placed(&self) -> PlacedCall<'_> {
        PlacedCall { words: &self.words, spans: &self.spans, whole: self.whole }
    }
}

impl Checker<'_> {
    fn call(&mut self, run: &mut Run, call: &FoundCall) {
        let Some(command) = calls::command(&call.name) else { return self.unknown(call) };
        let known = Known::of(call, self.source);
        if call.in_order {
            let result = run.check(command, &known.placed());
            if let Err(Exception::Error(e)) = result {
                self.found.push(e.diagnostic);
            }
        } else if !call.may_fail && !call.name.starts_with("block") {
            let found = self.without_model(command, &known);
            self.found.extend(found);
        }
    }

    /// A command that is not known.
    fn unknown(&mut self, call: &FoundCall) {
        let is_theirs = self.reading.module == Module::OpenSeesPy && opensees_names::has_command(&call.name);
        if is_theirs || call.may_fail {
            return;
        }
        let near = nearest(&call.name, commands().map(|c| c.name));
        let d = Diagnostic::error(format!("unknown command \"{}\"", call.name)).by(&UNKNOWN_COMMAND);
        self.found.push(d.place(Some(span(self.source, &call.name_at))).suggest(&call.name, near));
    }

    /// Findings that all models have. Of a call with unknown arguments only its kind is looked at.
    fn without_model(&mut self, command: &'static Command, known: &Known) -> Vec<Diagnostic> {
        if self.models.is_empty() {
            self.models = self.made();
        }
        let mut common: Option<Vec<Diagnostic>> = None;
        for (run, begin) in &mut self.models {
            let found = in_model(run, begin, command, known, &self.stop);
            let same =
                |a: &Diagnostic, b: &Diagnostic| (a.span, a.code(), &a.message) == (b.span, b.code(), &b.message);
            common = Some(match common {
                None => found,
                Some(before) => before.into_iter().filter(|a| found.iter().any(|b| same(a, b))).collect(),
            });
            if common.as_ref().is_some_and(Vec::is_empty) {
                break;
            }
        }
        let is_of_kind = |d: &Diagnostic| d.code() == words::UNKNOWN_KIND.code && d.span == known.spans.get(1).copied();
        common.unwrap_or_default().into_iter().filter(|d| known.is_whole || is_of_kind(d)).collect()
    }

    /// Models of all dimensions that the file may mean.
    fn made(&self) -> Vec<(Run, [String; 5])> {
        let dimension = |call: &FoundCall| {
            let words = Known::of(call, self.source).words;
            let at = words.iter().position(|w| w.as_str() == "-ndm")?;
            words.get(at + 1)?.as_i64()
        };
        let models: Vec<Option<i64>> = self.reading.calls.iter().filter(|c| c.name == "model").map(dimension).collect();
        let only = models.first().copied().flatten().filter(|ndm| models.iter().all(|m| *m == Some(*ndm)));
        let wanted = MODELS.iter().filter(|(ndm, _)| only.is_none_or(|only| only == *ndm));
        let one = |(ndm, ndf): &(i64, i64)| {
            let mut run = Run::for_calls(
                self.options.clone(),
                Box::new(Silent),
                Box::new(hysteron_tcl::MemoryFiles::default()),
                Box::new(NoFiles),
            );
            run.interp.interrupt = self.stop.clone();
            let words = ["basic".into(), "-ndm".into(), ndm.to_string(), "-ndf".into(), ndf.to_string()];
            (run, words)
        };
        wanted.map(one).collect()
    }
}

/// Findings about a call in a model that has nothing but what stands in for what the call names.
fn in_model(
    run: &mut Run,
    begin: &[String; 5],
    command: &'static Command,
    known: &Known,
    stop: &AtomicBool,
) -> Vec<Diagnostic> {
    let begun: Vec<Value> = ["model"].into_iter().chain(begin.iter().map(String::as_str)).map(Value::from).collect();
    for words in [&[Value::from("wipe")][..], &begun] {
        let name = words[0].as_str();
        if let Some(command) = calls::command(&name) {
            let _ = run.call(command, words);
        }
    }
    for _ in 0..MAX_STAND_INS {
        run.interp.clear_warnings();
        run.interp.host.check = Default::default();
        if stop.load(Ordering::Relaxed) || run.check(command, &known.placed()).is_err() {
            return vec![];
        }
        let absent =
            run.interp.warnings.iter().find_map(|d| d.absent.clone().filter(|_| d.severity == Severity::Error));
        if !absent.is_some_and(|a| run.stand_in(&a)) {
            break;
        }
    }
    let is_sure = |d: &Diagnostic| WITHOUT_MODEL.iter().any(|c| c.code == d.code());
    run.interp.warnings.iter().filter(|d| is_sure(d)).cloned().collect()
}
