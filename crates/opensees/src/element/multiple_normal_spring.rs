//! `element multipleNormalSpring`.

use super::multiple_springs::{LAMBDA, Orient, distribution, divisions, once, option_missing, shape};
use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::{Distribution, Layout, Link, Mean, MultipleNormalSpring, NormalSprings};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const SIZE: Arg = Arg::of("-size", "size", "diameter or edge of the section").within(Domain::Positive);

const N_DIVIDE: Arg = Arg::count("nDivide", "number nDivide of springs across the section");

pub(super) const MULTIPLE_NORMAL_SPRING: Kind = Kind {
    names: &["multipleNormalSpring"],
    usage: "element multipleNormalSpring $tag $i $j $nDivide -mat $mat -shape round|square -size $size \
            <-lambda $lambda> <-orient <$x1 $x2 $x3> $yp1 $yp2 $yp3> <-mass $m>",
    text: Text::new("A section of normal springs.")
        .example("element multipleNormalSpring 2 1 2 1 -mat 1 -shape round -size 1")
        .arguments(&[
            N_DIVIDE,
            Arg::of("-mat", "mat", "tag of a uniaxial material").within(Domain::Whole),
            SIZE,
            LAMBDA,
            super::MASS_ABOVE_ZERO,
        ]),
    make: Make::TwoNodes(make),
};

const NAME: &str = "multipleNormalSpring";

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    let n = divisions(a, &N_DIVIDE)?;
    let last = a.last_span();
    let (mut material, mut outline, mut size) = (None, None, None);
    let (mut lambda, mut orient, mut mass) = (Distribution::Uniform, Orient::default(), 0.0);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mat" => {
                once(a, &material, "-mat")?;
                material = Some(a.of(&interp.host.builder.definitions.materials)?.0);
            }
            "-shape" => {
                once(a, &outline, "-shape")?;
                outline = Some(shape(a)?);
            }
            "-size" => {
                once(a, &size, "-size")?;
                size = Some(a.number(&SIZE)?);
            }
            "-lambda" => lambda = distribution(a)?,
            "-orient" => orient.take(a)?,
            "-mass" => mass = a.number(&super::MASS_ABOVE_ZERO)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let missing = |option, what| option_missing(a, last, NAME, option, what);
    let material = material.ok_or_else(|| missing("-mat", "the tag of a material"))?;
    let outline = outline.ok_or_else(|| missing("-shape", "round or square"))?;
    let size = size.ok_or_else(|| missing("-size", "the diameter or edge of the section"))?;
    let (axes, length) = orient.axes(a, ends, nodes)?;
    if length == 0.0 {
        let message = format!("{NAME}: its nodes are at one place");
        return Err(a.refuse_at(nodes, message, "expected nodes at a distance: it is the length of the springs"));
    }
    let compat = interp.host.follows(&[slips::NORMAL_SPRINGS_COMMIT, slips::NORMAL_SPRINGS_AXIAL_SP]);
    let mut layout = Layout::new(outline, size, n, lambda, Mean::Section);
    if compat {
        // OpenSees counts y the other way round, which shows as it commits only some of the springs.
        layout.y.iter_mut().for_each(|y| *y = -*y);
    }
    let springs = NormalSprings::new(material, &layout, length, MultipleNormalSpring::HEADER);
    let link = Link::new(&axes, length, 0.5);
    Ok(MultipleNormalSpring::new(springs, link, mass, compat).shared())
}
