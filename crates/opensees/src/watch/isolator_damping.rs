//! Energy that Rayleigh damping takes out of isolators.
//!
//! Factors of a whole model act on its isolators too, whose initial stiffness is large: damping forces that no bearing has may
//! then carry a good part of the base shear (Ryan and Polanco, 2008, J. Struct. Eng. 134, 1780-1784).

use crate::checks;
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::{ElementEntry, ElementId, Tag};
use hysteron_tcl::diagnostic::{Diagnostic, Span};

/// Classes that are isolators where they are not linear.
const LINKS: [&str; 3] = ["ZeroLength", "TwoNodeLink", "CoupledZeroLength"];
/// Share of the energy that is no mistake yet.
const MIN_SHARE: f64 = 0.05;

/// Energies of the isolators that Rayleigh damping acts on.
#[derive(Debug, Default)]
pub(crate) struct IsolatorDamping {
    /// Revision of the model that the isolators were looked up in.
    revision: Option<u64>,
    elements: Vec<ElementId>,
    tags: Vec<Tag>,
    time: f64,
    damping: f64,
    force: f64,
}

/// Returns true if an element may be an isolator: a bearing, or a link that is not linear.
pub fn may_isolate(e: &ElementEntry) -> bool {
    e.element.bearing().is_some() || !e.element.traits().linear && LINKS.contains(&e.element.class().name)
}

fn is_isolator(e: &ElementEntry) -> bool {
    let traits = e.element.traits();
    let r = &e.rayleigh;
    let is_damped = traits.rayleigh && [r.beta_k, r.beta_k0, r.beta_kc].iter().any(|b| *b != 0.0);
    is_damped && may_isolate(e)
}

impl IsolatorDamping {
    /// Energies from the committed state on; those before it are kept while the isolators are the same.
    pub(crate) fn begin(&mut self, engine: &Engine) {
        let model = engine.model();
        self.time = engine.state().time;
        // Scripts may call "analyze" for each step.
        if self.revision == Some(model.revision()) {
            return;
        }
        let isolators = || model.elements.iter().enumerate().filter(|(_, e)| is_isolator(e));
        let tags: Vec<Tag> = isolators().map(|(_, e)| e.tag).collect();
        if tags != self.tags {
            *self = Self { tags, ..Self::default() };
        }
        self.elements = isolators().map(|(i, _)| ElementId(i)).collect();
        (self.time, self.revision) = (engine.state().time, Some(model.revision()));
    }

    /// Add the work of a step that has been committed.
    pub(crate) fn add_step(&mut self, engine: &Engine) {
        if self.elements.is_empty() {
            return;
        }
        let time = engine.state().time;
        let dt = time - std::mem::replace(&mut self.time, time);
        for id in &self.elements {
            let power = engine.element_power(*id);
            self.damping += power.damping * dt;
            self.force += power.force * dt;
        }
    }

    /// Energies of damping and of force.
    pub(crate) fn energies(&self) -> [f64; 2] {
        [self.damping, self.force]
    }

    /// Go on from the energies of an earlier run, which belong to the committed state.
    pub(crate) fn go_on(&mut self, engine: &Engine, [damping, force]: [f64; 2]) {
        (self.time, self.damping, self.force) = (engine.state().time, damping, force);
    }

    /// Share of the energy that the damping took; 0 without any.
    pub(crate) fn share(&self) -> f64 {
        let share = self.damping / (self.damping + self.force.max(0.0));
        if self.elements.is_empty() || !share.is_finite() { 0.0 } else { share }
    }

    /// Returns true if the share of the energy is too large.
    pub(crate) fn is_suspect(&self) -> bool {
        self.share() >= MIN_SHARE
    }

    /// The warning about a share of the energy that is too large.
    pub(crate) fn warning(&self, span: Option<Span>) -> Option<Diagnostic> {
        if !self.is_suspect() {
            return None;
        }
        let share = self.share();
        let which = match self.tags[..] {
            [one] => format!("isolator {one}"),
            [first, .., last] => format!("the {} isolators, elements {first} to {last}", self.tags.len()),
            [] => return None,
        };
        let message = format!("Rayleigh damping takes {:.0} % of the energy that goes into {which}", 100.0 * share);
        let d =
            Diagnostic::warning(&checks::analysis::DAMPED_ISOLATORS, message).at(span, "a bearing has no such damping");
        Some(
            d.help("give the factors to the superstructure alone: \"region ... -ele ... -rayleigh\", or -doRayleigh 0"),
        )
    }
}
