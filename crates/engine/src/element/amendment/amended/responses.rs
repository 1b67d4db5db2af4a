//! Responses of an element that follow its amendment: forces and deformations of the amended directions.

use super::WITHHELD_AT;
use crate::element::{BasicRow, Element, RowMaterial, Snapshot};

/// A response that an element computes from its own state, without the amendment.
///
/// Force and stress of an amended direction are those after the amendment. Deformation and strain are the total ones,
/// slack included. All other responses, such as tangents or the state of a law, stay those of the element.
#[derive(Clone, Debug)]
pub(super) struct AmendedResponse {
    /// Its probe path.
    pub(super) path: Vec<u32>,
    columns: Vec<Column>,
}

/// An amended column of a response.
#[derive(Clone, Copy, Debug)]
struct Column {
    /// Index in the response.
    index: usize,
    /// Index of the amended direction.
    direction: usize,
    quantity: Quantity,
}

#[derive(Clone, Copy, Debug)]
enum Quantity {
    /// A force times this factor.
    Force(f64),
    /// A deformation times this factor.
    Deformation(f64),
}

impl AmendedResponse {
    /// Amends a response by the amendment's own state variables.
    pub(super) fn amend(&self, own: &[f64], out: &mut [f64]) {
        for c in &self.columns {
            match c.quantity {
                Quantity::Force(factor) => out[c.index] += factor * own[2 + c.direction],
                // The deformation of the element itself differs from the total one by the withheld part.
                Quantity::Deformation(factor) if own[WITHHELD_AT + c.direction] != 0.0 => {
                    out[c.index] = factor * own[c.direction];
                }
                Quantity::Deformation(_) => {}
            }
        }
    }
}

/// The responses of an element that an amendment of its directions `rows` changes.
pub(super) fn amended(inner: &dyn Element, rows: &[BasicRow]) -> Vec<AmendedResponse> {
    let mut out: Vec<AmendedResponse> = vec![];
    let mut add = |words: &[&str], column: &dyn Fn(usize, usize) -> Vec<Column>| {
        let Some(probe) = inner.probe(words).filter(|p| !follows_end_forces(inner, &p.path, p.len())) else { return };
        let columns: Vec<Column> = (0..rows.len()).flat_map(|direction| column(direction, probe.len())).collect();
        match out.iter_mut().find(|r| r.path == probe.path) {
            Some(_) => {}
            None if columns.is_empty() || columns.iter().any(|c| c.index >= probe.len()) => {}
            None => out.push(AmendedResponse { path: probe.path, columns }),
        }
    };
    let force = |index, direction, factor| Column { index, direction, quantity: Quantity::Force(factor) };
    let deformation = |index, direction, factor| Column { index, direction, quantity: Quantity::Deformation(factor) };
    add(&["basicForce"], &|d, _| vec![force(rows[d].column, d, 1.0)]);
    add(&["deformation"], &|d, _| vec![deformation(rows[d].column, d, 1.0)]);
    add(&["defoANDforce"], &|d, n| vec![deformation(rows[d].column, d, 1.0), force(n / 2 + rows[d].column, d, 1.0)]);
    // End forces along local axes, which a bar computes from its material.
    let per_node = inner.dofs() / 2;
    add(&["localForce"], &|d, n| match rows[d].direction - 1 {
        axis if axis < 3 && n == 2 * per_node => vec![force(axis, d, -1.0), force(per_node + axis, d, 1.0)],
        _ => vec![],
    });
    for (own, row) in rows.iter().enumerate() {
        let Some(RowMaterial { number, area, length }) = row.material else { continue };
        let number = number.to_string();
        let of_own = |d: usize, columns: Vec<Column>| if d == own { columns } else { vec![] };
        let (stress, strain) = (force(0, own, 1.0 / area), |index| deformation(index, own, 1.0 / length));
        add(&["material", &number, "stress"], &|d, _| of_own(d, vec![stress]));
        add(&["material", &number, "strain"], &|d, _| of_own(d, vec![strain(0)]));
        add(&["material", &number, "stressStrain"], &|d, _| of_own(d, vec![stress, strain(1)]));
        add(&["material", &number, "stressStrainTangent"], &|d, _| of_own(d, vec![stress, strain(1)]));
    }
    out
}

/// Returns true if an element reads a response from its end forces, which are those after the amendment.
fn follows_end_forces(inner: &dyn Element, path: &[u32], len: usize) -> bool {
    let n = inner.dofs();
    let (rest, load) = (vec![0.0; n], vec![0.0; inner.load_len()]);
    let mut state = vec![0.0; inner.state_len()];
    inner.init(&mut state);
    let read = |force: f64| {
        let force = vec![force; n];
        let mut out = vec![0.0; len];
        inner.read(path, &Snapshot { disp: &rest, state: &state, force: &force, load: &load }, &mut out);
        out
    };
    read(0.0) != read(1.0)
}
