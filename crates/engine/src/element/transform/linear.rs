//! Small displacements, with and without the P-Delta effect.

use super::{Frame, Reactions, Transform};
use crate::element::{add_outer, dot};
use crate::numeric::axpy;

/// Small displacements: equilibrium in the undeformed position.
#[derive(Clone, Debug)]
pub struct Linear<const N: usize, const B: usize>(pub Frame<N, B>);

impl<const N: usize, const B: usize> Transform<N, B> for Linear<N, B> {
    fn length(&self) -> f64 {
        self.0.length
    }
    fn is_linear(&self) -> bool {
        true
    }
    fn deformation(&self, disp: &[f64], _: &[f64]) -> [f64; B] {
        self.0.deformation(disp)
    }
    fn add_force(&self, _: &[f64], _: &[f64], q: &[f64; B], p0: &Reactions, force: &mut [f64]) {
        self.0.add_basic_force(q, force);
        self.0.add_reactions(p0, force);
    }
    fn add_tangent(&self, _: &[f64], _: &[f64], kb: &[[f64; B]; B], _: &[f64; B], tangent: &mut [f64]) {
        self.0.add_basic_stiffness(kb, tangent);
    }
    fn frame(&self) -> &Frame<N, B> {
        &self.0
    }
}

/// Small displacements with the P-Delta effect: the axial force N adds the shear N Δ / L for the relative displacement
/// Δ of the ends.
#[derive(Clone, Debug)]
pub struct PDelta<const N: usize, const B: usize>(pub Frame<N, B>);

impl<const N: usize, const B: usize> Transform<N, B> for PDelta<N, B> {
    fn length(&self) -> f64 {
        self.0.length
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn deformation(&self, disp: &[f64], _: &[f64]) -> [f64; B] {
        self.0.deformation(disp)
    }
    fn add_force(&self, disp: &[f64], _: &[f64], q: &[f64; B], p0: &Reactions, force: &mut [f64]) {
        self.0.add_basic_force(q, force);
        self.0.add_reactions(p0, force);
        let u = self.0.since_made(disp);
        for row in self.0.across() {
            let shear = q[0] / self.0.length * dot(&row, &u);
            force.iter_mut().zip(&row).for_each(|(f, r)| *f += shear * r);
        }
    }
    /// The derivative of the axial force by the displacements is usually omitted: it would make the stiffness
    /// unsymmetric and is small. Elements with an unsymmetric tangent add it.
    fn add_tangent(&self, _: &[f64], _: &[f64], kb: &[[f64; B]; B], q: &[f64; B], tangent: &mut [f64]) {
        self.0.add_basic_stiffness(kb, tangent);
        for row in self.0.across() {
            add_outer(tangent, &row, q[0] / self.0.length);
        }
    }
    fn add_unsymmetric_tangent(&self, disp: &[f64], kb: &[[f64; B]; B], tangent: &mut [f64]) {
        let u = self.0.since_made(disp);
        let mut axial = [0.0; N];
        kb[0].iter().zip(&self.0.basic).for_each(|(k, row)| axpy(*k, row, &mut axial));
        for row in self.0.across() {
            let drift = dot(&row, &u) / self.0.length;
            tangent.chunks_exact_mut(N).zip(&row).for_each(|(t, r)| axpy(r * drift, &axial, t));
        }
    }
    fn frame(&self) -> &Frame<N, B> {
        &self.0
    }
}
