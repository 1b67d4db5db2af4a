//! The multi-point constraints as OpenSees' `Transformation` handler has them.

use crate::model::{Model, MultiPoint};
use std::collections::BTreeMap;

/// A degree of freedom that follows, and what it follows: degrees of freedom and coefficients.
pub(super) type Row = (usize, Vec<(usize, f64)>);

/// Rows of the first constraint of each constrained node.
///
/// A node that follows one which follows another takes the equations of the latter, and not its motion: the two
/// constraints are not multiplied. It takes none if the node that it follows has the greater tag.
pub(super) fn rows(model: &Model) -> Vec<Row> {
    let mut first: BTreeMap<_, &MultiPoint> = BTreeMap::new();
    for mp in &model.multi_points {
        first.entry(model.nodes[mp.constrained.0].tag).or_insert(mp);
    }
    let mut equations: BTreeMap<_, Vec<Option<usize>>> = BTreeMap::new();
    let mut rows = vec![];
    for (&tag, mp) in &first {
        let retained = &model.nodes[mp.retained.0];
        let at = |dof: usize| match (equations.get(&retained.tag), first.get(&retained.tag)) {
            (Some(known), _) => known.get(dof).copied().flatten(),
            (None, Some(later)) => free(model, later).get(dof).copied(),
            (None, None) => Some(retained.offset + dof),
        };
        let offset = model.nodes[mp.constrained.0].offset;
        for (i, &dof) in mp.constrained_dofs.iter().enumerate() {
            let terms = mp.row(i).filter(|(_, k)| *k != 0.0).filter_map(|(d, k)| Some((at(d)?, k)));
            rows.push((offset + dof, terms.collect()));
        }
        let own = free(model, mp).into_iter().map(Some);
        let list = own.chain(mp.retained_dofs.iter().map(|&d| at(d))).collect();
        equations.insert(tag, list);
    }
    rows
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
