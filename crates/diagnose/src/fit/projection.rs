//! What the known parameters of a model can still follow.
//!
//! A proposal is first tried with the user's own parameters where they were. They would move if they were fitted with
//! it, and by the derivatives of the fitted model it is told how far and what that gains, without another analysis: the
//! residual loses its part in the space of the derivatives (the score test of Rao, 1948, at a finite size of the
//! effect).

use nalgebra::{DMatrix, DVector};

/// The space of the derivatives at a point, of which only the first coordinates of other points are meant.
#[derive(Clone)]
pub(crate) struct Projection {
    rows: usize,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

/// Known parameters follow at most by this part of their range.
const FAR: f64 = 0.4;

impl Projection {
    /// From the residual at a point and the derivatives there.
    pub(crate) fn new(residual: &[f64], j: DMatrix<f64>) -> Option<Self> {
        let scale = j.norm().max(f64::MIN_POSITIVE);
        let n = j.ncols();
        // A little damping keeps what the samples do not tell where it is.
        let mut damped = DMatrix::zeros(j.nrows() + n, n);
        damped.view_mut((0, 0), (j.nrows(), n)).copy_from(&j);
        for i in 0..n {
            damped[(j.nrows() + i, i)] = 1e-3 * scale;
        }
        let (q, r) = damped.qr().unpack();
        (r.is_square() && residual.len() == j.nrows()).then(|| Self { rows: j.nrows(), q, r })
    }

    /// Number of known parameters.
    pub(crate) fn dimension(&self) -> usize {
        self.r.ncols()
    }

    /// What the known parameters cannot follow of a residual; `None` where it cannot be compared.
    pub(crate) fn left(&self, residual: &[f64]) -> Option<Vec<f64>> {
        if residual.len() != self.rows {
            return None;
        }
        let mut long = DVector::zeros(self.q.nrows());
        long.rows_mut(0, self.rows).copy_from_slice(residual);
        let part = self.q.tr_mul(&long);
        Some((long - &self.q * part).as_slice().to_vec())
    }

    /// The objective to be expected of a point with a residual when the known parameters follow, and the point with them
    /// moved. `None` where the residual cannot be compared.
    pub(crate) fn follow(&self, residual: &[f64], at: &[f64]) -> Option<(f64, Vec<f64>)> {
        if residual.len() != self.rows {
            return None;
        }
        let mut long = DVector::zeros(self.q.nrows());
        long.rows_mut(0, self.rows).copy_from_slice(residual);
        let part = self.q.tr_mul(&long);
        let step = self.r.solve_upper_triangular(&-&part)?;
        let score = long.norm_squared() - part.norm_squared();
        let mut start = at.to_vec();
        for (x, s) in start.iter_mut().zip(step.iter()) {
            *x = (*x + s.clamp(-FAR, FAR)).clamp(0.0, 1.0);
        }
        Some((score, start))
    }
}
