//! The four-node quadrilateral of plane elasticity: `quad`.

use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, Snapshot, dot};
use crate::numeric::axpy;
use crate::probe::Probe;

/// Isotropic linear elasticity (`nDMaterial ElasticIsotropic`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    /// Modulus of elasticity, stress.
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Mass per volume.
    pub rho: f64,
}

/// What does not vary across a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// No strain across it.
    Strain,
    /// No stress across it.
    Stress,
}

impl Isotropic {
    /// Stresses xx, yy, xy per strain xx, yy and shear angle.
    pub fn plane(&self, plane: Plane) -> [[f64; 3]; 3] {
        let (e, nu) = (self.e, self.nu);
        // Plane strain is plane stress of a material with other constants (Timoshenko and Goodier, 1970, section 17).
        let (e, nu) = match plane {
            Plane::Stress => (e, nu),
            Plane::Strain => (e / (1.0 - nu * nu), nu / (1.0 - nu)),
        };
        let d = e / (1.0 - nu * nu);
        [[d, d * nu, 0.0], [d * nu, d, 0.0], [0.0, 0.0, 0.5 * e / (1.0 + nu)]]
    }
}

/// What a quadrilateral has besides its corners and its material.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuadOptions {
    /// Thickness.
    pub thickness: f64,
    /// Pressure on all sides, force per length of side.
    pub pressure: f64,
    /// Mass per volume.
    pub rho: f64,
    /// Force per volume along x and y.
    pub body: [f64; 2],
}

/// A bilinear isoparametric quadrilateral with 2 x 2 points of Gauss (Zienkiewicz and Taylor, 2000, section 8.3). Pressure and
/// body forces act from the beginning, whatever the load patterns do. The mass is lumped.
#[derive(Clone, Debug)]
pub struct Quad {
    stiffness: Vec<f64>,
    /// Resisting force without displacements: that of pressure and body forces.
    at_rest: [f64; 8],
    mass: [f64; 8],
    elasticity: [[f64; 3]; 3],
    points: [Rows; 4],
    /// Volumes that go with the points.
    volumes: [f64; 4],
}

/// Strains xx, yy and the shear angle per displacement of the corners.
type Rows = [[f64; 8]; 3];

/// Corners and points of Gauss, against the clock.
const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Shape functions and their derivatives along x and y at a place in the unit square, and the area per area there.
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
    /// From its corners against the clock.
    ///
    /// # Errors
    /// The corners go round with the clock, or make no convex quadrilateral.
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
            at_rest: [0.0; 8],
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
                    made.at_rest[dof] -= volume * n * b;
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
                made.at_rest[2 * node] -= half[1];
                made.at_rest[2 * node + 1] += half[0];
            }
        }
        Ok(made)
    }

    /// Strains, or stresses, of a point.
    fn at(&self, point: usize, stress: bool, disp: &[f64]) -> [f64; 3] {
        let strain = self.points[point].each_ref().map(|row| dot(row, disp));
        if stress { self.elasticity.each_ref().map(|row| dot(row, &strain)) } else { strain }
    }
}

const STRESSES: u32 = 3;
const STRAINS: u32 = 4;
const AT_NODES: u32 = 11;
/// Of one point.
const POINT: u32 = 20;

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
        answer: ElementOutput<'_>,
    ) -> Result<(), ElementError> {
        answer.force.copy_from_slice(&self.at_rest);
        // Of stresses, not of stiffness times displacements, whose round-off would not be in equilibrium.
        for (point, (rows, volume)) in self.points.iter().zip(&self.volumes).enumerate() {
            for (row, stress) in rows.iter().zip(self.at(point, true, m.disp)) {
                axpy(volume * stress, row, answer.force);
            }
        }
        if let Some(k) = answer.tangent {
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

    fn ground_inertia_slip(&self) -> Option<f64> {
        (self.mass[0] != 0.0).then_some(1.0)
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
                    "stress" | "stresses" => Probe::new(POINT + point, STRESS_NAMES),
                    "strain" | "strains" => Probe::new(POINT + 4 + point, ["eps11", "eps22", "eps12"]),
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
                // The bilinear field through the points of Gauss, taken to the corners.
                let far = 3.0f64.sqrt();
                for (corner, out) in SIGNS.iter().zip(out.chunks_exact_mut(3)) {
                    out.fill(0.0);
                    for (point, [x, y]) in SIGNS.iter().enumerate() {
                        let share = 0.25 * (1.0 + far * x * corner[0]) * (1.0 + far * y * corner[1]);
                        axpy(share, &self.at(point, true, s.disp), out);
                    }
                }
            }
            kind => {
                let (point, stress) = if kind < POINT + 4 { (kind - POINT, true) } else { (kind - POINT - 4, false) };
                out.copy_from_slice(&self.at(point as usize, stress, s.disp));
            }
        }
    }
}
