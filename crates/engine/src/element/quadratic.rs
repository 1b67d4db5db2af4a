//! Plane elements of linear elasticity whose displacements are quadratic, or enhanced: `quad9n`, `quad8n`, `tri6n`,
//! `enhancedQuad`.

use super::continuum::{add_point_force, strain_or_stress};
use super::quad::{QuadOptions, SIGNS};
use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, OpenSeesTraits, Snapshot};
use crate::material::{Isotropic, Plane};
use crate::numeric::axpy;
use crate::probe::Probe;
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

/// Derivatives of the strains xx, yy and the shear angle by the displacements.
type Rows = [Vec<f64>; 3];

/// An element of plane elasticity with constant matrices. Pressure and body forces act from the start, independent of load
/// patterns.
#[derive(Clone, Debug)]
pub struct PlaneElastic {
    class: &'static str,
    dofs: usize,
    stiffness: Vec<f64>,
    load_force: Vec<f64>,
    mass: Mass,
    elasticity: [[f64; 3]; 3],
    points: Vec<(Rows, f64)>,
    /// Shares of the points in the stresses at each node; empty where they are not reported.
    extrapolation: Vec<Vec<f64>>,
}

impl PlaneElastic {
    fn of(class: &'static str, dofs: usize, elasticity: [[f64; 3]; 3], points: Vec<(Rows, f64)>) -> Self {
        let mut stiffness = vec![0.0; dofs * dofs];
        for (rows, volume) in &points {
            for (a, d) in rows.iter().zip(&elasticity) {
                for (b, d) in rows.iter().zip(d) {
                    for (i, a) in a.iter().enumerate() {
                        axpy(volume * d * a, b, &mut stiffness[dofs * i..dofs * (i + 1)]);
                    }
                }
            }
        }
        let load_force = vec![0.0; dofs];
        Self { class, dofs, stiffness, load_force, mass: Mass::None, elasticity, points, extrapolation: vec![] }
    }

    /// Makes an element with quadratic displacements of its nodes, with lumped mass.
    ///
    /// # Errors
    /// The corners are not counterclockwise, or the sides bend too much.
    pub fn quadratic(
        shape: QuadraticShape,
        nodes: &[[f64; 2]],
        (material, plane): (&Isotropic, Plane),
        options: &QuadOptions,
    ) -> Result<Self, ElementError> {
        let dofs = 2 * nodes.len();
        let rho = if options.rho == 0.0 { material.rho } else { options.rho };
        let (mut points, mut load, mut mass) = (vec![], vec![0.0; dofs], vec![0.0; dofs]);
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
            points.push((strain_rows(&gradients), volume));
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
            QuadraticShape::Triangle => "SixNodeTri",
            QuadraticShape::Serendipity => "EightNodeQuad",
            QuadraticShape::Lagrange => "NineNodeQuad",
        };
        let mut made = Self::of(class, dofs, material.plane(plane), points);
        made.load_force = load;
        if rho != 0.0 {
            made.mass = Mass::Lumped(mass);
        }
        made.extrapolation = (0..nodes.len()).map(|i| shape.extrapolation(i)).collect();
        Ok(made)
    }

    /// Makes a bilinear element with four enhanced strains (Simo and Rifai, 1990, International Journal for Numerical
    /// Methods in Engineering 29, 1595-1638) and consistent mass.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn enhanced(
        corners: &[[f64; 2]; 4],
        (material, plane): (&Isotropic, Plane),
        thickness: f64,
    ) -> Result<Self, ElementError> {
        let bilinear = |[s, t]: [f64; 2]| -> Vec<Function> {
            let of = |[a, b]: [f64; 2]| {
                let (p, q) = (0.25 * (1.0 + a * s), 1.0 + b * t);
                (p * q, Vector2::new(0.25 * a * q, b * p))
            };
            SIGNS.into_iter().map(of).collect()
        };
        let elasticity = material.plane(plane);
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
            let rows = strain_rows(&gradients);
            let b = SMatrix::<f64, 3, 8>::from_fn(|i, j| rows[i][j]);
            // Gradients of the modes: rows of the inverse Jacobian at the centre.
            let modes: Vec<Vector2<f64>> = (0..2).map(|m| inverse.row(m).transpose() * (at[m] / det)).collect();
            let rows = strain_rows(&modes);
            let e = SMatrix::<f64, 3, 4>::from_fn(|i, j| rows[i][j]);
            internal += e.transpose() * d * e * volume;
            by_nodes += e.transpose() * d * b * volume;
            for (i, (a, _)) in functions.iter().enumerate() {
                for (j, (b, _)) in functions.iter().enumerate() {
                    for d in 0..2 {
                        mass[(2 * i + d) * 8 + 2 * j + d] += volume * material.rho * a * b;
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
            (std::array::from_fn(|i| rows.row(i).iter().copied().collect()), volume)
        });
        let mut made = Self::of("EnhancedQuad", 8, elasticity, points.collect());
        if material.rho != 0.0 {
            made.mass = Mass::Consistent(mass);
        }
        Ok(made)
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

fn strain_rows(gradients: &[Vector2<f64>]) -> Rows {
    let row = |f: fn(&Vector2<f64>) -> [f64; 2]| gradients.iter().flat_map(f).collect();
    [row(|g| [g.x, 0.0]), row(|g| [0.0, g.y]), row(|g| [g.y, g.x])]
}

const STRESSES: u32 = 3;
const STRAINS: u32 = 4;
const AT_NODES: u32 = 11;
/// First response of a single point: stresses and then strains.
const SINGLE_POINT: u32 = 20;
const STRESS_NAMES: [&str; 3] = ["sigma11", "sigma22", "sigma12"];

impl Element for PlaneElastic {
    fn class(&self) -> &'static str {
        self.class
    }
    fn dofs(&self) -> usize {
        self.dofs
    }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: true, symmetric: true, viscous: false, elapses: false, rayleigh: true }
    }

    fn respond(
        &self,
        m: &ElementInput<'_>,
        _: &[f64],
        _: &mut [f64],
        output: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        output.force.copy_from_slice(&self.load_force);
        for (rows, volume) in &self.points {
            add_point_force(rows, &self.elasticity, *volume, m.disp, output.force);
        }
        if let Some(k) = output.tangent {
            axpy(1.0, &self.stiffness, k);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        axpy(1.0, &self.stiffness, tangent);
    }
    fn mass(&self) -> Mass {
        self.mass.clone()
    }
    fn opensees(&self) -> OpenSeesTraits<'_> {
        OpenSeesTraits { ground_inertia: (self.mass != Mass::None).then_some(1.0), ..OpenSeesTraits::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let count = self.points.len();
        let all = |count: usize, names: [&'static str; 3]| (0..count).flat_map(move |_| names);
        Some(match words {
            ["stress" | "stresses", ..] => Probe::new(STRESSES, all(count, STRESS_NAMES)),
            ["strain" | "strains", ..] => Probe::new(STRAINS, all(count, ["eta11", "eta22", "eta12"])),
            ["stressAtNodes" | "stressesAtNodes", ..] if !self.extrapolation.is_empty() => {
                Probe::new(AT_NODES, all(self.extrapolation.len(), STRESS_NAMES))
            }
            ["material" | "integrPoint", point, what, ..] => {
                let point = point.parse::<u32>().ok().filter(|p| (1..=count as u32).contains(p))? - 1;
                match *what {
                    "stress" | "stresses" => Probe::new(SINGLE_POINT + 2 * point, STRESS_NAMES),
                    "strain" | "strains" => Probe::new(SINGLE_POINT + 2 * point + 1, ["eps11", "eps22", "eps12"]),
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["stresses", "strains", "stressesAtNodes", "material"]
    }

    fn force_labels(&self) -> Vec<String> {
        (1..=self.dofs / 2).flat_map(|node| [1, 2].map(|i| format!("P{i}_{node}"))).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let at = |point: usize, stress: bool| strain_or_stress(&self.points[point].0, &self.elasticity, stress, s.disp);
        match path[0] {
            kind @ (STRESSES | STRAINS) => {
                let points = out.chunks_exact_mut(3).enumerate();
                points.for_each(|(point, out)| out.copy_from_slice(&at(point, kind == STRESSES)));
            }
            AT_NODES => {
                for (shares, out) in self.extrapolation.iter().zip(out.chunks_exact_mut(3)) {
                    out.fill(0.0);
                    shares.iter().enumerate().for_each(|(point, share)| axpy(*share, &at(point, true), out));
                }
            }
            kind => {
                out.copy_from_slice(&at(((kind - SINGLE_POINT) / 2) as usize, (kind - SINGLE_POINT).is_multiple_of(2)))
            }
        }
    }
}
