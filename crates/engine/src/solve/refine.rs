//! Solving with the factors of a matrix that has changed a little since: GMRES (Saad and Schultz, 1986) with the old
//! factors as preconditioner.
//!
//! From one iteration to the next only the stiffness of a few bearings changes, and a few products with the matrix
//! cost less than its factors.

use crate::numeric::{axpy, dot, norm};

/// Buffers for a number of directions.
#[derive(Debug, Default)]
pub(super) struct Gmres {
    /// Orthonormal directions, one after the other.
    v: Vec<f64>,
    /// Hessenberg matrix by columns, made triangular by rotations.
    h: Vec<f64>,
    rotations: Vec<(f64, f64)>,
    /// Right-hand side in the directions.
    g: Vec<f64>,
    product: Vec<f64>,
}

/// Preconditioned residuals smaller than this fraction of the first are round-off to Newton's method.
const TOLERANCE: f64 = 1e-10;

impl Gmres {
    /// Make room for `n` equations and `m` directions.
    pub(super) fn reserve(&mut self, n: usize, m: usize) {
        self.v.resize(n * (m + 1), 0.0);
        self.h.resize((m + 1) * m, 0.0);
        self.rotations.resize(m, (0.0, 0.0));
        self.g.resize(m + 1, 0.0);
        self.product.resize(n, 0.0);
    }

    /// Solve A x = b in at most `m` steps; `x` holds b, and afterwards the solution. `multiply` is A, `precondition`
    /// solves with the old factors in place. `false` where that is not enough: `x` holds b then.
    pub(super) fn solve(
        &mut self,
        m: usize,
        x: &mut [f64],
        multiply: impl Fn(&[f64], &mut [f64]),
        mut precondition: impl FnMut(&mut [f64]),
    ) -> bool {
        let n = x.len();
        let rows = m + 1;
        let (first, _) = self.v.split_at_mut(n);
        first.copy_from_slice(x);
        precondition(first);
        let size = norm(first);
        if size == 0.0 || !size.is_finite() {
            return false;
        }
        first.iter_mut().for_each(|v| *v /= size);
        self.g.fill(0.0);
        self.g[0] = size;
        for j in 0..m {
            multiply(&self.v[j * n..(j + 1) * n], &mut self.product);
            precondition(&mut self.product);
            let column = &mut self.h[j * rows..(j + 1) * rows];
            for (i, h) in column[..=j].iter_mut().enumerate() {
                let v = &self.v[i * n..(i + 1) * n];
                *h = dot(v, &self.product);
                axpy(-*h, v, &mut self.product);
            }
            let rest = norm(&self.product);
            column[j + 1] = rest;
            for (i, &(c, s)) in self.rotations[..j].iter().enumerate() {
                (column[i], column[i + 1]) = (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
            }
            let r = column[j].hypot(column[j + 1]);
            if r == 0.0 || !r.is_finite() {
                return false;
            }
            let (c, s) = (column[j] / r, column[j + 1] / r);
            self.rotations[j] = (c, s);
            (column[j], column[j + 1]) = (r, 0.0);
            (self.g[j], self.g[j + 1]) = (c * self.g[j], -s * self.g[j]);
            if self.g[j + 1].abs() <= TOLERANCE * size {
                self.combine(j + 1, rows, x);
                return true;
            }
            let next = &mut self.v[(j + 1) * n..(j + 2) * n];
            next.iter_mut().zip(&self.product).for_each(|(v, w)| *v = w / rest);
        }
        false
    }

    /// x = Σ y_i v_i with R y = g.
    fn combine(&mut self, k: usize, rows: usize, x: &mut [f64]) {
        let n = x.len();
        x.fill(0.0);
        for j in (0..k).rev() {
            let y = self.g[j] / self.h[j * rows + j];
            for i in 0..j {
                self.g[i] -= y * self.h[j * rows + i];
            }
            axpy(y, &self.v[j * n..(j + 1) * n], x);
        }
    }
}
