//! `element ElasticTubularJoint`.

use super::{Ends, Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::element::{Element, TubularJoint, TubularJointOptions};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const BRACE_ANGLE: Arg = Arg::number("braceAngle", "angle of the brace in degrees");
const CHORD_ANGLE: Arg = Arg::number("chordAngle", "angle of the chord in degrees");

const BRACE_DIAMETER: Arg = Arg::positive("braceDiameter", "diameter of the brace");
const ELASTIC_TUBULAR_JOINT_E: Arg = Arg::positive("E", "modulus of elasticity E");
const CHORD_DIAMETER: Arg = Arg::positive("chordDiameter", "diameter of the chord");
const CHORD_THICKNESS: Arg = Arg::positive("chordThickness", "thickness of the chord");

pub(super) const TUBULAR_JOINT: Kind = Kind {
    names: &["ElasticTubularJoint", "elasticTubularJoint"],
    usage: "element ElasticTubularJoint $tag $i $j $braceDiameter $braceAngle $E $chordDiameter $chordThickness $chordAngle",
    text: Text::new("Elastic flexibility of the wall of a tubular chord where a brace meets it.")
        .example("element ElasticTubularJoint 77 1 2 0.3 60. 2e8 0.6 0.02 0.")
        .arguments(&[
            BRACE_DIAMETER,
            BRACE_ANGLE,
            ELASTIC_TUBULAR_JOINT_E,
            CHORD_DIAMETER,
            CHORD_THICKNESS,
            CHORD_ANGLE,
        ]),
    make: Make::TwoNodes(make),
};

fn make(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let brace_diameter = a.number(&BRACE_DIAMETER)?;
    let brace_angle = a.number(&BRACE_ANGLE)?;
    if !(brace_angle > 0.0 && brace_angle < 180.0) {
        let label = "expected the angle between brace and chord, more than 0 and less than 180 degrees";
        return Err(a.refuse(format!("angle of the brace is {brace_angle}"), label));
    }
    let e = a.number(&ELASTIC_TUBULAR_JOINT_E)?;
    let chord_diameter = a.number(&CHORD_DIAMETER)?;
    if brace_diameter >= chord_diameter {
        let message = format!("the brace with the diameter {brace_diameter} is as wide as the chord");
        return Err(a.refuse(message, "expected a diameter of the chord greater than that of the brace"));
    }
    let options = TubularJointOptions {
        brace_diameter,
        brace_angle,
        e,
        chord_diameter,
        chord_thickness: a.number(&CHORD_THICKNESS)?,
        chord_angle: a.number(&CHORD_ANGLE)?,
    };
    let line = ends.place.1 - ends.place.0;
    Ok(TubularJoint::new(&options, [line.x, line.y]).map_err(|e| refused(a, nodes, e))?.shared())
}
