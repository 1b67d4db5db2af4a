//! Calls of single commands by a host program, without a script.
//!
//! ```
//! use hysteron_opensees::run::{Run, Settings};
//! use hysteron_opensees::{Mode, calls};
//! # use hysteron_engine::analysis::Options;
//! # use hysteron_tcl::{MemoryFiles, Recorded, Value};
//! # struct None;
//! # impl hysteron_opensees::Outputs for None {
//! #     fn create(&mut self, _: &str, _: &std::path::Path, _: hysteron_opensees::FileFormat)
//! #         -> Result<Box<dyn hysteron_engine::record::Output>, hysteron_engine::record::RecordError> {
//! #         Ok(Box::new(hysteron_engine::record::Memory::default()))
//! #     }
//! # }
//! let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
//! let mut run = Run::for_calls(settings, Box::new(Recorded::default()), Box::new(MemoryFiles::default()), Box::new(None));
//! let mut call = |words: &[&str]| {
//!     let command = calls::command(words[0]).unwrap();
//!     run.call(command, &words.iter().map(|w| Value::from(*w)).collect::<Vec<_>>())
//! };
//! call(&["model", "BasicBuilder", "-ndm", "1"]).unwrap();
//! call(&["node", "1", "0.5"]).unwrap();
//! assert_eq!(call(&["nodeCoord", "1", "1"]).unwrap().to_f64().unwrap(), 0.5);
//! ```

use crate::call_numbers::next_number;
use crate::check;
use crate::files::live::RecordedFiles;
use crate::mistakes;
use crate::run::{Run, Settings};
use crate::section::{fiber, open};
use crate::slips;
use crate::{Command, Outcome, Outputs, Session, opensees_names};

use hysteron_engine::analysis::Failure;
use hysteron_engine::model::{ElementId, NodeId};
use hysteron_engine::record::ElementResponse;
use hysteron_tcl::diagnostic::{Absent, Span};
use hysteron_tcl::{Call, Console, Files, Interp, Value};

pub use crate::call_numbers::CallNumbers;
pub use crate::command;

/// A call whose words stand in a text.
#[derive(Clone, Copy, Debug)]
pub struct PlacedCall<'a> {
    /// The words, the first of which is the name of the command.
    pub words: &'a [Value],
    /// Place of each word.
    pub spans: &'a [Span],
    /// Place of the whole call.
    pub whole: Span,
}

/// Returns true if a command only looks at the model and its results.
pub fn only_looks(command: &Command) -> bool {
    check::LOOKING.into_iter().flatten().any(|c| c.name == command.name)
}

impl Run {
    /// Prepare to call commands one by one with [`Run::call`].
    ///
    /// The interpreter shares nothing with others of the thread.
    pub fn for_calls(
        settings: Settings,
        console: Box<dyn Console>,
        files: Box<dyn Files>,
        outputs: Box<dyn Outputs>,
    ) -> Self {
        let session = Session::new(settings.options, settings.mode, settings.strict, outputs);
        let files = RecordedFiles::new(files, session.output.recorders.live.clone());
        let mut interp = Interp::new(session, console, Box::new(files));
        crate::install(&mut interp);
        interp.unknown_command_label = opensees_names::command_label;
        interp.core.follow_current_dir();
        interp.host.called_by_host = true;
        let interrupt = interp.interrupt.clone();
        interp.host.stop_on(interrupt);
        Self { interp, partial: vec![] }
    }

    /// Call a command with its words, the first of which is its name.
    ///
    /// Fibers of a section, loads of a pattern and motions of supports are commands of their own after the command that
    /// has a body in a script.
    ///
    /// # Errors
    /// The command is rejected. The places in the message are those of [`CallNumbers`].
    pub fn call(&mut self, command: &'static Command, words: &[Value]) -> Outcome {
        let (source, number) = next_number(&mut self.interp);
        self.interp.host.analysis_checks.passed = None;
        let is_open = self.interp.host.builder.open_section.is_some();
        if is_open && !fiber::COMMANDS.iter().any(|c| c.name == command.name) {
            open::settle(&mut self.interp)?;
        }
        (command.run)(&mut self.interp, &Call::numbered(words, source, number))
    }

    /// Check a call whose words stand in a text: its mistakes are added to the warnings. The run has been prepared by
    /// [`Run::for_calls`] in the mode of a check.
    ///
    /// # Errors
    /// The check was interrupted, or the command ends it.
    pub fn check(&mut self, command: &'static Command, call: &PlacedCall<'_>) -> Outcome {
        let interp = &mut self.interp;
        interp.host.analysis_checks.passed = None;
        let is_open = interp.host.builder.open_section.is_some();
        if is_open && !fiber::COMMANDS.iter().any(|c| c.name == command.name) {
            let settled = open::settle(interp);
            mistakes::go_on(interp, settled)?;
        }
        let first = interp.warnings.len();
        let result = check::run_known(interp, command, &Call::placed(call.words, call.spans, call.whole));
        for found in self.interp.warnings.iter_mut().skip(first).filter(|w| w.span.is_none()) {
            found.span = Some(call.whole);
        }
        result
    }

    /// Define what a call missed in the last check, so that the same call can be checked further. Returns false where nothing
    /// stands in for it.
    pub fn stand_in(&mut self, absent: &Absent) -> bool {
        check::stand_in::define_any(&mut self.interp, absent)
    }

    /// End a check of calls without looking at what the model would do: more may be called than is known.
    pub fn leave(&mut self) {
        self.interp.host.close_index();
    }
}

impl Session {
    /// Number of calls by a host.
    pub fn call_numbers(&self) -> CallNumbers {
        self.call_numbers
    }

    /// Reactions at all degrees of freedom in the committed state, of the kind that `reactions` has set.
    ///
    /// # Errors
    /// The model cannot be evaluated.
    pub fn reactions(&mut self) -> Result<Vec<f64>, Failure> {
        if self.follows(&[slips::KEPT_REACTIONS]) {
            return Ok(self.engine.kept_reactions());
        }
        let mut all = vec![];
        self.engine.reactions(self.output.reaction_kind, &mut all)?;
        Ok(all)
    }

    /// Degrees of freedom of a node in the arrays of the state.
    pub fn node_dofs(&self, node: NodeId) -> std::ops::Range<usize> {
        self.engine.model().nodes[node.0].dofs()
    }

    /// Response of an element in the committed state, by the words that name it; `None` if it has none of that name.
    pub fn element_response(&mut self, element: ElementId, words: &[&str]) -> Option<Vec<f64>> {
        ElementResponse::evaluate(&self.engine, element, words, &mut self.output.known)
    }
}
