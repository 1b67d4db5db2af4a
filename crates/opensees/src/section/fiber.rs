//! `fiber`, `patch` and `layer`: what the body of `section Fiber` is made of.

use super::nd_fiber;
use super::open::OpenSection;
use crate::args::Args;
use crate::checks;
use crate::kind::{Kind, usages};
use crate::material::nd_material::Family;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, ModelBuilder, Outcome, Tcl, finish, slips, warn};
use hysteron_engine::material::Material;
use hysteron_engine::section::Fiber;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};
use std::f64::consts::PI;

const N_IJ: Arg = Arg::count("nIJ", "number of divisions");
const N_JK: Arg = Arg::count("nJK", "number of divisions across");
const BARS: Arg = Arg::count("n", "number of bars");
const R_INNER: Arg = Arg::of_domain("rInner", "inner radius", Domain::UsuallyNotNegative);
const R_OUTER: Arg = Arg::of_domain("rOuter", "outer radius", Domain::UsuallyNotNegative);

const FIBER_Y: Arg = Arg::number("y", "y of the fiber");
const FIBER_Z: Arg = Arg::number("z", "z of the fiber");
const FIBER_AREA: Arg = Arg::of_domain("area", "area of the fiber", Domain::UsuallyNotNegative);
const STRAIGHT_AREA: Arg = Arg::of_domain("area", "area of a bar", Domain::UsuallyPositive);
const RADIUS: Arg = Arg::of_domain("radius", "radius", Domain::UsuallyPositive);
const ANGLE1: Arg = Arg::number("angle1", "first angle");
const ANGLE2: Arg = Arg::number("angle2", "last angle");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("fiber", FIBER, fiber)
        .arguments(&[FIBER_Y, FIBER_Z, FIBER_AREA, Arg::thing("material", things::MATERIAL)])
        .about("Adds one fibre to the section."),
    Command::new("patch", PATCH, patch)
        .about("Adds fibres that fill an area.")
        .arguments(&[
            Arg::thing("material", things::MATERIAL),
            N_IJ,
            N_JK,
            Arg::number("yI", "y of the corner I"),
            Arg::number("zI", "z of the corner I"),
            Arg::number("yJ", "y of the corner J"),
            Arg::number("zJ", "z of the corner J"),
            Arg::number("yK", "y of the corner K"),
            Arg::number("zK", "z of the corner K"),
            Arg::number("yL", "y of the corner L"),
            Arg::number("zL", "z of the corner L"),
            Arg::new("nY", "number of fibres along y"),
            Arg::new("nZ", "number of fibres along z"),
            Arg::new("nCirc", "number of fibres around the circle"),
            Arg::new("nRad", "number of fibres along the radius"),
            Arg::new("y", "centre y"),
            Arg::new("z", "centre z"),
            R_INNER,
            R_OUTER,
            Arg::new("angle1", "first angle in degrees"),
            Arg::new("angle2", "last angle in degrees"),
        ])
        .with_kinds(|| usages(PATCHES)),
    Command::new("layer", LAYER, layer)
        .arguments(&[
            Arg::thing("material", things::MATERIAL),
            BARS,
            STRAIGHT_AREA,
            Arg::number("y1", "y of the first bar"),
            Arg::number("z1", "z of the first bar"),
            Arg::number("y2", "y of the last bar"),
            Arg::number("z2", "z of the last bar"),
            Arg::number("y", "y of the centre"),
            Arg::number("z", "z of the centre"),
            RADIUS,
            ANGLE1,
            ANGLE2,
        ])
        .about("Adds fibres along a line or an arc, as reinforcing bars.")
        .with_kinds(|| usages(LAYERS)),
];

const FIBER: &str = "fiber $y $z $area $material";
const PATCH: &str = "patch quad $material $nIJ $nJK $yI $zI $yJ $zJ $yK $zK $yL $zL | rect $material $nY $nZ $yI $zI $yK $zK | \
                     circ $material $nCirc $nRad $y $z $rInner $rOuter <$angle1 $angle2>";
const LAYER: &str =
    "layer straight $material $n $area $y1 $z1 $y2 $z2 | circ $material $n $area $y $z $radius <$angle1 $angle2>";

/// Shape of a patch.
#[derive(Clone, Copy)]
enum Patch {
    Quadrilateral,
    Rectangle,
    Circle,
}

const PATCHES: &[Kind<Patch>] = &[
    Kind::named(&["quad", "quadr", "quadrilateral"], PATCH, Patch::Quadrilateral),
    Kind::named(&["rect", "rectangular"], PATCH, Patch::Rectangle),
    Kind::named(&["circ", "circular"], PATCH, Patch::Circle),
];

/// Shape of a layer.
#[derive(Clone, Copy, PartialEq)]
enum Layer {
    Line,
    Arc,
}

const LAYERS: &[Kind<Layer>] =
    &[Kind::named(&["straight"], LAYER, Layer::Line), Kind::named(&["circ", "circular"], LAYER, Layer::Arc)];

/// The shape that the next word names.
fn form<F: Copy>(a: &mut Args<'_>, what: &str, family: &str, kinds: &'static [Kind<F>]) -> Result<F, Exception> {
    let name = a.word(what)?;
    let kind = kinds.iter().find(|k| k.names.contains(&name.as_ref()));
    kind.map(|k| k.make).ok_or_else(|| a.unknown_name(family, kinds.iter().flat_map(|k| k.names.iter().copied())))
}

/// Material of a fiber with its tag: in the body of `section NDFiber` one of continua.
enum FiberMaterial {
    Uniaxial((Material, i32)),
    Continuum(Family),
}

/// Fiber of `section NDFiber`.
#[derive(Clone)]
pub(crate) struct ContinuumFiber {
    pub(super) y: f64,
    pub(super) z: f64,
    pub(super) area: f64,
    pub(super) material: Family,
}

/// The material of the section whose body is being run.
fn material(interp: &Tcl, a: &mut Args<'_>) -> Result<FiberMaterial, Exception> {
    let builder = &interp.host.builder;
    if builder.continuum_fibers.is_some() || builder.open_section.as_ref().is_some_and(OpenSection::takes_continua) {
        return Ok(FiberMaterial::Continuum(nd_fiber::material(interp, a)?));
    }
    Ok(FiberMaterial::Uniaxial(a.of(&interp.host.builder.definitions.materials)?))
}

/// Add fibers of a material, each with its place and area, to the section whose body is being run.
fn add(
    interp: &mut Tcl,
    a: &Args<'_>,
    material: FiberMaterial,
    made: impl IntoIterator<Item = ([f64; 2], f64)>,
) -> Result<(), Exception> {
    finish(interp, a)?;
    let keeps_negative = interp.host.follows(&[slips::NEGATIVE_AREAS]);
    let is_flat = interp.host.builder.ndm == 2 && interp.host.follows(&[slips::FLAT_FIBERS]);
    let ModelBuilder { fibers, continuum_fibers, open_section, .. } = &mut interp.host.builder;
    let mut push: Box<dyn FnMut([f64; 2], f64)> = match (material, fibers, continuum_fibers, open_section) {
        (FiberMaterial::Continuum(material), _, Some(fibers), _) => {
            Box::new(move |[y, z], area| fibers.push(ContinuumFiber { y, z, area, material: material.clone() }))
        }
        (FiberMaterial::Continuum(material), _, None, Some(open)) => {
            Box::new(move |[y, z], area| open.push_continuum(ContinuumFiber { y, z, area, material: material.clone() }))
        }
        (FiberMaterial::Uniaxial(material), Some(fibers), ..) => {
            Box::new(move |[y, z], area| fibers.push(Fiber { y, z, area, material: material.clone() }))
        }
        (FiberMaterial::Uniaxial(material), None, _, Some(open)) => {
            Box::new(move |[y, z], area| open.push(Fiber { y, z, area, material: material.clone() }))
        }
        _ => {
            let expected = "expected to be in the body of section Fiber";
            return Err(a.refuse("there is no fiber section to add to", expected));
        }
    };
    for ([y, z], area) in made {
        if area.is_nan() || area <= 0.0 && !keeps_negative {
            let message = format!("a fiber at y = {y:.6}, z = {z:.6} has an area of {area:.6e}");
            return Err(a.refuse(message, "expected corners in the sense that goes from y to z"));
        }
        push([y, if is_flat { 0.0 } else { z }], area);
    }
    Ok(())
}

fn fiber(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIBER);
    let place = [a.number(&FIBER_Y)?, a.number(&FIBER_Z)?];
    let area = a.read(interp, &FIBER_AREA)?;
    let at = a.last_span();
    let material = material(interp, &mut a)?;
    if area == 0.0 {
        // OpenSees integrates it with no effect.
        warn(
            interp,
            Diagnostic::warning(&checks::elements::FIBER_WITHOUT_AREA, "the fiber has no area, and is left out")
                .at(at, "expected more than 0"),
        )?;
        return Ok(Value::EMPTY);
    }
    add(interp, &a, material, [(place, area)])?;
    Ok(Value::EMPTY)
}

fn point(a: &mut Args<'_>, what: &str) -> Result<[f64; 2], Exception> {
    Ok([a.float(&format!("y of the {what}"))?, a.float(&format!("z of the {what}"))?])
}

fn patch(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, PATCH);
    let shape = form(&mut a, "kind of patch", "patch", PATCHES)?;
    let material = material(interp, &mut a)?;
    let [n, m] = a.parts([&N_IJ, &N_JK])?;
    let fibers = match shape {
        Patch::Rectangle => {
            let ([y1, mut z1], [y2, mut z2]) = (point(&mut a, "first corner")?, point(&mut a, "opposite corner")?);
            if (y2 - y1) * (z2 - z1) < 0.0 {
                // As in OpenSees, so that areas are positive.
                std::mem::swap(&mut z1, &mut z2);
            }
            quadrilateral([[y1, z1], [y2, z1], [y2, z2], [y1, z2]], n, m)
        }
        Patch::Circle => {
            let centre = point(&mut a, "centre")?;
            let mut inner = a.read(interp, &R_INNER)?;
            let mut outer = a.read(interp, &R_OUTER)?;
            let radii_at = a.last_span();
            if inner == outer {
                return Err(a.refuse(format!("the outer radius {outer} is not greater than the inner one"), ""));
            }
            let mut angles = match a.optional_number(&ANGLE1)? {
                Some(first) => [first, a.number(&ANGLE2)?],
                None => [0.0, 360.0],
            };
            if inner > outer && angles[0] > angles[1] {
                // Both turned round give the same fibers in OpenSees.
                let d = Diagnostic::warning(
                    &checks::elements::PATCH_TURNED_ROUND,
                    "the radii and the angles of the patch are both turned round",
                );
                warn(interp, d.at(radii_at, "expected the inner radius before the outer one"))?;
                std::mem::swap(&mut inner, &mut outer);
                angles.reverse();
            } else if inner > outer {
                let message = format!("the outer radius {outer} is not greater than the inner one");
                a.doubt_at(interp, radii_at, message, "expected the inner radius before the outer one")?;
            }
            ring(centre, [inner, outer], angles, n, m)
        }
        Patch::Quadrilateral => {
            let mut corners = [[0.0; 2]; 4];
            for (corner, name) in corners.iter_mut().zip(["corner I", "corner J", "corner K", "corner L"]) {
                *corner = point(&mut a, name)?;
            }
            quadrilateral(corners, n, m)
        }
    };
    add(interp, &a, material, fibers)?;
    Ok(Value::EMPTY)
}

/// Cells of a quadrilateral I J K L with `n` divisions from I to J and `m` from J to K: centroids and areas. Of two fibers
/// that are as near to a point, the round-off decides which one a recorder shows, so that corners and centroids are added
/// up in the order of OpenSees.
fn quadrilateral(corners: [[f64; 2]; 4], n: usize, m: usize) -> Vec<([f64; 2], f64)> {
    let natural = |i: usize, count: usize| -1.0 + 2.0 / count as f64 * i as f64;
    let at = |i: usize, j: usize| {
        let (xi, eta) = (natural(i, n), natural(j, m));
        let quarters =
            [(1.0 - xi) * (1.0 - eta), (1.0 + xi) * (1.0 - eta), (1.0 + xi) * (1.0 + eta), (1.0 - xi) * (1.0 + eta)];
        let mut p = [0.0; 2];
        for (quarter, c) in quarters.iter().zip(&corners) {
            p[0] += quarter / 4.0 * c[0];
            p[1] += quarter / 4.0 * c[1];
        }
        p
    };
    let cells = (0..m).flat_map(|j| (0..n).map(move |i| (i, j)));
    cells.map(|(i, j)| cell([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])).collect()
}

/// Difference of two ways to the centroid over the size of the cell, above which the coordinates have cancelled.
const CANCELLED: f64 = 1e-9;

/// Centroid and area of a quadrilateral.
fn cell(p: [[f64; 2]; 4]) -> ([f64; 2], f64) {
    let (centroid, area) = about_first_corner(p);
    let plain = about_origin(p);
    let size = p.iter().flat_map(|c| [c[0] - p[0][0], c[1] - p[0][1]]).fold(0.0f64, |m, d| m.max(d.abs()));
    let near = |i: usize| (plain[i] - centroid[i]).abs() <= CANCELLED * size;
    (if near(0) && near(1) { plain } else { centroid }, area)
}

/// Centroid and area, where large coordinates do not cancel.
fn about_first_corner(p: [[f64; 2]; 4]) -> ([f64; 2], f64) {
    let [y0, z0] = p[0];
    let (mut double, mut y, mut z) = (0.0, 0.0, 0.0);
    for i in 0..4 {
        let ([a, b], [c, d]) = (p[i], p[(i + 1) % 4]);
        let (a, b, c, d) = (a - y0, b - z0, c - y0, d - z0);
        let cross = a * d - c * b;
        double += cross;
        y += (a + c) * cross;
        z += (b + d) * cross;
    }
    ([y0 + y / (3.0 * double), z0 + z / (3.0 * double)], 0.5 * double)
}

/// Centroid with the round-off of OpenSees.
fn about_origin(p: [[f64; 2]; 4]) -> [f64; 2] {
    let (mut double, mut y, mut z) = (0.0, 0.0, 0.0);
    for i in 0..4 {
        let ([a, b], [c, d]) = (p[i], p[(i + 1) % 4]);
        let (dy, dz) = (c - a, d - b);
        let product = a * b + (a * dz + b * dy) / 2.0 + dy * dz / 3.0;
        double += dz * (c + a);
        y -= dy * product;
        z += dz * product;
    }
    let area = double / 2.0;
    [y / area, z / area]
}

/// Radians with the round-off of OpenSees.
fn radians(degrees: f64) -> f64 {
    PI * degrees / 180.0
}

/// Cells of a part of a ring, angles in degrees, with `n` divisions along it and `m` across: centroids and areas.
fn ring(centre: [f64; 2], radii: [f64; 2], angles: [f64; 2], n: usize, m: usize) -> Vec<([f64; 2], f64)> {
    let angles = angles.map(radians);
    let (width, angle) = ((radii[1] - radii[0]) / m as f64, (angles[1] - angles[0]) / n as f64);
    let half = angle / 2.0;
    let sector = |r: f64| (half * r * r, 2.0 * r * half.sin() / (3.0 * half));
    let cell = |(i, j): (usize, usize)| {
        let inner = radii[0] + width * j as f64;
        let middle = angles[0] + angle * i as f64 + half;
        let ((hole, hole_at), (whole, whole_at)) = (sector(inner), sector(inner + width));
        let area = whole - hole;
        let radius = (whole * whole_at - hole * hole_at) / area;
        ([centre[0] + radius * middle.cos(), centre[1] + radius * middle.sin()], area)
    };
    (0..m).flat_map(|j| (0..n).map(move |i| (i, j))).map(cell).collect()
}

fn layer(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, LAYER);
    let shape = form(&mut a, "kind of layer", "layer", LAYERS)?;
    let material = material(interp, &mut a)?;
    let [n] = a.parts([&BARS])?;
    let area = a.read(interp, &STRAIGHT_AREA)?;
    let places: Vec<[f64; 2]> = if shape == Layer::Line {
        let (first, last) = (point(&mut a, "first bar")?, point(&mut a, "last bar")?);
        if n == 1 {
            vec![[0, 1].map(|k| (first[k] + last[k]) / 2.0)]
        } else {
            let step = [0, 1].map(|k| (last[k] - first[k]) / (n - 1) as f64);
            (0..n).map(|i| [0, 1].map(|k| first[k] + step[k] * i as f64)).collect()
        }
    } else {
        let (centre, radius) = (point(&mut a, "centre")?, a.read(interp, &RADIUS)?);
        let [first, mut last] = match a.optional_number(&ANGLE1)? {
            Some(first) => [first, a.number(&ANGLE2)?],
            None => [0.0, 360.0],
        };
        if last - first >= 360.0 {
            // A whole circle has no bar twice.
            last = first + 360.0 - 360.0 / n as f64;
        }
        let (first, last) = (radians(first), radians(last));
        let step = if n == 1 { 0.0 } else { (last - first) / (n - 1) as f64 };
        let angle = |i: usize| first + step * i as f64;
        (0..n).map(|i| [centre[0] + radius * angle(i).cos(), centre[1] + radius * angle(i).sin()]).collect()
    };
    add(interp, &a, material, places.into_iter().map(|p| (p, area)))?;
    Ok(Value::EMPTY)
}
