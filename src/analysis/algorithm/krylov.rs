//! Modified Newton accelerated in a Krylov subspace.

use super::{Algorithm, Iteration};
use crate::analysis::failure::Failure;
use crate::analysis::prepared::TangentMix;
use crate::analysis::system::System;
use crate::numeric::{axpy, dot, norm};
use crate::solve::Use;

/// `algorithm KrylovNewton` (Carlson and Miller, 1998; Scott and Fenves, 2010).
#[derive(Clone, Debug)]
pub struct KrylovNewton {
    /// Tangent of the first iteration of a step.
    increment: TangentMix,
    /// Tangent when the subspace is full; `None` keeps the one there is.
    iterate: Option<TangentMix>,
    max_dimension: usize,
    /// Corrections so far, and one place more.
    v: Vec<Vec<f64>>,
    /// What the residual lost by them.
    av: Vec<Vec<f64>>,
    /// Orthonormal basis of `av`.
    q: Vec<Vec<f64>>,
    /// The last correction before it was accelerated.
    r: Vec<f64>,
    /// Whether the first tangent serves all steps.
    once: bool,
    factored: bool,
}

impl KrylovNewton {
    /// With the tangents of a step's first iteration and of a new subspace, and the largest dimension of a subspace.
    pub fn new(increment: TangentMix, iterate: Option<TangentMix>, max_dimension: usize) -> Self {
        Self {
            increment,
            iterate,
            max_dimension,
            v: vec![],
            av: vec![],
            q: vec![],
            r: vec![],
            once: false,
            factored: false,
        }
    }

    /// Keep the first tangent for all steps.
    pub fn factor_once(mut self) -> Self {
        self.once = true;
        self
    }

    /// Accelerate the correction `r` of dimension `k`: least squares of the residual in the subspace, the rest as it
    /// is. Leaves the correction in `v[k]`.
    fn accelerate(&mut self, k: usize, r: &[f64]) {
        self.v[k].copy_from_slice(r);
        self.av[k].copy_from_slice(r);
        if k == 0 {
            return;
        }
        // A v_k = r_{k-1} - r_k; then one more direction of the orthonormal basis, by Gram and Schmidt twice.
        axpy(-1.0, r, &mut self.av[k - 1]);
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
            rest[i] = dot(q, r);
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
    }
}

/// Largest dimension of a subspace that there is room for.
const MAX_SUBSPACE: usize = 32;

impl Algorithm for KrylovNewton {
    fn name(&self) -> &'static str {
        "KrylovNewton"
    }

    fn prepare(&mut self, s: &System<'_>) {
        let n = s.work.b.len();
        self.max_dimension = self.max_dimension.min(n).min(MAX_SUBSPACE - 1);
        self.r = vec![0.0; n];
        let room = vec![vec![0.0; n]; self.max_dimension + 1];
        (self.v, self.av, self.q) = (room.clone(), room.clone(), room);
        self.factored = false;
    }

    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.increment.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(self.increment, Use::Often)?;
        }
        self.factored = false;
        it.start_test();
        let mut k = 0;
        loop {
            it.system.solve()?;
            self.accelerate(k, &it.system.work.x);
            // The subspace keeps the correction as it is, whatever a static integrator adds to it to hold its path.
            self.r.copy_from_slice(&it.system.work.x);
            it.system.work.x.copy_from_slice(&self.v[k]);
            it.update()?;
            // As in OpenSees, the test sees the accelerated correction in a static analysis, the other in a transient one.
            if !it.integrator.is_static() {
                it.system.work.x.copy_from_slice(&self.r);
            }
            let full = k + 1 > self.max_dimension;
            it.system.form_unbalance(full && self.iterate.is_some_and(|m| m.current != 0.0))?;
            if let Some(n) = it.judge()? {
                self.factored = self.once;
                return Ok(n);
            }
            k += 1;
            if full {
                k = 0;
                if let Some(mix) = self.iterate {
                    it.system.form_tangent(mix, Use::Often)?;
                }
            }
        }
    }
}
