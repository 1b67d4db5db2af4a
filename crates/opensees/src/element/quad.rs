//! `element quad`, `SSPquad`, `tri31`, `quad9n`, `quad8n`, `tri6n` and `enhancedQuad`.

use super::damping::{damped, optional};
use super::{Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::node_of;
use hysteron_engine::element::{ConstantStrain, Element, PlaneElastic, Quad, QuadOptions, QuadraticShape};
use hysteron_engine::material::{Isotropic, Plane};
use hysteron_engine::model::{NdMaterial, NodeId};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const QUAD: Kind = Kind {
    names: &["quad", "stdQuad", "FourNodeQuad"],
    usage: "element quad $tag $i $j $k $l $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by> \
            <-damp $damping>",
    make: Make::AnyNodes(make),
};

pub(super) const STABILISED: Kind = Kind {
    names: &["SSPquad", "SSPQuad"],
    usage: "element SSPquad $tag $i $j $k $l $material PlaneStrain|PlaneStress $thickness <$bx $by>",
    make: Make::AnyNodes(make_stabilised),
};

pub(super) const TRIANGLE: Kind = Kind {
    names: &["tri31", "Tri31"],
    usage: "element tri31 $tag $i $j $k $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    make: Make::AnyNodes(make_triangle),
};

pub(super) const NINE_NODES: Kind = Kind {
    names: &["quad9n", "nineNodeQuad", "NineNodeQuad"],
    usage: "element quad9n $tag $n1 ... $n9 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    make: Make::AnyNodes(|interp, a| make_quadratic::<9>(interp, a, QuadraticShape::Lagrange)),
};

pub(super) const EIGHT_NODES: Kind = Kind {
    names: &["quad8n", "eightNodeQuad", "EightNodeQuad"],
    usage: "element quad8n $tag $n1 ... $n8 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    make: Make::AnyNodes(|interp, a| make_quadratic::<8>(interp, a, QuadraticShape::Serendipity)),
};

pub(super) const SIX_NODES: Kind = Kind {
    names: &["tri6n", "sixNodeTri", "SixNodeTri"],
    usage: "element tri6n $tag $n1 ... $n6 $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    make: Make::AnyNodes(|interp, a| make_quadratic::<6>(interp, a, QuadraticShape::Triangle)),
};

pub(super) const ENHANCED: Kind = Kind {
    names: &["enhancedQuad", "EnhancedQuad"],
    usage: "element enhancedQuad $tag $i $j $k $l $thickness PlaneStrain|PlaneStress $material",
    make: Make::AnyNodes(make_enhanced),
};

/// An elastic material of continua.
pub(super) fn isotropic(interp: &Tcl, a: &mut Args<'_>) -> Result<Isotropic, Exception> {
    match a.of(&interp.host.builder.definitions.nd_materials)? {
        (NdMaterial::Isotropic(material), _) => Ok(material),
        (NdMaterial::Plate(_), tag) => {
            Err(a.refuse(format!("material {tag} is one of plates"), "expected an ElasticIsotropic material"))
        }
    }
}

/// Nodes and places of the corners.
fn corners<const N: usize>(interp: &Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, [[f64; 2]; N]), Exception> {
    let (mut nodes, mut corners) = (vec![], [[0.0; 2]; N]);
    for corner in &mut corners {
        let id = node_of(interp, a, "tag of a corner's node")?;
        let node = &interp.host.engine.model().nodes[id.0];
        if (node.ndm(), node.ndf) != (2, 2) {
            let message = format!("node {} has {} degrees of freedom in {} dimensions", node.tag, node.ndf, node.ndm());
            return Err(a.refuse(message, "expected 2 degrees of freedom in 2 dimensions"));
        }
        corner.copy_from_slice(&node.coords[..2]);
        nodes.push(id);
    }
    Ok((nodes, corners))
}

fn plane(a: &mut Args<'_>) -> Result<Plane, Exception> {
    Ok(match a.word("PlaneStrain or PlaneStress")?.as_ref() {
        "PlaneStrain" | "PlaneStrain2D" => Plane::Strain,
        "PlaneStress" | "PlaneStress2D" => Plane::Stress,
        _ => return Err(a.unknown_name("kind of plane", ["PlaneStrain", "PlaneStress"])),
    })
}

fn possible(a: &Args<'_>, material: &Isotropic, plane: Plane) -> Result<(), Exception> {
    if plane == Plane::Strain && material.nu == 0.5 {
        return Err(a.refuse("Poisson's ratio of the material is 0.5", "expected less than 0.5 in plane strain"));
    }
    Ok(())
}

fn body_forces(a: &mut Args<'_>, body: &mut [f64; 2]) -> Result<(), Exception> {
    for (b, name) in body.iter_mut().zip(["body force bx", "body force by"]) {
        *b = a.optional_float(name)?.unwrap_or(0.0);
    }
    Ok(())
}

/// Thickness, plane, material, pressure, density and body forces.
fn properties(interp: &Tcl, a: &mut Args<'_>) -> Result<(Isotropic, Plane, QuadOptions), Exception> {
    let mut o = QuadOptions { thickness: a.positive("thickness")?, ..QuadOptions::default() };
    let plane = plane(a)?;
    let material = isotropic(interp, a)?;
    possible(a, &material, plane)?;
    o.pressure = a.optional_float("pressure")?.unwrap_or(0.0);
    if a.at_number() {
        o.rho = a.not_negative("mass per volume rho")?;
    }
    body_forces(a, &mut o.body)?;
    Ok((material, plane, o))
}

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let (material, plane, o) = properties(interp, a)?;
    let made = Quad::new(&corners, &material, plane, &o).map_err(|e| refused(a, place, e))?;
    let damping = optional(interp, a)?;
    Ok((nodes, damped(Arc::new(made), damping).map_err(|e| refused(a, place, e))?))
}

fn make_triangle(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<3>(interp, a)?;
    let place = a.last_span();
    let (material, plane, o) = properties(interp, a)?;
    let made = ConstantStrain::triangle(&corners, (&material, plane), &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

fn make_stabilised(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let material = isotropic(interp, a)?;
    let plane = plane(a)?;
    possible(a, &material, plane)?;
    let mut o = QuadOptions { thickness: a.positive("thickness")?, ..QuadOptions::default() };
    body_forces(a, &mut o.body)?;
    let made = ConstantStrain::stabilised_quad(&corners, (&material, plane), &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

fn make_quadratic<const N: usize>(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    shape: QuadraticShape,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places) = corners::<N>(interp, a)?;
    let place = a.last_span();
    let (material, plane, o) = properties(interp, a)?;
    let made = PlaneElastic::quadratic(shape, &places, (&material, plane), &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

fn make_enhanced(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, corners) = corners::<4>(interp, a)?;
    let place = a.last_span();
    let thickness = a.positive("thickness")?;
    let plane = plane(a)?;
    let material = isotropic(interp, a)?;
    possible(a, &material, plane)?;
    let made = PlaneElastic::enhanced(&corners, (&material, plane), thickness).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}
