//! Kinematics of two-node bearings: basic deformations, and the P-Delta moments of the axial force.

use crate::element::{BasicRow, MatrixMask, dot};
use crate::numeric::SparseMatrix;
use nalgebra::Matrix3;

/// Linear kinematics of a two-node bearing with `N` degrees of freedom and `B` basic deformations.
///
/// In the plane (`N` = 6, `B` = 3) the basic deformations are axial, shear and rotation; in space (`N` = 12, `B` = 6)
/// axial, shear y, shear z, torsion, rotation about y, rotation about z, in local axes. The shear force acts at
/// `shear_dist` times the length from node i, and half of the axial force times the offset goes to each end as a
/// moment, as in OpenSees.
#[derive(Clone, Debug)]
pub struct Link<const N: usize, const B: usize> {
    /// Basic deformations from global displacements.
    pub basic: [[f64; N]; B],
    /// Local displacements from global ones.
    pub local: [[f64; N]; N],
    /// Local axes by rows.
    axes: [[f64; 3]; 3],
    /// From node i to the shear force, and from there to node j.
    arms: [f64; 2],
    /// `basic` transposed. Few entries are not zero.
    columns: SparseMatrix<N, B>,
    /// Forces in global axes per unit of axial force and displacement, for the tangent; none without P-Delta moments.
    p_delta: Option<SparseMatrix<N, N>>,
    /// The tangent knows that the P-Delta moments grow with the axial force.
    grows: bool,
}

/// Motion of a link in local axes. In the plane what points out of it is zero.
#[derive(Clone, Copy, Debug)]
pub struct LocalMotion {
    /// Displacement of node j relative to node i.
    offset: [f64; 3],
    /// Rotations of node i and of node j.
    ends: [[f64; 3]; 2],
}

/// Forces on the ends of a link in local axes.
struct EndForces {
    /// Force on node j, and its opposite on node i.
    force: [f64; 3],
    /// Moments on node i and on node j.
    moments: [[f64; 3]; 2],
}

impl<const N: usize, const B: usize> Link<N, B> {
    const PLANE: bool = N == 6;
    /// Basic deformations among the six in space.
    const DIRECTIONS: [usize; B] = {
        let mut all = [0; B];
        let mut i = 0;
        while i < B {
            all[i] = if B == 3 && i == 2 { 5 } else { i };
            i += 1;
        }
        all
    };

    /// From the rotation to local axes, the length and the place of the shear force (0 node i, 1 node j).
    pub fn new(axes: &Matrix3<f64>, length: f64, shear_dist: f64) -> Self {
        let arms = [shear_dist * length, (1.0 - shear_dist) * length];
        let axes: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| axes[(i, j)]));
        let (basic, local) = ([[0.0; N]; B], [[0.0; N]; N]);
        let none = SparseMatrix::new(&[[0.0; B]; N]);
        let mut link = Self { basic, local, axes, arms, columns: none, p_delta: None, grows: true };
        let mut p_delta = [[0.0; N]; N];
        for column in 0..N {
            let unit: [f64; N] = std::array::from_fn(|i| if i == column { 1.0 } else { 0.0 });
            let moments = EndForces { force: [0.0; 3], moments: link.sway(&link.local_motion(&unit)) };
            let mut force = [0.0; N];
            link.add_end_forces(&moments, &mut force);
            force.iter().zip(&mut p_delta).for_each(|(f, row)| row[column] = *f);
            link.deformation(&unit).iter().zip(&mut link.basic).for_each(|(u, row)| row[column] = *u);
        }
        let per_node = N / 2;
        // Translations and, in space, rotations turn with the axes; in the plane a rotation keeps its direction or not.
        let blocks: &[(usize, usize, usize)] =
            if Self::PLANE { &[(0, 0, 2), (2, 2, 1)] } else { &[(0, 0, 3), (3, 0, 3)] };
        for (node, &(at, axis, size)) in
            [0, per_node].into_iter().flat_map(|node| blocks.iter().map(move |b| (node, b)))
        {
            for a in 0..size {
                for b in 0..size {
                    link.local[node + at + a][node + at + b] = axes[axis + a][axis + b];
                }
            }
        }
        link.columns = SparseMatrix::new(&link.basic).transposed();
        link.p_delta = Some(SparseMatrix::new(&p_delta));
        link
    }

    /// Without P-Delta moments.
    pub fn first_order(mut self) -> Self {
        self.p_delta = None;
        self
    }

    /// As in OpenSees, the tangent of the P-Delta moments is that under the axial force at hand.
    pub fn under_given_force(self, given: bool) -> Self {
        Self { grows: !given, ..self }
    }

    /// Global displacements (or their rates) in local axes: what deformations and P-Delta moments come from.
    #[inline]
    pub fn local_motion(&self, disp: &[f64]) -> LocalMotion {
        let (u, a) = (&disp[..N], &self.axes);
        if Self::PLANE {
            let offset = [u[3] - u[0], u[4] - u[1], 0.0];
            LocalMotion { offset: turn(a, offset), ends: [[0.0, 0.0, a[2][2] * u[2]], [0.0, 0.0, a[2][2] * u[5]]] }
        } else {
            let offset = [u[6] - u[0], u[7] - u[1], u[8] - u[2]];
            LocalMotion { offset: turn(a, offset), ends: [turn(a, [u[3], u[4], u[5]]), turn(a, [u[9], u[10], u[11]])] }
        }
    }

    /// Add forces on the ends to global forces.
    #[inline]
    fn add_end_forces(&self, local: &EndForces, force: &mut [f64]) {
        let (f, a) = (&mut force[..N], &self.axes);
        let pull = turn_back(a, local.force);
        let add = |f: &mut [f64], sign: f64, v: &[f64]| f.iter_mut().zip(v).for_each(|(f, v)| *f += sign * v);
        if Self::PLANE {
            add(&mut f[..2], -1.0, &pull);
            add(&mut f[3..5], 1.0, &pull);
            f[2] += a[2][2] * local.moments[0][2];
            f[5] += a[2][2] * local.moments[1][2];
        } else {
            add(&mut f[..3], -1.0, &pull);
            add(&mut f[3..6], 1.0, &turn_back(a, local.moments[0]));
            add(&mut f[6..9], 1.0, &pull);
            add(&mut f[9..12], 1.0, &turn_back(a, local.moments[1]));
        }
    }

    /// End forces of basic forces `q`, without P-Delta moments.
    #[inline]
    fn end_forces(&self, q: &[f64; B]) -> EndForces {
        let [i, j] = self.arms;
        let mut all = [0.0; 6];
        Self::DIRECTIONS.iter().zip(q).for_each(|(d, q)| all[*d] = *q);
        let [n, vy, vz, t, my, mz] = all;
        EndForces { force: [n, vy, vz], moments: [[-t, i * vz - my, -i * vy - mz], [t, j * vz + my, mz - j * vy]] }
    }

    /// P-Delta moments on the ends per unit of axial force.
    #[inline]
    fn sway(&self, u: &LocalMotion) -> [[f64; 3]; 2] {
        let ([i, j], [start, end]) = (self.arms, &u.ends);
        // Half of the offset at each end, and what the rotations of the ends take from one to the other.
        let half = [-0.5 * u.offset[2], 0.5 * u.offset[1]];
        let over = [0.5 * (i * start[1] - j * end[1]), 0.5 * (i * start[2] - j * end[2])];
        [[0.0, half[0] + over[0], half[1] + over[1]], [0.0, half[0] - over[0], half[1] - over[1]]]
    }

    /// Basic deformations of global displacements (or their rates).
    #[inline]
    pub fn deformation(&self, disp: &[f64]) -> [f64; B] {
        self.deformation_of(&self.local_motion(disp))
    }

    /// Basic deformations of a motion in local axes.
    #[inline]
    pub fn deformation_of(&self, motion: &LocalMotion) -> [f64; B] {
        let ([i, j], LocalMotion { offset, ends: [start, end] }) = (self.arms, motion);
        let all = [
            offset[0],
            offset[1] - i * start[2] - j * end[2],
            offset[2] + i * start[1] + j * end[1],
            end[0] - start[0],
            end[1] - start[1],
            end[2] - start[2],
        ];
        Self::DIRECTIONS.map(|d| all[d])
    }

    /// Add the global forces of basic forces `q` without P-Delta moments.
    #[inline]
    pub fn add_basic_force(&self, q: &[f64; B], force: &mut [f64]) {
        self.add_end_forces(&self.end_forces(q), force);
    }

    /// Add the global forces of basic forces `q` at a motion in local axes, P-Delta moments included.
    #[inline]
    pub fn add_force(&self, q: &[f64; B], motion: &LocalMotion, force: &mut [f64]) {
        let mut local = self.end_forces(q);
        if self.p_delta.is_some() {
            let sway = self.sway(motion);
            for (moment, lever) in local.moments.as_flattened_mut().iter_mut().zip(sway.as_flattened()) {
                *moment += q[0] * lever;
            }
        }
        self.add_end_forces(&local, force);
    }

    /// Add a part of the consistent tangent of [`Link::add_force`] for the basic stiffness `k`.
    pub fn add_tangent(&self, k: &[[f64; B]; B], q: &[f64; B], disp: &[f64], tangent: &mut [f64], part: MatrixMask) {
        self.add_basic_part(k, tangent, part);
        let Some(p_delta) = &self.p_delta else { return };
        let moments = || part.rows.among(N).map(|i| (i, p_delta.row(i))).filter(|(_, row)| !row.is_empty());
        if moments().next().is_none() {
            return;
        }
        // The moments grow with the axial force too.
        let mut axial = [0.0; N];
        self.add_basic_force(&k[0], &mut axial);
        for (i, row) in moments() {
            let to = &mut tangent[i * N..(i + 1) * N];
            row.iter().for_each(|e| to[e.column] += q[0] * e.value);
            if !self.grows {
                continue;
            }
            let lever: f64 = row.iter().map(|e| e.value * disp[e.column]).sum();
            to.iter_mut().zip(&axial).for_each(|(t, a)| *t += lever * a);
        }
    }

    /// Add Aᵀ k A for a basic matrix `k`.
    pub fn add_basic(&self, k: &[[f64; B]; B], tangent: &mut [f64]) {
        self.add_basic_part(k, tangent, MatrixMask::ALL);
    }

    /// Add a part of Aᵀ k A for a basic matrix `k`.
    pub fn add_basic_part(&self, k: &[[f64; B]; B], tangent: &mut [f64], part: MatrixMask) {
        let whole = part.columns.has_all(N);
        for i in part.rows.among(N) {
            // Derivative of the force at i by the basic deformations.
            let mut by_basic = [0.0; B];
            for e in self.columns.row(i) {
                by_basic.iter_mut().zip(&k[e.column]).for_each(|(by, k)| *by += e.value * k);
            }
            let to = &mut tangent[i * N..(i + 1) * N];
            if whole {
                self.add_basic_force(&by_basic, to);
                continue;
            }
            for j in part.columns.among(N) {
                to[j] += self.columns.row(j).iter().fold(0.0, |sum, e| sum + e.value * by_basic[e.column]);
            }
        }
    }

    /// Basic deformations by direction, in the order of the basic forces.
    pub fn basic_rows(&self) -> Vec<BasicRow> {
        let (ndm, directions): (usize, &[usize]) = if N == 6 { (2, &[1, 2, 6]) } else { (3, &[1, 2, 3, 4, 5, 6]) };
        let rows = directions.iter().zip(&self.basic).enumerate();
        rows.map(|(column, (d, row))| BasicRow::new(*d, column, row, (ndm, N / 2))).collect()
    }

    /// Local forces of basic forces, P-Delta moments included.
    pub fn local_force(&self, global: &[f64], out: &mut [f64]) {
        for (o, row) in out.iter_mut().zip(&self.local) {
            *o = dot(row, global);
        }
    }
}

/// Components of a global vector along local axes.
#[inline]
fn turn(axes: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    axes.map(|a| a[0] * v[0] + a[1] * v[1] + a[2] * v[2])
}

/// Components of a local vector along global axes.
#[inline]
fn turn_back(axes: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| axes[0][i] * v[0] + axes[1][i] * v[1] + axes[2][i] * v[2])
}
