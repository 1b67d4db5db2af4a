//! Deflections of a beam from the polynomial through the curvatures of its sections.

use crate::numeric::eliminate;

/// Largest number of places.
const MAX_PLACES: usize = 35;

/// Values of Legendre polynomials of 2x - 1 at one place x, and of their first and second integrals from 0.
pub(super) type Polynomials = [Vec<f64>; 3];

/// The polynomial through the values at n places (curvature-based displacement interpolation, Neuenhofer and Filippou, 1998).
#[derive(Clone, Debug)]
pub(super) struct CurvatureInterpolation {
    n: usize,
    /// Coefficient of each polynomial per value at each place, n x n by rows.
    coefficients: Vec<f64>,
    /// Polynomials at the first and the second end.
    pub(super) ends: [Polynomials; 2],
}

/// Legendre polynomials of 2x - 1 up to degree `n`, and their first and second integrals from 0.
pub(super) fn polynomials(x: f64, n: usize) -> Polynomials {
    let t = 2.0 * x - 1.0;
    let mut p = vec![1.0, t];
    for k in 1..n + 2 {
        let k1 = k as f64;
        p.push(((2.0 * k1 + 1.0) * t * p[k] - k1 * p[k - 1]) / (k1 + 1.0));
    }
    let integral = |of: &[f64], first: f64| -> Vec<f64> {
        let rest = (1..of.len() - 1).map(|k| 0.5 * (of[k + 1] - of[k - 1]) / (2 * k + 1) as f64);
        std::iter::once(first).chain(rest).collect()
    };
    let once = integral(&p, x);
    let twice = integral(&once, 0.5 * x * x);
    [p, once, twice]
}

impl CurvatureInterpolation {
    /// The interpolation between `places` (fractions of the length). `None` if two coincide or there are too many.
    pub(super) fn new(places: &[f64]) -> Option<Self> {
        let n = places.len();
        // Values of the polynomials at the places; the inverse gives the coefficients.
        let mut values = vec![[0.0; 2 * MAX_PLACES]; n];
        if n > MAX_PLACES {
            return None;
        }
        for (i, (row, x)) in values.iter_mut().zip(places).enumerate() {
            row[..n].copy_from_slice(&polynomials(*x, n)[0][..n]);
            row[n + i] = 1.0;
        }
        if !eliminate(&mut values, n, 2 * n) {
            return None;
        }
        let coefficients = values.iter().flat_map(|row| row[n..2 * n].to_vec()).collect();
        Some(Self { n, coefficients, ends: [polynomials(0.0, n), polynomials(1.0, n)] })
    }

    /// Derivatives, by the value at each place, of the sum of the polynomials times `factor`.
    pub(super) fn influence(&self, factor: impl Fn(usize) -> f64) -> Vec<f64> {
        (0..self.n).map(|j| (0..self.n).map(|k| factor(k) * self.coefficients[k * self.n + j]).sum()).collect()
    }

    /// Deflections from the chord at the place x (over L²) per curvature.
    pub(super) fn deflection(&self, x: f64) -> Vec<f64> {
        let [.., twice] = polynomials(x, self.n);
        self.influence(|k| twice[k] - x * self.ends[1][2][k])
    }
}
