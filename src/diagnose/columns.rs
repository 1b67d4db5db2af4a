//! Columns of a model, at whose feet hinges can form.

use crate::model::{Model, NodeId};

/// A beam that is taken as elastic and stands upright on something: a support, a girder or a bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Tag of the beam.
    pub tag: i32,
    /// Tag of the node that it stands on.
    pub node: i32,
    /// Height of that node.
    pub level: f64,
    /// Largest stiffness of the beam against rotations of that node about the horizontal axes.
    pub rotational: f64,
}

/// Degrees of freedom of a node, from 1, that are rotations about horizontal axes.
pub fn rotations(ndm: usize) -> &'static [usize] {
    if ndm == 2 { &[3] } else { &[4, 5] }
}

/// Part of its length by which a beam rises that is called upright.
const UPRIGHT: f64 = 0.7;

/// The columns among some beams, the lowest first.
pub(super) fn columns(model: &Model, beams: &[i32]) -> Vec<Column> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()).filter(|n| *n > 1) else { return vec![] };
    let rise = |nodes: &[NodeId]| -> Option<(usize, f64)> {
        let [i, j] = nodes[..] else { return None };
        let way = model.nodes[j.0].place() - model.nodes[i.0].place();
        let part = way[ndm - 1] / way.norm();
        (part.abs() > UPRIGHT).then_some((usize::from(part < 0.0), part))
    };
    let is_beam = |tag: i32| beams.contains(&tag);
    let mut out: Vec<Column> = vec![];
    for e in model.elements.iter().filter(|e| is_beam(e.tag)) {
        let Some((end, _)) = rise(&e.nodes) else { continue };
        let foot = e.nodes[end];
        let others: Vec<_> = model.elements.iter().filter(|o| o.tag != e.tag && o.nodes.contains(&foot)).collect();
        let fixed = model.fixes.iter().any(|f| f.node == foot);
        // Where a pier is made of several beams only its lowest end is one.
        let stands = if fixed {
            others.iter().all(|o| !is_beam(o.tag))
        } else {
            others.iter().any(|o| !is_beam(o.tag) || rise(&o.nodes).is_none())
        };
        if !stands {
            continue;
        }
        let (n, own) = (e.element.dofs(), e.element.dofs() / 2);
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        let about = rotations(ndm).iter().map(|r| end * own + r - 1).filter(|i| *i < n);
        let rotational = about.map(|i| tangent[i * n + i]).fold(0.0, f64::max);
        let node = &model.nodes[foot.0];
        out.push(Column { tag: e.tag, node: node.tag, level: node.place()[ndm - 1], rotational });
    }
    out.sort_by(|a, b| a.level.total_cmp(&b.level));
    out
}
