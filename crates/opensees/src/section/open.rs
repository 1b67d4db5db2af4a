//! A fiber section without a body: its fibers follow in commands of their own, as a host calls them.

use super::{FiberOptions, fiber_options};
use crate::args::Args;
use crate::{Outcome, Tcl};
use hysteron_engine::model::Tag;
use hysteron_engine::section::Fiber;
use hysteron_tcl::{Exception, Value};

/// A fiber section that takes fibers until the next `section`.
pub(crate) struct OpenSection {
    tag: Tag,
    options: FiberOptions,
    fibers: Vec<Fiber>,
    changed: bool,
}

impl OpenSection {
    /// Add a fiber.
    pub(crate) fn push(&mut self, fiber: Fiber) {
        self.fibers.push(fiber);
        self.changed = true;
    }
}

/// Take the options of `section Fiber`; fibers are to follow.
pub(super) fn open(interp: &mut Tcl, a: &mut Args<'_>, tag: Tag) -> Outcome {
    let span = a.last_span();
    let definitions = &interp.host.builder.definitions;
    if definitions.sections.get(tag).is_some() || definitions.plates.get(tag).is_some() {
        return Err(a.refuse_at(span, format!("there is a section {tag} already"), "expected a new tag"));
    }
    let options = fiber_options(interp, a, 0)?;
    interp.host.builder.open_section = Some(OpenSection { tag, options, fibers: vec![], changed: false });
    Ok(Value::EMPTY)
}

/// Define the open section with the fibers that it has by now. Elements that have it already keep what they have.
pub(crate) fn settle(interp: &mut Tcl) -> Result<(), Exception> {
    let builder = &mut interp.host.builder;
    let Some(open) = builder.open_section.as_mut().filter(|o| o.changed) else { return Ok(()) };
    open.changed = false;
    let made = open.options.section(open.fibers.clone());
    builder.definitions.sections.remove(open.tag);
    builder.definitions.sections.add(open.tag, made);
    Ok(())
}
