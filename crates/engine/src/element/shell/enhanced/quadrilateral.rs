//! Gauss points of `ASDShellQ4`: the membrane AGQ6-I of quadrilateral area coordinates (Chen, Cen, Long and Yao, 2004,
//! Computers and Structures 82, 35-54), the drilling penalty of Hughes and Brezzi (1989, Computer Methods in Applied
//! Mechanics and Engineering 72, 105-121), and the tied transverse shear strains of Dvorkin and Bathe (1984).

use super::super::mitc4::{self, Bilinear, SIGNS, bilinear};
use super::super::{Geometry, MAX, Row};
use super::INTERNAL;
use super::point::LocalPoint;
use crate::numeric::axpy;
use crate::section::plate::PLATE_ORDER;

/// Area coordinates of a quadrilateral (Long, Li, Long and Cen, 1999): equations 3, 4 and 7 of Chen et al.
struct AreaCoordinates {
    b: [f64; 4],
    c: [f64; 4],
    g: [f64; 4],
    area: f64,
}

impl AreaCoordinates {
    fn new(x: &[[f64; 2]]) -> Self {
        let triangle = |i: usize, j: usize, k: usize| {
            0.5 * ((x[j][0] - x[i][0]) * (x[k][1] - x[i][1]) - (x[k][0] - x[i][0]) * (x[j][1] - x[i][1]))
        };
        let area = triangle(0, 1, 3) + triangle(1, 2, 3);
        let (g1, g2) = (triangle(0, 1, 3) / area, triangle(0, 1, 2) / area);
        let next = |i: usize, n: usize| (i + n) % 4;
        Self {
            b: std::array::from_fn(|i| x[next(i, 1)][1] - x[next(i, 2)][1]),
            c: std::array::from_fn(|i| x[next(i, 2)][0] - x[next(i, 1)][0]),
            g: [g1, g2, 1.0 - g1, 1.0 - g2],
            area,
        }
    }

    fn at(&self, [xi, eta]: [f64; 2]) -> [f64; 4] {
        let g = &self.g;
        let share = |along: f64, across: f64, low: f64, high: f64| {
            0.25 * (1.0 + along) * (low * (1.0 - across) + high * (1.0 + across))
        };
        [
            share(-xi, eta, g[1], g[2]),
            share(-eta, xi, g[3], g[2]),
            share(xi, eta, g[0], g[3]),
            share(eta, xi, g[0], g[1]),
        ]
    }

    /// Gradients of the shape functions of the corners.
    fn gradients(&self, at: [f64; 2]) -> [[f64; 2]; 4] {
        let (l, g) = (self.at(at), &self.g);
        let sign = |i: usize| SIGNS[i][0] * SIGNS[i][1];
        let mut sum = [0.0; 2];
        for i in 0..4 {
            let (j, k, m) = ((i + 1) % 4, (i + 2) % 4, (i + 3) % 4);
            let factor = sign(i) * (3.0 * (l[j] - l[m]) + g[j] - g[k]);
            axpy(factor, &[self.b[i], self.c[i]], &mut sum);
        }
        let whole = 1.0 + g[0] * g[2] + g[1] * g[3];
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 4, (i + 2) % 4);
            let share = sign(i) * g[k] / whole;
            [
                (self.b[i] + self.b[j] + share * sum[0]) / (2.0 * self.area),
                (self.c[i] + self.c[j] + share * sum[1]) / (2.0 * self.area),
            ]
        })
    }

    /// Gradients of the two internal modes.
    fn internal(&self, at: [f64; 2]) -> [[f64; 2]; 2] {
        let l = self.at(at);
        [(0, 2), (1, 3)]
            .map(|(i, k)| [&self.b, &self.c].map(|side| (side[i] * l[k] + side[k] * l[i]) / (2.0 * self.area)))
    }
}

/// Derivatives of the drilling strain by the displacements.
fn drilling_row(geometry: &Geometry, shape: &[f64; 4], gradients: &[[f64; 2]; 4]) -> Row {
    let mut row = [0.0; MAX];
    for (node, (n, [x, y])) in shape.iter().zip(gradients).enumerate() {
        for (dof, value) in [((0, false), -0.5 * y), ((1, false), 0.5 * x), ((2, true), -n)] {
            geometry.add(&mut row, node, dof, value);
        }
    }
    row
}

/// Gauss points in the axes of the plane of the corners. `internal` adds the modes of AGQ6-I, and `stabilisation` is the
/// share of the drilling penalty that is integrated fully.
pub(super) fn points(geometry: &Geometry, internal: bool, stabilisation: f64) -> Vec<LocalPoint> {
    let corners = &geometry.corners;
    let areas = AreaCoordinates::new(corners);
    let of_corners = |at: [f64; 2], plain: [[f64; 2]; 4]| if internal { areas.gradients(at) } else { plain };
    let centre = bilinear(corners, [0.0; 2]);
    let centre_drilling = drilling_row(geometry, &centre.shape, &of_corners([0.0; 2], centre.gradients));
    let directions = mitc4::directions(corners);
    let mut all = vec![];
    for at in SIGNS.map(|s| s.map(|s| s / 3.0f64.sqrt())) {
        let Bilinear { shape, gradients, tangents, area } = bilinear(corners, at);
        let gradients = of_corners(at, gradients);
        let mut p = LocalPoint::new(area);
        for (node, [x, y]) in gradients.into_iter().enumerate() {
            let [u, v, about_1, about_2] = [(0, false), (1, false), (0, true), (1, true)];
            for (row, dof, value) in [(0, u, x), (1, v, y), (2, u, y), (2, v, x)] {
                geometry.add(&mut p.rows[row], node, dof, value);
            }
            for (row, dof, value) in [(3, about_2, -x), (4, about_1, y), (5, about_1, x), (5, about_2, -y)] {
                geometry.add(&mut p.rows[row], node, dof, value);
            }
        }
        mitc4::add_shear(geometry, (at, &tangents, area), directions, &mut p.rows);
        let mut drilling = centre_drilling.map(|d| (1.0 - stabilisation).sqrt() * d);
        axpy(stabilisation.sqrt(), &drilling_row(geometry, &shape, &gradients), &mut drilling);
        p.drilling = vec![drilling];
        if internal {
            for (mode, [x, y]) in areas.internal(at).into_iter().enumerate() {
                let (first, second) = (2 * mode, 2 * mode + 1);
                (p.internal[0][first], p.internal[1][second]) = (x, y);
                (p.internal[2][first], p.internal[2][second]) = (y, x);
            }
        }
        all.push(p);
    }
    remove_mean(&mut all);
    all
}

/// Takes the mean of the internal strains from them, so that a uniform stress does no work on them.
fn remove_mean(points: &mut [LocalPoint]) {
    let whole: f64 = points.iter().map(|p| p.area).sum();
    let mut mean = [[0.0; INTERNAL]; PLATE_ORDER];
    for p in &*points {
        mean.iter_mut().zip(&p.internal).for_each(|(mean, row)| axpy(p.area / whole, row, mean));
    }
    for p in points {
        p.internal.iter_mut().zip(&mean).for_each(|(row, mean)| axpy(-1.0, mean, row));
    }
}
