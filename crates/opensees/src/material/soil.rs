//! Springs between piles and soil.

use super::Kind;
use super::by_rules::by_rules;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    HyperbolicGap, Material, PyBackbone, PySimple1, QzBackbone, QzSimple1, SoilSpring, TzBackbone, TzSimple1,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const PY: [Arg; 3] = [
    Arg::positive("pult", "ultimate resistance pult"),
    Arg::positive("Y50", "displacement Y50 at half of the ultimate resistance"),
    Arg::not_negative("Cd", "drag resistance Cd within a gap, as a part of the ultimate one"),
];
const PY_TYPE: Arg = Arg::of_domain("soilType", "soil type", Domain::Whole);
const TZ: [Arg; 2] = [
    Arg::positive("tult", "ultimate resistance tult"),
    Arg::positive("z50", "displacement z50 at half of the ultimate resistance"),
];
const TZ_TYPE: Arg = Arg::of_domain("tzType", "type of the t-z spring", Domain::Whole);
const QZ: [Arg; 2] = [
    Arg::positive("qult", "ultimate resistance qult"),
    Arg::positive("Z50", "displacement Z50 at half of the ultimate resistance"),
];
const QZ_TYPE: Arg = Arg::of_domain("qzType", "type of the q-z spring", Domain::Whole);
const SUCTION: Arg = Arg::not_negative("suction", "suction, the resistance in uplift as a part of the ultimate one");
const DASHPOT: Arg = Arg::not_negative("c", "dashpot coefficient c");

const KMAX: Arg = Arg::not_negative("Kmax", "initial stiffness Kmax");
const HYPERBOLA: [Arg; 2] =
    [Arg::positive("Kur", "stiffness Kur of unloading and reloading"), Arg::number("Rf", "failure ratio Rf")];
const FULT: Arg = Arg::number("Fult", "ultimate force Fult");
const GAP: Arg = Arg::number("gap", "gap");

pub(super) const KINDS: &[Kind] =
    &[
        Kind {
            names: &["PySimple1"],
            usage: "uniaxialMaterial PySimple1 $tag $soilType $pult $Y50 $Cd <$c>",
            text: Text::new("Lateral spring between pile and soil.")
                .example("uniaxialMaterial PySimple1 77 1 1 1 1")
                .groups(&[&[PY_TYPE], &PY, &[DASHPOT]]),
            make: py_simple1,
        },
        Kind {
            names: &["TzSimple1"],
            usage: "uniaxialMaterial TzSimple1 $tag $tzType $tult $z50 <$c>",
            text: Text::new("Shaft spring between pile and soil.")
                .example("uniaxialMaterial TzSimple1 77 1 1 1")
                .groups(&[&[TZ_TYPE], &TZ, &[DASHPOT]]),
            make: tz_simple1,
        },
        Kind {
            names: &["QzSimple1"],
            usage: "uniaxialMaterial QzSimple1 $tag $qzType $qult $Z50 <$suction> <$c>",
            text: Text::new("Tip spring between pile and soil.")
                .example("uniaxialMaterial QzSimple1 77 1 1 1")
                .groups(&[&[QZ_TYPE], &QZ, &[SUCTION, DASHPOT]]),
            make: qz_simple1,
        },
        Kind {
            names: &["HyperbolicGapMaterial"],
            usage: "uniaxialMaterial HyperbolicGapMaterial $tag $Kmax $Kur $Rf $Fult $gap",
            text: Text::new("Backfill of an abutment: a hyperbola in compression behind a gap.")
                .example("uniaxialMaterial HyperbolicGapMaterial 77 200. 180. 0.7 -3. -0.02")
                .groups(&[&[KMAX], &HYPERBOLA, &[FULT, GAP]]),
            make: hyperbolic_gap,
        },
    ];

/// One of two backbones.
fn backbone<T>(a: &mut Args<'_>, arg: &Arg, kinds: [(&str, T); 2]) -> Result<T, Exception> {
    let what = arg.meaning;
    let number = a.int(what)?;
    let [one, two] = kinds;
    match number {
        1 => Ok(one.1),
        2 => Ok(two.1),
        _ => Err(a.refuse(format!("the {what} is {number}"), format!("expected 1 ({}) or 2 ({})", one.0, two.0))),
    }
}

/// A number that is zero where it is left out.
fn optional(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    if a.left() == 0 { Ok(0.0) } else { a.read(interp, arg) }
}

fn py_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("soft clay", PyBackbone::Clay), ("sand", PyBackbone::Sand)];
    let kind = backbone(a, &PY_TYPE, kinds)?;
    let [pult, y50, drag] = a.read_all(interp, &PY)?;
    let dashpot = optional(interp, a, &DASHPOT)?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: PySimple1::new(kind, pult, y50, drag), dashpot, compat }.shared())
}

fn tz_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("Reese and O'Neill", TzBackbone::ReeseONeill), ("Mosher", TzBackbone::Mosher)];
    let kind = backbone(a, &TZ_TYPE, kinds)?;
    let [tult, z50] = a.read_all(interp, &TZ)?;
    let dashpot = optional(interp, a, &DASHPOT)?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: TzSimple1::new(kind, tult, z50), dashpot, compat }.shared())
}

fn qz_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("clay", QzBackbone::Clay), ("sand", QzBackbone::Sand)];
    let kind = backbone(a, &QZ_TYPE, kinds)?;
    let [qult, z50] = a.read_all(interp, &QZ)?;
    let suction = optional(interp, a, &SUCTION)?;
    if suction > QzSimple1::MAX_SUCTION_RATIO {
        let message = format!("the suction {suction} is more than {}, which is taken", QzSimple1::MAX_SUCTION_RATIO);
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message).at(a.last_span(), "expected at most a tenth"),
        )?;
    }
    let dashpot = optional(interp, a, &DASHPOT)?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: QzSimple1::new(kind, qult, z50, suction), dashpot, compat }.shared())
}

/// Displacement at which the ultimate force is reached if the initial stiffness is zero.
const STIFFNESS_DISPLACEMENT: f64 = 0.002;

/// A number that is negative in compression; OpenSees turns the sign of a positive one.
fn negative(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    let (x, what) = (a.read(interp, arg)?, arg.meaning);
    if x > 0.0 {
        let d =
            Diagnostic::warning(&checks::words::REPLACED_VALUE, format!("the {what} is {x}: it is taken as {}", -x));
        warn(interp, d.at(a.last_span(), "expected a number less than 0"))?;
    }
    Ok(-x.abs())
}

fn hyperbolic_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut kmax = a.read(interp, &KMAX)?;
    let place = a.last_span();
    let [kur, rf] = a.read_all(interp, &HYPERBOLA)?;
    let fult = negative(interp, a, &FULT)?;
    if fult == 0.0 {
        return Err(a.refuse("the ultimate force Fult is 0", "expected a number less than 0"));
    }
    if kmax == 0.0 {
        kmax = -fult / STIFFNESS_DISPLACEMENT;
        let d = Diagnostic::warning(
            &checks::words::REPLACED_VALUE,
            format!("the initial stiffness Kmax is 0: it is taken as Fult / 0.002, {kmax}"),
        );
        warn(interp, d.at(place, "expected a number greater than 0"))?;
    }
    let gap = negative(interp, a, &GAP)?;
    Ok(by_rules!(interp, slips::HYPERBOLIC_GAP_TRIALS, rules => HyperbolicGap { kmax, kur, rf, fult, gap, rules }))
}
