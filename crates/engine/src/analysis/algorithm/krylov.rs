//! Modified Newton accelerated in a Krylov subspace.

use super::Algorithm;
use super::accelerated::{Accelerated, Accelerator, Tangents};
use crate::numeric::{axpy, dot, norm};

/// `algorithm KrylovNewton` (Carlson and Miller, 1998; Scott and Fenves, 2010); a new tangent when the subspace is full.
pub fn krylov_newton(tangents: Tangents) -> Box<dyn Algorithm> {
    Box::new(Accelerated::new(Krylov::default(), tangents))
}

#[derive(Clone, Debug, Default)]
struct Krylov {
    /// Corrections so far, and one place more.
    v: Vec<Vec<f64>>,
    /// Decrease of the residual by each of them.
    av: Vec<Vec<f64>>,
    /// Orthonormal basis of `av`.
    q: Vec<Vec<f64>>,
}

/// Largest dimension of a subspace that there is room for.
const MAX_SUBSPACE: usize = 32;

impl Accelerator for Krylov {
    fn name(&self) -> &'static str {
        "KrylovNewton"
    }

    fn prepare(&mut self, n: usize, wanted: usize) -> usize {
        let dimension = wanted.min(n).min(MAX_SUBSPACE - 1);
        let room = vec![vec![0.0; n]; dimension + 1];
        (self.v, self.av, self.q) = (room.clone(), room.clone(), room);
        dimension
    }

    /// As in OpenSees, the test sees the accelerated correction in a static analysis, the other in a transient one.
    fn hides_from_test(&self) -> bool {
        true
    }

    /// Least squares of the residual in the subspace, the rest as it is.
    fn accelerate(&mut self, k: usize, x: &mut [f64], _: &[f64]) {
        self.v[k].copy_from_slice(x);
        self.av[k].copy_from_slice(x);
        if k == 0 {
            return;
        }
        // A v_k = r_{k-1} - r_k; then one more direction of the orthonormal basis, by Gram and Schmidt twice.
        axpy(-1.0, x, &mut self.av[k - 1]);
        let (basis, new) = self.q.split_at_mut(k - 1);
        let q = &mut new[0];
        q.copy_from_slice(&self.av[k - 1]);
        let size = norm(q);
        for _ in 0..2 {
            for b in basis.iter() {
                axpy(-dot(b, q), b, q);
            }
        }
        let length = norm(q);
        // A direction that depends on the others adds nothing.
        let inverse = if length > 1e-12 * size { 1.0 / length } else { 0.0 };
        q.iter_mut().for_each(|x| *x *= inverse);
        // Back substitution for the coefficients: av_j = Σ R_ij q_i.
        let mut rest: [f64; MAX_SUBSPACE] = [0.0; MAX_SUBSPACE];
        for (i, q) in self.q[..k].iter().enumerate() {
            rest[i] = dot(q, x);
        }
        for j in (0..k).rev() {
            let diagonal = dot(&self.q[j], &self.av[j]);
            let c = if diagonal == 0.0 { 0.0 } else { rest[j] / diagonal };
            for (i, q) in self.q[..j].iter().enumerate() {
                rest[i] -= c * dot(q, &self.av[j]);
            }
            let (head, tail) = self.v.split_at_mut(k);
            axpy(c, &head[j], &mut tail[0]);
            axpy(-c, &self.av[j], &mut tail[0]);
        }
        x.copy_from_slice(&self.v[k]);
    }
}
