//! Integration along a beam: positions and weights of its sections (`beamIntegration`).

use crate::numeric::invert;

/// An integration rule.
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// Gauss-Lobatto: both ends are points.
    Lobatto,
    /// Gauss-Legendre: no end is a point.
    Legendre,
    /// Gauss-Radau: end i is a point.
    Radau,
    /// Newton-Cotes: equidistant points, weights of the interpolating polynomial.
    NewtonCotes,
    /// Trapezoidal rule with equidistant points.
    Trapezoidal,
    /// Simpson's rule with equidistant points.
    Simpson,
    /// Points and weights as fractions of the length.
    Given(Vec<f64>, Vec<f64>),
    /// Points as fractions of the length, and the first weights, if any. The other weights integrate polynomials
    /// exactly.
    Located(Vec<f64>, Vec<f64>),
    /// Points as fractions of the length; each has the part of the length that is closer to it than to its neighbours.
    MidDistance(Vec<f64>),
    /// Hinges of given lengths at i and j, with two Gauss points between them.
    Hinges(Hinge, f64, f64),
}

/// Integration rule of a plastic hinge (Scott and Fenves, 2006).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hinge {
    /// Radau's two points over four hinge lengths: the end point has the weight of the hinge length.
    Radau,
    /// Radau's two points over the hinge length.
    RadauTwo,
    /// The midpoint.
    Midpoint,
    /// The end point.
    Endpoint,
}

/// Points and weights as fractions of the length.
pub type Points = (Vec<f64>, Vec<f64>);

impl Rule {
    /// Points and weights for `n` sections of a beam of the given length. `None` if the rule has no such number of
    /// points.
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
        // Map [-1, 1] to [0, 1].
        Some((x.iter().map(|x| 0.5 * (x + 1.0)).collect(), w.iter().map(|w| 0.5 * w).collect()))
    }
}

impl Hinge {
    fn points(self, i: f64, j: f64) -> Points {
        // Per hinge length: distances of the points from the end, their weights, and the extent of the hinge.
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

    /// Section of each point: 0 for hinge i, 1 for hinge j, 2 for the interior.
    pub fn sections(self) -> &'static [usize] {
        match self {
            // As in OpenSees, only the end points of the longer rule have the hinge section.
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

/// Gauss' rule on [-1, 1] with `n` points, of which `fixed` are prescribed ends. The others are the roots of the
/// polynomial of degree n - fixed that is orthogonal with the weight of the ends.
fn gauss(n: usize, fixed: &[f64]) -> Points {
    let value = |x: f64| {
        // Polynomials up to a factor without roots inside: P_n, (P_{n-1} + P_n)/(1 + x), P'_{n-1}.
        match fixed.len() {
            0 => legendre(n, x).0,
            1 => legendre(n - 1, x).0 + legendre(n, x).0,
            _ => legendre(n - 1, x).1,
        }
    };
    let free = n.saturating_sub(fixed.len());
    let mut x: Vec<f64> = fixed.iter().copied().filter(|x| *x < 0.0).collect();
    // Roots cluster at the ends like those of Chebyshev polynomials: on a grid in the angle each has its own sign
    // change.
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

/// Legendre polynomial, ends included.
fn legendre_at(n: usize, x: f64) -> f64 {
    if x.abs() < 1.0 { legendre(n, x).0 } else { x.powi(n as i32) }
}

/// Weights on [0, 1] that integrate polynomials exactly, with the first weights given.
fn polynomial_weights(x: &[f64], given: &[f64]) -> Option<Vec<f64>> {
    let free = x.len().checked_sub(given.len()).filter(|n| *n <= 16)?;
    // Powers about the middle are better conditioned.
    let power = |x: f64, i: usize| (2.0 * x - 1.0).powi(i as i32);
    let integral = |i: usize| if i.is_multiple_of(2) { 1.0 / (i + 1) as f64 } else { 0.0 };
    let mut w = given.to_vec();
    let mut matrix: Vec<f64> = (0..free).flat_map(|i| x[given.len()..].iter().map(move |x| power(*x, i))).collect();
    if !invert(&mut matrix, free) {
        return None;
    }
    let given_part = |i: usize| x.iter().zip(given).map(|(x, w)| power(*x, i) * w).sum::<f64>();
    let rest: Vec<f64> = (0..free).map(|i| integral(i) - given_part(i)).collect();
    w.extend(matrix.chunks_exact(free.max(1)).map(|row| row.iter().zip(&rest).map(|(m, r)| m * r).sum::<f64>()));
    Some(w)
}

/// Weights from the midpoints between neighbours.
fn mid_distances(x: &[f64]) -> Vec<f64> {
    let before =
        |p: f64| x.iter().copied().filter(|q| *q < p).fold(None, |m: Option<f64>, q| Some(m.map_or(q, |m| m.max(q))));
    let after =
        |p: f64| x.iter().copied().filter(|q| *q > p).fold(None, |m: Option<f64>, q| Some(m.map_or(q, |m| m.min(q))));
    let weight = |p: f64| after(p).map_or(1.0, |q| 0.5 * (p + q)) - before(p).map_or(0.0, |q| 0.5 * (p + q));
    x.iter().map(|p| weight(*p)).collect()
}
