//! Mullins effect: virgin rubber is stiffer than scragged rubber.

use super::declaration::{Dimension, Measurement, Quantity};
use super::materials::RUBBERS;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "mullins_softening",
    statement: "virgin or recovered rubber is stiffer on its first way to a strain than on the next (Mullins, scragging)",
    refuted_by: "the second cycle at an amplitude that was never reached before is as stiff as the first",
    look_alikes: &["cyclic_degradation", "self_heating", "strain_stiffening"],
    shows: "a first cycle at each new amplitude that is stiffer than the next at the same amplitude",
    parted_by: "`self_heating` softens every cycle, also at an amplitude reached before",
    place: "nonlinear groups",
    forms: "`mullins` with a gradual way back to the virgin path, or lost for good",
    needs_clock: false,
    memory: &[Family::Largest],
    materials: RUBBERS,
    measurement: Measurement::new(
        "compare earthquakes before and after the strongest one: {place} must be softer after it",
        "drive the same cycles twice without a rest: the second time must be softer",
    ),
    quantities: &[
        Quantity::new("virgin", "excess of the virgin stiffness", Dimension::Ratio)
            .within("the excess of the virgin stiffness", [0.0, 1.5], "unscragged bearings are at most 2.5 times as stiff as scragged ones (Thompson et al. 2000, 12th World Conf. Earthq. Eng.)"),
        Quantity::new("onset", "deformation at the onset", Dimension::Length),
        Quantity::new("excess", "excess of the virgin stress", Dimension::Ratio),
        Quantity::new("strain", "strain of the softening", Dimension::Ratio),
        Quantity::new("rest", "factor of the rest", Dimension::Ratio),
        Quantity::new("damping", "factor on the damping of the compound", Dimension::Ratio),
        Quantity::new("share", "factor on the hysteretic share of the compound", Dimension::Ratio),
        Quantity::new("linear", "virgin force of the linear part at the largest deformation", Dimension::Force),
        Quantity::new("fifth", "virgin force of the fifth-order part at the largest deformation", Dimension::Force),
        Quantity::new("softening", "factor on the published softening", Dimension::Ratio),
        Quantity::new("cycles", "factor on the published softening by cycles", Dimension::Ratio),
        Quantity::new("strength", "strength of the hysteretic part", Dimension::Force),
        Quantity::new("sharpness", "largest deformation over the yield deformation", Dimension::Ratio),
        Quantity::new("transition", "exponent of the transition", Dimension::Ratio),
        Quantity::new("hardening", "largest temporary hardening", Dimension::Ratio),
    ],
    propose,
};

/// Largest exponent of the way back to the virgin path, and a further start. Choices: the error function of Ogden and Roxburgh
/// (1999) comes back within a few hundredths of the largest strain where their m is small beside the energy.
const MAX_POWER: f64 = 40.0;
const SHARP_POWER: f64 = 12.0;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let k = m.stiffness();
        let elastic = || AddedParameter::linear("k", 0.05 * k, 1.2 * k, 0.6 * k);
        // The rubber network softens; the rest has a factor of its own.
        for (part_name, share, further) in [
            ("of the whole force", "", vec![]),
            ("of the hysteretic part", " -share $hy_k 0", vec![elastic()]),
            ("of the elastic part", " -share $hy_k 1 0", vec![elastic()]),
            (
                "of both parts",
                " -share $hy_k 1 $hy_rest",
                vec![elastic(), AddedParameter::linear("rest", 0.0, 1.5, 0.4)],
            ),
        ] {
            let form = |form: &str, power: &str, added: Vec<AddedParameter>| {
                let options = format!("-virgin $hy_virgin -power {power} -onset $hy_onset {}{share}", m.dir_option);
                let line = format!("{} {options}", m.amend("mullins"));
                let added = added.into_iter().chain(further.clone()).collect();
                Proposal::script_edit(
                    "mullins_softening",
                    &format!("{form} {part_name}"),
                    m.location(),
                    vec![line],
                    added,
                )
            };
            // Rubber loses at most half of its stiffness by it.
            let virgin = AddedParameter::linear("virgin", -0.3, 1.2, 0.2);
            let onset = |start: f64| {
                AddedParameter::log("onset", 1e-3 * m.deformation, 3.0 * m.deformation, start * m.deformation)
            };
            let power = AddedParameter::log("power", 0.2, MAX_POWER, 2.0);
            let power = AddedParameter { further_starts: vec![SHARP_POWER], ..power };
            let recovering = vec![virgin.clone(), power, onset(0.1)];
            out.push(form("excess", "$hy_power", recovering));
            // Back at its largest strain, rubber is as stiff as virgin rubber (Ogden and Roxburgh 1999).
            // Or the virgin path itself has softened (Simo 1987; Govindjee and Simo 1991).
            out.push(form("excess, lost for good,", "0", vec![virgin, onset(0.4)]));
        }
    }
    out
}
