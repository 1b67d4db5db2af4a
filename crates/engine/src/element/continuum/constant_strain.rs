//! Plane elements with one point of integration: the stabilised quadrilateral `SSPquad` and the triangle `tri31`. Their
//! mass is lumped.

use super::quad::QuadOptions;
use super::{Body, Continuum, ElementResult, least_distance, lumped, plane_rows};
use crate::element::{Class, ElementError};
use crate::material::{PLANE, SharedMultiaxial};

/// Derivatives by x and y of the shape functions of the nodes, and the volume that belongs to each node.
struct Shape {
    gradients: Vec<[f64; 2]>,
    volumes: Vec<f64>,
    /// Least distance of two nodes.
    size: f64,
}

impl Shape {
    fn body<const D: usize>(
        self,
        class: Class,
        stabilisation: Vec<f64>,
        law: &SharedMultiaxial<PLANE>,
        options: &QuadOptions,
    ) -> Body<PLANE, D> {
        let rho = options.density(law);
        let mass: [f64; D] = std::array::from_fn(|i| rho * self.volumes[i / 2]);
        Body {
            class,
            points: vec![(plane_rows(self.gradients), self.volumes.iter().sum())],
            stabilisation,
            load_force: std::array::from_fn(|i| -options.body[i % 2] * self.volumes[i / 2]),
            mass: lumped(&mass),
            size: self.size,
            extrapolation: vec![],
        }
    }
}

impl Continuum<PLANE, 8> {
    /// A quadrilateral with one point and a physical stabilisation of its hourglass modes (McGann, Arduino and
    /// Mackenzie-Helnwein, 2012), of its corners counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn stabilised_quad(
        corners: &[[f64; 2]; 4],
        law: &SharedMultiaxial<PLANE>,
        options: &QuadOptions,
    ) -> ElementResult<Self> {
        const XI: [f64; 4] = [-1.0, 1.0, 1.0, -1.0];
        const ETA: [f64; 4] = [-1.0, -1.0, 1.0, 1.0];
        let sum = |signs: [f64; 4], d: usize| -> f64 { signs.iter().zip(corners).map(|(s, c)| s * c[d]).sum() };
        let hourglass: [f64; 4] = std::array::from_fn(|i| XI[i] * ETA[i]);
        let (a, b) = ([0, 1].map(|d| 0.25 * sum(XI, d)), [0, 1].map(|d| 0.25 * sum(ETA, d)));
        let h = [0, 1].map(|d| sum(hourglass, d));
        // The Jacobian determinant is j0 + j1 ξ + j2 η.
        let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
        let j0 = cross(a, b);
        let (j1, j2) = (0.25 * cross(a, h), 0.25 * cross(h, b));
        if (0..4).any(|i| j0 + j1 * XI[i] + j2 * ETA[i] <= 0.0) {
            return Err(ElementError("the corners do not make a convex quadrilateral against the clock".into()));
        }
        let t = options.thickness;
        // Rows of the inverse Jacobian: derivatives of ξ and η by x and y.
        let inverse = [[b[1] / j0, -b[0] / j0], [-a[1] / j0, a[0] / j0]];
        let gradients: Vec<[f64; 2]> =
            (0..4).map(|i| [0, 1].map(|d| 0.25 * (XI[i] * inverse[0][d] + ETA[i] * inverse[1][d]))).collect();
        let volumes = (0..4).map(|i| t * (j0 + (j1 * XI[i] + j2 * ETA[i]) / 3.0)).collect();
        let gamma: [f64; 4] =
            std::array::from_fn(|i| 0.25 * (hourglass[i] - h[0] * gradients[i][0] - h[1] * gradients[i][1]));
        let c = law.initial_tangent();
        let resistance = c[0][0] - c[0][1] - c[1][0] + c[1][1];
        let bending = hourglass_moments(t * j0, a, b, inverse);
        let mut stabilisation = vec![0.0; 64];
        for (i, gi) in gamma.iter().enumerate() {
            for (j, gj) in gamma.iter().enumerate() {
                for (p, row) in bending.iter().enumerate() {
                    for (q, moment) in row.iter().enumerate() {
                        stabilisation[(2 * i + p) * 8 + 2 * j + q] = gi * gj * moment * resistance;
                    }
                }
            }
        }
        let shape = Shape { gradients, volumes, size: least_distance(corners) };
        Ok(Self::of(shape.body(Class::new("SSPquad", 119), stabilisation, law, options), law))
    }
}

impl Continuum<PLANE, 6> {
    /// A triangle of its corners, counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise.
    pub fn triangle(
        corners: &[[f64; 2]; 3],
        law: &SharedMultiaxial<PLANE>,
        options: &QuadOptions,
    ) -> ElementResult<Self> {
        let side = |i: usize| [0, 1].map(|d| corners[(i + 2) % 3][d] - corners[(i + 1) % 3][d]);
        let area = 0.5 * (side(0)[0] * side(1)[1] - side(0)[1] * side(1)[0]);
        if area <= 0.0 {
            return Err(ElementError("the corners do not make a triangle against the clock".into()));
        }
        let gradients = (0..3).map(|i| [-side(i)[1] / (2.0 * area), side(i)[0] / (2.0 * area)]).collect();
        let volumes = vec![options.thickness * area / 3.0; 3];
        let mut body = Shape { gradients, volumes, size: least_distance(corners) }.body(
            Class::new("Tri31", 33),
            vec![],
            law,
            options,
        );
        for side in [(0, 1), (1, 2), (2, 0)] {
            options.press(corners, side, &mut body.load_force);
        }
        // The stress is the same everywhere.
        body.extrapolation = vec![vec![1.0]; 3];
        Ok(Self::of(body, law))
    }
}

/// Second moments of the hourglass field of a quadrilateral in its natural axes, from half its sides `a` and `b`.
fn hourglass_moments(volume: f64, a: [f64; 2], b: [f64; 2], inverse: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let unit = |v: [f64; 2]| v.map(|x| x / v[0].hypot(v[1]));
    let (a, b) = (unit(a), unit(b));
    let i = |p: usize, q: usize| 4.0 / 3.0 * volume * (a[p] * a[q] + b[p] * b[q]);
    let [[p00, p01], [p10, p11]] = inverse;
    let ss = i(0, 0) * p10 * p10 + i(0, 1) * p00 * p10 + i(1, 1) * p00 * p00;
    let tt = i(0, 0) * p11 * p11 + i(0, 1) * p01 * p11 + i(1, 1) * p01 * p01;
    let st = i(0, 0) * p11 * p10 + i(0, 1) * (p10 * p01 + p11 * p00) + i(1, 1) * p01 * p00;
    [[0.25 * ss, -0.25 * st], [-0.25 * st, 0.25 * tt]]
}
