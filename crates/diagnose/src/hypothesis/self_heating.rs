//! Self-heating: dissipated work warms and softens a device.

use super::context::{HYSTERETIC_PART, STRENGTH, force_parts, strength_part};
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, MovingGroup, Proposal, ProposalContext};
use crate::memory::family::Family;
use hysteron_identify::study::DeviceMaterial;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "self_heating",
    statement: "dissipated work warms the device and softens it",
    refuted_by: "after a pause long enough to cool the first cycle is as soft as the last",
    look_alikes: &["cyclic_degradation", "mullins_softening"],
    shows: "loops that shrink from cycle to cycle, most where most work is done, and recover after a pause",
    parted_by: "`cyclic_degradation` does not recover",
    place: "nonlinear groups; needs a clock",
    forms: "`heating` with cooling, as a factor or of the strength; with conduction, of the hysteretic part or the strength; of a sliding face where the slider covers it",
    needs_clock: true,
    memory: &[Family::Heat, Family::Temperature],
    materials: &[],
    measurement: Measurement::new(
        "put a thermometer on {place}: its strength must fall while it warms during strong shaking",
        "put a thermometer on {place}, and repeat a run after it has cooled: the first cycle must be strong again",
    ).unless(Recordable::Temperature,Some("repeat a run after {place} has cooled: the first cycle must be strong again"),),
    quantities: &[
        Quantity::new("capacity", "work per degree, at a softening of 1 %/degree", Dimension::Energy),
        Quantity::new("cooling", "cooling time", Dimension::Time)
            .within("the cooling time, s", [10.0, f64::INFINITY], "lead cores keep their heat for tens of seconds, rubber for hours (Kalpakidis and Constantinou 2009, J. Struct. Eng. 135, \
                1440-1449)"),
        Quantity::new("width", "half width of the slider", Dimension::Length),
        Quantity::new("heatCapacity", "heat capacity per volume of rubber", Dimension::Unnamed),
        Quantity::new("coolingTime", "cooling time", Dimension::Time),
        Quantity::new("leadCapacity", "factor on the specific heat of lead", Dimension::Ratio),
        Quantity::new("conductivity", "factor on the conductivity", Dimension::Ratio),
        Quantity::new("conduction", "conduction", Dimension::Unnamed),
    ],
    propose,
};

/// Softening, 1/degree. Without a thermometer only its ratio to the heat capacity can be found.
const SOFTENING: f64 = 0.01;

/// Returns true if devices have a sliding face.
fn slides(s: &ProposalContext<'_>, m: &MovingGroup<'_>) -> bool {
    s.study.material == Some(DeviceMaterial::Sliding) || m.devices.iter().all(|d| d.slides)
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        // Start: a rise of ten degrees over the longest run.
        let capacity = m.work / 10.0;
        for (part_name, share, further) in force_parts(&m).into_iter().chain([strength_part(&m)]) {
            let mut form = |form: &str, loss: &str, added: Vec<AddedParameter>| {
                let options = format!("-softening {SOFTENING} -capacity $hy_capacity {loss} {}{share}", m.dir_option);
                let line = format!("{} {options}", m.amend("heating"));
                let added = added.into_iter().chain(further.clone()).collect();
                out.push(Proposal::script_edit(
                    "self_heating",
                    &format!("{form} {part_name}"),
                    m.location(),
                    vec![line],
                    added,
                ));
            };
            let cooling = vec![
                AddedParameter::log("capacity", 0.02 * capacity, 30.0 * capacity, capacity),
                AddedParameter::log("cooling", 1.0, 1e5, 100.0),
            ];
            form("softening", "-cooling $hy_cooling", cooling);
            // Lead cores and sliding faces conduct heat into adjacent bodies; a face alone has hardly any heat capacity.
            if [HYSTERETIC_PART, STRENGTH].contains(&part_name) {
                let capacity = AddedParameter::log("capacity", 1e-3 * capacity, 30.0 * capacity, 0.3 * capacity);
                let conduction = vec![capacity, AddedParameter::log("conduction", 1e-3, 1e3, 10.0)];
                form("softening, heat conducted away,", "-conduction $hy_conduction", conduction);
            }
            if part_name == STRENGTH && slides(s, &m) {
                // Nothing but the half-space under the face takes heat up; a short time stands for that.
                let (step, longest) = (s.sampling_interval(), s.longest_run());
                let capacity = capacity * (step / longest).sqrt();
                let face = vec![
                    AddedParameter::log("capacity", 0.02 * capacity, 30.0 * capacity, capacity),
                    AddedParameter::log("width", 0.1 * m.deformation, m.deformation, 0.6 * m.deformation),
                ];
                let loss = format!("-conduction {step:.6e} -halfWidth $hy_width");
                form("softening of a face that heats under the slider,", &loss, face);
            }
        }
    }
    out
}
