//! High damping rubber by Gallardo et al.: softening by the largest strain and by cycles, stiffening, temporary hardening.
//!
//! A strain of one is the largest deformation of the user's model. Exponents and the ratio of the two softenings are those of
//! the published bearing.

use super::{LAWS_OF_RUBBER, LawParameter, LawUnit, Phenomenon, Replaces, WholeLaw};
use crate::hypothesis::materials::RUBBERS;

const EXAMPLE: &str = "start: the published example; range: a choice around it, since one bearing is published";
const FORCE: &str = "the force of the user's device";

pub(super) const LAW: WholeLaw = WholeLaw {
    cause: "mullins_softening",
    form: "high damping rubber by Gallardo and others in the place of the law",
    replaces: Replaces::Shear { kinds: LAWS_OF_RUBBER, bearings: true },
    materials: RUBBERS,
    command: "HDR_mat {tag} $::hy_linear 0.0 $::hy_fifth [expr {$::hy_softening*1.13}] 0.38 0.0 1.0 \
              [expr {$::hy_softening*3.70}] 0.37 [expr {$::hy_cycles*0.0676}] 0.57 \
              [expr {$::hy_sharpness*$::hy_strength}] $::hy_strength 0.9 $::hy_transition $::hy_hardening 0.018 \
              {deformation}",
    parameters: &[
        LawParameter::log("linear", 2.1, [0.3, 10.0], LawUnit::Force, FORCE),
        LawParameter::linear("fifth", 10.0, [0.0, 100.0], LawUnit::Force, FORCE),
        LawParameter::linear("softening", 1.0, [0.0, 3.0], LawUnit::One, EXAMPLE),
        LawParameter::linear("cycles", 1.0, [0.0, 5.0], LawUnit::One, EXAMPLE),
        LawParameter::log("strength", 0.07, [0.005, 1.0], LawUnit::Force, FORCE),
        LawParameter::log("sharpness", 80.0, [3.0, 1000.0], LawUnit::One, EXAMPLE),
        LawParameter::log("transition", 0.32, [0.1, 3.0], LawUnit::One, EXAMPLE),
        LawParameter::linear("hardening", 0.1, [0.0, 0.45], LawUnit::One, EXAMPLE),
    ],
    phenomena: &[
        Phenomenon {
            name: "softening by the largest strain",
            cause: Some("mullins_softening"),
            neutral: &[("softening", 0.0)],
        },
        Phenomenon { name: "softening by cycles", cause: Some("cyclic_degradation"), neutral: &[("cycles", 0.0)] },
        Phenomenon { name: "stiffening at large strain", cause: Some("strain_stiffening"), neutral: &[("fifth", 0.0)] },
        Phenomenon { name: "temporary hardening", cause: None, neutral: &[("hardening", 0.0)] },
    ],
    basis: "a linear spring beside a hysteretic one",
    source: "Gallardo, de la Llera, Restrepo, Chen, Engineering Structures 289 (2023) 116234",
};
