//! Columns and girders of a model, at whose ends hinges can form.

use hysteron_engine::model::{ElementEntry, Model, NodeId};

/// An elastic beam: a column on a support, a girder or a bearing, or a girder itself.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FrameMember {
    /// Tag of the beam.
    pub(crate) tag: i32,
    /// Tag of the node at the foot; of a girder, its first node.
    pub(crate) foot: i32,
    /// Tag of the node at the other end.
    pub(crate) head: i32,
    /// End of the beam at the foot, 0 or 1.
    pub(crate) foot_end: usize,
    /// Height of the foot, length.
    pub(crate) level: f64,
    /// Largest initial stiffness against rotation of the foot about a horizontal axis, moment.
    pub(crate) rotational_stiffness: f64,
    /// Distance of the nodes, length.
    pub(crate) length: f64,
}

impl FrameMember {
    /// A beam whose end `foot_end` is its foot.
    fn new(model: &Model, e: &ElementEntry, foot_end: usize, ndm: usize) -> Self {
        let (n, dofs_per_node) = (e.element.dofs(), e.element.dofs() / 2);
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        let rotations = horizontal_rotations(ndm).iter().map(|r| foot_end * dofs_per_node + r - 1).filter(|i| *i < n);
        let rotational_stiffness = rotations.map(|i| tangent[i * n + i]).fold(0.0, f64::max);
        let (foot, head) = (&model.nodes[e.nodes[foot_end].0], &model.nodes[e.nodes[1 - foot_end].0]);
        let length = (head.place() - foot.place()).norm();
        let level = foot.place()[ndm - 1];
        Self { tag: e.tag, foot: foot.tag, head: head.tag, foot_end, level, rotational_stiffness, length }
    }

    /// Lateral stiffness of a column whose ends do not turn, force per length: 12 EI/L³, from 4 EI/L against rotation of an end.
    pub(crate) fn sway_stiffness(&self) -> f64 {
        3.0 * self.rotational_stiffness / (self.length * self.length)
    }
}

/// Degrees of freedom of a node, from 1, that are rotations about horizontal axes.
fn horizontal_rotations(ndm: usize) -> &'static [usize] {
    if ndm == 2 { &[3] } else { &[4, 5] }
}

/// Least rise over length of an upright beam.
const MIN_UPRIGHT_SLOPE: f64 = 0.7;

/// Rise of a two-node element from its first to its second node, over its length.
fn slope(model: &Model, nodes: &[NodeId], ndm: usize) -> Option<f64> {
    let [i, j] = nodes[..] else { return None };
    let axis = model.nodes[j.0].place() - model.nodes[i.0].place();
    Some(axis[ndm - 1] / axis.norm())
}

/// The columns among beams, the lowest first.
pub(crate) fn columns(model: &Model, beams: &[i32]) -> Vec<FrameMember> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()).filter(|n| *n > 1) else { return vec![] };
    let foot_end = |nodes: &[NodeId]| {
        let slope = slope(model, nodes, ndm).filter(|slope| slope.abs() > MIN_UPRIGHT_SLOPE)?;
        Some(usize::from(slope < 0.0))
    };
    let is_beam = |tag: i32| beams.contains(&tag);
    let mut out: Vec<FrameMember> = vec![];
    for e in model.elements.iter().filter(|e| is_beam(e.tag)) {
        let Some(end) = foot_end(&e.nodes) else { continue };
        let foot = e.nodes[end];
        let others: Vec<_> = model.elements.iter().filter(|o| o.tag != e.tag && o.nodes.contains(&foot)).collect();
        let fixed = model.fixes.iter().any(|f| f.node == foot);
        // Of a pier made of several beams only the lowest has a foot.
        let stands = if fixed {
            others.iter().all(|o| !is_beam(o.tag))
        } else {
            others.iter().any(|o| !is_beam(o.tag) || foot_end(&o.nodes).is_none())
        };
        if !stands {
            continue;
        }
        out.push(FrameMember::new(model, e, end, ndm));
    }
    out.sort_by(|a, b| a.level.total_cmp(&b.level));
    out
}

/// The girders among beams, in the order of the script.
pub(crate) fn girders(model: &Model, beams: &[i32]) -> Vec<FrameMember> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()).filter(|n| *n > 1) else { return vec![] };
    let lies = |e: &&ElementEntry| slope(model, &e.nodes, ndm).is_some_and(|slope| slope.abs() <= MIN_UPRIGHT_SLOPE);
    let all = model.elements.iter().filter(|e| beams.contains(&e.tag)).filter(lies);
    all.map(|e| FrameMember::new(model, e, 0, ndm)).collect()
}
