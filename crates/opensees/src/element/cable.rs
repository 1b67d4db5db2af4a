//! `element CatenaryCable`.

use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::element::{CatenaryCable, Element};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const CATENARY: Kind = Kind {
    names: &["CatenaryCable"],
    usage: "element CatenaryCable $tag $i $j $weight $E $A $L0 $alpha $temperature $rho $tol $parts $massType",
    text: Text::new("An elastic cable under its weight or a uniform load.").arguments(&[
        Arg::new("weight", "weight per length along z, until a load on the element replaces it"),
        Arg::new("temperature", "change of temperature"),
        Arg::new("tol", "tolerance of the shape as a part of the length"),
        Arg::new("parts", "number of parts of a correction"),
        Arg::new("massType", "0: mass at the nodes, 3: mass matrix of a bar"),
    ]),
    make: Make::TwoNodes(make),
};

fn make(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    if (ends.ndm, ends.ndf) != (3, 3) {
        return Err(ends.wrong(a, "3 degrees of freedom in 3 dimensions"));
    }
    let weight = a.float("weight per length, along z")?;
    if weight == 0.0 {
        return Err(a.refuse("the weight per length is 0", "expected another number, negative downwards"));
    }
    let stiffness = a.positive("elastic modulus E")? * a.positive("cross-sectional area A")?;
    let given = a.float("length without stress L0")?;
    let length = if given > 0.0 { given } else { (ends.place.1 - ends.place.0).norm() };
    if length == 0.0 {
        return Err(a.refuse("the cable has no length", "expected a number greater than 0"));
    }
    let expansion = a.float("thermal expansion alpha")? * a.float("change of temperature")?;
    let (rho, tolerance) = (a.float("mass per length rho")?, a.positive("tolerance of the shape")?);
    let parts = a.count("number of parts of a correction")?.max(1);
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
    Ok(CatenaryCable { ends, weight, stiffness, length, expansion, rho, consistent, tolerance, parts }.shared())
}
