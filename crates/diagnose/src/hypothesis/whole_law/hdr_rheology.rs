//! High damping rubber as a rheology: friction, stiffening, and an overstress that depends on the rate.
//!
//! The numbers are those of the compound HDR3 at 23 degrees. Factors move each of the three parts.

use super::{LAWS_OF_RUBBER, LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use crate::hypothesis::materials::RUBBERS;

/// Least factor of a part: it is absent.
const ABSENT: f64 = 1e-3;
/// Stress of the compound at a strain of one and some rate.
const AREA: f64 = 1.0 / 2.0;
const COMPOUNDS: &str =
    "Nguyen, dissertation, Tables 3.1 and 3.2: HDR2 and HDR3 at -30 to 23 degrees differ by factors up to 3";

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "rate_dependence",
    form: "high damping rubber as a rheology in the place of the law",
    replaces: Replaces::Shear { kinds: LAWS_OF_RUBBER, bearings: true },
    materials: RUBBERS,
    command: "HDRRheology {tag} [expr {$::hy_friction*7.12}] 0.486 [expr {$::hy_stiffening*0.0079}] \
              [expr {$::hy_friction*0.355}] 5.03 [expr {$::hy_overstress*10.2}] [expr {$::hy_overstress*0.652}] \
              [expr {$::hy_overstress*0.711}] [expr {$::hy_overstress*1.45}] 0.238 -area $::hy_area -height $::hy_height",
    parameters: &[
        LawParameter::log("area", AREA, [0.1 * AREA, 10.0 * AREA], LawUnit::Force, "the force of the user's device"),
        LawParameter::log("height", 0.7, [0.25, 5.0], LawUnit::Deformation, "tests go up to a strain of 2.5 (Nguyen)"),
        LawParameter::log("friction", 1.0, [0.1, 5.0], LawUnit::One, COMPOUNDS),
        LawParameter::log("overstress", 0.5, [0.02, 5.0], LawUnit::One, COMPOUNDS),
        LawParameter::linear("stiffening", 1.0, [0.0, 5.0], LawUnit::One, COMPOUNDS),
    ],
    phenomena: &[
        Phenomenon { name: "overstress", cause: Some("rate_dependence"), neutral: &[("overstress", ABSENT)] },
        Phenomenon { name: "friction", cause: Some("friction"), neutral: &[("friction", ABSENT)] },
        Phenomenon {
            name: "stiffening at large strain",
            cause: Some("strain_stiffening"),
            neutral: &[("stiffening", 0.0)],
        },
    ],
    basis: "a linear spring",
    source: "Nguyen, A rheology model of high damping rubber bearings, dissertation, Eqs 3.1 to 3.13",
};
