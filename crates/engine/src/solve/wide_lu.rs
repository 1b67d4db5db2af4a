//! Small dense systems of several models side by side.

use crate::numeric::dot;
use crate::numeric::real::Real;
use crate::numeric::wide::{Flags, Wide};

/// Most equations whose products are summed one after the other, as [`DenseLu`](super::DenseLu) does.
const SMALL: usize = 6;

/// LU factors of several models with the same row exchanges.
#[derive(Debug)]
pub(crate) struct WideLu {
    n: usize,
    lu: Vec<Wide>,
    /// Row that was exchanged with each row.
    exchange: Vec<usize>,
}

impl WideLu {
    pub(crate) fn new(n: usize) -> Self {
        Self { n, lu: vec![Wide::all(0.0); n * n], exchange: vec![0; n] }
    }

    /// Solve with the matrices of all models for right-hand sides in place, to the bits of [`DenseLu`](super::DenseLu).
    /// Returns false where `wanted` models exchange different rows or have no usable pivot; the right-hand sides are as they
    /// were then.
    #[inline(always)]
    pub(crate) fn solve(&mut self, matrix: &[Wide], x: &mut [Wide], wanted: Flags) -> bool {
        self.lu.copy_from_slice(matrix);
        if !self.eliminate(wanted) {
            return false;
        }
        self.substitute(x);
        true
    }

    #[inline(always)]
    fn eliminate(&mut self, wanted: Flags) -> bool {
        let (n, lu) = (self.n, &mut self.lu);
        for k in 0..n {
            let mut p = k;
            for i in k + 1..n {
                let larger = !lu[i * n + k].abs().at_most(lu[p * n + k].abs()) & wanted;
                if larger == wanted {
                    p = i;
                } else if larger != 0 {
                    return false;
                }
            }
            self.exchange[k] = p;
            if p != k {
                let (a, b) = lu.split_at_mut(p * n);
                a[k * n..k * n + n].swap_with_slice(&mut b[..n]);
            }
            let pivot = lu[k * n + k];
            let unusable = pivot.abs().at_most(Wide::all(0.0)) | (pivot * 0.0).is_no_number();
            if unusable & wanted != 0 {
                return false;
            }
            let inverse = Wide::all(1.0) / pivot;
            let (top, rest) = lu.split_at_mut((k + 1) * n);
            let pivot_row = &top[k * n + k + 1..k * n + n];
            for row in rest.chunks_exact_mut(n) {
                let f = row[k] * inverse;
                row[k] = f;
                for (r, p) in row[k + 1..].iter_mut().zip(pivot_row) {
                    *r -= f * *p;
                }
            }
        }
        true
    }

    #[inline(always)]
    fn substitute(&self, x: &mut [Wide]) {
        let n = self.n;
        for (k, &p) in self.exchange.iter().enumerate() {
            x.swap(k, p);
        }
        for i in 1..n {
            x[i] -= self.product(&self.lu[i * n..i * n + i], x);
        }
        for i in (0..n).rev() {
            x[i] = (x[i] - self.product(&self.lu[i * n + i + 1..i * n + n], &x[i + 1..])) / self.lu[i * n + i];
        }
    }

    #[inline(always)]
    fn product(&self, a: &[Wide], b: &[Wide]) -> Wide {
        if self.n > SMALL {
            return dot(a, b);
        }
        let mut sum = Wide::all(0.0);
        for (a, b) in a.iter().zip(b) {
            sum += *a * *b;
        }
        sum
    }
}
