//! `hystereticBackbone`, and the material along one.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::material::{Backbone, BackboneElastic, Material, SoilCurve};
use hysteron_engine::shared::Shared;
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const FACTOR: Arg = Arg::number("factor", "factor of the stress");
const CAP: [Arg; 3] = [
    Arg::number("eCap", "strain of the cap eCap"),
    Arg::number("E", "slope behind the cap E"),
    Arg::number("sRes", "residual stress sRes"),
];

const TAG: Arg = Arg::whole("tag", "tag of the backbone");
const ARCTANGENT: [Arg; 3] = [
    Arg::number("K1", "coefficient K1"),
    Arg::positive("gammaY", "strain at yielding gammaY"),
    Arg::number("alpha", "angle alpha"),
];
const STRENGTH: [Arg; 2] = [Arg::positive("E", "modulus E"), Arg::positive("Fy", "strength Fy")];
const RAYNOR: [Arg; 3] = [
    Arg::positive("Es", "elastic modulus Es"),
    Arg::positive("fy", "yield stress fy"),
    Arg::positive("fsu", "ultimate stress fsu"),
];
const EPSSH: Arg = Arg::positive("epssh", "strain at hardening epssh");
const EPSSM: Arg = Arg::positive("epssm", "strain at the ultimate stress epssm");
const RAYNOR_C1: Arg = Arg::not_negative("C1", "exponent of hardening C1");
const EY: Arg = Arg::number("Ey", "modulus of the plateau Ey");
const SAND: [Arg; 5] = [
    Arg::positive("kx", "initial stiffness kx"),
    Arg::positive("ym", "displacement ym"),
    Arg::positive("pm", "resistance pm"),
    Arg::positive("yu", "displacement yu"),
    Arg::positive("pu", "resistance pu"),
];
const SOFT_CLAY: [Arg; 2] = [Arg::positive("pu", "ultimate resistance pu"), Arg::positive("y50", "displacement y50")];
const N: Arg = Arg::positive("n", "exponent n");
const ESI: Arg = Arg::positive("Esi", "initial stiffness Esi");
const STIFF_CLAY: [Arg; 2] = [Arg::positive("As", "coefficient As"), Arg::positive("Pc", "ultimate resistance Pc")];
const HL: Arg = Arg::number("hl", "length of the linear part hl");
const SU: Arg = Arg::positive("su", "shear strength su");
const DIAMETER: Arg = Arg::positive("b", "diameter b");
const CEMENTED: [Arg; 5] = [
    Arg::positive("pM", "resistance pM at b/60"),
    Arg::positive("pU", "resistance pU at 3b/80"),
    Arg::positive("Kpy", "stiffness per depth Kpy"),
    Arg::positive("z", "depth z"),
    DIAMETER,
];
const WEAK_ROCK: [Arg; 3] = [
    Arg::positive("Kir", "initial stiffness Kir"),
    Arg::positive("pur", "ultimate resistance pur"),
    Arg::positive("yrm", "displacement yrm"),
];

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["Backbone"],
    usage: "uniaxialMaterial Backbone $tag $backbone <$factor>",
    text: Text::new("Elastic along a curve of `hystereticBackbone`.")
        .example("hystereticBackbone Bilinear 1 0.01 1. 0.1 1.5; uniaxialMaterial Backbone 77 1")
        .arguments(&[Arg::thing("backbone", things::BACKBONE), FACTOR]),
    make: backbone_material,
}];

pub(crate) const COMMANDS: &[Command] = &[Command::new("hystereticBackbone", USAGE, hysteretic_backbone)
    .arguments(&[
        TAG,
        Arg::number("e1", "strain e1"),
        Arg::number("s1", "stress s1"),
        Arg::number("e2", "strain e2"),
        Arg::number("s2", "stress s2"),
    ])
    .about("Makes a curve of stress over strain, for `uniaxialMaterial Backbone`.")
    .defining(&[things::BACKBONE], 2)
    .with_kinds(|| kind::usages(BACKBONES))];

const USAGE: &str = "hystereticBackbone $kind $tag ...";

/// A kind of backbone, made from the words after its tag.
type BackboneKind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<Backbone, Exception>>;

const BACKBONES: &[BackboneKind] = &[
    BackboneKind {
        names: &["Bilinear"],
        usage: "hystereticBackbone Bilinear $tag $e1 $s1 $e2 $s2",
        text: Text::new("Two straight lines."),
        make: |_, a| points(a, 2),
    },
    BackboneKind {
        names: &["Trilinear"],
        usage: "hystereticBackbone Trilinear $tag $e1 $s1 $e2 $s2 $e3 $s3",
        text: Text::new("Three straight lines.")
            .arguments(&[Arg::number("e3", "strain e3"), Arg::number("s3", "stress s3")]),
        make: |_, a| points(a, 3),
    },
    BackboneKind {
        names: &["Multilinear"],
        usage: "hystereticBackbone Multilinear $tag $e1 $s1 $e2 $s2 ...",
        text: Text::new("Straight lines through points, from the origin."),
        make: |_, a| points(a, a.left() / 2),
    },
    BackboneKind {
        names: &["Arctangent"],
        usage: "hystereticBackbone Arctangent $tag $K1 $gammaY $alpha or $E $Fy",
        text: Text::new("An arctangent of the strain.").groups(&[&ARCTANGENT, &STRENGTH]),
        make: arctangent,
    },
    BackboneKind {
        names: &["Mander"],
        usage: "hystereticBackbone Mander $tag $fc $epsc $E",
        text: Text::new("Concrete under compression, with positive strains.").arguments(&[
            Arg::number("fc", "strength fc"),
            Arg::number("epsc", "strain at the strength epsc"),
            Arg::number("E", "initial modulus E"),
        ]),
        make: mander,
    },
    BackboneKind {
        names: &["Raynor"],
        usage: "hystereticBackbone Raynor $tag $Es $fy $fsu $epssh $epssm $C1 $Ey",
        text: Text::new("Reinforcing steel with a plateau and hardening.")
            .groups(&[&RAYNOR, &[EPSSH, EPSSM, RAYNOR_C1, EY]]),
        make: raynor,
    },
    BackboneKind {
        names: &["ReeseSand"],
        usage: "hystereticBackbone ReeseSand $tag $kx $ym $pm $yu $pu",
        text: Text::new("Lateral resistance of sand around a pile.").groups(&[&SAND]),
        make: reese_sand,
    },
    BackboneKind {
        names: &["ReeseSoftClay"],
        usage: "hystereticBackbone ReeseSoftClay $tag $pu $y50 $n",
        text: Text::new("Lateral resistance of soft clay around a pile.").groups(&[&SOFT_CLAY, &[N]]),
        make: reese_soft_clay,
    },
    BackboneKind {
        names: &["ReeseStiffClayBelowWS"],
        usage: "hystereticBackbone ReeseStiffClayBelowWS $tag $Esi $y50 $As $Pc",
        text: Text::new("Lateral resistance of stiff clay below the water surface.")
            .groups(&[&[ESI, SOFT_CLAY[1]], &STIFF_CLAY]),
        make: reese_stiff_clay_below,
    },
    BackboneKind {
        names: &["ReeseStiffClayAboveWS"],
        usage: "hystereticBackbone ReeseStiffClayAboveWS $tag $pu $y50 <$hl>",
        text: Text::new("Lateral resistance of stiff clay above the water surface.").groups(&[&SOFT_CLAY, &[HL]]),
        make: reese_stiff_clay_above,
    },
    BackboneKind {
        names: &["VuggyLimestone"],
        usage: "hystereticBackbone VuggyLimestone $tag $b $su",
        text: Text::new("Lateral resistance of vuggy limestone around a pile.").arguments(&[DIAMETER, SU]),
        make: vuggy_limestone,
    },
    BackboneKind {
        names: &["CementedSoil"],
        usage: "hystereticBackbone CementedSoil $tag $pM $pU $Kpy $z $b",
        text: Text::new("Lateral resistance of cemented soil around a pile.").groups(&[&CEMENTED]),
        make: cemented_soil,
    },
    BackboneKind {
        names: &["WeakRock"],
        usage: "hystereticBackbone WeakRock $tag $Kir $pur $yrm",
        text: Text::new("Lateral resistance of weak rock around a pile.").groups(&[&WEAK_ROCK]),
        make: weak_rock,
    },
    BackboneKind {
        names: &["Material"],
        usage: "hystereticBackbone Material $tag $material <-compression>",
        text: Text::new("The virgin curve of a uniaxial material.").arguments(&[
            Arg::thing("material", things::MATERIAL),
            Arg::flag("-compression", "the curve of compression, with positive strains"),
        ]),
        make: of_material,
    },
    BackboneKind {
        names: &["LinearCapped"],
        usage: "hystereticBackbone LinearCapped $tag $backbone $eCap $E $sRes",
        text: Text::new("Another curve up to a strain, then a line to a residual stress.")
            .arguments(&[Arg::thing("backbone", things::BACKBONE)])
            .groups(&[&CAP]),
        make: linear_capped,
    },
];

fn hysteretic_backbone(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of backbone", "backbone", BACKBONES.iter())?;
    interp.host.note_kind("hystereticBackbone", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let made = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.backbones.add(tag, Arc::new(made)) {
        return Err(a.exists_at(span, things::BACKBONE, tag));
    }
    Ok(Value::EMPTY)
}

fn backbone_material(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (backbone, _) = a.of(&interp.host.builder.definitions.backbones)?;
    let factor = a.optional_number(&FACTOR)?.unwrap_or(1.0);
    Ok(BackboneElastic { backbone, factor }.shared())
}

fn points(a: &mut Args<'_>, n: usize) -> Result<Backbone, Exception> {
    let (mut all, mut before) = (vec![], 0.0);
    for i in 1..=n.max(2) {
        let strain = a.float(&format!("strain e{i}"))?;
        if strain <= before {
            return Err(a.refuse(format!("the strain e{i} is {strain}"), format!("expected more than {before}")));
        }
        all.push((strain, a.float(&format!("stress s{i}"))?));
        before = strain;
    }
    Ok(Backbone::Multilinear(all))
}

/// Strain at yielding where only modulus and strength are given: the angle whose tangent the strain is multiplied by.
const DEFAULT_ANGLE: f64 = 0.8;

fn arctangent(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    if a.ahead().take_while(|v| v.as_f64().is_some()).count() == 2 {
        let [e, fy] = a.numbers(&STRENGTH)?;
        let k2 = DEFAULT_ANGLE.tan() / (fy / e);
        return Ok(Backbone::Arctangent { k1: e / k2, k2 });
    }
    let [k1, gamma, alpha] = a.numbers(&ARCTANGENT)?;
    Ok(Backbone::Arctangent { k1, k2: alpha.abs().tan() / gamma })
}

/// A number of any sign, taken as positive.
fn size(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match a.float(what)?.abs() {
        0.0 => Err(a.refuse(format!("the {what} is 0"), "expected another number")),
        value => Ok(value),
    }
}

fn mander(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let (fc, epsc) = (size(a, "strength fc")?, size(a, "strain at the strength epsc")?);
    let e = size(a, "initial modulus E")?;
    if e <= fc / epsc {
        let label = format!("expected more than fc / epsc, {}", fc / epsc);
        return Err(a.refuse(format!("the initial modulus E is {e}"), label));
    }
    Ok(Backbone::Mander { fc, epsc, e })
}

fn raynor(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [es, fy, fsu] = a.numbers(&RAYNOR)?;
    let hard = a.number(&EPSSH)?;
    if hard < fy / es {
        return Err(a.refuse(format!("the strain at hardening epssh is {hard}"), "expected fy / Es at least"));
    }
    let ultimate = a.number(&EPSSM)?;
    if ultimate <= hard {
        let message = format!("the strain at the ultimate stress epssm is {ultimate}");
        return Err(a.refuse(message, format!("expected more than epssh, {hard}")));
    }
    let c1 = a.number(&RAYNOR_C1)?;
    Ok(Backbone::Raynor { es, fy, fsu, strain: [hard, ultimate], c1, ey: a.number(&EY)? })
}

fn reese_sand(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [kx, ym, pm, yu, pu] = a.numbers(&SAND)?;
    if yu <= ym || pu <= pm {
        return Err(
            a.refuse(format!("the end of the curve is {pu} at {yu}"), format!("expected more than {pm} at {ym}"))
        );
    }
    Ok(Backbone::Soil(SoilCurve::Sand { kx, points: [(ym, pm), (yu, pu)] }))
}

fn reese_soft_clay(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [pu, y50] = a.numbers(&SOFT_CLAY)?;
    Ok(Backbone::Soil(SoilCurve::SoftClay { pu, y50, n: a.number(&N)? }))
}

fn reese_stiff_clay_below(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [esi, y50] = a.numbers(&[ESI, SOFT_CLAY[1]])?;
    let [coefficient, pc] = a.numbers(&STIFF_CLAY)?;
    Ok(Backbone::Soil(SoilCurve::StiffClayBelowWater { esi, y50, a: coefficient, pc }))
}

fn reese_stiff_clay_above(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [pu, y50] = a.numbers(&SOFT_CLAY)?;
    let linear = a.optional_number(&HL)?.unwrap_or(0.1);
    if !(linear > 0.0 && linear <= 1.0) {
        return Err(a.refuse(format!("the length of the linear part hl is {linear}"), "expected more than 0, up to 1"));
    }
    Ok(Backbone::Soil(SoilCurve::StiffClayAboveWater { pu, y50, linear }))
}

fn vuggy_limestone(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let (diameter, strength) = (a.number(&DIAMETER)?, a.number(&SU)?);
    Ok(Backbone::Soil(SoilCurve::VuggyLimestone { diameter, strength }))
}

fn cemented_soil(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [pm, pu, kpy, z, diameter] = a.numbers(&CEMENTED)?;
    Ok(Backbone::Soil(SoilCurve::CementedSoil { resistance: [pm, pu], stiffness: kpy * z, diameter }))
}

fn weak_rock(_: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let [kir, pur, yrm] = a.numbers(&WEAK_ROCK)?;
    Ok(Backbone::Soil(SoilCurve::WeakRock { kir, pur, yrm }))
}

fn of_material(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let (material, _) = a.of(&interp.host.builder.definitions.materials)?;
    let compression = a.flag("-compression") || a.flag("compression");
    Ok(Backbone::Material(material, if compression { -1.0 } else { 1.0 }))
}

fn linear_capped(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Backbone, Exception> {
    let (inner, _) = a.of(&interp.host.builder.definitions.backbones)?;
    let [cap, slope, residual] = a.numbers(&CAP)?;
    inner.at(cap).map_err(|e| a.refuse(e.to_string(), "expected a backbone with a stress at the cap"))?;
    Ok(Backbone::LinearCapped { inner, cap, slope, residual })
}
