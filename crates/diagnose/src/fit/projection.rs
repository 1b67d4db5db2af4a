//! Prediction of how the user's parameters follow an added effect.
//!
//! A proposal is first evaluated at fixed user parameters, which have the derivatives J = Q R. If they follow, the residual r
//! loses its part Q Qᵀ r, and they move by -R⁻¹ Qᵀ r. No further analysis is needed. This is the score test (Rao 1948, Proc.
//! Camb. Phil. Soc. 44, 50-57) at a finite size of the effect.

use super::search_settings::{MAX_PROJECTED_STEP, PROJECTION_DAMPING};
use nalgebra::{DMatrix, DVector};

/// Factored derivatives by the user's parameters, which are the first coordinates of a point.
#[derive(Clone)]
pub(crate) struct Projection {
    rows: usize,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl Projection {
    /// From the residual at a point and the derivatives there. `None` for fewer rows than parameters.
    pub(crate) fn new(residual: &[f64], j: DMatrix<f64>) -> Option<Self> {
        let scale = j.norm().max(f64::MIN_POSITIVE);
        let n = j.ncols();
        // Damping keeps parameters that the samples do not determine.
        let mut damped = DMatrix::zeros(j.nrows() + n, n);
        damped.view_mut((0, 0), (j.nrows(), n)).copy_from(&j);
        for i in 0..n {
            damped[(j.nrows() + i, i)] = PROJECTION_DAMPING * scale;
        }
        let (q, r) = damped.qr().unpack();
        (r.is_square() && residual.len() == j.nrows()).then(|| Self { rows: j.nrows(), q, r })
    }

    /// Number of the user's parameters.
    pub(crate) fn dimension(&self) -> usize {
        self.r.ncols()
    }

    /// A residual with zero rows for the damping, and its components Qᵀ r. `None` for another number of rows.
    fn components(&self, residual: &[f64]) -> Option<(DVector<f64>, DVector<f64>)> {
        if residual.len() != self.rows {
            return None;
        }
        let mut padded = DVector::zeros(self.q.nrows());
        padded.rows_mut(0, self.rows).copy_from_slice(residual);
        let components = self.q.tr_mul(&padded);
        Some((padded, components))
    }

    /// Residual that remains if the user's parameters follow. `None` for another number of rows.
    pub(crate) fn remaining(&self, residual: &[f64]) -> Option<Vec<f64>> {
        let (padded, components) = self.components(residual)?;
        Some((padded - &self.q * components).as_slice().to_vec())
    }

    /// Expected objective at a point if the user's parameters follow, and the point with them moved. `None` for another
    /// number of rows.
    pub(crate) fn follow(&self, residual: &[f64], point: &[f64]) -> Option<(f64, Vec<f64>)> {
        let (padded, components) = self.components(residual)?;
        let step = self.r.solve_upper_triangular(&-&components)?;
        let objective = padded.norm_squared() - components.norm_squared();
        let mut start = point.to_vec();
        for (x, s) in start.iter_mut().zip(step.iter()) {
            *x = (*x + s.clamp(-MAX_PROJECTED_STEP, MAX_PROJECTED_STEP)).clamp(0.0, 1.0);
        }
        Some((objective, start))
    }
}
