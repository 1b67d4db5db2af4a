//! Plane elements with one point of integration: the stabilised quadrilateral `SSPquad` and the triangle `tri31`.

use super::continuum::{add_point_force, strain_or_stress};
use super::quad::QuadOptions;
use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, OpenSeesTraits, Snapshot, dot};
use crate::material::{Isotropic, Plane};
use crate::numeric::axpy;
use crate::probe::Probe;

/// An element of plane elasticity whose strain is constant, with lumped mass. Pressure and body forces act from the
/// start, independent of load patterns.
#[derive(Clone, Debug)]
pub struct ConstantStrain {
    class: &'static str,
    stiffness: Vec<f64>,
    /// Stiffness against hourglass modes; empty without them.
    stabilisation: Vec<f64>,
    /// Resisting force at zero displacement.
    load_force: Vec<f64>,
    mass: Vec<f64>,
    elasticity: [[f64; 3]; 3],
    /// Derivatives of the strains xx, yy and the shear angle by the displacements.
    rows: [Vec<f64>; 3],
    volume: f64,
}

/// Derivatives by x and y of the shape functions of the nodes, and the volume that belongs to each node.
struct Shape {
    gradients: Vec<[f64; 2]>,
    volumes: Vec<f64>,
}

impl ConstantStrain {
    fn of(
        class: &'static str,
        shape: &Shape,
        stabilisation: Vec<f64>,
        (material, plane): (&Isotropic, Plane),
        options: &QuadOptions,
    ) -> Self {
        let n = 2 * shape.gradients.len();
        let volume: f64 = shape.volumes.iter().sum();
        let mut rows = [const { vec![] }; 3].map(|_: Vec<f64>| vec![0.0; n]);
        for (node, [dx, dy]) in shape.gradients.iter().enumerate() {
            let [x, y] = [2 * node, 2 * node + 1];
            (rows[0][x], rows[1][y], rows[2][x], rows[2][y]) = (*dx, *dy, *dy, *dx);
        }
        let elasticity = material.plane(plane);
        let mut stiffness = if stabilisation.is_empty() { vec![0.0; n * n] } else { stabilisation.clone() };
        for (a, d) in rows.iter().zip(&elasticity) {
            for (b, d) in rows.iter().zip(d) {
                for (i, a) in a.iter().enumerate() {
                    axpy(volume * d * a, b, &mut stiffness[n * i..n * (i + 1)]);
                }
            }
        }
        let rho = if options.rho == 0.0 { material.rho } else { options.rho };
        let by_dof = |f: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..n).map(|i| f(i) * shape.volumes[i / 2]).collect() };
        let load_force = by_dof(&|i| -options.body[i % 2]);
        let mass = by_dof(&|_| rho);
        Self { class, stiffness, stabilisation, load_force, mass, elasticity, rows, volume }
    }

    /// A quadrilateral with one point and a physical stabilisation of its hourglass modes (McGann, Arduino and
    /// Mackenzie-Helnwein, 2012), of its corners counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn stabilised_quad(
        corners: &[[f64; 2]; 4],
        (material, plane): (&Isotropic, Plane),
        options: &QuadOptions,
    ) -> Result<Self, ElementError> {
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
        let c = material.plane(plane);
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
        let shape = Shape { gradients, volumes };
        Ok(Self::of("SSPquad", &shape, stabilisation, (material, plane), options))
    }

    /// A triangle of its corners, counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise.
    pub fn triangle(
        corners: &[[f64; 2]; 3],
        (material, plane): (&Isotropic, Plane),
        options: &QuadOptions,
    ) -> Result<Self, ElementError> {
        let side = |i: usize| [0, 1].map(|d| corners[(i + 2) % 3][d] - corners[(i + 1) % 3][d]);
        let area = 0.5 * (side(0)[0] * side(1)[1] - side(0)[1] * side(1)[0]);
        if area <= 0.0 {
            return Err(ElementError("the corners do not make a triangle against the clock".into()));
        }
        let gradients = (0..3).map(|i| [-side(i)[1] / (2.0 * area), side(i)[0] / (2.0 * area)]).collect();
        let volumes = vec![options.thickness * area / 3.0; 3];
        let mut made = Self::of("Tri31", &Shape { gradients, volumes }, vec![], (material, plane), options);
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let half = [0, 1].map(|d| 0.5 * options.pressure * (corners[j][d] - corners[i][d]));
            for node in [i, j] {
                made.load_force[2 * node] -= half[1];
                made.load_force[2 * node + 1] += half[0];
            }
        }
        Ok(made)
    }

    /// Strains or stresses xx, yy, xy.
    fn at(&self, stress: bool, disp: &[f64]) -> [f64; 3] {
        strain_or_stress(&self.rows, &self.elasticity, stress, disp)
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

const STRESSES: u32 = 3;
const STRAINS: u32 = 4;

impl Element for ConstantStrain {
    fn class(&self) -> &'static str {
        self.class
    }
    fn dofs(&self) -> usize {
        self.mass.len()
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
        add_point_force(&self.rows, &self.elasticity, self.volume, m.disp, output.force);
        for (force, row) in output.force.iter_mut().zip(self.stabilisation.chunks_exact(self.dofs())) {
            *force += dot(row, m.disp);
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
        if self.mass.iter().all(|m| *m == 0.0) { Mass::None } else { Mass::Lumped(self.mass.clone()) }
    }

    fn opensees(&self) -> OpenSeesTraits<'_> {
        OpenSeesTraits { ground_inertia: (self.mass[0] != 0.0).then_some(1.0), ..OpenSeesTraits::default() }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let inner = match words {
            ["material" | "integrPoint", "1", what, ..] => *what,
            [what, ..] => *what,
            [] => return None,
        };
        match inner {
            "stress" | "stresses" => Some(Probe::new(STRESSES, ["sigma11", "sigma22", "sigma12"])),
            "strain" | "strains" => Some(Probe::new(STRAINS, ["eta11", "eta22", "eta12"])),
            _ => None,
        }
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["stress", "strain", "material"]
    }

    fn force_labels(&self) -> Vec<String> {
        (1..=self.dofs() / 2).flat_map(|node| [1, 2].map(|i| format!("P{i}_{node}"))).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        out.copy_from_slice(&self.at(path[0] == STRESSES, s.disp));
    }
}
