//! Friction of a slider whose coefficient falls with the axial force.

use super::{LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use hysteron_identify::study::DeviceMaterial;

pub(super) const BOWDEN: &str =
    "contact of elastic asperities: 2/3 to 1 (Bowden and Tabor 1950, in Constantinou and others 2007)";

pub(super) const FALL: Phenomenon = Phenomenon {
    name: "fall of the coefficient with the axial force",
    cause: Some("varying_axial_load"),
    neutral: &[("exponent", 1.0)],
};

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "varying_axial_load",
    form: "a friction force that grows with a power of the axial force in the place of a proportional one",
    replaces: Replaces::Friction(&["Coulomb", "Constant"]),
    materials: &[DeviceMaterial::Sliding],
    command: "VelNormalFrcDep {tag} [expr {({old})*pow({axial},1.0-$::hy_exponent)}] $::hy_exponent \
              [expr {({old})*pow({axial},1.0-$::hy_exponent)}] $::hy_exponent 0.0 0.0 0.0 3.0",
    parameters: &[LawParameter::linear("exponent", 0.8, [0.5, 1.0], LawUnit::One, BOWDEN)],
    phenomena: &[FALL],
    basis: "a constant coefficient",
    source: "OpenSees' manual, VelNormalFrcDep",
};
