//! Integrators of static analyses: control of loads, of a displacement, and of the length of the path.

use super::{IntegratorResult, Kind};
use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::{DOF, NODE, node_of};
use crate::text::{Arg, Text};
use hysteron_engine::analysis::TangentMix;
use hysteron_engine::analysis::integrator::{
    Adaptive, ArcLength, DisplacementControl, EquilibriumPath, LoadControl, MinUnbalDispNorm, PathConstraint, Sense,
};
use hysteron_tcl::Exception;

const LOAD_CONTROL_INCREMENT: Arg = Arg::number("increment", "increment of the load factor");
const MIN: Arg = Arg::number("min", "smallest step");
const MAX: Arg = Arg::number("max", "largest step");
const DISPLACEMENT_CONTROL_INCREMENT: Arg = Arg::number("increment", "increment of the displacement");
const LENGTH: Arg = Arg::positive("length", "arc length");
const PSI_U: Arg = Arg::positive("psiU", "weight psiU of the displacements");
const PSI_F: Arg = Arg::not_negative("psiF", "weight psiF of the load");
const ARC_ALPHA: Arg = Arg::number("alpha", "weight alpha of the load factor");
const U_REF: Arg = Arg::positive("uRef", "reference displacement uRef");
const CONSTRAINT: Arg = Arg::count("constraint", "number of the constraint");
const MIN_UNBAL_DISP_NORM_INCREMENT: Arg = Arg::number("increment", "first increment of the load factor");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["LoadControl"],
        usage: "integrator LoadControl $increment <$iterations $min $max>",
        text: Text::new("Steps of the load factor.").arguments(&[LOAD_CONTROL_INCREMENT, MIN, MAX]),
        make: load_control,
    },
    Kind {
        names: &["DisplacementControl"],
        usage: "integrator DisplacementControl $node $dof $increment <$iterations $min $max>",
        text: Text::new("Steps of one displacement.").arguments(&[NODE, DOF, DISPLACEMENT_CONTROL_INCREMENT, MIN, MAX]),
        make: displacement_control,
    },
    Kind {
        names: &["ArcLength"],
        usage: "integrator ArcLength $length <$alpha>",
        text: Text::new("Steps along the path of equilibrium.").arguments(&[LENGTH, ARC_ALPHA]),
        make: arc_length,
    },
    Kind {
        names: &["ArcLength1"],
        usage: "integrator ArcLength1 $length <$alpha>",
        text: Text::new("Steps along the path of equilibrium, by displacements.").arguments(&[LENGTH, ARC_ALPHA]),
        make: linearised_arc_length,
    },
    Kind {
        names: &["HSConstraint"],
        usage: "integrator HSConstraint $length <$psiU> <$psiF> <$uRef>",
        text: Text::new("Steps along the path of equilibrium, of a given length in displacements and loads.")
            .arguments(&[LENGTH, PSI_U, PSI_F, U_REF]),
        make: hyper_spherical,
    },
    Kind {
        names: &["EQPath"],
        usage: "integrator EQPath $length $constraint (1 to 8)",
        text: Text::new("Steps along the path of equilibrium, with corrections that keep to one of eight constraints.")
            .arguments(&[LENGTH, CONSTRAINT]),
        make: equilibrium_path,
    },
    Kind {
        names: &["MinUnbalDispNorm"],
        usage: "integrator MinUnbalDispNorm $increment <$iterations $min $max> <-determinant>",
        text: Text::new("Steps of the load factor with least corrections.").arguments(&[
            MIN_UNBAL_DISP_NORM_INCREMENT,
            MIN,
            MAX,
        ]),
        make: min_unbal_disp_norm,
    },
];

/// Take the numbers after the step: iterations wanted, smallest and largest step.
fn adaptive(a: &mut Args<'_>, step: f64) -> Result<Adaptive, Exception> {
    if !a.at_number() {
        return Ok(Adaptive::fixed(step));
    }
    let desired_iterations = a.count(&super::ITERATIONS)?;
    let min = a.optional_number(&MIN)?.unwrap_or(step);
    let max = a.optional_number(&MAX)?.unwrap_or(step);
    Ok(Adaptive { desired_iterations, min, max })
}

fn load_control(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let step = a.number(&LOAD_CONTROL_INCREMENT)?;
    Ok(Box::new(LoadControl::new(step, adaptive(a, step)?)))
}

fn displacement_control(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let node = node_of(interp, a, NODE.meaning)?;
    let (ndf, offset) = {
        let n = &interp.host.engine.model().nodes[node.0];
        (n.ndf, n.offset)
    };
    let dof = a.dof(DOF.meaning, ndf)?;
    let step = a.number(&DISPLACEMENT_CONTROL_INCREMENT)?;
    let adaptive = adaptive(a, step)?;
    let mix = if a.flag("-initial") { TangentMix::INITIAL } else { TangentMix::CURRENT };
    Ok(Box::new(DisplacementControl::new(offset + dof, step, adaptive, mix)))
}

/// Take the arc length and the weight of the load factor.
fn arc(a: &mut Args<'_>) -> Result<(f64, f64), Exception> {
    let length = a.number(&LENGTH)?;
    Ok((length, a.optional_number(&ARC_ALPHA)?.unwrap_or(1.0)))
}

fn arc_length(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (length, alpha) = arc(a)?;
    Ok(Box::new(ArcLength::new(length, alpha)))
}

fn linearised_arc_length(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (length, alpha) = arc(a)?;
    Ok(Box::new(ArcLength::linearised(length, alpha)))
}

fn hyper_spherical(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let length = a.number(&LENGTH)?;
    let displacement = if a.at_number() { a.number(&PSI_U)? } else { 1.0 };
    let load = if a.at_number() { a.number(&PSI_F)? } else { 1.0 };
    let reference = if a.at_number() { a.number(&U_REF)? } else { 1.0 };
    Ok(Box::new(ArcLength::hyper_spherical(length, [displacement, load, reference])))
}

/// Constraints of `EQPath` by their number, from 1.
const PATH_CONSTRAINTS: [PathConstraint; 8] = [
    PathConstraint::MinimumResidual,
    PathConstraint::NormalPlane,
    PathConstraint::UpdatedNormalPlane,
    PathConstraint::Cylinder,
    PathConstraint::NormalFlow,
    PathConstraint::GeneralisedDisplacement,
    PathConstraint::ModifiedNormalPlane,
    PathConstraint::IncrementNormal,
];

fn equilibrium_path(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let length = a.number(&LENGTH)?;
    let number = a.count(&CONSTRAINT)?;
    let Some(constraint) = number.checked_sub(1).and_then(|i| PATH_CONSTRAINTS.get(i)) else {
        return Err(a.refuse(format!("there is no constraint {number}"), "expected a number from 1 to 8"));
    };
    Ok(Box::new(EquilibriumPath::new(length, *constraint)))
}

fn min_unbal_disp_norm(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let increment = a.number(&MIN_UNBAL_DISP_NORM_INCREMENT)?;
    let adaptive = adaptive(a, increment)?;
    let by_stiffness = a.flag("-determinant") || a.flag("-det");
    let sense = if by_stiffness { Sense::Stiffness } else { Sense::LastStep };
    Ok(Box::new(MinUnbalDispNorm::new(increment, adaptive, sense)))
}
