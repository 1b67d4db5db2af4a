//! High damping rubber by Kikuchi and Aiken: stiffness and damping are functions of the largest strain so far.
//!
//! Up to the strain [`STIFFENS`] the equivalent stiffness falls with the strain, so that rubber is stiffer on its first way
//! to a strain than on the next. Above it the rubber stiffens. The two ranges are forms of two causes. They overlap a little,
//! because the largest strain is known from the user's model alone.

use super::{LAWS_OF_RUBBER, LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use crate::hypothesis::materials::RUBBERS;

const REPLACES: Replaces = Replaces::Shear { kinds: LAWS_OF_RUBBER, bearings: true };
const COMMAND: &str = "KikuchiAikenHDR {tag} X0.6 $::hy_area $::hy_height -coGHU 1.0 $::hy_damping $::hy_share";
const SOURCE: &str = "Kikuchi and Aiken (1997); coefficients of the compound: Ishii and Kikuchi (2012)";
const STRAINS: &str = "bearings are designed for strains up to 2.5, and tested up to 4 (Kikuchi and Aiken 1997)";
const COMPOUNDS: &str = "the equivalent damping of high damping rubber is 0.08 to 0.24 (Naeim and Kelly 1999)";

/// Shear strain at which the equivalent modulus of the compound is least.
const STIFFENS: f64 = 2.0;
/// Area for a unit of force at a stress of the compound. The bounds follow no source, since the baseline's force may be off.
const fn area(stress: f64) -> LawParameter {
    let area = 1.0 / stress;
    LawParameter::log("area", area, [0.2 * area, 5.0 * area], LawUnit::Force, "the force of the user's device")
}

const fn damping() -> LawParameter {
    LawParameter::log("damping", 0.8, [0.25, 1.4], LawUnit::One, COMPOUNDS)
}

const fn share() -> LawParameter {
    LawParameter::log("share", 0.9, [0.25, 1.8], LawUnit::One, COMPOUNDS)
}

/// Height of the rubber for a range of the largest strain.
const fn height(start: f64, [least, most]: [f64; 2]) -> LawParameter {
    LawParameter::log("height", 1.0 / start, [1.0 / most, 1.0 / least], LawUnit::Deformation, STRAINS)
}

pub(super) const SOFTENING: WholeLaw = WholeLaw {
    cause: "mullins_softening",
    form: "high damping rubber by Kikuchi and Aiken in the place of the law",
    replaces: REPLACES,
    materials: RUBBERS,
    command: COMMAND,
    parameters: &[area(0.89e6), height(1.5, [0.15, 1.15 * STIFFENS]), damping(), share()],
    phenomena: &[],
    basis: "stiffness that falls with the largest strain so far, and loops whose damping depends on it",
    source: SOURCE,
};

pub(super) const STIFFENING: WholeLaw = WholeLaw {
    cause: "strain_stiffening",
    form: "high damping rubber by Kikuchi and Aiken in the place of the law",
    replaces: REPLACES,
    materials: RUBBERS,
    command: COMMAND,
    parameters: &[area(1.53e6), height(2.6, [STIFFENS, 4.0]), damping(), share()],
    phenomena: &[Phenomenon {
        name: "stiffening at large strain",
        cause: Some("strain_stiffening"),
        neutral: &[("height", 1.0 / STIFFENS)],
    }],
    basis: "stiffness that falls with the largest strain so far, and loops whose damping depends on it",
    source: SOURCE,
};
