//! Springs between piles and soil.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    HyperbolicGap, Material, PyBackbone, PySimple1, QzBackbone, QzSimple1, SoilSpring, TzBackbone, TzSimple1,
};
use hysteron_engine::rules::{Consistent, OpenSees};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["PySimple1"],
        usage: "uniaxialMaterial PySimple1 $tag $soilType $pult $Y50 $Cd <$c>",
        text: Text::new("Lateral spring between pile and soil."),
        make: py_simple1,
    },
    Kind {
        names: &["TzSimple1"],
        usage: "uniaxialMaterial TzSimple1 $tag $tzType $tult $z50 <$c>",
        text: Text::new("Shaft spring between pile and soil."),
        make: tz_simple1,
    },
    Kind {
        names: &["QzSimple1"],
        usage: "uniaxialMaterial QzSimple1 $tag $qzType $qult $Z50 <$suction> <$c>",
        text: Text::new("Tip spring between pile and soil.").arguments(&[
            Arg::new("suction", "resistance in uplift over the ultimate one"),
            Arg::new("c", "viscous coefficient"),
        ]),
        make: qz_simple1,
    },
    Kind {
        names: &["HyperbolicGapMaterial"],
        usage: "uniaxialMaterial HyperbolicGapMaterial $tag $Kmax $Kur $Rf $Fult $gap",
        text: Text::new("Backfill of an abutment: a hyperbola in compression behind a gap.")
            .example("uniaxialMaterial HyperbolicGapMaterial 77 200. 180. 0.7 -3. -0.02"),
        make: hyperbolic_gap,
    },
];

/// One of two backbones.
fn backbone<T>(a: &mut Args<'_>, what: &str, kinds: [(&str, T); 2]) -> Result<T, Exception> {
    let number = a.int(what)?;
    let [one, two] = kinds;
    match number {
        1 => Ok(one.1),
        2 => Ok(two.1),
        _ => Err(a.refuse(format!("the {what} is {number}"), format!("expected 1 ({}) or 2 ({})", one.0, two.0))),
    }
}

/// A number that is zero where it is left out.
fn optional(a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    if a.left() == 0 { Ok(0.0) } else { a.not_negative(what) }
}

fn py_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("soft clay", PyBackbone::Clay), ("sand", PyBackbone::Sand)];
    let kind = backbone(a, "soil type", kinds)?;
    let pult = a.positive("ultimate resistance pult")?;
    let y50 = a.positive("displacement Y50 at half of the ultimate resistance")?;
    let drag = a.not_negative("drag resistance Cd within a gap, as a part of the ultimate one")?;
    let dashpot = optional(a, "dashpot coefficient c")?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: PySimple1::new(kind, pult, y50, drag), dashpot, compat }.shared())
}

fn tz_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("Reese and O'Neill", TzBackbone::ReeseONeill), ("Mosher", TzBackbone::Mosher)];
    let kind = backbone(a, "type of the t-z spring", kinds)?;
    let tult = a.positive("ultimate resistance tult")?;
    let z50 = a.positive("displacement z50 at half of the ultimate resistance")?;
    let dashpot = optional(a, "dashpot coefficient c")?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: TzSimple1::new(kind, tult, z50), dashpot, compat }.shared())
}

fn qz_simple1(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kinds = [("clay", QzBackbone::Clay), ("sand", QzBackbone::Sand)];
    let kind = backbone(a, "type of the q-z spring", kinds)?;
    let qult = a.positive("ultimate resistance qult")?;
    let z50 = a.positive("displacement Z50 at half of the ultimate resistance")?;
    let suction = optional(a, "suction, the resistance in uplift as a part of the ultimate one")?;
    if suction > QzSimple1::MAX_SUCTION_RATIO {
        let message = format!("the suction {suction} is more than {}, which is taken", QzSimple1::MAX_SUCTION_RATIO);
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message).at(a.last_span(), "expected at most a tenth"),
        )?;
    }
    let dashpot = optional(a, "dashpot coefficient c")?;
    let compat = interp.host.follows(&[slips::SOIL_SPRING_ROUNDS]);
    Ok(SoilSpring { soil: QzSimple1::new(kind, qult, z50, suction), dashpot, compat }.shared())
}

/// Displacement at which the ultimate force is reached if the initial stiffness is zero.
const STIFFNESS_DISPLACEMENT: f64 = 0.002;

/// A number that is negative in compression; OpenSees turns the sign of a positive one.
fn negative(interp: &mut Tcl, a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    let x = a.float(what)?;
    if x > 0.0 {
        let d =
            Diagnostic::warning(&checks::words::REPLACED_VALUE, format!("the {what} is {x}: it is taken as {}", -x));
        warn(interp, d.at(a.last_span(), "expected a number less than 0"))?;
    }
    Ok(-x.abs())
}

fn hyperbolic_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let mut kmax = a.not_negative("initial stiffness Kmax")?;
    let place = a.last_span();
    let kur = a.positive("stiffness Kur of unloading and reloading")?;
    let rf = a.float("failure ratio Rf")?;
    let fult = negative(interp, a, "ultimate force Fult")?;
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
    let gap = negative(interp, a, "gap")?;
    if interp.host.follows(&[slips::HYPERBOLIC_GAP_TRIALS]) {
        return Ok(HyperbolicGap { kmax, kur, rf, fult, gap, rules: OpenSees }.shared());
    }
    Ok(HyperbolicGap { kmax, kur, rf, fult, gap, rules: Consistent }.shared())
}
