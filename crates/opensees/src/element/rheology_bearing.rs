//! `element HDRRheologyBearing`.

use super::rubber_bearing::{AC, COVER, Common, KC, MASS, PHI_M, SHEAR_DIST, layers};
use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::material::{CONDUCTION, RHEOLOGY_ARGUMENTS, rheology};
use crate::slips;
use crate::text::{Arg, Text};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::{RheologyShear, RubberBearing};
use hysteron_engine::material::HdrRheology;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const RHEOLOGY: Kind = Kind {
    names: &["HDRRheologyBearing"],
    usage: "element HDRRheologyBearing $tag $i $j $Gr $Kbulk $D1 $D2 $ts $tr $n -compound $name -temperature $T | $C1eq \
            $C2eq $C3eq $tauCrEq $m $C1oe $C2oe $tauCrOe $a $n <-linear $C> <-heatCapacity $c <-coolingTime $s>> \
            <-conduction $layers $tRubber $tSteel $tPlate $kRubber $cRubber $kSteel $cSteel $film> <-ambient $T> <-beyond hold|error> <-mullins $excess $strain <-heal $fraction $time> <-preload $strain>> <-axial kumar|linear> <-pDelta on|off> \
            <-orient $x1 $x2 $x3 $y1 $y2 $y3> <-kc $kc> <-PhiM $PhiM> <-ac $ac> <-shearDist $sDratio> <-mass $m> \
            <-cover $tc>",
    text: Text::new(
        "High damping rubber bearing with rate, temperature and self-heating; see [High damping \
         rubber](../../explanation/rubber.md).",
    )
    .example(
        "element HDRRheologyBearing 77 1 2 800. 2e6 0. 0.6 0.003 0.008 20 700. 100. 20. 200. 3. 900. 100. \
         400. 300. 0.2",
    )
    .arguments(&[
        Arg::positive("Gr", "shear modulus Gr"),
        Arg::positive("Kbulk", "bulk modulus Kbulk"),
        Arg::not_negative("D1", "inner diameter D1"),
        Arg::positive("D2", "outer diameter D2"),
        Arg::not_negative("ts", "thickness of a shim ts"),
        Arg::positive("tr", "thickness of a rubber layer tr"),
        Arg::number("n", "number of layers; the second `$n` is the parameter n of the overstress"),
        KC.after("-kc"),
        PHI_M.after("-PhiM"),
        AC.after("-ac"),
        SHEAR_DIST.after("-shearDist"),
        MASS.after("-mass"),
        COVER.after("-cover"),
    ])
    .groups(&[RHEOLOGY_ARGUMENTS, &CONDUCTION])
    .own(),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let mut c = Common::new(a.last_span());
    let mut layers = layers(interp, a, false)?;
    let (mut varies, mut p_delta) = (true, true);
    let law = rheology(interp, a, |interp, a, option| {
        match option {
            "-axial" => {
                varies = match a.word("axial law: kumar or linear")?.as_ref() {
                    "kumar" => true,
                    "linear" => false,
                    _ => return Err(a.unknown_name("axial law", ["kumar", "linear"])),
                }
            }
            "-pDelta" => {
                p_delta = match a.word("P-Delta moments: on or off")?.as_ref() {
                    "on" => true,
                    "off" => false,
                    _ => return Err(a.unknown_name("choice of P-Delta moments", ["on", "off"])),
                }
            }
            "-orient" => c.axes(interp, a)?,
            "-kc" => c.kc = a.read(interp, &KC)?,
            "-PhiM" => c.phi = a.read(interp, &PHI_M)?,
            "-ac" => c.ac = a.read(interp, &AC)?,
            "-shearDist" => c.shear_dist = a.read(interp, &SHEAR_DIST)?,
            "-mass" => c.mass = a.read(interp, &MASS)?,
            "-cover" => c.cover = a.read(interp, &COVER)?,
            _ => return Ok(false),
        }
        Ok(true)
    })?;
    if !law.hold_ends {
        return Err(a.refuse("a bearing cannot end at the table of its compound", "expected -beyond hold, or none"));
    }
    layers.cover = c.cover;
    let rubber = layers.bearing();
    let law = HdrRheology { area: rubber.area, height: rubber.thickness, ..law };
    let axial = c.axial(rubber, [varies; 3], interp.host.follows(&[slips::RUBBER_LAG]));
    let shear = RheologyShear { law };
    let link = c.link(a, ends)?;
    let link = if p_delta { link } else { link.first_order() };
    Ok(RubberBearing::new(axial, shear, link, c.mass).shared())
}
