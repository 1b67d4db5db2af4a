//! Pinching: slip thins the loops near zero.

use super::context::force_parts;
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;
use hysteron_identify::study::DeviceMaterial;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "pinching",
    statement: "slip or crack closing thins the loops near zero",
    refuted_by: "the force at zero deformation is as large as that of a fresh device",
    look_alikes: &["cyclic_degradation", "mullins_softening"],
    shows: "loops that are thin near zero and wide at the ends",
    parted_by: "peaks of the force keep their height, unlike in `cyclic_degradation`",
    place: "nonlinear groups",
    forms: "`slip` of a constant size or growing with the deformation; `pinching`",
    needs_clock: false,
    memory: &[Family::Pinching, Family::Largest],
    materials: &[DeviceMaterial::Steel, DeviceMaterial::Concrete, DeviceMaterial::Timber],
    measurement: Measurement::new(
        "record the displacement across {place}: the loops must be thin near zero",
        "drive small cycles after large ones: their force must be small",
    )
    .unless_at_building(Recordable::Deformation),
    quantities: &[
        Quantity::new("size", "slip", Dimension::Length),
        Quantity::new("growth", "slip per deformation", Dimension::Ratio),
        Quantity::new("pinchX", "pinching of the deformation", Dimension::Ratio),
        Quantity::new("pinchY", "pinching of the force", Dimension::Ratio),
        Quantity::new("depth", "depth", Dimension::Ratio),
        Quantity::new("onset", "onset", Dimension::Length),
        Quantity::new("width", "width", Dimension::Unnamed),
        Quantity::new("strength", "yield force", Dimension::Force),
        Quantity::new("yield", "yield deformation", Dimension::Length),
        Quantity::new("damage", "damage by energy", Dimension::Ratio),
        Quantity::new("unloading", "exponent of unloading", Dimension::Ratio),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let k = m.stiffness();
        for (form, option, most) in [
            ("slip where the hysteretic force passes zero", "size", m.deformation),
            ("slip that grows with the deformation", "growth", 1.0),
        ] {
            let size = if option == "size" { "-size $hy_size" } else { "-size 0.0 -growth $hy_growth" };
            let line = format!("{} {size} -width $hy_width -share $hy_k 0 {}", m.amend("slip"), m.dir_option);
            let added = vec![
                AddedParameter::linear(option, 0.0, 1.5 * most, 0.3 * most),
                AddedParameter::log("width", 0.02 * m.force, m.force, 0.2 * m.force),
                AddedParameter::linear("k", 0.0, 1.2 * k, 0.6 * k),
            ];
            out.push(Proposal::script_edit("pinching", form, m.location(), vec![line], added));
        }
        for (part_name, share, further) in force_parts(&m) {
            let line = format!(
                "{} -depth $hy_depth -width $hy_width -onset $hy_onset {}{share}",
                m.amend("pinching"),
                m.dir_option
            );
            let mut added = vec![
                AddedParameter::linear("depth", 0.0, 1.0, 0.3),
                AddedParameter::log("width", 0.05, 1.5, 0.3),
                AddedParameter::linear("onset", 0.0, 0.6 * m.deformation, 0.05 * m.deformation),
            ];
            added.extend(further);
            out.push(Proposal::script_edit("pinching", &format!("slack {part_name}"), m.location(), vec![line], added));
        }
    }
    out
}
