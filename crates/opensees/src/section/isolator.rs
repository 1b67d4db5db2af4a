//! Sections of isolators: `section Bidirectional`, `Elliptical` and `Isolator2spring`.

use super::{Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::section::{Bidirectional, Elliptical, Resultant, SharedSection, TwoSpringIsolator};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const PLASTIC: [Arg; 4] = [
    Arg::positive("E", "elastic stiffness E"),
    Arg::positive("Fy", "yield force Fy"),
    Arg::number("Hiso", "isotropic hardening Hiso"),
    Arg::number("Hkin", "kinematic hardening Hkin"),
];
const ELLIPSE: [Arg; 7] = [
    Arg::positive("E1", "elastic stiffness E1"),
    Arg::positive("E2", "elastic stiffness E2"),
    Arg::positive("Fy1", "yield force Fy1"),
    Arg::positive("Fy2", "yield force Fy2"),
    Arg::not_negative("Hiso", "isotropic hardening Hiso"),
    Arg::not_negative("Hkin1", "kinematic hardening Hkin1"),
    Arg::not_negative("Hkin2", "kinematic hardening Hkin2"),
];
const SHEAR: [Arg; 4] = [
    Arg::positive("tol", "tolerance tol"),
    Arg::positive("k1", "initial stiffness k1"),
    Arg::positive("Fyo", "strength Fyo"),
    Arg::positive("k2o", "stiffness after yielding k2o"),
];
const AXIAL: [Arg; 3] = [
    Arg::positive("kvo", "vertical stiffness kvo"),
    Arg::positive("hb", "height hb"),
    Arg::positive("PE", "Euler load PE"),
];
const REFERENCE: Arg = Arg::number("Po", "reference axial load Po");

pub(super) const BIDIRECTIONAL: Kind = Kind {
    names: &["Bidirectional"],
    usage: "section Bidirectional $tag $E $Fy $Hiso $Hkin <$code1 $code2>",
    text: Text::new("Two resultants that yield together, with isotropic and kinematic hardening.")
        .example("section Bidirectional 77 1 1 1 1")
        .arguments(&[
            Arg::new("code1", "first resultant: `P`, `Mz`, `Vy`, `My`, `Vz` or `T`"),
            Arg::new("code2", "second resultant"),
        ])
        .groups(&[&PLASTIC]),
    make: Make::Beam(bidirectional),
};

pub(super) const ELLIPTICAL: Kind = Kind {
    names: &["Elliptical", "Elliptical2"],
    usage: "section Elliptical $tag $E1 $E2 $Fy1 $Fy2 $Hiso $Hkin1 $Hkin2 <$code1 $code2>",
    text: Text::new("Two resultants that yield together on an ellipse, each with its own stiffness and strength.")
        .example("section Elliptical 77 1 1 1 1 1 1 1")
        .arguments(&[
            Arg::new("code1", "first resultant: `P`, `Mz`, `Vy`, `My`, `Vz` or `T`; `Mz` where both are left out"),
            Arg::new("code2", "second resultant; `Vy` where both are left out"),
        ])
        .groups(&[&ELLIPSE]),
    make: Make::Beam(elliptical),
};

pub(super) const TWO_SPRINGS: Kind = Kind {
    names: &["Isolator2spring", "Iso2spring"],
    usage: "section Isolator2spring $tag $tol $k1 $Fyo $k2o $kvo $hb $PE <$Po>",
    text: Text::new("An elastomeric bearing of two springs that buckles, for `zeroLengthSection` in the plane.")
        .example("section Isolator2spring 77 1 1 1 0.5 1 1 1")
        .groups(&[&SHEAR, &AXIAL, &[REFERENCE]]),
    make: Make::Beam(two_springs),
};

fn resultant(a: &mut Args<'_>, what: &str) -> Result<Resultant, Exception> {
    let word = a.word(what)?;
    let found = Resultant::ALL.into_iter().find(|r| r.name() == word);
    found.ok_or_else(|| a.unknown_name("resultant", Resultant::ALL.map(Resultant::name)))
}

fn bidirectional(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let [e, yield_force, isotropic, kinematic] = a.read_all(interp, &PLASTIC)?;
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

fn elliptical(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let [e1, e2, fy1, fy2, isotropic, h1, h2] = a.read_all(interp, &ELLIPSE)?;
    let resultants = resultants(a, [Resultant::Mz, Resultant::Vy])?;
    let (e, yield_force, kinematic) = ([e1, e2], [fy1, fy2], [h1, h2]);
    Ok(Elliptical { e, yield_force, isotropic, kinematic, resultants }.shared())
}

fn two_springs(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let [tolerance, k1, strength, k2] = a.read_all(interp, &SHEAR)?;
    if k2 >= k1 {
        return Err(
            a.refuse(format!("the stiffness after yielding k2o is {k2}"), format!("expected less than k1, {k1}"))
        );
    }
    let [kv, height, euler] = a.read_all(interp, &AXIAL)?;
    let reference = a.read_or(interp, &REFERENCE, 0.0)?;
    Ok(TwoSpringIsolator { tolerance, k1, strength, k2, kv, height, euler, reference }.shared())
}
