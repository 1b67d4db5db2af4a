//! Small numerical tools that several laws share.

mod dual;
pub(crate) mod elementary;
pub(crate) mod lanes;
pub mod real;
pub mod wide;

pub use dual::Dual;

use real::Real;

/// Scalar product. Four sums side by side, so that it takes the width of the processor; always in the same order.
#[inline(always)]
pub fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    let n = a.len().min(b.len());
    let (head_a, tail_a) = a[..n].as_chunks::<4>();
    let (head_b, tail_b) = b[..n].as_chunks::<4>();
    let mut sum = [T::ZERO; 4];
    for (x, y) in head_a.iter().zip(head_b) {
        for ((s, x), y) in sum.iter_mut().zip(x).zip(y) {
            *s += *x * *y;
        }
    }
    let mut rest = T::ZERO;
    for (x, y) in tail_a.iter().zip(tail_b) {
        rest += *x * *y;
    }
    (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest
}

/// Product of a matrix by rows with a vector.
#[inline]
pub fn product<const R: usize, const C: usize>(a: &[[f64; C]; R], x: &[f64; C]) -> [f64; R] {
    let mut y = [0.0; R];
    y.iter_mut().zip(a).for_each(|(y, row)| *y = dot(row, x));
    y
}

/// y += c x
#[inline]
pub fn axpy(c: f64, x: &[f64], y: &mut [f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += c * x);
}

/// Largest of the absolute values, passing over what is no number; four side by side.
#[inline]
pub fn largest(v: &[f64]) -> f64 {
    let greater = |m: f64, x: f64| if x.abs() > m { x.abs() } else { m };
    if let [x] = v {
        return greater(0.0, *x);
    }
    let (head, tail) = v.as_chunks::<4>();
    let mut most = [0.0; 4];
    for x in head {
        most.iter_mut().zip(x).for_each(|(m, x)| *m = greater(*m, *x));
    }
    most.into_iter().chain(tail.iter().copied()).fold(0.0, greater)
}

/// Returns true if all are zero; compared four at a time.
#[inline]
pub fn all_zero(v: &[f64]) -> bool {
    let (head, tail) = v.as_chunks::<4>();
    head.iter().all(|x| x.iter().fold(true, |all, x| all & (*x == 0.0))) && tail.iter().all(|x| *x == 0.0)
}

/// Euclidean length.
#[inline]
pub fn norm(a: &[f64]) -> f64 {
    match a {
        [a] => a.abs(),
        _ => dot(a, a).sqrt(),
    }
}

/// A matrix of `R` rows and `C` columns of which few entries are not zero, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct SparseMatrix<const R: usize, const C: usize> {
    entries: Vec<Entry>,
    /// Start and end of each row.
    spans: [(u32, u32); R],
}

/// An entry of a [`SparseMatrix`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Row.
    pub row: usize,
    /// Column.
    pub column: usize,
    /// Value.
    pub value: f64,
}

impl<const R: usize, const C: usize> SparseMatrix<R, C> {
    /// From all entries.
    pub fn new(rows: &[[f64; C]; R]) -> Self {
        let (mut entries, mut spans) = (vec![], [(0, 0); R]);
        for ((row, numbers), span) in rows.iter().enumerate().zip(&mut spans) {
            let start = entries.len() as u32;
            let some = numbers.iter().enumerate().filter(|(_, v)| **v != 0.0);
            entries.extend(some.map(|(column, &value)| Entry { row, column, value }));
            *span = (start, entries.len() as u32);
        }
        Self { entries, spans }
    }

    /// Transposed.
    pub fn transposed(&self) -> SparseMatrix<C, R> {
        let mut columns = [[0.0; R]; C];
        self.entries.iter().for_each(|e| columns[e.column][e.row] = e.value);
        SparseMatrix::new(&columns)
    }

    /// The entries of a row that are not zero.
    #[inline]
    pub fn row(&self, row: usize) -> &[Entry] {
        let (start, end) = self.spans[row];
        &self.entries[start as usize..end as usize]
    }

    /// Product with a vector of at least `C` numbers.
    #[inline]
    pub fn times(&self, x: &[f64]) -> [f64; R] {
        let (x, mut y) = (&x[..C], [0.0; R]);
        self.entries.iter().for_each(|e| y[e.row] += e.value * x[e.column]);
        y
    }

    /// Add the product of the transposed matrix with a vector to `y`, of at least `C` numbers.
    #[inline]
    pub fn add_transposed(&self, x: &[f64; R], y: &mut [f64]) {
        let y = &mut y[..C];
        self.entries.iter().for_each(|e| y[e.column] += e.value * x[e.row]);
    }
}

/// Root of a function by Newton's method from `start`, kept inside a bracket at whose ends the function is not positive
/// (left) and not negative (right); the ends may be infinite. `f` gives value and derivative; `scale` is the size of a
/// root that counts as one.
///
/// Goes on to round-off. `None` where no root is found within `limit` steps, or where the function falls to the right of
/// an open left end: a root may be anywhere then.
pub fn bracketed_root(
    mut f: impl FnMut(f64) -> (f64, f64),
    (mut lo, mut hi): (f64, f64),
    start: f64,
    scale: f64,
    limit: u32,
) -> Option<f64> {
    let (mut x, mut reach) = (start, scale);
    for i in 0..limit {
        let (value, slope) = f(x);
        if value == 0.0 {
            return Some(x);
        }
        if value > 0.0 {
            hi = x
        } else {
            lo = x
        }
        let mut next = x - value / slope;
        if (next - x).abs() <= 1e-15 * scale.max(x.abs()) {
            return Some(next);
        }
        let closed = lo.is_finite() && hi.is_finite();
        if closed && i > limit / 2 || !(next > lo && next < hi) {
            // Half-way where Newton leaves the bracket, or is slow because of a kink.
            next = match value < 0.0 {
                _ if closed => 0.5 * (lo + hi),
                true => x + reach,
                false => return None,
            };
            reach *= 2.0;
            if (next - x).abs() <= 1e-15 * scale.max(x.abs()) {
                return Some(next);
            }
        }
        x = next;
    }
    None
}

/// Modified Bessel function of the first kind of a whole order at x ≥ 0, by its power series
/// Σ (x/2)^(2k+n) / (k! (k+n)!), whose terms are all positive. Overflows beyond x = 713.
pub fn bessel_i(order: u32, x: f64) -> f64 {
    let quarter = 0.25 * x * x;
    let mut term = (1..=order).fold(1.0, |t, k| t * 0.5 * x / f64::from(k));
    let mut sum = term;
    for k in 1.. {
        term *= quarter / (f64::from(k) * f64::from(k + order));
        sum += term;
        // The terms grow up to k = x/2.
        if f64::from(k) > x && term <= 1e-17 * sum || !sum.is_finite() {
            break;
        }
    }
    sum
}

/// Sign, zero for zero.
#[inline]
pub fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// Invert an n x n matrix by rows in place, with row exchanges (Gauss and Jordan); `false` where it is singular, and the
/// matrix is spoilt then.
pub fn invert(a: &mut [f64], n: usize) -> bool {
    // The sizes of sections and beams are known to the compiler.
    match n {
        2 => invert_known::<2>(a),
        3 => invert_known::<3>(a),
        4 => invert_known::<4>(a),
        6 => invert_known::<6>(a),
        _ => invert_any(a, n),
    }
}

fn invert_known<const N: usize>(a: &mut [f64]) -> bool {
    let mut own = [[0.0; N]; N];
    own.as_flattened_mut().copy_from_slice(&a[..N * N]);
    let done = invert_in_order(&mut own) || {
        own.as_flattened_mut().copy_from_slice(&a[..N * N]);
        invert_any(own.as_flattened_mut(), N)
    };
    a[..N * N].copy_from_slice(own.as_flattened());
    done
}

/// A pivot of at least this part of the largest entry below it needs no row exchange.
const SUFFICIENT_PIVOT: f64 = 1e-2;

/// Inverts without row exchanges; `false` where a pivot is too small, and the matrix is spoilt then.
#[inline(always)]
fn invert_in_order<const N: usize>(a: &mut [[f64; N]; N]) -> bool {
    for column in 0..N {
        let p = a[column][column];
        let below = a[column..].iter().fold(0.0, |most, row| f64::max(most, row[column].abs()));
        let sufficient = p.abs() > 0.0 && p.abs() >= SUFFICIENT_PIVOT * below && p.is_finite();
        if !sufficient {
            return false;
        }
        a[column][column] = 1.0;
        let inverse = 1.0 / p;
        a[column].iter_mut().for_each(|x| *x *= inverse);
        let pivot_row = a[column];
        for (_, row) in a.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = std::mem::replace(&mut row[column], 0.0);
            row.iter_mut().zip(&pivot_row).for_each(|(x, pivot)| *x -= factor * pivot);
        }
    }
    true
}

#[inline(always)]
fn invert_any(a: &mut [f64], n: usize) -> bool {
    // Row exchanges come out as column exchanges of the inverse.
    let mut from = [0usize; 16];
    for column in 0..n {
        let size = |row: usize, a: &[f64]| a[row * n + column].abs();
        let pivot = (column..n).fold(column, |best, row| if size(row, a) > size(best, a) { row } else { best });
        let p = a[pivot * n + column];
        if p == 0.0 || !p.is_finite() {
            return false;
        }
        from[column] = pivot;
        if pivot != column {
            (0..n).for_each(|j| a.swap(column * n + j, pivot * n + j));
        }
        a[column * n + column] = 1.0;
        a[column * n..(column + 1) * n].iter_mut().for_each(|x| *x /= p);
        for row in (0..n).filter(|row| *row != column) {
            let factor = std::mem::replace(&mut a[row * n + column], 0.0);
            (0..n).for_each(|j| a[row * n + j] -= factor * a[column * n + j]);
        }
    }
    for column in (0..n).rev().filter(|column| from[*column] != *column) {
        (0..n).for_each(|row| a.swap(row * n + column, row * n + from[column]));
    }
    true
}

/// Solve n equations whose right-hand sides are behind them in their rows, up to `columns`, with row exchanges; `false` where
/// there is no solution.
pub fn eliminate<const C: usize>(a: &mut [[f64; C]], n: usize, columns: usize) -> bool {
    for c in 0..n {
        let pivot = (c..n).fold(c, |best, i| if a[i][c].abs() > a[best][c].abs() { i } else { best });
        a.swap(c, pivot);
        let own = a[c];
        if own[c] == 0.0 || !own[c].is_finite() {
            return false;
        }
        for (i, row) in a[..n].iter_mut().enumerate() {
            let factor = row[c] / own[c];
            if i != c && factor != 0.0 {
                row[c..columns].iter_mut().zip(&own[c..columns]).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    for (c, row) in a[..n].iter_mut().enumerate() {
        let pivot = row[c];
        row[n..columns].iter_mut().for_each(|x| *x /= pivot);
    }
    true
}
