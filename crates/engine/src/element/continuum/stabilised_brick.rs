//! The eight-node brick with one point of integration and stabilised hourglass modes: `SSPbrick`.

use super::brick::{DOFS, NODES, SIGNS, gauss_points, mean_derivatives, strain_rows};
use super::{Body, Continuum, ElementResult, Mass, least_distance};
use crate::element::{Class, ElementError};
use crate::material::{SOLID, SharedMultiaxial};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Powers of the natural coordinates.
type Powers = [usize; 3];
/// Terms of the gradient of a mode: powers, and the natural axis whose gradient they multiply.
type Field = &'static [(Powers, usize)];

/// Enhanced modes, one along each natural axis.
const ENHANCED: [Field; 3] = [&[([1, 0, 0], 0)], &[([0, 1, 0], 1)], &[([0, 0, 1], 2)]];
/// Hourglass modes st, tu, su and stu.
const HOURGLASS: [Field; 4] = [
    &[([0, 1, 0], 0), ([1, 0, 0], 1)],
    &[([0, 0, 1], 1), ([0, 1, 0], 2)],
    &[([0, 0, 1], 0), ([1, 0, 0], 2)],
    &[([0, 1, 1], 0), ([1, 0, 1], 1), ([1, 1, 0], 2)],
];
/// The last hourglass mode, which meets shear alone.
const WARPING: usize = 3;

/// Values of a hourglass mode at the corners over the number of corners.
fn mode(mode: usize) -> [f64; NODES] {
    let [s, t, u]: [usize; 3] = [[1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1]][mode];
    let power = |x: f64, p: usize| if p == 1 { x } else { 1.0 };
    SIGNS.map(|c| 0.125 * power(c[0], s) * power(c[1], t) * power(c[2], u))
}

/// Coefficients of the Jacobian determinant, in the order of the paper. Those that are linear in one coordinate are
/// left out, as in OpenSees.
fn determinant(e: [Vector3<f64>; 7]) -> [f64; 20] {
    let [e1, e2, e3, e4, e5, e6, e7] = e;
    let triple = |a: Vector3<f64>, b: Vector3<f64>, c: Vector3<f64>| a.dot(&b.cross(&c));
    [
        triple(e1, e2, e3),
        0.0,
        0.0,
        0.0,
        triple(e7, e2, e3) + triple(e4, e5, e2) + triple(e4, e3, e6),
        triple(e1, e7, e3) + triple(e4, e5, e1) + triple(e3, e5, e6),
        triple(e1, e2, e7) + triple(e4, e1, e6) + triple(e2, e5, e6),
        -triple(e1, e5, e6),
        -triple(e4, e2, e6),
        -triple(e4, e5, e3),
        triple(e2, e4, e7),
        -triple(e3, e4, e7),
        triple(e3, e5, e7),
        -triple(e1, e5, e7),
        triple(e1, e6, e7),
        -triple(e2, e6, e7),
        2.0 * triple(e4, e5, e6),
        triple(e7, e5, e6),
        triple(e4, e7, e6),
        triple(e4, e5, e7),
    ]
}

/// Integral over the volume of a product of natural coordinates.
fn moment(j: &[f64; 20], powers: Powers) -> f64 {
    let second = |a: usize, b: usize, c: usize| 8.0 * (j[0] / 3.0 + j[a] / 5.0 + j[b] / 9.0 + j[c] / 9.0);
    let mixed = |a: usize, b: usize| 8.0 * (j[a] / 9.0 + j[b] / 27.0);
    let third = |a: usize, b: usize, c: usize| 8.0 * (j[a] / 9.0 + j[b] / 15.0 + j[c] / 27.0);
    let fourth = |a: usize, b: usize, c: usize| 8.0 * (j[0] / 9.0 + j[a] / 15.0 + j[b] / 15.0 + j[c] / 27.0);
    let skew = |a: usize, b: usize| 8.0 * (j[a] / 27.0 + 64.0 * j[b] / 45.0);
    match powers {
        [2, 0, 0] => second(7, 8, 9),
        [0, 2, 0] => second(8, 7, 9),
        [0, 0, 2] => second(9, 7, 8),
        [0, 1, 1] => mixed(4, 17),
        [1, 0, 1] => mixed(5, 18),
        [1, 1, 0] => mixed(6, 19),
        [1, 0, 2] => third(1, 12, 15),
        [1, 2, 0] => third(1, 15, 12),
        [0, 1, 2] => third(2, 11, 14),
        [2, 1, 0] => third(2, 14, 11),
        [0, 2, 1] => third(3, 10, 13),
        [2, 0, 1] => third(3, 13, 10),
        [2, 2, 0] => fourth(7, 8, 9),
        [0, 2, 2] => fourth(8, 9, 7),
        [2, 0, 2] => fourth(7, 9, 8),
        [2, 1, 1] => skew(4, 17),
        [1, 2, 1] => skew(5, 18),
        [1, 1, 2] => skew(6, 19),
        _ => 8.0 * j[16] / 27.0,
    }
}

/// Geometry and elasticity that the stiffness of modes is integrated with.
struct Integration {
    determinant: [f64; 20],
    /// Derivatives of the natural coordinates, by rows, by the axes.
    inverse: Matrix3<f64>,
    /// Stress along an axis for the strain along it and along another one, and for a shear.
    moduli: [f64; 3],
}

impl Integration {
    /// Stiffness of the displacements of one mode against those of another.
    fn block(&self, f: Field, g: Field, shear_only: bool) -> Matrix3<f64> {
        let mut h = Matrix3::zeros();
        for (m, a) in f {
            for (n, b) in g {
                let powers = [m[0] + n[0], m[1] + n[1], m[2] + n[2]];
                let (a, b) = (self.inverse.row(*a), self.inverse.row(*b));
                h += moment(&self.determinant, powers) * a.transpose() * b;
            }
        }
        let [mut along, mut across, shear] = self.moduli;
        if shear_only {
            (along, across) = (0.0, 0.0);
        }
        let mut k = across * h + shear * h.transpose();
        let trace = h.trace();
        (0..3).for_each(|i| k[(i, i)] = along * h[(i, i)] + shear * (trace - h[(i, i)]));
        k
    }

    /// Stiffness of all hourglass modes, condensed for the enhanced strains. `None` if these have none.
    fn hourglass(&self) -> Option<SMatrix<f64, 12, 12>> {
        let mut whole = SMatrix::<f64, 12, 12>::zeros();
        let mut coupling = SMatrix::<f64, 9, 12>::zeros();
        let mut enhanced = SMatrix::<f64, 9, 9>::zeros();
        for (n, g) in HOURGLASS.iter().enumerate() {
            for (m, f) in HOURGLASS.iter().enumerate() {
                let block = self.block(f, g, m == WARPING || n == WARPING);
                whole.fixed_view_mut::<3, 3>(3 * m, 3 * n).copy_from(&block);
            }
            for (m, f) in ENHANCED.iter().enumerate().filter(|_| n != WARPING) {
                coupling.fixed_view_mut::<3, 3>(3 * m, 3 * n).copy_from(&self.block(f, g, false));
            }
        }
        for (m, f) in ENHANCED.iter().enumerate() {
            for (n, g) in ENHANCED.iter().enumerate() {
                enhanced.fixed_view_mut::<3, 3>(3 * m, 3 * n).copy_from(&self.block(f, g, false));
            }
        }
        Some(whole - coupling.transpose() * enhanced.try_inverse()? * coupling)
    }
}

impl Continuum<SOLID, DOFS> {
    /// Makes a brick with one point and a physical stabilisation of its twelve hourglass modes. Their stiffness is integrated
    /// in closed form, and nine enhanced strains free them from locking (McGann, Arduino and Mackenzie-Helnwein, 2015; Puso,
    /// 2000). The first four corners go against the clock, seen from the other four; `body` is the force per volume along
    /// the axes.
    ///
    /// # Errors
    /// The corners do not make a brick of positive volume.
    pub fn stabilised_brick(
        corners: &[Vector3<f64>; NODES],
        law: &SharedMultiaxial<SOLID>,
        body: [f64; 3],
    ) -> ElementResult<Self> {
        let wrong = || ElementError("the corners do not make a brick of positive volume".into());
        let sum = |values: [f64; NODES]| -> Vector3<f64> { corners.iter().zip(values).map(|(x, v)| v * x).sum() };
        let axis = |a: usize| sum(SIGNS.map(|s| 0.125 * s[a]));
        let [e1, e2, e3] = [axis(0), axis(1), axis(2)];
        let modes: [Vector3<f64>; 4] = std::array::from_fn(|m| sum(mode(m)));
        let inverse = Matrix3::from_columns(&[e1, e2, e3]).try_inverse().ok_or_else(wrong)?;
        let gauss = gauss_points(corners);
        let volume: f64 = gauss.iter().map(|(.., v)| v).sum();
        if volume.is_nan() || volume <= 0.0 {
            return Err(wrong());
        }
        let mean = mean_derivatives(&gauss);
        let elasticity = law.initial_tangent();
        let integration = Integration {
            determinant: determinant([e1, e2, e3, modes[1], modes[2], modes[0], modes[3]]),
            inverse,
            moduli: [elasticity[0][0], elasticity[0][1], elasticity[3][3]],
        };
        let hourglass = integration.hourglass().ok_or_else(wrong)?;
        // Displacements of the modes from those of the corners, without their uniform strains.
        let mut projection = SMatrix::<f64, 12, DOFS>::zeros();
        for (m, place) in modes.iter().enumerate() {
            for (node, value) in mode(m).into_iter().enumerate() {
                let gamma = value - mean[node].dot(place);
                (0..3).for_each(|i| projection[(3 * m + i, 3 * node + i)] = gamma);
            }
        }
        let stabilisation = (projection.transpose() * hourglass * projection).as_slice().to_vec();
        let share = |dof: usize| -> f64 { gauss.iter().map(|(n, _, v)| v * n[dof / 3]).sum() };
        let load_force = std::array::from_fn(|dof| -share(dof) * body[dof % 3]);
        let mass = match law.density() {
            0.0 => Mass::None,
            rho => Mass::Lumped((0..DOFS).map(|dof| rho * share(dof)).collect()),
        };
        let points = vec![(strain_rows(&mean), volume)];
        let size = least_distance(&corners.map(|x| [x.x, x.y, x.z]));
        let class = Class::new("SSPbrick", 121);
        let body = Body { class, points, stabilisation, load_force, mass, size, extrapolation: vec![] };
        Ok(Self::of(body, law))
    }
}
