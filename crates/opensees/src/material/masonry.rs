//! `uniaxialMaterial Masonry`.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Text};
use crate::{Tcl, slips};
use hysteron_engine::material::{Masonry, Material};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const FT: Arg = Arg::not_negative("Ft", "tensile strength Ft");
const SHAPE: [Arg; 7] = [
    Arg::number("Ucl", "strain Ucl at which cracks are closed"),
    Arg::positive("Emo", "initial modulus Emo"),
    Arg::positive("L", "length L of the strut"),
    Arg::positive("a1", "initial area a1"),
    Arg::positive("a2", "last area a2"),
    Arg::number("D1", "shortening D1 where the area begins to change"),
    Arg::number("D2", "shortening D2 at the last area"),
];
const CYCLES: [Arg; 9] = [
    Arg::number("Ach", "factor Ach"),
    Arg::not_negative("Are", "factor Are"),
    Arg::positive("Ba", "factor Ba of the focal point"),
    Arg::positive("Bch", "factor Bch"),
    Arg::positive("Gun", "ratio Gun of the slope of unloading"),
    Arg::positive("Gplu", "ratio Gplu of the slope at the end of unloading"),
    Arg::positive("Gplr", "ratio Gplr of the slope at the beginning of reloading"),
    Arg::number("Exp1", "exponent Exp1 of the slopes"),
    Arg::number("Exp2", "exponent Exp2 of inner cycles"),
];
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
            MASONRY_IENV,
        ])
        .groups(&[&SHAPE, &CYCLES]),
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
    let [closing, modulus, length, a1, a2, d1, d2] = a.numbers(&SHAPE)?;
    if a1 != a2 && d2 >= d1 {
        return Err(a.refuse(format!("the shortening D2 is {d2}"), format!("expected less than D1, {d1}")));
    }
    let [a_ch, a_re, b_a, b_ch, gun, gplu, gplr, exp1, exp2] = a.numbers(&CYCLES)?;
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
        area: [a1, a2],
        shortening: [d1, d2],
        a_ch,
        a_re,
        b_a,
        b_ch,
        slopes: [gun, gplu, gplr],
        exponents: [exp1, exp2],
        parabola,
        compat,
    }
    .shared())
}
