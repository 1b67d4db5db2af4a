//! `uniaxialMaterial Masonry`.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Text};
use crate::{Tcl, slips};
use hysteron_engine::material::{Masonry, Material};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const FT: Arg = Arg::not_negative("Ft", "tensile strength Ft");
const UCL: Arg = Arg::number("Ucl", "strain Ucl at which cracks are closed");
const EMO: Arg = Arg::positive("Emo", "initial modulus Emo");
const MASONRY_L: Arg = Arg::positive("L", "length L of the strut");
const A1: Arg = Arg::positive("a1", "initial area a1");
const A2: Arg = Arg::positive("a2", "last area a2");
const MASONRY_D1: Arg = Arg::number("D1", "shortening D1 where the area begins to change");
const MASONRY_D2: Arg = Arg::number("D2", "shortening D2 at the last area");
const ACH: Arg = Arg::number("Ach", "factor Ach");
const ARE: Arg = Arg::not_negative("Are", "factor Are");
const BA: Arg = Arg::positive("Ba", "factor Ba of the focal point");
const BCH: Arg = Arg::positive("Bch", "factor Bch");
const GUN: Arg = Arg::positive("Gun", "ratio Gun of the slope of unloading");
const GPLU: Arg = Arg::positive("Gplu", "ratio Gplu of the slope at the end of unloading");
const GPLR: Arg = Arg::positive("Gplr", "ratio Gplr of the slope at the beginning of reloading");
const EXP1: Arg = Arg::number("Exp1", "exponent Exp1 of the slopes");
const EXP2: Arg = Arg::number("Exp2", "exponent Exp2 of inner cycles");
const MASONRY_IENV: Arg = Arg::whole("IENV", "shape IENV of the envelope");

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["Masonry"],
    usage: "uniaxialMaterial Masonry $tag $Fm $Ft $Um $Uult $Ucl $Emo $L $a1 $a2 $D1 $D2 $Ach $Are $Ba $Bch $Gun $Gplu $Gplr \
            $Exp1 $Exp2 $IENV",
    text: Text::new("Force and shortening of a strut of masonry in a frame (Crisafulli).")
        .example(
            "uniaxialMaterial Masonry 77 -5. 0.2 -0.002 -0.01 0.001 5000. 2. 0.3 0.2 -0.003 -0.008 0.3 0.4 1.5 \
         0.7 1.5 0.6 1.1 1.5 1. 1",
        )
        .arguments(&[
            Arg::number("Fm", "compressive strength Fm"),
            FT,
            Arg::number("Um", "strain at the strength Um"),
            Arg::number("Uult", "ultimate strain Uult"),
            UCL,
            EMO,
            MASONRY_L,
            A1,
            A2,
            MASONRY_D1,
            MASONRY_D2,
            ACH,
            ARE,
            BA,
            BCH,
            GUN,
            GPLU,
            GPLR,
            EXP1,
            EXP2,
            MASONRY_IENV,
        ]),
    make: masonry,
}];

/// A number in compression.
fn compressive(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    match a.float(what)? {
        x if x < 0.0 => Ok(x),
        x => Err(a.refuse(format!("the {what} is {x}"), "expected a negative number: compression")),
    }
}

fn masonry(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (fm, ft) = (compressive(a, "compressive strength Fm")?, a.number(&FT)?);
    let peak = [fm, compressive(a, "strain at the strength Um")?];
    let ultimate = compressive(a, "ultimate strain Uult")?;
    if ultimate >= peak[1] {
        let label = format!("expected it beyond Um, {}", peak[1]);
        return Err(a.refuse(format!("the ultimate strain Uult is {ultimate}"), label));
    }
    let closing = a.number(&UCL)?;
    let (modulus, length) = (a.number(&EMO)?, a.number(&MASONRY_L)?);
    let area = [a.number(&A1)?, a.number(&A2)?];
    let shortening = [a.number(&MASONRY_D1)?, a.number(&MASONRY_D2)?];
    if area[0] != area[1] && shortening[1] >= shortening[0] {
        let label = format!("expected less than D1, {}", shortening[0]);
        return Err(a.refuse(format!("the shortening D2 is {}", shortening[1]), label));
    }
    let (a_ch, a_re) = (a.number(&ACH)?, a.number(&ARE)?);
    let (b_a, b_ch) = (a.number(&BA)?, a.number(&BCH)?);
    let slopes = [a.number(&GUN)?, a.number(&GPLU)?, a.number(&GPLR)?];
    let exponents = [a.number(&EXP1)?, a.number(&EXP2)?];
    let parabola = match a.int(MASONRY_IENV.meaning)? {
        1 => true,
        2 => false,
        n => return Err(a.refuse(format!("the envelope has no shape {n}"), "expected 1 (parabola) or 2 (Sargin)")),
    };
    let compat = interp.host.follows(&[slips::MASONRY_SLOPES]);
    Ok(Masonry {
        peak,
        ft,
        ultimate,
        closing,
        modulus,
        length,
        area,
        shortening,
        a_ch,
        a_re,
        b_a,
        b_ch,
        slopes,
        exponents,
        parabola,
        compat,
    }
    .shared())
}
