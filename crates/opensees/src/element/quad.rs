//! `element quad`.

use super::{Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::node_of;
use hysteron_engine::element::{Element, Quad, QuadOptions};
use hysteron_engine::material::{Isotropic, Plane};
use hysteron_engine::model::{NdMaterial, NodeId};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const QUAD: Kind = Kind {
    names: &["quad", "stdQuad", "FourNodeQuad"],
    usage: "element quad $tag $i $j $k $l $thickness PlaneStrain|PlaneStress $material <$pressure $rho $bx $by>",
    make: Make::AnyNodes(make),
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

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (mut nodes, mut corners) = (vec![], [[0.0; 2]; 4]);
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
    let place = a.last_span();
    let mut o = QuadOptions { thickness: a.positive("thickness")?, ..QuadOptions::default() };
    let plane = match a.word("PlaneStrain or PlaneStress")?.as_ref() {
        "PlaneStrain" | "PlaneStrain2D" => Plane::Strain,
        "PlaneStress" | "PlaneStress2D" => Plane::Stress,
        _ => return Err(a.unknown_name("kind of plane", ["PlaneStrain", "PlaneStress"])),
    };
    let material = isotropic(interp, a)?;
    if plane == Plane::Strain && material.nu == 0.5 {
        return Err(a.refuse("Poisson's ratio of the material is 0.5", "expected less than 0.5 in plane strain"));
    }
    o.pressure = a.optional_float("pressure")?.unwrap_or(0.0);
    if a.at_number() {
        o.rho = a.not_negative("mass per volume rho")?;
    }
    for (b, name) in o.body.iter_mut().zip(["body force bx", "body force by"]) {
        *b = a.optional_float(name)?.unwrap_or(0.0);
    }
    let made = Quad::new(&corners, &material, plane, &o).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}
