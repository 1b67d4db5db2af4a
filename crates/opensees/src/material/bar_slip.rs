//! `uniaxialMaterial BarSlip`.

use super::Kind;
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Text};
use hysteron_engine::material::{BarPlace, BarSlip, Bond, BondDamage, Material, Pinching4, StressUnit};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const ANC_LRATIO: Arg = Arg::positive("ancLratio", "part of the anchorage length ancLratio");

const FC: Arg = Arg::number("fc", "strength of the concrete fc");
const STEEL: [Arg; 3] = [
    Arg::positive("fy", "yield stress fy"),
    Arg::positive("Es", "elastic modulus Es"),
    Arg::positive("fu", "ultimate stress fu"),
];
const BARS: [Arg; 6] = [
    Arg::positive("Eh", "hardening modulus Eh"),
    Arg::positive("db", "diameter of a bar db"),
    Arg::positive("ld", "anchorage length ld"),
    Arg::positive("nb", "number of bars nb"),
    Arg::positive("width", "width of the member"),
    Arg::positive("depth", "depth of the member"),
];

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["BarSlip"],
    usage: "uniaxialMaterial BarSlip $tag $fc $fy $Es $fu $Eh $db $ld $nb $width $depth <$ancLratio> strong|weak \
            beamTop|beamBot|column <Damage1|Damage2|NoDamage $unit>",
    text: Text::new("Slip of bars anchored in a joint: `Pinching4` with a backbone from the bond.")
        .example(
            "uniaxialMaterial BarSlip 77 30. 450. 200000. 600. 4000. 20. 400. 4 400. 400. strong \
                beamTop",
        )
        .arguments(&[
            FC,
            ANC_LRATIO,
            Arg::new("unit", "unit of stress: `MPa`, `psi`, `Pa`, `psf`, `ksi` or `ksf`; that of length follows"),
        ])
        .groups(&[&STEEL, &BARS]),
    make: bar_slip,
}];

/// Strength of concrete from which the stresses are taken for psi, not MPa.
const LEAST_PSI: f64 = 1000.0;

/// One of some words, whatever their capitals.
fn one_of<T: Copy>(a: &mut Args<'_>, what: &str, words: &[(&'static str, T)]) -> Result<T, Exception> {
    let word = a.word(what)?;
    let found = words.iter().find(|(name, _)| name.eq_ignore_ascii_case(&word));
    found.map(|f| f.1).ok_or_else(|| a.unknown_name(what, words.iter().map(|w| w.0)))
}

const PLACES: &[(&str, BarPlace)] = &[
    ("beamTop", BarPlace::Beam),
    ("beam", BarPlace::Beam),
    ("beamBot", BarPlace::Beam),
    ("beamBottom", BarPlace::Beam),
    ("column", BarPlace::Column),
];

const DAMAGES: &[(&str, BondDamage)] =
    &[("Damage1", BondDamage::Linear), ("Damage2", BondDamage::Power), ("NoDamage", BondDamage::None)];

const UNITS: &[(&str, StressUnit)] = &[
    ("MPa", StressUnit::Mpa),
    ("psi", StressUnit::Psi),
    ("Pa", StressUnit::Pa),
    ("psf", StressUnit::Psf),
    ("ksi", StressUnit::Ksi),
    ("ksf", StressUnit::Ksf),
];

fn bar_slip(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fc = a.number(&FC)?.abs();
    if fc == 0.0 {
        return Err(a.refuse("the strength of the concrete fc is 0", "expected another number"));
    }
    let [fy, es, fu] = a.numbers(&STEEL)?;
    if fu <= fy {
        return Err(a.refuse(format!("the ultimate stress fu is {fu}"), format!("expected more than fy, {fy}")));
    }
    let [eh, diameter, mut anchorage, bars, width, depth] = a.numbers(&BARS)?;
    if a.at_number() {
        anchorage *= a.number(&ANC_LRATIO)?;
    }
    let bond = one_of(a, "bond", &[("strong", Bond::Strong), ("weak", Bond::Weak)])?;
    let place = one_of(a, "place of the bars", PLACES)?;
    let (mut damage, mut unit) = (BondDamage::Linear, if fc >= LEAST_PSI { StressUnit::Psi } else { StressUnit::Mpa });
    if a.left() > 0 {
        (damage, unit) = (one_of(a, "damage", DAMAGES)?, one_of(a, "unit of stress", UNITS)?);
    }
    let (bars, member) = (bars.trunc(), [width, depth]);
    let slip = BarSlip { fc, fy, es, fu, eh, diameter, anchorage, bars, member, bond, place, damage, unit };
    let given = slip.pinching();
    Ok(match interp.host.follows(&[slips::PINCHING_TRIALS]) {
        true => Pinching4::as_opensees(given).shared(),
        false => Pinching4::new(given).shared(),
    })
}
