//! State that the OpenSees commands of a script work on.

use crate::analysis::isolator_damping::IsolatorDamping;
use crate::analysis::plausibility::Looked;
use crate::analysis::softening::BackboneWatch;
use crate::calls::CallNumbers;
use crate::check::CheckState;
use crate::checkpoint::Journal;
use crate::files::number_files::NumberFiles;
use crate::files::series::{FileSeries, NoSeries};
use crate::material::MaterialTests;
use crate::model::parameter::Parameter;
use crate::output::Balances;
use crate::output::model_file::MadeOf;
use crate::section::open::OpenSection;
use crate::slips::Slip;
use hysteron_engine::analysis::algorithm::Algorithm;
use hysteron_engine::analysis::integrator::Integrator;
use hysteron_engine::analysis::{Engine, Failure, Kind, Observer, Options, ReactionKind, Test};
use hysteron_engine::assembly::Handler;
use hysteron_engine::model::{Definitions, ElementId, NodeId, Tag};
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{Known, Layout, Output, RecordError, Recorder};
use hysteron_engine::section::Fiber;
use hysteron_tcl::Watch;
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, Span};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Purpose of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Run: compute the results.
    Run,
    /// Check: find mistakes; analyses are passed over.
    Check,
}

/// Format of a recorder's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileFormat {
    /// Numbers.
    pub style: Style,
    /// Layout of the rows.
    pub layout: Layout,
    /// Every row at once.
    pub close_on_write: bool,
}

/// Destination of recorders: files, or the memory of a study.
pub trait Outputs {
    /// An output by the name the script gives it, and as a path that is not relative to anything.
    ///
    /// # Errors
    /// It cannot be made.
    fn create(&mut self, name: &str, path: &Path, format: FileFormat) -> Result<Box<dyn Output>, RecordError>;

    /// The place of a file and of a folder of its name without ending beside it, for recorders that write many files.
    /// By default nothing is kept.
    ///
    /// # Errors
    /// The folder cannot be made.
    fn series(&mut self, _name: &str, _path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        Ok(Box::new(NoSeries))
    }
}

/// Receiver of the progress of an analysis.
pub trait Progress {
    /// A step has been committed at this time; `end` is the time at which the excitation ends, where that is known.
    fn step(&mut self, time: f64, end: Option<f64>);
}

/// Receiver of the motion of a model, for programs that show it.
pub trait MotionObserver {
    /// An analysis begins with the committed state.
    fn start(&mut self, engine: &Engine);
    /// A step has been committed.
    fn step(&mut self, engine: &Engine);
    /// The script is about to forget the model.
    fn wipe(&mut self, engine: &mut Engine);
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
    /// Steps of time may change their length: `analysis VariableTransient`.
    pub(crate) variable_steps: bool,
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
    /// Places of the tags that the command names, by the words of a message: "node 3".
    pub(crate) tags: BTreeMap<String, Span>,
    /// Path of its file.
    pub(crate) path: Option<String>,
    /// The same as the script names it.
    pub(crate) file: Option<String>,
    /// The words of the command.
    pub(crate) words: Vec<String>,
    pub(crate) reported: bool,
}

/// The recorders of a model, and who else wants to know about steps.
#[derive(Default)]
pub(crate) struct Recorders {
    pub(crate) by_tag: BTreeMap<Tag, PlacedRecorder>,
    next: Tag,
    pub(crate) interrupt: Option<Arc<AtomicBool>>,
    pub(crate) progress: Option<Box<dyn Progress>>,
    pub(crate) end: Option<f64>,
    /// Balances of energy, where they are asked for.
    pub(crate) balances: Option<Box<Balances>>,
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

    /// Record the committed state.
    pub(crate) fn record(&mut self, engine: &mut Engine) -> Result<(), RecordError> {
        self.by_tag.values_mut().try_for_each(|r| r.recorder.record(engine).map(drop))
    }

    /// An analysis starts from the committed state.
    pub(crate) fn start(&mut self, engine: &mut Engine) {
        if let Some(balances) = &mut self.balances {
            balances.start(engine);
        }
        self.by_tag.values_mut().for_each(|r| r.recorder.start(engine));
        if let Some(motion) = &mut self.motion {
            motion.start(engine);
        }
    }

    /// Finish and forget all recorders.
    pub(crate) fn finish(&mut self) -> Result<(), RecordError> {
        let all = std::mem::take(&mut self.by_tag);
        // An error of one recorder must not keep the others from being finished.
        let mut result = Ok(());
        for mut r in all.into_values() {
            result = result.and(r.recorder.finish());
        }
        result
    }

    /// Warnings about responses that recorders asked for in vain, once for each recorder. What `held_back` tells of
    /// is left out.
    pub(crate) fn missing(&mut self, mut held_back: impl FnMut(&str) -> bool) -> Vec<Diagnostic> {
        let mut warning = |r: &mut PlacedRecorder| {
            if r.recorder.missing.is_empty() || std::mem::replace(&mut r.reported, true) {
                return None;
            }
            let missing = r.recorder.missing.iter().filter(|m| !held_back(m));
            let missing: Vec<&str> = missing.map(String::as_str).collect();
            let first = missing.first()?;
            let place = r.tags.get(*first).copied().or(r.span);
            let message = format!("recorder: the model has no {}", missing.join(", no "));
            Some(Diagnostic::warning(message).at(place, "left out of the record"))
        };
        self.by_tag.values_mut().filter_map(&mut warning).collect()
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

/// State of the commands that build the model.
#[derive(Default)]
pub struct ModelBuilder {
    /// Time for which the loads were applied last, where a command has set another time since.
    pub(crate) loads_time: Option<f64>,
    /// Materials, series, sections and the like, by tag.
    pub definitions: Definitions,
    /// Definitions that each element was made of.
    pub(crate) made_of: MadeOf,
    /// Number of dimensions.
    pub(crate) ndm: usize,
    /// Degrees of freedom of a node, unless it has its own number.
    pub(crate) ndf: usize,
    /// Dimensions and degrees of freedom before `wipe`.
    pub(crate) former: Option<(usize, usize)>,
    /// The pattern that loads go into.
    pub(crate) pattern: Option<Tag>,
    pub(crate) regions: BTreeMap<Tag, Region>,
    /// Fibers of the section whose body runs.
    pub(crate) fibers: Option<Vec<Fiber>>,
    /// The section that takes fibers outside a body, in calls by a host.
    pub(crate) open_section: Option<OpenSection>,
    /// Parameters that `parameter` has named, by tag.
    pub(crate) parameters: BTreeMap<Tag, Parameter>,
    pub(crate) material_tests: MaterialTests,
    next_sp: Tag,
    next_mp: Tag,
}

impl ModelBuilder {
    /// The state after `wipe`: tags of constraints go on.
    fn wiped(&mut self) -> Self {
        let former = if self.ndm > 0 { Some((self.ndm, self.ndf)) } else { self.former };
        Self { former, fibers: self.fibers.take(), next_sp: self.next_sp, next_mp: self.next_mp, ..Self::default() }
    }
}

/// State of the commands that show results.
pub(crate) struct OutputState {
    pub(crate) recorders: Recorders,
    pub(crate) outputs: Box<dyn Outputs>,
    pub(crate) style: Style,
    pub(crate) reaction_kind: ReactionKind,
    /// Responses of elements that the script has asked for.
    pub(crate) known: Known,
}

/// Warnings of the commands.
#[derive(Default)]
pub(crate) struct Warnings {
    pub(crate) handler: Option<OnWarning>,
    /// Warnings that are given once, by a key.
    pub(crate) reported: BTreeMap<&'static str, usize>,
}

/// State that the OpenSees commands of a script work on.
pub struct Session {
    /// The model with its state and analysis.
    pub engine: Engine,
    /// Definitions by tag and the state of the model builder.
    pub builder: ModelBuilder,
    pub(crate) parts: Parts,
    pub(crate) output: OutputState,
    /// Values that a study gives to parameters: they win over `pset`.
    pub parameters: BTreeMap<String, f64>,
    /// Parameters that the script has declared, with their values.
    pub declared: BTreeMap<String, f64>,
    /// Place of each declared value in the script.
    pub declared_at: BTreeMap<String, Span>,
    /// Watches of the variables of declared parameters; `None` if they are not watched.
    pub watches: Option<BTreeMap<String, Watch>>,
    /// Purpose of the run.
    pub mode: Mode,
    /// Warnings are errors.
    pub strict: bool,
    /// Mistakes that a check has found.
    pub check: CheckState,
    /// Failure of the last `analyze`; none if it succeeded.
    pub last_failure: Option<Failure>,
    pub(crate) warnings: Warnings,
    /// Kinds that the script has made, by command, with their numbers.
    pub kinds_made: BTreeMap<(&'static str, &'static str), usize>,
    /// Name of the database that states are saved in.
    pub(crate) database: Option<String>,
    /// Patterns and models that the warnings about analyses have looked at.
    pub(crate) looked: Looked,
    /// The first failure of an `analyze` whose result nobody has looked at.
    pub(crate) ignored_failure: Option<Failure>,
    /// The commands are called by a host: bodies follow as commands of their own.
    pub(crate) called_by_host: bool,
    pub(crate) call_numbers: CallNumbers,
    /// Files of numbers that runs of the script have read.
    pub number_files: NumberFiles,
}

impl Session {
    /// Returns true if OpenSees' answer is wanted where these slips differ from it; of no slips, where any does.
    pub fn follows(&self, slips: &[Slip]) -> bool {
        self.engine.options.compat && slips.iter().all(Slip::is_followed)
    }

    /// A session whose recorders write to `outputs`.
    pub fn new(options: Options, mode: Mode, strict: bool, outputs: Box<dyn Outputs>) -> Self {
        Self {
            engine: Engine::new(options),
            builder: ModelBuilder::default(),
            parts: Parts::default(),
            output: OutputState {
                recorders: Recorders::default(),
                outputs,
                style: Style::default(),
                reaction_kind: ReactionKind::Static,
                known: Known::default(),
            },
            parameters: BTreeMap::new(),
            declared: BTreeMap::new(),
            declared_at: BTreeMap::new(),
            watches: None,
            mode,
            strict,
            check: CheckState::default(),
            last_failure: None,
            warnings: Warnings::default(),
            kinds_made: BTreeMap::new(),
            database: None,
            looked: Looked::default(),
            ignored_failure: None,
            called_by_host: false,
            call_numbers: CallNumbers::default(),
            number_files: NumberFiles::default(),
        }
    }

    /// Stop analyses when the flag is set.
    pub fn stop_on(&mut self, flag: Arc<AtomicBool>) {
        self.engine.interrupt = Some(flag.clone());
        self.output.recorders.interrupt = Some(flag);
    }

    /// Files that recorders are writing, as the script names them.
    pub fn open_files(&self) -> Vec<String> {
        let mut files: Vec<String> = self.output.recorders.by_tag.values().filter_map(|r| r.file.clone()).collect();
        files.sort();
        files.dedup();
        files
    }

    /// Report steps to `progress`.
    pub fn set_progress(&mut self, progress: Box<dyn Progress>) {
        self.output.recorders.progress = Some(progress);
    }

    /// Sum the energies of the analyses, with their history if `history`.
    pub fn balance_energy(&mut self, history: bool) {
        self.output.recorders.balances = Some(Box::new(Balances::new(history)));
    }

    /// Balances of energy, where they are asked for.
    pub fn balances(&self) -> Option<&Balances> {
        self.output.recorders.balances.as_deref()
    }

    /// Note that a command makes a kind.
    pub(crate) fn note_kind(&mut self, command: &'static str, kind: &'static str) {
        *self.kinds_made.entry((command, kind)).or_default() += 1;
    }

    /// Report the motion of the model to `motion`.
    pub fn observe_motion(&mut self, motion: Box<dyn MotionObserver>) {
        self.output.recorders.motion = Some(motion);
    }

    /// Call `handler` with each warning when it comes up.
    pub fn on_warning(&mut self, handler: OnWarning) {
        self.warnings.handler = Some(handler);
    }

    /// Finish the recorders.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn finish(&mut self) -> Result<(), RecordError> {
        self.output.recorders.finish()
    }

    /// Share of the energy into the isolators so far that Rayleigh damping took; 0 without any.
    pub fn isolator_damping_share(&self) -> f64 {
        self.output.recorders.isolator_damping.share()
    }

    /// Forget everything but the settings.
    pub(crate) fn wipe(&mut self) -> Result<(), RecordError> {
        let finished = self.output.recorders.finish();
        if let Some(balances) = &mut self.output.recorders.balances {
            balances.next_model();
        }
        if let Some(motion) = &mut self.output.recorders.motion {
            motion.wipe(&mut self.engine);
        }
        self.engine.wipe();
        self.builder = self.builder.wiped();
        self.output.known = Known::default();
        self.looked = Looked::default();
        self.output.recorders.isolator_damping = IsolatorDamping::default();
        self.output.recorders.backbones = BackboneWatch::default();
        self.parts = Parts { variable_steps: self.parts.variable_steps, ..Parts::default() };
        finished
    }

    /// Kind of the analysis that is set up.
    pub(crate) fn kind(&self) -> Option<Kind> {
        self.engine.setup().map(|s| s.kind)
    }

    /// Number for the next single-point constraint.
    pub(crate) fn sp_tag(&mut self) -> Tag {
        self.builder.next_sp += 1;
        self.builder.next_sp - 1
    }

    /// Number for the next multi-point constraint.
    pub(crate) fn mp_tag(&mut self) -> Tag {
        self.builder.next_mp += 1;
        self.builder.next_mp - 1
    }

    /// A node has been removed: the numbers of those behind it have moved down.
    pub(crate) fn forget_node(&mut self, node: NodeId) {
        for r in self.builder.regions.values_mut() {
            r.nodes.retain(|n| *n != node);
            r.nodes.iter_mut().filter(|n| n.0 > node.0).for_each(|n| n.0 -= 1);
        }
    }

    /// An element has been removed, likewise.
    pub(crate) fn forget_element(&mut self, element: ElementId) {
        for r in self.builder.regions.values_mut() {
            r.elements.retain(|e| *e != element);
            r.elements.iter_mut().filter(|e| e.0 > element.0).for_each(|e| e.0 -= 1);
        }
    }
}
