//! Loops over the columns of a group, for vector instructions.

use super::structure::{Structure, WIDTH};
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
pub(super) fn sums_of(rows: usize, x: &[f64], factors: &[f64], ends: &[usize], n: usize, out: &mut [Vec<f64>; WIDTH]) {
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

/// Subtracts the products of `T` columns of L, from `first` on, from the right-hand side x. Sums go through a buffer.
#[inline(always)]
pub(super) fn forward<const T: usize>(s: &Structure, first: usize, lower: &[f64], x: &mut [f64], buffer: &mut [f64]) {
    let mut y = [0.0; T];
    for q in 0..T {
        y[q] = x[first + q];
        for p in 0..q {
            y[q] = lower[s.ptr[first + p] + q - p].mul_add(-y[p], y[q]);
        }
        x[first + q] = y[q];
    }
    let rows = s.rows_below(first + T - 1);
    let ends = &s.ptr[first + 1..=first + T];
    let n = rows.len();
    for start in (0..n).step_by(BLOCK) {
        let mut sums = [0.0; BLOCK];
        for q in 0..T {
            let Some(l) = lower[ends[q] - n + start..].first_chunk::<BLOCK>() else { return };
            for i in 0..BLOCK {
                sums[i] = l[i].mul_add(y[q], sums[i]);
            }
        }
        if let Some(out) = buffer[start..].first_chunk_mut::<BLOCK>() {
            *out = sums;
        }
    }
    for (&i, sum) in rows.iter().zip(&*buffer) {
        x[i] -= sum;
    }
}

/// Solves for the unknowns x of `T` rows of U, from `first` on, from those below them.
#[inline(always)]
pub(super) fn backward<const T: usize>(s: &Structure, first: usize, upper: &[f64], x: &mut [f64], buffer: &mut [f64]) {
    let rows = s.rows_below(first + T - 1);
    let ends = &s.ptr[first + 1..=first + T];
    let n = rows.len();
    for (&i, known) in rows.iter().zip(&mut *buffer) {
        *known = x[i];
    }
    // Entries that are read behind the end count nothing.
    buffer[n..n + BLOCK].fill(0.0);
    let mut sums = [[0.0; BLOCK]; T];
    for start in (0..n).step_by(BLOCK) {
        let Some(known) = buffer[start..].first_chunk::<BLOCK>() else { return };
        for q in 0..T {
            let Some(u) = upper[ends[q] - n + start..].first_chunk::<BLOCK>() else { return };
            for i in 0..BLOCK {
                sums[q][i] = u[i].mul_add(known[i], sums[q][i]);
            }
        }
    }
    for q in (0..T).rev() {
        let [a, b, c, d, e, f, g, h] = sums[q];
        let mut y = x[first + q] - (((a + e) + (c + g)) + ((b + f) + (d + h)));
        let own = s.ptr[first + q];
        for p in q + 1..T {
            y = upper[own + p - q].mul_add(-x[first + p], y);
        }
        x[first + q] = y / upper[own];
    }
}
