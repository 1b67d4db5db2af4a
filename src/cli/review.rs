//! `hysteron run --review FILE`: a page about a run for the engineer who has to trust it.
//!
//! Beside the results stand the inputs by their hashes, what verifies each kind that the script uses, the error of the steps
//! (from a second run with half of them), the balance of energy, and all warnings.

mod inputs;
mod page;
mod peaks;

use super::args::{FolderArgs, ScriptArgs, StepArgs};
use super::files::write_atomically;
use super::progress::ProgressLine;
use super::run::{RunArgs, guarded, settings};
use super::signals::on_interrupt;
use hysteron::opensees::{Mode, Outputs, Tcl};
use hysteron::run::{End, Run};
use hysteron::tcl::Files;
use hysteron::tcl::Silent;
use hysteron_files::Scratch;
pub(super) use inputs::Inputs;
use inputs::ReadFiles;
use page::Page;
use peaks::{Peak, Peaks, WithPeaks};
use std::collections::BTreeMap;
use std::path::Path;

/// Inputs and peaks of a run. Clones share them.
#[derive(Clone, Default)]
pub(super) struct Observed {
    inputs: Inputs,
    peaks: Peaks,
}

impl Observed {
    /// The files that the script has read.
    pub(super) fn inputs(&self) -> Inputs {
        self.inputs.clone()
    }

    /// Files and outputs that note inputs and peaks.
    pub(super) fn around(
        &self,
        files: Box<dyn Files>,
        outputs: Box<dyn Outputs>,
    ) -> (Box<dyn Files>, Box<dyn Outputs>) {
        let outputs = WithPeaks::new(outputs, self.peaks.clone(), self.inputs.clone());
        (Box::new(ReadFiles::new(files, self.inputs.clone())), Box::new(outputs))
    }
}

/// A run that has ended.
pub(super) struct Ended<'a> {
    /// The script, and its words.
    pub(super) model: &'a str,
    pub(super) words: &'a [String],
    pub(super) end: &'a End,
    pub(super) interp: &'a Tcl,
}

/// Write the page of a run, after another run with half the steps.
pub(super) fn write(path: &Path, args: &RunArgs<'_>, observed: &Observed, run: &Ended<'_>) -> Result<(), String> {
    let Ended { model, words, end, interp } = *run;
    let came_to_its_end = matches!(end, End::Done | End::Exit(0));
    let refined = came_to_its_end.then(|| refined_peaks(args, model, words)).flatten();
    let (options, peaks) = (options_in_words(args.script, args.steps), observed.peaks.take());
    let inputs = &observed.inputs;
    let page = Page { model, options, end, interp, inputs, peaks: &peaks, refined: refined.as_ref() };
    write_atomically(path, &page.html())
}

/// Peaks of the recorders with half the steps, from a run in a folder of its own; `None` if it is not completed.
fn refined_peaks(args: &RunArgs<'_>, model: &str, words: &[String]) -> Option<BTreeMap<String, Vec<Peak>>> {
    let scratch = Scratch::new("review").ok()?;
    let out = Some(scratch.path().to_owned());
    let folders = FolderArgs { out, sandbox: args.folders.sandbox, ..FolderArgs::default() };
    let (files, outputs) = guarded(&folders, model).ok()?;
    let observed = Observed::default();
    let (files, outputs) = observed.around(files, outputs);
    let steps = StepArgs { refine: 2 * args.steps.refine.max(1), ..*args.steps };
    let mut run = Run::new(settings(args.script, &steps, Mode::Run), Box::new(Silent), files, outputs);
    let progress = ProgressLine::new();
    run.interp.host.set_progress(Box::new(progress.steps(None)));
    on_interrupt(&run.interp.interrupt);
    let end = run.script(model, words);
    progress.clear();
    if matches!(end, End::Done | End::Exit(0)) {
        return Some(observed.peaks.take());
    }
    eprintln!("note: the run with half the steps was not completed: the review has no error of the steps");
    None
}

/// Options that change the numbers of a run.
fn options_in_words(script: &ScriptArgs, steps: &StepArgs) -> String {
    let refine = format!("--refine {}", steps.refine);
    let all = [
        (script.compat.is_some(), "--compat opensees"),
        (script.strict, "--strict"),
        (steps.ladder, "--ladder"),
        (steps.refine > 1, refine.as_str()),
    ];
    let given: Vec<&str> = all.into_iter().filter(|(is, _)| *is).map(|(_, word)| word).collect();
    given.join(" ")
}
