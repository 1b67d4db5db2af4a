//! The multi-point constraints as OpenSees' `Transformation` handler has them.

use crate::model::{ElementEntry, Model, MultiPoint};
use std::collections::BTreeMap;

/// A degree of freedom that follows, and what it follows: degrees of freedom and coefficients.
pub(super) type Row = (usize, Vec<(usize, f64)>);

/// A constrained node of the handler. It is late if it follows degrees of freedom without an equation: those that are held, and
/// those of a node that follows another and has the greater tag. It is then moved to where they are, and not with the equations.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformedNode {
    /// The constrained degrees of freedom.
    pub rows: Vec<TransformedRow>,
    /// Its degrees of freedom that do not follow.
    pub own: Vec<usize>,
    /// Degrees of freedom of the retained node that have no equation.
    pub retained: Vec<usize>,
    /// The retained node has the greater tag, so that it is moved after the constrained one.
    pub moves_first: bool,
    /// What has no equation moves, or takes a motion of the equations with it.
    pub late: bool,
    /// The retained node is constrained too.
    pub chained: bool,
    /// Its mass joins degrees of freedom of several nodes that no element joins. OpenSees' matrices drop such terms, all but
    /// that of `FullGeneral`.
    pub joins_alone: bool,
}

/// A constrained degree of freedom of a [`TransformedNode`].
#[derive(Clone, Debug, PartialEq)]
pub struct TransformedRow {
    /// Global degree of freedom.
    pub dof: usize,
    /// Degrees of freedom with an equation that it follows, and coefficients.
    pub equations: Vec<(usize, f64)>,
    /// Places in [`TransformedNode::retained`], and coefficients.
    pub retained: Vec<(usize, f64)>,
}

/// Rows of the first constraint of each constrained node, and the nodes by rising tag. `stands` says which degrees of freedom are
/// held at zero.
///
/// A node that follows one which follows another takes the equations of the latter, and not its motion: the two
/// constraints are not multiplied. It takes none if the node that it follows has the greater tag.
pub(super) fn rows(model: &Model, held: &[bool], stands: impl Fn(usize) -> bool) -> (Vec<Row>, Vec<TransformedNode>) {
    let mut first: BTreeMap<_, &MultiPoint> = BTreeMap::new();
    for mp in &model.multi_points {
        first.entry(model.nodes[mp.constrained.0].tag).or_insert(mp);
    }
    let mut equations: BTreeMap<_, Vec<Option<usize>>> = BTreeMap::new();
    let (mut rows, mut nodes) = (vec![], vec![]);
    for (&tag, mp) in &first {
        let retained = &model.nodes[mp.retained.0];
        let at = |dof: usize| match (equations.get(&retained.tag), first.get(&retained.tag)) {
            (Some(known), _) => known.get(dof).copied().flatten(),
            (None, Some(later)) => free(model, later).get(dof).copied(),
            (None, None) => Some(retained.offset + dof),
        };
        let equation = |dof: usize| at(dof).filter(|&d| !held[d]);
        let offset = model.nodes[mp.constrained.0].offset;
        let without: Vec<usize> =
            mp.retained_dofs.iter().filter(|&&d| equation(d).is_none()).map(|d| retained.offset + d).collect();
        let (own, moves_first) = (free(model, mp), retained.tag > tag);
        let chained = first.contains_key(&retained.tag);
        let (rows_of_node, late, joins_alone) = (vec![], false, false);
        let mut node =
            TransformedNode { rows: rows_of_node, own, retained: without, moves_first, late, chained, joins_alone };
        for (i, &dof) in mp.constrained_dofs.iter().enumerate() {
            let terms = || mp.row(i).filter(|(_, k)| *k != 0.0);
            let own: Vec<_> = terms().filter_map(|(d, k)| Some((equation(d)?, k))).collect();
            let place = |d| node.retained.iter().position(|&r| r == retained.offset + d);
            let others = terms().filter_map(|(d, k)| Some((place(d)?, k))).collect();
            node.rows.push(TransformedRow { dof: offset + dof, equations: own.clone(), retained: others });
            rows.push((offset + dof, own));
        }
        let moves = node.rows.iter().any(|r| !r.equations.is_empty()) || node.retained.iter().any(|&dof| !stands(dof));
        node.late = !node.retained.is_empty() && moves;
        node.joins_alone = mass_joins_alone(model, mp.constrained.0, &node);
        let own = node.own.iter().copied().map(Some);
        let list = own.chain(mp.retained_dofs.iter().map(|&d| at(d))).collect();
        equations.insert(tag, list);
        nodes.push(node);
    }
    (rows, nodes)
}

/// Degrees of freedom of constrained nodes that stand still because one before them is held and follows as well: the
/// handler takes the number of the latter for theirs.
pub(super) fn frozen(model: &Model, held: &[bool]) -> Vec<usize> {
    let mut seen = std::collections::BTreeSet::new();
    let mut out = vec![];
    for mp in model.multi_points.iter().filter(|mp| seen.insert(mp.constrained)) {
        let offset = model.nodes[mp.constrained.0].offset;
        let own = free(model, mp);
        let both = mp.constrained_dofs.iter().map(|d| offset + d).filter(|&d| held[d]);
        out.extend(both.filter_map(|d| own.iter().copied().find(|&x| x > d)));
    }
    out
}

/// Degrees of freedom of the constrained node that do not follow.
fn free(model: &Model, mp: &MultiPoint) -> Vec<usize> {
    let offset = model.nodes[mp.constrained.0].offset;
    model.nodes[mp.constrained.0].dofs().filter(|d| !mp.constrained_dofs.contains(&(d - offset))).collect()
}

/// A mass of the node moves with equations of two nodes which no element joins.
fn mass_joins_alone(model: &Model, index: usize, node: &TransformedNode) -> bool {
    let constrained = &model.nodes[index];
    let place = |dof: usize| model.nodes.partition_point(|n| n.offset <= dof) - 1;
    let heavy =
        node.rows.iter().filter(|r| constrained.mass.get(r.dof - constrained.offset).is_some_and(|&m| m != 0.0));
    heavy
        .filter_map(|r| {
            let nodes = || r.equations.iter().map(|&(dof, _)| place(dof));
            let first = nodes().next()?;
            Some((first, nodes().find(|&n| n != first)?))
        })
        .any(|(a, b)| {
            let has = |e: &ElementEntry, node| e.nodes.iter().any(|n| n.0 == node);
            !model.elements.iter().any(|e| has(e, a) && has(e, b))
        })
}
