//! A hysteretic law with pinching, damage and unloading that softens.
//!
//! The smooth law of Baber and Noori for pinching is none of the library; the trilinear law of OpenSees stands for it.

use super::{LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use hysteron_identify::study::DeviceMaterial;

const MANUAL: &str = "OpenSees' manual, Hysteretic";

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "pinching",
    form: "a law with pinching, damage and softer unloading in the place of the law",
    replaces: Replaces::Shear {
        kinds: &["Elastic", "Steel01", "Steel02", "Hardening", "ElasticPP", "BoucWen"],
        bearings: false,
    },
    materials: &[DeviceMaterial::Steel, DeviceMaterial::Concrete, DeviceMaterial::Timber],
    command: "Hysteretic {tag} $::hy_strength $::hy_yield [expr {$::hy_strength*(1.0+$::hy_hardening)}] \
              [expr {10.0*$::hy_yield}] [expr {-$::hy_strength}] [expr {-$::hy_yield}] \
              [expr {-$::hy_strength*(1.0+$::hy_hardening)}] [expr {-10.0*$::hy_yield}] \
              $::hy_pinchX $::hy_pinchY 0.0 $::hy_damage $::hy_unloading",
    parameters: &[
        LawParameter::log("strength", 0.6, [0.1, 1.5], LawUnit::Force, "the force of the user's device"),
        LawParameter::log("yield", 0.1, [0.01, 1.0], LawUnit::Deformation, "the deformation of the user's device"),
        LawParameter::linear(
            "hardening",
            0.5,
            [0.0, 4.0],
            LawUnit::One,
            "stiffness after yield up to 0.44 of the first",
        ),
        LawParameter::linear("pinchX", 0.6, [0.1, 1.0], LawUnit::One, MANUAL),
        LawParameter::linear("pinchY", 0.4, [0.05, 1.0], LawUnit::One, MANUAL),
        LawParameter::linear("damage", 0.01, [0.0, 0.2], LawUnit::One, MANUAL),
        LawParameter::linear(
            "unloading",
            0.2,
            [0.0, 0.8],
            LawUnit::One,
            "0.5 and less (Takeda, Sozen and Nielsen 1970)",
        ),
    ],
    phenomena: &[
        Phenomenon { name: "pinching", cause: Some("pinching"), neutral: &[("pinchX", 1.0), ("pinchY", 1.0)] },
        Phenomenon {
            name: "damage by dissipated energy",
            cause: Some("cyclic_degradation"),
            neutral: &[("damage", 0.0)],
        },
        Phenomenon { name: "softer unloading after large deformation", cause: None, neutral: &[("unloading", 0.0)] },
    ],
    basis: "yielding with hardening, and reloading towards the largest deformation",
    source: MANUAL,
};
