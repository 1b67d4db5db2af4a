//! Steels with curved or sharp transitions.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{BrbBranch, Cast, Material, Steel01, Steel02, Steel03, SteelBrb, SteelMpf};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const FINGERS: [Arg; 6] = [
    Arg::positive("n", "number of fingers n"),
    Arg::positive("bo", "width of a finger bo"),
    Arg::positive("h", "thickness of a finger h"),
    Arg::positive("fy", "yield stress fy"),
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("L", "length of a finger L"),
];
const CAST_FUSE_B: Arg = Arg::number("b", "hardening ratio b");
const FUSE_TRANSITION: [Arg; 3] = [
    Arg::positive("R0", "radius R0"),
    Arg::not_negative("cR1", "coefficient cR1"),
    Arg::positive("cR2", "coefficient cR2"),
];
const FUSE_ISOTROPIC: [Arg; 4] = [
    Arg::not_negative("a1", "isotropic hardening a1"),
    Arg::positive("a2", "isotropic hardening a2"),
    Arg::not_negative("a3", "isotropic hardening a3"),
    Arg::positive("a4", "isotropic hardening a4"),
];

/// Yield strength and modulus of steels for which OpenSees takes any number.
const USUAL: [Arg; 2] = [
    Arg::usually_positive("Fy", "yield strength Fy").also(&["sigmaY", "fy"]),
    Arg::usually_positive("E0", "elastic modulus E0").also(&["E"]),
];
pub(super) const B: Arg = Arg::number("b", "hardening ratio b");
const ISOTROPIC: [Arg; 4] = [
    Arg::number("a1", "isotropic hardening parameter a1"),
    Arg::number("a2", "isotropic hardening parameter a2"),
    Arg::number("a3", "isotropic hardening parameter a3"),
    Arg::number("a4", "isotropic hardening parameter a4"),
];

const R0: Arg = Arg::usually_positive("R0", "sharpness of the transition R0");
const C_R1: Arg = Arg::number("cR1", "cR1");
const C_R2: Arg = Arg::usually_positive("cR2", "cR2");
const SIG_INIT: Arg = Arg::number("sigInit", "initial stress sigInit").also(&["sig0"]);

const STEEL03: [Arg; 2] = [
    Arg::positive("fy", "yield stress fy").also(&["sigmaY", "Fy"]),
    Arg::positive("E0", "elastic modulus E0").also(&["E"]),
];
const STEEL03_TRANSITION: [Arg; 3] = [
    Arg::positive("r", "radius of the transition r"),
    Arg::not_negative("cR1", "coefficient cR1"),
    Arg::not_negative("cR2", "coefficient cR2"),
];

const BRB: [Arg; 2] =
    [Arg::positive("E", "elastic modulus E"), Arg::positive("sigmaY0", "initial yield stress sigmaY0")];
const BRB_TENSION: [Arg; 4] = [
    Arg::positive("sigmaYT", "hardened yield stress sigmaYT").also(&["sigmaY_T"]),
    Arg::positive("alphaT", "exponent alphaT of the transition").also(&["alpha_T"]),
    Arg::not_negative("betaT", "kinematic hardening betaT").also(&["beta_T"]),
    Arg::positive("deltaT", "plastic strain deltaT of isotropic hardening").also(&["delta_T"]),
];
const BRB_COMPRESSION: [Arg; 4] = [
    Arg::positive("sigmaYC", "hardened yield stress sigmaYC").also(&["sigmaY_C"]),
    Arg::positive("alphaC", "exponent alphaC of the transition").also(&["alpha_C"]),
    Arg::not_negative("betaC", "kinematic hardening betaC").also(&["beta_C"]),
    Arg::positive("deltaC", "plastic strain deltaC of isotropic hardening").also(&["delta_C"]),
];
const TOLERANCE: Arg = Arg::number("tol", "tolerance");

const MPF: [Arg; 3] = [
    Arg::positive("fyp", "yield strength in tension fyp"),
    Arg::positive("fyn", "yield strength in compression fyn"),
    Arg::positive("E0", "elastic modulus E0"),
];
const MPF_RATIOS: [Arg; 2] =
    [Arg::number("bp", "hardening ratio in tension bp"), Arg::number("bn", "hardening ratio in compression bn")];
const MPF_CURVE: [Arg; 3] = [
    Arg::positive("R0", "exponent of the first loading R0"),
    Arg::number("cR1", "loss of the exponent cR1"),
    Arg::positive("cR2", "plastic strain of half the loss cR2"),
];
const MPF_ISOTROPIC: [Arg; 4] = [
    Arg::number("a1", "isotropic hardening a1"),
    Arg::number("a2", "isotropic hardening a2"),
    Arg::number("a3", "isotropic hardening a3"),
    Arg::number("a4", "isotropic hardening a4"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["CastFuse", "Cast"],
        usage: "uniaxialMaterial CastFuse $tag $n $bo $h $fy $E $L $b $R0 $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Yielding fingers of a cast steel brace, which pull at large deformations.")
            .example("uniaxialMaterial CastFuse 77 8 5. 1.5 50. 29000. 12. 0.05 20. 0.92 0.15")
            .groups(&[&FINGERS, &[CAST_FUSE_B], &FUSE_TRANSITION, &FUSE_ISOTROPIC]),
        make: cast_fuse,
    },
    Kind {
        names: &["Steel01"],
        usage: "uniaxialMaterial Steel01 $tag $Fy $E0 $b <$a1 $a2 $a3 $a4>",
        text: Text::new("Bilinear steel with kinematic and optional isotropic hardening.")
            .example("uniaxialMaterial Steel01 77 1 1 1")
            .groups(&[&USUAL, &[B], &ISOTROPIC]),
        make: steel01,
    },
    Kind {
        names: &["Steel02"],
        usage: "uniaxialMaterial Steel02 $tag $Fy $E0 $b <$R0 $cR1 $cR2 <$a1 $a2 $a3 $a4 <$sigInit>>>",
        text: Text::new("Steel of Giuffré, Menegotto and Pinto with curved transitions.")
            .example("uniaxialMaterial Steel02 77 1 1 1")
            .groups(&[&USUAL, &[B, R0, C_R1, C_R2], &ISOTROPIC, &[SIG_INIT]]),
        make: steel02,
    },
    Kind {
        names: &["Steel03"],
        usage: "uniaxialMaterial Steel03 $tag $fy $E0 $b $r $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Steel with a curved transition to hardening and isotropic hardening as of `Steel01`.")
            .example("uniaxialMaterial Steel03 77 1 1 2 1 1 1")
            .groups(&[&STEEL03, &[B], &STEEL03_TRANSITION, &ISOTROPIC]),
        make: steel03,
    },
    Kind {
        names: &["SteelBRB"],
        usage: "uniaxialMaterial SteelBRB $tag $E $sigmaY0 $sigmaYT $alphaT $betaT $deltaT $sigmaYC $alphaC $betaC $deltaC \
                <$tol>",
        text: Text::new("Steel core of a buckling-restrained brace.")
            .example("uniaxialMaterial SteelBRB 77 1 1 1 1 1 1 1 1 1 1")
            .groups(&[&BRB, &BRB_TENSION, &BRB_COMPRESSION, &[TOLERANCE]]),
        make: steel_brb,
    },
    Kind {
        names: &["SteelMPF"],
        usage: "uniaxialMaterial SteelMPF $tag $fyp $fyn $E0 $bp $bn $R0 $cR1 $cR2 <$a1 $a2 $a3 $a4>",
        text: Text::new("Steel of Menegotto and Pinto with its own yield strength and hardening on either side.")
            .example("uniaxialMaterial SteelMPF 77 1 1 1 0.5 0.5 1 1 1")
            .groups(&[&MPF, &MPF_RATIOS, &MPF_CURVE, &MPF_ISOTROPIC]),
        make: steel_mpf,
    },
];

/// The hardening ratio of a steel, with a warning where it is none: numbers in another order, or percent.
pub(super) fn hardening_ratio(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let b = a.read(interp, &B)?;
    if !(0.0..=1.0).contains(&b) {
        let d = Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, format!("the hardening ratio b is {b}"));
        let d = d.at(a.last_span(), "expected the stiffness after yielding over that before, 0 to 1");
        let what = if b < 0.0 { "softens after yielding" } else { "is stiffer after yielding than before" };
        warn(interp, d.help(format!("such a steel {what}")))?;
    }
    Ok(b)
}

fn steel01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, e0] = a.read_all(interp, &USUAL)?;
    let b = hardening_ratio(interp, a)?;
    let isotropic = isotropic(interp, a, Steel01::NO_ISOTROPIC)?;
    Ok(Steel01 { fy, e0, b, a: isotropic }.shared())
}

/// R0, cR1 and cR2 of Steel02: all or none.
fn transition(interp: &mut Tcl, a: &mut Args<'_>) -> Result<[f64; 3], Exception> {
    if a.left() == 0 {
        return Ok(a.left_out(Steel02::TRANSITION));
    }
    let (r0, c_r1) = (a.read(interp, &R0)?, a.read(interp, &C_R1)?);
    if c_r1 > 1.0 {
        let label = "the sharpness of the transition would come to be negative: expected at most 1";
        return Err(a.refuse(format!("cR1 is {c_r1}"), label));
    }
    Ok([r0, c_r1, a.read(interp, &C_R2)?])
}

/// a1 to a4: all or none.
fn isotropic(interp: &mut Tcl, a: &mut Args<'_>, none: [f64; 4]) -> Result<[f64; 4], Exception> {
    a.read_all_or(interp, &ISOTROPIC, none)
}

fn steel03(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, e0] = a.read_all(interp, &STEEL03)?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        return Err(a.refuse("the hardening ratio is 1", "the asymptotes never meet: use the material Elastic"));
    }
    let [r, c_r1, c_r2] = a.read_all(interp, &STEEL03_TRANSITION)?;
    let c_r = [c_r1, c_r2];
    if c_r[0] >= Steel03::TRILINEAR && c_r[1] == 0.0 {
        return Err(a.refuse("the coefficient cR2 is 0", "expected more than 0, or cR1 less than 0.1"));
    }
    let isotropic = isotropic(interp, a, Steel03::NO_ISOTROPIC)?;
    for scale in [isotropic[1], isotropic[3]] {
        if scale <= 0.0 {
            let label = "expected a2 and a4 greater than 0";
            return Err(a.refuse(format!("isotropic hardening starts at {scale} yield strains"), label));
        }
    }
    Ok(Steel03 { fy, e0, b, r, c_r, a: isotropic }.shared())
}

fn steel02(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fy, e0] = a.read_all(interp, &USUAL)?;
    let b = hardening_ratio(interp, a)?;
    if b == 1.0 {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            "the hardening ratio is 1: the steel never yields",
        );
        warn(interp, d.at(a.last_span(), "expected less than 1, or the material Elastic"))?;
    }
    let [r0, c_r1, c_r2] = transition(interp, a)?;
    let isotropic = isotropic(interp, a, Steel02::NO_ISOTROPIC)?;
    for [growth, scale] in [[isotropic[0], isotropic[1]], [isotropic[2], isotropic[3]]] {
        if growth != 0.0 && scale <= 0.0 {
            let label = "expected a2 and a4 greater than 0";
            return Err(a.refuse(format!("isotropic hardening starts at {scale} yield strains"), label));
        }
    }
    let sig_init = a.read_or(interp, &SIG_INIT, 0.0)?;
    Ok(Steel02 { fy, e0, b, r0, c_r: [c_r1, c_r2], a: isotropic, sig_init }.shared())
}

fn steel_brb(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, yield_stress] = a.read_all(interp, &BRB)?;
    let mut branch = |args: &[Arg; 4]| {
        let [yield_stress, alpha, beta, delta] = a.read_all(interp, args)?;
        Ok::<_, Exception>(BrbBranch { yield_stress, alpha, beta, delta })
    };
    let (tension, compression) = (branch(&BRB_TENSION)?, branch(&BRB_COMPRESSION)?);
    // Found to round-off here.
    a.read_optional(interp, &TOLERANCE)?;
    let compat = interp.host.follows(&[slips::STEEL_BRB_FIRST]);
    Ok(SteelBrb { e, yield_stress, tension, compression, compat }.shared())
}

fn steel_mpf(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fyp, fyn, e] = a.read_all(interp, &MPF)?;
    let mut b = [0.0; 2];
    for (b, arg) in b.iter_mut().zip(&MPF_RATIOS) {
        *b = a.read(interp, arg)?;
        if *b >= 1.0 {
            return Err(a.refuse(format!("the hardening ratio is {b}"), "expected less than 1"));
        }
    }
    let [r0, cr1, cr2] = a.read_all(interp, &MPF_CURVE)?;
    let mut shift = [(0.0, 1.0); 2];
    if a.left() > 0 {
        let [a1, a2, a3, a4] = a.read_all(interp, &MPF_ISOTROPIC)?;
        // The first two numbers are those of compression.
        shift = [(a3, a4), (a1, a2)];
    }
    let least_strain = if interp.host.follows(&[slips::STEEL_MPF_START]) { 0.0 } else { SteelMpf::LEAST_STRAIN };
    Ok(SteelMpf { fy: [fyp, fyn], e, b, r0, cr1, cr2, shift, least_strain }.shared())
}

fn cast_fuse(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [legs, width, thickness, fy, e, length] = a.numbers(&FINGERS)?;
    let b = a.number(&CAST_FUSE_B)?;
    if b >= 1.0 {
        return Err(a.refuse(format!("the hardening ratio b is {b}"), "expected less than 1"));
    }
    let r = a.numbers(&FUSE_TRANSITION)?;
    let hardening = if a.left() > 0 { a.numbers(&FUSE_ISOTROPIC)? } else { [0.0, 1.0, 0.0, 1.0] };
    Ok(Cast { legs, width, thickness, length, fy, e, b, r, a: hardening }.shared())
}
