//! `element YamamotoBiaxialHDR`.

use super::multiple_springs::Orient;
use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::{Link, ShearBearing, ShearLaw, YamamotoShear};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const CO_RS_CR: Arg = Arg::of("-coRS", "cr", "factor cr of tau_r").within(Domain::Positive);
const CO_RS_CS: Arg = Arg::of("-coRS", "cs", "factor cs of tau_s").within(Domain::Positive);

const TP: Arg = Arg::whole("tp", "compound tp");
const D_DO: Arg = Arg::positive("dDo", "outer diameter dDo");
const D_DI: Arg = Arg::not_negative("dDi", "inner diameter dDi");
const HR: Arg = Arg::positive("hr", "total thickness hr of the rubber");

pub(super) const YAMAMOTO: Kind = Kind {
    names: &["YamamotoBiaxialHDR"],
    usage: "element YamamotoBiaxialHDR $tag $i $j $tp $dDo $dDi $hr <-coRS $cr $cs> <-orient <$x1 $x2 $x3> $y1 $y2 $y3> \
            <-mass $m>",
    text: Text::new("High damping rubber bearing with bidirectional shear (Yamamoto).")
        .example("element YamamotoBiaxialHDR 2 1 2 1 1 0.5 1")
        .arguments(&[TP, D_DO, D_DI, HR, CO_RS_CR, CO_RS_CS, super::MASS_ABOVE_ZERO]),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    match a.int(TP.meaning)? {
        1 => {}
        tp => return Err(a.refuse(format!("there is no compound {tp}"), "expected 1, Bridgestone's X0.6R")),
    }
    let outer = a.number(&D_DO)?;
    let inner = a.number(&D_DI)?;
    if inner >= outer {
        return Err(a.refuse(format!("the inner diameter is {inner}"), format!("expected it less than dDo, {outer}")));
    }
    let height = a.number(&HR)?;
    let (mut factors, mut mass) = ([1.0; 2], 0.0);
    let mut orient = Orient::default();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-coRS" => factors = [a.number(&CO_RS_CR)?, a.number(&CO_RS_CS)?],
            "-orient" => orient.take(a)?,
            "-mass" => mass = a.number(&super::MASS_ABOVE_ZERO)?,
            _ => return Err(a.unknown_name("option", a.options())),
        }
    }
    let (axes, length) = orient.axes(a, ends, nodes)?;
    let link = Link::new(&axes, length, 0.5);
    Ok(match interp.host.follows(&[slips::YAMAMOTO_EULER]) {
        true => around(YamamotoShear::as_opensees([outer, inner], height, factors), link, mass),
        false => around(YamamotoShear::new([outer, inner], height, factors), link, mass),
    })
}

/// The bearing of a shear law. Nothing resists axial force, torsion and bending.
fn around<L: ShearLaw<2>>(law: L, link: Link<12, 6>, mass: f64) -> Arc<dyn Element>
where
    ShearBearing<L, 12, 6, 0, 2>: Shared<dyn Element>,
{
    ShearBearing::<_, 12, 6, 0, 2>::new(law, link, [], mass, true).shared()
}
