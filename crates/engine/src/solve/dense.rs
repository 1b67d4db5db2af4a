//! Small dense systems: LU with row exchanges, in place.

use super::{Pivots, SolveError};
use crate::numeric::dot;
use crate::numeric::lanes::{Lanes, in_lanes};

/// Dense LU factors.
#[derive(Debug)]
pub(crate) struct DenseLu {
    n: usize,
    lu: Vec<f64>,
    /// Row that was exchanged with each row.
    exchange: Vec<usize>,
    /// Largest entry of each column before the factorisation.
    scale: Vec<f64>,
}

/// A factorisation as a loop.
struct Elimination<'a> {
    factors: &'a mut DenseLu,
    done: Result<Pivots, SolveError>,
}

impl Lanes for Elimination<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        self.done = self.done.and_then(|pivots| self.factors.eliminate_all(pivots));
    }
}

impl DenseLu {
    pub(crate) fn new(n: usize) -> Self {
        Self { n, lu: vec![0.0; n * n], exchange: vec![0; n], scale: vec![0.0; n] }
    }

    pub(crate) fn factor(&mut self, values: &[f64]) -> Result<Pivots, SolveError> {
        let n = self.n;
        self.lu.copy_from_slice(values);
        let mut pivots = Pivots::GOOD;
        if n == 0 {
            // All motions are imposed.
            return Ok(pivots);
        }
        if let [pivot] = *values {
            // A single bearing under its load is one equation.
            pivots.see(0, pivot, pivot);
            let usable = pivot != 0.0 && pivot.is_finite();
            return if usable { Ok(pivots) } else { Err(SolveError::Singular { equation: 0 }) };
        }
        // For the few equations of a single bearing or a small building the loops over a size that is known take half the
        // time.
        match n {
            2 => return self.eliminate::<2>(pivots),
            3 => return self.eliminate::<3>(pivots),
            4 => return self.eliminate::<4>(pivots),
            5 => return self.eliminate::<5>(pivots),
            6 => return self.eliminate::<6>(pivots),
            _ => {}
        }
        let mut elimination = Elimination { factors: self, done: Ok(pivots) };
        in_lanes(&mut elimination);
        elimination.done
    }

    /// Factor any number of equations.
    #[inline(always)]
    fn eliminate_all(&mut self, mut pivots: Pivots) -> Result<Pivots, SolveError> {
        let n = self.n;
        self.scale.fill(0.0);
        for row in self.lu.chunks_exact(n) {
            self.scale.iter_mut().zip(row).for_each(|(s, x)| *s = if x.abs() > *s { x.abs() } else { *s });
        }
        for k in 0..n {
            let mut p = k;
            for i in k + 1..n {
                if self.lu[i * n + k].abs() > self.lu[p * n + k].abs() {
                    p = i;
                }
            }
            self.exchange[k] = p;
            if p != k {
                let (a, b) = self.lu.split_at_mut(p * n);
                a[k * n..k * n + n].swap_with_slice(&mut b[..n]);
            }
            let pivot = self.lu[k * n + k];
            pivots.see(k, pivot, self.scale[k]);
            if pivot == 0.0 || !pivot.is_finite() {
                return Err(SolveError::Singular { equation: k });
            }
            let inverse = 1.0 / pivot;
            let (top, rest) = self.lu.split_at_mut((k + 1) * n);
            let pivot_row = &top[k * n + k + 1..k * n + n];
            for row in rest.chunks_exact_mut(n) {
                if row[k] != 0.0 {
                    let f = row[k] * inverse;
                    row[k] = f;
                    for (r, p) in row[k + 1..].iter_mut().zip(pivot_row) {
                        *r -= f * p;
                    }
                }
            }
        }
        Ok(pivots)
    }

    /// Factor `N` equations.
    fn eliminate<const N: usize>(&mut self, mut pivots: Pivots) -> Result<Pivots, SolveError> {
        let rows = self.lu.as_chunks_mut::<N>().0;
        let Ok(rows) = <&mut [[f64; N]; N]>::try_from(rows) else {
            return Err(SolveError::Singular { equation: 0 });
        };
        let scale: [f64; N] = std::array::from_fn(|j| rows.iter().fold(0.0, |m, row| f64::max(m, row[j].abs())));
        for k in 0..N {
            let mut p = k;
            for i in k + 1..N {
                if rows[i][k].abs() > rows[p][k].abs() {
                    p = i;
                }
            }
            self.exchange[k] = p;
            if p != k {
                rows.swap(k, p);
            }
            let pivot_row = rows[k];
            let pivot = pivot_row[k];
            pivots.see(k, pivot, scale[k]);
            if pivot == 0.0 || !pivot.is_finite() {
                return Err(SolveError::Singular { equation: k });
            }
            let inverse = 1.0 / pivot;
            for row in &mut rows[k + 1..] {
                let f = row[k] * inverse;
                row[k] = f;
                for j in k + 1..N {
                    row[j] -= f * pivot_row[j];
                }
            }
        }
        Ok(pivots)
    }

    pub(crate) fn solve(&self, x: &mut [f64]) {
        let n = self.n;
        if let [x] = x {
            *x /= self.lu[0];
            return;
        }
        match self.n {
            2 => return self.substitute::<2>(x),
            3 => return self.substitute::<3>(x),
            4 => return self.substitute::<4>(x),
            5 => return self.substitute::<5>(x),
            6 => return self.substitute::<6>(x),
            _ => {}
        }
        for (k, &p) in self.exchange.iter().enumerate() {
            x.swap(k, p);
        }
        for i in 1..n {
            x[i] -= dot(&self.lu[i * n..i * n + i], x);
        }
        for i in (0..n).rev() {
            x[i] = (x[i] - dot(&self.lu[i * n + i + 1..i * n + n], &x[i + 1..])) / self.lu[i * n + i];
        }
    }

    /// Solve `N` equations.
    fn substitute<const N: usize>(&self, x: &mut [f64]) {
        let rows = <&[[f64; N]; N]>::try_from(self.lu.as_chunks::<N>().0);
        let (Ok(rows), Ok(x)) = (rows, <&mut [f64; N]>::try_from(x)) else { return };
        for (k, &p) in self.exchange.iter().enumerate() {
            x.swap(k, p);
        }
        for i in 1..N {
            let s: f64 = (0..i).map(|j| rows[i][j] * x[j]).sum();
            x[i] -= s;
        }
        for i in (0..N).rev() {
            let s: f64 = (i + 1..N).map(|j| rows[i][j] * x[j]).sum();
            x[i] = (x[i] - s) / rows[i][i];
        }
    }
}
