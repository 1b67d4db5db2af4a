//! `element multipleShearSpring`.

use super::multiple_springs::{Orient, divisions, once, option_missing};
use super::{Ends, Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::{Link, MultipleShearSpring, ShearSprings};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const LIM_DSP: Arg =
    Arg::of("-lim", "dsp", "smallest displacement dsp that the factors are for").within(Domain::NotNegative);

const N_SPRING: Arg = Arg::count("nSpring", "number nSpring of springs");

pub(super) const MULTIPLE_SHEAR_SPRING: Kind = Kind {
    names: &["multipleShearSpring", "MSS"],
    usage: "element multipleShearSpring $tag $i $j $nSpring -mat $mat | -nMat $mat1 ... <-lim $dsp> \
            <-orient <$x1 $x2 $x3> $yp1 $yp2 $yp3> <-mass $m>",
    text: Text::new("Shear springs in a circle.").example("element multipleShearSpring 2 1 2 1 -mat 1").arguments(&[
        N_SPRING,
        Arg::of("-mat", "mat", "tag of a uniaxial material").within(Domain::Whole),
        LIM_DSP,
        super::MASS_ABOVE_ZERO,
    ]),
    make: Make::TwoNodes(make),
};

const NAME: &str = "multipleShearSpring";

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    let n = divisions(a, &N_SPRING)?;
    let last = a.last_span();
    let (mut materials, mut limit, mut limit_at) = (None, None, None);
    let (mut orient, mut mass) = (Orient::default(), 0.0);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mat" | "-nMat" => {
                once(a, &materials, "-mat or -nMat")?;
                let known = &interp.host.builder.definitions.materials;
                materials = Some(if option == "-mat" {
                    vec![(a.of(known)?.0, n)]
                } else {
                    (0..n).map(|_| Ok((a.of(known)?.0, 1))).collect::<Result<_, Exception>>()?
                });
            }
            "-lim" => {
                limit = Some(a.number(&LIM_DSP)?).filter(|l| *l > 0.0);
                limit_at = a.last_span();
            }
            "-orient" => orient.take(a)?,
            "-mass" => mass = a.number(&super::MASS_ABOVE_ZERO)?,
            _ => return Err(a.unknown_name("option", a.options())),
        }
    }
    let materials = materials.ok_or_else(|| option_missing(a, last, NAME, "-mat", "the tag of a material"))?;
    let (axes, length) = orient.axes(a, ends, nodes)?;
    let springs = ShearSprings::of(materials, limit, MultipleShearSpring::HEADER);
    let link = Link::new(&axes, length, 0.5);
    let element = match interp.host.follows(&[slips::SHEAR_SPRINGS_LIMIT]) {
        true => MultipleShearSpring::as_opensees(springs, link, mass).map(|e| e.shared()),
        false => MultipleShearSpring::new(springs, link, mass).map(|e| e.shared()),
    };
    element.map_err(|e| refused(a, limit_at, e))
}
