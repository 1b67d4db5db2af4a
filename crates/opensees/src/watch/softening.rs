//! Bearings whose backbone pushes away from rest.
//!
//! A bearing with alpha2 < 0 softens as it was calibrated to. Far enough beyond that range its backbone changes its sign, and a
//! structure on it is driven away.

use crate::checks;
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::Softening;
use hysteron_engine::model::ElementId;
use hysteron_tcl::diagnostic::{Diagnostic, Span};

/// Watches the committed deformations of elements that soften.
#[derive(Debug, Default)]
pub(crate) struct BackboneWatch {
    /// Revision of the model that the elements were looked up in.
    revision: Option<u64>,
    elements: Vec<ElementId>,
    /// The first element beyond its end, and the time.
    found: Option<(String, Softening, f64)>,
}

impl BackboneWatch {
    /// Look up the elements that soften, where the model has changed.
    pub(crate) fn begin(&mut self, engine: &Engine) {
        let model = engine.model();
        // Scripts may call "analyze" for each step.
        if self.revision == Some(model.revision()) {
            return;
        }
        self.revision = Some(model.revision());
        self.elements = (0..model.elements.len()).map(ElementId).filter(|id| engine.softening(*id).is_some()).collect();
    }

    /// Look at a step that has been committed.
    pub(crate) fn step(&mut self, engine: &Engine) {
        if self.found.is_some() {
            return;
        }
        let beyond = |id: &ElementId| engine.softening(*id).filter(|s| s.deformation > s.force_end).map(|s| (*id, s));
        if let Some((id, softening)) = self.elements.iter().find_map(beyond) {
            let e = &engine.model().elements[id.0];
            self.found = Some((format!("{} {}", e.element.class().name, e.tag), softening, engine.state().time));
        }
    }

    /// The warning about the first element that has gone beyond its end.
    pub(crate) fn warning(&self, span: Option<Span>) -> Option<Diagnostic> {
        let (name, s, time) = self.found.as_ref()?;
        let message = format!(
            "the backbone of {name} is negative: its shear is {:.4e} at time {time:.3}, and beyond {:.4e} it pushes away from rest",
            s.deformation, s.force_end
        );
        let d = Diagnostic::warning(&checks::analysis::SOFTENING_BEARING, message)
            .at(span, "alpha2 < 0 holds within the shear that it was calibrated to");
        Some(d.help(format!("the stiffness of the backbone is negative from {:.4e} on", s.stiffness_end)))
    }
}
