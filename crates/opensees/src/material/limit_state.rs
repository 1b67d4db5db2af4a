//! `limitCurve`, and the springs that fail at one.

use super::Kind;
use super::hysteretic::{ENVELOPE, PINCHING_AND_DAMAGE, POINTS, UNLOADING_EXPONENT, envelope};
use crate::args::Args;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind, slips};
use hysteron_engine::material::{
    Column, LimitCurve, LimitDeformation, LimitForce, LimitState, LimitSurface, Material, RotationLimit, RotationShear,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::{Call, Exception, Value};

const ROTATION_DELTA: Arg = Arg::number("delta", "shift of the rotation delta");

/// Points of a curve.
const CURVE_POINTS: [Arg; 6] = [
    Arg::number("x1", "deformation x 1"),
    Arg::number("y1", "force y 1"),
    Arg::number("x2", "deformation x 2"),
    Arg::number("y2", "force y 2"),
    Arg::number("x3", "deformation x 3"),
    Arg::number("y3", "force y 3"),
];
const DELTA: Arg = Arg::number("delta", "shift of the drift delta");
const RHOT: Arg = Arg::number("rhot", "ratio of hoops rhot");

const TAG: Arg = Arg::whole("tag", "tag of the limit curve");
const SHEAR_ELEMENT: Arg = Arg::whole("element", "tag of the element");
const SHEAR: [Arg; 6] = [
    Arg::not_negative("rho", "ratio of hoops rho"),
    Arg::positive("fc", "concrete strength fc in psi"),
    Arg::positive("b", "width b"),
    Arg::positive("h", "depth h"),
    Arg::positive("d", "effective depth d"),
    Arg::not_negative("Fsw", "force of the hoops Fsw"),
];
const KDEG: Arg = Arg::number("Kdeg", "slope after failure Kdeg");
const SHEAR_FRES: Arg = Arg::not_negative("Fres", "residual force Fres");
const DEF_TYPE: Arg = Arg::whole("defType", "type of the deformation defType");
const FOR_TYPE: Arg = Arg::whole("forType", "type of the force forType");
const AXIAL_FSW: Arg = Arg::positive("Fsw", "force of the hoops Fsw");
const AXIAL_FRES: Arg = Arg::number("Fres", "residual force Fres");
const NODE_I: Arg = Arg::whole("nodeI", "tag of node I");
const NODE_J: Arg = Arg::whole("nodeJ", "tag of node J");
const ROT_AXIS: Arg = Arg::whole("rotAxis", "axis of the rotation rotAxis");
const VN: Arg = Arg::number("Vn", "shear strength Vn");
const VR: Arg = Arg::number("Vr", "residual shear Vr");
const ROT_LIM: Arg = Arg::positive("rotLim", "rotation at failure rotLim");

const DRIFT: &[Arg] = &[
    Arg::whole("nodeI", "tags of the nodes whose drift counts, for defType 2"),
    Arg::new("nodeJ", "tags of the nodes whose drift counts, for defType 2"),
    Arg::new("dof", "degree of freedom of the drift"),
    Arg::new("perpDirn", "coordinate along the column, 1 to 3"),
];

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["LimitState"],
    usage: "uniaxialMaterial LimitState $tag $s1p $e1p $s2p $e2p <$s3p $e3p> $s1n $e1n $s2n $e2n <$s3n $e3n> $pinchX $pinchY \
            $damage1 $damage2 <$beta <$curve $curveType <$degrade>>>",
    text: Text::new(
        "Hysteresis with pinching that fails when a column reaches a limit curve. Springs in `zeroLength`, \
         `twoNodeLink` and in sections `Aggregator` watch their column; inside other materials they do \
         not.",
    )
    .example("uniaxialMaterial LimitState 77 1 1 1 2 -1 -1 1 -2 1 1 1 1")
    .points(POINTS)
    .groups(&[&ENVELOPE[0], &ENVELOPE[1], &PINCHING_AND_DAMAGE, &[UNLOADING_EXPONENT]])
    .arguments(&[
        Arg::new("curve", "tag of a limit curve"),
        Arg::new("curveType", "1: a spring that loses axial load; 0: no curve; else a spring that loses shear"),
        Arg::new("degrade", "1: the largest deformation of one side counts for the other one too"),
    ]),
    make: limit_state,
}];

pub(crate) const COMMANDS: &[Command] = &[Command::new("limitCurve", USAGE, limit_curve)
    .arguments(&[TAG, SHEAR_ELEMENT])
    .about("Makes a surface of deformations and forces at which a column fails.")
    .defining(&[things::LIMIT_CURVE], 2)
    .with_kinds(|| kind::usages(CURVES))];

const USAGE: &str = "limitCurve $kind $tag $element ...";

/// A kind of curve, made from the words after the tag of its element.
type CurveKind = kind::Kind<fn(&mut Args<'_>, i32) -> Result<LimitCurve, Exception>>;

const CURVES: &[CurveKind] = &[
    CurveKind {
        names: &["Shear"],
        usage: "limitCurve Shear $tag $element $rho $fc $b $h $d $Fsw $Kdeg $Fres $defType $forType \
                <$nodeI $nodeJ $dof $perpDirn> <$delta>",
        text: Text::new("Shear of a column after flexural yielding by its drift (Elwood); kip, in. and psi.")
            .arguments(&[KDEG, SHEAR_FRES, DEF_TYPE, FOR_TYPE, DELTA])
            .groups(&[&SHEAR, DRIFT]),
        make: shear,
    },
    CurveKind {
        names: &["Axial"],
        usage: "limitCurve Axial $tag $element $Fsw $Kdeg $Fres $defType $forType <$nodeI $nodeJ $dof $perpDirn> \
                <$delta <$eleRemove>>",
        text: Text::new(
            "Axial load of a column by friction along its shear crack (Elwood and Moehle). The element is not removed.",
        )
        .arguments(&[
            AXIAL_FSW,
            KDEG,
            AXIAL_FRES,
            DEF_TYPE,
            FOR_TYPE,
            DELTA,
            Arg::new("eleRemove", "0: the element is not removed at its failure"),
        ])
        .groups(&[DRIFT]),
        make: axial,
    },
    CurveKind {
        names: &["ThreePoint"],
        usage: "limitCurve ThreePoint $tag $element $x1 $y1 $x2 $y2 $x3 $y3 $Kdeg $Fres $defType $forType \
                <$nodeI $nodeJ $dof $perpDirn>",
        text: Text::new("Straight lines between three points.")
            .arguments(&[
                Arg::new("Kdeg", "slope after failure, negative"),
                Arg::new("Fres", "residual force"),
                Arg::new(
                    "defType",
                    "deformation: 1 the larger chord rotation of the element, 2 the drift of two nodes",
                ),
                Arg::new("forType", "force: 0 of the spring, 1 shear of the element, 2 its axial load"),
            ])
            .groups(&[DRIFT, &CURVE_POINTS]),
        make: three_point,
    },
    CurveKind {
        names: &["RotationShearCurve"],
        usage: "limitCurve RotationShearCurve $tag $element $nodeI $nodeJ $rotAxis $Vn $Vr $Kdeg \
                $rotLim | $defType $b $d $h $L $st $As $Acc $ld $db $rhot $fc $fy $fyt $delta",
        text: Text::new("Rotation of a plastic hinge, or a shear force (Leborgne); kip, in. and ksi.").arguments(&[
            NODE_I,
            NODE_J,
            ROT_AXIS,
            VN,
            VR,
            KDEG,
            ROT_LIM,
            Arg::new(
                "defType",
                "rotation at failure: 1 of the hinge, 2 total, 3 flexural, 4 plastic, 5 flexural \
                 plastic",
            ),
            Arg::new("b", "width of the column"),
            Arg::new("d", "effective depth"),
            Arg::new("h", "depth"),
            Arg::new("L", "length of the column"),
            Arg::new("st", "spacing of the hoops"),
            Arg::new("As", "area of the longitudinal bars"),
            Arg::new("Acc", "area of the core"),
            Arg::new("ld", "development length of the longitudinal bars"),
            Arg::new("db", "diameter of the longitudinal bars"),
            RHOT,
            Arg::new("fc", "concrete strength, ksi"),
            Arg::new("fy", "yield stress of the longitudinal bars"),
            Arg::number("fyt", "yield stress of the hoops"),
            ROTATION_DELTA,
        ]),
        make: rotation_shear,
    },
];

fn limit_curve(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of limit curve", "limit curve", CURVES.iter())?;
    interp.host.note_kind("limitCurve", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let element = a.tag(things::ELEMENT, SHEAR_ELEMENT.meaning)?;
    let made = (kind.make)(&mut a, element)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.limit_curves.add(tag, made) {
        return Err(a.exists_at(span, things::LIMIT_CURVE, tag));
    }
    Ok(Value::EMPTY)
}

/// Deformation and force of a curve by their types, with the nodes of a drift.
fn watched(a: &mut Args<'_>) -> Result<(LimitDeformation, LimitForce), Exception> {
    let drift = match a.int(DEF_TYPE.meaning)? {
        1 => false,
        2 => true,
        n => return Err(a.refuse(format!("there is no deformation {n}"), "expected 1 (chord rotation) or 2 (drift)")),
    };
    let force = match a.int(FOR_TYPE.meaning)? {
        0 => LimitForce::Spring,
        1 => LimitForce::Shear,
        2 => LimitForce::Axial,
        n => return Err(a.refuse(format!("there is no force {n}"), "expected 0 (spring), 1 (shear) or 2 (axial)")),
    };
    if !drift {
        return Ok((LimitDeformation::ChordRotation, force));
    }
    let nodes = [a.int(NODE_I.meaning)?, a.int(NODE_J.meaning)?];
    let dof = a.dof("degree of freedom of the drift", 6)?;
    Ok((LimitDeformation::Drift { nodes, dof, along: a.dof("direction of the height perpDirn", 3)? }, force))
}

fn shear(a: &mut Args<'_>, element: i32) -> Result<LimitCurve, Exception> {
    let [rho, fc, b, h, d, hoops] = a.numbers(&SHEAR)?;
    let (slope, residual) = (a.number(&KDEG)?, a.number(&SHEAR_FRES)?);
    if slope == 0.0 {
        return Err(
            a.refuse("the slope after failure Kdeg is 0", "expected it negative, or the stiffness of unloading")
        );
    }
    let (deformation, force) = watched(a)?;
    let shift = a.optional_number(&DELTA)?.unwrap_or(0.0);
    let surface = LimitSurface::Shear { rho, fc, size: [b, h, d], hoops, shift };
    Ok(LimitCurve { element, deformation, force, surface, slope, residual })
}

/// Slope after failure, negative, and residual force.
fn falling(a: &mut Args<'_>) -> Result<(f64, f64), Exception> {
    let slope = a.number(&KDEG)?;
    if slope >= 0.0 {
        return Err(a.refuse(format!("the slope after failure Kdeg is {slope}"), "expected it negative"));
    }
    Ok((slope, a.number(&AXIAL_FRES)?))
}

fn axial(a: &mut Args<'_>, element: i32) -> Result<LimitCurve, Exception> {
    let hoops = a.number(&AXIAL_FSW)?;
    let (slope, residual) = falling(a)?;
    let (deformation, force) = watched(a)?;
    let shift = a.optional_number(&DELTA)?.unwrap_or(0.0);
    if a.left() > 0 && a.int("removal of the element eleRemove")? != 0 {
        return Err(a.refuse("elements are not removed at axial failure", "expected 0"));
    }
    Ok(LimitCurve { element, deformation, force, surface: LimitSurface::Axial { hoops, shift }, slope, residual })
}

fn three_point(a: &mut Args<'_>, element: i32) -> Result<LimitCurve, Exception> {
    let [x1, y1, x2, y2, x3, y3] = a.numbers(&CURVE_POINTS)?;
    let points = [[x1, y1], [x2, y2], [x3, y3]];
    if !points.windows(2).all(|p| p[1][0] > p[0][0]) {
        return Err(a.refuse("the deformations of the points do not rise", "expected x1 < x2 < x3"));
    }
    let (slope, residual) = falling(a)?;
    let (deformation, force) = watched(a)?;
    Ok(LimitCurve { element, deformation, force, surface: LimitSurface::Points(points), slope, residual })
}

/// Words of a curve with the data of its column: those from the deformation type on.
const COLUMN_WORDS: usize = 15;

fn rotation_shear(a: &mut Args<'_>, element: i32) -> Result<LimitCurve, Exception> {
    let nodes = [a.int(NODE_I.meaning)?, a.int(NODE_J.meaning)?];
    let dof = a.dof(ROT_AXIS.meaning, 6)?;
    if dof < 2 {
        return Err(a.refuse("the axis of the rotation is a translation", "expected 3, or 4 to 6 in space"));
    }
    let calibrated = a.left() >= 3 + COLUMN_WORDS;
    let strength = a.number(&VN)?;
    if !(strength > 0.0 || strength == -1.0 || calibrated && strength == 0.0) {
        return Err(a.refuse(format!("the shear strength Vn is {strength}"), "expected it positive, or -1 for none"));
    }
    let residual = a.number(&VR)?;
    if residual < -1.0 {
        return Err(a.refuse(format!("the residual shear Vr is {residual}"), "expected -1 or more"));
    }
    let slope = a.number(&KDEG)?;
    if slope > 0.0 || !calibrated && slope == 0.0 {
        return Err(a.refuse(format!("the slope after failure Kdeg is {slope}"), "expected it negative"));
    }
    let (rotation, column) = if calibrated { (0.0, Some(column(a)?)) } else { (a.number(&ROT_LIM)?, None) };
    let surface = LimitSurface::RotationShear(RotationShear { strength, rotation, column });
    let (deformation, force) = (LimitDeformation::Rotation { nodes, dof }, LimitForce::Spring);
    Ok(LimitCurve { element, deformation, force, surface, slope, residual })
}

fn column(a: &mut Args<'_>) -> Result<Column, Exception> {
    let limit = match a.int("type of the rotation defType")? {
        1 => RotationLimit::Hinge,
        2 => RotationLimit::Total,
        3 => RotationLimit::Flexural,
        4 => RotationLimit::Plastic,
        5 => RotationLimit::FlexuralPlastic,
        n => return Err(a.refuse(format!("there is no rotation {n}"), "expected 1 to 5")),
    };
    let size = |a: &mut Args<'_>, what: &str| match a.float(what)?.abs() {
        0.0 => Err(a.refuse(format!("the {what} is 0"), "expected another number")),
        x => Ok::<f64, Exception>(x),
    };
    Ok(Column {
        limit,
        size: [size(a, "width b")?, size(a, "effective depth d")?, size(a, "depth h")?],
        length: size(a, "length L")?,
        spacing: size(a, "spacing st of the hoops")?,
        steel: size(a, "area As of the longitudinal bars")?,
        core: size(a, "area Acc of the core")?,
        development: size(a, "development length ld")?,
        bar: size(a, "bar diameter db")?,
        hoops: a.number(&RHOT)?.abs(),
        fc: size(a, "concrete strength fc in ksi")?,
        fy: size(a, "yield stress fy")?,
        fyt: size(a, "yield stress fyt of the hoops")?,
        shift: a.number(&ROTATION_DELTA)?,
    })
}

fn limit_state(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    // Two points a side with pinching and damage are 12 numbers, three are 16; beta may follow, then the curve.
    let points = if a.left() <= 13 { 2 } else { 3 };
    let sides = [envelope(a, points, 1.0)?, envelope(a, points, -1.0)?];
    let [pinch_x, pinch_y, damage1, damage2] = a.read_all(interp, &PINCHING_AND_DAMAGE)?;
    let (pinch, damage) = ([pinch_x, pinch_y], [damage1, damage2]);
    let beta = a.read_or(interp, &UNLOADING_EXPONENT, 0.0)?;
    let (mut curve, mut symmetric) = (None, false);
    if a.left() > 0 {
        let (found, _) = a.of(&interp.host.builder.definitions.limit_curves)?;
        curve = match a.int("type of the curve curveType")? {
            0 => None,
            n => Some((found, n == 1)),
        };
        symmetric = a.optional_int("symmetric reloading degrade")?.unwrap_or(0) == 1;
    }
    let compat = interp.host.follows(&[slips::LIMIT_STATE]);
    let odd_energy = compat && points == 3;
    Ok(LimitState { sides, pinch, damage, beta, symmetric, curve, turns_beyond: !compat, odd_energy }.shared())
}
