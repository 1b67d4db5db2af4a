//! A fiber section without a body: its fibers follow in commands of their own, as a host calls them.

use super::fiber::ContinuumFiber;
use super::nd_fiber::NdFiberOptions;
use super::{FiberOptions, fiber_options};
use crate::args::Args;
use crate::things;
use crate::{Outcome, Tcl};
use hysteron_engine::model::Tag;
use hysteron_engine::section::Fiber;
use hysteron_tcl::{Exception, Value};

/// Fibers so far, with the options of their section.
enum Fibers {
    Uniaxial(FiberOptions, Vec<Fiber>),
    Continuum(NdFiberOptions, Vec<ContinuumFiber>),
}

/// A fiber section that takes fibers until the next `section`.
pub(crate) struct OpenSection {
    tag: Tag,
    fibers: Fibers,
    changed: bool,
}

impl OpenSection {
    /// Returns true if its fibers are of materials of continua.
    pub(super) fn takes_continua(&self) -> bool {
        matches!(self.fibers, Fibers::Continuum(..))
    }

    /// Add a fiber.
    pub(crate) fn push(&mut self, fiber: Fiber) {
        if let Fibers::Uniaxial(_, fibers) = &mut self.fibers {
            fibers.push(fiber);
            self.changed = true;
        }
    }

    /// Add a fiber of a material of continua.
    pub(super) fn push_continuum(&mut self, fiber: ContinuumFiber) {
        if let Fibers::Continuum(_, fibers) = &mut self.fibers {
            fibers.push(fiber);
            self.changed = true;
        }
    }
}

/// Take the options of `section Fiber` or `NDFiber`; fibers are to follow.
pub(super) fn open(interp: &mut Tcl, a: &mut Args<'_>, tag: Tag, continua: bool) -> Outcome {
    let span = a.last_span();
    let definitions = &interp.host.builder.definitions;
    if definitions.sections.get(tag).is_some() || definitions.plates.get(tag).is_some() {
        return Err(a.exists_at(span, things::SECTION, tag));
    }
    let fibers = if continua {
        Fibers::Continuum(NdFiberOptions::take(interp, a, 0)?, vec![])
    } else {
        Fibers::Uniaxial(fiber_options(interp, a, 0)?, vec![])
    };
    interp.host.builder.open_section = Some(OpenSection { tag, fibers, changed: false });
    Ok(Value::EMPTY)
}

/// Define the open section with the fibers that it has by now. Elements that have it already keep what they have.
pub(crate) fn settle(interp: &mut Tcl) -> Result<(), Exception> {
    let builder = &mut interp.host.builder;
    let Some(open) = builder.open_section.as_mut().filter(|o| o.changed) else { return Ok(()) };
    open.changed = false;
    let made = match &open.fibers {
        Fibers::Uniaxial(options, fibers) => options.section(fibers.clone()),
        Fibers::Continuum(options, fibers) => options.section(fibers),
    };
    builder.definitions.sections.remove(open.tag);
    builder.definitions.sections.add(open.tag, made);
    Ok(())
}
