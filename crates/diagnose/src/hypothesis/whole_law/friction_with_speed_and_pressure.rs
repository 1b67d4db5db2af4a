//! Friction of a slider that grows with the speed, and whose coefficient falls with the axial force.

use super::friction_with_pressure::{BOWDEN, FALL};
use super::friction_with_speed::{GROWTH, RATES, TESTS};
use super::{LawParameter, LawUnit, Replaces, WholeLaw};
use hysteron_identify::study::DeviceMaterial;

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "rate_dependence",
    form: "friction that grows with the speed and with a power of the axial force in the place of a proportional one",
    replaces: Replaces::Friction(&["Coulomb", "Constant"]),
    materials: &[DeviceMaterial::Sliding],
    command: "VelNormalFrcDep {tag} [expr {$::hy_slow*({old})*pow({axial},1.0-$::hy_exponent)}] $::hy_exponent \
              [expr {({old})*pow({axial},1.0-$::hy_exponent)}] $::hy_exponent $::hy_rate 0.0 0.0 3.0",
    parameters: &[
        LawParameter::linear("slow", 0.5, [0.1, 1.0], LawUnit::One, TESTS),
        LawParameter::log("rate", 10.0, [1.0, 300.0], LawUnit::PerSpeed, RATES),
        LawParameter::linear("exponent", 0.8, [0.5, 1.0], LawUnit::One, BOWDEN),
    ],
    phenomena: &[GROWTH, FALL],
    basis: "a constant coefficient",
    source: "OpenSees' manual, VelNormalFrcDep",
};
