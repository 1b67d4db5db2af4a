//! A fit as a linear function of its parameters near its optimum.

use super::job::ChannelResiduals;
use crate::prior::{LIKELIHOOD_POINTS, STEP_DAMPING_DIVISOR};
use crate::series::resampled;
use nalgebra::{DMatrix, DVector};

/// Damped least-squares step p = -(JᵀJ + r²/100 I)⁻¹ Jᵀr from the normal matrix JᵀJ, the gradient Jᵀr and the square r².
///
/// The damping keeps parameters that the samples do not determine. `None` for a matrix that is not positive definite.
pub(crate) fn damped_step(mut normal: DMatrix<f64>, gradient: &DVector<f64>, square: f64) -> Option<DVector<f64>> {
    for i in 0..normal.nrows() {
        normal[(i, i)] += square.max(f64::MIN_POSITIVE) / STEP_DAMPING_DIVISOR;
    }
    Some(normal.cholesky()?.solve(&-gradient))
}

/// Residuals and derivatives at a fit, averaged as in the likelihood.
#[derive(Clone)]
pub(crate) struct LinearizedFit {
    /// Residuals, channel after channel.
    pub(crate) residual: DVector<f64>,
    /// Derivatives of the residuals by the coordinates; points x parameters.
    pub(crate) derivatives: DMatrix<f64>,
    /// Number of points of each channel.
    pub(crate) channels: Vec<usize>,
}

impl LinearizedFit {
    /// From weighted residuals and their derivatives at all samples, channel after channel with `samples` each.
    pub(crate) fn new(residual: &[f64], derivatives: &DMatrix<f64>, samples: &[usize]) -> Self {
        let mut channels = vec![];
        let mut averaged_by_channel = |x: &[f64]| -> Vec<f64> {
            let mut rest = x;
            let parts: Vec<Vec<f64>> = samples
                .iter()
                .map(|n| {
                    let (own, after) = rest.split_at(*n);
                    rest = after;
                    resampled(own, LIKELIHOOD_POINTS)
                })
                .collect();
            channels = parts.iter().map(Vec::len).collect();
            parts.concat()
        };
        let columns: Vec<Vec<f64>> = derivatives.column_iter().map(|c| averaged_by_channel(c.as_slice())).collect();
        let residual = DVector::from_vec(averaged_by_channel(residual));
        let derivatives = DMatrix::from_fn(residual.len(), columns.len(), |i, k| columns[k][i]);
        Self { residual, derivatives, channels }
    }

    /// Residuals split into channels.
    pub(crate) fn by_channel(&self, x: &DVector<f64>) -> ChannelResiduals {
        let mut rest = x.as_slice();
        let own = |n: &usize| {
            let (own, after) = rest.split_at(*n);
            rest = after;
            own.to_vec()
        };
        self.channels.iter().map(own).collect()
    }
}
