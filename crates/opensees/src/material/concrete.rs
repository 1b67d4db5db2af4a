//! Concrete.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, slips, warn};
use hysteron_engine::material::{
    Concrete01, Concrete01Sitc, Concrete02, Concrete02Is, Concrete04, Concrete06, Concrete07, ConcreteCm, ConcreteD,
    ConcreteWBeta, Material, TsaiEnvelope,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const BETA_FT: Arg = Arg::not_negative("ft", "tensile strength ft");
const BETA_LAMBDA: Arg =
    Arg::of("-lambda", "lambda", "share lambda of the secant modulus in unloading").within(Domain::Number);
const BETA_ALPHA: Arg =
    Arg::of("-alpha", "alpha", "closing stress over tensile strength alpha").within(Domain::NotNegative);
const BETA_POINT: Arg = Arg::of("-beta", "bint", "point of the reduction by the strain across").within(Domain::Number);
const BETA_M: Arg = Arg::of("-M", "M", "share of tension stiffening M").within(Domain::NotNegative);
const BETA_E: Arg = Arg::of("-E", "Ec", "initial modulus E").within(Domain::Positive);

const COMPRESSION: [Arg; 4] = [
    Arg::number("fpc", "compressive strength fpc"),
    Arg::number("epsc0", "strain at the strength epsc0"),
    Arg::number("fpcu", "crushing strength fpcu"),
    Arg::number("epscu", "strain at the crushing strength epscu"),
];
const TENSION: [Arg; 3] = [
    Arg::number("lambda", "ratio of the unloading slope lambda"),
    Arg::number("ft", "tensile strength ft"),
    Arg::not_negative("Ets", "tension softening modulus Ets"),
];
const E0: Arg = Arg::positive("E0", "initial modulus E0");
const DEBRIS: Arg = Arg::number("endStrainSITC", "strain of the debris without stress endStrainSITC");

const POPOVICS: [Arg; 4] = [
    COMPRESSION[0],
    COMPRESSION[1],
    Arg::number("epscu", "crushing strain epscu"),
    Arg::positive("Ec0", "initial modulus Ec0"),
];
const POPOVICS_TENSION: [Arg; 3] = [
    TENSION[1],
    Arg::number("etu", "ultimate strain in tension etu"),
    Arg::number("beta", "share beta of the tensile strength at the ultimate strain"),
];

const THORENFELDT: [Arg; 3] = [
    Arg::number("fc", "compressive strength fc"),
    Arg::number("e0", "strain at the strength e0"),
    Arg::number("n", "shape of the curve n"),
];
const THORENFELDT_REST: [Arg; 6] = [
    Arg::positive("k", "steepness after the strength k"),
    Arg::not_negative("alpha1", "rate of plastic strain alpha1"),
    Arg::positive("fcr", "tensile strength fcr"),
    Arg::positive("ecr", "strain at the tensile strength ecr"),
    Arg::not_negative("b", "exponent of tension stiffening b"),
    Arg::not_negative("alpha2", "rate of plastic strain alpha2"),
];

/// Curves of `ConcreteCM` in compression and tension.
const SHAPE: [Arg; 4] = [
    Arg::positive("rc", "shape parameter rc"),
    Arg::positive("xcrn", "critical strain xcrn"),
    Arg::positive("rt", "shape parameter rt"),
    Arg::positive("xcrp", "critical strain xcrp"),
];

const TSAI: [Arg; 6] = [
    Arg::positive("Ec", "initial modulus Ec"),
    Arg::positive("ft", "tensile strength ft"),
    Arg::positive("et", "strain at the tensile strength et"),
    Arg::positive("xp", "critical strain ratio xp"),
    Arg::positive("xn", "critical strain ratio xn"),
    Arg::positive("r", "shape of the curves r"),
];

const CHINESE: [Arg; 2] = [THORENFELDT[0], Arg::number("epsc", "strain at the strength epsc")];
const CHINESE_TENSION: [Arg; 3] = [
    Arg::positive("ft", "tensile strength ft"),
    Arg::positive("epst", "strain at the tensile strength epst"),
    Arg::positive("Ec", "initial modulus Ec"),
];
const SOFTENING: [Arg; 2] = [
    Arg::not_negative("alphac", "softening in compression alphac"),
    Arg::not_negative("alphat", "softening in tension alphat"),
];
const PLASTIC: [Arg; 2] = [
    Arg::not_negative("cesp", "factor of the plastic strain cesp"),
    Arg::number("etap", "exponent of the plastic strain etap"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Concrete01", "concrete01"],
        usage: "uniaxialMaterial Concrete01 $tag $fpc $epsc0 $fpcu $epscu",
        text: Text::new("Concrete of Kent, Scott and Park without tensile strength.")
            .example("uniaxialMaterial Concrete01 77 1 1 1 1")
            .arguments(&[
                COMPRESSION[0].also(&["fc"]),
                COMPRESSION[1].also(&["epsco"]),
                COMPRESSION[2].also(&["fcu"]),
                COMPRESSION[3],
            ]),
        make: concrete01,
    },
    Kind {
        names: &["Concrete02", "concrete02"],
        usage: "uniaxialMaterial Concrete02 $tag $fpc $epsc0 $fpcu $epscu <$lambda $ft $Ets>",
        text: Text::new("Concrete with linear tension softening.")
            .example("uniaxialMaterial Concrete02 77 1 1 1 1")
            .groups(&[&COMPRESSION, &TENSION]),
        make: concrete02,
    },
    Kind {
        names: &["Concrete04"],
        usage: "uniaxialMaterial Concrete04 $tag $fpc $epsc0 $epscu $Ec0 <$ft $etu <$beta>>",
        text: Text::new("Concrete by Popovics' curve, with exponential softening in tension.")
            .example("uniaxialMaterial Concrete04 77 -30. -0.002 -0.006 25000. 3. 0.002 0.2")
            .groups(&[&POPOVICS, &POPOVICS_TENSION]),
        make: concrete04,
    },
    Kind {
        names: &["ConcreteCM"],
        usage: "uniaxialMaterial ConcreteCM $tag $fpcc $epcc $Ec $rc $xcrn $ft $et $rt $xcrp <$mon | -GapClose $gap>",
        text: Text::new("Concrete of Chang and Mander with closing cracks.")
            .example("uniaxialMaterial ConcreteCM 77 -30. -0.002 25000. 7. 1.035 3. 0.0002 1.2 1e4")
            .arguments(&[
                Arg::number("fpcc", "compressive strength fpcc"),
                Arg::number("epcc", "strain at the strength epcc"),
                TSAI[0],
                SHAPE[0],
                SHAPE[1],
                TSAI[1],
                TSAI[2],
                SHAPE[2],
                SHAPE[3],
                Arg::new("mon", "1: the envelopes alone, without memory; 0: cycles"),
                Arg::of("-GapClose", "gap", "1: cracks close with a stiffness of their own; 0: without"),
            ]),
        make: concrete_cm,
    },
    Kind {
        names: &["Concrete02IS"],
        usage: "uniaxialMaterial Concrete02IS $tag $E0 $fpc $epsc0 $fpcu $epscu <$lambda $ft $Ets>",
        text: Text::new("As `Concrete02`, with an initial modulus and Popovics' curve.")
            .example("uniaxialMaterial Concrete02IS 77 25000. -30. -0.002 -6. -0.005")
            .groups(&[&[E0], &COMPRESSION, &TENSION]),
        make: concrete02_is,
    },
    Kind {
        names: &["Concrete06"],
        usage: "uniaxialMaterial Concrete06 $tag $fc $e0 $n $k $alpha1 $fcr $ecr $b $alpha2",
        text: Text::new("Concrete with Thorenfeldt's curve and tension stiffening.")
            .example("uniaxialMaterial Concrete06 77 -30. -0.002 2. 1.1 0.32 3. 0.0002 0.4 0.08")
            .groups(&[&THORENFELDT, &THORENFELDT_REST]),
        make: concrete06,
    },
    Kind {
        names: &["Concrete07"],
        usage: "uniaxialMaterial Concrete07 $tag $fpc $epsc0 $Ec $ft $et $xp $xn $r",
        text: Text::new("Concrete of Chang and Mander with Tsai's envelopes and simple rules of unloading.")
            .example("uniaxialMaterial Concrete07 77 -30. -0.002 25000. 3. 0.0002 2. 2.3 4.")
            .groups(&[&[COMPRESSION[0], COMPRESSION[1]], &TSAI]),
        make: concrete07,
    },
    Kind {
        names: &["ConcreteD"],
        usage: "uniaxialMaterial ConcreteD $tag $fc $epsc $ft $epst $Ec $alphac $alphat <$cesp $etap>",
        text: Text::new("Concrete of the Chinese code GB 50010, with plastic strains.")
            .example("uniaxialMaterial ConcreteD 77 -30. -0.002 3. 0.00015 25000. 1.5 2.")
            .groups(&[&CHINESE, &CHINESE_TENSION, &SOFTENING, &PLASTIC]),
        make: concrete_d,
    },
    Kind {
        names: &["ConcretewBeta"],
        usage: "uniaxialMaterial ConcretewBeta $tag $fpc $ec0 $fcint $ecint $fcres $ecres $ft $ftint $etint $ftres $etres \
                <-lambda $lambda> <-alpha $alpha> <-beta $bint $ebint $bres $ebres> <-M $M> <-E $Ec> <-conf $fcc $ecc>",
        text: Text::new("Concrete with multilinear softening, of planar trusses and panels.")
            .example(
                "uniaxialMaterial ConcretewBeta 77 -30. -0.002 -15. -0.006 -3. -0.012 3. 1.5 0.0005 0.3 \
                0.001",
            )
            .arguments(&[
                Arg::number("fpc", "peak stress fpc"),
                Arg::number("ec0", "peak strain ec0"),
                Arg::new("fcint", "stress in the middle of softening in compression"),
                Arg::new("ecint", "strain of that stress"),
                Arg::new("fcres", "residual stress in compression"),
                Arg::new("ecres", "strain at which it begins"),
                BETA_FT,
                Arg::new("ftint", "stress in the middle of softening in tension"),
                Arg::new("etint", "strain of that stress"),
                Arg::new("ftres", "residual stress in tension"),
                Arg::new("etres", "strain at which it begins"),
                BETA_LAMBDA,
                BETA_ALPHA,
                BETA_POINT,
                BETA_M,
                BETA_E,
                Arg::of("-conf", "fcc", "strength with confinement and its strain"),
            ]),
        make: concrete_w_beta,
    },
    Kind {
        names: &["Concrete01WithSITC"],
        usage: "uniaxialMaterial Concrete01WithSITC $tag $fpc $epsc0 $fpcu $epscu <$endStrainSITC>",
        text: Text::new("As `Concrete01`, with debris that keeps cracks open.")
            .example("uniaxialMaterial Concrete01WithSITC 77 1 1 1 1")
            .groups(&[&COMPRESSION, &[DEBRIS]]),
        make: concrete01_sitc,
    },
];

/// Strength, its strain, crushing strength, its strain: all in compression, whatever their signs.
fn compression(interp: &mut Tcl, a: &mut Args<'_>) -> Result<[f64; 4], Exception> {
    let [strength, strain, crushing, end] = &COMPRESSION;
    let fc = -compressive(a, strength.meaning)?;
    let epsc0 = -compressive(a, strain.meaning)?;
    let fcu = -a.read(interp, crushing)?.abs();
    let epscu = -a.read(interp, end)?.abs();
    if epscu >= epsc0 {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("the crushing strain {epscu} is not beyond that of the strength, {epsc0}"),
        );
        warn(interp, d.at(a.last_span(), "expected a larger strain"))?;
    }
    Ok([fc, epsc0, fcu, epscu])
}

fn concrete01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fpc, epsc0, fpcu, epscu] = compression(interp, a)?;
    Ok(Concrete01 { fpc, epsc0, fpcu, epscu }.shared())
}

fn concrete02(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fc, epsc0, fcu, epscu] = compression(interp, a)?;
    let [ratio, ft, ets] = tension(interp, a, fc, epsc0)?;
    Ok(Concrete02 { fc, epsc0, fcu, epscu, ratio, ft, ets }.shared())
}

/// Ratio of the unloading slope, tensile strength, softening modulus: all or none.
fn tension(interp: &mut Tcl, a: &mut Args<'_>, fc: f64, epsc0: f64) -> Result<[f64; 3], Exception> {
    let (mut ratio, mut ft, mut ets) = (0.1, -0.1 * fc, 0.1 * fc / epsc0);
    if a.left() > 0 {
        ratio = a.read(interp, &TENSION[0])?;
        if ratio == 1.0 {
            return Err(a.refuse("lambda is 1", "expected a ratio less than 1"));
        }
        ft = a.read(interp, &TENSION[1])?;
        if ft < 0.0 {
            warn_of_strength(interp, a, ft)?;
        }
        ets = a.read(interp, &TENSION[2])?;
        if ets == 0.0 && ft > 0.0 {
            let d = Diagnostic::warning(
                &checks::materials::UNUSUAL_PARAMETER,
                "without a tension softening modulus Ets a crack carries the tensile strength for good",
            );
            warn(interp, d.at(a.last_span(), "expected a number greater than 0"))?;
        }
    }
    Ok([ratio, ft, ets])
}

/// Warn of a tensile strength less than 0.
fn warn_of_strength(interp: &mut Tcl, a: &Args<'_>, ft: f64) -> Result<(), Exception> {
    let message = format!("the tensile strength ft is {ft}: there is no tension, as in OpenSees");
    let d = Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, message);
    warn(interp, d.at(a.last_span(), "expected 0 or more"))
}

fn concrete02_is(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e0 = a.read(interp, &E0)?;
    let [fc, epsc0, fcu, epscu] = compression(interp, a)?;
    let [ratio, ft, ets] = tension(interp, a, fc, epsc0)?;
    Ok(Concrete02Is { e0, concrete: Concrete02 { fc, epsc0, fcu, epscu, ratio, ft, ets } }.shared())
}

fn concrete06(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [strength, strain, shape] = &THORENFELDT;
    let (fc, eo) = (-compressive(a, strength.meaning)?, -compressive(a, strain.meaning)?);
    let r = a.read(interp, shape)?;
    if r <= 1.0 {
        return Err(a.refuse(format!("the shape of the curve n is {r}"), "expected more than 1"));
    }
    let [k, alpha_c, fcr, ecr, b, alpha_t] = a.read_all(interp, &THORENFELDT_REST)?;
    Ok(Concrete06 { fc, eo, r, k, alpha_c, fcr, ecr, b, alpha_t }.shared())
}

fn concrete07(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [strength, strain, ..] = &COMPRESSION;
    let compression = [-compressive(a, strength.meaning)?, -compressive(a, strain.meaning)?];
    let [ec, ft, et, critical_tension, critical_compression, r] = a.read_all(interp, &TSAI)?;
    let tension = [ft, et];
    let kept_strain = if interp.host.follows(&[slips::CHANG_MANDER_STRAIN]) { 0.0 } else { 1.0 };
    Ok(Concrete07 { compression, tension, ec, critical_tension, critical_compression, r, kept_strain }.shared())
}

fn concrete_d(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [strength, strain] = &CHINESE;
    let (fc, ec) = (-compressive(a, strength.meaning)?, -compressive(a, strain.meaning)?);
    let [ft, et, modulus] = a.read_all(interp, &CHINESE_TENSION)?;
    let least = (fc / ec).max(ft / et);
    if modulus <= least {
        let label = format!("expected more than the secant moduli of the strengths, {least}");
        return Err(a.refuse(format!("the initial modulus Ec is {modulus}"), label));
    }
    let alpha = a.read_all(interp, &SOFTENING)?;
    let plastic = if a.left() > 0 { a.read_all(interp, &PLASTIC)? } else { [0.25, 1.15] };
    Ok(ConcreteD { fc, ec, ft, et, modulus, alpha, plastic }.shared())
}

fn concrete_w_beta(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let place = |a: &mut Args<'_>, what: &str, stress: &str, strain: &str| {
        let f = a.float(&format!("{what} stress {stress}"))?;
        Ok::<_, Exception>([f, a.float(&format!("{what} strain {strain}"))?])
    };
    let negative = |a: &mut Args<'_>, what: &str, stress: &str, strain: &str| {
        let f = place(a, what, stress, strain)?;
        if f[0] > 0.0 || f[1] >= 0.0 {
            return Err(
                a.refuse(format!("the {what} stress and strain are {} and {}", f[0], f[1]), "expected compression")
            );
        }
        Ok(f)
    };
    let peak = negative(a, "peak", "fpc", "ec0")?;
    if peak[0] == 0.0 {
        return Err(a.refuse("the peak stress fpc is 0", "expected a number less than 0"));
    }
    let (middle, residual) = (negative(a, "middle", "fcint", "ecint")?, negative(a, "residual", "fcres", "ecres")?);
    let ft = a.number(&BETA_FT)?;
    let tension_middle = place(a, "middle tensile", "ftint", "etint")?;
    let tension_residual = place(a, "residual tensile", "ftres", "etres")?;
    let secant = peak[0] / peak[1];
    let (mut lambda, mut alpha, mut stiffening, mut e0, mut confined) = (0.5, 1.0, 0.0, 2.0 * secant, peak);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-lambda" => lambda = a.number(&BETA_LAMBDA)?,
            "-alpha" => alpha = a.number(&BETA_ALPHA)?,
            // The strain across has an effect in panels alone.
            "-beta" => (0..4).try_for_each(|_| a.number(&BETA_POINT).map(|_| ()))?,
            "-M" => stiffening = a.number(&BETA_M)?,
            "-E" => e0 = a.number(&BETA_E)?,
            "-conf" => confined = negative(a, "confined", "fcc", "ecc")?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if confined[0] > peak[0] || confined[1] > peak[1] {
        let d = Diagnostic::warning(
            &checks::words::UNUSED_WORD,
            "ConcretewBeta: the confined strength is below that without, and is not used",
        );
        warn(interp, d.at(a.last_span(), "expected a larger strength at a larger strain"))?;
        confined = peak;
    }
    if !(secant..=2.0 * secant).contains(&e0) {
        let d = Diagnostic::warning(
            &checks::words::REPLACED_VALUE,
            format!("ConcretewBeta: the initial modulus {e0} is taken into its bounds"),
        );
        warn(interp, d.at(a.last_span(), format!("expected {secant} to {}", 2.0 * secant)))?;
        e0 = e0.clamp(secant, 2.0 * secant);
    }
    Ok(ConcreteWBeta {
        peak,
        confined,
        middle,
        residual,
        ft,
        tension_middle,
        tension_residual,
        lambda,
        alpha,
        stiffening,
        e0,
    }
    .shared())
}

/// Strain at which debris in cracks has no stress, where it is left out.
const END_OF_DEBRIS: f64 = 0.03;

fn concrete01_sitc(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fpc, epsc0, fpcu, epscu] = compression(interp, a)?;
    let end = a.read_or(interp, &DEBRIS, END_OF_DEBRIS)?;
    Ok(Concrete01Sitc { concrete: Concrete01 { fpc, epsc0, fpcu, epscu }, end }.shared())
}

/// Stress at the ultimate tensile strain divided by the tensile strength, where it is left out.
const TENSION_LEFT: f64 = 0.1;

fn concrete04(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [strength, strain, crushing, modulus] = &POPOVICS;
    let fc = -compressive(a, strength.meaning)?;
    let epsc0 = -compressive(a, strain.meaning)?;
    let epscu = -compressive(a, crushing.meaning)?;
    if epscu > epsc0 {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("the crushing strain {epscu} is not beyond that of the strength, {epsc0}"),
        );
        warn(interp, d.at(a.last_span(), "expected a larger strain"))?;
    }
    let ec0 = a.read(interp, modulus)?;
    let (mut ft, mut etu, mut beta) = (0.0, 0.0, TENSION_LEFT);
    if a.left() > 0 {
        let [strength, ultimate, share] = &POPOVICS_TENSION;
        ft = a.read(interp, strength)?;
        if ft < 0.0 {
            warn_of_strength(interp, a, ft)?;
            ft = 0.0;
        }
        etu = a.read(interp, ultimate)?;
        beta = a.read_optional(interp, share)?.unwrap_or(beta);
    }
    Ok(Concrete04 { fc, epsc0, epscu, ec0, ft, etu, beta }.shared())
}

fn concrete_cm(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (strength, strain) =
        (-compressive(a, "compressive strength fpcc")?, -compressive(a, "strain at the strength epcc")?);
    let ec = a.number(&TSAI[0])?;
    let (r, critical) = (a.number(&SHAPE[0])?, a.number(&SHAPE[1])?);
    let compression = TsaiEnvelope { strength, strain, r, critical };
    let (strength, strain) = (a.number(&TSAI[1])?, a.number(&TSAI[2])?);
    let (r, critical) = (a.number(&SHAPE[2])?, a.number(&SHAPE[3])?);
    let tension = TsaiEnvelope { strength, strain, r, critical };
    let (mut stiff_closure, mut monotonic) = (false, false);
    if a.at_number() {
        monotonic = switch(a, "switch mon of the envelopes alone")?;
    } else if let Some(option) = a.option() {
        match option.as_ref() {
            "-GapClose" => stiff_closure = switch(a, "switch gap of the closure")?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(ConcreteCm { ec, compression, tension, stiff_closure, monotonic }.shared())
}

/// 0 or 1.
fn switch(a: &mut Args<'_>, what: &str) -> Result<bool, Exception> {
    match a.int(what)? {
        0 => Ok(false),
        1 => Ok(true),
        x => Err(a.refuse(format!("the {what} is {x}"), "expected 0 or 1")),
    }
}

/// A number other than zero that stands for compression, whatever its sign.
pub(super) fn compressive(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match a.float(what)? {
        0.0 => Err(a.refuse(format!("the {what} is 0"), "expected a number less than 0")),
        x => Ok(x.abs()),
    }
}
