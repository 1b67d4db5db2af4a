//! Gauss points of `ASDShellT3`: the membrane is the optimal triangle with drilling rotations (Felippa, 2003, Computer
//! Methods in Applied Mechanics and Engineering 192, 2125-2168), the transverse shear strains are tied (Lee and Bathe,
//! 2004, Computers and Structures 82, 945-962) and reduced in thin plates (Lyly, Stenberg and Vihinen, 1993, ibid. 110,
//! 343-357).

use super::super::{Geometry, MAX, Row};
use super::point::LocalPoint;
use nalgebra::{Matrix2, Matrix3, SMatrix};

/// Points at the middles of the sides, or the centroid, in area coordinates 2 and 3, with the share of the area.
const MIDDLES: [([f64; 2], f64); 3] = [([0.5, 0.5], 1.0 / 3.0), ([0.0, 0.5], 1.0 / 3.0), ([0.5, 0.0], 1.0 / 3.0)];
const CENTRE: [([f64; 2], f64); 1] = [([1.0 / 3.0, 1.0 / 3.0], 1.0)];

/// Weight of the drilling rotations in the basic membrane strains.
const BASIC_DRILLING: f64 = 1.5;
/// Weight of the higher-order stiffness: β₀ = 1/2.
const HIGHER_ORDER: f64 = 0.5;
/// Weight of the curvature of the drilling rotation, as a share of the squared size: it only stops mechanisms.
const DRILLING_CURVATURE: f64 = 0.1;
/// Weight of the squared size of the mesh in the reduction of the transverse shear.
const SHEAR_REDUCTION: f64 = 0.1;

/// Differences of the coordinates of two corners.
fn difference(x: &[[f64; 2]], i: usize, j: usize) -> [f64; 2] {
    [x[i][0] - x[j][0], x[i][1] - x[j][1]]
}

/// Gauss points in the axes of the plane of the corners: one with a penalty on the drilling strain, or three without.
/// `thickness` is that of a solid plate of the same ratio of bending to membrane stiffness.
pub(super) fn points(geometry: &Geometry, reduced: bool, thickness: f64) -> Vec<LocalPoint> {
    let x = &geometry.corners;
    let lengths = [(1, 0), (2, 1), (0, 2)].map(|(i, j)| difference(x, i, j)).map(|[dx, dy]| dx.hypot(dy));
    let (least, most) = lengths.iter().fold((f64::INFINITY, 0.0f64), |(a, b), l| (a.min(*l), b.max(*l)));
    let square = thickness * thickness;
    let shear = (square / (square + SHEAR_REDUCTION * most * most)).sqrt();
    let ([x21, y21], [x31, y31]) = (difference(x, 1, 0), difference(x, 2, 0));
    let double = x21 * y31 - x31 * y21;
    let gradients: [[f64; 2]; 3] = std::array::from_fn(|i| {
        let [dx, dy] = difference(x, (i + 1) % 3, (i + 2) % 3);
        [dy / double, -dx / double]
    });
    let rule: &[([f64; 2], f64)] = if reduced { &CENTRE } else { &MIDDLES };
    let make = |&(at, share): &([f64; 2], f64)| {
        let mut p = LocalPoint::new(0.5 * double * share);
        let shape = [1.0 - at[0] - at[1], at[0], at[1]];
        add_membrane(geometry, double, &mut p);
        if reduced {
            p.drilling = drilling_rows(geometry, &shape, &gradients, DRILLING_CURVATURE.sqrt() * least);
        } else {
            add_higher_order(geometry, double, &shape, &mut p);
        }
        for (node, [x, y]) in gradients.into_iter().enumerate() {
            let (about_1, about_2) = ((0, true), (1, true));
            for (row, dof, value) in [(3, about_2, -x), (4, about_1, y), (5, about_1, x), (5, about_2, -y)] {
                geometry.add(&mut p.rows[row], node, dof, value);
            }
        }
        add_shear(geometry, double, at, shear, &mut p);
        p
    };
    rule.iter().map(make).collect()
}

/// Basic membrane strains.
fn add_membrane(geometry: &Geometry, double: f64, p: &mut LocalPoint) {
    let x = &geometry.corners;
    for node in 0..3 {
        let (next, last) = ((node + 1) % 3, (node + 2) % 3);
        let [xa, ya] = difference(x, next, last);
        let ([xb, yb], [xc, yc]) = (difference(x, last, node), difference(x, node, next));
        let [u, v, drill] = [(0, false), (1, false), (2, true)];
        let turn = BASIC_DRILLING / double;
        for (row, dof, value) in [
            (0, u, ya / double),
            (1, v, -xa / double),
            (2, u, -xa / double),
            (2, v, ya / double),
            (0, drill, turn * ya * (yc - yb) / 6.0),
            (1, drill, turn * -xa * (xb - xc) / 6.0),
            (2, drill, turn * (xc * yc - xb * yb) / 3.0),
        ] {
            geometry.add(&mut p.rows[row], node, dof, value);
        }
    }
}

/// Higher-order membrane strains of the optimal triangle.
fn add_higher_order(geometry: &Geometry, double: f64, shape: &[f64; 3], p: &mut LocalPoint) {
    let x = &geometry.corners;
    let area = 0.5 * double;
    let sides = [difference(x, 1, 0), difference(x, 2, 1), difference(x, 0, 2)];
    let squares = sides.map(|[dx, dy]| dx * dx + dy * dy);
    // Strains along the sides in the axes of the plane: column i from side i.
    let natural = Matrix3::from_fn(|row, side| {
        let ([x1, y1], [x2, y2]) = (sides[(side + 1) % 3], sides[(side + 2) % 3]);
        let value = match row {
            0 => -y1 * y2,
            1 => -x1 * x2,
            _ => y1 * x2 + x1 * y2,
        };
        value * squares[side] / (4.0 * area * area)
    });
    // β₁ to β₉ of the optimal triangle, for corner 1; the other corners permute them.
    let [b1, b2, b3, b4, b5, b6, b7, b8, b9] = [1.0, 2.0, 1.0, 0.0, 1.0, -1.0, -1.0, -1.0, -2.0];
    let by_corner = [
        [[b1, b2, b3], [b4, b5, b6], [b7, b8, b9]],
        [[b9, b7, b8], [b3, b1, b2], [b6, b4, b5]],
        [[b5, b6, b4], [b8, b9, b7], [b2, b3, b1]],
    ];
    let along = Matrix3::from_fn(|side, turn| {
        let sum: f64 = by_corner.iter().zip(shape).map(|(b, n)| n * b[side][turn]).sum();
        2.0 * area / 3.0 / squares[side] * sum
    });
    // Hierarchical rotations of the corners: theirs less that of the triangle as a whole.
    let turns = SMatrix::<f64, 3, 9>::from_fn(|row, column| {
        let (node, dof) = (column / 3, column % 3);
        let opposite = difference(x, (node + 2) % 3, (node + 1) % 3);
        match dof {
            2 => f64::from(u8::from(row == node)),
            _ => opposite[dof] / (4.0 * area),
        }
    });
    let strains = natural * along * turns;
    // Three points of a third of the area each, and 3/4 β₀ of the higher-order stiffness.
    let scale = (3.0 * 0.75 * HIGHER_ORDER).sqrt();
    for row in 0..3 {
        for column in 0..9 {
            let dof = [(0, false), (1, false), (2, true)][column % 3];
            geometry.add(&mut p.rows[row], column / 3, dof, scale * strains[(row, column)]);
        }
    }
}

/// Tied transverse shear strains.
fn add_shear(geometry: &Geometry, double: f64, [xi, eta]: [f64; 2], reduction: f64, p: &mut LocalPoint) {
    let x = &geometry.corners;
    let ([x21, y21], [x31, y31]) = (difference(x, 1, 0), difference(x, 2, 0));
    let [x32, y32] = difference(x, 2, 1);
    let (first, second) = (x21.hypot(y21), x31.hypot(y31));
    let turned = Matrix2::new(y31 / second, -y21 / first, -x31 / second, x21 / first);
    let to_axes = turned * Matrix2::new(second, 0.0, 0.0, first) / double;
    // Deflection and rotations of each corner: strains along sides 1-2 and 1-3.
    let natural = [
        [
            [-1.0, -0.5 * (y21 + y32 * xi), 0.5 * (x21 + x32 * xi)],
            [1.0, -0.5 * (y21 - y31 * xi), 0.5 * (x21 - x31 * xi)],
            [0.0, -0.5 * y21 * xi, 0.5 * x21 * xi],
        ],
        [
            [-1.0, 0.5 * (-y31 + y32 * eta), -0.5 * (-x31 + x32 * eta)],
            [0.0, -0.5 * y31 * eta, 0.5 * x31 * eta],
            [1.0, 0.5 * (-y31 + y21 * eta), -0.5 * (-x31 + x21 * eta)],
        ],
    ];
    for row in 0..2 {
        for (node, (first, second)) in natural[0].iter().zip(&natural[1]).enumerate() {
            for (at, dof) in [(2, false), (0, true), (1, true)].into_iter().enumerate() {
                let value = to_axes[(row, 0)] * first[at] + to_axes[(row, 1)] * second[at];
                geometry.add(&mut p.rows[6 + row], node, dof, reduction * value);
            }
        }
    }
}

/// Drilling strain, and the curvatures of the drilling rotation times `length`.
fn drilling_rows(geometry: &Geometry, shape: &[f64; 3], gradients: &[[f64; 2]; 3], length: f64) -> Vec<Row> {
    let mut rows = vec![[0.0; MAX]; 3];
    for (node, (n, [x, y])) in shape.iter().zip(gradients).enumerate() {
        let [u, v, drill] = [(0, false), (1, false), (2, true)];
        for (row, dof, value) in
            [(0, u, -0.5 * y), (0, v, 0.5 * x), (0, drill, -n), (1, drill, length * x), (2, drill, length * y)]
        {
            geometry.add(&mut rows[row], node, dof, value);
        }
    }
    rows
}
