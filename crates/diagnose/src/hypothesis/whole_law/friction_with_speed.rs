//! Friction of a slider that grows with the speed.

use super::{LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use hysteron_identify::study::DeviceMaterial;

pub(super) const TESTS: &str =
    "Constantinou, Mokha and Reinhorn (1990): friction at rest is 0.2 to 0.5 of that at speed";

pub(super) const RATES: &str = "20 to 100 s/m (Constantinou and others 1990)";

pub(super) const GROWTH: Phenomenon =
    Phenomenon { name: "growth with the speed", cause: Some("rate_dependence"), neutral: &[("slow", 1.0)] };

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "rate_dependence",
    form: "friction between a slow and a fast coefficient in the place of a constant one",
    replaces: Replaces::Friction(&["Coulomb", "Constant"]),
    materials: &[DeviceMaterial::Sliding],
    command: "VelDependent {tag} [expr {$::hy_slow*({old})}] {old} $::hy_rate",
    parameters: &[
        LawParameter::linear("slow", 0.5, [0.1, 1.0], LawUnit::One, TESTS),
        LawParameter::log("rate", 10.0, [1.0, 300.0], LawUnit::PerSpeed, RATES),
    ],
    phenomena: &[GROWTH],
    basis: "a constant coefficient",
    source: "Constantinou, Mokha and Reinhorn (1990), Journal of Structural Engineering 116, 455-474",
};
