//! `element ElasticTimoshenkoBeam`.

use super::beam::{A, AVY, AVZ, E, G, IY, IZ, J, MASS_PER_LENGTH, elastic_part, no_transform};
use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::Element;
use hysteron_engine::element::beam::{TimoshenkoBeam, TimoshenkoOptions};
use hysteron_engine::element::transform;
use hysteron_engine::section::ElasticSection;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use nalgebra::Vector3;
use std::sync::Arc;

pub(super) const TIMOSHENKO: Kind = Kind {
    names: &["ElasticTimoshenkoBeam", "elasticTimoshenkoBeam"],
    usage: "element ElasticTimoshenkoBeam $tag $i $j $E $G $A $Iz $Avy $transf (in the plane) or \
            $E $G $A $J $Iy $Iz $Avy $Avz $transf (in space) or $section $transf <-mass $m> <-cMass|-lMass> <-geomNonlinear>",
    text: Text::new("Elastic beam with shear deformation.")
        .example("element ElasticTimoshenkoBeam 2 1 2 1 1 1 1 1 1")
        .arguments(&[
            E,
            G,
            A,
            J,
            IY,
            IZ,
            AVY,
            AVZ,
            MASS_PER_LENGTH,
            Arg::thing("section", things::SECTION),
            Arg::thing("transf", things::TRANSFORM),
        ]),
    make: Make::TwoNodes(make),
};

/// The section of the beam: by its tag, or number after number.
fn section(interp: &mut Tcl, a: &mut Args<'_>, ndm: usize) -> Result<ElasticSection, Exception> {
    if a.numbers_ahead() == 2 {
        let (section, tag) = a.of(&interp.host.builder.definitions.sections)?;
        let mut s = elastic_part(&section);
        if s.g == 0.0 {
            return Err(a.refuse(
                format!("section {tag} has no shear modulus, which the beam needs"),
                "expected a section with a G",
            ));
        }
        // As in OpenSees, the whole area takes the shear of a section that says nothing about it.
        s.shear = (s.shear.0.or(Some(s.area)), s.shear.1.or(Some(s.area)));
        return Ok(s);
    }
    let (e, g) = (a.read(interp, &E)?, a.read(interp, &G)?);
    let area = a.read(interp, &A)?;
    let (mut j, mut iy) = (0.0, 0.0);
    if ndm == 3 {
        j = a.read(interp, &J)?;
        iy = a.read(interp, &IY)?;
    }
    let iz = a.read(interp, &IZ)?;
    let avy = a.read(interp, &AVY)?;
    let avz = if ndm == 3 { Some(a.read(interp, &AVZ)?) } else { None };
    Ok(ElasticSection { e, area, iz, iy, g, j, shear: (Some(avy), avz) })
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need_frame(a)?;
    let s = section(interp, a, ends.ndm)?;
    let (spec, tag) = a.of(&interp.host.builder.definitions.transforms)?;
    let place = a.last_span();
    if spec.offsets != (Vector3::zeros(), Vector3::zeros()) {
        return Err(a.refuse(
            format!("the beam has no joint offsets, but transformation {tag} does"),
            "expected a transformation without -jntOffset",
        ));
    }
    let mut o = TimoshenkoOptions::default();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mass" => o.rho = a.number(&MASS_PER_LENGTH)?,
            "-cMass" => o.consistent = true,
            "-lMass" => o.consistent = false,
            "-geomNonlinear" => o.geometric = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    // The transformation gives the axes alone, and displacements count from the nodes' coordinates.
    let still = vec![0.0; ends.disp.len()];
    let stand = transform::Ends { place: ends.place, disp: &still };
    let wrong = |e| no_transform(a, place, nodes, e);
    Ok(if ends.ndm == 2 {
        TimoshenkoBeam::new(spec.plane(&stand).map_err(wrong)?.frame().clone(), s, o).shared()
    } else {
        TimoshenkoBeam::new(spec.space(&stand).map_err(wrong)?.frame().clone(), s, o).shared()
    })
}
