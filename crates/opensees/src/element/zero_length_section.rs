//! `element zeroLengthSection`.

use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::model::transform::vector;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::axes;
use hysteron_engine::element::{Element, ZeroLengthSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use nalgebra::Vector3;
use std::sync::Arc;

pub(super) const ZERO_LENGTH_SECTION: Kind = Kind {
    names: &["zeroLengthSection", "ZeroLengthSection"],
    usage: "element zeroLengthSection $tag $i $j $section <-orient $x1 $x2 $x3 $yp1 $yp2 $yp3> <-doRayleigh $flag>",
    text: Text::new("A section between two nodes at one place.")
        .example("element zeroLengthSection 2 1 2 1")
        .arguments(&[Arg::thing("section", things::SECTION)]),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need_frame(a)?;
    let section = a.of(&interp.host.builder.definitions.sections)?;
    let (mut x, mut y, mut rayleigh) = (Vector3::x(), Vector3::y(), true);
    let mut orient = a.last_span();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-orient" => {
                orient = a.last_span();
                x = vector(a, 3, "local x axis")?;
                if a.at_number() {
                    y = vector(a, 3, "vector in the local x-y plane")?;
                }
            }
            "-doRayleigh" => rayleigh = a.switch(interp, "flag")?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if ends.ndm == 2 {
        y = Vector3::new(-x.y, x.x, 0.0);
    }
    let axes = axes::from_x_and_y(x, y).map_err(|e| a.refuse_at(orient, e.message(), ""))?;
    Ok(ZeroLengthSection::new(section, (ends.ndm, ends.ndf), axes, rayleigh).shared())
}
