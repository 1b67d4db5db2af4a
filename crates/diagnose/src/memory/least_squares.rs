//! Least squares with weights of which some may not be negative.

use nalgebra::{DMatrix, DVector};

/// Ridge in parts of the scaled diagonal.
const RIDGE: f64 = 1e-5;
/// Least diagonal in parts of the largest, so that a column that the samples hardly touch stays small.
const MIN_DIAGONAL: f64 = 1e-2;

/// Weights x of the least |A x - y|² from the normal matrix AᵀA and the vector Aᵀy, x ≥ 0 where `positive`.
///
/// The method is that of Lawson and Hanson (1974) with the free columns always in the passive set.
pub(super) fn weights(normal: &DMatrix<f64>, right: &DVector<f64>, positive: &[bool]) -> Vec<f64> {
    let n = right.len();
    let most = (0..n).map(|i| normal[(i, i)]).fold(f64::MIN_POSITIVE, f64::max);
    let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].max(MIN_DIAGONAL * most).sqrt()).collect();
    let q = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / scale[i] / scale[j] + if i == j { RIDGE } else { 0.0 });
    let b = DVector::from_fn(n, |i, _| right[i] / scale[i]);
    let mut passive: Vec<bool> = positive.iter().map(|p| !p).collect();
    let mut x = solve(&q, &b, &passive);
    let tolerance = 1e-10 * b.amax();
    for _ in 0..3 * n {
        let gradient = &b - &q * &x;
        let entering = (0..n).filter(|i| !passive[*i] && gradient[*i] > tolerance);
        let Some(entering) = entering.max_by(|i, j| gradient[*i].total_cmp(&gradient[*j])) else { break };
        passive[entering] = true;
        loop {
            let z = solve(&q, &b, &passive);
            let negative = |i: &usize| positive[*i] && passive[*i] && z[*i] <= 0.0;
            let blocking: Vec<usize> = (0..n).filter(negative).collect();
            if blocking.is_empty() {
                x = z;
                break;
            }
            let part = blocking.iter().map(|i| x[*i] / (x[*i] - z[*i])).fold(1.0, f64::min);
            let part = if part.is_finite() { part } else { 0.0 };
            x += part * (&z - &x);
            for i in blocking {
                if x[i] <= 1e-14 {
                    (x[i], passive[i]) = (0.0, false);
                }
            }
        }
    }
    (0..n).map(|i| x[i] / scale[i]).collect()
}

/// Scalar product of two series of one length, in four sums. Release builds compile this crate for its size, where an index is
/// several times as fast as the engine's iterators over chunks.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sum, mut j) = ([0.0; 4], 0);
    while j + 4 <= a.len() {
        sum[0] += a[j] * b[j];
        sum[1] += a[j + 1] * b[j + 1];
        sum[2] += a[j + 2] * b[j + 2];
        sum[3] += a[j + 3] * b[j + 3];
        j += 4;
    }
    while j < a.len() {
        sum[0] += a[j] * b[j];
        j += 1;
    }
    (sum[0] + sum[1]) + (sum[2] + sum[3])
}

/// Solution for the passive columns; the others are zero.
fn solve(q: &DMatrix<f64>, b: &DVector<f64>, passive: &[bool]) -> DVector<f64> {
    let kept: Vec<usize> = (0..b.len()).filter(|i| passive[*i]).collect();
    let mut x = DVector::zeros(b.len());
    let sub = DMatrix::from_fn(kept.len(), kept.len(), |i, j| q[(kept[i], kept[j])]);
    let right = DVector::from_fn(kept.len(), |i, _| b[kept[i]]);
    if let Some(c) = sub.cholesky() {
        let z = c.solve(&right);
        kept.iter().enumerate().for_each(|(k, i)| x[*i] = z[k]);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::weights;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn a_weight_that_would_be_negative_is_zero() {
        // Columns (1,1,0), (0,1,1), (0,0,1) and y = (1,0,0): the free solution is 1, -1, 1.
        let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
        let y = DVector::from_vec(vec![1.0, 0.0, 0.0]);
        let (normal, right) = (a.tr_mul(&a), a.tr_mul(&y));
        let free = weights(&normal, &right, &[false; 3]);
        assert!(free.iter().zip([1.0, -1.0, 1.0]).all(|(x, y)| (x - y).abs() < 1e-3), "{free:?}");
        let bounded = weights(&normal, &right, &[true; 3]);
        assert!((bounded[0] - 0.5).abs() < 1e-3 && bounded[1] == 0.0 && bounded[2] == 0.0, "{bounded:?}");
    }
}
