//! Responses that OpenSees does not know.

use crate::analysis::Engine;
use crate::model::ElementId;
use crate::probe::Probe;

/// The response of an element by its words. OpenSees' elastic beam in the plane has its deformations under another name.
pub(super) fn probe(engine: &Engine, id: ElementId, words: &[&str]) -> Option<Probe> {
    let element = &engine.model().elements[id.0].element;
    let lacks = engine.options.compat && words == ["deformations"] && element.class().name == "ElasticBeam2d";
    if lacks { None } else { element.probe(words) }
}
