//! `element CatenaryCable`.

use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::element::{CatenaryCable, Element};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const WEIGHT: Arg = Arg::number("weight", "weight per length, along z");
const PARTS: Arg = Arg::count("parts", "number of parts of a correction");

const STIFFNESS: [Arg; 3] = [
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("A", "cross-sectional area A"),
    Arg::number("L0", "length without stress L0"),
];
const NUMBERS: [Arg; 4] = [
    Arg::number("alpha", "thermal expansion alpha"),
    Arg::number("temperature", "change of temperature"),
    Arg::number("rho", "mass per length rho"),
    Arg::positive("tol", "tolerance of the shape"),
];

pub(super) const CATENARY: Kind = Kind {
    names: &["CatenaryCable"],
    usage: "element CatenaryCable $tag $i $j $weight $E $A $L0 $alpha $temperature $rho $tol $parts $massType",
    text: Text::new("An elastic cable under its weight or a uniform load.")
        .example("element CatenaryCable 2 1 2 1 1 1 1 1 1 1 1 1 1")
        .arguments(&[WEIGHT, PARTS, Arg::whole("massType", "0: mass at the nodes, 3: mass matrix of a bar")])
        .groups(&[&STIFFNESS, &NUMBERS]),
    make: Make::TwoNodes(make),
};

fn make(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 3))?;
    let weight = a.number(&WEIGHT)?;
    if weight == 0.0 {
        return Err(a.refuse("the weight per length is 0", "expected another number, negative downwards"));
    }
    let [e, area, given] = a.numbers(&STIFFNESS)?;
    let length = if given > 0.0 { given } else { (ends.place.1 - ends.place.0).norm() };
    if length == 0.0 {
        return Err(a.refuse("the cable has no length", "expected a number greater than 0"));
    }
    let [alpha, temperature, rho, tolerance] = a.numbers(&NUMBERS)?;
    let parts = a.count(&PARTS)?.max(1);
    // Lumped where OpenSees has no integration of its own.
    let consistent = match a.int("type of the mass")? {
        0 | 1 => false,
        3 => true,
        n => {
            let label = "expected 0 (at the nodes) or 3 (as of a bar)";
            return Err(a.refuse(format!("there is no type {n} of the mass here"), label));
        }
    };
    let ends = [ends.place.0, ends.place.1];
    let (stiffness, expansion) = (e * area, alpha * temperature);
    Ok(CatenaryCable { ends, weight, stiffness, length, expansion, rho, consistent, tolerance, parts }.shared())
}
