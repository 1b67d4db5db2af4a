//! The four-node quadrilateral of plane elasticity: `quad`.

use super::continuum::{add_point_force, strain_or_stress};
use super::damping::BasicForces;
use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, OpenSeesTraits, Snapshot};
use crate::material::{Isotropic, Plane};
use crate::numeric::axpy;
use crate::probe::Probe;

/// Properties of a quadrilateral.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuadOptions {
    /// Thickness.
    pub thickness: f64,
    /// Pressure on all sides, force/length.
    pub pressure: f64,
    /// Density, mass/volume; 0 for that of the material.
    pub rho: f64,
    /// Force per volume along x and y.
    pub body: [f64; 2],
}

/// A bilinear isoparametric quadrilateral with 2 x 2 Gauss points and lumped mass (Zienkiewicz and Taylor, 2000,
/// section 8.3). Pressure and body forces act from the start, independent of load patterns.
#[derive(Clone, Debug)]
pub struct Quad {
    stiffness: Vec<f64>,
    /// Resisting force at zero displacement, from pressure and body forces.
    load_force: [f64; 8],
    mass: [f64; 8],
    elasticity: [[f64; 3]; 3],
    points: [Rows; 4],
    /// Volume of each Gauss point.
    volumes: [f64; 4],
}

/// Derivatives of the strains xx, yy and the shear angle by the displacements of the corners.
type Rows = [[f64; 8]; 3];

/// Natural coordinates of the corners, counterclockwise. Gauss points are at 1/√3 of them.
pub(super) const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Shape functions, their derivatives by x and y, and the Jacobian determinant at natural coordinates `at`.
fn shape(corners: &[[f64; 2]; 4], at: [f64; 2]) -> ([f64; 4], [[f64; 2]; 4], f64) {
    let n = SIGNS.map(|[x, y]| 0.25 * (1.0 + x * at[0]) * (1.0 + y * at[1]));
    let local = SIGNS.map(|[x, y]| [0.25 * x * (1.0 + y * at[1]), 0.25 * y * (1.0 + x * at[0])]);
    let mut j = [[0.0; 2]; 2];
    for (d, c) in local.iter().zip(corners) {
        for (row, d) in j.iter_mut().zip(d) {
            axpy(*d, c, row);
        }
    }
    let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    let global = local.map(|[a, b]| [(j[1][1] * a - j[0][1] * b) / det, (j[0][0] * b - j[1][0] * a) / det]);
    (n, global, det)
}

impl Quad {
    /// Makes an element of its corners, counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn new(
        corners: &[[f64; 2]; 4],
        material: &Isotropic,
        plane: Plane,
        options: &QuadOptions,
    ) -> Result<Self, ElementError> {
        if SIGNS.iter().any(|at| shape(corners, *at).2 <= 0.0) {
            return Err(ElementError("the corners do not make a convex quadrilateral against the clock".into()));
        }
        let mut made = Self {
            stiffness: vec![0.0; 64],
            load_force: [0.0; 8],
            mass: [0.0; 8],
            elasticity: material.plane(plane),
            points: [[[0.0; 8]; 3]; 4],
            volumes: [0.0; 4],
        };
        let rho = if options.rho == 0.0 { material.rho } else { options.rho };
        for ((sign, rows), at) in SIGNS.iter().zip(&mut made.points).zip(&mut made.volumes) {
            let (n, d, det) = shape(corners, sign.map(|s| s / 3.0f64.sqrt()));
            let volume = det * options.thickness;
            *at = volume;
            for (node, (n, [dx, dy])) in n.iter().zip(d).enumerate() {
                let [x, y] = [2 * node, 2 * node + 1];
                (rows[0][x], rows[1][y], rows[2][x], rows[2][y]) = (dx, dy, dy, dx);
                for (dof, b) in [x, y].into_iter().zip(options.body) {
                    made.load_force[dof] -= volume * n * b;
                    made.mass[dof] += volume * n * rho;
                }
            }
            for (a, d) in rows.iter().zip(&made.elasticity) {
                for (b, d) in rows.iter().zip(d) {
                    for (i, a) in a.iter().enumerate() {
                        axpy(volume * d * a, b, &mut made.stiffness[8 * i..8 * i + 8]);
                    }
                }
            }
        }
        for (i, j) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
            let half = [0, 1].map(|d| 0.5 * options.pressure * (corners[j][d] - corners[i][d]));
            for node in [i, j] {
                made.load_force[2 * node] -= half[1];
                made.load_force[2 * node + 1] += half[0];
            }
        }
        Ok(made)
    }

    /// Strains or stresses xx, yy, xy of a Gauss point.
    fn at(&self, point: usize, stress: bool, disp: &[f64]) -> [f64; 3] {
        strain_or_stress(&self.points[point], &self.elasticity, stress, disp)
    }
}

const STRESSES: u32 = 3;
const STRAINS: u32 = 4;
const AT_NODES: u32 = 11;
/// First response of a single Gauss point.
const SINGLE_POINT: u32 = 20;

const STRESS_NAMES: [&str; 3] = ["sigma11", "sigma22", "sigma12"];
const STRAIN_NAMES: [&str; 3] = ["eta11", "eta22", "eta12"];

impl Element for Quad {
    fn class(&self) -> &'static str {
        "FourNodeQuad"
    }
    fn dofs(&self) -> usize {
        8
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
        for (rows, volume) in self.points.iter().zip(&self.volumes) {
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
        if self.mass.iter().all(|m| *m == 0.0) { Mass::None } else { Mass::Lumped(self.mass.to_vec()) }
    }

    fn opensees(&self) -> OpenSeesTraits<'_> {
        OpenSeesTraits { ground_inertia: (self.mass[0] != 0.0).then_some(1.0), ..OpenSeesTraits::default() }
    }

    fn basic_forces(&self) -> Option<&dyn BasicForces> {
        Some(self)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let all = |names: [&'static str; 3]| (0..4).flat_map(move |_| names);
        Some(match words {
            ["stress" | "stresses", ..] => Probe::new(STRESSES, all(STRESS_NAMES)),
            ["strain" | "strains", ..] => Probe::new(STRAINS, all(STRAIN_NAMES)),
            ["stressAtNodes" | "stressesAtNodes", ..] => Probe::new(AT_NODES, all(STRESS_NAMES)),
            ["material" | "integrPoint", point, what, ..] => {
                let point = point.parse::<u32>().ok().filter(|p| (1..=4).contains(p))? - 1;
                match *what {
                    "stress" | "stresses" => Probe::new(SINGLE_POINT + point, STRESS_NAMES),
                    "strain" | "strains" => Probe::new(SINGLE_POINT + 4 + point, ["eps11", "eps22", "eps12"]),
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
        (1..=4).flat_map(|node| [1, 2].map(|i| format!("P{i}_{node}"))).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            kind @ (STRESSES | STRAINS) => {
                for (point, out) in out.chunks_exact_mut(3).enumerate() {
                    out.copy_from_slice(&self.at(point, kind == STRESSES, s.disp));
                }
            }
            AT_NODES => {
                // Extrapolate the bilinear field of the Gauss points to the corners.
                let extrapolation = 3.0f64.sqrt();
                for (corner, out) in SIGNS.iter().zip(out.chunks_exact_mut(3)) {
                    out.fill(0.0);
                    for (point, [x, y]) in SIGNS.iter().enumerate() {
                        let share =
                            0.25 * (1.0 + extrapolation * x * corner[0]) * (1.0 + extrapolation * y * corner[1]);
                        axpy(share, &self.at(point, true, s.disp), out);
                    }
                }
            }
            kind => {
                let (point, stress) = if kind < SINGLE_POINT + 4 {
                    (kind - SINGLE_POINT, true)
                } else {
                    (kind - SINGLE_POINT - 4, false)
                };
                out.copy_from_slice(&self.at(point as usize, stress, s.disp));
            }
        }
    }
}

impl BasicForces for Quad {
    fn len(&self) -> usize {
        4 * 3
    }
    fn in_resisting_force(&self) -> bool {
        true
    }
    fn basic_forces(&self, disp: &[f64], _: &[f64], _: &[f64], out: &mut [f64]) {
        for (point, q) in out.chunks_exact_mut(3).enumerate() {
            q.copy_from_slice(&self.at(point, true, disp));
        }
    }
    fn add_global(&self, _: &[f64], _: &[f64], q: &[f64], force: &mut [f64]) {
        for ((rows, volume), q) in self.points.iter().zip(&self.volumes).zip(q.chunks_exact(3)) {
            for (row, q) in rows.iter().zip(q) {
                axpy(volume * q, row, force);
            }
        }
    }
    fn scale_stiffness(&self, _: &[f64], _: &[f64], factor: f64, tangent: &mut [f64]) {
        tangent.iter_mut().for_each(|k| *k *= 1.0 + factor);
    }
}
