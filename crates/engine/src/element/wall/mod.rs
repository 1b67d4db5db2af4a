//! Walls of vertical strips between two rigid beams, in the plane and in space.

mod lines;
mod panels;

use super::roles::ForceLabels;
use super::{ElementError, ElementResult, Mass};
use crate::numeric::axpy;
use crate::probe::Probe;
use nalgebra::{Matrix3, SMatrix, Vector3};

pub use lines::{WallFibre, WallLines};
pub use panels::{PanelLaw, WallPanel, WallPanels};

/// Number of displacements in the plane: horizontal, vertical and rotation of the lower beam, then of the upper one.
const IN_PLANE: usize = 6;
/// Displacements of a wall in the plane.
pub const PLANE_WALL: usize = IN_PLANE;
/// First word of the path of the forces in the axes of a wall.
const LOCAL_FORCE: u32 = 9;
/// Displacements of a wall in space.
pub const SPACE_WALL: usize = 24;

/// Geometry of a wall, and its elastic stiffness beside that of the strips.
#[derive(Clone, Debug)]
pub struct WallShape<const D: usize> {
    /// The six displacements in the plane, by those of the nodes.
    basis: [[f64; D]; IN_PLANE],
    /// Elastic stiffness D x D by rows; empty without one.
    stiffness: Vec<f64>,
    /// Axes of a wall in space, in rows: along its width, along its height, and square to it.
    axes: Option<Matrix3<f64>>,
    height: f64,
    /// Height of the centre of rotation over that of the wall.
    centre: f64,
    mass: Mass,
}

/// Elastic properties of a wall in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallPlate {
    /// Modulus of elasticity.
    pub modulus: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Mean thickness.
    pub thickness: f64,
    /// Thickness in bending over the mean thickness.
    pub bending: f64,
}

impl WallShape<PLANE_WALL> {
    /// A wall of a height in the plane, node i below node j. `mass` is that of the whole wall; none in rotation.
    pub fn plane(height: f64, centre: f64, mass: f64) -> Self {
        let basis = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
        let share = 0.5 * mass;
        let mass = if mass == 0.0 { Mass::None } else { Mass::Lumped(vec![share, share, 0.0, share, share, 0.0]) };
        Self { basis, stiffness: vec![], axes: None, height, centre, mass }
    }
}

impl WallShape<SPACE_WALL> {
    /// A rectangular wall in space of its corners: lower left and right, upper left and right. Rigid beams in the plane are
    /// elastic beams of half the stiffness of a beam as high as the wall. Out of the plane it is an elastic plate with
    /// twelve displacements (Adini and Clough, 1961; Zienkiewicz and Cheung, 1964).
    ///
    /// # Errors
    /// The corners do not make a rectangle whose width is `width`, to one percent.
    pub fn space(
        corners: &[Vector3<f64>; 4],
        width: f64,
        centre: f64,
        mass: f64,
        plate: &WallPlate,
    ) -> ElementResult<Self> {
        let side = |i: usize, j: usize| corners[j] - corners[i];
        let (h1, h2) = (side(0, 2).norm(), side(1, 3).norm());
        let near = |a: f64, b: f64| (0.99..=1.01).contains(&(a / b));
        if !near(h1, h2) {
            return Err(ElementError("the two vertical sides of the wall do not have one height".into()));
        }
        if !near(width, side(0, 1).norm()) || !near(width, side(2, 3).norm()) {
            return Err(ElementError(format!("the widths add up to {width}, which is not that of the sides").into()));
        }
        let height = 0.5 * (h1 + h2);
        let (x, y) = (side(0, 1).normalize(), side(0, 2).normalize());
        let z = x.cross(&y);
        if z.norm().is_nan() || z.norm() <= 0.99 {
            return Err(ElementError("the corners do not make a rectangle".into()));
        }
        let axes = Matrix3::from_rows(&[x.transpose(), y.transpose(), z.transpose()]);
        let mut basis = [[0.0; SPACE_WALL]; IN_PLANE];
        let half = 0.5 * width;
        let turn = 0.5 / (half * half + 1.0);
        for beam in 0..2 {
            let at = |end: usize, dof: usize| 12 * beam + 6 * end + dof;
            for end in 0..2 {
                let side = if end == 0 { -half } else { half };
                basis[3 * beam][at(end, 0)] = 0.5;
                basis[3 * beam + 1][at(end, 1)] = 0.5;
                basis[3 * beam + 2][at(end, 1)] = side * turn;
                basis[3 * beam + 2][at(end, 5)] = turn;
            }
        }
        let mut local = SMatrix::<f64, SPACE_WALL, SPACE_WALL>::zeros();
        add_plate(width, height, plate, &mut local);
        add_beams(width, height, plate, &mut local);
        // Each group of three displacements turns from the axes into those of the wall.
        let mut turned = SMatrix::<f64, SPACE_WALL, SPACE_WALL>::zeros();
        (0..8).for_each(|group| turned.fixed_view_mut::<3, 3>(3 * group, 3 * group).copy_from(&axes));
        let stiffness = (turned.transpose() * local * turned).as_slice().to_vec();
        let to_global = |row: [f64; SPACE_WALL]| {
            let global = SMatrix::<f64, 1, SPACE_WALL>::from_row_slice(&row) * turned;
            std::array::from_fn(|i| global[i])
        };
        let share = 0.25 * mass;
        let lumped = (0..SPACE_WALL).map(|dof| if dof % 6 < 3 { share } else { 0.0 }).collect();
        let mass = if mass == 0.0 { Mass::None } else { Mass::Lumped(lumped) };
        Ok(Self { basis: basis.map(to_global), stiffness, axes: Some(axes), height, centre, mass })
    }
}

/// Adds the stiffness of a rectangular plate with cubic deflections: deflection, slope along y and negative slope along x at
/// each corner.
fn add_plate(a: f64, b: f64, plate: &WallPlate, k: &mut SMatrix<f64, SPACE_WALL, SPACE_WALL>) {
    // Powers of x and y of the deflection.
    const POWERS: [(i32, i32); 12] =
        [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3), (3, 1), (1, 3)];
    let thickness = plate.thickness * plate.bending;
    let rigidity = plate.modulus * thickness.powi(3) / (12.0 * (1.0 - plate.nu * plate.nu));
    let falling = |p: i32, n: i32| (0..n).map(|i| f64::from(p - i)).product::<f64>();
    // Derivative of the term (p, q), `m` times by x and `n` times by y. Lengths are in units of the sides.
    let term = |(p, q): (i32, i32), (m, n): (i32, i32), [x, y]: [f64; 2]| {
        if p < m || q < n {
            0.0
        } else {
            falling(p, m) * falling(q, n) * x.powi(p - m) * y.powi(q - n) / a.powi(m) / b.powi(n)
        }
    };
    let mut corners = SMatrix::<f64, 12, 12>::zeros();
    for (corner, at) in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].into_iter().enumerate() {
        for (j, power) in POWERS.into_iter().enumerate() {
            corners[(3 * corner, j)] = term(power, (0, 0), at);
            corners[(3 * corner + 1, j)] = term(power, (0, 1), at);
            corners[(3 * corner + 2, j)] = -term(power, (1, 0), at);
        }
    }
    let Some(inverse) = corners.try_inverse() else { return };
    let d = Matrix3::new(1.0, plate.nu, 0.0, plate.nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - plate.nu)) * rigidity;
    let mut terms = SMatrix::<f64, 12, 12>::zeros();
    let outer = 0.5 * 0.6f64.sqrt();
    let points = [(0.5 - outer, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + outer, 5.0 / 18.0)];
    for (x, wx) in points {
        for (y, wy) in points {
            let row = |by: (i32, i32), factor: f64| POWERS.map(|power| factor * term(power, by, [x, y]));
            let rows = [row((2, 0), 1.0), row((0, 2), 1.0), row((1, 1), 2.0)];
            let curvature = SMatrix::<f64, 3, 12>::from_fn(|i, j| rows[i][j]);
            terms += curvature.transpose() * d * curvature * (wx * wy * a * b);
        }
    }
    let plate = inverse.transpose() * terms * inverse;
    let dof = |i: usize| 6 * (i / 3) + 2 + i % 3;
    for i in 0..12 {
        for j in 0..12 {
            k[(dof(i), dof(j))] += plate[(i, j)];
        }
    }
}

/// Adds the stiffness of the beams between the lower corners, and between the upper ones, in the plane.
fn add_beams(length: f64, height: f64, plate: &WallPlate, k: &mut SMatrix<f64, SPACE_WALL, SPACE_WALL>) {
    let e = plate.modulus;
    let axial = e * plate.thickness * height / length;
    let bending = e * 0.5 * plate.thickness * height.powi(3) / 12.0 / length.powi(3);
    let rows = [
        ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], axial),
        // Mean rotation and difference of rotations.
        ([0.0, 2.0 / length, 1.0, 0.0, -2.0 / length, 1.0], 3.0 * bending * length * length),
        ([0.0, 0.0, -1.0, 0.0, 0.0, 1.0], bending * length * length),
    ];
    let dofs = [0, 1, 5, 6, 7, 11];
    for beam in [0, 12] {
        for (row, stiffness) in rows {
            for (i, a) in dofs.into_iter().zip(row) {
                for (j, b) in dofs.into_iter().zip(row) {
                    k[(beam + i, beam + j)] += stiffness * a * b;
                }
            }
        }
    }
}

impl<const D: usize> WallShape<D> {
    /// `localForce` of a wall in space: the forces of the nodes in its axes.
    fn local_force_probe(&self, words: &[&str]) -> Option<Probe> {
        match words {
            ["localForce" | "localForces", ..] if self.axes.is_some() => {
                let labels = ForceLabels::Wall.names(D).into_iter().map(|label| label.replace("global", "local"));
                Some(Probe::new(LOCAL_FORCE, labels))
            }
            _ => None,
        }
    }

    /// Forces in the axes of the wall, by groups of three.
    fn local_force(&self, force: &[f64], out: &mut [f64]) {
        let Some(axes) = &self.axes else { return };
        for (force, out) in force.chunks_exact(3).zip(out.chunks_exact_mut(3)) {
            out.copy_from_slice((axes * Vector3::from_column_slice(force)).as_slice());
        }
    }

    /// A combination of the displacements in the plane.
    fn combined(&self, row: [f64; IN_PLANE]) -> [f64; D] {
        let mut out = [0.0; D];
        row.iter().zip(&self.basis).filter(|(factor, _)| **factor != 0.0).for_each(|(f, b)| axpy(*f, b, &mut out));
        out
    }

    /// Vertical strain at a distance from the centre line.
    fn vertical_strain(&self, x: f64) -> [f64; D] {
        self.combined([0.0, -1.0, -x, 0.0, 1.0, x].map(|r| r / self.height))
    }

    /// Shear deformation at the centre of rotation, with the sign of the lower beam's displacement.
    fn shear(&self) -> [f64; D] {
        let (h, c) = (self.height, self.centre);
        self.combined([1.0, 0.0, -c * h, -1.0, 0.0, -(1.0 - c) * h])
    }

    /// Curvature.
    fn curvature(&self) -> [f64; D] {
        self.combined([0.0, 0.0, -1.0, 0.0, 0.0, 1.0].map(|r| r / self.height))
    }
}

/// Adds `stiffness row^T row` to a matrix.
fn add_stiffness<const D: usize>(matrix: &mut [f64], row: &[f64; D], stiffness: f64) {
    for (out, r) in matrix.chunks_exact_mut(D).zip(row) {
        axpy(stiffness * r, row, out);
    }
}
