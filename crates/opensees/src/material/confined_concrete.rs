//! Confined concrete.

use super::Kind;
use crate::Tcl;
use crate::args::Args;
use hysteron_engine::material::{FrpConfinedConcrete02, Jacket, Material};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["FRPConfinedConcrete02"],
    usage: "uniaxialMaterial FRPConfinedConcrete02 $tag $fc0 $Ec $ec0 <-JacketC $tfrp $Efrp $erup $R | -Ultimate $fcu $ecu> \
            $ft $Ets $Unit",
    make: frp_confined_concrete02,
}];

/// Megapascal per ksi, in the digits of OpenSees.
const KSI: f64 = 6.895;

/// A number in compression, negative in the script, as a positive one.
fn compressive(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match -a.float(what)? {
        value if value > 0.0 => Ok(value),
        value => Err(a.refuse(format!("the {what} is {}", -value), "expected a negative number: compression")),
    }
}

fn frp_confined_concrete02(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fc0 = compressive(a, "strength fc0")?;
    let ec = a.positive("initial modulus Ec")?;
    let epsc0 = compressive(a, "strain at the strength ec0")?;
    let (fcc, epscu) = if a.flag("-JacketC") {
        let jacket = Jacket {
            thickness: a.positive("thickness of the jacket tfrp")?,
            modulus: a.positive("modulus of the jacket Efrp")?,
            rupture: a.positive("hoop strain at rupture erup")?,
            radius: a.positive("radius of the concrete R")?,
        };
        jacket.confined(fc0, epsc0)
    } else if a.flag("-Ultimate") {
        (compressive(a, "ultimate stress fcu")?, compressive(a, "ultimate strain ecu")?)
    } else {
        // Concrete without confinement (Teng and others, 2009).
        (0.85 * fc0, 1.75 * epsc0)
    };
    if ec <= (fcc - fc0) / epscu {
        return Err(a.refuse("the initial modulus Ec is less than that of the second part", "expected more"));
    }
    let (ft, ets) = (a.positive("tensile strength ft")?, a.positive("softening modulus in tension Ets")?);
    let mpa = if a.int("units, 1: MPa, 0: ksi")? == 0 { KSI } else { 1.0 };
    Ok(Arc::new(FrpConfinedConcrete02 { fc0, ec, fcc, epscu, ft, ets, mpa }))
}
