//! Elastic materials.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    Elastic, ElasticBilin, ElasticMultiLinear, ElasticPP, ElasticPPGap, ElasticPower, HookGap, Material, NoTension,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Elastic"],
        usage: "uniaxialMaterial Elastic $tag $E <$eta> <$Eneg>",
        text: Text::new("Linear elastic, with an optional viscous part.")
            .arguments(&[Arg::new("Eneg", "elastic modulus in compression")]),
        make: elastic,
    },
    Kind {
        names: &["ElasticPP"],
        usage: "uniaxialMaterial ElasticPP $tag $E $epsyP <$epsyN> <$eps0>",
        text: Text::new("Elastic, perfectly plastic.").arguments(&[Arg::new("eps0", "initial strain")]),
        make: elastic_pp,
    },
    Kind {
        names: &["ElasticPPGap"],
        usage: "uniaxialMaterial ElasticPPGap $tag $E $Fy $gap <$eta> <damage>",
        text: Text::new("Elastic, perfectly plastic beyond a gap."),
        make: elastic_pp_gap,
    },
    Kind {
        names: &["HookGap"],
        usage: "uniaxialMaterial HookGap $tag $E $gap <$gapP>",
        text: Text::new("Elastic beyond a gap in either sense."),
        make: hook_gap,
    },
    Kind {
        names: &["ENT"],
        usage: "uniaxialMaterial ENT $tag $E <$a> <$b>",
        text: Text::new("Elastic without tension.").arguments(&[Arg::new("b", "factor of the strain in tension")]),
        make: no_tension,
    },
    Kind {
        names: &["ElasticBilin", "ElasticBilinear"],
        usage: "uniaxialMaterial ElasticBilin $tag $EP1 $EP2 $epsP2 <$EN1 $EN2 $epsN2>",
        text: Text::new("Elastic with two slopes in each sense."),
        make: elastic_bilin,
    },
    Kind {
        names: &["ElasticPowerFunc"],
        usage: "uniaxialMaterial ElasticPowerFunc $tag <$eta> -coeff $c1 $c2 ... -exp $e1 $e2 ...",
        text: Text::new("Elastic, a sum of powers of the strain.")
            .example("uniaxialMaterial ElasticPowerFunc 77 -coeff 20. 300. -exp 1. 3.")
            .arguments(&[
                Arg::new("eta", "damping modulus"),
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
            .arguments(&[Arg::new("eta", "viscous coefficient")]),
        make: elastic_multi_linear,
    },
];

/// A modulus that may be 0, as that of a spring which is there for its name only. A negative one stands for an effect
/// that softens: seldom meant.
fn modulus(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let e = a.float("elastic modulus E")?;
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
fn yield_strain(interp: &mut Tcl, a: &mut Args<'_>, what: &str, x: f64, sign: f64) -> Result<(), Exception> {
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

fn elastic(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = modulus(interp, a)?;
    let eta = a.optional_float("damping modulus eta")?.unwrap_or(0.0);
    let e_neg = a.optional_float("modulus in compression Eneg")?.unwrap_or(e);
    Ok(Elastic { e_pos: e, eta, e_neg }.shared())
}

fn elastic_pp(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.usually_positive(interp, "elastic modulus E")?;
    let tension = a.float("yield strain in tension epsyP")?;
    yield_strain(interp, a, "yield strain in tension epsyP", tension, 1.0)?;
    let compression = a.optional_float("yield strain in compression epsyN")?;
    if let Some(x) = compression {
        yield_strain(interp, a, "yield strain in compression epsyN", x, -1.0)?;
    }
    let compression = compression.unwrap_or(-tension);
    if tension == 0.0 && compression == 0.0 {
        a.doubt(interp, "ElasticPP: both yield strains are 0", "expected a strain other than 0")?;
    }
    let initial = a.optional_float("initial strain eps0")?.unwrap_or(0.0);
    Ok(ElasticPP::new(e, tension, compression, initial).shared())
}

fn hook_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = modulus(interp, a)?;
    // One gap is that of both senses; of two the first is that in compression, with either sign.
    let first = a.float("gap")?;
    let second = a.optional_float("gap in tension")?.unwrap_or(first);
    Ok(HookGap { e, gap: [-first.abs(), second] }.shared())
}

fn elastic_pp_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut e = a.not_negative("elastic modulus E")?;
    let e_span = a.last_span();
    let fy = a.float("yield stress Fy")?;
    let gap = a.float("strain at which the gap closes")?;
    let gap_span = a.last_span();
    let mut eta = a.optional_float("hardening ratio eta")?.unwrap_or(0.0);
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

fn no_tension(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.not_negative("elastic modulus E")?;
    let tension = a.optional_float("part of the modulus that acts in tension, a")?.unwrap_or(0.0);
    let b = a.optional_float("factor of the strain in tension, b")?.unwrap_or(1.0);
    Ok(NoTension { e, a: tension, b }.shared())
}

fn elastic_bilin(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let tension = [a.float("first modulus EP1")?, a.float("second modulus EP2")?, a.float("strain epsP2")?];
    let compression = if a.left() > 0 {
        [
            a.float("first modulus in compression EN1")?,
            a.float("second modulus in compression EN2")?,
            a.float("strain in compression epsN2")?,
        ]
    } else {
        tension
    };
    let both = |i: usize| [tension[i], compression[i]];
    Ok(ElasticBilin { first: both(0), second: both(1), bend: both(2).map(f64::abs) }.shared())
}

fn elastic_multi_linear(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let eta = a.optional_float("damping modulus eta")?.unwrap_or(0.0);
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
    let eta = a.optional_float("damping modulus eta")?.unwrap_or(0.0);
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
