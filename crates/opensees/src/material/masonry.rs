//! `uniaxialMaterial Masonry`.

use super::Kind;
use crate::args::Args;
use crate::text::Text;
use crate::{Tcl, slips};
use hysteron_engine::material::{Masonry, Material};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["Masonry"],
    usage: "uniaxialMaterial Masonry $tag $Fm $Ft $Um $Uult $Ucl $Emo $L $a1 $a2 $D1 $D2 $Ach $Are $Ba $Bch $Gun $Gplu $Gplr \
            $Exp1 $Exp2 $IENV",
    text: Text::new("Force and shortening of a strut of masonry in a frame (Crisafulli).").example(
        "uniaxialMaterial Masonry 77 -5. 0.2 -0.002 -0.01 0.001 5000. 2. 0.3 0.2 -0.003 -0.008 0.3 0.4 1.5 \
         0.7 1.5 0.6 1.1 1.5 1. 1",
    ),
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
    let (fm, ft) = (compressive(a, "compressive strength Fm")?, a.not_negative("tensile strength Ft")?);
    let peak = [fm, compressive(a, "strain at the strength Um")?];
    let ultimate = compressive(a, "ultimate strain Uult")?;
    if ultimate >= peak[1] {
        let label = format!("expected it beyond Um, {}", peak[1]);
        return Err(a.refuse(format!("the ultimate strain Uult is {ultimate}"), label));
    }
    let closing = a.float("strain Ucl at which cracks are closed")?;
    let (modulus, length) = (a.positive("initial modulus Emo")?, a.positive("length L of the strut")?);
    let area = [a.positive("initial area a1")?, a.positive("last area a2")?];
    let shortening =
        [a.float("shortening D1 where the area begins to change")?, a.float("shortening D2 at the last area")?];
    if area[0] != area[1] && shortening[1] >= shortening[0] {
        let label = format!("expected less than D1, {}", shortening[0]);
        return Err(a.refuse(format!("the shortening D2 is {}", shortening[1]), label));
    }
    let (a_ch, a_re) = (a.float("factor Ach")?, a.not_negative("factor Are")?);
    let (b_a, b_ch) = (a.positive("factor Ba of the focal point")?, a.positive("factor Bch")?);
    let slopes = [
        a.positive("ratio Gun of the slope of unloading")?,
        a.positive("ratio Gplu of the slope at the end of unloading")?,
        a.positive("ratio Gplr of the slope at the beginning of reloading")?,
    ];
    let exponents = [a.float("exponent Exp1 of the slopes")?, a.float("exponent Exp2 of inner cycles")?];
    let parabola = match a.int("shape IENV of the envelope")? {
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
