//! Regression of a series on others, cross-validated over blocks of time.

use crate::prior::{REGRESSION_RIDGE, SAMPLES_PER_REGRESSOR};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Regressors of one length, factored for any number of targets.
pub(crate) struct Regression {
    columns: Vec<Vec<f64>>,
    /// For each block, the factored normal equations of all other samples.
    without_block: Vec<Cholesky<f64, Dyn>>,
}

impl Regression {
    /// Factors the regressors for cross-validation over blocks. `None` if there are too few samples for the regressors.
    pub(crate) fn new(columns: Vec<Vec<f64>>, blocks: usize) -> Option<Self> {
        let (n, k) = (columns.first()?.len(), columns.len());
        if n < SAMPLES_PER_REGRESSOR * k {
            return None;
        }
        let normal_of_block = |held: usize| {
            let mut a = DMatrix::<f64>::zeros(k, k);
            for t in (0..n).filter(|t| t * blocks / n == held) {
                for i in 0..k {
                    for j in 0..=i {
                        a[(i, j)] += columns[i][t] * columns[j][t];
                    }
                }
            }
            a
        };
        let own: Vec<DMatrix<f64>> = (0..blocks).map(normal_of_block).collect();
        let all = own.iter().fold(DMatrix::zeros(k, k), |sum, a| sum + a);
        let factor = |own: &DMatrix<f64>| {
            let mut a = &all - own;
            let ridge = REGRESSION_RIDGE * a.diagonal().sum() / k as f64;
            for i in 0..k {
                a[(i, i)] += ridge + f64::MIN_POSITIVE;
            }
            // The factorisation reads the lower triangle alone.
            a.cholesky()
        };
        let without_block = own.iter().map(factor).collect::<Option<_>>()?;
        Some(Self { columns, without_block })
    }

    /// Share of a target's power that is predicted in the blocks left out; at least 0.
    pub(crate) fn explained_share(&self, target: &[f64]) -> f64 {
        let (n, blocks) = (target.len(), self.without_block.len());
        let by_block =
            |f: &dyn Fn(usize) -> f64, held: usize| -> f64 { (0..n).filter(|t| t * blocks / n == held).map(f).sum() };
        let right = |held: usize| {
            let of = |c: &Vec<f64>| by_block(&|t| c[t] * target[t], held);
            DVector::from_iterator(self.columns.len(), self.columns.iter().map(of))
        };
        let own: Vec<DVector<f64>> = (0..blocks).map(right).collect();
        let all = own.iter().fold(DVector::zeros(self.columns.len()), |sum, b| sum + b);
        let mut error = 0.0;
        for (held, (a, own)) in self.without_block.iter().zip(&own).enumerate() {
            let c = a.solve(&(&all - own));
            let squared_error = |t: usize| {
                let predicted: f64 = self.columns.iter().zip(c.iter()).map(|(x, c)| c * x[t]).sum();
                (target[t] - predicted).powi(2)
            };
            error += by_block(&squared_error, held);
        }
        let total: f64 = target.iter().map(|x| x * x).sum();
        if total > 0.0 { (1.0 - error / total).max(0.0) } else { 0.0 }
    }
}

/// Share of a target's power that regressors of its length predict by cross-validation; 0 for too many regressors.
pub(crate) fn explained_share(target: &[f64], columns: &[Vec<f64>], blocks: usize) -> f64 {
    Regression::new(columns.to_vec(), blocks).map_or(0.0, |r| r.explained_share(target))
}

#[cfg(test)]
mod tests {
    use super::explained_share;
    use crate::test_support::white_noise;

    #[test]
    fn only_cross_validated_power_is_explained() {
        let x = white_noise(0, 3000);
        let column: Vec<f64> = (0..3000).map(|t| (0.01 * f64::from(t)).sin()).collect();
        assert!(explained_share(&x, std::slice::from_ref(&column), 6) < 0.01);
        let y: Vec<f64> = x.iter().zip(&column).map(|(x, c)| 0.1 * x + c).collect();
        assert!(explained_share(&y, &[column], 6) > 0.95);
    }
}
