//! Cavitation of rubber in tension.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::materials::RUBBERS;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext, element_names, element_tags};
use crate::inspect::device_axes::{AxialDirection, device_axes};
use crate::inspect::inventory::{Device, grouped};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cavitation",
    statement: "the rubber cavitates in tension and is damaged by it",
    refuted_by: "the second pull is as strong as the first",
    look_alikes: &[],
    shows: "a tension that reaches a limit, and a softer second pull",
    parted_by: "only pulled devices show it",
    place: "single devices that are pulled in their axis; both signs for springs of one direction",
    forms: "`cavitation`: a level limit, one that rises, and one of the elastic part",
    needs_clock: false,
    memory: &[],
    materials: RUBBERS,
    measurement: Measurement::new(
        "record the vertical displacement across {place}: it must lift",
        "pull twice to the same extension: the second pull must be weaker",
    )
    .unless_at_building(Recordable::VerticalDeformation),
    quantities: &[
        Quantity::new("strength", "cavitation force", Dimension::Force),
        Quantity::new("damage", "largest damage", Dimension::Ratio),
        Quantity::new("rise", "rise of the force", Dimension::Ratio),
        Quantity::new("reach", "extension of the rise", Dimension::Length),
    ],
    propose,
};

/// Relative difference of axial stiffnesses below which devices can share the parameters of a form.
const EQUAL_STIFFNESS: f64 = 1e-6;

/// Devices that are pulled in their axis.
pub(super) struct PulledDevices<'a> {
    pub(super) devices: Vec<&'a Device>,
    /// Direction of the axis, and the sign of its deformation that is tension.
    pub(super) direction: usize,
    pub(super) sign: f64,
    /// Stiffness along the axis.
    pub(super) stiffness: f64,
    /// Largest extension.
    pub(super) extension: f64,
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    pulled_devices(s).iter().flat_map(forms).collect()
}

/// Each device that is pulled, and all that are alike together; twice where tension may be either sign.
pub(super) fn pulled_devices<'a>(s: &ProposalContext<'a>) -> Vec<PulledDevices<'a>> {
    let axis = |d: &Device| device_axes(&[d], s.inventory, s.responses).axial;
    let stiffness = |d: &Device, number: usize| d.directions.iter().find(|x| x.number == number).map(|x| x.stiffness);
    let alike = |a: &&Device, b: &&Device| {
        let (first, second) = (axis(a), axis(b));
        let stiffnesses = first.and_then(|x| stiffness(a, x.number).zip(stiffness(b, x.number)));
        first == second && stiffnesses.is_some_and(|(a, b)| (a - b).abs() <= EQUAL_STIFFNESS * a.abs())
    };
    let mut out = vec![];
    let mut groups: Vec<Vec<&Device>> = vec![];
    for kind in s.inventory.groups_of_one_kind() {
        let together = grouped(&kind, alike).into_iter().map(|g| g.into_iter().copied().collect::<Vec<_>>());
        groups.extend(kind.iter().map(|d| vec![*d]));
        groups.extend(together.filter(|g| g.len() > 1));
    }
    for group in groups {
        let Some(AxialDirection { number, tension }) = device_axes(&group, s.inventory, s.responses).axial else {
            continue;
        };
        let Some(x) = s.responses.of(&group, number) else { continue };
        let Some(k) = stiffness(group[0], number) else { continue };
        for sign in tension.as_ref().map_or(&[1.0, -1.0][..], std::slice::from_ref) {
            let extension = if *sign > 0.0 { x.deformation_bounds[1] } else { -x.deformation_bounds[0] };
            if extension > MIN_EXTENSION * x.deformation {
                let devices = group.clone();
                out.push(PulledDevices { devices, direction: number, sign: *sign, stiffness: k, extension });
            }
        }
    }
    out
}

/// Least extension over the largest deformation of a device that counts as pulled. A choice.
const MIN_EXTENSION: f64 = 0.05;

/// Forms for devices that are pulled.
fn forms(pulled: &PulledDevices<'_>) -> Vec<Proposal> {
    let &PulledDevices { ref devices, direction, sign, stiffness: k, extension } = pulled;
    let mut out = vec![];
    let force = k * extension;
    let mut form = |form: &str, tension_stiffness: &str, rise: &str, more: &[AddedParameter]| {
        let line = format!(
            "amend element {} cavitation -strength $hy_strength -extension [expr {{$hy_strength/{tension_stiffness}}}] \
             -damage $hy_damage{rise} -sign {sign} -dir {direction}",
            element_tags(devices)
        );
        let mut added = vec![
            AddedParameter::log("strength", 0.02 * force, force, 0.4 * force),
            AddedParameter::linear("damage", 0.0, 0.99, 0.5),
        ];
        added.extend_from_slice(more);
        out.push(Proposal::script_edit("cavitation", form, element_names(devices), vec![line], added));
    };
    let own = format!("{k:.6e}");
    form("limit of tension", &own, "", &[]);
    let rise = || AddedParameter::linear("rise", 0.0, 3.0, 0.3);
    let reach = || AddedParameter::log("reach", 0.02 * extension, 5.0 * extension, 0.5 * extension);
    form("limit of tension that rises", &own, " -rise $hy_rise -reach $hy_reach", &[rise(), reach()]);
    // A dashpot beside the rubber keeps its force in tension.
    let part = AddedParameter::linear("k", 0.5 * k, 1.5 * k, k);
    let line = " -rise $hy_rise -reach $hy_reach -share $hy_k 0";
    form("limit of the elastic tension", "$hy_k", line, &[rise(), reach(), part]);
    out
}
