//! What the OpenSees commands of a script work on.

use crate::check::Findings;
use crate::files::number_files::NumberFiles;
use crate::material::Bench;
use crate::model::parameter::Parameter;
use crate::slips::Slip;
use hysteron_engine::analysis::algorithm::Algorithm;
use hysteron_engine::analysis::integrator::Integrator;
use hysteron_engine::analysis::{Engine, Failure, Kind, Observer, Options, ReactionKind, Test};
use hysteron_engine::assembly::Handler;
use hysteron_engine::model::{Definitions, ElementId, NodeId, Tag};
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{Known, Layout, Output, RecordError, Recorder};
use hysteron_engine::section::Fiber;
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, Span};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// How a script is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// For its results.
    Run,
    /// To find what is wrong with it: analyses are passed over.
    Check,
}

/// How a recorder's file is to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileFormat {
    /// Numbers.
    pub style: Style,
    /// How rows are laid out.
    pub layout: Layout,
    /// Every row at once.
    pub close_on_write: bool,
}

/// Where recorders write: files, or the memory of a study.
pub trait Outputs {
    /// An output by the name the script gives it, and as a path that is not relative to anything.
    ///
    /// # Errors
    /// It cannot be made.
    fn create(&mut self, name: &str, path: &Path, format: FileFormat) -> Result<Box<dyn Output>, RecordError>;
}

/// What is told while an analysis runs.
pub trait Progress {
    /// A step has been committed at this time; `end` is the time at which the excitation ends, where that is known.
    fn step(&mut self, time: f64, end: Option<f64>);
}

/// Is called with each warning when it comes up.
pub type OnWarning = Box<dyn FnMut(&Diagnostic, &SourceMap)>;

/// The parts of an analysis as the commands have given them so far.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub(crate) handler: Option<Handler>,
    pub(crate) test: Option<Test>,
    pub(crate) algorithm: Option<Box<dyn Algorithm>>,
    pub(crate) integrator: Option<Box<dyn Integrator>>,
    /// Print flag of the test.
    pub(crate) print: i32,
}

/// A named set of nodes and elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Region {
    pub(crate) nodes: Vec<NodeId>,
    pub(crate) elements: Vec<ElementId>,
}

/// A recorder with the place of its command, for messages.
pub(crate) struct PlacedRecorder {
    pub(crate) recorder: Recorder,
    pub(crate) span: Option<Span>,
    pub(crate) told: bool,
}

/// The recorders of a model, and who else wants to know about steps.
#[derive(Default)]
pub(crate) struct Recorders {
    pub(crate) by_tag: BTreeMap<Tag, PlacedRecorder>,
    next: Tag,
    pub(crate) interrupt: Option<Arc<AtomicBool>>,
    pub(crate) progress: Option<Box<dyn Progress>>,
    pub(crate) end: Option<f64>,
    /// Norms of the iterations, to be printed.
    pub(crate) printed: String,
    pub(crate) print: i32,
}

impl Recorders {
    /// Add a recorder; its tag.
    pub(crate) fn add(&mut self, recorder: Recorder, span: Option<Span>) -> Tag {
        self.next += 1;
        self.by_tag.insert(self.next, PlacedRecorder { recorder, span, told: false });
        self.next
    }

    /// Record the committed state.
    pub(crate) fn record(&mut self, engine: &mut Engine) -> Result<(), RecordError> {
        self.by_tag.values_mut().try_for_each(|r| r.recorder.record(engine))
    }

    /// An analysis starts from the committed state.
    pub(crate) fn start(&mut self, engine: &mut Engine) {
        self.by_tag.values_mut().for_each(|r| r.recorder.start(engine));
    }

    /// Finish and forget all recorders.
    pub(crate) fn finish(&mut self) -> Result<(), RecordError> {
        let all = std::mem::take(&mut self.by_tag);
        // All of them are finished, whatever the first that cannot be.
        let mut result = Ok(());
        for mut r in all.into_values() {
            result = result.and(r.recorder.finish());
        }
        result
    }

    /// What recorders asked for in vain, told once each.
    pub(crate) fn missing(&mut self) -> Vec<Diagnostic> {
        let tell = |r: &mut PlacedRecorder| {
            let missing = &r.recorder.missing;
            if missing.is_empty() || std::mem::replace(&mut r.told, true) {
                return None;
            }
            let message = format!("recorder: the model has no {}", missing.join(", no "));
            Some(Diagnostic::warning(message).at(r.span, "left out of the record"))
        };
        self.by_tag.values_mut().filter_map(tell).collect()
    }
}

impl Observer for Recorders {
    fn committed(&mut self, engine: &mut Engine) -> Result<(), String> {
        self.record(engine).map_err(|e| e.to_string())?;
        if self.print != 0 {
            self.note_iterations(engine);
        }
        if let Some(p) = &mut self.progress {
            p.step(engine.state().time, self.end);
        }
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

/// What the OpenSees commands of a script work on.
pub struct Session {
    /// The model with its state and analysis.
    pub engine: Engine,
    pub(crate) definitions: Definitions,
    pub(crate) ndm: usize,
    pub(crate) ndf: usize,
    pub(crate) pattern: Option<Tag>,
    pub(crate) parts: Parts,
    pub(crate) regions: BTreeMap<Tag, Region>,
    pub(crate) recorders: Recorders,
    pub(crate) outputs: Box<dyn Outputs>,
    /// Values that a study gives to parameters: they win over `pset`.
    pub parameters: BTreeMap<String, f64>,
    /// Parameters that the script has declared, with their values.
    pub declared: BTreeMap<String, f64>,
    /// Where the value of each stands in the script.
    pub declared_at: BTreeMap<String, Span>,
    /// How the script is run.
    pub mode: Mode,
    /// Warnings are errors.
    pub strict: bool,
    /// A check has passed over an analysis: results that the script reads are not there.
    pub rehearsed: bool,
    /// What a check has found.
    pub findings: Findings,
    /// Why the last `analyze` failed; none if it succeeded.
    pub last_failure: Option<Failure>,
    pub(crate) on_warning: Option<OnWarning>,
    pub(crate) style: Style,
    pub(crate) reaction_kind: ReactionKind,
    /// Steps of time may change their length: `analysis VariableTransient`.
    pub(crate) variable_steps: bool,
    pub(crate) next_sp: Tag,
    pub(crate) next_mp: Tag,
    pub(crate) told: BTreeMap<&'static str, usize>,
    pub(crate) bench: Bench,
    /// Fibers of the section whose body is being run.
    pub(crate) fibers: Option<Vec<Fiber>>,
    /// Files of numbers that runs of the script have read.
    pub number_files: NumberFiles,
    /// Responses of elements that the script has asked for.
    pub(crate) known: Known,
    /// What `parameter` has named.
    pub(crate) numbers: BTreeMap<Tag, Parameter>,
}

impl Session {
    /// Returns true if OpenSees' answer is wanted where these slips differ from it.
    pub fn follows(&self, slips: &[Slip]) -> bool {
        self.engine.options.compat && slips.iter().all(Slip::is_followed)
    }

    /// A session whose recorders write to `outputs`.
    pub fn new(options: Options, mode: Mode, strict: bool, outputs: Box<dyn Outputs>) -> Self {
        Self {
            engine: Engine::new(options),
            definitions: Definitions::default(),
            ndm: 0,
            ndf: 0,
            pattern: None,
            parts: Parts::default(),
            regions: BTreeMap::new(),
            recorders: Recorders::default(),
            outputs,
            parameters: BTreeMap::new(),
            declared: BTreeMap::new(),
            declared_at: BTreeMap::new(),
            mode,
            strict,
            rehearsed: false,
            findings: Findings::default(),
            last_failure: None,
            on_warning: None,
            style: Style::default(),
            reaction_kind: ReactionKind::Static,
            variable_steps: false,
            next_sp: 0,
            next_mp: 0,
            told: BTreeMap::new(),
            bench: Bench::default(),
            fibers: None,
            number_files: NumberFiles::default(),
            known: Known::default(),
            numbers: BTreeMap::new(),
        }
    }

    /// Stop analyses when the flag is set.
    pub fn stop_on(&mut self, flag: Arc<AtomicBool>) {
        self.recorders.interrupt = Some(flag);
    }

    /// Tell about steps.
    pub fn tell(&mut self, progress: Box<dyn Progress>) {
        self.recorders.progress = Some(progress);
    }

    /// Hear of warnings when they come up.
    pub fn on_warning(&mut self, hear: OnWarning) {
        self.on_warning = Some(hear);
    }

    /// Finish the recorders.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn finish(&mut self) -> Result<(), RecordError> {
        self.recorders.finish()
    }

    /// Forget everything but the settings.
    pub(crate) fn wipe(&mut self) -> Result<(), RecordError> {
        let finished = self.recorders.finish();
        self.engine.wipe();
        self.definitions = Definitions::default();
        self.bench = Bench::default();
        self.numbers.clear();
        self.known = Known::default();
        (self.ndm, self.ndf, self.pattern) = (0, 0, None);
        self.parts = Parts::default();
        self.regions.clear();
        finished
    }

    /// Kind of the analysis that is set up.
    pub(crate) fn kind(&self) -> Option<Kind> {
        self.engine.setup().map(|s| s.kind)
    }

    /// Number for the next single-point constraint.
    pub(crate) fn sp_tag(&mut self) -> Tag {
        self.next_sp += 1;
        self.next_sp - 1
    }

    /// Number for the next multi-point constraint.
    pub(crate) fn mp_tag(&mut self) -> Tag {
        self.next_mp += 1;
        self.next_mp - 1
    }

    /// A node has been removed: the numbers of those behind it have moved down.
    pub(crate) fn forget_node(&mut self, node: NodeId) {
        for r in self.regions.values_mut() {
            r.nodes.retain(|n| *n != node);
            r.nodes.iter_mut().filter(|n| n.0 > node.0).for_each(|n| n.0 -= 1);
        }
    }

    /// An element has been removed, likewise.
    pub(crate) fn forget_element(&mut self, element: ElementId) {
        for r in self.regions.values_mut() {
            r.elements.retain(|e| *e != element);
            r.elements.iter_mut().filter(|e| e.0 > element.0).for_each(|e| e.0 -= 1);
        }
    }
}
