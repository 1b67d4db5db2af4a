//! State that the OpenSees commands of a script work on.

use crate::call_numbers::CallNumbers;
use crate::course::Course;
use crate::files::number_files::NumberFiles;
use crate::files::outputs::Outputs;
use crate::host::{BeforeTransient, Mode, MotionObserver, OnWarning, Progress};
use crate::index::Index;
use crate::load::late_support::LateSupport;
use crate::material::MaterialTests;
use crate::mistakes::CheckState;
use crate::model::parameter_change::{ParameterChanges, ScriptStart};
use crate::output::Balances;
use crate::output::model_file::Components;
use crate::output::recorders::Recorders;
use crate::parameter::Parameter;
use crate::recipes::WordsOfElement;
use crate::section::fiber::ContinuumFiber;
use crate::section::open::OpenSection;
use crate::slips::Slip;
use crate::watch::overview::Overview;
use crate::watch::{AnalysisChecks, Checked};
use hysteron_engine::analysis::algorithm::Algorithm;
use hysteron_engine::analysis::integrator::Integrator;
use hysteron_engine::analysis::{Engine, Failure, Kind, MatrixTerms, Options, ReactionKind, Test};
use hysteron_engine::assembly::Handler;
use hysteron_engine::model::{Definitions, ElementId, NodeId, Tag};
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{Known, RecordError};
use hysteron_engine::section::Fiber;
use hysteron_tcl::Watch;
use hysteron_tcl::diagnostic::{Check, Span};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The parts of an analysis as the commands have given them so far.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub(crate) handler: Option<Handler>,
    pub(crate) test: Option<Test>,
    pub(crate) algorithm: Option<Box<dyn Algorithm>>,
    pub(crate) integrator: Option<Box<dyn Integrator>>,
    /// Terms of the matrix that the system of equations holds in OpenSees.
    pub(crate) matrix_terms: Option<MatrixTerms>,
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

/// State of the commands that build the model.
#[derive(Default)]
pub struct ModelBuilder {
    /// Time for which the loads were applied last, where a command has set another time since.
    pub(crate) loads_time: Option<f64>,
    /// Materials, series, sections and the like, by tag.
    pub definitions: Definitions,
    /// Definitions that each element was made of.
    pub(crate) components: Components,
    /// Words that each element between two nodes was made from.
    pub(crate) element_words: BTreeMap<Tag, WordsOfElement>,
    /// Place in the script of the command that made each element.
    pub made_at: BTreeMap<i32, Span>,
    /// Number of dimensions.
    pub(crate) ndm: usize,
    /// Degrees of freedom of a node, unless it has its own number.
    pub(crate) ndf: usize,
    /// Dimensions and degrees of freedom before `wipe`.
    pub(crate) former: Option<(usize, usize)>,
    /// The pattern that loads go into.
    pub(crate) pattern: Option<Tag>,
    pub(crate) regions: BTreeMap<Tag, Region>,
    /// Supports that uniform excitations reach later.
    pub(crate) late_supports: Vec<LateSupport>,
    /// Fibers of the section whose body runs.
    pub(crate) fibers: Option<Vec<Fiber>>,
    /// Fibers of the body of `section NDFiber` that is being run.
    pub(crate) continuum_fibers: Option<Vec<ContinuumFiber>>,
    /// The section that takes fibers outside a body, in calls by a host.
    pub(crate) open_section: Option<OpenSection>,
    /// Parameters that `parameter` has named, by tag.
    pub(crate) parameters: BTreeMap<Tag, Parameter>,
    pub(crate) material_tests: MaterialTests,
    next_sp: Tag,
    next_mp: Tag,
}

impl ModelBuilder {
    /// Tags of the uniaxial materials that elements take themselves. Other materials are those of sections and wrappers.
    pub fn materials_of_elements(&self) -> BTreeSet<Tag> {
        let kind = self.definitions.materials.kind;
        self.components.values().flatten().filter(|(k, _)| *k == kind).map(|(_, tag)| *tag).collect()
    }

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
    /// Codes of the checks that warn once in a script, and have.
    given: BTreeSet<&'static str>,
}

impl Warnings {
    /// Returns true if a check that warns once in a script has warned.
    pub(crate) fn has(&self, check: &'static Check) -> bool {
        self.given.contains(check.code)
    }

    /// Note that a check has warned. Returns true if it is the first time.
    pub(crate) fn note(&mut self, check: &'static Check) -> bool {
        self.given.insert(check.code)
    }
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
    pub(crate) analysis_checks: AnalysisChecks,
    /// What a check finds out about the first model that is analysed.
    pub overview: Overview,
    /// The first failure of an `analyze` whose result nobody has looked at.
    pub(crate) ignored_failure: Option<Failure>,
    /// The commands are called by a host: bodies follow as commands of their own.
    pub(crate) called_by_host: bool,
    pub(crate) call_numbers: CallNumbers,
    /// Files of numbers that runs of the script have read.
    pub number_files: NumberFiles,
    /// Course of the run, where it is followed.
    pub course: Option<Course>,
    /// Call by a host before the first transient analysis.
    pub(crate) before_transient: Option<BeforeTransient>,
    /// Index of the script, where a check is to make one.
    pub index: Option<Box<Index>>,
    /// Script that is run; `None` where a host calls single commands.
    pub(crate) start: Option<ScriptStart>,
    /// Parameters that change in time.
    pub(crate) changes: ParameterChanges,
    /// Parameters with respect to which derivatives are found with each step, as they were when an analysis last began; `None`
    /// where no derivatives are wanted.
    pub(crate) derived: Option<BTreeMap<Tag, Parameter>>,
    /// The run is made for its elements: it ends where the first analysis would begin.
    pub(crate) ends_at_analysis: bool,
}

impl Session {
    /// Returns true under `--compat opensees`.
    pub(crate) fn is_compat(&self) -> bool {
        self.engine.options.compat
    }

    /// Returns true if OpenSees' answer is wanted where these slips differ from it; of no slips, where any does.
    pub fn follows(&self, slips: &[Slip]) -> bool {
        self.is_compat() && slips.iter().all(Slip::is_followed)
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
            analysis_checks: AnalysisChecks::default(),
            overview: Overview::default(),
            ignored_failure: None,
            called_by_host: false,
            call_numbers: CallNumbers::default(),
            number_files: NumberFiles::default(),
            course: None,
            before_transient: None,
            index: None,
            start: None,
            changes: ParameterChanges::default(),
            derived: None,
            ends_at_analysis: false,
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

    /// Do something before the first step of the first transient analysis, for instance add recorders. An exception ends the
    /// command `analyze`.
    pub fn before_transient(&mut self, hook: BeforeTransient) {
        self.before_transient = Some(hook);
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
        if self.mode == Mode::Check {
            self.overview.close(&mut self.engine);
        }
        self.close_index();
        self.engine.wipe();
        self.builder = self.builder.wiped();
        self.output.known = Known::default();
        self.analysis_checks = AnalysisChecks::default();
        self.output.recorders.forget_model();
        self.parts = Parts { variable_steps: self.parts.variable_steps, ..Parts::default() };
        self.changes = ParameterChanges::default();
        self.derived = None;
        finished
    }

    /// The checks before an analysis with steps of `dt` have been made, and stand until the next command.
    pub(crate) fn note_checked(&mut self, kind: Kind, dt: f64) {
        let is_plain = self.mode == Mode::Run
            && !self.parts.variable_steps
            && self.output.recorders.journal.is_none()
            && self.changes.is_empty();
        self.analysis_checks.passed = (is_plain && self.called_by_host).then_some(Checked { kind, dt });
    }

    /// Keep the model in the index, before it is forgotten or at the end.
    pub(crate) fn close_index(&mut self) {
        if let Some(index) = &mut self.index {
            index.close_model(self.engine.model(), &self.builder.definitions);
        }
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
