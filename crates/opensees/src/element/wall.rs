//! Walls of strips: `element MVLEM`, `SFI_MVLEM`, `E_SFI`, and their forms in space.

use super::corners::{CORNERS, placed_nodes};
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::material::nd_material::{family, form};
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::{
    Element, PLANE_WALL, PanelLaw, SPACE_WALL, WallFibre, WallLines, WallPanel, WallPanels, WallPlate, WallShape,
};
use hysteron_engine::material::{Material, PLANE, SharedMultiaxial};
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Span;
use nalgebra::Vector3;
use std::sync::Arc;

const COR: Arg =
    Arg::of("-CoR", "c", "height of the centre of rotation as a share of the height").within(Domain::Number);
const THICK_MOD: Arg = Arg::of("-ThickMod", "factor", "factor of the thickness in bending").within(Domain::Positive);
const DENSITY: Arg = Arg::of("-Density", "density", "mass per volume of the wall").within(Domain::NotNegative);
const EAVE: Arg = Arg::of("-Eave", "modulus", "modulus of elasticity of the plate").within(Domain::Positive);
const POISSON: Arg = Arg::of("-Poisson", "nu", "Poisson's ratio of the plate").within(Domain::Number);
const MVLEM_DENSITY: Arg = Arg::not_negative("density", "mass per volume of the wall");

const M: Arg = Arg::count("m", "number m of strips");
const THICK_T1: Arg = Arg::of("-thick", "t1", "thickness of a strip").within(Domain::Positive);
const WIDTH_W1: Arg = Arg::of("-width", "w1", "width of a strip").within(Domain::Positive);
const RHO_RATIO1: Arg = Arg::of("-rho", "ratio1", "ratio of reinforcement of a fibre").within(Domain::NotNegative);
const C: Arg = Arg::number("c", "height c of the shear spring as a share of the height");

const PLATE: &[Arg] = &[COR, THICK_MOD, POISSON, DENSITY];

pub(super) const MVLEM: Kind = Kind {
    names: &["MVLEM"],
    usage: "element MVLEM $tag $density $i $j $m $c -thick $t1 ... -width $w1 ... -rho $ratio1 ... -matConcrete $mat1 ... \
            -matSteel $mat1 ... -matShear $mat",
    text: Text::new("Wall of vertical fibres between rigid beams, with a spring for the shear.")
        .example(
            "element MVLEM 77 0. 1 2 1 0.4 -thick 1. -width 1. -rho 0.1 -matConcrete 9 -matSteel 9 \
                -matShear 9",
        )
        .arguments(&[
            MVLEM_DENSITY,
            M,
            C,
            THICK_T1,
            WIDTH_W1,
            RHO_RATIO1,
            Arg::of("-matConcrete", "mat1", "concrete of each fibre").within(Domain::Whole),
            Arg::of("-matSteel", "mat1", "reinforcement of each fibre").within(Domain::Whole),
            Arg::of("-matShear", "mat", "law of the shear force and the shear deformation").within(Domain::Whole),
        ]),
    make: Make::AnyNodes(lines),
};

pub(super) const MVLEM_3D: Kind = Kind {
    names: &["MVLEM_3D"],
    usage: "element MVLEM_3D $tag $i $j $k $l $m -thick $t1 ... -width $w1 ... -rho $ratio1 ... -matConcrete $mat1 ... \
            -matSteel $mat1 ... -matShear $mat <-CoR $c> <-ThickMod $factor> <-Poisson $nu> <-Density $density>",
    text: Text::new(
        "Wall of vertical fibres in space, an elastic plate out of its plane. The corners go against the \
         clock.",
    )
    .example(
        "element MVLEM_3D 77 1 3 4 2 1 -thick 1. -width 1. -rho 0.1 -matConcrete 9 -matSteel 9 \
                -matShear 9",
    )
    .arguments(&[
        M,
        THICK_T1,
        WIDTH_W1,
        RHO_RATIO1,
        Arg::of("-matConcrete", "mat1", "tag of a uniaxial material").within(Domain::Whole),
        Arg::of("-matSteel", "mat1", "tag of a uniaxial material").within(Domain::Whole),
        Arg::of("-matShear", "mat", "tag of a uniaxial material").within(Domain::Whole),
    ])
    .groups(&[&CORNERS, PLATE]),
    make: Make::AnyNodes(lines_in_space),
};

pub(super) const SFI_MVLEM: Kind = Kind {
    names: &["SFI_MVLEM"],
    usage: "element SFI_MVLEM $tag $i $j $m $c -thick $t1 ... -width $w1 ... -mat $mat1 ...",
    text: Text::new("Wall of panels in plane stress, without horizontal stress.")
        .example("element SFI_MVLEM 77 1 2 1 0.4 -thick 1. -width 1. -mat 1")
        .arguments(&[M, C, THICK_T1, WIDTH_W1]),
    make: Make::AnyNodes(|interp, a| panels(interp, a, PanelLaw::NoStress)),
};

pub(super) const E_SFI: Kind = Kind {
    names: &["E_SFI", "E_SFI_MVLEM"],
    usage: "element E_SFI $tag $i $j $m $c -thick $t1 ... -width $w1 ... -mat $mat1 ...",
    text: Text::new("Wall of panels in plane stress, whose horizontal strain follows from the shear strain.")
        .example("element E_SFI 77 1 2 1 0.4 -thick 1. -width 1. -mat 1")
        .arguments(&[M, C, THICK_T1, WIDTH_W1]),
    make: Make::AnyNodes(|interp, a| panels(interp, a, PanelLaw::FromShear)),
};

pub(super) const SFI_MVLEM_3D: Kind = Kind {
    names: &["SFI_MVLEM_3D"],
    usage: "element SFI_MVLEM_3D $tag $i $j $k $l $m -thick $t1 ... -width $w1 ... -mat $mat1 ... <-CoR $c> <-ThickMod $factor> \
            <-Poisson $nu> <-Density $density> <-Eave $modulus>",
    text: Text::new("`SFI_MVLEM` in space, an elastic plate out of its plane. The corners go against the clock.")
        .example("element SFI_MVLEM_3D 77 1 3 4 2 1 -thick 1. -width 1. -mat 1")
        .arguments(&[M, THICK_T1, WIDTH_W1, EAVE])
        .groups(&[&CORNERS, PLATE]),
    make: Make::AnyNodes(|interp, a| panels_in_space(interp, a, PanelLaw::NoStress)),
};

pub(super) const E_SFI_MVLEM_3D: Kind = Kind {
    names: &["E_SFI_MVLEM_3D"],
    usage: "element E_SFI_MVLEM_3D $tag $i $j $k $l $m -thick $t1 ... -width $w1 ... -mat $mat1 ... <-CoR $c> \
            <-ThickMod $factor> <-Poisson $nu> <-Density $density> <-Eave $modulus>",
    text: Text::new("`E_SFI` in space, an elastic plate out of its plane. The corners go against the clock.")
        .example("element E_SFI_MVLEM_3D 77 1 3 4 2 1 -thick 1. -width 1. -mat 1")
        .arguments(&[M, THICK_T1, WIDTH_W1, EAVE])
        .groups(&[&CORNERS, PLATE]),
    make: Make::AnyNodes(|interp, a| panels_in_space(interp, a, PanelLaw::FromShearAndBars)),
};

type WallResult = Result<(Vec<NodeId>, Arc<dyn Element>), Exception>;

/// Options of walls, with those that a kind does not have left empty.
struct Strips {
    thickness: Vec<f64>,
    width: Vec<f64>,
    ratio: Vec<f64>,
    concrete: Vec<(Material, i32)>,
    steel: Vec<(Material, i32)>,
    shear: Option<(Material, i32)>,
    panels: Vec<SharedMultiaxial<PLANE>>,
    centre: f64,
    bending: f64,
    nu: f64,
    density: f64,
    modulus: Option<f64>,
}

const LINES: &[&str] = &["-thick", "-width", "-rho", "-matConcrete", "-matSteel", "-matShear"];
const PANELS: &[&str] = &["-thick", "-width", "-mat"];

impl Strips {
    /// Takes the options `needed`, and in space those that may be left out. Defaults are those of OpenSees.
    fn take(
        interp: &mut Tcl,
        a: &mut Args<'_>,
        count: usize,
        needed: &[&str],
        in_space: bool,
    ) -> Result<Self, Exception> {
        let mut s = Self {
            thickness: vec![],
            width: vec![],
            ratio: vec![],
            concrete: vec![],
            steel: vec![],
            shear: None,
            panels: vec![],
            centre: 0.4,
            bending: 0.63,
            nu: 0.25,
            density: 0.0,
            modulus: None,
        };
        let last = a.last_span();
        while let Some(option) = a.option() {
            match option.as_ref() {
                "-thick" => s.thickness = numbers(count, || a.number(&THICK_T1))?,
                "-width" => s.width = numbers(count, || a.number(&WIDTH_W1))?,
                "-rho" if needed.contains(&"-rho") => {
                    s.ratio = numbers(count, || a.number(&RHO_RATIO1))?;
                }
                "-matConcrete" => s.concrete = numbers(count, || a.of(&interp.host.builder.definitions.materials))?,
                "-matSteel" => s.steel = numbers(count, || a.of(&interp.host.builder.definitions.materials))?,
                "-matShear" => s.shear = Some(a.of(&interp.host.builder.definitions.materials)?),
                "-mat" => {
                    s.panels = numbers(count, || {
                        let family = family(interp, a)?;
                        form(a, &family, (family.0.plane_stress.as_ref(), "in plane stress"))
                    })?;
                }
                "-CoR" if in_space => s.centre = a.number(&COR)?,
                "-ThickMod" if in_space => s.bending = a.number(&THICK_MOD)?,
                "-Poisson" if in_space => s.nu = poisson(a)?,
                "-Density" if in_space => s.density = a.number(&DENSITY)?,
                "-Eave" if in_space => s.modulus = Some(a.number(&EAVE)?),
                "-Coupling" => {
                    // The tangent here always has the terms that this option adds.
                    a.int("coupling")?;
                }
                _ => ignore_unknown(interp, a)?,
            }
        }
        let missing = needed.iter().find(|option| match **option {
            "-thick" => s.thickness.is_empty(),
            "-width" => s.width.is_empty(),
            "-rho" => s.ratio.is_empty(),
            "-matConcrete" => s.concrete.is_empty(),
            "-matSteel" => s.steel.is_empty(),
            "-mat" => s.panels.is_empty(),
            _ => s.shear.is_none(),
        });
        match missing {
            None => Ok(s),
            Some(option) => {
                let message = format!("{option} is missing");
                Err(a.refuse_at(last, message, format!("expected all of {}", needed.join(", "))))
            }
        }
    }

    fn area(&self) -> f64 {
        self.thickness.iter().zip(&self.width).map(|(t, w)| t * w).sum()
    }

    fn fibres(&mut self) -> Vec<WallFibre> {
        let (concrete, steel) = (std::mem::take(&mut self.concrete), std::mem::take(&mut self.steel));
        let sizes = self.thickness.iter().zip(&self.width).zip(&self.ratio);
        let fibre = |((concrete, steel), ((thickness, width), ratio)): ((_, _), ((&f64, &f64), &f64))| WallFibre {
            thickness: *thickness,
            width: *width,
            ratio: *ratio,
            concrete,
            steel,
        };
        concrete.into_iter().zip(steel).zip(sizes).map(fibre).collect()
    }

    fn panels(&self) -> Vec<WallPanel> {
        let sizes = self.thickness.iter().zip(&self.width);
        let panel = |((thickness, width), law): ((&f64, &f64), &SharedMultiaxial<PLANE>)| WallPanel {
            thickness: *thickness,
            width: *width,
            law: Arc::clone(law),
        };
        sizes.zip(&self.panels).map(panel).collect()
    }

    /// The wall in space of corners in OpenSees' order, with the mean of the moduli of the strips.
    fn in_space(
        &self,
        corners: &[Vector3<f64>; 4],
        modulus: impl Fn(usize) -> f64,
    ) -> hysteron_engine::element::ElementResult<WallShape<SPACE_WALL>> {
        let (area, width) = (self.area(), self.width.iter().sum::<f64>());
        let mean =
            self.thickness.iter().zip(&self.width).enumerate().map(|(i, (t, w))| modulus(i) * t * w / area).sum();
        let plate = WallPlate {
            modulus: self.modulus.unwrap_or(mean),
            nu: self.nu,
            thickness: area / width,
            bending: self.bending,
        };
        let height = (corners[2] - corners[0]).norm();
        WallShape::space(corners, width, self.centre, self.density * area * height, &plate)
    }
}

fn poisson(a: &mut Args<'_>) -> Result<f64, Exception> {
    let nu = a.number(&POISSON)?;
    if nu.abs() >= 1.0 {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected between -1 and 1"));
    }
    Ok(nu)
}

/// As many values as there are strips.
fn numbers<T>(count: usize, mut take: impl FnMut() -> Result<T, Exception>) -> Result<Vec<T>, Exception> {
    (0..count).map(|_| take()).collect()
}

fn count(a: &mut Args<'_>) -> Result<usize, Exception> {
    match a.count(&M)? {
        0 => Err(a.refuse("the wall has no strips", "expected 1 or more")),
        count => Ok(count),
    }
}

/// Two nodes above each other, with the height between them.
fn ends(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, f64), Exception> {
    let ends = Ends::take(interp, a)?;
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let (below, above) = ends.place;
    let height = above.y - below.y;
    if above.x != below.x || height <= 0.0 {
        return Err(a.refuse_at(nodes, "node j is not above node i", "expected a node with the same x above node i"));
    }
    Ok((ends.nodes.to_vec(), height))
}

/// Height of the shear spring over that of the wall.
fn centre(a: &mut Args<'_>) -> Result<f64, Exception> {
    a.number(&C)
}

/// Nodes at the corners of a wall, their places, and the last word of them.
type Corners = (Vec<NodeId>, [Vector3<f64>; 4], Option<Span>);

/// Four nodes against the clock: the lower ones, then the upper ones from the right to the left. They are returned in
/// OpenSees' order, the upper ones from the left.
fn corners(interp: &Tcl, a: &mut Args<'_>) -> Result<Corners, Exception> {
    let (mut nodes, mut corners) = placed_nodes(interp, a, &CORNERS[0], (3, 6))?;
    nodes.swap(2, 3);
    corners.swap(2, 3);
    Ok((nodes, corners, a.last_span()))
}

fn lines(interp: &mut Tcl, a: &mut Args<'_>) -> WallResult {
    let density = a.number(&MVLEM_DENSITY)?;
    let (nodes, height) = ends(interp, a)?;
    let count = count(a)?;
    let centre = centre(a)?;
    let mut s = Strips::take(interp, a, count, LINES, false)?;
    let density = if interp.host.follows(&[slips::WALL_MASS]) { 0.0 } else { density };
    let shape: WallShape<PLANE_WALL> = WallShape::plane(height, centre, density * s.area() * height);
    let fibres = s.fibres();
    let Some(shear) = s.shear else { return Err(a.refuse("-matShear is missing", "expected a material")) };
    Ok((nodes, WallLines::new(fibres, shear, shape).shared()))
}

fn lines_in_space(interp: &mut Tcl, a: &mut Args<'_>) -> WallResult {
    let (nodes, corners, place) = corners(interp, a)?;
    let count = count(a)?;
    let mut s = Strips::take(interp, a, count, LINES, true)?;
    let moduli: Vec<f64> = s.concrete.iter().map(|(m, _)| m.initial_tangent()).collect();
    let shape = s.in_space(&corners, |i| moduli[i]).map_err(|e| refused(a, place, e))?;
    let fibres = s.fibres();
    let Some(shear) = s.shear else { return Err(a.refuse("-matShear is missing", "expected a material")) };
    Ok((nodes, WallLines::new(fibres, shear, shape).shared()))
}

fn panels(interp: &mut Tcl, a: &mut Args<'_>, kind: PanelLaw) -> WallResult {
    let (nodes, height) = ends(interp, a)?;
    let count = count(a)?;
    let centre = centre(a)?;
    let s = Strips::take(interp, a, count, PANELS, false)?;
    let strips = s.panels();
    let mass = strips.iter().map(|p| p.law.density() * p.thickness * p.width * height).sum();
    let shape: WallShape<PLANE_WALL> = WallShape::plane(height, centre, mass);
    Ok((nodes, WallPanels::new(strips, kind, shape).shared()))
}

fn panels_in_space(interp: &mut Tcl, a: &mut Args<'_>, kind: PanelLaw) -> WallResult {
    let (nodes, corners, place) = corners(interp, a)?;
    let count = count(a)?;
    let s = Strips::take(interp, a, count, PANELS, true)?;
    // The modulus of the concrete: twice the shear modulus of the virgin panel.
    let shape =
        s.in_space(&corners, |i| 2.0 * s.panels[i].initial_tangent()[2][2]).map_err(|e| refused(a, place, e))?;
    Ok((nodes, WallPanels::new(s.panels(), kind, shape).shared()))
}
