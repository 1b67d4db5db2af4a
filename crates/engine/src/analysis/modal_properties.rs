//! Share of the mass that each mode moves: participation factors and effective masses.
//!
//! Chopra, Dynamics of Structures, chapter 13; the rules for rotations and for consistent masses are those of OpenSees
//! (`modalProperties`).

use super::modes::Modes;
use crate::element::Mass;
use crate::model::{Model, Node};

/// Participation of the modes in rigid motions of the ground: translations, and rotations about the center of mass.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModalProperties {
    /// Number of dimensions.
    pub ndm: usize,
    /// Eigenvalues λ = ω².
    pub lambda: Vec<f64>,
    /// Mass in each direction, that of held degrees of freedom included.
    pub total_mass: Vec<f64>,
    /// Mass of the free degrees of freedom in each direction.
    pub free_mass: Vec<f64>,
    /// Center of the free mass; of the free nodes in directions without mass.
    pub center: Vec<f64>,
    /// Participation factors, by mode and direction.
    pub factors: Vec<Vec<f64>>,
    /// Effective masses, by mode and direction.
    pub masses: Vec<Vec<f64>>,
}

/// Masses that belong together, over some degrees of freedom.
struct Block<'a> {
    /// Node and its degree of freedom by row.
    owners: Vec<(usize, usize)>,
    /// Global degree of freedom by row.
    dofs: Vec<usize>,
    matrix: std::borrow::Cow<'a, [f64]>,
}

/// Number of directions: translations and rotations.
fn directions(ndm: usize) -> usize {
    [0, 1, 3, 6][ndm.min(3)]
}

/// Direction of a node's degree of freedom; none for a pressure.
fn direction(node: &Node, dof: usize, ndf: usize) -> Option<usize> {
    let pressure = node.ndf == 4 && ndf == 6 && dof == 3;
    (dof < ndf && !pressure).then_some(dof)
}

/// Displacement of a point at `d` from the center in the translations of a rigid motion in a direction.
fn rigid(ndm: usize, direction: usize, d: [f64; 3]) -> [f64; 3] {
    let mut r = [0.0; 3];
    match (ndm, direction) {
        (2, 2) | (3, 5) => [r[0], r[1]] = [-d[1], d[0]],
        (3, 3) => [r[1], r[2]] = [-d[2], d[1]],
        (3, 4) => [r[0], r[2]] = [d[2], -d[0]],
        _ => r[direction.min(2)] = f64::from(u8::from(direction < ndm)),
    }
    r
}

impl ModalProperties {
    /// Of the modes of a model. With `unit_shapes`, shapes are scaled so that their largest component is one.
    pub fn new(model: &Model, modes: &Modes, unit_shapes: bool) -> Self {
        let ndm = model.nodes.first().map_or(0, Node::ndm);
        let ndf = directions(ndm);
        let mut free = vec![true; model.dofs()];
        let imposed = model.patterns.values().flat_map(|p| p.motions.iter().map(|m| (m.node, m.dof)));
        for (node, dof) in model.fixes.iter().map(|f| (f.node, f.dof)).chain(imposed) {
            free[model.nodes[node.0].offset + dof] = false;
        }
        let blocks = blocks(model);
        let mut all = vec![[0.0; 6]; model.nodes.len()];
        let mut moving = all.clone();
        for block in &blocks {
            for ((node, dof), global, mass) in lumped(model, block, ndf) {
                all[node][dof] += mass;
                if free[global] {
                    moving[node][dof] += mass;
                }
            }
        }
        let center = center(model, &moving, &free, ndm);
        let arms: Vec<[f64; 3]> = model.nodes.iter().map(|n| arm(n, &center)).collect();
        let total = |lumped: &[[f64; 6]]| -> Vec<f64> {
            let mass = |d: usize, (m, arm): (&[f64; 6], &[f64; 3])| {
                let swung = rigid(ndm, d, *arm);
                let turning: f64 = (0..ndm).map(|i| m[i] * swung[i] * swung[i]).sum();
                if d < ndm { m[d] } else { m[d] + turning }
            };
            (0..ndf).map(|d| lumped.iter().zip(&arms).map(|x| mass(d, x)).sum()).collect()
        };
        let (total_mass, free_mass) = (total(&all), total(&moving));
        let mut properties =
            Self { ndm, lambda: modes.lambda.clone(), total_mass, free_mass, center, ..Self::default() };
        for shape in &modes.shapes {
            let scale = if unit_shapes { scale_to_unit(model, shape, ndf) } else { 1.0 };
            let (loads, generalized) = participation(model, &blocks, &free, shape, &arms);
            let (mut factors, mut masses) = (vec![], vec![]);
            for load in loads {
                let over = |x: f64| if generalized == 0.0 { 0.0 } else { x / generalized };
                // A shape that is scaled by s has a load s times as large, and s² times the generalized mass.
                factors.push(over(load) / scale);
                masses.push(over(load * load));
            }
            properties.factors.push(factors);
            properties.masses.push(masses);
        }
        properties
    }

    /// Effective masses as parts of the free mass, by mode and direction.
    pub fn ratios(&self) -> Vec<Vec<f64>> {
        let ratio = |(m, total): (&f64, &f64)| if *total == 0.0 { 0.0 } else { m / total };
        self.masses.iter().map(|row| row.iter().zip(&self.free_mass).map(ratio).collect()).collect()
    }
}

/// Sums over the modes up to each.
pub fn cumulative(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut sum = vec![0.0; rows.first().map_or(0, Vec::len)];
    let add = |row: &Vec<f64>| {
        sum.iter_mut().zip(row).for_each(|(s, x)| *s += x);
        sum.clone()
    };
    rows.iter().map(add).collect()
}

/// Masses of the elements and the nodes.
fn blocks(model: &Model) -> Vec<Block<'_>> {
    let mut blocks = vec![];
    for entry in &model.elements {
        let n = entry.dofs.len();
        let inertance = entry.element.inertance();
        let mut matrix = match entry.element.mass() {
            Mass::None if inertance.is_none() => continue,
            Mass::None => vec![0.0; n * n],
            Mass::Lumped(m) => diagonal(&m),
            Mass::Consistent(m) => m,
        };
        matrix.iter_mut().zip(inertance.iter().flatten()).for_each(|(m, b)| *m += b);
        if matrix.len() != n * n {
            continue;
        }
        let dofs: Vec<usize> = entry.dofs.iter().map(|d| *d as usize).collect();
        let owners = dofs.iter().map(|d| model.owner(*d)).map(|(node, dof)| (node.0, dof)).collect();
        blocks.push(Block { owners, dofs, matrix: matrix.into() });
    }
    for (i, node) in model.nodes.iter().enumerate() {
        let owners = (0..node.ndf).map(|d| (i, d)).collect();
        blocks.push(Block { owners, dofs: node.dofs().collect(), matrix: diagonal(&node.mass).into() });
    }
    blocks
}

fn diagonal(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let mut m = vec![0.0; n * n];
    values.iter().enumerate().for_each(|(i, x)| m[i * n + i] = *x);
    m
}

/// The diagonal of a mass matrix, scaled in each direction so that its sum is that of the rows: node and degree of
/// freedom, global degree of freedom, mass.
fn lumped<'a>(
    model: &'a Model,
    block: &'a Block<'_>,
    ndf: usize,
) -> impl Iterator<Item = ((usize, usize), usize, f64)> + 'a {
    let n = block.dofs.len();
    let along = move |i: usize| direction(&model.nodes[block.owners[i].0], block.owners[i].1, ndf);
    let (mut sums, mut diagonals) = ([0.0; 6], [0.0; 6]);
    for i in 0..n {
        if let Some(d) = along(i) {
            sums[d] += block.matrix[i * n..(i + 1) * n].iter().sum::<f64>();
            diagonals[d] += block.matrix[i * n + i];
        }
    }
    (0..n).filter_map(move |i| {
        let d = along(i)?;
        let scale = if diagonals[d] == 0.0 { 0.0 } else { sums[d] / diagonals[d] };
        Some((block.owners[i], block.dofs[i], block.matrix[i * n + i] * scale))
    })
}

fn center(model: &Model, masses: &[[f64; 6]], free: &[bool], ndm: usize) -> Vec<f64> {
    let along = |j: usize| {
        let (mut moment, mut mass, mut sum, mut count) = (0.0, 0.0, 0.0, 0.0);
        for (node, m) in model.nodes.iter().zip(masses) {
            if j < node.ndf && free[node.offset + j] {
                let x = node.place()[j];
                moment += x * m[j];
                mass += m[j];
                sum += x;
                count += 1.0;
            }
        }
        match (mass > 0.0, count > 0.0) {
            (true, _) => moment / mass,
            (false, true) => sum / count,
            (false, false) => 0.0,
        }
    };
    (0..ndm).map(along).collect()
}

fn arm(node: &Node, center: &[f64]) -> [f64; 3] {
    let x = node.place();
    std::array::from_fn(|i| x[i] - center.get(i).copied().unwrap_or(0.0))
}

/// One over the largest component of a shape.
fn scale_to_unit(model: &Model, shape: &[f64], ndf: usize) -> f64 {
    let largest = model
        .nodes
        .iter()
        .flat_map(|n| (0..n.ndf).filter_map(move |d| direction(n, d, ndf)).map(move |d| n.offset + d))
        .fold(0.0, |max: f64, dof| max.max(shape[dof].abs()));
    if largest == 0.0 { 1.0 } else { 1.0 / largest }
}

/// φᵀ M r for the rigid motions r in all directions, and φᵀ M φ, over the free degrees of freedom.
fn participation(
    model: &Model,
    blocks: &[Block<'_>],
    free: &[bool],
    shape: &[f64],
    arms: &[[f64; 3]],
) -> (Vec<f64>, f64) {
    let ndm = model.nodes.first().map_or(0, Node::ndm);
    let ndf = directions(ndm);
    let (mut loads, mut generalized) = (vec![0.0; ndf], 0.0);
    for block in blocks {
        let n = block.dofs.len();
        for (j, (node, dof)) in block.owners.iter().enumerate() {
            let Some(d) = direction(&model.nodes[*node], *dof, ndf).filter(|_| free[block.dofs[j]]) else { continue };
            let carried = |i: usize| {
                free[block.dofs[i]] && direction(&model.nodes[block.owners[i].0], block.owners[i].1, ndf).is_some()
            };
            let pull: f64 =
                (0..n).filter(|i| carried(*i)).map(|i| shape[block.dofs[i]] * block.matrix[i * n + j]).sum();
            generalized += pull * shape[block.dofs[j]];
            for (k, load) in loads.iter_mut().enumerate() {
                *load += pull * if d < ndm { rigid(ndm, k, arms[*node])[d] } else { f64::from(u8::from(d == k)) };
            }
        }
    }
    (loads, generalized)
}
