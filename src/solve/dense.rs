//! Small dense systems: LU with row exchanges, in place.

use super::{Pivots, SolveError};

/// Dense LU factors.
#[derive(Debug)]
pub(super) struct DenseLu {
    n: usize,
    lu: Vec<f64>,
    /// Row that was exchanged with each row.
    exchange: Vec<usize>,
    /// Largest entry of each column before the factorisation.
    scale: Vec<f64>,
}

impl DenseLu {
    pub(super) fn new(n: usize) -> Self {
        Self { n, lu: vec![0.0; n * n], exchange: vec![0; n], scale: vec![0.0; n] }
    }

    pub(super) fn factor(&mut self, values: &[f64]) -> Result<Pivots, SolveError> {
        let n = self.n;
        self.lu.copy_from_slice(values);
        let mut pivots = Pivots::GOOD;
        if let [pivot] = *values {
            // A single bearing under its load is one equation.
            pivots.see(0, pivot, pivot);
            let usable = pivot != 0.0 && pivot.is_finite();
            return if usable { Ok(pivots) } else { Err(SolveError::Singular { equation: 0 }) };
        }
        for (j, s) in self.scale.iter_mut().enumerate() {
            *s = (0..n).map(|i| values[i * n + j].abs()).fold(0.0, f64::max);
        }
        for k in 0..n {
            let mut p = k;
            for i in k + 1..n {
                if self.lu[i * n + k].abs() > self.lu[p * n + k].abs() {
                    p = i;
                }
            }
            self.exchange[k] = p;
            if p != k {
                let (a, b) = self.lu.split_at_mut(p * n);
                a[k * n..k * n + n].swap_with_slice(&mut b[..n]);
            }
            let pivot = self.lu[k * n + k];
            pivots.see(k, pivot, self.scale[k]);
            if pivot == 0.0 || !pivot.is_finite() {
                return Err(SolveError::Singular { equation: k });
            }
            let inverse = 1.0 / pivot;
            let (top, rest) = self.lu.split_at_mut((k + 1) * n);
            let pivot_row = &top[k * n + k + 1..k * n + n];
            for row in rest.chunks_exact_mut(n) {
                if row[k] != 0.0 {
                    let f = row[k] * inverse;
                    row[k] = f;
                    for (r, p) in row[k + 1..].iter_mut().zip(pivot_row) {
                        *r -= f * p;
                    }
                }
            }
        }
        Ok(pivots)
    }

    pub(super) fn solve(&self, x: &mut [f64]) {
        let n = self.n;
        if let [x] = x {
            *x /= self.lu[0];
            return;
        }
        for (k, &p) in self.exchange.iter().enumerate() {
            x.swap(k, p);
        }
        for i in 1..n {
            let s: f64 = self.lu[i * n..i * n + i].iter().zip(&*x).map(|(l, x)| l * x).sum();
            x[i] -= s;
        }
        for i in (0..n).rev() {
            let s: f64 = self.lu[i * n + i + 1..i * n + n].iter().zip(&x[i + 1..]).map(|(u, x)| u * x).sum();
            x[i] = (x[i] - s) / self.lu[i * n + i];
        }
    }
}
