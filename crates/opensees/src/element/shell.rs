//! `element ShellMITC4`, `ShellDKGQ`, `ShellDKGT`, `ShellNLDKGQ`, `ASDShellQ4`, `ASDShellT3`.

use super::corners::{CORNERS, TRIANGLE_CORNERS, placed_node};
use super::damping::{damped, optional};
use super::{Kind, Make, refused};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, slips};
use hysteron_engine::element::Element;
use hysteron_engine::element::shell::{
    Drilling, EnhancedShell, EnhancedShellOptions, Formulation, Shell, UpdatedShell,
};
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use nalgebra::Vector3;
use std::sync::Arc;

const DRILLING_SHARE: Arg =
    Arg::of("-drillingStab", "share", "share of full integration of the drilling stiffness").within(Domain::Number);
const LOCAL_X: [Arg; 3] = [
    Arg::of("-local", "x1", "x1 of axis 1").within(Domain::Number),
    Arg::of("-local", "x2", "x2 of axis 1").within(Domain::Number),
    Arg::of("-local", "x3", "x3 of axis 1").within(Domain::Number),
];

const LOCAL_AXES: &[Arg] =
    &[Arg::flag("-corotational", "the axes of the shell follow its nodes"), LOCAL_X[0], LOCAL_X[1], LOCAL_X[2]];

pub(super) const MITC4: Kind = Kind {
    names: &["ShellMITC4", "shellMITC4", "Shell", "shell"],
    usage: "element ShellMITC4 $tag $i $j $k $l $section <-damp $damping>",
    text: Text::new("Four-node shell with shear deformation.")
        .example("element ShellMITC4 77 1 3 4 2 1")
        .groups(&[&CORNERS]),
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::Mitc4)),
};

pub(super) const DKGQ: Kind = Kind {
    names: &["ShellDKGQ", "shellDKGQ"],
    usage: "element ShellDKGQ $tag $i $j $k $l $section <-damp $damping>",
    text: Text::new("Four-node thin shell with drilling.")
        .example("element ShellDKGQ 77 1 3 4 2 1")
        .groups(&[&CORNERS]),
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::KirchhoffQuadrilateral)),
};

pub(super) const DKGT: Kind = Kind {
    names: &["ShellDKGT", "shellDKGT"],
    usage: "element ShellDKGT $tag $i $j $k $section <-damp $damping>",
    text: Text::new("Three-node thin shell with drilling.")
        .example("element ShellDKGT 77 1 3 4 1")
        .groups(&[&TRIANGLE_CORNERS]),
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::KirchhoffTriangle)),
};

pub(super) const UPDATED: Kind = Kind {
    names: &["ShellNLDKGQ", "shellNLDKGQ"],
    usage: "element ShellNLDKGQ $tag $i $j $k $l $section",
    text: Text::new("Four-node thin shell with drilling and large displacements.")
        .example("element ShellNLDKGQ 77 1 3 4 2 1")
        .groups(&[&CORNERS]),
    make: Make::AnyNodes(make_updated),
};

pub(super) const ENHANCED: Kind = Kind {
    names: &["ASDShellQ4", "asdShellQ4"],
    usage: "element ASDShellQ4 $tag $i $j $k $l $section <-corotational> <-noeas> <-drillingStab $share> <-drillingNL> \
            <-local $x1 $x2 $x3>",
    text: Text::new(
        "Four-node shell with shear deformation and internal modes of the membrane; large displacements on \
         demand.",
    )
    .example("element ASDShellQ4 77 1 3 4 2 1")
    .arguments(&[
        Arg::flag("-noeas", "the membrane has no internal modes"),
        DRILLING_SHARE,
        Arg::flag("-drillingNL", "the drilling stiffness is damaged with the section"),
    ])
    .groups(&[&CORNERS, LOCAL_AXES]),
    make: Make::AnyNodes(|interp, a| make_enhanced(interp, a, 4)),
};

pub(super) const ENHANCED_TRIANGLE: Kind = Kind {
    names: &["ASDShellT3", "asdShellT3"],
    usage: "element ASDShellT3 $tag $i $j $k $section <-corotational> <-reducedIntegration> <-drillingNL> \
            <-local $x1 $x2 $x3>",
    text: Text::new("Three-node shell with shear deformation and drilling; large displacements on demand.")
        .example("element ASDShellT3 77 1 3 4 1")
        .arguments(&[
            Arg::flag("-reducedIntegration", "one point, and a penalty on the drilling strain"),
            Arg::flag("-drillingNL", "with -reducedIntegration, the drilling stiffness is damaged with the section"),
        ])
        .groups(&[&TRIANGLE_CORNERS, LOCAL_AXES]),
    make: Make::AnyNodes(|interp, a| make_enhanced(interp, a, 3)),
};

/// Nodes of the corners, their places, and their displacements.
type Corners = (Vec<NodeId>, Vec<Vector3<f64>>, Vec<f64>);

fn corners(interp: &Tcl, a: &mut Args<'_>, count: usize) -> Result<Corners, Exception> {
    let (mut nodes, mut places, mut disp) = (vec![], vec![], vec![]);
    for _ in 0..count {
        let (id, place) = placed_node(interp, a, &CORNERS[0], (3, 6))?;
        let engine = &interp.host.engine;
        places.push(place);
        disp.extend(engine.model().nodes[id.0].dofs().map(|d| engine.state().disp[d]));
        nodes.push(id);
    }
    Ok((nodes, places, disp))
}

fn make(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    formulation: Formulation,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places, mut disp) = corners(interp, a, formulation.nodes())?;
    if formulation != Formulation::Mitc4 {
        disp.clear();
    }
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let made = Shell::new(formulation, &places, section, &disp).map_err(|e| refused(a, place, e))?;
    let damping = optional(interp, a)?;
    Ok((nodes, damped(made.shared(), damping).map_err(|e| refused(a, place, e))?))
}

fn make_updated(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places, _) = corners(interp, a, 4)?;
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let places = std::array::from_fn(|i| places[i]);
    let made = UpdatedShell::new(places, section).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}

/// Share of the drilling penalty of a quadrilateral that is integrated fully, where none is given.
const DEFAULT_DRILLING_SHARE: f64 = 0.01;

fn make_enhanced(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    count: usize,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places, disp) = corners(interp, a, count)?;
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let mut o = EnhancedShellOptions {
        corotational: false,
        internal: count == 4,
        reduced: false,
        drilling: Drilling::Elastic(DEFAULT_DRILLING_SHARE),
        axis: None,
        opensees_axes: interp.host.follows(&[slips::SHELL_AXES]),
        by_trials: interp.host.follows(&[slips::COROTATIONAL_TRIALS]),
    };
    let (mut share, mut damaged) = (None, false);
    while let Some(option) = a.option() {
        match (option.as_ref(), count) {
            ("-corotational" | "-Corotational", _) => o.corotational = true,
            ("-noeas", 4) => o.internal = false,
            ("-drillingStab", 4) => share = Some(a.number(&DRILLING_SHARE)?),
            ("-reducedIntegration", 3) => o.reduced = true,
            ("-drillingNL", _) => damaged = true,
            ("-local", _) => {
                let axis = a.numbers(&LOCAL_X)?;
                o.axis = axis.iter().any(|x| *x != 0.0).then_some(axis);
            }
            _ => ignore_unknown(interp, a)?,
        }
        if share.is_some() && damaged {
            return Err(a.refuse("-drillingStab and -drillingNL exclude each other", "expected one of them"));
        }
    }
    if let Some(share) = share {
        o.drilling = Drilling::Elastic(share.clamp(0.0, 1.0));
    }
    // A triangle with three points has no drilling penalty that could be damaged.
    if damaged && (count == 4 || o.reduced) {
        o.drilling = Drilling::Damaged;
    }
    let made = EnhancedShell::new(&places, section, o, &disp).map_err(|e| refused(a, place, e))?;
    Ok((nodes, made.shared()))
}
