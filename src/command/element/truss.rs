//! `element truss`.

use super::{Ends, Kind, refused};
use crate::command::args::Args;
use crate::command::{Tcl, ignore_option};
use crate::element::{Element, Truss, TrussOptions};
use crate::script::Exception;
use std::sync::Arc;

pub(super) const TRUSS: Kind = Kind {
    names: &["truss", "Truss"],
    usage: "element truss $tag $i $j $A $matTag <-rho $rho> <-cMass $flag> <-doRayleigh $flag> <-useInitialDisp $flag>",
    make,
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let span = a.last_span();
    let area = a.positive("cross-sectional area A")?;
    let (material, tag) = a.of(&interp.host.definitions.materials)?;
    let mut options = TrussOptions { area, rho: 0.0, consistent: false, rayleigh: false };
    let mut initial = ends.initial();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-rho" => options.rho = a.not_negative("mass per length rho")?,
            "-cMass" => options.consistent = a.int("flag")? != 0,
            "-doRayleigh" => options.rayleigh = a.int("flag")? != 0,
            "-useInitialDisp" => {
                if a.int("flag")? == 0 {
                    initial.fill(0.0);
                }
            }
            _ => ignore_option(interp, a, &["-rho", "-cMass", "-doRayleigh", "-useInitialDisp"])?,
        }
    }
    if !matches!((ends.ndm, ends.ndf), (1, 1) | (2, 2 | 3) | (3, 3 | 6)) {
        return Err(ends.wrong(a, "1 degree of freedom in 1, 2 or 3 in 2, 3 or 6 in 3 dimensions"));
    }
    let line = ends.place.1 - ends.place.0;
    let line: Vec<f64> = (0..ends.ndm).map(|i| line[i] + initial[i]).collect();
    let truss = Truss::new(material, tag, &line, ends.ndf, &initial, &options);
    Ok(Arc::new(truss.map_err(|e| refused(a, span, e))?))
}
