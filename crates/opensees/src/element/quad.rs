//! `element quad`, `bbarQuad`, `SSPquad`, `tri31`, `quad9n`, `quad8n`, `tri6n` and `enhancedQuad`.

use super::corners::{CORNERS, TRIANGLE_CORNERS, placed_nodes};
use super::damping::{damped, optional};
use super::{Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::material::nd_material::{Family, family, form};
use crate::text::{Arg, Domain, Text};
use hysteron_engine::element::{Continuum, Element, QuadOptions, QuadraticShape};
use hysteron_engine::material::{Condensed, PLANE, Plane, SharedMultiaxial};
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const PRESSURE: Arg = Arg::number("pressure", "pressure on the edges");
const RHO: Arg = Arg::not_negative("rho", "mass per volume rho");

const QUAD_THICKNESS: Arg = Arg::positive("thickness", "thickness");
const N9: Arg = Arg::whole("n9", "tag of a corner's node");
const N8: Arg = Arg::whole("n8", "tag of a corner's node");
const N6: Arg = Arg::whole("n6", "tag of a corner's node");

const BODY: &[Arg] = &[PRESSURE, RHO, Arg::new("bx", "body force along x"), Arg::new("by", "body force along y")];

pub(super) const QUAD: Kind = Kind {
    names: &["quad", "stdQuad", "FourNodeQuad"],
    usage: "element quad $tag $i $j $k $l $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by> \
            <-damp $damping>",
    text: Text::new("Four-node quadrilateral.").example("element quad 77 1 2 3 4 1. PlaneStress 1").groups(&[
        &CORNERS,
        &[QUAD_THICKNESS],
        BODY,
    ]),
    make: Make::AnyNodes(make),
};

pub(super) const MEAN_DILATATION: Kind = Kind {
    names: &["bbarQuad", "mixedQuad"],
    usage: "element bbarQuad $tag $i $j $k $l $thickness $material",
    text: Text::new("Four-node quadrilateral in plane strain with a constant dilatation.")
        .example("element bbarQuad 77 1 2 3 4 1. 1")
        .groups(&[&CORNERS, &[QUAD_THICKNESS]]),
    make: Make::AnyNodes(make_mean_dilatation),
};

pub(super) const STABILISED: Kind = Kind {
    names: &["SSPquad", "SSPQuad"],
    usage: "element SSPquad $tag $i $j $k $l $material PlaneStrain|PlaneStress $thickness <$bx $by>",
    text: Text::new("Stabilised quadrilateral of plane elasticity with one Gauss point.")
        .example("element SSPquad 77 1 2 3 4 1 PlaneStress 1.")
        .groups(&[&CORNERS])
        .arguments(&[QUAD_THICKNESS, Arg::new("bx", "body force bx"), Arg::new("by", "body force by")]),
    make: Make::AnyNodes(make_stabilised),
};

pub(super) const TRIANGLE: Kind = Kind {
    names: &["tri31", "Tri31"],
    usage: "element tri31 $tag $i $j $k $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    text: Text::new("Three-node triangle of plane elasticity.")
        .example("element tri31 77 1 2 3 1. PlaneStress 1")
        .groups(&[&TRIANGLE_CORNERS, &[QUAD_THICKNESS], BODY]),
    make: Make::AnyNodes(make_triangle),
};

pub(super) const NINE_NODES: Kind = Kind {
    names: &["quad9n", "nineNodeQuad", "NineNodeQuad"],
    usage: "element quad9n $tag $n1 ... $n9 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    text: Text::new("Nine-node quadrilateral of plane elasticity.")
        .example("element quad9n 77 1 2 3 4 5 6 7 8 9 1. PlaneStress 1")
        .arguments(&[
            Arg::new("n1", "corners against the clock, then the middles of the sides in order, then the centre")
                .within(Domain::Whole),
            N9,
            QUAD_THICKNESS,
            Arg::new("material", "tag of the material of continua"),
        ])
        .groups(&[BODY]),
    make: Make::AnyNodes(|interp, a| make_quadratic::<9, 18>(interp, a, QuadraticShape::Lagrange)),
};

pub(super) const EIGHT_NODES: Kind = Kind {
    names: &["quad8n", "eightNodeQuad", "EightNodeQuad"],
    usage: "element quad8n $tag $n1 ... $n8 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    text: Text::new("Eight-node quadrilateral.")
        .example("element quad8n 77 1 2 3 4 5 6 7 8 1. PlaneStress 1")
        .arguments(&[
            Arg::whole("n1", "corners against the clock, then the middles of the sides in order"),
            N8,
            QUAD_THICKNESS,
            Arg::new("material", "tag of the material of continua"),
        ])
        .groups(&[BODY]),
    make: Make::AnyNodes(|interp, a| make_quadratic::<8, 16>(interp, a, QuadraticShape::Serendipity)),
};

pub(super) const SIX_NODES: Kind = Kind {
    names: &["tri6n", "sixNodeTri", "SixNodeTri"],
    usage: "element tri6n $tag $n1 ... $n6 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    text: Text::new("Six-node triangle.")
        .example("element tri6n 77 1 2 3 5 6 9 1. PlaneStress 1")
        .arguments(&[
            Arg::whole("n1", "corners against the clock, then the middles of the sides in order"),
            N6,
            QUAD_THICKNESS,
            Arg::new("material", "tag of the material of continua"),
        ])
        .groups(&[BODY]),
    make: Make::AnyNodes(|interp, a| make_quadratic::<6, 12>(interp, a, QuadraticShape::Triangle)),
};

pub(super) const ENHANCED: Kind = Kind {
    names: &["enhancedQuad", "EnhancedQuad"],
    usage: "element enhancedQuad $tag $i $j $k $l $thickness PlaneStrain|PlaneStress $material",
    text: Text::new("Four-node quadrilateral of plane elasticity with enhanced strains.")
        .example("element enhancedQuad 77 1 2 3 4 1. PlaneStress 1")
        .groups(&[&CORNERS, &[QUAD_THICKNESS]]),
    make: Make::AnyNodes(make_enhanced),
};

fn plane_form(a: &Args<'_>, family: &Family, plane: Plane) -> Result<SharedMultiaxial<PLANE>, Exception> {
    form(a, family, (family.0.plane(plane), if plane == Plane::Strain { "in plane strain" } else { "in plane stress" }))
}

/// A material in a plane.
fn plane_law(interp: &Tcl, a: &mut Args<'_>, plane: Plane) -> Result<SharedMultiaxial<PLANE>, Exception> {
    let family = family(interp, a)?;
    plane_form(a, &family, plane)
}

/// Nodes and places of the corners.
fn corners<const N: usize>(interp: &Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, [[f64; 2]; N]), Exception> {
    let (nodes, places) = placed_nodes(interp, a, &CORNERS[0], (2, 2))?;
    Ok((nodes, places.map(|p| [p.x, p.y])))
}

fn plane(a: &mut Args<'_>) -> Result<Plane, Exception> {
    Ok(match a.word("PlaneStrain or PlaneStress")?.as_ref() {
        "PlaneStrain" | "PlaneStrain2D" => Plane::Strain,
        "PlaneStress" | "PlaneStress2D" => Plane::Stress,
        _ => return Err(a.unknown_name("kind of plane", ["PlaneStrain", "PlaneStress"])),
    })
}

fn body_forces(a: &mut Args<'_>, body: &mut [f64; 2]) -> Result<(), Exception> {
    for (b, name) in body.iter_mut().zip(["body force bx", "body force by"]) {
        *b = a.optional_float(name)?.unwrap_or(0.0);
    }
    Ok(())
}

/// Thickness, plane, material, pressure, density and body forces.
fn properties(interp: &Tcl, a: &mut Args<'_>) -> Result<(SharedMultiaxial<PLANE>, QuadOptions), Exception> {
    let mut o = QuadOptions { thickness: a.number(&QUAD_THICKNESS)?, ..QuadOptions::default() };
    let plane = plane(a)?;
    let law = plane_law(interp, a, plane)?;
    o.pressure = a.optional_number(&PRESSURE)?.unwrap_or(0.0);
    if a.at_number() {
        o.rho = a.number(&RHO)?;
    }
    body_forces(a, &mut o.body)?;
    Ok((law, o))
}

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let (law, o) = properties(interp, a)?;
    let made = Continuum::quad(&corners, &law, &o).map_err(|e| refused(a, place, e))?;
    let damping = optional(interp, a)?;
    Ok((nodes, damped(made.shared(), damping).map_err(|e| refused(a, place, e))?))
}

fn make_mean_dilatation(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let thickness = a.number(&QUAD_THICKNESS)?;
    let family = family(interp, a)?;
    let solid = form(a, &family, (family.0.solid.as_ref(), "in space"))?;
    let law = Condensed::thick_plane(&solid);
    let made = Continuum::mean_dilatation_quad(&corners, &law, thickness).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}

fn make_triangle(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<3>(interp, a)?;
    let place = a.last_span();
    let (law, o) = properties(interp, a)?;
    let made = Continuum::triangle(&corners, &law, &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}

fn make_stabilised(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let family = family(interp, a)?;
    let plane = plane(a)?;
    let law = plane_form(a, &family, plane)?;
    let mut o = QuadOptions { thickness: a.number(&QUAD_THICKNESS)?, ..QuadOptions::default() };
    body_forces(a, &mut o.body)?;
    let made = Continuum::stabilised_quad(&corners, &law, &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}

fn make_quadratic<const N: usize, const D: usize>(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    shape: QuadraticShape,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception>
where
    Continuum<PLANE, D>: Shared<dyn Element>,
{
    let (nodes, places) = corners::<N>(interp, a)?;
    let place = a.last_span();
    let (law, o) = properties(interp, a)?;
    let made = Continuum::<PLANE, D>::quadratic(shape, &places, &law, &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}

fn make_enhanced(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let thickness = a.number(&QUAD_THICKNESS)?;
    let plane = plane(a)?;
    let law = plane_law(interp, a, plane)?;
    let made = Continuum::enhanced(&corners, &law, thickness).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}
