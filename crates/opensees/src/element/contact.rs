//! `element zeroLengthImpact3D`.

use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use hysteron_engine::element::{ContactDirection, Element, Impact, ImpactOptions};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const IMPACT: Kind = Kind {
    names: &["zeroLengthImpact3D"],
    usage: "element zeroLengthImpact3D $tag $secondary $primary $direction $gap $friction $Kt $Kn $Kn2 $yield $cohesion",
    make: Make::TwoNodes(make),
};

fn make(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    if (ends.ndm, ends.ndf) != (3, 3) {
        return Err(ends.wrong(a, "3 degrees of freedom in 3 dimensions"));
    }
    let direction = match a.int("direction of the contact")? {
        0 => ContactDirection::Circular,
        axis @ 1..=3 => ContactDirection::Axis(axis as usize - 1),
        other => return Err(a.refuse(format!("direction of the contact is {other}"), "expected 0, 1, 2 or 3")),
    };
    let options = ImpactOptions {
        direction,
        gap: a.float("gap")?,
        friction: a.not_negative("coefficient of friction")?,
        tangential: a.not_negative("tangential stiffness Kt")?,
        normal: [a.positive("normal stiffness Kn")?, a.not_negative("normal stiffness Kn2 after yielding")?],
        yield_penetration: a.not_negative("yield penetration")?,
        cohesion: a.not_negative("cohesion")?,
    };
    Ok(Arc::new(Impact::new(options, [ends.place.0, ends.place.1])))
}
