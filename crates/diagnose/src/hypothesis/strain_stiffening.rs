//! Stiffening of the backbone at large strain.

use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "strain_stiffening",
    statement: "the backbone hardens at large strain",
    refuted_by: "the secant stiffness goes on falling beyond the largest strain tested",
    look_alikes: &["axial_shear_interaction", "gap_impact"],
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Shape],
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
