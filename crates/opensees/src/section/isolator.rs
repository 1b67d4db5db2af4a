//! Sections of isolators: `section Bidirectional`, `Elliptical` and `Isolator2spring`.

use super::{Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::section::{Bidirectional, Elliptical, Resultant, SharedSection, TwoSpringIsolator};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

pub(super) const BIDIRECTIONAL: Kind = Kind {
    names: &["Bidirectional"],
    usage: "section Bidirectional $tag $E $Fy $Hiso $Hkin <$code1 $code2>",
    text: Text::new("Two resultants that yield together, with isotropic and kinematic hardening.").arguments(&[
        Arg::new("code1", "first resultant: `P`, `Mz`, `Vy`, `My`, `Vz` or `T`"),
        Arg::new("code2", "second resultant"),
    ]),
    make: Make::Beam(bidirectional),
};

pub(super) const ELLIPTICAL: Kind = Kind {
    names: &["Elliptical", "Elliptical2"],
    usage: "section Elliptical $tag $E1 $E2 $Fy1 $Fy2 $Hiso $Hkin1 $Hkin2 <$code1 $code2>",
    text: Text::new("Two resultants that yield together on an ellipse, each with its own stiffness and strength.")
        .arguments(&[
            Arg::new("E1", "elastic stiffness of the first resultant, and E2 of the second"),
            Arg::new("Fy1", "yield force of the first resultant alone, and Fy2 of the second"),
            Arg::new("Hiso", "isotropic hardening, as a part of the size of the yield surface"),
            Arg::new("Hkin1", "kinematic hardening modulus of the first resultant, and Hkin2 of the second"),
            Arg::new("code1", "first resultant: `P`, `Mz`, `Vy`, `My`, `Vz` or `T`; `Mz` where both are left out"),
            Arg::new("code2", "second resultant; `Vy` where both are left out"),
        ]),
    make: Make::Beam(elliptical),
};

pub(super) const TWO_SPRINGS: Kind = Kind {
    names: &["Isolator2spring", "Iso2spring"],
    usage: "section Isolator2spring $tag $tol $k1 $Fyo $k2o $kvo $hb $PE <$Po>",
    text: Text::new("An elastomeric bearing of two springs that buckles, for `zeroLengthSection` in the plane."),
    make: Make::Beam(two_springs),
};

fn resultant(a: &mut Args<'_>, what: &str) -> Result<Resultant, Exception> {
    let word = a.word(what)?;
    let found = Resultant::ALL.into_iter().find(|r| r.name() == word);
    found.ok_or_else(|| a.unknown_name("resultant", Resultant::ALL.map(Resultant::name)))
}

fn bidirectional(_: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let (e, yield_force) = (a.positive("elastic stiffness E")?, a.positive("yield force Fy")?);
    let (isotropic, kinematic) = (a.float("isotropic hardening Hiso")?, a.float("kinematic hardening Hkin")?);
    if e + isotropic + kinematic <= 0.0 {
        return Err(a.refuse("the hardening is not greater than -E", "expected more"));
    }
    let resultants = resultants(a, [Resultant::Vy, Resultant::P])?;
    Ok(Bidirectional { e, yield_force, isotropic, kinematic, resultants }.shared())
}

/// Two resultants by their names, or those of a section without names.
fn resultants(a: &mut Args<'_>, mut resultants: [Resultant; 2]) -> Result<[Resultant; 2], Exception> {
    if a.left() > 1 {
        resultants = [resultant(a, "first resultant code1")?, resultant(a, "second resultant code2")?];
    }
    if resultants[0] == resultants[1] {
        return Err(a.refuse("both resultants are the same", "expected another one"));
    }
    Ok(resultants)
}

fn elliptical(_: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let e = [a.positive("elastic stiffness E1")?, a.positive("elastic stiffness E2")?];
    let yield_force = [a.positive("yield force Fy1")?, a.positive("yield force Fy2")?];
    let isotropic = a.not_negative("isotropic hardening Hiso")?;
    let kinematic = [a.not_negative("kinematic hardening Hkin1")?, a.not_negative("kinematic hardening Hkin2")?];
    let resultants = resultants(a, [Resultant::Mz, Resultant::Vy])?;
    Ok(Elliptical { e, yield_force, isotropic, kinematic, resultants }.shared())
}

fn two_springs(_: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let tolerance = a.positive("tolerance tol")?;
    let (k1, strength) = (a.positive("initial stiffness k1")?, a.positive("strength Fyo")?);
    let k2 = a.positive("stiffness after yielding k2o")?;
    if k2 >= k1 {
        return Err(
            a.refuse(format!("the stiffness after yielding k2o is {k2}"), format!("expected less than k1, {k1}"))
        );
    }
    let (kv, height) = (a.positive("vertical stiffness kvo")?, a.positive("height hb")?);
    let euler = a.positive("Euler load PE")?;
    let reference = a.optional_float("reference axial load Po")?.unwrap_or(0.0);
    Ok(TwoSpringIsolator { tolerance, k1, strength, k2, kv, height, euler, reference }.shared())
}
