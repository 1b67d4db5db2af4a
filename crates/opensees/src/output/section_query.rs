//! Queries of the sections of beams, and of the beam between its ends.

use super::query::{DOF_OR_ALL, ELE_RESPONSE_ELEMENT, element_of, evaluate, list, pick};
use crate::args::Args;
use crate::checks;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_tcl::Call;

const SECTION: Arg = Arg::count("section", "number of the section");
const PLACE: Arg = Arg::number("x", "place along the beam from 0 to 1, a fraction of its length");

pub(crate) const COMMANDS: &[Command] = &[
    Command::asking("sectionForce", OF_SECTION, |i, c| of_section(i, c, "force"))
        .arguments(&[ELE_RESPONSE_ELEMENT, SECTION])
        .about("Returns the resultants of a section of a beam.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("sectionDeformation", OF_SECTION, |i, c| of_section(i, c, "deformation"))
        .about("Returns the deformations of a section of a beam."),
    Command::asking("sectionStiffness", OF_SECTION, |i, c| of_section(i, c, "stiffness"))
        .about("Returns the tangent of a section of a beam."),
    Command::asking("sectionFlexibility", OF_SECTION, |i, c| of_section(i, c, "flexibility"))
        .about("Returns the inverse of the tangent of a section of a beam."),
    Command::asking("sectionLocation", ALONG, |i, c| along(i, c, "integrationPoints"))
        .about("Returns the places of the sections along a beam.")
        .arguments(&[
            ELE_RESPONSE_ELEMENT,
            Arg::new("section", "number of the section from 1; all where it is left out"),
        ]),
    Command::asking("sectionWeight", ALONG, |i, c| along(i, c, "integrationWeights"))
        .about("Returns the weights of the sections along a beam."),
    Command::asking("sectionTag", ALONG, |i, c| along(i, c, "sectionTags"))
        .about("Returns the tags of the sections along a beam."),
    Command::asking("sectionDisplacement", DISPLACEMENT, section_displacement)
        .arguments(&[
            ELE_RESPONSE_ELEMENT,
            SECTION,
            Arg::flag("-local", "in local axes; in global ones where it is left out"),
        ])
        .about(
            "Returns the displacements along x, y and z of a section of a force-based beam. Its deflection is the double \
             integral of the polynomial through the curvatures of the sections.",
        ),
    Command::asking("cbdiDisplacement", AT_PLACE, displacement_at)
        .arguments(&[ELE_RESPONSE_ELEMENT, PLACE])
        .about("Returns the global displacements along x, y and z of a place of a force-based beam."),
];

const OF_SECTION: &str = "sectionForce $element $section <$dof>";
const ALONG: &str = "sectionLocation $element <$section>";

/// A response of a section of a beam, or one of its values.
fn of_section(interp: &mut Tcl, call: &Call<'_>, what: &str) -> Outcome {
    let mut a = Args::new(call, OF_SECTION);
    let id = element_of(interp, &mut a)?;
    let number = a.count(&SECTION)?.to_string();
    let words = ["section", number.as_str(), what];
    let Some(values) = evaluate(interp, id, &words) else {
        let refused = a.refuse(format!("the element has no section {number}"), "expected a number from 1 on");
        return Err(refused.by(&checks::output::NO_RESPONSE));
    };
    pick(interp, &mut a, &values, "number of the value")
}

/// Response of a beam's sections, or of one of them.
fn along(interp: &mut Tcl, call: &Call<'_>, what: &str) -> Outcome {
    let mut a = Args::new(call, ALONG);
    let id = element_of(interp, &mut a)?;
    let Some(values) = evaluate(interp, id, &[what]) else {
        let refused = a.refuse("the element has no sections along its length", "expected a beam with sections");
        return Err(refused.by(&checks::output::NO_RESPONSE));
    };
    pick(interp, &mut a, &values, "number of the section")
}

const DISPLACEMENT: &str = "sectionDisplacement $element $section <-local>";
const AT_PLACE: &str = "cbdiDisplacement $element $x";

/// Displacements of one section of a beam.
fn section_displacement(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, DISPLACEMENT);
    let id = element_of(interp, &mut a)?;
    let section = a.count(&SECTION)?;
    let frame = if a.flag("-local") { "local" } else { "global" };
    let Some(values) = evaluate(interp, id, &["sectionDisplacements", frame]) else {
        return Err(a.refuse(UNKNOWN, EXPECTED).by(&checks::output::NO_RESPONSE));
    };
    let Some(values) = values.chunks_exact(3).nth(section - 1) else {
        let refused = a.refuse(format!("the element has no section {section}"), "expected a number from 1 on");
        return Err(refused.by(&checks::output::NO_RESPONSE));
    };
    finish(interp, &a)?;
    Ok(list(values))
}

/// Displacements of a place of a beam.
fn displacement_at(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, AT_PLACE);
    let id = element_of(interp, &mut a)?;
    let x = a.number(&PLACE)?;
    if !(0.0..=1.0).contains(&x) {
        return Err(a.refuse("the place is not on the beam", "expected a fraction of the length, 0 to 1"));
    }
    let Some(values) = evaluate(interp, id, &["cbdiDisplacements", &x.to_string()]) else {
        return Err(a.refuse(UNKNOWN, EXPECTED).by(&checks::output::NO_RESPONSE));
    };
    finish(interp, &a)?;
    Ok(list(&values))
}

const UNKNOWN: &str = "the displacements of the element between its ends are not known";
const EXPECTED: &str = "expected a force-based beam with sections at distinct places and small displacements";
