//! Thin shells of three or four nodes: bending by discrete Kirchhoff constraints on the sides (Batoz, Bathe and Ho, 1980,
//! International Journal for Numerical Methods in Engineering 15, 1771-1812; Batoz and Ben Tahar, 1982, ibid. 18,
//! 1655-1677), and a membrane whose sides bend by the drilling rotations (Allman, 1984, Computers and Structures 19, 1-8).

use super::mitc4::{Bilinear, SIGNS, bilinear};
use super::{Geometry, MAX, Point};
use crate::section::plate::PLATE_ORDER;

/// Derivatives by the axes of the plane.
type Gradient = [f64; 2];

/// Shape functions at a point: linear ones of the corners, and the gradients of linear and quadratic ones.
struct Shapes {
    linear: [f64; 4],
    gradients: [Gradient; 4],
    /// Quadratic functions of the corners.
    corners: [Gradient; 4],
    /// Quadratic functions of the middles of the sides, each from a corner to the next.
    middles: [Gradient; 4],
    area: f64,
}

/// Points and weights of a triangle: area coordinates, and shares of the area (Zienkiewicz and Taylor, 2000, table 9.2).
const TRIANGLE: [([f64; 3], f64); 4] = [
    ([1.0 / 3.0; 3], -9.0 / 16.0),
    ([0.2, 0.6, 0.2], 25.0 / 48.0),
    ([0.6, 0.2, 0.2], 25.0 / 48.0),
    ([0.2, 0.2, 0.6], 25.0 / 48.0),
];

/// Shape functions of a triangle at area coordinates with a weight.
fn triangle(x: &[[f64; 2]], (l, weight): ([f64; 3], f64)) -> Shapes {
    let double = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]);
    let mut s = Shapes {
        linear: [l[0], l[1], l[2], 0.0],
        gradients: [[0.0; 2]; 4],
        corners: [[0.0; 2]; 4],
        middles: [[0.0; 2]; 4],
        area: 0.5 * weight * double,
    };
    for (i, l) in l.iter().enumerate() {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        s.gradients[i] = [(x[j][1] - x[k][1]) / double, (x[k][0] - x[j][0]) / double];
        s.corners[i] = s.gradients[i].map(|g| (4.0 * l - 1.0) * g);
    }
    for i in 0..3 {
        let j = (i + 1) % 3;
        s.middles[i] = [0, 1].map(|d| 4.0 * (l[i] * s.gradients[j][d] + l[j] * s.gradients[i][d]));
    }
    s
}

/// Shape functions of a quadrilateral at natural coordinates: the quadratic ones are those of eight nodes.
fn quadrilateral(x: &[[f64; 2]], at: [f64; 2]) -> Shapes {
    let Bilinear { shape: linear, gradients, tangents: [[a, b], [c, d]], area: det } = bilinear(x, at);
    let [xi, eta] = at;
    let global = |[x, y]: Gradient| [(d * x - b * y) / det, (a * y - c * x) / det];
    let corners = SIGNS.map(|[s, t]| {
        global([
            0.25 * s * (1.0 + t * eta) * (2.0 * s * xi + t * eta),
            0.25 * t * (1.0 + s * xi) * (s * xi + 2.0 * t * eta),
        ])
    });
    let along = |t: f64| global([-xi * (1.0 + t * eta), 0.5 * t * (1.0 - xi * xi)]);
    let across = |s: f64| global([0.5 * s * (1.0 - eta * eta), -eta * (1.0 + s * xi)]);
    Shapes { linear, gradients, corners, middles: [along(-1.0), across(1.0), along(1.0), across(-1.0)], area: det }
}

/// Gauss points of a triangle or a quadrilateral.
pub(super) fn points(geometry: &Geometry) -> Vec<Point> {
    let x = &geometry.corners;
    if x.len() == 3 {
        return TRIANGLE.map(|at| point(geometry, &triangle(x, at))).to_vec();
    }
    SIGNS.map(|s| point(geometry, &quadrilateral(x, s.map(|s| s / 3.0f64.sqrt())))).to_vec()
}

/// Constants of a side from corner `i` to corner `j` in the rotations of the normal: a to e of Batoz.
fn side(x: &[[f64; 2]], i: usize, j: usize) -> [f64; 5] {
    let [dx, dy] = [x[i][0] - x[j][0], x[i][1] - x[j][1]];
    let square = dx * dx + dy * dy;
    let c = |along: f64, across: f64| (0.25 * along * along - 0.5 * across * across) / square;
    [-dx / square, 0.75 * dx * dy / square, c(dx, dy), -dy / square, c(dy, dx)]
}

/// A Gauss point from its shape functions.
fn point(geometry: &Geometry, s: &Shapes) -> Point {
    let (x, n) = (&geometry.corners, geometry.corners.len());
    let mut p = Point { rows: [[0.0; MAX]; PLATE_ORDER], drilling: [0.0; MAX], area: s.area, shape: s.linear };
    for node in 0..n {
        let (next, last) = ((node + 1) % n, (node + n - 1) % n);
        let [gx, gy] = s.gradients[node];
        let (u, v) = ((0, false), (1, false));
        for (row, dof, value) in [(0, u, gx), (1, v, gy), (2, u, gy), (2, v, gx)] {
            geometry.add(&mut p.rows[row], node, dof, value);
        }
        // A side bends by an eighth of its length times the difference of the drilling rotations of its ends.
        let (after, before) = (s.middles[node], s.middles[last]);
        let bent = |d: usize, axis: usize| {
            let side = |from: usize, to: usize| x[to][axis] - x[from][axis];
            0.125 * (side(last, node) * before[d] - side(node, next) * after[d])
        };
        let drill = (2, true);
        for (row, value) in [(0, bent(0, 1)), (1, -bent(1, 0)), (2, bent(1, 1) - bent(0, 0))] {
            geometry.add(&mut p.rows[row], node, drill, value);
        }
        // Gradients of the rotations of the normal by deflection and rotations of the corner.
        let ([a1, b1, c1, d1, e1], [a0, b0, c0, d0, e0]) = (side(x, node, next), side(x, last, node));
        let by = |d: usize| {
            let (m1, m0, own) = (after[d], before[d], s.corners[node][d]);
            let of_x = [1.5 * (a1 * m1 - a0 * m0), b1 * m1 + b0 * m0, own - c1 * m1 - c0 * m0];
            let of_y = [1.5 * (d1 * m1 - d0 * m0), e1 * m1 + e0 * m0 - own, -b1 * m1 - b0 * m0];
            (of_x, of_y)
        };
        let ((x_by_x, y_by_x), (x_by_y, y_by_y)) = (by(0), by(1));
        for (i, dof) in [(2, false), (0, true), (1, true)].into_iter().enumerate() {
            for (row, value) in [(3, x_by_x[i]), (4, y_by_y[i]), (5, x_by_y[i] + y_by_x[i])] {
                geometry.add(&mut p.rows[row], node, dof, -value);
            }
        }
    }
    p
}
