//! `uniaxialMaterial Steel4`.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::material::{Material, Steel4, Steel4Side};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const KIN_BK: Arg = Arg::of("-kin", "bk", "kinematic hardening ratio bk").within(Domain::Number);
const RADII: [Arg; 3] = [
    Arg::of("-kin", "R0", "radius R0").within(Domain::Positive),
    Arg::of("-kin", "r1", "coefficient r1").within(Domain::NotNegative),
    Arg::of("-kin", "r2", "coefficient r2").within(Domain::Positive),
];
const ISOTROPIC: [Arg; 4] = [
    Arg::of("-iso", "bi", "isotropic hardening ratio bi").within(Domain::NotNegative),
    Arg::of("-iso", "rhoi", "position of the turn rhoi").within(Domain::Positive),
    Arg::of("-iso", "bl", "ratio of the bound bl").within(Domain::NotNegative),
    Arg::of("-iso", "Ri", "radius Ri").within(Domain::Positive),
];
const ISO_LYP: Arg = Arg::of("-iso", "lyp", "length of the yield plateau lyp").within(Domain::NotNegative);
const ULTIMATE: [Arg; 2] = [
    Arg::of("-ult", "fu", "ultimate strength fu").within(Domain::Positive),
    Arg::of("-ult", "Ru", "radius Ru").within(Domain::Positive),
];

const FY: Arg = Arg::positive("fy", "yield stress fy");
const STEEL4_E0: Arg = Arg::positive("E0", "elastic modulus E0");
const INIT_SIG0: Arg = Arg::of("-init", "sig0", "initial stress sig0").within(Domain::Number);
const MEM_CYCLES: Arg = Arg::of("-mem", "cycles", "cycles of the memory").within(Domain::Whole);

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["Steel4"],
    usage: "uniaxialMaterial Steel4 $tag $fy $E0 <-asym> <-kin $bk $R0 $r1 $r2 <$bkc $R0c $r1c $r2c>> \
            <-iso $bi $rhoi $bl $Ri $lyp <$bic $rhoic $blc $Ric>> <-ult $fu $Ru <$fuc $Ruc>> <-init $sig0> <-mem $cycles>",
    text: Text::new("Steel with asymmetric hardening, an ultimate strength and a memory of its cycles.")
        .example("uniaxialMaterial Steel4 77 355. 210000. -kin 0.01 20. 0.9 0.15")
        .arguments(&[
            FY,
            STEEL4_E0,
            Arg::flag("-asym", "what follows is given for tension, then for compression"),
            KIN_BK,
            ISO_LYP,
            INIT_SIG0,
            MEM_CYCLES,
        ])
        .groups(&[&RADII, &ISOTROPIC, &ULTIMATE]),
    make: steel4,
}];

/// Ultimate strength over the yield stress, where none is given.
const NO_LIMIT: f64 = 1e8;

/// Kinematic hardening of a side.
fn kinematic(a: &mut Args<'_>, side: &mut Steel4Side) -> Result<(), Exception> {
    side.b = a.number(&KIN_BK)?;
    if side.b >= 1.0 {
        return Err(a.refuse(format!("the hardening ratio bk is {}", side.b), "expected less than 1"));
    }
    side.r = a.numbers(&RADII)?;
    Ok(())
}

/// Isotropic hardening of a side; in tension the length of the yield plateau follows.
fn isotropic(a: &mut Args<'_>, side: &mut Steel4Side) -> Result<(), Exception> {
    let [first, rho, last, radius] = a.numbers(&ISOTROPIC)?;
    side.isotropic = [first, last, rho, radius];
    Ok(())
}

fn ultimate(a: &mut Args<'_>, side: &mut Steel4Side) -> Result<(), Exception> {
    [side.ultimate, side.ultimate_radius] = a.numbers(&ULTIMATE)?;
    Ok(())
}

/// One number of words for both sides, or one after the other.
fn both(
    a: &mut Args<'_>,
    sides: &mut [Steel4Side; 2],
    asymmetric: bool,
    take: impl Fn(&mut Args<'_>, &mut Steel4Side) -> Result<(), Exception>,
    same: impl Fn(&Steel4Side, &mut Steel4Side),
) -> Result<(), Exception> {
    let [tension, compression] = sides;
    take(a, tension)?;
    if asymmetric {
        return take(a, compression);
    }
    same(tension, compression);
    Ok(())
}

fn steel4(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (fy, e0) = (a.number(&FY)?, a.number(&STEEL4_E0)?);
    let virgin = Steel4Side {
        b: 0.0,
        r: [50.0, 0.1, 0.15],
        isotropic: [0.0, 0.0, 1.0, 50.0],
        ultimate: NO_LIMIT * fy,
        ultimate_radius: 50.0,
    };
    let (mut sides, mut plateau, mut remembers, mut initial) = ([virgin; 2], 0.0, true, 0.0);
    let mut asymmetric = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-asym" => asymmetric = true,
            "-kin" => both(a, &mut sides, asymmetric, kinematic, |t, c| (c.b, c.r) = (t.b, t.r))?,
            "-iso" => {
                isotropic(a, &mut sides[0])?;
                plateau = a.number(&ISO_LYP)?;
                sides[1].isotropic = sides[0].isotropic;
                if asymmetric {
                    isotropic(a, &mut sides[1])?;
                }
            }
            "-ult" => both(a, &mut sides, asymmetric, ultimate, |t, c| {
                (c.ultimate, c.ultimate_radius) = (t.ultimate, t.ultimate_radius);
            })?,
            "-mem" => remembers = a.int(MEM_CYCLES.meaning)? != 0,
            "-init" => initial = a.number(&INIT_SIG0)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(Steel4 { fy, e0, sides, plateau, remembers, initial }.shared())
}
