//! Materials of laminated rubber bearings.

use super::Kind;
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use hysteron_engine::material::{
    AxialParameters, AxialSp, AxialSpHD, COMPOUNDS, Device, ElasticRange, HighDampingRubber, KikuchiAiken, LeadRubber,
    LeadRubberParameters, Material, Uniaxial,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const RK: Arg = Arg::of("-coKQ", "rk", "factor rk of the stiffness").within(Domain::NotNegative);
const RQ: Arg = Arg::of("-coKQ", "rq", "factor rq of the strength").within(Domain::NotNegative);
const CG: Arg = Arg::of("-coGHU", "cg", "factor cg of the shear modulus").within(Domain::NotNegative);
const CH: Arg = Arg::of("-coGHU", "ch", "factor ch of the damping").within(Domain::NotNegative);
const CU: Arg = Arg::of("-coGHU", "cu", "factor cu of u").within(Domain::NotNegative);
const FORCE_FACTOR: Arg = Arg::of("-coMSS", "rf", "factor rf of the force").within(Domain::NotNegative);
const STIFFNESS_FACTOR: Arg = Arg::of("-coMSS", "rs", "factor rs of the stiffness").within(Domain::NotNegative);
const SPRING: [Arg; 3] = [
    Arg::positive("sce", "stiffness sce in compression"),
    Arg::not_negative("fty", "stress fty at cavitation"),
    Arg::number("fcy", "stress fcy at yield in compression"),
];
const KIKUCHI_AIKEN_HDR_TP: Arg = Arg::new("tp", "compound tp");
const LEAD: [Arg; 7] = [
    Arg::positive("ar", "area ar of the rubber"),
    Arg::positive("hr", "total thickness hr of the rubber"),
    Arg::positive("gr", "shear modulus gr of the rubber"),
    Arg::positive("ap", "area ap of the lead plug"),
    Arg::positive("tp", "yield stress tp of the lead"),
    Arg::not_negative("alph", "shear modulus alph of the lead"),
    Arg::number("beta", "ratio beta of the initial stiffness to that after yield"),
];
const TYPE: Arg = Arg::whole("type", "type of bearing");
const T_TEMP: Arg = Arg::of("-T", "temp", "temperature in degrees Celsius").within(Domain::Number);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["AxialSp"],
        usage: "uniaxialMaterial AxialSp $tag $sce $fty $fcy <$bte $bty $bcy $fcr>",
        text: Text::new("Axial spring of an elastomeric bearing.")
            .example("uniaxialMaterial AxialSp 77 1 1 -1")
            .arguments(&[
                Arg::number("bte", "ratio bte of the stiffness in tension"),
                Arg::number("bty", "ratio bty of the stiffness after cavitation"),
                Arg::number("bcy", "ratio bcy of the stiffness after yield in compression"),
                Arg::number("fcr", "stress fcr at which a cavitated spring closes"),
            ])
            .groups(&[&SPRING]),
        make: axial_sp,
    },
    Kind {
        names: &["AxialSpHD"],
        usage: "uniaxialMaterial AxialSpHD $tag $sce $fty $fcy <$bte $bty $bth $bcy $fcr $ath>",
        text: Text::new("Axial spring of an elastomeric bearing, with hardening.")
            .example("uniaxialMaterial AxialSpHD 77 1 1 -1")
            .arguments(&[
                Arg::number("bte", "ratio bte of the stiffness in tension"),
                Arg::number("bty", "ratio bty of the stiffness after cavitation"),
                Arg::number("bth", "ratio bth of the stiffness after hardening in tension"),
                Arg::number("bcy", "ratio bcy of the stiffness after yield in compression"),
                Arg::number("fcr", "stress fcr at which a cavitated spring closes"),
                Arg::number("ath", "displacement ath at which hardening begins, over that at cavitation"),
            ])
            .groups(&[&SPRING]),
        make: axial_sp_hd,
    },
    Kind {
        names: &["KikuchiAikenHDR"],
        usage: "uniaxialMaterial KikuchiAikenHDR $tag $tp $ar $hr <-coGHU $cg $ch $cu> <-coMSS $rs $rf>",
        text: Text::new("Shear spring of a high damping rubber bearing (Kikuchi and Aiken, 1997).")
            .example("uniaxialMaterial KikuchiAikenHDR 77 1 1 1")
            .arguments(&[KIKUCHI_AIKEN_HDR_TP, LEAD[0], LEAD[1], CG, CH, CU, STIFFNESS_FACTOR, FORCE_FACTOR]),
        make: kikuchi_aiken_hdr,
    },
    Kind {
        names: &["KikuchiAikenLRB"],
        usage: "uniaxialMaterial KikuchiAikenLRB $tag $type $ar $hr $gr $ap $tp $alph $beta <-T $temp> <-coKQ $rk $rq> \
                <-coMSS $rs $rf>",
        text: Text::new("Shear spring of a lead rubber bearing (Kikuchi and Aiken, 1997).")
            .example("uniaxialMaterial KikuchiAikenLRB 77 1 1 1 1 1 1 1 2")
            .arguments(&[TYPE, T_TEMP, RK, RQ, STIFFNESS_FACTOR, FORCE_FACTOR])
            .groups(&[&LEAD]),
        make: kikuchi_aiken_lrb,
    },
];

/// A number between limits, or what it is where there is no word left.
fn within(a: &mut Args<'_>, what: &str, otherwise: f64, limits: [f64; 2], range: &str) -> Result<f64, Exception> {
    let x = if a.left() > 0 { a.float(what)? } else { otherwise };
    if (limits[0]..=limits[1]).contains(&x) {
        return Ok(x);
    }
    let expected = match limits {
        [low, f64::INFINITY] => format!("expected at least {low}: {range}"),
        [low, high] => format!("expected a number from {low} to {high}: {range}"),
    };
    Err(a.refuse(format!("{what} is {x}"), expected))
}

const RATIO: &str = "a ratio to the stiffness sce in compression";
const TENSION: &str = "ratio bte of the stiffness in tension";
const CAVITATED: &str = "ratio bty of the stiffness after cavitation";
const HARDENED: &str = "ratio bth of the stiffness after hardening in tension";
const YIELDED: &str = "ratio bcy of the stiffness after yield in compression";

/// sce, fty and fcy, which both springs begin with.
fn stiffness_and_strengths(a: &mut Args<'_>) -> Result<AxialParameters, Exception> {
    let [sce, fty, fcy] = a.numbers(&SPRING)?;
    if fcy > 0.0 {
        return Err(
            a.refuse(format!("fcy is {fcy}"), "expected the stress at yield in compression, not greater than 0")
        );
    }
    Ok(AxialParameters { sce, fty, fcy, bte: 0.0, bty: 0.0, bcy: 0.0, fcr: 0.0, hardening: None })
}

fn closing_stress(a: &mut Args<'_>, fcy: f64) -> Result<f64, Exception> {
    within(a, "stress fcr at which a cavitated spring closes", 0.0, [fcy, 0.0], "fcy to 0")
}

fn axial_sp(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut p = stiffness_and_strengths(a)?;
    p.bte = within(a, TENSION, 0.0, [0.0, 1.0], RATIO)?;
    p.bty = within(a, CAVITATED, 0.0, [0.0, p.bte], "0 to bte")?;
    p.bcy = within(a, YIELDED, 0.0, [0.0, 1.0], RATIO)?;
    p.fcr = closing_stress(a, p.fcy)?;
    Ok(match interp.host.follows(&[slips::AXIAL_SP_JUMP]) {
        true => AxialSp::as_opensees(&p).shared(),
        false => AxialSp::new(&p).shared(),
    })
}

fn axial_sp_hd(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut p = stiffness_and_strengths(a)?;
    p.bte = within(a, TENSION, 1.0, [0.0, 1.0], RATIO)?;
    p.bty = within(a, CAVITATED, 1.0, [0.0, p.bte], "0 to bte")?;
    let bth = within(a, HARDENED, 1.0, [p.bty, p.bte], "bty to bte")?;
    if p.bty < p.bte && (bth == p.bty || bth == p.bte) {
        return Err(a.refuse(
            format!("bth is {bth}"),
            format!(
                "expected a ratio between bty, {}, and bte, {}: the spring hardens, and less than elastic",
                p.bty, p.bte
            ),
        ));
    }
    p.bcy = within(a, YIELDED, 1.0, [0.0, 1.0], RATIO)?;
    p.fcr = closing_stress(a, p.fcy)?;
    let at = "displacement ath at which hardening begins, over that at cavitation";
    let ath = within(a, at, 1.0, [1.0, f64::INFINITY], "a ratio")?;
    p.hardening = (p.bty < p.bte).then_some((bth, ath));
    Ok(match interp.host.follows(&[slips::AXIAL_SP_JUMP]) {
        true => AxialSpHD::as_opensees(&p).shared(),
        false => AxialSpHD::new(&p).shared(),
    })
}

/// A factor, where 0 stands for 1.
fn factor(a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    let x = a.number(arg)?;
    Ok(if x == 0.0 { 1.0 } else { x })
}

/// R_s and R_f of a spring of several side by side.
fn spring_factors(a: &mut Args<'_>) -> Result<[f64; 2], Exception> {
    Ok([factor(a, &STIFFNESS_FACTOR)?, factor(a, &FORCE_FACTOR)?])
}

/// The law of a device, by the rules of the mode.
fn kikuchi_aiken<D: Device>(interp: &Tcl, device: D, springs: [f64; 2]) -> Material
where
    KikuchiAiken<D>: Shared<dyn Uniaxial>,
    KikuchiAiken<D, ElasticRange>: Shared<dyn Uniaxial>,
{
    let slips = [slips::KIKUCHI_AIKEN_TANGENT, slips::KIKUCHI_AIKEN_STEPS, slips::KIKUCHI_AIKEN_FACTORS];
    match interp.host.follows(&slips) {
        true => KikuchiAiken::as_opensees(device, springs).shared(),
        false => KikuchiAiken::new(device, springs).shared(),
    }
}

fn kikuchi_aiken_hdr(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let name = a.word(KIKUCHI_AIKEN_HDR_TP.meaning)?;
    let number = name.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
    let compound = match number {
        Some(i) => COMPOUNDS.get(i),
        None => COMPOUNDS.iter().find(|c| c.name == name),
    };
    let Some(compound) = compound else {
        return Err(a.unknown_name("compound", COMPOUNDS.iter().map(|c| c.name)));
    };
    let [area, height] = a.numbers(&[LEAD[0], LEAD[1]])?;
    let (mut factors, mut springs) = ([1.0; 3], [1.0; 2]);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-coGHU" => {
                for (f, arg) in factors.iter_mut().zip([&CG, &CH, &CU]) {
                    *f = factor(a, arg)?;
                }
            }
            "-coMSS" => springs = spring_factors(a)?,
            _ => return Err(a.unknown_name("option", a.options())),
        }
    }
    let rubber = HighDampingRubber { compound: compound.clone(), area, height, factors };
    Ok(kikuchi_aiken(interp, rubber, springs))
}

fn kikuchi_aiken_lrb(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    match a.int(TYPE.meaning)? {
        1 => {}
        n => return Err(a.refuse(format!("the type of bearing is {n}"), "expected 1: there is no other")),
    }
    let [rubber_area, height, rubber_modulus, lead_area, lead_strength, lead_modulus, stiffness_ratio] =
        a.numbers(&LEAD)?;
    let mut p = LeadRubberParameters {
        rubber_area,
        height,
        rubber_modulus,
        lead_area,
        lead_strength,
        lead_modulus,
        stiffness_ratio,
        temperature: 15.0,
        factors: [1.0; 2],
    };
    if p.stiffness_ratio <= 1.0 {
        let label = "expected a ratio greater than 1: the bearing softens when it yields";
        return Err(a.refuse(format!("beta is {}", p.stiffness_ratio), label));
    }
    let mut springs = [1.0; 2];
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-T" => p.temperature = a.number(&T_TEMP)?,
            "-coKQ" => p.factors = [factor(a, &RK)?, factor(a, &RQ)?],
            "-coMSS" => springs = spring_factors(a)?,
            _ => return Err(a.unknown_name("option", a.options())),
        }
    }
    Ok(kikuchi_aiken(interp, LeadRubber::new(&p), springs))
}
