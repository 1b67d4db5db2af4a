//! Errors on what is held back, from the derivatives at the fit of all samples.

use super::competition::{Competition, HeldBack};
use super::law::Law;
use super::least_squares::weights;
use nalgebra::{DMatrix, DVector};

/// Steps of Gauss and Newton in the fit of all samples.
const STEPS: usize = 6;
/// Largest change of a factor without a fold, for which the derivatives hold.
const MAX_CHANGE: f64 = 0.5;

impl Competition<'_> {
    /// Errors on blocks and whole runs held back in turn. Without a fold, weights and factors are those of linear least squares
    /// with the columns and derivatives of the fit of all samples, which costs a tenth of fits of their own.
    pub(super) fn linear_held_back(&self, law: &Law) -> HeldBack {
        let d = self.data;
        let c = self.fitter.fit(law, &d.fitted, STEPS, &[]);
        let columns = self.fitter.columns(law, &c.factors);
        let n = columns.all.len();
        let positive: Vec<bool> = self.fitter.positive(law, columns.counts);
        let positive: Vec<bool> = positive.into_iter().chain((0..law.factors.len()).map(|_| false)).collect();
        let size = |x: &Vec<f64>| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let largest = columns.all.iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
        // Derivatives have the unit of a force. The ridge is one of columns of a common size.
        let (sizes, derivatives): (Vec<f64>, Vec<Vec<f64>>) = self
            .fitter
            .derivatives(law, &c, &columns)
            .into_iter()
            .map(|x| {
                let ratio = (size(&x) / largest).max(f64::MIN_POSITIVE);
                (ratio, x.into_iter().map(|x| x / ratio).collect::<Vec<f64>>())
            })
            .unzip();
        let all: Vec<Vec<f64>> = columns.all.into_iter().chain(derivatives).collect();
        let rows = |keep: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..d.samples.len()).filter(|i| d.fitted[*i] && keep(*i)).collect()
        };
        let of_folds: Vec<(DMatrix<f64>, DVector<f64>)> =
            d.folds.iter().map(|held| self.fitter.normal(&all, &d.recorded, &rows(&|i| held[i]))).collect();
        // Each fitted sample is in one block.
        let blocks = &of_folds[..d.block_folds];
        let total: DMatrix<f64> = blocks.iter().map(|(normal, _)| normal).sum();
        let total_right: DVector<f64> = blocks.iter().map(|(_, right)| right).sum();
        let of_fold = |(held, (normal, right)): (&Vec<bool>, &(DMatrix<f64>, DVector<f64>))| {
            let held = rows(&|i| held[i]);
            let mut x = weights(&(&total - normal), &(&total_right - right), &positive);
            // Of the column, a change of the factor is its weight over the ratio of sizes.
            for (a, ratio) in x[n..].iter_mut().zip(&sizes) {
                *a = (*a / ratio).clamp(-MAX_CHANGE, MAX_CHANGE) * ratio;
            }
            held.iter()
                .map(|i| {
                    let value: f64 = all.iter().zip(&x).map(|(column, w)| w * column[*i]).sum();
                    ((value - d.recorded[*i]) * d.weight[*i]).powi(2)
                })
                .sum()
        };
        let folds: Vec<f64> = d.folds.iter().zip(&of_folds).map(of_fold).collect();
        let (blocks, whole) = folds.split_at(d.block_folds);
        HeldBack { pooled: 0.5 * (blocks.iter().sum::<f64>() + d.whole_factor * whole.iter().sum::<f64>()), folds }
    }
}
