//! `element inerter`.

use super::two_node_link::moment_ratios;
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::model::transform::vector;
use crate::text::any_command::MASS;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::axes;
use hysteron_engine::element::{Element, Inerter, InerterOptions};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Span;
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

/// Force over acceleration: a matrix by rows with a row for each direction.
const INERTANCE: Arg = Arg::of("-inertance", "b11", "inertance").within(Domain::Number);
/// Force over velocity, likewise.
const DAMP: Arg = Arg::of("-damp", "c11", "damping coefficient").within(Domain::Number);

pub(super) const INERTER: Kind = Kind {
    names: &["inerter", "Inerter"],
    usage: "element inerter $tag $i $j -dir $dir1 ... -inertance $b11 ... <-orient <$x1 $x2 $x3> $yp1 $yp2 $yp3> \
            <-pDelta <$My1 $My2> $Mz1 $Mz2> <-doRayleigh> <-damp $c11 ...> <-mass $m>",
    text: Text::new("Forces in proportion to relative accelerations of two nodes, with damping.")
        .example("element inerter 77 1 2 -dir 1 2 -inertance 2. 0. 0. 1.")
        .arguments(&[
            Arg::of(
                "-dir",
                "dir1",
                "directions of the relative motions: degrees of freedom of the nodes in local axes",
            )
            .within(Domain::Whole),
            INERTANCE,
            Arg::of("-pDelta", "My1", "shares of the P-Delta moments about local y at nodes i and j, in space")
                .within(Domain::Number),
            DAMP,
            MASS,
        ]),
    make: Make::TwoNodes(make),
};

/// The vectors x and y after `-orient`.
type Vectors = (Option<Vector3<f64>>, Option<Vector3<f64>>);

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need_any(a)?;
    let mut options = InerterOptions::default();
    if !matches!(a.word("option -dir")?.as_ref(), "-dir" | "-dof") {
        return Err(a.unknown_name("option in this place", ["-dir"]));
    }
    while options.directions.is_empty() || a.at_number() {
        options.directions.push(a.dof("direction", ends.ndf)? + 1);
    }
    if !matches!(a.word("option -inertance")?.as_ref(), "-inertance" | "-inertia") {
        return Err(a.unknown_name("option in this place", ["-inertance"]));
    }
    let count = options.directions.len();
    options.inertance = matrix(a, count, &INERTANCE)?;
    let (mut orient, mut orient_at) = ((None, None), nodes);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-orient" => {
                orient_at = a.last_span();
                let first = vector(a, 3, "vector after -orient")?;
                orient = if a.at_number() {
                    (Some(first), Some(vector(a, 3, "local x-y plane's vector after -orient")?))
                } else {
                    (None, Some(first))
                };
            }
            "-pDelta" => options.p_delta = Some(moment_ratios(interp, a, ends.ndm, "inerter")?),
            "-doRayleigh" => options.rayleigh = true,
            "-damp" => options.damping = matrix(a, count, &DAMP)?,
            "-mass" => options.mass = a.number(&MASS)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let line = ends.place.1 - ends.place.0;
    let length = if line.norm() > f64::EPSILON { line.norm() } else { 0.0 };
    let axes = axes_of(a, ends.ndm, line, orient, orient_at)?;
    let inerter = Inerter::new((ends.ndm, ends.ndf), axes, length, options);
    Ok(inerter.map_err(|e| refused(a, nodes, e))?.shared())
}

/// A square matrix, by rows.
fn matrix(a: &mut Args<'_>, rows: usize, arg: &Arg) -> Result<Vec<f64>, Exception> {
    (1..=rows * rows).map(|i| a.nth_number(arg, i)).collect()
}

/// Local axes: along the line unless x is given, and global ones if the nodes are at one place.
fn axes_of(
    a: &Args<'_>,
    ndm: usize,
    line: Vector3<f64>,
    (x, y): Vectors,
    span: Option<Span>,
) -> Result<Matrix3<f64>, Exception> {
    if ndm == 1 {
        return Ok(Matrix3::identity());
    }
    let apart = line.norm() > f64::EPSILON;
    let x = x.unwrap_or(if apart { line } else { Vector3::x() });
    // A line along the global Z has no y axis of its own.
    let y = y.unwrap_or(if apart { Vector3::new(-line.y, line.x, 0.0) } else { Vector3::y() });
    axes::from_x_and_y(x, y).map_err(|e| {
        let label = if ndm == 3 { "expected -orient with a vector that is not along the element" } else { "" };
        a.refuse_at(span, format!("inerter: {}", e.message()), label)
    })
}
