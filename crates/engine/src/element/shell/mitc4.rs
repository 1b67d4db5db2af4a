//! The four-node shell with tied transverse shear strains: Dvorkin and Bathe, 1984, Engineering Computations 1, 77-88;
//! Bathe and Dvorkin, 1985, International Journal for Numerical Methods in Engineering 21, 367-383.

use super::{Geometry, MAX, Point, Row};
use crate::section::plate::{PLATE_ORDER, PlateSection};
use nalgebra::Matrix3;

/// Natural coordinates of the corners. Gauss points are at 1/√3 of them.
pub(super) const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Sides along which the shear strain is tied: first and last corner, direction, and the side's other coordinate.
const SIDES: [(usize, usize, usize, f64); 4] = [(0, 1, 0, -1.0), (3, 2, 0, 1.0), (0, 3, 1, -1.0), (1, 2, 1, 1.0)];

/// Bilinear shape functions at natural coordinates.
pub(super) struct Bilinear {
    /// Values.
    pub(super) shape: [f64; 4],
    /// Derivatives by the axes of the plane.
    pub(super) gradients: [[f64; 2]; 4],
    /// Derivatives of the place by the natural coordinates.
    pub(super) tangents: [[f64; 2]; 2],
    /// Jacobian determinant.
    pub(super) area: f64,
}

/// Shape functions of a quadrilateral at natural coordinates.
pub(super) fn bilinear(corners: &[[f64; 2]], [xi, eta]: [f64; 2]) -> Bilinear {
    let shape = SIGNS.map(|[s, t]| 0.25 * (1.0 + s * xi) * (1.0 + t * eta));
    let local = SIGNS.map(|[s, t]| [0.25 * s * (1.0 + t * eta), 0.25 * t * (1.0 + s * xi)]);
    let mut tangents = [[0.0; 2]; 2];
    for (d, c) in local.iter().zip(corners) {
        for (along, d) in tangents.iter_mut().zip(d) {
            along.iter_mut().zip(c).for_each(|(a, c)| *a += d * c);
        }
    }
    let [[a, b], [c, d]] = tangents;
    let det = a * d - b * c;
    let gradients = local.map(|[x, y]| [(d * x - b * y) / det, (a * y - c * x) / det]);
    Bilinear { shape, gradients, tangents, area: det }
}

/// Directions of the natural axes at the centre.
pub(super) fn directions(corners: &[[f64; 2]]) -> [[f64; 2]; 2] {
    bilinear(corners, [0.0, 0.0]).tangents.map(|[x, y]| {
        let length = x.hypot(y);
        [x / length, y / length]
    })
}

/// Adds the transverse shear strains at natural coordinates `at` to the rows of the deformations.
pub(super) fn add_shear(
    geometry: &Geometry,
    (at, tangents, det): ([f64; 2], &[[f64; 2]; 2], f64),
    [first, second]: [[f64; 2]; 2],
    rows: &mut [Row; PLATE_ORDER],
) {
    let corners = &geometry.corners;
    // Covariant shear strains from those of the sides, turned into the axes of the plane.
    let lengths = tangents.map(|[x, y]| x.hypot(y));
    let turned = [[second[1], -first[1]], [-second[0], first[0]]];
    for (i, j, direction, side) in SIDES {
        let other = 1 - direction;
        let weight = 0.5 * (1.0 + side * at[other]) * lengths[other] / det;
        let [dx, dy] = [corners[j][0] - corners[i][0], corners[j][1] - corners[i][1]];
        for (axis, factors) in turned.iter().enumerate() {
            let factor = factors[direction] * weight;
            let row = &mut rows[6 + axis];
            for (node, deflection) in [(i, -0.5), (j, 0.5)] {
                geometry.add(row, node, (2, false), factor * deflection);
                geometry.add(row, node, (0, true), -0.25 * factor * dy);
                geometry.add(row, node, (1, true), 0.25 * factor * dx);
            }
        }
    }
}

/// Gauss points of a quadrilateral.
pub(super) fn points(geometry: &Geometry) -> Vec<Point> {
    let corners = &geometry.corners;
    let root = 3.0f64.sqrt();
    // The directions of the natural axes are those at the centre at all points.
    let directions = directions(corners);
    let mut all = vec![];
    for at in SIGNS.map(|s| s.map(|s| s / root)) {
        let Bilinear { shape, gradients, tangents, area: det } = bilinear(corners, at);
        let mut p = Point { rows: [[0.0; MAX]; PLATE_ORDER], drilling: [0.0; MAX], area: det, shape };
        for (node, (n, [x, y])) in shape.iter().zip(gradients).enumerate() {
            let (u, v) = ((0, false), (1, false));
            for (row, dof, value) in [(0, u, x), (1, v, y), (2, u, y), (2, v, x)] {
                geometry.add(&mut p.rows[row], node, dof, value);
            }
            let (about_1, about_2) = ((0, true), (1, true));
            for (row, dof, value) in [(3, about_2, -x), (4, about_1, y), (5, about_1, x), (5, about_2, -y)] {
                geometry.add(&mut p.rows[row], node, dof, value);
            }
            for (dof, value) in [(u, -0.5 * y), (v, 0.5 * x), ((2, true), -n)] {
                geometry.add(&mut p.drilling, node, dof, value);
            }
        }
        add_shear(geometry, (at, &tangents, det), directions, &mut p.rows);
        all.push(p);
    }
    all
}

/// Penalty on the drilling strain: the least stiffness of the membrane.
pub(super) fn drilling_stiffness(section: &dyn PlateSection) -> f64 {
    let k = section.initial_stiffness();
    Matrix3::from_fn(|i, j| k[i][j]).symmetric_eigenvalues().min()
}
