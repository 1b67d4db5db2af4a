//! Dampers.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::material::{
    BilinearOilDamper, CoulombDamper, IntegrationMethod, Material, Maxwell, Viscous, ViscousDamper,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const ABS_TOL: Arg = Arg::not_negative("absTol", "absolute tolerance absTol");
const SLOW_TOL: Arg =
    Arg::of("-tol", "tol", "rate tol below which the friction is proportional to it").within(Domain::Positive);
const DAMP_OUT_TANGENT: Arg =
    Arg::of("-dampOutTangent", "dampOutTangent", "damping coefficient dampOutTangent").within(Domain::Number);

const FR: Arg = Arg::positive("Fr", "relief force Fr");
const P: Arg = Arg::number("p", "ratio p of the damping coefficients");
const REL_TOL: Arg = Arg::not_negative("relTol", "relative tolerance relTol");

const COEFFICIENT: Arg = Arg::not_negative("C", "damping coefficient C");
const EXPONENT: Arg = Arg::number("alpha", "velocity exponent alpha");
const SMALLEST: Arg = Arg::number("minVel", "smallest velocity minVel");

const USUAL_STIFFNESS: Arg = Arg::usually_positive("K", "stiffness K").also(&["E"]);
const STIFFNESS: Arg = Arg::positive("K", "stiffness K").also(&["E"]);
const DASHPOT: Arg = Arg::positive("C", "damping coefficient C").also(&["eta"]);
const LENGTH: Arg = Arg::positive("L", "length L");
const GAP: Arg = Arg::number("LGap", "length of the gap LGap").also(&["Lgap"]);

const FRICTION: [Arg; 2] = [
    Arg::not_negative("tangent", "stiffness of the spring").also(&["Tangent"]),
    Arg::not_negative("friction", "friction force").also(&["Friction"]),
];

const SUBSTEPS: &[Arg] = &[ABS_TOL, Arg::new("maxHalf", "most halvings of a step")];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Viscous"],
        usage: "uniaxialMaterial Viscous $tag $C $alpha <$minVel>",
        text: Text::new("Dashpot of a power of the velocity.").example("uniaxialMaterial Viscous 77 1 1").arguments(&[
            COEFFICIENT,
            EXPONENT.also(&["Alpha"]),
            SMALLEST,
        ]),
        make: viscous,
    },
    Kind {
        names: &["ViscousDamper"],
        usage: "uniaxialMaterial ViscousDamper $tag $K $C $alpha <$LGap> <$NM $relTol $absTol $maxHalf>",
        text: Text::new("Dashpot of a power of the velocity in series with a spring.")
            .example("uniaxialMaterial ViscousDamper 77 1 1 1")
            .arguments(&[
                USUAL_STIFFNESS,
                DASHPOT,
                EXPONENT,
                GAP,
                Arg::new("NM", "method of integration of OpenSees"),
                REL_TOL,
            ])
            .groups(&[SUBSTEPS]),
        make: viscous_damper,
    },
    Kind {
        names: &["BilinearOilDamper"],
        usage: "uniaxialMaterial BilinearOilDamper $tag $K $C <$Fr $p> <$LGap> <$NM $relTol $absTol $maxHalf>",
        text: Text::new("Oil damper with a relief valve, in series with a spring.")
            .example("uniaxialMaterial BilinearOilDamper 77 200. 5. 30. 0.1")
            .arguments(&[
                STIFFNESS,
                DASHPOT,
                FR,
                P,
                GAP,
                Arg::new("NM", "method of integration: 1 Dormand-Prince, 2 finite differences"),
                REL_TOL,
            ])
            .groups(&[SUBSTEPS]),
        make: bilinear_oil_damper,
    },
    Kind {
        names: &["CoulombDamper"],
        usage: "uniaxialMaterial CoulombDamper $tag $tangent $friction <-tol $tol> <-numFlipped $numFlipped> <-reduceFc> \
                <-dampOutTangent $dampOutTangent>",
        text: Text::new("Spring and Coulomb friction side by side.")
            .example("uniaxialMaterial CoulombDamper 77 1 1")
            .arguments(&[
                FRICTION[0],
                FRICTION[1],
                SLOW_TOL,
                Arg::of(
                    "-numFlipped",
                    "numFlipped",
                    "no effect; in OpenSees the friction depends on the iterations of a step",
                )
                .within(Domain::Whole),
                Arg::flag("-reduceFc", "no effect; in OpenSees the friction depends on the iterations of a step"),
                DAMP_OUT_TANGENT,
            ]),
        make: coulomb_damper,
    },
    Kind {
        names: &["Maxwell", "MaxwellMaterial"],
        usage: "uniaxialMaterial Maxwell $tag $K $C $alpha $L <-returnD>",
        text: Text::new("Spring and linear dashpot in series.")
            .example("uniaxialMaterial Maxwell 77 1 1 1 1")
            .arguments(&[STIFFNESS, DASHPOT, EXPONENT, LENGTH]),
        make: maxwell,
    },
];

fn viscous(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let c = a.read(interp, &COEFFICIENT)?;
    let alpha = a.read(interp, &EXPONENT)?;
    if alpha <= 0.0 {
        let is = if alpha < 0.0 { "is taken for 1" } else { "makes the force the same at every velocity" };
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("Viscous: the velocity exponent alpha is {alpha} and {is}"),
        );
        warn(interp, d.at(a.last_span(), "expected a number greater than 0"))?;
    }
    let min_rate = a.read_or(interp, &SMALLEST, 1e-11)?.abs();
    // As in OpenSees a negative exponent stands for a linear dashpot, and a zero velocity for a very small one.
    let min_rate = if min_rate == 0.0 { 1e-21 } else { min_rate };
    Ok(Viscous { c, alpha: if alpha < 0.0 { 1.0 } else { alpha }, min_rate }.shared())
}

/// A velocity exponent; as in OpenSees a negative one stands for a linear dashpot.
fn exponent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    match a.read(interp, &EXPONENT)? {
        0.0 => Err(a.refuse("the velocity exponent alpha is 0", "expected alpha, greater than 0")),
        alpha => Ok(if alpha < 0.0 { 1.0 } else { alpha }),
    }
}

fn viscous_damper(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let compat = interp.host.follows(&[slips::DAMPER_TANGENT]);
    let k = a.read(interp, &USUAL_STIFFNESS)?;
    let c = a.read(interp, &DASHPOT)?;
    let alpha = exponent(interp, a)?;
    let gap = a.read_or(interp, &GAP, 0.0)?;
    let method = IntegrationMethod::DormandPrince;
    let mut law = ViscousDamper { k, c, alpha, gap, method, relative: 1e-6, absolute: 1e-10, max_halvings: 15, compat };
    if a.left() > 0 {
        law.method = match a.int("number of the method NM")? {
            1 => IntegrationMethod::DormandPrince,
            2 => IntegrationMethod::AdamsBashforthMoulton,
            3 => IntegrationMethod::Rosenbrock,
            n => {
                let label = "expected 1 (Dormand-Prince), 2 (Adams-Bashforth-Moulton) or 3 (Rosenbrock)";
                return Err(a.refuse(format!("there is no method {n}"), label));
            }
        };
        ([law.relative, law.absolute], law.max_halvings) = tolerances(a)?;
    }
    Ok(law.shared())
}

/// Relative and absolute tolerance of the integration, and the largest number of halvings.
fn tolerances(a: &mut Args<'_>) -> Result<([f64; 2], i32), Exception> {
    let tolerances = a.numbers(&[REL_TOL, ABS_TOL])?;
    let max_halvings = a.int("largest number of halvings maxHalf")?;
    if !(0..=20).contains(&max_halvings) {
        return Err(a.refuse(format!("maxHalf is {max_halvings}"), "expected maxHalf, 0 to 20"));
    }
    Ok((tolerances, max_halvings))
}

fn bilinear_oil_damper(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let compat = interp.host.follows(&[slips::DAMPER_TANGENT]);
    let (k, c) = (a.read(interp, &STIFFNESS)?, a.read(interp, &DASHPOT)?);
    let mut law = BilinearOilDamper {
        k,
        c,
        relief: 1.0,
        ratio: 1.0,
        gap: 0.0,
        differences: false,
        relative: 1e-6,
        absolute: 1e-10,
        max_halvings: 15,
        compat,
    };
    if a.left() > 0 {
        law.relief = a.number(&FR)?;
        law.ratio = a.number(&P)?.max(0.0);
    }
    law.gap = a.read_or(interp, &GAP, 0.0)?;
    if a.left() > 0 {
        law.differences = match a.int("number of the method NM")? {
            1 => false,
            2 => true,
            n => {
                let label = "expected 1 (Dormand-Prince) or 2 (finite differences)";
                return Err(a.refuse(format!("there is no method {n}"), label));
            }
        };
        ([law.relative, law.absolute], law.max_halvings) = tolerances(a)?;
    }
    Ok(law.shared())
}

fn maxwell(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let compat = interp.host.follows(&[slips::DAMPER_TANGENT]);
    let (k, c) = (a.read(interp, &STIFFNESS)?, a.read(interp, &DASHPOT)?);
    let alpha = exponent(interp, a)?;
    let length = a.read(interp, &LENGTH)?;
    let secant_damping = a.flag("-returnD") || a.flag("-D");
    Ok(Maxwell { k, c, alpha, length, secant_damping, compat }.shared())
}

/// Rate below which the friction of a Coulomb damper is proportional to it.
const SLOW_RATE: f64 = 1e-6;

fn coulomb_damper(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [k, friction] = a.read_all(interp, &FRICTION)?;
    let mut slow = SLOW_RATE;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-tol" => slow = a.number(&SLOW_TOL)?,
            // These change the force by the number of iterations.
            "-numFlipped" => {
                a.int("number of changes of sign numFlipped")?;
            }
            "-dampOutTangent" => {
                a.number(&DAMP_OUT_TANGENT)?;
            }
            "-reduceFc" => {}
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(CoulombDamper { k, friction, slow }.shared())
}
