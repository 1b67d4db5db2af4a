//! Concrete.

use super::Kind;
use crate::args::Args;
use crate::{Tcl, ignore_option, warn};
use hysteron_engine::material::{Concrete01, Concrete02, Concrete04, ConcreteCm, Material, TsaiEnvelope};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::sync::Arc;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Concrete01", "concrete01"],
        usage: "uniaxialMaterial Concrete01 $tag $fpc $epsc0 $fpcu $epscu",
        make: concrete01,
    },
    Kind {
        names: &["Concrete02", "concrete02"],
        usage: "uniaxialMaterial Concrete02 $tag $fpc $epsc0 $fpcu $epscu <$lambda $ft $Ets>",
        make: concrete02,
    },
    Kind {
        names: &["Concrete04"],
        usage: "uniaxialMaterial Concrete04 $tag $fpc $epsc0 $epscu $Ec0 <$ft $etu <$beta>>",
        make: concrete04,
    },
    Kind {
        names: &["ConcreteCM"],
        usage: "uniaxialMaterial ConcreteCM $tag $fpcc $epcc $Ec $rc $xcrn $ft $et $rt $xcrp <$mon | -GapClose $gap>",
        make: concrete_cm,
    },
];

/// Strength, its strain, crushing strength, its strain: all in compression, whatever their signs.
fn compression(interp: &mut Tcl, a: &mut Args<'_>) -> Result<[f64; 4], Exception> {
    let fc = -compressive(a, "compressive strength fpc")?;
    let epsc0 = -compressive(a, "strain at the strength epsc0")?;
    let fcu = -a.float("crushing strength fpcu")?.abs();
    let epscu = -a.float("strain at the crushing strength epscu")?.abs();
    if epscu >= epsc0 {
        let d = Diagnostic::warning(format!("the crushing strain {epscu} is not beyond that of the strength, {epsc0}"));
        warn(interp, d.at(a.last_span(), "expected a larger strain"))?;
    }
    Ok([fc, epsc0, fcu, epscu])
}

fn concrete01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fpc, epsc0, fpcu, epscu] = compression(interp, a)?;
    Ok(Arc::new(Concrete01 { fpc, epsc0, fpcu, epscu }))
}

fn concrete02(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fc, epsc0, fcu, epscu] = compression(interp, a)?;
    let (mut ratio, mut ft, mut ets) = (0.1, -0.1 * fc, 0.1 * fc / epsc0);
    if a.left() > 0 {
        ratio = a.float("ratio of the unloading slope lambda")?;
        if ratio == 1.0 {
            return Err(a.refuse("lambda is 1", "expected a ratio less than 1"));
        }
        ft = a.not_negative("tensile strength ft")?;
        ets = a.not_negative("tension softening modulus Ets")?;
        if ets == 0.0 && ft > 0.0 {
            let d = Diagnostic::warning(
                "without a tension softening modulus Ets a crack carries the tensile strength for good",
            );
            warn(interp, d.at(a.last_span(), "expected a number greater than 0"))?;
        }
    }
    Ok(Arc::new(Concrete02 { fc, epsc0, fcu, epscu, ratio, ft, ets }))
}

/// Stress at the ultimate tensile strain divided by the tensile strength, where it is left out.
const TENSION_LEFT: f64 = 0.1;

fn concrete04(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fc = -compressive(a, "compressive strength fpc")?;
    let epsc0 = -compressive(a, "strain at the strength epsc0")?;
    let epscu = -compressive(a, "crushing strain epscu")?;
    if epscu > epsc0 {
        let d = Diagnostic::warning(format!("the crushing strain {epscu} is not beyond that of the strength, {epsc0}"));
        warn(interp, d.at(a.last_span(), "expected a larger strain"))?;
    }
    let ec0 = a.positive("initial modulus Ec0")?;
    let (mut ft, mut etu, mut beta) = (0.0, 0.0, TENSION_LEFT);
    if a.left() > 0 {
        ft = a.float("tensile strength ft")?;
        if ft < 0.0 {
            let d =
                Diagnostic::warning(format!("the tensile strength ft is {ft}: there is no tension, as in OpenSees"));
            warn(interp, d.at(a.last_span(), "expected 0 or more"))?;
            ft = 0.0;
        }
        etu = a.float("ultimate strain in tension etu")?;
        beta = a.optional_float("share beta of the tensile strength at the ultimate strain")?.unwrap_or(beta);
    }
    Ok(Arc::new(Concrete04 { fc, epsc0, epscu, ec0, ft, etu, beta }))
}

fn concrete_cm(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (strength, strain) =
        (-compressive(a, "compressive strength fpcc")?, -compressive(a, "strain at the strength epcc")?);
    let ec = a.positive("initial modulus Ec")?;
    let shape = |a: &mut Args<'_>, side: &str| {
        Ok::<_, Exception>((
            a.positive(&format!("shape parameter {side}"))?,
            a.positive(&format!("critical strain {}", if side == "rc" { "xcrn" } else { "xcrp" }))?,
        ))
    };
    let (r, critical) = shape(a, "rc")?;
    let compression = TsaiEnvelope { strength, strain, r, critical };
    let (strength, strain) = (a.positive("tensile strength ft")?, a.positive("strain at the tensile strength et")?);
    let (r, critical) = shape(a, "rt")?;
    let tension = TsaiEnvelope { strength, strain, r, critical };
    let (mut stiff_closure, mut monotonic) = (false, false);
    if a.at_number() {
        monotonic = switch(a, "switch mon of the envelopes alone")?;
    } else if let Some(option) = a.option() {
        match option.as_ref() {
            "-GapClose" => stiff_closure = switch(a, "switch gap of the closure")?,
            _ => ignore_option(interp, a, &["-GapClose"])?,
        }
    }
    Ok(Arc::new(ConcreteCm { ec, compression, tension, stiff_closure, monotonic }))
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
fn compressive(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match a.float(what)? {
        0.0 => Err(a.refuse(format!("the {what} is 0"), "expected a number less than 0")),
        x => Ok(x.abs()),
    }
}
