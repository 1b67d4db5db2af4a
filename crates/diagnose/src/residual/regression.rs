//! What some series tell of another one, on times that they were not fitted to.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Regressors of one length, ready to be held against any number of targets.
pub(crate) struct Regression {
    columns: Vec<Vec<f64>>,
    /// Normal equations of all samples but those of a block of time.
    without: Vec<Cholesky<f64, Dyn>>,
}

impl Regression {
    /// Over so many blocks of time; `None` where the samples cannot bear as many regressors.
    pub(crate) fn new(columns: Vec<Vec<f64>>, blocks: usize) -> Option<Self> {
        let (n, k) = (columns.first()?.len(), columns.len());
        if n < 8 * k {
            return None;
        }
        let of_block = |held: usize| {
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
        let own: Vec<DMatrix<f64>> = (0..blocks).map(of_block).collect();
        let all = own.iter().fold(DMatrix::zeros(k, k), |sum, a| sum + a);
        let factor = |own: &DMatrix<f64>| {
            let mut a = &all - own;
            let ridge = 1e-3 * a.diagonal().sum() / k as f64;
            for i in 0..k {
                a[(i, i)] += ridge + f64::MIN_POSITIVE;
            }
            // Of a symmetric matrix the lower triangle is read.
            a.cholesky()
        };
        let without = own.iter().map(factor).collect::<Option<_>>()?;
        Some(Self { columns, without })
    }

    /// Part of the power of a target that is told on the blocks of time that were left out; 0 where nothing is.
    pub(crate) fn explained(&self, target: &[f64]) -> f64 {
        let (n, blocks) = (target.len(), self.without.len());
        let by_block =
            |f: &dyn Fn(usize) -> f64, held: usize| -> f64 { (0..n).filter(|t| t * blocks / n == held).map(f).sum() };
        let right = |held: usize| {
            let of = |c: &Vec<f64>| by_block(&|t| c[t] * target[t], held);
            DVector::from_iterator(self.columns.len(), self.columns.iter().map(of))
        };
        let own: Vec<DVector<f64>> = (0..blocks).map(right).collect();
        let all = own.iter().fold(DVector::zeros(self.columns.len()), |sum, b| sum + b);
        let mut error = 0.0;
        for (held, (a, own)) in self.without.iter().zip(&own).enumerate() {
            let c = a.solve(&(&all - own));
            let miss = |t: usize| {
                let guess: f64 = self.columns.iter().zip(c.iter()).map(|(x, c)| c * x[t]).sum();
                (target[t] - guess).powi(2)
            };
            error += by_block(&miss, held);
        }
        let total: f64 = target.iter().map(|x| x * x).sum();
        if total > 0.0 { (1.0 - error / total).max(0.0) } else { 0.0 }
    }
}

/// Part of the power of a target that regressors as long as the target explain on blocks of time that they were not fitted
/// to; 0 where they explain nothing, or are too many.
pub(crate) fn explained(target: &[f64], columns: &[Vec<f64>], blocks: usize) -> f64 {
    Regression::new(columns.to_vec(), blocks).map_or(0.0, |r| r.explained(target))
}

#[cfg(test)]
mod tests {
    use super::explained;
    use crate::residual::noise::tests::noise;

    #[test]
    fn only_what_generalises_is_explained() {
        let x = noise(0, 3000);
        let column: Vec<f64> = (0..3000).map(|t| (0.01 * f64::from(t)).sin()).collect();
        assert!(explained(&x, std::slice::from_ref(&column), 6) < 0.01);
        let y: Vec<f64> = x.iter().zip(&column).map(|(x, c)| 0.1 * x + c).collect();
        assert!(explained(&y, &[column], 6) > 0.95);
    }
}
