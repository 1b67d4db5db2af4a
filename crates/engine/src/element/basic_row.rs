//! Deformations of an element by direction, for those who change or watch it from outside.

use super::dot;

/// One basic deformation of an element of linear kinematics.
#[derive(Clone, Debug, PartialEq)]
pub struct BasicRow {
    /// Direction, 1 to 6: along x, y, z of the element, about x, y, z.
    pub direction: usize,
    /// Column of its force in the response `basicForce`.
    pub column: usize,
    /// Deformation from the displacements of all degrees of freedom, length n.
    pub row: Vec<f64>,
    /// Deformation that was there when the element was made.
    pub initial: f64,
    /// The part of `row` that belongs to the direction itself at node j: reads the basic force from the end forces.
    at_j: Vec<f64>,
}

impl BasicRow {
    /// From the row of a deformation of two nodes with `per_node` degrees of freedom in `ndm` dimensions.
    pub fn new(direction: usize, column: usize, row: &[f64], (ndm, per_node): (usize, usize)) -> Self {
        let rotation = direction > 3;
        let mut at_j = vec![0.0; row.len()];
        for (dof, (to, from)) in at_j.iter_mut().zip(row).enumerate().skip(per_node) {
            if (dof - per_node >= ndm) == rotation {
                *to = *from;
            }
        }
        Self { direction, column, row: row.to_vec(), initial: 0.0, at_j }
    }

    /// The same, measured from a deformation that was there when the element was made.
    pub fn from_initial(self, initial: f64) -> Self {
        Self { initial, ..self }
    }

    /// Deformation for the displacements of all degrees of freedom.
    pub fn deformation(&self, disp: &[f64]) -> f64 {
        dot(&self.row, disp) - self.initial
    }

    /// Basic force in the end forces of the element.
    pub fn force(&self, end_forces: &[f64]) -> f64 {
        dot(&self.at_j, end_forces)
    }

    /// A unit deformation by node j.
    pub fn at_j(&self) -> &[f64] {
        &self.at_j
    }

    /// Derivative of the basic force by the displacements, from the element's tangent n x n by rows.
    pub fn force_by_disp(&self, tangent: &[f64], out: &mut [f64]) {
        for (k, &t) in tangent.chunks_exact(out.len()).zip(&self.at_j) {
            if t != 0.0 {
                out.iter_mut().zip(k).for_each(|(o, k)| *o += t * k);
            }
        }
    }
}
