//! The recorders of a model, and who else looks at its steps.

use super::Balances;
use super::collapse::Collapses;
use super::journal::Journal;
use crate::checks;
use crate::files::live::LiveFiles;
use crate::host::{MotionObserver, Progress};
use crate::things;
use crate::watch::isolator_damping::IsolatorDamping;
use crate::watch::softening::BackboneWatch;
use hysteron_engine::analysis::{Engine, Observer};
use hysteron_engine::model::Tag;
use hysteron_engine::record::{Missing, RecordError, Recorder};
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Span};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A recorder with the place of its command, for messages.
pub(crate) struct PlacedRecorder {
    pub(crate) recorder: Recorder,
    pub(crate) span: Option<Span>,
    /// Places of the tags that the command names, by the words of a message: "node 3".
    pub(crate) tags: BTreeMap<Absent, Span>,
    /// Path of its file.
    pub(crate) path: Option<String>,
    /// The same as the script names it.
    pub(crate) file: Option<String>,
    /// The words of the command.
    pub(crate) words: Vec<String>,
    pub(crate) reported: bool,
    /// None of the elements that were there with the command had the response, which has been said.
    pub(crate) knows_missing_response: bool,
}

/// The recorders of a model, and who else wants to know about steps.
#[derive(Default)]
pub(crate) struct Recorders {
    pub(crate) by_tag: BTreeMap<Tag, PlacedRecorder>,
    next: Tag,
    /// Their files, as the script finds them.
    pub(crate) live: LiveFiles,
    pub(crate) interrupt: Option<Arc<AtomicBool>>,
    pub(crate) progress: Option<Box<dyn Progress>>,
    pub(crate) end: Option<f64>,
    /// Balances of energy, where they are asked for.
    pub(crate) balances: Option<Box<Balances>>,
    /// Elements that are removed while an analysis runs.
    pub(crate) collapses: Collapses,
    /// Work of Rayleigh damping in isolators.
    pub(crate) isolator_damping: IsolatorDamping,
    /// Bearings that soften.
    pub(crate) backbones: BackboneWatch,
    pub(crate) motion: Option<Box<dyn MotionObserver>>,
    /// Checkpoints, where they are asked for.
    pub(crate) journal: Option<Box<Journal>>,
    /// Norms of the iterations, to be printed.
    pub(crate) printed: String,
    pub(crate) print: i32,
}

impl Recorders {
    /// Add a recorder; its tag. The first is 0, as in OpenSees, and `wipe` does not begin anew.
    pub(crate) fn add(&mut self, placed: PlacedRecorder) -> Tag {
        let tag = self.next;
        self.next += 1;
        self.by_tag.insert(tag, placed);
        tag
    }

    /// A tag for a recorder without rows.
    pub(crate) fn next_tag(&mut self) -> Tag {
        self.next += 1;
        self.next - 1
    }

    /// The recorder of a file.
    pub(crate) fn of_file(&self, path: &str) -> Option<&PlacedRecorder> {
        self.by_tag.values().find(|r| r.path.as_deref() == Some(path))
    }

    /// Finish and forget the recorder of a file, if there is one.
    pub(crate) fn finish_file(&mut self, path: &str) -> Result<(), RecordError> {
        let tag = self.by_tag.iter().find(|(_, r)| r.path.as_deref() == Some(path)).map(|(tag, _)| *tag);
        tag.and_then(|tag| self.by_tag.remove(&tag)).map_or(Ok(()), |mut r| r.recorder.finish())
    }

    /// Look up what is to be recorded in the model as it is now, as the first row of a run would.
    pub(crate) fn look_up(&mut self, engine: &Engine) {
        self.by_tag.values_mut().filter(|r| !r.reported).for_each(|r| r.recorder.look_up(engine));
    }

    /// Returns true if steps come from a journal and are not computed: the engine has not their state.
    pub(crate) fn repeats(&self) -> bool {
        self.journal.as_ref().is_some_and(|j| j.repeats())
    }

    /// Returns true if nobody but recorders needs the state after each step.
    pub(crate) fn records_only(&self) -> bool {
        self.balances.is_none() && self.motion.is_none() && self.journal.is_none() && self.print == 0
    }

    /// Record the committed state.
    pub(crate) fn record(&mut self, engine: &mut Engine) -> Result<(), RecordError> {
        self.by_tag.values_mut().try_for_each(|r| r.recorder.record(engine).map(drop))
    }

    /// An analysis has ended, and others may look at the files.
    pub(crate) fn pause(&mut self) -> Result<(), RecordError> {
        self.by_tag.values_mut().try_for_each(|r| r.recorder.pause())?;
        self.live.sync_if_due()
    }

    /// An analysis starts from the committed state.
    pub(crate) fn start(&mut self, engine: &mut Engine) {
        self.live.mark();
        if let Some(balances) = &mut self.balances {
            balances.start(engine);
        }
        self.by_tag.values_mut().for_each(|r| r.recorder.start(engine));
        if let Some(motion) = &mut self.motion {
            motion.start(engine);
        }
    }

    /// Forget what is known of the elements of the model.
    pub(crate) fn forget_model(&mut self) {
        self.isolator_damping = IsolatorDamping::default();
        self.backbones = BackboneWatch::default();
    }

    /// Finish and forget all recorders.
    pub(crate) fn finish(&mut self) -> Result<(), RecordError> {
        let all = std::mem::take(&mut self.by_tag);
        self.collapses = Collapses::default();
        // An error of one recorder must not keep the others from being finished.
        let mut result = Ok(());
        for mut r in all.into_values() {
            result = result.and(r.recorder.finish());
        }
        result
    }

    /// Warnings about responses that recorders asked for in vain, once for each recorder. What `held_back` tells of
    /// is left out.
    pub(crate) fn missing(&mut self, mut held_back: impl FnMut(&Absent) -> bool) -> Vec<Diagnostic> {
        let mut warnings = vec![];
        for r in self.by_tag.values_mut() {
            if r.recorder.missing.is_empty() || std::mem::replace(&mut r.reported, true) {
                continue;
            }
            let known = |m: &&Missing| r.knows_missing_response && matches!(m, Missing::Response { .. });
            let missing = r.recorder.missing.iter().filter(|m| !known(m));
            let missing = missing.filter(|m| absent_of(m).is_none_or(|thing| !held_back(&thing)));
            let (zero, absent): (Vec<&Missing>, Vec<&Missing>) = missing.partition(|m| m.is_zero());
            for (group, label) in [(absent, "left out of the record"), (zero, "its column is zero, as in OpenSees")] {
                let Some(first) = group.first() else { continue };
                let place = absent_of(first).and_then(|thing| r.tags.get(&thing).copied()).or(r.span);
                let message = format!("recorder: the model has no {}", Missing::list(group.iter().copied()));
                warnings.push(Diagnostic::warning(&checks::output::NOT_IN_MODEL, message).at(place, label));
            }
        }
        warnings
    }
}

impl Observer for Recorders {
    fn committed(&mut self, engine: &mut Engine) -> Result<(), String> {
        match &mut self.journal {
            Some(journal) => journal.record(&mut self.by_tag, engine).map_err(|e| e.to_string())?,
            None => self.record(engine).map_err(|e| e.to_string())?,
        }
        if let Some(balances) = &mut self.balances {
            balances.step(engine)?;
        }
        self.isolator_damping.add_step(engine);
        self.backbones.step(engine);
        if self.print != 0 {
            self.note_iterations(engine);
        }
        if let Some(p) = &mut self.progress {
            p.step(engine.state().time, self.end);
        }
        if let Some(motion) = &mut self.motion {
            motion.step(engine);
        }
        self.collapses.step(engine);
        Ok(())
    }

    fn interrupted(&self) -> bool {
        self.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed))
    }
}

impl Recorders {
    /// Note the norms of a step's iterations as OpenSees prints them.
    fn note_iterations(&mut self, engine: &Engine) {
        use std::fmt::Write as _;
        let Some(test) = engine.setup().map(|s| &s.test) else { return };
        let name = test.measure.name();
        let all = matches!(self.print, 1 | 4);
        let n = test.norms.len();
        for (i, norm) in test.norms.iter().enumerate().filter(|(i, _)| all || i + 1 == n) {
            let _ = writeln!(self.printed, "{name}: iteration {} norm {norm:.6e} (max {:.3e})", i + 1, test.tolerance);
        }
    }
}

/// The thing that a recorder or a region misses, as messages name it.
pub(crate) fn absent_of(missing: &Missing) -> Option<Absent> {
    match missing {
        Missing::Node(tag) => Some(Absent::new(things::NODE, tag)),
        Missing::Element(tag) => Some(Absent::new(things::ELEMENT, tag)),
        Missing::Dof { dof, .. } => Some(Absent::new(things::DOF, dof)),
        Missing::Response { .. } | Missing::Column { .. } | Missing::Drift { .. } => None,
    }
}
