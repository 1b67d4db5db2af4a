//! Single-point and multi-point constraints.

use crate::args::Args;
use crate::checks;
use crate::model::nodes::{NODE, node_of};
use crate::text::{Arg, Domain};
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::model::{Fix, MultiPoint, NodeId};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const COORDINATE: Arg = Arg::number("coordinate", "coordinate");
const TOL_TOLERANCE: Arg = Arg::of("-tol", "tolerance", "tolerance").within(Domain::NotNegative);
const RETAINED: Arg = Arg::whole("retained", "tag of the retained node");
const CONSTRAINED: Arg = Arg::whole("constrained", "tag of the constrained node");
const DOF1: Arg = Arg::whole("dof1", "degree of freedom");
const COUNT: Arg = Arg::count("count", "number of pairs of degrees of freedom");
const RETAINED_DOF1: Arg = Arg::whole("retainedDof1", "degree of freedom of the retained node");
const CONSTRAINED_DOF1: Arg = Arg::whole("constrainedDof1", "degree of freedom of the constrained node");
const PERPENDICULAR: Arg = Arg::whole("perpendicular", "direction perpendicular to the diaphragm");
const CONSTRAINED1: Arg = Arg::whole("constrained1", "tag of a constrained node");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("fix", FIX, fix)
        .arguments(&[NODE, Arg::whole("flag1", "flag of degree of freedom 1")])
        .about("Holds degrees of freedom of a node."),
    Command::new("fixX", FIX_LEVEL, |i, c| fix_level(i, c, 0))
        .arguments(&[COORDINATE, Arg::whole("flag1", "flag of degree of freedom 1"), TOL_TOLERANCE])
        .about("Holds degrees of freedom of all nodes at a coordinate x."),
    Command::new("fixY", FIX_LEVEL, |i, c| fix_level(i, c, 1))
        .about("Holds degrees of freedom of all nodes at a coordinate y."),
    Command::new("fixZ", FIX_LEVEL, |i, c| fix_level(i, c, 2))
        .about("Holds degrees of freedom of all nodes at a coordinate z."),
    Command::new("equalDOF", EQUAL, equal_dof)
        .arguments(&[RETAINED, CONSTRAINED, DOF1])
        .about("Gives degrees of freedom of two nodes the same displacement."),
    Command::new("equalDOF_Mixed", EQUAL_MIXED, equal_dof_mixed)
        .about("Gives degrees of freedom of two nodes the same displacement, pair by pair.")
        .arguments(&[
            RETAINED,
            CONSTRAINED,
            COUNT,
            RETAINED_DOF1,
            CONSTRAINED_DOF1,
            Arg::new("retainedDof2", "further pairs: degree of freedom of the retained node"),
            Arg::new("constrainedDof2", "further pairs: degree of freedom of the constrained node"),
        ]),
    Command::new("rigidDiaphragm", DIAPHRAGM, rigid_diaphragm)
        .arguments(&[PERPENDICULAR, RETAINED, CONSTRAINED1])
        .about(
            "Makes nodes move in a plane like one rigid body. In a plane model 1 and 2 make that displacement \
         equal, and 3 makes a rigid body.",
        ),
    Command::new("rigidLink", LINK, rigid_link)
        .arguments(&[RETAINED, CONSTRAINED])
        .about("Makes a node follow another: `beam` with its rotation, `bar` without."),
];

const FIX: &str = "fix $node $flag1 <$flag2 ...> (1 held, 0 free)";
const FIX_LEVEL: &str = "fixX $coordinate $flag1 <$flag2 ...> <-tol $tolerance>";
const EQUAL: &str = "equalDOF $retained $constrained $dof1 <$dof2 ...>";
const EQUAL_MIXED: &str =
    "equalDOF_Mixed $retained $constrained $count $retainedDof1 $constrainedDof1 <$retainedDof2 $constrainedDof2 ...>";
const DIAPHRAGM: &str = "rigidDiaphragm $perpendicular $retained $constrained1 <$constrained2 ...>";
const LINK: &str = "rigidLink beam|bar $retained $constrained";

fn flags(interp: &mut Tcl, a: &mut Args<'_>, n: usize) -> Result<Vec<bool>, Exception> {
    (1..=n).map(|i| a.nth_switch(interp, "flag of degree of freedom", i)).collect()
}

fn hold(interp: &mut Tcl, node: NodeId, flags: &[bool]) {
    let dofs: Vec<usize> = (0..flags.len()).filter(|&i| flags[i]).collect();
    let tags: Vec<i32> = dofs.iter().map(|_| interp.host.sp_tag()).collect();
    interp.host.engine.change_model(|model| {
        for (dof, tag) in dofs.into_iter().zip(tags) {
            if !model.fixes.iter().any(|f| f.node == node && f.dof == dof) {
                model.fixes.push(Fix { node, dof, tag });
            }
        }
    });
}

fn fix(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIX);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let ndf = interp.host.engine.model().nodes[node.0].ndf;
    let flags = flags(interp, &mut a, ndf)?;
    finish(interp, &a)?;
    hold(interp, node, &flags);
    Ok(Value::EMPTY)
}

/// `fixX` and its sisters: all nodes at a coordinate.
fn fix_level(interp: &mut Tcl, call: &Call<'_>, direction: usize) -> Outcome {
    let mut a = Args::new(call, FIX_LEVEL);
    let level = a.number(&COORDINATE)?;
    let words = a.ahead().map(|v| v.as_str().into_owned());
    let given = words.take_while(|w| w != "-tol").count();
    // Without a flag nothing would be held.
    let flags = flags(interp, &mut a, given.max(1))?;
    let tolerance = if a.flag("-tol") { a.number(&TOL_TOLERANCE)? } else { 1e-10 };
    finish(interp, &a)?;
    let model = interp.host.engine.model();
    let at_level =
        |n: &hysteron_engine::model::Node| n.coords.get(direction).is_some_and(|x| (x - level).abs() <= tolerance);
    let nodes: Vec<NodeId> = (0..model.nodes.len()).map(NodeId).filter(|n| at_level(&model.nodes[n.0])).collect();
    if nodes.is_empty() {
        return Err(a.refuse_at(call.span(1), format!("{}: no node has this coordinate", call.name()), ""));
    }
    for node in nodes {
        let ndf = interp.host.engine.model().nodes[node.0].ndf;
        hold(interp, node, &flags[..flags.len().min(ndf)]);
    }
    Ok(Value::EMPTY)
}

/// Add a constraint: `matrix` times the retained degrees of freedom are the constrained ones, row by row. Of a node with itself
/// there is none.
pub(crate) fn add(
    interp: &mut Tcl,
    retained: NodeId,
    constrained: NodeId,
    dofs: (Vec<usize>, Vec<usize>),
    matrix: Vec<f64>,
) {
    if constrained == retained {
        return;
    }
    let tag = interp.host.mp_tag();
    let (constrained_dofs, retained_dofs) = dofs;
    interp.host.engine.change_model(|model| {
        model.multi_points.push(MultiPoint { constrained, retained, constrained_dofs, retained_dofs, matrix, tag });
    });
}

/// Retained and constrained node.
fn pair(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(NodeId, NodeId), Exception> {
    let retained = node_of(interp, a, RETAINED.meaning)?;
    Ok((retained, follower(interp, a, retained)?.unwrap_or(retained)))
}

/// A node that follows the retained one; `None` where it is that node itself, as in loops over all nodes of a floor.
fn follower(interp: &mut Tcl, a: &mut Args<'_>, retained: NodeId) -> Result<Option<NodeId>, Exception> {
    let constrained = node_of(interp, a, CONSTRAINED.meaning)?;
    if constrained != retained {
        return Ok(Some(constrained));
    }
    let d = Diagnostic::warning(&checks::model::FOLLOWS_ITSELF, "a node follows itself: nothing is constrained");
    warn(interp, d.at(a.last_span(), "expected another node than the retained one"))?;
    Ok(None)
}

fn equal_dof(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, EQUAL);
    let (retained, constrained) = pair(interp, &mut a)?;
    let nodes = &interp.host.engine.model().nodes;
    let limit = nodes[retained.0].ndf.min(nodes[constrained.0].ndf);
    let mut dofs = vec![a.dof(DOF1.meaning, limit)?];
    while a.left() > 0 {
        dofs.push(a.dof(DOF1.meaning, limit)?);
    }
    let n = dofs.len();
    let mut matrix = vec![0.0; n * n];
    (0..n).for_each(|i| matrix[i * n + i] = 1.0);
    add(interp, retained, constrained, (dofs.clone(), dofs), matrix);
    Ok(Value::EMPTY)
}

fn equal_dof_mixed(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, EQUAL_MIXED);
    let (retained, constrained) = pair(interp, &mut a)?;
    let nodes = &interp.host.engine.model().nodes;
    let (of_retained, of_constrained) = (nodes[retained.0].ndf, nodes[constrained.0].ndf);
    let n = a.count(&COUNT)?;
    let (mut leading, mut following) = (vec![], vec![]);
    for _ in 0..n {
        leading.push(a.dof(RETAINED_DOF1.meaning, of_retained)?);
        let dof = a.dof(CONSTRAINED_DOF1.meaning, of_constrained)?;
        if following.contains(&dof) {
            return Err(a.refuse(format!("degree of freedom {} follows two", dof + 1), "expected another one"));
        }
        following.push(dof);
    }
    finish(interp, &a)?;
    let mut matrix = vec![0.0; n * n];
    (0..n).for_each(|i| matrix[i * n + i] = 1.0);
    add(interp, retained, constrained, (following, leading), matrix);
    Ok(Value::EMPTY)
}

fn rigid_diaphragm(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, DIAPHRAGM);
    let ndm = interp.host.builder.ndm;
    let normal = a.dof(PERPENDICULAR.meaning, 3)?;
    let retained = node_of(interp, &mut a, RETAINED.meaning)?;
    if a.left() == 0 {
        node_of(interp, &mut a, CONSTRAINED1.meaning)?;
    }
    let ndf = interp.host.engine.model().nodes[retained.0].ndf;
    if ndm == 2 {
        return plane_diaphragm(interp, &mut a, normal, retained);
    }
    if ndm != 3 || ndf != 6 {
        let message = format!("rigidDiaphragm is ignored: the node has {ndf} degrees of freedom in {ndm} dimensions");
        let d = Diagnostic::warning(&checks::model::DIAPHRAGM_IGNORED, message)
            .at(call.span(0), "nothing is joined in this model");
        warn(interp, d.help("it needs 3 dimensions and 6 degrees of freedom a node, or a model in the plane"))?;
        return Ok(Value::EMPTY);
    }
    // The two directions in the plane, and the rotation about its normal.
    let (p, q) = [(1, 2), (2, 0), (0, 1)][normal];
    while a.left() > 0 {
        let Some(node) = follower(interp, &mut a, retained)? else { continue };
        let nodes = &interp.host.engine.model().nodes;
        let arm = nodes[node.0].place() - nodes[retained.0].place();
        if nodes[node.0].ndf != 6 {
            return Err(a.refuse("the node has not got 6 degrees of freedom", ""));
        }
        if arm[normal].abs() > 1e-9 * arm.norm().max(1.0) {
            let axis = ["x", "y", "z"][normal];
            let message = format!("the node does not lie in the diaphragm: its {axis} differs by {}", arm[normal]);
            a.doubt(interp, message, "expected a node in the plane of the retained one")?;
            // OpenSees leaves it out.
            continue;
        }
        let matrix = vec![1.0, 0.0, -arm[q], 0.0, 1.0, arm[p], 0.0, 0.0, 1.0];
        let dofs = vec![p, q, 3 + normal];
        add(interp, retained, node, (dofs.clone(), dofs), matrix);
    }
    Ok(Value::EMPTY)
}

/// `rigidDiaphragm` in a plane model: the direction itself is made equal; 3 makes the nodes one rigid body in the plane.
fn plane_diaphragm(interp: &mut Tcl, a: &mut Args<'_>, direction: usize, retained: NodeId) -> Outcome {
    let needed = if direction == 2 { 3 } else { direction + 1 };
    while a.left() > 0 {
        let Some(node) = follower(interp, a, retained)? else { continue };
        let nodes = &interp.host.engine.model().nodes;
        if nodes[node.0].ndf.min(nodes[retained.0].ndf) < needed {
            let message =
                format!("rigidDiaphragm {}: a node has fewer than {needed} degrees of freedom", direction + 1);
            return Err(a.refuse(message, "expected nodes that have them"));
        }
        let arm = nodes[node.0].place() - nodes[retained.0].place();
        if direction == 2 {
            let matrix = vec![1.0, 0.0, -arm.y, 0.0, 1.0, arm.x, 0.0, 0.0, 1.0];
            add(interp, retained, node, (vec![0, 1, 2], vec![0, 1, 2]), matrix);
            continue;
        }
        let apart = arm[1 - direction];
        if apart.abs() > 1e-9 * arm.norm().max(1.0) {
            let axis = ["y", "x"][direction];
            let message =
                format!("rigidDiaphragm: the {axis} of the node differs by {apart} from that of the retained one");
            let d = Diagnostic::warning(&checks::model::DIAPHRAGM_APART, message)
                .at(a.last_span(), "moves as far as it, without the turn of a rigid body");
            warn(interp, d)?;
        }
        add(interp, retained, node, (vec![direction], vec![direction]), vec![1.0]);
    }
    Ok(Value::EMPTY)
}

fn rigid_link(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, LINK);
    let kind = a.word("kind of link")?;
    let beam = match kind.as_ref() {
        "beam" | "-beam" => true,
        "bar" | "-bar" | "rod" | "-rod" => false,
        _ => return Err(a.unknown_name("kind of rigid link", ["beam", "bar"])),
    };
    let (retained, constrained) = pair(interp, &mut a)?;
    finish(interp, &a)?;
    let nodes = &interp.host.engine.model().nodes;
    let (r, c) = (&nodes[retained.0], &nodes[constrained.0]);
    let (ndm, ndf, arm) = (r.ndm(), r.ndf, c.place() - r.place());
    if ndf != c.ndf {
        return Err(a.refuse("the two nodes have different numbers of degrees of freedom", ""));
    }
    let n = if beam { ndf } else { ndm.min(ndf) };
    let mut matrix = vec![0.0; n * n];
    (0..n).for_each(|i| matrix[i * n + i] = 1.0);
    match (beam, ndm, ndf) {
        (true, 2, 3) => {
            matrix[2] = -arm.y;
            matrix[n + 2] = arm.x;
        }
        (true, 3, 6) => {
            for (i, row) in (-arm.cross_matrix()).row_iter().enumerate() {
                row.iter().enumerate().for_each(|(j, x)| matrix[i * n + 3 + j] = *x);
            }
        }
        _ => {}
    }
    let dofs: Vec<usize> = (0..n).collect();
    add(interp, retained, constrained, (dofs.clone(), dofs), matrix);
    Ok(Value::EMPTY)
}
