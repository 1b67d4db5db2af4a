//! Loops over the columns of a group, for vector instructions.

use super::structure::WIDTH;
use crate::numeric::lanes::BLOCK;

/// Sums over columns of a group: out[q][r] = Σ factors[j, q] x[j, r] for q < T and r < n. The last n entries of a column,
/// which ends at one of `ends`, count; up to a block behind them is read, and its sums are written behind those of a row.
#[inline(always)]
fn sums<const T: usize>(x: &[f64], factors: &[f64], ends: &[usize], n: usize, out: &mut [Vec<f64>; WIDTH]) {
    for start in (0..n).step_by(BLOCK) {
        let mut sums = [[0.0; BLOCK]; T];
        for &end in ends {
            let place = end - n;
            let Some(x) = x[place + start..].first_chunk::<BLOCK>() else { return };
            let Some(factors) = factors[place..].first_chunk::<T>() else { return };
            for q in 0..T {
                for i in 0..BLOCK {
                    sums[q][i] = x[i].mul_add(factors[q], sums[q][i]);
                }
            }
        }
        for q in 0..T {
            if let Some(out) = out[q][start..].first_chunk_mut::<BLOCK>() {
                *out = sums[q];
            }
        }
    }
}

/// As `sums`, for up to [`WIDTH`] rows.
#[inline(always)]
pub(super) fn sums_of(
    rows: usize,
    x: &[f64],
    factors: &[f64],
    ends: &[usize],
    n: usize,
    out: &mut [Vec<f64>; WIDTH],
) {
    match rows {
        1 => sums::<1>(x, factors, ends, n, out),
        2 => sums::<2>(x, factors, ends, n, out),
        3 => sums::<3>(x, factors, ends, n, out),
        _ => sums::<WIDTH>(x, factors, ends, n, out),
    }
}

/// y -= c x
#[inline(always)]
pub(super) fn subtract(x: &[f64], c: f64, y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y = x.mul_add(-c, *y);
    }
}

/// Σ x[i] y[i], as a block of sums side by side; both are read to whole blocks, so that y must be zero behind its end.
#[inline(always)]
pub(super) fn product(x: &[f64], y: &[f64], n: usize) -> f64 {
    let mut sums = [0.0; BLOCK];
    for start in (0..n).step_by(BLOCK) {
        let (Some(x), Some(y)) = (x[start..].first_chunk::<BLOCK>(), y[start..].first_chunk::<BLOCK>()) else { break };
        for i in 0..BLOCK {
            sums[i] = x[i].mul_add(y[i], sums[i]);
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + b) + (c + d)) + ((e + f) + (g + h))
}
