//! Columns and girders of a model, at whose ends hinges can form.

use hysteron_engine::model::{ElementEntry, Model, NodeId};

/// A beam that is taken as elastic: a column, which stands upright on something (a support, a girder or a bearing), or a girder.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Tag of the beam.
    pub tag: i32,
    /// Tag of the node that it stands on; the first one of a girder.
    pub node: i32,
    /// Tag of the node at its other end.
    pub head: i32,
    /// Which end of the beam that is, 0 or 1.
    pub end: usize,
    /// Height of the first node.
    pub level: f64,
    /// Largest stiffness of the beam against rotations of that node about the horizontal axes.
    pub rotational: f64,
    /// Distance of its nodes.
    pub length: f64,
}

impl Column {
    /// A beam with this end (0 or 1) as the one that it stands on.
    fn standing(model: &Model, e: &ElementEntry, end: usize, ndm: usize) -> Self {
        let (n, own) = (e.element.dofs(), e.element.dofs() / 2);
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        let about = rotations(ndm).iter().map(|r| end * own + r - 1).filter(|i| *i < n);
        let rotational = about.map(|i| tangent[i * n + i]).fold(0.0, f64::max);
        let (foot, head) = (&model.nodes[e.nodes[end].0], &model.nodes[e.nodes[1 - end].0]);
        let length = (head.place() - foot.place()).norm();
        Self { tag: e.tag, node: foot.tag, head: head.tag, end, level: foot.place()[ndm - 1], rotational, length }
    }
}

/// Degrees of freedom of a node, from 1, that are rotations about horizontal axes.
pub fn rotations(ndm: usize) -> &'static [usize] {
    if ndm == 2 { &[3] } else { &[4, 5] }
}

/// Part of its length by which a beam rises that is called upright.
const UPRIGHT: f64 = 0.7;

/// Part of its length by which an element with two nodes rises from the first to the second.
fn rise(model: &Model, nodes: &[NodeId], ndm: usize) -> Option<f64> {
    let [i, j] = nodes[..] else { return None };
    let way = model.nodes[j.0].place() - model.nodes[i.0].place();
    Some(way[ndm - 1] / way.norm())
}

/// The columns among some beams, the lowest first.
pub(crate) fn columns(model: &Model, beams: &[i32]) -> Vec<Column> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()).filter(|n| *n > 1) else { return vec![] };
    // The end on which what stands upright stands.
    let foot_of = |nodes: &[NodeId]| {
        let part = rise(model, nodes, ndm).filter(|part| part.abs() > UPRIGHT)?;
        Some(usize::from(part < 0.0))
    };
    let is_beam = |tag: i32| beams.contains(&tag);
    let mut out: Vec<Column> = vec![];
    for e in model.elements.iter().filter(|e| is_beam(e.tag)) {
        let Some(end) = foot_of(&e.nodes) else { continue };
        let foot = e.nodes[end];
        let others: Vec<_> = model.elements.iter().filter(|o| o.tag != e.tag && o.nodes.contains(&foot)).collect();
        let fixed = model.fixes.iter().any(|f| f.node == foot);
        // Where a pier is made of several beams only its lowest end is one.
        let stands = if fixed {
            others.iter().all(|o| !is_beam(o.tag))
        } else {
            others.iter().any(|o| !is_beam(o.tag) || foot_of(&o.nodes).is_none())
        };
        if !stands {
            continue;
        }
        out.push(Column::standing(model, e, end, ndm));
    }
    out.sort_by(|a, b| a.level.total_cmp(&b.level));
    out
}

/// The girders among some beams, in the order of the script: what lies, or nearly.
pub(crate) fn girders(model: &Model, beams: &[i32]) -> Vec<Column> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()).filter(|n| *n > 1) else { return vec![] };
    let lies = |e: &&ElementEntry| rise(model, &e.nodes, ndm).is_some_and(|part| part.abs() <= UPRIGHT);
    let all = model.elements.iter().filter(|e| beams.contains(&e.tag)).filter(lies);
    all.map(|e| Column::standing(model, e, 0, ndm)).collect()
}
