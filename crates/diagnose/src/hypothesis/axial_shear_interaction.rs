//! Loss of lateral stiffness under axial load.

use super::context::force_parts;
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::conditions::axial_loads;
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "axial_shear_interaction",
    statement: "the axial load takes lateral stiffness away (P-Delta, buckling)",
    refuted_by: "the lateral stiffness is the same at another axial load",
    look_alikes: &["strain_stiffening", "mullins_softening"],
    shows: "a lateral stiffness that falls at large deformation or under more load, down to a negative slope",
    parted_by: "another axial load changes the slope",
    place: "nonlinear groups with a known compression: the model's, or a variable `axial` of each run",
    forms: "`axial` with a constant critical load, or one that falls with the overlap",
    needs_clock: false,
    memory: &[Family::Shape, Family::AxialForce],
    materials: &[],
    measurement: Measurement::new(
        "compute or measure the axial load of {place}: the lateral stiffness must fall as it grows",
        "repeat a run at another axial load: the lateral stiffness must change",
    )
    .unless(Recordable::AxialForce, Some("repeat a run at another axial load: the lateral stiffness must change")),
    quantities: &[
        Quantity::new("critical", "critical load", Dimension::Force),
        Quantity::new("width", "width of the overlap", Dimension::Length),
    ],
    propose,
};

/// Axial force of a group, with the option of the amendment for it: that of the model, or the variable `axial` of the runs.
pub(super) fn axial_force(s: &ProposalContext<'_>, m: &super::MovingGroup<'_>) -> Option<(f64, String)> {
    let carried = m.axial_range(s).map_or(0.0, |x| x.force);
    if carried > 0.0 {
        return Some((carried, m.axial_option()));
    }
    let most = axial_loads(s.study)?.into_iter().fold(0.0, f64::max);
    (most > 0.0).then(|| (most, " -load [expr {abs($axial)}]".into()))
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let Some((force, option)) = axial_force(s, &m) else { continue };
        for (which, share, further) in force_parts(&m) {
            let critical = || AddedParameter::log("critical", 0.5 * force, 20.0 * force, 2.0 * force);
            let line = format!("{} -critical $hy_critical{option} {}{share}", m.amend("axial"), m.dir_option);
            let mut added = vec![critical()];
            added.extend(further.clone());
            let form = format!("critical load, loss {which}");
            out.push(Proposal::script_edit("axial_shear_interaction", &form, m.location(), vec![line], added));
            let line =
                format!("{} -critical $hy_critical -width $hy_width{option} {}{share}", m.amend("axial"), m.dir_option);
            let mut added = vec![
                critical(),
                AddedParameter::log("width", 1.1 * m.deformation, 20.0 * m.deformation, 3.0 * m.deformation),
            ];
            added.extend(further);
            let form = format!("critical load falling with the overlap, loss {which}");
            out.push(Proposal::script_edit("axial_shear_interaction", &form, m.location(), vec![line], added));
        }
    }
    out
}
