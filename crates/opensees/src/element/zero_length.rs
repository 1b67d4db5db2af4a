//! `element zeroLength`.

use super::damping::{damped, of_tag};
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::model::transform::vector;
use crate::slips;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::element::axes::{self, Orientation};
use hysteron_engine::element::{CoupledZeroLength, Element, RayleighDamping, ZeroLength};
use hysteron_engine::material::Material;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

const DIR1: Arg = Arg::whole("dir1", "first direction");
const DIR2: Arg = Arg::whole("dir2", "second direction");

pub(super) const ZERO_LENGTH: Kind = Kind {
    names: &["zeroLength"],
    usage: "element zeroLength $tag $i $j -mat $mat1 ... -dir $dir1 ... <-doRayleigh <$flag>> \
            <-dampMats $mat1 ...> <-damp $damping> <-orient $x1 $x2 $x3 $yp1 $yp2 $yp3>",
    text: Text::new("Springs between two nodes at one place.").example("element zeroLength 2 1 2 -mat 1 -dir 1"),
    make: Make::TwoNodes(make),
};

pub(super) const COUPLED: Kind = Kind {
    names: &["CoupledZeroLength", "coupledZeroLength", "ZeroLengthCoupled"],
    usage: "element CoupledZeroLength $tag $i $j $dir1 $dir2 $mat <$doRayleigh>",
    text: Text::new("One spring for two directions.").example("element CoupledZeroLength 2 1 2 1 2 1").arguments(&[
        DIR1,
        DIR2,
        Arg::thing("mat", things::MATERIAL),
        Arg::new("doRayleigh", "1: the element takes part in Rayleigh damping"),
    ]),
    make: Make::TwoNodes(make_coupled),
};

fn materials(interp: &Tcl, a: &mut Args<'_>) -> Result<Vec<(Material, i32)>, Exception> {
    let mut out = vec![a.of(&interp.host.builder.definitions.materials)?];
    while a.at_number() {
        out.push(a.of(&interp.host.builder.definitions.materials)?);
    }
    Ok(out)
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let span = a.last_span();
    let (mut mats, mut dirs) = (vec![], vec![]);
    let mut damping = RayleighDamping::None;
    let (mut axes, mut own) = (Matrix3::identity(), None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mat" => mats = materials(interp, a)?,
            "-dir" | "-dof" => {
                while dirs.is_empty() || a.at_number() {
                    let direction = a.dof("direction", 6)? + 1;
                    // In the plane the third degree of freedom of a node is its rotation.
                    let turns = direction == 3 && (ends.ndm, ends.ndf) == (2, 3);
                    dirs.push((if turns { 6 } else { direction }, a.last_span()));
                }
            }
            "-doRayleigh" => {
                let at = a.last_span();
                let flag = a.optional_switch(interp, "flag")?;
                if matches!(damping, RayleighDamping::Materials(_)) {
                    let d = Diagnostic::warning(
                        &checks::words::OVERRIDDEN,
                        "zeroLength: -doRayleigh takes the damping materials away, as in OpenSees",
                    );
                    warn(interp, d.at(at, "expected it before -dampMats"))?;
                }
                damping = match flag {
                    None | Some(true) => RayleighDamping::Model,
                    _ => RayleighDamping::None,
                };
            }
            "-dampMats" => damping = RayleighDamping::Materials(materials(interp, a)?),
            "-damp" => own = Some(of_tag(interp, a)?),
            "-orient" => {
                let place = a.last_span();
                let (x, y) = if ends.ndm == 2 {
                    // In the plane y is square to x, whatever else is given.
                    let x = vector(a, 3, "local x axis")?;
                    if a.at_number() {
                        vector(a, 3, "vector in the local x-y plane")?;
                    }
                    (x, Vector3::new(-x.y, x.x, 0.0))
                } else {
                    let Orientation { x, y } = super::orientation(a, 1)?;
                    (x.unwrap_or(Vector3::x()), y.unwrap_or(Vector3::y()))
                };
                axes = axes::from_x_and_y(x, y).map_err(|e| a.refuse_at(place, e.message(), ""))?;
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    if mats.is_empty() {
        return Err(a.refuse_at(
            span,
            "zeroLength: the materials are missing",
            "expected -mat and their tags after this",
        ));
    }
    if mats.len() < dirs.len() {
        let message =
            format!("zeroLength: {} materials but {} directions: the others stay free", mats.len(), dirs.len());
        let d = Diagnostic::warning(&checks::elements::FEWER_MATERIALS, message)
            .at(dirs[mats.len()].1, "expected a direction for each material");
        warn(interp, d)?;
        dirs.truncate(mats.len());
    }
    if mats.len() > dirs.len() {
        let message = format!("zeroLength: {} materials but {} directions", mats.len(), dirs.len());
        let e = a.refuse_at(dirs.last().map_or(span, |d| d.1), message, "expected a direction for each material");
        return Err(e.by(&checks::elements::MATERIALS_AND_DIRECTIONS));
    }
    let gap = (ends.place.1 - ends.place.0).norm();
    if gap > 1e-6 * ends.place.0.norm().max(ends.place.1.norm()) {
        let message = format!("zeroLength: its nodes are {gap:.6} apart, which the element takes no notice of");
        warn(
            interp,
            Diagnostic::warning(&checks::elements::NODES_APART, message).at(span, "expected a node at the same place"),
        )?;
    }
    let last = dirs.last().and_then(|d| d.1);
    let springs = mats.into_iter().zip(&dirs).map(|((m, tag), (d, _))| (m, tag, *d)).collect();
    let element = ZeroLength::new(springs, ends.ndm, ends.ndf, axes, &ends.initial(), damping);
    let element = element.map_err(|e| refused(a, last, e))?.shared();
    damped(element, own).map_err(|e| refused(a, last, e))
}

fn make_coupled(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let directions = [a.dof(DIR1.meaning, ends.ndf)?, a.dof(DIR2.meaning, ends.ndf)?];
    if directions[0] == directions[1] {
        return Err(a.refuse("both directions are the same", "expected another direction"));
    }
    let material = a.of(&interp.host.builder.definitions.materials)?;
    let rayleigh = a.optional_switch(interp, "flag")?.unwrap_or(false);
    let compat = interp.host.follows(&[slips::COUPLED_ZERO_LENGTH]);
    Ok(CoupledZeroLength::new(material, directions, ends.ndf, &ends.initial(), rayleigh, compat).shared())
}
