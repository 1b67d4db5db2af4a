//! Resultants of a shell at its Gauss points, for a damping of single elements.

use super::{Shell, work};
use crate::element::damping::BasicForces;
use crate::numeric::axpy;
use crate::section::plate::PLATE_ORDER;

impl BasicForces for Shell {
    fn len(&self) -> usize {
        PLATE_ORDER * self.points.len()
    }
    fn in_resisting_force(&self) -> bool {
        true
    }
    fn basic_forces(&self, _: &[f64], state: &[f64], _: &[f64], out: &mut [f64]) {
        for (point, q) in state.chunks_exact(self.words).zip(out.chunks_exact_mut(PLATE_ORDER)) {
            q.copy_from_slice(&point[..PLATE_ORDER]);
        }
    }
    fn add_global(&self, _: &[f64], _: &[f64], q: &[f64], force: &mut [f64]) {
        for (point, q) in self.points.iter().zip(q.chunks_exact(PLATE_ORDER)) {
            for (i, (row, s)) in point.rows.iter().zip(q).enumerate() {
                axpy(work(i) * point.area * s, &row[..self.dofs], force);
            }
        }
    }
    fn scale_stiffness(&self, _: &[f64], _: &[f64], factor: f64, tangent: &mut [f64]) {
        tangent.iter_mut().for_each(|k| *k *= 1.0 + factor);
        // The stiffness against drilling is not damped.
        self.points.iter().for_each(|point| self.add_drilling(point, -factor, tangent));
    }
}
