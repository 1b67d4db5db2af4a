//! `element twoNodeLink`.

use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::model::transform::vector;
use crate::text::any_command::MASS;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::element::axes;
use hysteron_engine::element::{Element, LinkOptions, TwoNodeLink};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

const P_DELTA: Arg = Arg::of("-pDelta", "My1", "ratio of a P-Delta moment").within(Domain::Number);

pub(super) const TWO_NODE_LINK: Kind = Kind {
    names: &["twoNodeLink"],
    usage: "element twoNodeLink $tag $i $j -mat $mat1 ... -dir $dir1 ... <-orient <$x1 $x2 $x3> $yp1 $yp2 $yp3> \
            <-pDelta <$My1 $My2> $Mz1 $Mz2> <-shearDist $sDy <$sDz>> <-doRayleigh> <-mass $m>",
    text: Text::new("Springs between two nodes at a distance.")
        .example("element twoNodeLink 2 1 2 -mat 1 -dir 1")
        .arguments(&[P_DELTA]),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need_any(a)?;
    let (mut mats, mut dirs) = (vec![], vec![]);
    let mut last = nodes;
    let (mut orient, mut orient_at) = ((None, None), nodes);
    let mut options = LinkOptions { p_delta: None, shear_dist: [0.5; 2], mass: 0.0, rayleigh: false };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mat" => {
                while mats.is_empty() || a.at_number() {
                    mats.push(a.of(&interp.host.builder.definitions.materials)?);
                }
            }
            "-dir" | "-dof" => {
                while dirs.is_empty() || a.at_number() {
                    dirs.push(a.dof("direction", ends.ndf)? + 1);
                    last = a.last_span();
                }
            }
            "-orient" => {
                orient_at = a.last_span();
                let first = vector(a, 3, "vector after -orient")?;
                orient = if a.at_number() {
                    (Some(first), Some(vector(a, 3, "local x-y plane's vector after -orient")?))
                } else if ends.ndm == 3 {
                    (None, Some(first))
                } else {
                    (Some(first), None)
                };
            }
            "-pDelta" => options.p_delta = Some(moment_ratios(interp, a, ends.ndm, "twoNodeLink")?),
            "-shearDist" => {
                let axes = if ends.ndm == 3 { 2 } else { 1 };
                for dist in &mut options.shear_dist[..axes] {
                    *dist = fraction(interp, a, "place of the shear spring as a fraction of the length")?;
                }
            }
            "-doRayleigh" => options.rayleigh = true,
            "-mass" => options.mass = a.number(&MASS)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if mats.is_empty() {
        return Err(a.refuse_at(
            nodes,
            "twoNodeLink: the materials are missing",
            "expected -mat and their tags after this",
        ));
    }
    if mats.len() != dirs.len() {
        let message = format!("twoNodeLink: {} materials but {} directions", mats.len(), dirs.len());
        let e = a.refuse_at(last, message, "expected a direction for each material");
        return Err(e.by(&checks::elements::MATERIALS_AND_DIRECTIONS));
    }
    let line = ends.place.1 - ends.place.0;
    let length = if line.norm() > f64::EPSILON { line.norm() } else { 0.0 };
    let axes = axes_of(a, ends.ndm, line, orient, orient_at)?;
    let springs = mats.into_iter().zip(dirs).map(|((m, tag), d)| (m, tag, d)).collect();
    let link = TwoNodeLink::new(springs, (ends.ndm, ends.ndf), axes, length, &options);
    Ok(link.map_err(|e| refused(a, nodes, e))?.shared())
}

/// Local axes: along the line unless x is given, global ones if the nodes are at one place.
fn axes_of(
    a: &Args<'_>,
    ndm: usize,
    line: Vector3<f64>,
    (x, y): (Option<Vector3<f64>>, Option<Vector3<f64>>),
    span: Option<Span>,
) -> Result<Matrix3<f64>, Exception> {
    if ndm == 1 {
        return Ok(Matrix3::identity());
    }
    let apart = line.norm() > f64::EPSILON;
    let x = x.unwrap_or(if apart { line } else { Vector3::x() });
    let y = match y {
        // In the plane, y is square to x whatever is given.
        _ if ndm == 2 => Vector3::new(-x.y, x.x, 0.0),
        Some(y) => y,
        // A line along the global Y has the local y axis on the side of the global X.
        None if line.x == 0.0 && line.z == 0.0 && apart => Vector3::new(-line.y.signum(), 0.0, 0.0),
        None => Vector3::y(),
    };
    axes::from_x_and_y(x, y).map_err(|e| a.refuse_at(span, format!("twoNodeLink: {}", e.message()), ""))
}

/// A fraction of the length; out of range it is put right with a warning, as OpenSees does.
fn fraction(interp: &mut Tcl, a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    let x = a.float(what)?;
    let good = x.abs().min(1.0);
    if good != x {
        let message = format!("twoNodeLink: {what} is {x}; {good} is taken");
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                .at(a.last_span(), "expected a fraction, 0 to 1"),
        )?;
    }
    Ok(good)
}

/// Ratios of the P-Delta moments: about y at i and j (only in space), about z at i and j.
pub(super) fn moment_ratios(interp: &mut Tcl, a: &mut Args<'_>, ndm: usize, kind: &str) -> Result<[f64; 4], Exception> {
    let mut ratios = [0.0; 4];
    // OpenSees reads four numbers in one dimension too, where there is nothing for them to do.
    let first = if ndm == 2 { 2 } else { 0 };
    for pair in (first..4).step_by(2) {
        for ratio in &mut ratios[pair..pair + 2] {
            *ratio = a.number(&P_DELTA)?;
            if *ratio < 0.0 {
                let message = format!("{kind}: the P-Delta moment ratio {ratio} is negative; its size is taken");
                warn(
                    interp,
                    Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                        .at(a.last_span(), "expected a fraction, 0 to 1"),
                )?;
                *ratio = ratio.abs();
            }
        }
        let sum = ratios[pair] + ratios[pair + 1];
        if sum > 1.0 {
            let message = format!("{kind}: the P-Delta moment ratios sum up to {sum}; they are scaled down to 1");
            warn(
                interp,
                Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                    .at(a.last_span(), "expected a sum of at most 1"),
            )?;
            ratios[pair..pair + 2].iter_mut().for_each(|r| *r /= sum);
        }
    }
    Ok(ratios)
}
