//! Elastic materials.

use super::Kind;
use super::by_rules::by_rules;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    Cable, Elastic, ElasticBilin, ElasticMultiLinear, ElasticPP, ElasticPPGap, ElasticPower, HookGap, Material,
    NoTension,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const E: Arg = Arg::number("E", "elastic modulus E");
const ETA: Arg = Arg::number("eta", "damping modulus eta");
const E_NEG: Arg = Arg::number("Eneg", "modulus in compression Eneg");

const USUAL_E: Arg = Arg::usually_positive("E", "elastic modulus E");
const EPSY_P: Arg = Arg::number("epsyP", "yield strain in tension epsyP");
const EPSY_N: Arg = Arg::number("epsyN", "yield strain in compression epsyN");
const EPS_0: Arg = Arg::number("eps0", "initial strain eps0");

const STIFFNESS: Arg = Arg::not_negative("E", "elastic modulus E");
const FY: Arg = Arg::number("Fy", "yield stress Fy");
const CLOSING: Arg = Arg::number("gap", "strain at which the gap closes");
const HARDENING: Arg = Arg::number("eta", "hardening ratio eta");

const GAP: Arg = Arg::number("gap", "gap");
const GAP_P: Arg = Arg::number("gapP", "gap in tension");

const TENSION: Arg = Arg::number("a", "part of the modulus that acts in tension, a");
const FACTOR: Arg = Arg::number("b", "factor of the strain in tension, b");

const BILINEAR: [Arg; 3] = [
    Arg::number("EP1", "first modulus EP1").also(&["E1p", "E1"]),
    Arg::number("EP2", "second modulus EP2").also(&["E2p", "E2"]),
    Arg::number("epsP2", "strain epsP2").also(&["eps2p", "eps2"]),
];
const BILINEAR_N: [Arg; 3] = [
    Arg::number("EN1", "first modulus in compression EN1").also(&["E1n", "E1"]),
    Arg::number("EN2", "second modulus in compression EN2").also(&["E2n", "E2"]),
    Arg::number("epsN2", "strain in compression epsN2").also(&["eps2n", "-eps2"]),
];

const CABLE: [Arg; 4] = [
    Arg::positive("prestress", "prestress"),
    Arg::positive("E", "elastic modulus E"),
    Arg::not_negative("weight", "weight per volume"),
    Arg::not_negative("length", "length of the cable"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Cable", "CableMaterial"],
        usage: "uniaxialMaterial Cable $tag $prestress $E $weight $length",
        text: Text::new("Elastic cable that sags under its weight.")
            .example("uniaxialMaterial Cable 77 200. 2e5 0.08 5000.")
            .groups(&[&CABLE]),
        make: cable,
    },
    Kind {
        names: &["Elastic"],
        usage: "uniaxialMaterial Elastic $tag $E <$eta> <$Eneg>",
        text: Text::new("Linear elastic, with an optional viscous part.")
            .example("uniaxialMaterial Elastic 77 1")
            .arguments(&[E.also(&["Epos"]), ETA, E_NEG.also(&["E"])]),
        make: elastic,
    },
    Kind {
        names: &["ElasticPP"],
        usage: "uniaxialMaterial ElasticPP $tag $E $epsyP <$epsyN> <$eps0>",
        text: Text::new("Elastic, perfectly plastic.")
            .example("uniaxialMaterial ElasticPP 77 1 1")
            .arguments(&[USUAL_E, EPSY_P, EPSY_N, EPS_0]),
        make: elastic_pp,
    },
    Kind {
        names: &["ElasticPPGap"],
        usage: "uniaxialMaterial ElasticPPGap $tag $E $Fy $gap <$eta> <damage>",
        text: Text::new("Elastic, perfectly plastic beyond a gap.")
            .example("uniaxialMaterial ElasticPPGap 77 1 1 1")
            .arguments(&[STIFFNESS.also(&["k"]), FY.also(&["fy"]), CLOSING, HARDENING]),
        make: elastic_pp_gap,
    },
    Kind {
        names: &["HookGap"],
        usage: "uniaxialMaterial HookGap $tag $E $gap <$gapP>",
        text: Text::new("Elastic beyond a gap in either sense.")
            .example("uniaxialMaterial HookGap 77 1 1")
            .arguments(&[E, GAP, GAP_P]),
        make: hook_gap,
    },
    Kind {
        names: &["ENT"],
        usage: "uniaxialMaterial ENT $tag $E <$a> <$b>",
        text: Text::new("Elastic without tension.")
            .example("uniaxialMaterial ENT 77 1")
            .arguments(&[STIFFNESS, TENSION, FACTOR]),
        make: no_tension,
    },
    Kind {
        names: &["ElasticBilin", "ElasticBilinear"],
        usage: "uniaxialMaterial ElasticBilin $tag $EP1 $EP2 $epsP2 <$EN1 $EN2 $epsN2>",
        text: Text::new("Elastic with two slopes in each sense.")
            .example("uniaxialMaterial ElasticBilin 77 1 1 1")
            .groups(&[&BILINEAR, &BILINEAR_N]),
        make: elastic_bilin,
    },
    Kind {
        names: &["ElasticPowerFunc"],
        usage: "uniaxialMaterial ElasticPowerFunc $tag <$eta> -coeff $c1 $c2 ... -exp $e1 $e2 ...",
        text: Text::new("Elastic, a sum of powers of the strain.")
            .example("uniaxialMaterial ElasticPowerFunc 77 -coeff 20. 300. -exp 1. 3.")
            .arguments(&[
                ETA,
                Arg::of("-coeff", "c1", "coefficients of the powers"),
                Arg::of("-exp", "e1", "exponents, as many as coefficients"),
            ]),
        make: elastic_power,
    },
    Kind {
        names: &["ElasticMultiLinear"],
        usage: "uniaxialMaterial ElasticMultiLinear $tag <$eta> -strain $e1 $e2 ... -stress $s1 $s2 ...",
        text: Text::new("Elastic along given points.")
            .example("uniaxialMaterial ElasticMultiLinear 77 -strain -0.1 0. 0.1 -stress -1. 0. 1.")
            .arguments(&[ETA, Arg::of("-strain", "e1", "-stress"), Arg::of("-stress", "s1", "a stress")]),
        make: elastic_multi_linear,
    },
];

/// A modulus that may be 0, as that of a spring which is there for its name only. A negative one stands for an effect
/// that softens: seldom meant.
fn modulus(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let e = a.read(interp, &E)?;
    if e < 0.0 {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("the elastic modulus E is {e}: the material pushes instead of holding"),
        );
        warn(interp, d.at(a.last_span(), "expected a number not less than 0"))?;
    }
    Ok(e)
}

/// A yield strain whose sign is made to fit its side, as in OpenSees.
fn yield_strain(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg, x: f64, sign: f64) -> Result<(), Exception> {
    let what = arg.meaning;
    if x == 0.0 {
        // A cable has no strength in compression.
        let side = if sign > 0.0 { "tension" } else { "compression" };
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("ElasticPP: the {what} is 0: the material yields at once in {side}"),
        );
        warn(interp, d.at(a.last_span(), "expected a strain other than 0"))?;
    }
    if x * sign < 0.0 {
        let d = Diagnostic::warning(
            &checks::words::REPLACED_VALUE,
            format!("ElasticPP: the {what} is {x} and is taken for {}", -x),
        );
        warn(
            interp,
            d.at(a.last_span(), format!("expected a number {} than 0", if sign > 0.0 { "greater" } else { "less" })),
        )?;
    }
    Ok(())
}

fn cable(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [prestress, e, weight, length] = a.read_all(interp, &CABLE)?;
    Ok(by_rules!(interp, slips::CABLE_SAG, rules => Cable { prestress, e, weight, length, rules }))
}

fn elastic(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = modulus(interp, a)?;
    let eta = a.read_or(interp, &ETA, 0.0)?;
    let e_neg = a.read_or(interp, &E_NEG, e)?;
    Ok(Elastic { e_pos: e, eta, e_neg }.shared())
}

fn elastic_pp(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.read(interp, &USUAL_E)?;
    let tension = a.read(interp, &EPSY_P)?;
    yield_strain(interp, a, &EPSY_P, tension, 1.0)?;
    let compression = a.read_optional(interp, &EPSY_N)?;
    if let Some(x) = compression {
        yield_strain(interp, a, &EPSY_N, x, -1.0)?;
    }
    let compression = compression.unwrap_or(-tension);
    if tension == 0.0 && compression == 0.0 {
        a.doubt(interp, "ElasticPP: both yield strains are 0", "expected a strain other than 0")?;
    }
    let initial = a.read_optional(interp, &EPS_0)?.unwrap_or(0.0);
    Ok(ElasticPP::new(e, tension, compression, initial).shared())
}

fn hook_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = modulus(interp, a)?;
    // One gap is that of both senses; of two the first is that in compression, with either sign.
    let first = a.read(interp, &GAP)?;
    let second = a.read_optional(interp, &GAP_P)?.unwrap_or(first);
    Ok(HookGap { e, gap: [-first.abs(), second] }.shared())
}

fn elastic_pp_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut e = a.read(interp, &STIFFNESS)?;
    let e_span = a.last_span();
    let fy = a.read(interp, &FY)?;
    let gap = a.read(interp, &CLOSING)?;
    let gap_span = a.last_span();
    let mut eta = a.read_or(interp, &HARDENING, 0.0)?;
    if e == 0.0 {
        // As in OpenSees: a yield strain of 0.2 %.
        e = fy.abs() / 0.002;
        if e == 0.0 {
            return Err(a.refuse_at(e_span, "E and Fy are both 0", "expected the elastic modulus E, greater than 0"));
        }
    }
    if eta >= 1.0 {
        let message = format!("ElasticPPGap: the hardening ratio {eta} is not less than 1 and is taken for 0");
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                .at(a.last_span(), "expected a ratio less than 1"),
        )?;
        eta = 0.0;
    }
    if fy * gap < 0.0 {
        let message = "ElasticPPGap: the yield stress and the gap have different signs, so that it acts at once";
        warn(
            interp,
            Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, message).at(gap_span, "expected the sign of Fy"),
        )?;
    }
    let damage = a.flag("damage") || a.flag("Damage");
    Ok(ElasticPPGap { e, fy, gap, eta, damage }.shared())
}

fn no_tension(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.read(interp, &STIFFNESS)?;
    let tension = a.read_or(interp, &TENSION, 0.0)?;
    let b = a.read_or(interp, &FACTOR, 1.0)?;
    Ok(NoTension { e, a: tension, b }.shared())
}

fn elastic_bilin(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let tension = a.read_all(interp, &BILINEAR)?;
    let compression = if a.left() > 0 { a.read_all(interp, &BILINEAR_N)? } else { tension };
    let both = |i: usize| [tension[i], compression[i]];
    Ok(ElasticBilin { first: both(0), second: both(1), bend: both(2).map(f64::abs) }.shared())
}

fn elastic_multi_linear(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let eta = a.optional_number(&ETA)?.unwrap_or(0.0);
    let mut list = |option: &str, what: &str| {
        if a.flag(option) {
            return a.floats(what);
        }
        a.word(option)?;
        Err(a.refuse(format!("\"{}\" is not {option}", a.last_word()), format!("expected {option} and a list")))
    };
    let (strains, stresses) = (list("-strain", "strain")?, list("-stress", "stress")?);
    let (n, m) = (strains.len(), stresses.len());
    let law = ElasticMultiLinear::new(strains, stresses, eta).ok_or_else(|| {
        let message = format!("{n} strains and {m} stresses make no curve");
        a.refuse(message, "expected at least 2 strains that rise, and as many stresses")
    })?;
    Ok(law.shared())
}

fn elastic_power(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let eta = a.optional_number(&ETA)?.unwrap_or(0.0);
    let mut list = |options: &[&str], what: &str| {
        let word = a.word(options[0])?;
        if options.contains(&word.as_ref()) {
            return a.floats(what);
        }
        Err(a.refuse(format!("\"{word}\" is not {}", options[0]), format!("expected {} and a list", options[0])))
    };
    let coefficients = list(&["-coeff", "-coefficient", "-coefficients"], "coefficient")?;
    let exponents = list(&["-exp", "-exponent", "-exponents"], "exponent")?;
    let (n, m) = (coefficients.len(), exponents.len());
    if n == 0 || n != m {
        return Err(a.refuse(format!("{n} coefficients and {m} exponents"), "expected as many of either, at least one"));
    }
    if let Some(n) = exponents.iter().find(|n| **n < 0.0) {
        return Err(a.refuse(format!("an exponent is {n}"), "expected 0 or more: the stress would be infinite at rest"));
    }
    let terms = coefficients.into_iter().zip(exponents).map(|(c, n)| [c, n]).collect();
    Ok(ElasticPower { terms, eta }.shared())
}
