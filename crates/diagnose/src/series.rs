//! Elementary statistics of a sampled series.

/// Means of at most `points` blocks of a series, all as long as the first but for the last.
pub(crate) fn averaged(x: &[f64], points: usize) -> Vec<f64> {
    let block = x.len().div_ceil(points).max(1);
    x.chunks(block).map(|c| c.iter().sum::<f64>() / c.len() as f64).collect()
}

/// Means of a series over `points` equal parts of its length, which may cut a sample in two; the series itself if it has no
/// more samples.
///
/// The same record with more samples gives the same points.
pub(crate) fn resampled(x: &[f64], points: usize) -> Vec<f64> {
    let n = x.len();
    if n <= points {
        return x.to_vec();
    }
    let width = n as f64 / points as f64;
    let mean = |k: usize| {
        let (from, to) = (k as f64 * width, (k + 1) as f64 * width);
        let part = |i: usize| (to.min((i + 1) as f64) - from.max(i as f64)).max(0.0);
        (from as usize..(to.ceil() as usize).min(n)).map(|i| part(i) * x[i]).sum::<f64>() / width
    };
    (0..points).map(mean).collect()
}

/// Mean square; 0 for an empty series.
pub(crate) fn power(x: &[f64]) -> f64 {
    if x.is_empty() { 0.0 } else { x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64 }
}

/// A series without its mean.
pub(crate) fn centred(x: Vec<f64>) -> Vec<f64> {
    let mean = x.iter().sum::<f64>() / x.len().max(1) as f64;
    x.into_iter().map(|x| x - mean).collect()
}

/// Median; 0 for an empty series.
pub(crate) fn median(mut x: Vec<f64>) -> f64 {
    let middle = x.len() / 2;
    if x.is_empty() { 0.0 } else { *x.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

#[cfg(test)]
mod tests {
    use super::resampled;

    #[test]
    fn a_series_has_the_same_points_from_any_sampling() {
        let at = |n: usize| -> Vec<f64> { (0..n).map(|i| (7.0 * (i as f64 + 0.5) / n as f64).sin()).collect() };
        let exact = resampled(&at(4000), 400);
        for n in [401, 599, 1000, 1723] {
            let points = resampled(&at(n), 400);
            assert_eq!(points.len(), 400);
            assert!(points.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 0.02), "{n}");
            let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
            assert!((mean(&points) - mean(&at(n))).abs() < 1e-12);
        }
        assert_eq!(resampled(&[1.0, 2.0], 400), [1.0, 2.0]);
    }
}
