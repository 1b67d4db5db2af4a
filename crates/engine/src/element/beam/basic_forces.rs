//! Basic forces of beams, for a damping of single elements.

use super::basic::Basic;
use super::elastic::ElasticBeam;
use super::member::{FiberBeam, Formulation};
use crate::element::damping::BasicForces;
use crate::element::transform::Transform;

/// Adds the global forces of basic forces without member loads.
fn add_global<const N: usize, const B: usize>(
    transform: &dyn Transform<N, B>,
    disp: &[f64],
    state: &[f64],
    q: &[f64],
    force: &mut [f64],
) {
    let mut own = [0.0; B];
    own.copy_from_slice(q);
    transform.add_force(disp, state, &own, &[0.0; 5], force);
}

/// Adds the stiffness of a basic stiffness times a factor, without geometric stiffness.
fn add_stiffness<const N: usize, const B: usize>(
    transform: &dyn Transform<N, B>,
    (disp, state): (&[f64], &[f64]),
    kb: &[[f64; B]; B],
    factor: f64,
    tangent: &mut [f64],
) {
    let kb = kb.map(|row| row.map(|k| factor * k));
    transform.add_tangent(disp, state, &kb, &[0.0; B], tangent);
}

impl<const N: usize, const B: usize> BasicForces for ElasticBeam<N, B> {
    fn len(&self) -> usize {
        B
    }
    fn basic_forces(&self, disp: &[f64], state: &[f64], load: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&self.basic_force(disp, state, load));
    }
    fn add_global(&self, disp: &[f64], state: &[f64], q: &[f64], force: &mut [f64]) {
        add_global(self.transform.as_ref(), disp, state, q, force);
    }
    fn scale_stiffness(&self, disp: &[f64], state: &[f64], factor: f64, tangent: &mut [f64]) {
        add_stiffness(self.transform.as_ref(), (disp, state), &self.kb, factor, tangent);
    }
}

impl<F: Formulation<N, B>, const N: usize, const B: usize> BasicForces for FiberBeam<F, N, B> {
    fn len(&self) -> usize {
        B
    }
    fn basic_forces(&self, _: &[f64], state: &[f64], _: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&Basic::<B>::read(&state[self.member.head()..]).q);
    }
    fn add_global(&self, disp: &[f64], state: &[f64], q: &[f64], force: &mut [f64]) {
        add_global(self.member.transform.as_ref(), disp, &state[..self.member.head()], q, force);
    }
    fn scale_stiffness(&self, disp: &[f64], state: &[f64], factor: f64, tangent: &mut [f64]) {
        let (own, rest) = state.split_at(self.member.head());
        add_stiffness(self.member.transform.as_ref(), (disp, own), &Basic::<B>::read(rest).k, factor, tangent);
    }
}
