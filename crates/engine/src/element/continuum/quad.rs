//! The four-node quadrilateral `quad`.

use super::{Body, Continuum, ElementResult, Mass, Rows, least_distance, lumped, plane_rows};
use crate::element::{Class, ElementError};
use crate::material::{PLANE, SharedMultiaxial, THICK_PLANE};
use crate::numeric::axpy;

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

impl QuadOptions {
    /// Adds the forces of the pressure on a straight side to the resisting force.
    pub(super) fn press(&self, corners: &[[f64; 2]], (i, j): (usize, usize), load: &mut [f64]) {
        let half = [0, 1].map(|d| 0.5 * self.pressure * (corners[j][d] - corners[i][d]));
        for node in [i, j] {
            load[2 * node] -= half[1];
            load[2 * node + 1] += half[0];
        }
    }

    /// Density that counts.
    pub(super) fn density(&self, law: &SharedMultiaxial<PLANE>) -> f64 {
        if self.rho == 0.0 { law.density() } else { self.rho }
    }
}

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

impl Continuum<PLANE, 8> {
    /// Makes a bilinear isoparametric quadrilateral with 2 x 2 Gauss points and lumped mass (Zienkiewicz and Taylor, 2000,
    /// section 8.3) of its corners, counterclockwise.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn quad(corners: &[[f64; 2]; 4], law: &SharedMultiaxial<PLANE>, options: &QuadOptions) -> ElementResult<Self> {
        if SIGNS.iter().any(|at| shape(corners, *at).2 <= 0.0) {
            return Err(ElementError("the corners do not make a convex quadrilateral against the clock".into()));
        }
        let (mut load_force, mut mass, mut points) = ([0.0; 8], [0.0; 8], vec![]);
        let rho = options.density(law);
        for sign in SIGNS {
            let (n, d, det) = shape(corners, sign.map(|s| s / 3.0f64.sqrt()));
            let volume = det * options.thickness;
            for (node, n) in n.iter().enumerate() {
                for (dof, b) in [2 * node, 2 * node + 1].into_iter().zip(options.body) {
                    load_force[dof] -= volume * n * b;
                    mass[dof] += volume * n * rho;
                }
            }
            points.push((plane_rows(d), volume));
        }
        for side in [(0, 1), (1, 2), (2, 3), (3, 0)] {
            options.press(corners, side, &mut load_force);
        }
        // The bilinear field of the Gauss points at the corners.
        let root = 3.0f64.sqrt();
        let share = |[x, y]: [f64; 2], [s, t]: [f64; 2]| 0.25 * (1.0 + root * x * s) * (1.0 + root * y * t);
        let extrapolation = SIGNS.map(|corner| SIGNS.map(|point| share(point, corner)).to_vec()).to_vec();
        let body = Body {
            class: Class::new("FourNodeQuad", 31),
            points,
            stabilisation: vec![],
            load_force,
            mass: lumped(&mass),
            size: least_distance(corners),
            extrapolation,
        };
        Ok(Self::of(body, law))
    }
}

impl Continuum<THICK_PLANE, 8> {
    /// Makes a quadrilateral in plane strain with a constant dilatation: its derivatives are those of the mean over the
    /// volume (Hughes, 1980). The mass is consistent, with the density of the law.
    ///
    /// # Errors
    /// The corners are not counterclockwise or not convex.
    pub fn mean_dilatation_quad(
        corners: &[[f64; 2]; 4],
        law: &SharedMultiaxial<THICK_PLANE>,
        thickness: f64,
    ) -> ElementResult<Self> {
        if SIGNS.iter().any(|at| shape(corners, *at).2 <= 0.0) {
            return Err(ElementError("the corners do not make a convex quadrilateral against the clock".into()));
        }
        let gauss = SIGNS.map(|sign| shape(corners, sign.map(|s| s / 3.0f64.sqrt())));
        let area: f64 = gauss.iter().map(|(.., det)| det).sum();
        let mean = |node: usize, d: usize| gauss.iter().map(|(_, g, det)| det * g[node][d]).sum::<f64>() / area;
        let (mut points, mut mass) = (vec![], vec![0.0; 64]);
        for (n, d, det) in &gauss {
            let [along, across, shear] = plane_rows::<8>(*d);
            let mut rows: Rows<THICK_PLANE, 8> = [along, across, [0.0; 8], shear];
            for (node, d) in d.iter().enumerate() {
                for (axis, d) in d.iter().enumerate() {
                    let change = (mean(node, axis) - d) / 3.0;
                    rows[..3].iter_mut().for_each(|row| row[2 * node + axis] += change);
                }
            }
            for i in 0..8 {
                for j in (i % 2..8).step_by(2) {
                    mass[8 * i + j] += det * thickness * law.density() * n[i / 2] * n[j / 2];
                }
            }
            points.push((rows, det * thickness));
        }
        let body = Body {
            class: Class::new("ConstantPressureVolumeQuad", 60),
            points,
            stabilisation: vec![],
            load_force: [0.0; 8],
            mass: if law.density() == 0.0 { Mass::None } else { Mass::Consistent(mass) },
            size: least_distance(corners),
            extrapolation: vec![],
        };
        Ok(Self::of(body, law))
    }
}
