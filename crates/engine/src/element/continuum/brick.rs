//! The eight-node bricks `stdBrick` and `bbarBrick`.

use super::{Body, Continuum, ElementResult, Mass, Rows, least_distance};
use crate::element::{Class, ElementError};
use crate::material::{SOLID, SharedMultiaxial};
use nalgebra::{Matrix3, Vector3};

pub(super) const NODES: usize = 8;
pub(super) const DOFS: usize = 3 * NODES;

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
pub(super) fn strain_rows<const D: usize>(derivatives: &[Vector3<f64>]) -> Rows<SOLID, D> {
    let mut rows = [[0.0; D]; SOLID];
    for (node, d) in derivatives.iter().enumerate() {
        let [x, y, z] = [3 * node, 3 * node + 1, 3 * node + 2];
        (rows[0][x], rows[1][y], rows[2][z]) = (d.x, d.y, d.z);
        (rows[3][x], rows[3][y], rows[4][y], rows[4][z], rows[5][x], rows[5][z]) = (d.y, d.x, d.z, d.y, d.z, d.x);
    }
    rows
}

impl Continuum<SOLID, DOFS> {
    /// Makes a trilinear isoparametric brick with 2 x 2 x 2 Gauss points (Zienkiewicz and Taylor, 2000, section 8.12). The
    /// first four corners go against the clock, seen from the other four.
    ///
    /// # Errors
    /// The corners do not make a brick.
    pub fn brick(
        corners: &[Vector3<f64>; NODES],
        law: &SharedMultiaxial<SOLID>,
        options: &BrickOptions,
    ) -> ElementResult<Self> {
        let rho = law.density();
        let mut body = Body {
            class: if options.mean_dilatation { Class::new("BbarBrick", 57) } else { Class::new("Brick", 56) },
            points: vec![],
            stabilisation: vec![],
            load_force: [0.0; DOFS],
            mass: Mass::None,
            size: least_distance(&corners.map(|x| [x.x, x.y, x.z])),
            extrapolation: vec![],
        };
        let (mut lumped, mut consistent) = (vec![0.0; DOFS], vec![0.0; DOFS * DOFS]);
        let gauss = gauss_points(corners);
        let mean = options.mean_dilatation.then(|| mean_derivatives(&gauss));
        for (n, d, volume) in gauss {
            if volume.is_nan() || volume == 0.0 {
                return Err(ElementError("the corners do not make a brick".into()));
            }
            let mut rows: Rows<SOLID, DOFS> = strain_rows(&d);
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
                    body.load_force[dof] -= volume * n * b;
                    lumped[dof] += volume * n * rho;
                }
            }
            for i in 0..DOFS {
                for j in (i % 3..DOFS).step_by(3) {
                    consistent[i * DOFS + j] += volume * rho * n[i / 3] * n[j / 3];
                }
            }
            body.points.push((rows, volume));
        }
        if rho != 0.0 {
            body.mass = if options.lumped { Mass::Lumped(lumped) } else { Mass::Consistent(consistent) };
        }
        Ok(Self::of(body, law))
    }
}
