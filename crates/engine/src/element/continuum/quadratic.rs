//! Plane elements whose displacements are quadratic, or enhanced: `quad9n`, `quad8n`, `tri6n`,
//! `enhancedQuad`.

use super::quad::{QuadOptions, SIGNS};
use super::{Body, Continuum, ElementResult, Mass, Rows, least_distance, lumped, plane_rows};
use crate::element::{Class, ElementError};
use crate::material::{PLANE, SharedMultiaxial};
use nalgebra::{Matrix2, Matrix4, SMatrix, Vector2};

/// Coordinate of the outer points of Gauss' rule of three points.
const OUTER: f64 = 0.774_596_669_241_483_4;

/// Shape of an element with quadratic displacements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuadraticShape {
    /// Six nodes: corners and then the middles of the sides 1-2, 2-3 and 3-1 (Zienkiewicz and Taylor, 2000, section 8.8).
    Triangle,
    /// Eight nodes: corners and then the middles of the sides, in order (ibid., section 8.6).
    Serendipity,
    /// Nine nodes: those of eight, and the centre (ibid., section 8.7).
    Lagrange,
}

/// Value and derivatives of a shape function.
type Function = (f64, Vector2<f64>);

impl QuadraticShape {
    /// Number of nodes.
    pub fn nodes(self) -> usize {
        match self {
            Self::Triangle => 6,
            Self::Serendipity => 8,
            Self::Lagrange => 9,
        }
    }

    fn corners(self) -> usize {
        if self == Self::Triangle { 3 } else { 4 }
    }

    /// Shape functions at natural coordinates.
    fn functions(self, s: f64, t: f64) -> Vec<Function> {
        match self {
            Self::Triangle => {
                let l =
                    [(s, Vector2::new(1.0, 0.0)), (t, Vector2::new(0.0, 1.0)), (1.0 - s - t, Vector2::new(-1.0, -1.0))];
                let corner = l.map(|(l, d)| (l * (2.0 * l - 1.0), d * (4.0 * l - 1.0)));
                let side = |i: usize, j: usize| (4.0 * l[i].0 * l[j].0, (l[i].1 * l[j].0 + l[j].1 * l[i].0) * 4.0);
                corner.into_iter().chain([side(0, 1), side(1, 2), side(2, 0)]).collect()
            }
            Self::Serendipity => natural_nodes(8).map(|node| serendipity(node, s, t)).collect(),
            Self::Lagrange => natural_nodes(9)
                .map(|[a, b]| {
                    let ((f, df), (g, dg)) = (parabola(a, s), parabola(b, t));
                    (f * g, Vector2::new(df * g, f * dg))
                })
                .collect(),
        }
    }

    /// Natural coordinates and weights of the points of integration.
    fn points(self) -> Vec<([f64; 2], f64)> {
        if self == Self::Triangle {
            let (far, near) = (2.0 / 3.0, 1.0 / 6.0);
            return [[far, near], [near, far], [near, near]].map(|at| (at, 1.0 / 6.0)).to_vec();
        }
        let weight = |x: f64| if x == 0.0 { 8.0 / 9.0 } else { 5.0 / 9.0 };
        natural_nodes(9).map(|[s, t]| ([OUTER * s, OUTER * t], weight(s) * weight(t))).collect()
    }

    /// Shares of the stresses at the points in the stress at node `i`.
    fn extrapolation(self, i: usize) -> Vec<f64> {
        match self {
            Self::Triangle => {
                let corner = |n: usize| if n == 0 { [1.0, 0.0] } else { [0.0, f64::from(u8::from(n == 1))] };
                let [s, t] = if i < 3 {
                    corner(i)
                } else {
                    let (a, b) = (corner(i - 3), corner((i - 2) % 3));
                    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
                };
                // Linear through the three points.
                vec![2.0 * s - 1.0 / 3.0, 2.0 * t - 1.0 / 3.0, 2.0 * (1.0 - s - t) - 1.0 / 3.0]
            }
            shape => {
                let at = natural_nodes(9).nth(i).unwrap_or_default().map(|x| x / OUTER);
                let mut shares: Vec<f64> = shape.functions(at[0], at[1]).into_iter().map(|(n, _)| n).collect();
                shares.resize(9, 0.0);
                shares
            }
        }
    }
}

/// Natural coordinates of the corners, the middles of the sides and the centre.
fn natural_nodes(count: usize) -> impl Iterator<Item = [f64; 2]> {
    SIGNS.into_iter().chain([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]]).take(count)
}

/// The parabola that is 1 at `a` and 0 at the others of -1, 0 and 1, with its derivative.
fn parabola(a: f64, x: f64) -> (f64, f64) {
    if a == 0.0 { (1.0 - x * x, -2.0 * x) } else { (0.5 * x * (x + a), x + 0.5 * a) }
}

/// Shape function of the node at natural coordinates `node` of the element with eight nodes.
fn serendipity(node: [f64; 2], s: f64, t: f64) -> Function {
    let [a, b] = node;
    if a == 0.0 {
        return (0.5 * (1.0 - s * s) * (1.0 + b * t), Vector2::new(-s * (1.0 + b * t), 0.5 * b * (1.0 - s * s)));
    }
    if b == 0.0 {
        return (0.5 * (1.0 + a * s) * (1.0 - t * t), Vector2::new(0.5 * a * (1.0 - t * t), -t * (1.0 + a * s)));
    }
    let (p, q) = (1.0 + a * s, 1.0 + b * t);
    let rest = a * s + b * t - 1.0;
    (0.25 * p * q * rest, Vector2::new(0.25 * a * q * (rest + p), 0.25 * b * p * (rest + q)))
}

impl<const D: usize> Continuum<PLANE, D> {
    /// Makes an element with quadratic displacements of its nodes, with lumped mass.
    ///
    /// # Errors
    /// The corners are not counterclockwise, or the sides bend too much.
    pub fn quadratic(
        shape: QuadraticShape,
        nodes: &[[f64; 2]],
        law: &SharedMultiaxial<PLANE>,
        options: &QuadOptions,
    ) -> ElementResult<Self> {
        let rho = options.density(law);
        let (mut points, mut load, mut mass) = (vec![], [0.0; D], [0.0; D]);
        for ([s, t], weight) in shape.points() {
            let functions = shape.functions(s, t);
            let (det, gradients) = gradients(nodes, &functions);
            if det.is_nan() || det <= 0.0 {
                return Err(ElementError("the nodes do not make a convex element against the clock".into()));
            }
            let volume = det * weight * options.thickness;
            for (node, (n, _)) in functions.iter().enumerate() {
                for (d, b) in options.body.iter().enumerate() {
                    load[2 * node + d] -= volume * n * b;
                    mass[2 * node + d] += volume * n * rho;
                }
            }
            points.push((plane_rows(gradients.iter().map(|g| [g.x, g.y])), volume));
        }
        for i in 0..shape.corners() {
            let (j, middle) = ((i + 1) % shape.corners(), shape.corners() + i);
            for (from, to) in [(i, middle), (middle, j)] {
                let normal = [nodes[to][1] - nodes[from][1], nodes[from][0] - nodes[to][0]];
                for (node, share) in
                    [(from, if from == middle { 2.0 } else { 1.0 }), (to, if to == middle { 2.0 } else { 1.0 })]
                {
                    for (d, n) in normal.iter().enumerate() {
                        load[2 * node + d] -= options.pressure * share * n / 3.0;
                    }
                }
            }
        }
        let class = match shape {
            QuadraticShape::Triangle => Class::new("SixNodeTri", 209),
            QuadraticShape::Serendipity => Class::new("EightNodeQuad", 208),
            QuadraticShape::Lagrange => Class::new("NineNodeQuad", 207),
        };
        let body = Body {
            class,
            points,
            stabilisation: vec![],
            load_force: load,
            mass: lumped(&mass),
            size: least_distance(nodes),
            extrapolation: (0..nodes.len()).map(|i| shape.extrapolation(i)).collect(),
        };
        Ok(Self::of(body, law))
    }
}

impl Continuum<PLANE, 8> {
    /// Makes a bilinear element with four enhanced strains (Simo and Rifai, 1990, International Journal for Numerical
    /// Methods in Engineering 29, 1595-1638) and consistent mass.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn enhanced(corners: &[[f64; 2]; 4], law: &SharedMultiaxial<PLANE>, thickness: f64) -> ElementResult<Self> {
        let bilinear = |[s, t]: [f64; 2]| -> Vec<Function> {
            let of = |[a, b]: [f64; 2]| {
                let (p, q) = (0.25 * (1.0 + a * s), 1.0 + b * t);
                (p * q, Vector2::new(0.25 * a * q, b * p))
            };
            SIGNS.into_iter().map(of).collect()
        };
        if !(law.is_linear() && law.state_len() == 0) {
            return Err(ElementError(
                "the enhanced strains follow the displacements in linear elasticity alone".into(),
            ));
        }
        let (elasticity, rho) = (law.initial_tangent(), law.density());
        let d = SMatrix::<f64, 3, 3>::from_fn(|i, j| elasticity[i][j]);
        let centre = jacobian(corners, &bilinear([0.0; 2]));
        let inverse = centre.try_inverse().unwrap_or_default();
        let (mut plain, mut enhanced, mut mass) = (vec![], vec![], vec![0.0; 64]);
        let (mut internal, mut by_nodes) = (Matrix4::zeros(), SMatrix::<f64, 4, 8>::zeros());
        for at in SIGNS.map(|s| s.map(|s| s / 3.0f64.sqrt())) {
            let functions = bilinear(at);
            let (det, gradients) = gradients(corners, &functions);
            if det.is_nan() || det <= 0.0 {
                return Err(ElementError("the corners do not make a convex quadrilateral against the clock".into()));
            }
            let volume = det * thickness;
            let rows: Rows<PLANE, 8> = plane_rows(gradients.iter().map(|g| [g.x, g.y]));
            let b = SMatrix::<f64, 3, 8>::from_fn(|i, j| rows[i][j]);
            // Gradients of the modes: rows of the inverse Jacobian at the centre.
            let modes: Vec<Vector2<f64>> = (0..2).map(|m| inverse.row(m).transpose() * (at[m] / det)).collect();
            let rows: Rows<PLANE, 4> = plane_rows(modes.iter().map(|g| [g.x, g.y]));
            let e = SMatrix::<f64, 3, 4>::from_fn(|i, j| rows[i][j]);
            internal += e.transpose() * d * e * volume;
            by_nodes += e.transpose() * d * b * volume;
            for (i, (a, _)) in functions.iter().enumerate() {
                for (j, (b, _)) in functions.iter().enumerate() {
                    for d in 0..2 {
                        mass[(2 * i + d) * 8 + 2 * j + d] += volume * rho * a * b;
                    }
                }
            }
            plain.push((b, volume));
            enhanced.push(e);
        }
        let Some(inverse) = internal.try_inverse() else {
            return Err(ElementError("the enhanced strains have no stiffness".into()));
        };
        // In linear elasticity the enhanced strains follow the displacements.
        let follow = inverse * by_nodes;
        let points = plain.into_iter().zip(enhanced).map(|((b, volume), e)| {
            let rows = b - e * follow;
            (std::array::from_fn(|i| std::array::from_fn(|j| rows[(i, j)])), volume)
        });
        let body = Body {
            class: Class::new("EnhancedQuad", 59),
            points: points.collect(),
            stabilisation: vec![],
            load_force: [0.0; 8],
            mass: if rho == 0.0 { Mass::None } else { Mass::Consistent(mass) },
            size: least_distance(corners),
            extrapolation: vec![],
        };
        Ok(Self::of(body, law))
    }
}

/// Derivatives of the place by the natural coordinates, as columns.
fn jacobian(nodes: &[[f64; 2]], functions: &[Function]) -> Matrix2<f64> {
    nodes.iter().zip(functions).map(|(x, (_, d))| Vector2::from(*x) * d.transpose()).sum()
}

/// Determinant of the Jacobian, and the gradients of the shape functions.
fn gradients(nodes: &[[f64; 2]], functions: &[Function]) -> (f64, Vec<Vector2<f64>>) {
    let j = jacobian(nodes, functions);
    let to_global = j.try_inverse().unwrap_or_default().transpose();
    (j.determinant(), functions.iter().map(|(_, d)| to_global * d).collect())
}
