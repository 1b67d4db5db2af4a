//! Basic deformations of an element by direction, for amendments and diagnosis.

use super::dot;

/// A material that carries the force of one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowMaterial {
    /// Number in the response `material $number`, from 1.
    pub number: usize,
    /// Force per stress.
    pub area: f64,
    /// Deformation per strain.
    pub length: f64,
}

/// One basic deformation of an element with linear kinematics.
#[derive(Clone, Debug, PartialEq)]
pub struct BasicRow {
    /// Direction: 1 to 3 along the element's x, y, z; 4 to 6 about them.
    pub direction: usize,
    /// Column of the conjugate force in the response `basicForce`.
    pub column: usize,
    /// Columns of further springs in this direction; the force of the direction is the sum over all of them.
    pub further_columns: Vec<usize>,
    /// Derivatives of the deformation by the displacements, length n.
    pub row: Vec<f64>,
    /// Deformation when the element was created.
    pub initial: f64,
    /// The material that carries the force of this direction, if there is one.
    pub material: Option<RowMaterial>,
    /// Entries of `row` that belong to the direction itself at node j. Their product with the end forces is the basic
    /// force.
    at_j: Vec<f64>,
}

impl BasicRow {
    /// Makes the row of an element between two nodes with `per_node` degrees of freedom in `ndm` dimensions.
    pub fn new(direction: usize, column: usize, row: &[f64], (ndm, per_node): (usize, usize)) -> Self {
        let rotation = direction > 3;
        let mut at_j = vec![0.0; row.len()];
        for (dof, (to, from)) in at_j.iter_mut().zip(row).enumerate().skip(per_node) {
            if (dof - per_node >= ndm) == rotation {
                *to = *from;
            }
        }
        Self { direction, column, further_columns: vec![], row: row.to_vec(), initial: 0.0, material: None, at_j }
    }

    /// The row of the opposite sense: deformation and force change their signs.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.row.iter_mut().chain(&mut self.at_j).for_each(|x| *x = -*x);
        Self { initial: -self.initial, ..self }
    }

    /// Subtracts a deformation from when the element was created.
    pub fn from_initial(self, initial: f64) -> Self {
        Self { initial, ..self }
    }

    /// Names the material that carries the force, by its number from 1, with force per stress and deformation per strain.
    pub fn of_material(self, number: usize, area: f64, length: f64) -> Self {
        Self { material: Some(RowMaterial { number, area, length }), ..self }
    }

    /// Deformation for displacements of length n.
    pub fn deformation(&self, disp: &[f64]) -> f64 {
        dot(&self.row, disp) - self.initial
    }

    /// Basic force from the end forces of the element, length n.
    pub fn force(&self, end_forces: &[f64]) -> f64 {
        dot(&self.at_j, end_forces)
    }

    /// Displacements at node j for a unit deformation, length n.
    pub fn at_j(&self) -> &[f64] {
        &self.at_j
    }

    /// Writes the derivatives of the basic force by the displacements, length n, from the element's tangent, n x n by
    /// rows.
    pub fn force_by_disp(&self, tangent: &[f64], out: &mut [f64]) {
        for (k, &t) in tangent.chunks_exact(out.len()).zip(&self.at_j) {
            if t != 0.0 {
                out.iter_mut().zip(k).for_each(|(o, k)| *o += t * k);
            }
        }
    }
}
