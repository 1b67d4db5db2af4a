//! The tangent of a beam with sections, whose basic forces and stiffness lie in its history.

use super::basic::Basic;
use super::member::{FiberBeam, Formulation};
use crate::element::roles::KeptTangent;

impl<F: Formulation<N, B>, const N: usize, const B: usize> FiberBeam<F, N, B> {
    /// Adds the tangent for basic forces and stiffness, with the state variables of the transformation.
    #[inline]
    pub(super) fn add_tangent(&self, disp: &[f64], transform_state: &[f64], basic: &Basic<B>, tangent: &mut [f64]) {
        let transform = &self.member.transform;
        transform.add_tangent(disp, transform_state, &basic.k, &basic.q, tangent);
        if self.formulation.whole_tangent() {
            transform.add_unsymmetric_tangent(disp, &basic.k, tangent);
        }
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> KeptTangent for FiberBeam<F, N, B> {
    fn add_kept_tangent(&self, disp: &[f64], history: &[f64], tangent: &mut [f64]) {
        let (transform_state, rest) = history.split_at(self.member.head());
        self.add_tangent(disp, transform_state, &Basic::read(rest), tangent);
    }
}
