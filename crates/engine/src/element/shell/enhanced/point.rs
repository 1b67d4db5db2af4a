//! A Gauss point of a shell, in the axes of the shell.

use super::super::{MAX, Row};
use super::INTERNAL;
use crate::numeric::axpy;
use crate::section::plate::PLATE_ORDER;

/// A Gauss point, with derivatives by displacements in the axes of the shell.
#[derive(Clone, Debug)]
pub(super) struct LocalPoint {
    /// Derivatives of the deformations of the plate.
    pub(super) rows: [Row; PLATE_ORDER],
    /// The same by the internal degrees of freedom.
    pub(super) internal: [[f64; INTERNAL]; PLATE_ORDER],
    /// Derivatives of the strains against which the drilling stiffness works.
    pub(super) drilling: Vec<Row>,
    pub(super) area: f64,
}

impl LocalPoint {
    pub(super) fn new(area: f64) -> Self {
        Self { rows: [[0.0; MAX]; PLATE_ORDER], internal: [[0.0; INTERNAL]; PLATE_ORDER], drilling: vec![], area }
    }

    /// Turns the axes of the section by an angle from those of the rows, those of the transverse shear by another.
    pub(super) fn turn(&mut self, angle: f64, shear: f64) {
        fn turned<const N: usize>(rows: &mut [[f64; N]; PLATE_ORDER], (s, c): (f64, f64), shear: f64) {
            let combined = |of: &[(f64, &[f64; N])]| {
                let mut sum = [0.0; N];
                of.iter().for_each(|(factor, row)| axpy(*factor, *row, &mut sum));
                sum
            };
            for at in [0, 3] {
                let [x, y, xy] = [rows[at], rows[at + 1], rows[at + 2]];
                rows[at] = combined(&[(c * c, &x), (s * s, &y), (s * c, &xy)]);
                rows[at + 1] = combined(&[(s * s, &x), (c * c, &y), (-s * c, &xy)]);
                rows[at + 2] = combined(&[(-2.0 * s * c, &x), (2.0 * s * c, &y), (c * c - s * s, &xy)]);
            }
            let [first, second] = [rows[6], rows[7]];
            let (s, c) = shear.sin_cos();
            rows[6] = combined(&[(c, &first), (s, &second)]);
            rows[7] = combined(&[(-s, &first), (c, &second)]);
        }
        turned(&mut self.rows, angle.sin_cos(), shear);
        turned(&mut self.internal, angle.sin_cos(), shear);
    }
}
