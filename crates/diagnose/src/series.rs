//! Elementary statistics of a sampled series.

/// Means of at most `points` blocks of a series, all as long as the first but for the last.
pub(crate) fn averaged(x: &[f64], points: usize) -> Vec<f64> {
    let block = x.len().div_ceil(points).max(1);
    x.chunks(block).map(|c| c.iter().sum::<f64>() / c.len() as f64).collect()
}

/// Mean square; 0 for an empty series.
pub(crate) fn power(x: &[f64]) -> f64 {
    if x.is_empty() { 0.0 } else { x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64 }
}

/// Median; 0 for an empty series.
pub(crate) fn median(mut x: Vec<f64>) -> f64 {
    let middle = x.len() / 2;
    if x.is_empty() { 0.0 } else { *x.select_nth_unstable_by(middle, f64::total_cmp).1 }
}
