//! The eight-node bricks of elasticity: `stdBrick` and `bbarBrick`.

use super::continuum::{add_point_force, strain_or_stress};
use super::damping::BasicForces;
use super::{Element, ElementError, ElementInput, ElementOutput, ElementTraits, Mass, OpenSeesTraits, Snapshot};
use crate::material::Isotropic;
use crate::numeric::axpy;
use crate::probe::Probe;
use nalgebra::{Matrix3, Vector3};

pub(super) const NODES: usize = 8;
pub(super) const DOFS: usize = 3 * NODES;
pub(super) const STRESSES: usize = 6;

/// Derivatives of the strains 11, 22, 33, 12, 23, 31 by the displacements of the corners; shears are angles.
pub(super) type Rows = [[f64; DOFS]; STRESSES];

/// Natural coordinates of the corners.
pub(super) const SIGNS: [[f64; 3]; NODES] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Options of a brick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BrickOptions {
    /// Force per volume along the axes; it acts from the start, independent of load patterns.
    pub body: [f64; 3],
    /// The mass is lumped at the corners.
    pub lumped: bool,
    /// The dilatation is constant: its derivatives are those of the mean over the volume (Hughes, 1980).
    pub mean_dilatation: bool,
}

/// A trilinear isoparametric brick with 2 x 2 x 2 Gauss points (Zienkiewicz and Taylor, 2000, section 8.12).
#[derive(Clone, Debug)]
pub struct Brick {
    stiffness: Vec<f64>,
    load_force: [f64; DOFS],
    mass: Mass,
    elasticity: [[f64; STRESSES]; STRESSES],
    points: Vec<(Rows, f64)>,
    class: &'static str,
    inverted: bool,
}

/// Values of the shape functions, their derivatives by the axes, and the Jacobian determinant.
pub(super) type Shape = ([f64; NODES], [Vector3<f64>; NODES], f64);

/// Shape functions at natural coordinates.
fn shape(corners: &[Vector3<f64>; NODES], at: [f64; 3]) -> Shape {
    let factor = |s: &[f64; 3], d: usize| 1.0 + s[d] * at[d];
    let values = SIGNS.map(|s| 0.125 * factor(&s, 0) * factor(&s, 1) * factor(&s, 2));
    let local = SIGNS.map(|s| {
        0.125
            * Vector3::new(
                s[0] * factor(&s, 1) * factor(&s, 2),
                s[1] * factor(&s, 0) * factor(&s, 2),
                s[2] * factor(&s, 0) * factor(&s, 1),
            )
    });
    let jacobian: Matrix3<f64> = local.iter().zip(corners).map(|(d, x)| d * x.transpose()).sum();
    let inverse = jacobian.try_inverse().unwrap_or_else(Matrix3::zeros);
    (values, local.map(|d| inverse * d), jacobian.determinant())
}

/// Means over the volume of the derivatives of the shape functions.
pub(super) fn mean_derivatives(gauss: &[Shape; NODES]) -> [Vector3<f64>; NODES] {
    let volume: f64 = gauss.iter().map(|(.., v)| v).sum();
    std::array::from_fn(|node| gauss.iter().map(|(_, d, v)| *v * d[node]).sum::<Vector3<f64>>() / volume)
}

/// Shapes at the 2 x 2 x 2 Gauss points.
pub(super) fn gauss_points(corners: &[Vector3<f64>; NODES]) -> [Shape; NODES] {
    let root = 3.0f64.sqrt().recip();
    std::array::from_fn(|at| {
        let sign = |bit: usize| if at >> bit & 1 == 1 { root } else { -root };
        shape(corners, [sign(2), sign(1), sign(0)])
    })
}

/// Derivatives of the strains by the displacements, from those of the shape functions.
pub(super) fn strain_rows(derivatives: &[Vector3<f64>; NODES]) -> Rows {
    let mut rows = [[0.0; DOFS]; STRESSES];
    for (node, d) in derivatives.iter().enumerate() {
        let [x, y, z] = [3 * node, 3 * node + 1, 3 * node + 2];
        (rows[0][x], rows[1][y], rows[2][z]) = (d.x, d.y, d.z);
        (rows[3][x], rows[3][y], rows[4][y], rows[4][z], rows[5][x], rows[5][z]) = (d.y, d.x, d.z, d.y, d.z, d.x);
    }
    rows
}

/// Stresses for unit strains.
pub(super) fn elasticity(material: &Isotropic) -> [[f64; STRESSES]; STRESSES] {
    let (shear, bulk) = (0.5 * material.e / (1.0 + material.nu), material.e / 3.0 / (1.0 - 2.0 * material.nu));
    let mut elasticity = [[0.0; STRESSES]; STRESSES];
    for (i, row) in elasticity.iter_mut().enumerate() {
        if i < 3 {
            row[..3].fill(bulk - 2.0 / 3.0 * shear);
            row[i] += 2.0 * shear;
        } else {
            row[i] = shear;
        }
    }
    elasticity
}

impl Brick {
    /// Makes a brick of its corners: the first four against the clock, seen from the other four.
    ///
    /// # Errors
    /// The corners do not make a convex brick of positive volume.
    pub fn new(
        corners: &[Vector3<f64>; NODES],
        material: &Isotropic,
        options: &BrickOptions,
    ) -> Result<Self, ElementError> {
        let elasticity = elasticity(material);
        let mut made = Self {
            stiffness: vec![0.0; DOFS * DOFS],
            load_force: [0.0; DOFS],
            mass: Mass::None,
            elasticity,
            points: vec![],
            class: if options.mean_dilatation { "BbarBrick" } else { "Brick" },
            inverted: false,
        };
        let (mut lumped, mut consistent) = (vec![0.0; DOFS], vec![0.0; DOFS * DOFS]);
        let gauss = gauss_points(corners);
        let mean = options.mean_dilatation.then(|| mean_derivatives(&gauss));
        for (n, d, volume) in gauss {
            if volume.is_nan() || volume == 0.0 {
                return Err(ElementError("the corners do not make a brick".into()));
            }
            made.inverted |= volume < 0.0;
            let mut rows = strain_rows(&d);
            for (node, d) in d.iter().enumerate() {
                let [x, y, z] = [3 * node, 3 * node + 1, 3 * node + 2];
                let Some(mean) = &mean else { continue };
                let change = (mean[node] - d) / 3.0;
                for (dof, change) in [x, y, z].into_iter().zip([change.x, change.y, change.z]) {
                    rows[..3].iter_mut().for_each(|row| row[dof] += change);
                }
            }
            for (node, n) in n.iter().enumerate() {
                let [x, y, z] = [3 * node, 3 * node + 1, 3 * node + 2];
                for (dof, b) in [x, y, z].into_iter().zip(options.body) {
                    made.load_force[dof] -= volume * n * b;
                    lumped[dof] += volume * n * material.rho;
                }
            }
            for i in 0..DOFS {
                for j in (i % 3..DOFS).step_by(3) {
                    consistent[i * DOFS + j] += volume * material.rho * n[i / 3] * n[j / 3];
                }
            }
            for (a, d) in rows.iter().zip(&made.elasticity) {
                for (b, d) in rows.iter().zip(d).filter(|(_, d)| **d != 0.0) {
                    for (i, a) in a.iter().enumerate() {
                        axpy(volume * d * a, b, &mut made.stiffness[DOFS * i..DOFS * (i + 1)]);
                    }
                }
            }
            made.points.push((rows, volume));
        }
        if material.rho != 0.0 {
            made.mass = if options.lumped { Mass::Lumped(lumped) } else { Mass::Consistent(consistent) };
        }
        Ok(made)
    }

    /// Returns true if the volume at a Gauss point is negative: the corners go round the other way or are not convex.
    /// Stiffness and mass are then negative there.
    pub fn is_inverted(&self) -> bool {
        self.inverted
    }

    /// Strains or stresses of a Gauss point.
    fn at(&self, rows: &Rows, stress: bool, disp: &[f64]) -> [f64; STRESSES] {
        strain_or_stress(rows, &self.elasticity, stress, disp)
    }
}

const ALL_STRESSES: u32 = 3;
const ALL_STRAINS: u32 = 4;
/// First response of a single Gauss point: stresses and then strains.
const SINGLE_POINT: u32 = 20;
pub(super) const STRESS_NAMES: [&str; STRESSES] = ["sigma11", "sigma22", "sigma33", "sigma12", "sigma23", "sigma13"];
pub(super) const STRAIN_NAMES: [&str; STRESSES] = ["eps11", "eps22", "eps33", "eps12", "eps23", "eps13"];

impl Element for Brick {
    fn class(&self) -> &'static str {
        self.class
    }
    fn dofs(&self) -> usize {
        DOFS
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

    fn basic_forces(&self) -> Option<&dyn BasicForces> {
        Some(self)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let all = |names: [&'static str; STRESSES]| (0..NODES).flat_map(move |_| names);
        Some(match words {
            ["stress" | "stresses", ..] => Probe::new(ALL_STRESSES, all(STRESS_NAMES)),
            ["strain" | "strains", ..] => Probe::new(ALL_STRAINS, all(STRAIN_NAMES)),
            ["material" | "integrPoint", point, what, ..] => {
                let point = point.parse::<u32>().ok().filter(|p| (1..=NODES as u32).contains(p))? - 1;
                match *what {
                    "stress" | "stresses" => Probe::new(SINGLE_POINT + 2 * point, STRESS_NAMES),
                    "strain" | "strains" => Probe::new(SINGLE_POINT + 2 * point + 1, STRAIN_NAMES),
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &["stresses", "strains", "material"]
    }

    fn force_labels(&self) -> Vec<String> {
        (1..=NODES).flat_map(|node| [1, 2, 3].map(|i| format!("P{i}_{node}"))).collect()
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        match path[0] {
            kind @ (ALL_STRESSES | ALL_STRAINS) => {
                for ((rows, _), out) in self.points.iter().zip(out.chunks_exact_mut(STRESSES)) {
                    out.copy_from_slice(&self.at(rows, kind == ALL_STRESSES, s.disp));
                }
            }
            kind => {
                let (point, stress) = ((kind - SINGLE_POINT) / 2, (kind - SINGLE_POINT).is_multiple_of(2));
                out.copy_from_slice(&self.at(&self.points[point as usize].0, stress, s.disp));
            }
        }
    }
}

impl BasicForces for Brick {
    fn len(&self) -> usize {
        NODES * STRESSES
    }
    fn in_resisting_force(&self) -> bool {
        true
    }
    fn basic_forces(&self, disp: &[f64], _: &[f64], _: &[f64], out: &mut [f64]) {
        for (point, q) in out.chunks_exact_mut(STRESSES).enumerate() {
            q.copy_from_slice(&self.at(&self.points[point].0, true, disp));
        }
    }
    fn add_global(&self, _: &[f64], _: &[f64], q: &[f64], force: &mut [f64]) {
        for ((rows, volume), q) in self.points.iter().map(|(rows, volume)| (rows, volume)).zip(q.chunks_exact(STRESSES))
        {
            for (row, q) in rows.iter().zip(q) {
                axpy(volume * q, row, force);
            }
        }
    }
    fn scale_stiffness(&self, _: &[f64], _: &[f64], factor: f64, tangent: &mut [f64]) {
        tangent.iter_mut().for_each(|k| *k *= 1.0 + factor);
    }
}
