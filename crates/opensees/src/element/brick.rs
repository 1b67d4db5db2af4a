//! `element stdBrick`, `bbarBrick`, `SSPbrick` and the tetrahedra.

use super::corners::placed_nodes;
use super::damping::{damped, optional};
use super::{Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::material::nd_material::{family, form};
use crate::text::{Arg, Text};
use crate::{Tcl, slips, warn};
use hysteron_engine::element::{BrickOptions, Continuum, Element};
use hysteron_engine::material::{SOLID, SharedMultiaxial};
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use nalgebra::Vector3;
use std::sync::Arc;

const CORNERS: [Arg; 8] = [
    Arg::whole("n1", "tag of a corner's node"),
    Arg::whole("n2", "tag of a corner's node"),
    Arg::whole("n3", "tag of a corner's node"),
    Arg::whole("n4", "tag of a corner's node"),
    Arg::whole("n5", "tag of a corner's node"),
    Arg::whole("n6", "tag of a corner's node"),
    Arg::whole("n7", "tag of a corner's node"),
    Arg::whole("n8", "tag of a corner's node"),
];
const TEN_NODE: [Arg; 5] = [
    Arg::whole("n10", "tag of a corner's node"),
    Arg::whole("material", "tag of a corner's node"),
    Arg::whole("b1", "tag of a corner's node"),
    Arg::whole("b2", "tag of a corner's node"),
    Arg::whole("b3", "tag of a corner's node"),
];

const BODY_FORCES: &[Arg] =
    &[Arg::new("b1", "body force along x"), Arg::new("b2", "body force along y"), Arg::new("b3", "body force along z")];

pub(super) const BRICK: Kind = Kind {
    names: &["stdBrick", "Brick", "brick"],
    usage: "element stdBrick $tag $n1 $n2 $n3 $n4 $n5 $n6 $n7 $n8 $material <$b1 $b2 $b3> <-lumped> <-damp $damping>",
    text: Text::new("Eight-node brick.")
        .example("element stdBrick 77 1 2 3 4 5 6 7 8 1")
        .arguments(&[Arg::flag("-lumped", "the mass is lumped at the corners")])
        .groups(&[&CORNERS, BODY_FORCES]),
    make: Make::AnyNodes(|interp, a| make(interp, a, false)),
};

pub(super) const MEAN_DILATATION: Kind = Kind {
    names: &["bbarBrick"],
    usage: "element bbarBrick $tag $n1 $n2 $n3 $n4 $n5 $n6 $n7 $n8 $material <$b1 $b2 $b3>",
    text: Text::new("Eight-node brick of elasticity with a constant dilatation.")
        .example("element bbarBrick 77 1 2 3 4 5 6 7 8 1")
        .groups(&[&CORNERS, BODY_FORCES]),
    make: Make::AnyNodes(|interp, a| make(interp, a, true)),
};

pub(super) const STABILISED: Kind = Kind {
    names: &["SSPbrick", "SSPBrick"],
    usage: "element SSPbrick $tag $n1 $n2 $n3 $n4 $n5 $n6 $n7 $n8 $material <$b1 $b2 $b3>",
    text: Text::new("Eight-node brick with one point of integration and stabilised hourglass modes.")
        .example("element SSPbrick 77 1 2 3 4 5 6 7 8 1")
        .groups(&[&CORNERS, BODY_FORCES]),
    make: Make::AnyNodes(stabilised),
};

pub(super) const FOUR_NODES: Kind = Kind {
    names: &["FourNodeTetrahedron"],
    usage: "element FourNodeTetrahedron $tag $n1 $n2 $n3 $n4 $material <$b1 $b2 $b3>",
    text: Text::new("Four-node tetrahedron with one point of integration.")
        .example("element FourNodeTetrahedron 77 1 2 4 5 1")
        .groups(&[&[CORNERS[0], CORNERS[1], CORNERS[2], CORNERS[3]], BODY_FORCES]),
    make: Make::AnyNodes(tetrahedron::<4, 12>),
};

pub(super) const TEN_NODES: Kind = Kind {
    names: &["TenNodeTetrahedron"],
    usage: "element TenNodeTetrahedron $tag $n1 ... $n10 $material <$b1 $b2 $b3>",
    text: Text::new(
        "Ten-node tetrahedron; nodes 5 to 10 are the middles of the edges 1-2, 2-3, 1-3, 1-4, 3-4 and 2-4.",
    )
    .example("element TenNodeTetrahedron 77 1 2 4 5 11 12 13 14 15 16 1")
    .groups(&[&[CORNERS[0]], &TEN_NODE]),
    make: Make::AnyNodes(tetrahedron::<10, 30>),
};

/// Words that all have: nodes, places of the corners, material, and body forces. The places are those of the
/// last node, for errors.
struct Read<const N: usize> {
    nodes: Vec<NodeId>,
    corners: [Vector3<f64>; N],
    law: SharedMultiaxial<SOLID>,
    body: [f64; 3],
    place: Option<Span>,
}

fn stabilised(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let r = read(interp, a)?;
    let made = Continuum::stabilised_brick(&r.corners, &r.law, r.body).map_err(|e| refused(a, r.place, e))?;
    Ok((r.nodes, made.shared()))
}

fn read<const N: usize>(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Read<N>, Exception> {
    let (nodes, corners) = placed_nodes(interp, a, &CORNERS[0], (3, 3))?;
    let place = a.last_span();
    let family = family(interp, a)?;
    let law = form(a, &family, (family.0.solid.as_ref(), "in space"))?;
    let mut body = [0.0; 3];
    for (b, name) in body.iter_mut().zip(["body force b1", "body force b2", "body force b3"]) {
        *b = a.optional_float(name)?.unwrap_or(0.0);
    }
    Ok(Read { nodes, corners, law, body, place })
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, bbar: bool) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let Read { nodes, corners, law, body, place } = read(interp, a)?;
    let mut options = BrickOptions { body, mean_dilatation: bbar, lumped: false };
    options.lumped = !bbar && a.flag("-lumped");
    let damping = if bbar { None } else { optional(interp, a)? };
    let made = Continuum::brick(&corners, &law, &options).map_err(|e| refused(a, place, e))?;
    warn_of_inversion(interp, made.is_inverted(), place)?;
    Ok((nodes, damped(made.shared(), damping).map_err(|e| refused(a, place, e))?))
}

fn tetrahedron<const N: usize, const D: usize>(
    interp: &mut Tcl,
    a: &mut Args<'_>,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception>
where
    Continuum<SOLID, D>: Shared<dyn Element>,
{
    let Read::<N> { nodes, corners, law, body, place } = read(interp, a)?;
    let weight = if N == 10 && interp.host.follows(&[slips::TETRAHEDRON_VOLUME]) { 1.0 / 6.0 } else { 1.0 };
    let made = Continuum::<SOLID, D>::tetrahedron(&corners, &law, (body, weight)).map_err(|e| refused(a, place, e))?;
    warn_of_inversion(interp, made.is_inverted(), place)?;
    Ok((nodes, made.shared()))
}

fn warn_of_inversion(interp: &mut Tcl, inverted: bool, place: Option<Span>) -> Result<(), Exception> {
    if !inverted {
        return Ok(());
    }
    let warning = Diagnostic::warning(
        &checks::elements::INVERTED_ELEMENT,
        "the corners go round the other way: stiffness and mass of the element are negative",
    );
    warn(interp, warning.at(place, "expected the corners of one face against the clock seen from the other ones"))
}
