//! Stiffening of the backbone at large strain.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "strain_stiffening",
    statement: "the backbone hardens at large strain",
    refuted_by: "the secant stiffness goes on falling beyond the largest strain tested",
    look_alikes: &["axial_shear_interaction", "gap_impact"],
    shows: "a force that rises beyond the straight branch at the largest deformations, in loading and unloading alike",
    parted_by: "`gap_impact` begins at one deformation, without a rise before it",
    place: "nonlinear groups, and linear ones on the ground",
    forms: "`stiffening`: cubic, or quadratic from an onset",
    needs_clock: false,
    memory: &[Family::Shape],
    materials: &[],
    measurement: Measurement::new(
        "record the displacement across {place}: its stiffness must rise at the largest ones",
        "drive one cycle to the largest displacement that the rig allows: the stiffness must rise",
    )
    .unless_at_building(Recordable::Deformation),
    quantities: &[
        Quantity::new("factor", "factor", Dimension::Unnamed),
        Quantity::new("from", "onset", Dimension::Length),
        Quantity::new("damping", "factor on the damping of the compound", Dimension::Ratio),
        Quantity::new("share", "factor on the hysteretic share of the compound", Dimension::Ratio),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    // Under ground motion a model without stiffening deforms much more than a stiffening structure.
    let largest_factor = if s.inventory.base_excited { 20.0 } else { 3.0 };
    for m in s.moving_or_supported_groups() {
        let form = |form: &str, power: f64, from: &str, added: Vec<AddedParameter>| {
            let line =
                format!("{} -factor $hy_factor -power {power} -from {from} {}", m.amend("stiffening"), m.dir_option);
            Proposal::script_edit("strain_stiffening", form, m.location(), vec![line], added)
        };
        let scaled = |power: f64, size: f64| size * m.force / m.deformation.powf(power);
        out.push(form(
            "cubic",
            3.0,
            "0.0",
            vec![AddedParameter::linear("factor", scaled(3.0, -1.0), scaled(3.0, largest_factor), scaled(3.0, 0.1))],
        ));
        let from = AddedParameter::linear("from", 0.0, 0.95 * m.deformation, 0.4 * m.deformation);
        let factor =
            AddedParameter::linear("factor", scaled(2.0, -1.0), scaled(2.0, 10.0 * largest_factor), scaled(2.0, 0.3));
        out.push(form("quadratic from an onset", 2.0, "$hy_from", vec![factor, from]));
    }
    out
}
