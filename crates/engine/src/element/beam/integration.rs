//! Quadrature along a beam: where its sections are, and how much they count (`beamIntegration`).

use crate::numeric::invert;

/// A rule of quadrature.
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// Gauss and Lobatto: both ends among the points.
    Lobatto,
    /// Gauss and Legendre: no end among the points.
    Legendre,
    /// Gauss and Radau: end i among the points.
    Radau,
    /// Newton and Cotes: points at equal distances, weights of the interpolating polynomial.
    NewtonCotes,
    /// Trapezoids between points at equal distances.
    Trapezoidal,
    /// Simpson's rule over pairs of intervals between points at equal distances.
    Simpson,
    /// Points and weights as fractions of the length.
    Given(Vec<f64>, Vec<f64>),
    /// Points as fractions of the length; the first weights, if any, are given, the others integrate polynomials.
    Located(Vec<f64>, Vec<f64>),
    /// Points as fractions of the length; each counts for what lies nearer to it than to its neighbours.
    MidDistance(Vec<f64>),
    /// Hinges of given lengths at i and j, with two points of Gauss between them.
    Hinges(Hinge, f64, f64),
}

/// How a plastic hinge is integrated (Scott and Fenves, 2006).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hinge {
    /// Radau's two points over four times the length, which gives the end point the length of the hinge.
    Radau,
    /// Radau's two points over the length.
    RadauTwo,
    /// The point in the middle.
    Midpoint,
    /// The point at the end.
    Endpoint,
}

/// Points and weights as fractions of the length.
pub type Points = (Vec<f64>, Vec<f64>);

impl Rule {
    /// Points and weights for `n` sections of a beam of a length. `None` where the rule has no such number of points.
    pub fn points(&self, n: usize, length: f64) -> Option<Points> {
        let (x, w) = match self {
            Self::Legendre => gauss(n, &[]),
            Self::Lobatto if n >= 2 => gauss(n, &[-1.0, 1.0]),
            Self::Radau => gauss(n, &[-1.0]),
            Self::NewtonCotes | Self::Trapezoidal | Self::Simpson if n >= 2 => {
                let x: Vec<f64> = (0..n).map(|i| i as f64 / (n - 1) as f64).collect();
                let w = match self {
                    Self::NewtonCotes => polynomial_weights(&x, &[])?,
                    Self::Trapezoidal => {
                        let whole = 1.0 / (n - 1) as f64;
                        (0..n).map(|i| if i == 0 || i == n - 1 { 0.5 * whole } else { whole }).collect()
                    }
                    _ if n % 2 == 1 => {
                        let unit = 1.0 / (3 * (n - 1)) as f64;
                        let count = |i: usize| if i == 0 || i == n - 1 { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
                        (0..n).map(|i| unit * count(i)).collect()
                    }
                    _ => return None,
                };
                return Some((x, w));
            }
            Self::Given(x, w) => return Some((x.clone(), w.clone())),
            Self::Located(x, w) => return Some((x.clone(), polynomial_weights(x, w)?)),
            Self::MidDistance(x) => return Some((x.clone(), mid_distances(x))),
            Self::Hinges(hinge, i, j) => return Some(hinge.points(i / length, j / length)),
            _ => return None,
        };
        // From -1 to 1 to the length.
        Some((x.iter().map(|x| 0.5 * (x + 1.0)).collect(), w.iter().map(|w| 0.5 * w).collect()))
    }
}

impl Hinge {
    fn points(self, i: f64, j: f64) -> Points {
        // Distances of the points from their end, and their weights, over the length of the hinge; what it takes up.
        let (places, weights, reach): (&[f64], &[f64], f64) = match self {
            Self::Radau => (&[0.0, 8.0 / 3.0], &[1.0, 3.0], 4.0),
            Self::RadauTwo => (&[0.0, 2.0 / 3.0], &[0.25, 0.75], 1.0),
            Self::Midpoint => (&[0.5], &[1.0], 1.0),
            Self::Endpoint => (&[0.0], &[1.0], 1.0),
        };
        let half = 0.5 * (1.0 - reach * (i + j));
        let middle = reach * i + half;
        let gauss = half / 3.0f64.sqrt();
        let mut x: Vec<f64> = places.iter().map(|p| p * i).collect();
        let mut w: Vec<f64> = weights.iter().map(|w| w * i).collect();
        x.extend([middle - gauss, middle + gauss]);
        w.extend([half, half]);
        x.extend(places.iter().rev().map(|p| 1.0 - p * j));
        w.extend(weights.iter().rev().map(|w| w * j));
        (x, w)
    }

    /// Which section each point has: 0 that of hinge i, 1 that of hinge j, 2 that between.
    pub fn sections(self) -> &'static [usize] {
        match self {
            // As in OpenSees, only the end points of the longer rule have the hinge's section.
            Self::Radau => &[0, 2, 2, 2, 2, 1],
            Self::RadauTwo => &[0, 0, 2, 2, 1, 1],
            Self::Midpoint | Self::Endpoint => &[0, 2, 2, 1],
        }
    }
}

/// Legendre polynomial of degree `n` and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut last, mut p) = (1.0, x);
    if n == 0 {
        return (1.0, 0.0);
    }
    for k in 2..=n {
        let k = k as f64;
        (last, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * last) / k);
    }
    (p, n as f64 * (last - x * p) / (1.0 - x * x))
}

/// Gauss' rule on -1 to 1 with `n` points, of which `fixed` are given ends: the others are the roots of the polynomial of
/// degree n - fixed that is orthogonal with the weight of the ends, found between the roots of lower degree.
fn gauss(n: usize, fixed: &[f64]) -> Points {
    let value = |x: f64| {
        // Up to a factor that does not vanish inside: P_n, (P_{n-1} + P_n)/(1 + x), P'_{n-1}.
        match fixed.len() {
            0 => legendre(n, x).0,
            1 => legendre(n - 1, x).0 + legendre(n, x).0,
            _ => legendre(n - 1, x).1,
        }
    };
    let free = n.saturating_sub(fixed.len());
    let mut x: Vec<f64> = fixed.iter().copied().filter(|x| *x < 0.0).collect();
    // Roots crowd towards the ends like those of Chebyshev: a grid in the angle has one sign change for each of them.
    let grid = 64 * n.max(1);
    let place = |i: usize| -(std::f64::consts::PI * (i as f64 + 0.5) / grid as f64).cos();
    let mut found = 0;
    for i in 0..grid - 1 {
        let (mut lo, mut hi) = (place(i), place(i + 1));
        if found == free || value(lo) * value(hi) > 0.0 {
            continue;
        }
        for _ in 0..80 {
            let mid = 0.5 * (lo + hi);
            if value(lo) * value(mid) <= 0.0 { hi = mid } else { lo = mid }
        }
        x.push(0.5 * (lo + hi));
        found += 1;
    }
    x.extend(fixed.iter().copied().filter(|x| *x > 0.0));
    let m = n as f64;
    let weight = |x: f64| match fixed.len() {
        0 => 2.0 / ((1.0 - x * x) * legendre(n, x).1.powi(2)),
        1 if x <= -1.0 => 2.0 / (m * m),
        1 => (1.0 - x) / (m * legendre(n - 1, x).0).powi(2),
        _ => 2.0 / (m * (m - 1.0) * legendre_at(n - 1, x).powi(2)),
    };
    let w = x.iter().map(|x| weight(*x)).collect();
    (x, w)
}

/// Legendre polynomial, at the ends too.
fn legendre_at(n: usize, x: f64) -> f64 {
    if x.abs() < 1.0 { legendre(n, x).0 } else { x.powi(n as i32) }
}

/// Weights on 0 to 1 such that polynomials are integrated, the first of them given.
fn polynomial_weights(x: &[f64], given: &[f64]) -> Option<Vec<f64>> {
    let free = x.len().checked_sub(given.len()).filter(|n| *n <= 16)?;
    // About the middle, where powers differ most.
    let power = |x: f64, i: usize| (2.0 * x - 1.0).powi(i as i32);
    let integral = |i: usize| if i.is_multiple_of(2) { 1.0 / (i + 1) as f64 } else { 0.0 };
    let mut w = given.to_vec();
    let mut matrix: Vec<f64> = (0..free).flat_map(|i| x[given.len()..].iter().map(move |x| power(*x, i))).collect();
    if !invert(&mut matrix, free) {
        return None;
    }
    let taken = |i: usize| x.iter().zip(given).map(|(x, w)| power(*x, i) * w).sum::<f64>();
    let rest: Vec<f64> = (0..free).map(|i| integral(i) - taken(i)).collect();
    w.extend(matrix.chunks_exact(free.max(1)).map(|row| row.iter().zip(&rest).map(|(m, r)| m * r).sum::<f64>()));
    Some(w)
}

/// Weights by the distances to the middles between neighbours.
fn mid_distances(x: &[f64]) -> Vec<f64> {
    let before =
        |p: f64| x.iter().copied().filter(|q| *q < p).fold(None, |m: Option<f64>, q| Some(m.map_or(q, |m| m.max(q))));
    let after =
        |p: f64| x.iter().copied().filter(|q| *q > p).fold(None, |m: Option<f64>, q| Some(m.map_or(q, |m| m.min(q))));
    let weight = |p: f64| after(p).map_or(1.0, |q| 0.5 * (p + q)) - before(p).map_or(0.0, |q| 0.5 * (p + q));
    x.iter().map(|p| weight(*p)).collect()
}
