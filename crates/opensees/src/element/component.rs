//! `element componentElement2d`.

use super::beam::no_transform;
use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::Element;
use hysteron_engine::element::beam::{ComponentBeam, ComponentOptions};
use hysteron_engine::element::transform;
use hysteron_engine::material::Elastic;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const SPRINGS: [Arg; 2] = [
    Arg::of("-stiffness", "kI", "stiffness kI (0: a hinge)").within(Domain::NotNegative),
    Arg::of("-stiffness", "kJ", "stiffness kJ (0: a hinge)").within(Domain::NotNegative),
];

const SECTION: [Arg; 3] = [
    Arg::positive("A", "cross-sectional area A"),
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("I", "second moment of area I"),
];
const RHO_M: Arg = Arg::of("-rho", "m", "mass per length").within(Domain::NotNegative);

pub(super) const COMPONENT: Kind = Kind {
    names: &["componentElement2d", "componentElement", "ComponentElement2d"],
    usage: "element componentElement2d $tag $i $j $A $E $I $transf $materialI $materialJ | -stiffness $kI $kJ <-rho $m> \
            <-cMass>",
    text: Text::new("Elastic beam between two rotational springs, in the plane.")
        .example("element componentElement2d 2 1 2 1 1 1 1 1 1")
        .arguments(&[Arg::thing("materialI", things::MATERIAL), Arg::thing("materialJ", things::MATERIAL), RHO_M])
        .groups(&[&SECTION, &SPRINGS]),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let [area, e, i] = a.numbers(&SECTION)?;
    let (spec, _) = a.of(&interp.host.builder.definitions.transforms)?;
    let place = a.last_span();
    let springs = if a.flag("-stiffness") || a.flag("-k") {
        a.numbers(&SPRINGS)?
            .map(|k| (k > 0.0).then(|| (Elastic::new(k).shared() as hysteron_engine::material::Material, 0)))
    } else {
        let materials = &interp.host.builder.definitions.materials;
        [Some(a.of(materials)?), Some(a.of(materials)?)]
    };
    let mut options = ComponentOptions { ea: e * area, ei: e * i, rho: 0.0, consistent: false };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-rho" => options.rho = a.number(&RHO_M)?,
            "-cMass" => options.consistent = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let stand = transform::Ends { place: ends.place, disp: &ends.disp };
    let transform = spec.plane(&stand).map_err(|e| no_transform(a, place, nodes, e))?;
    Ok(ComponentBeam::new(transform, options, springs).shared())
}
