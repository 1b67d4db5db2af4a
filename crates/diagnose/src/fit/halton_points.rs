//! Evenly spread start points.

use super::search_settings::{LAST_SEARCH_SIDE, LAST_SEARCH_STARTS};
use hysteron_identify::halton::{MAX_COORDINATES, halton};

/// A start and `per_parameter` (n + 1) points of a Halton sequence (Halton 1960, Numer. Math. 2, 84-90) in the last n
/// coordinates, from index `first` on. The first coordinates stay at the start.
pub(crate) fn halton_points(start: &[f64], first: usize, per_parameter: usize) -> Vec<Vec<f64>> {
    let n = start.len() - first;
    let point = |i: usize| -> Vec<f64> {
        let at = |k: usize| halton(i, k).unwrap_or(start[first + k]);
        start[..first].iter().copied().chain((0..n).map(at)).collect()
    };
    // Random points of many coordinates are of no use; a wandering zero, which has them, starts at zero.
    let further = if n > MAX_COORDINATES { 0 } else { per_parameter * (n + 1) };
    std::iter::once(start.to_vec()).chain((1..=further).map(point)).collect()
}

/// A point, and [`LAST_SEARCH_STARTS`] others in a small cube around it.
pub(crate) fn points_around(point: &[f64]) -> Vec<Vec<f64>> {
    let middle: Vec<f64> = point.iter().map(|_| 0.5).collect();
    let per_parameter = LAST_SEARCH_STARTS.div_ceil(point.len() + 1);
    let spread = halton_points(&middle, 0, per_parameter).into_iter().skip(1).take(LAST_SEARCH_STARTS);
    let near = |other: Vec<f64>| {
        point.iter().zip(other).map(|(p, o)| (p + LAST_SEARCH_SIDE * (o - 0.5)).clamp(0.0, 1.0)).collect()
    };
    std::iter::once(point.to_vec()).chain(spread.map(near)).collect()
}
