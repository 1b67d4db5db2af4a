//! Kinematics of two-node bearings: basic deformations, and P-Delta moments of the axial force.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use crate::element::{BasicRow, MatrixMask, dot};
use crate::numeric::SparseMatrix;
use crate::numeric::real::Real;
use nalgebra::Matrix3;

/// Linear kinematics of a two-node bearing with `N` degrees of freedom and `B` basic deformations.
///
/// Basic deformations in the plane (`N` = 6, `B` = 3) are axial, shear and rotation. In space (`N` = 12, `B` = 6) they
/// are axial, shear y, shear z, torsion, rotation y and rotation z, in local axes. The shear force acts at `shear_dist`
/// times the length from node i. The axial force times the offset is a moment, half of which acts at each end, as in
/// OpenSees.
#[derive(Clone, Debug, PartialEq)]
pub struct Link<const N: usize, const B: usize> {
    /// Derivatives of the basic deformations by the global displacements.
    pub basic: [[f64; N]; B],
    /// Transformation from global to local displacements.
    pub local: [[f64; N]; N],
    /// Local axes by rows.
    axes: [[f64; 3]; 3],
    /// Distances from node i to the shear force, and from there to node j.
    arms: [f64; 2],
    /// `basic` transposed, without its zeros.
    columns: SparseMatrix<N, B>,
    /// Global forces per unit of axial force and displacement, for the tangent; `None` without P-Delta moments.
    p_delta: Option<SparseMatrix<N, N>>,
    /// The tangent includes the derivative of the axial force in the P-Delta moments.
    axial_derivative: bool,
}

/// Displacements of a link in local axes; components out of a plane are 0.
#[derive(Clone, Copy, Debug)]
pub struct LocalMotion<T> {
    /// Displacement of node j relative to node i.
    offset: [T; 3],
    /// Rotations of node i and of node j.
    ends: [[T; 3]; 2],
}

/// End forces of a link in local axes.
struct EndForces<T> {
    /// Force on node j, and its opposite on node i.
    force: [T; 3],
    /// Moments on node i and on node j.
    moments: [[T; 3]; 2],
}

impl<const N: usize, const B: usize> Link<N, B> {
    const PLANE: bool = N == 6;
    /// Indices of the basic deformations among the six in space.
    const DIRECTIONS: [usize; B] = {
        let mut all = [0; B];
        let mut i = 0;
        while i < B {
            all[i] = if B == 3 && i == 2 { 5 } else { i };
            i += 1;
        }
        all
    };

    /// Makes the kinematics from the rotation to local axes and the length. `shear_dist` is the position of the shear
    /// force: 0 for node i, 1 for node j.
    pub fn new(axes: &Matrix3<f64>, length: f64, shear_dist: f64) -> Self {
        let arms = [shear_dist * length, (1.0 - shear_dist) * length];
        let axes: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| axes[(i, j)]));
        let (basic, local) = ([[0.0; N]; B], [[0.0; N]; N]);
        let none = SparseMatrix::new(&[[0.0; B]; N]);
        let mut link = Self { basic, local, axes, arms, columns: none, p_delta: None, axial_derivative: true };
        let mut p_delta = [[0.0; N]; N];
        for column in 0..N {
            let unit: [f64; N] = std::array::from_fn(|i| if i == column { 1.0 } else { 0.0 });
            let moments = EndForces { force: [0.0; 3], moments: link.p_delta_levers(&link.local_motion(&unit)) };
            let mut force = [0.0; N];
            link.add_end_forces(&moments, &mut force);
            force.iter().zip(&mut p_delta).for_each(|(f, row)| row[column] = *f);
            link.deformation(&unit).iter().zip(&mut link.basic).for_each(|(u, row)| row[column] = *u);
        }
        let per_node = N / 2;
        // Rotate translations and, in space, rotations; in the plane only the sign of a rotation may change.
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

    /// Removes the P-Delta moments.
    pub fn first_order(mut self) -> Self {
        self.p_delta = None;
        self
    }

    /// With `constant`, the tangent of the P-Delta moments is that at constant axial force, as in OpenSees.
    pub fn under_given_force(self, constant: bool) -> Self {
        Self { axial_derivative: !constant, ..self }
    }

    /// Local displacements (or velocities) from global ones.
    #[inline(always)]
    pub fn local_motion<T: Real>(&self, disp: &[T]) -> LocalMotion<T> {
        let (u, a) = (&disp[..N], &self.axes);
        if Self::PLANE {
            let offset = [u[3] - u[0], u[4] - u[1], T::ZERO];
            let [start, end] = [u[2] * a[2][2], u[5] * a[2][2]];
            let zero = T::ZERO;
            LocalMotion { offset: to_local(a, offset), ends: [[zero, zero, start], [zero, zero, end]] }
        } else {
            let offset = [u[6] - u[0], u[7] - u[1], u[8] - u[2]];
            LocalMotion {
                offset: to_local(a, offset),
                ends: [to_local(a, [u[3], u[4], u[5]]), to_local(a, [u[9], u[10], u[11]])],
            }
        }
    }

    /// Adds end forces to the global forces.
    #[inline(always)]
    fn add_end_forces<T: Real>(&self, local: &EndForces<T>, force: &mut [T]) {
        let (f, a) = (&mut force[..N], &self.axes);
        let global_force = to_global(a, local.force);
        if Self::PLANE {
            for k in 0..2 {
                f[k] += -global_force[k];
                f[3 + k] += global_force[k];
            }
            f[2] += local.moments[0][2] * a[2][2];
            f[5] += local.moments[1][2] * a[2][2];
        } else {
            let [start, end] = [to_global(a, local.moments[0]), to_global(a, local.moments[1])];
            for k in 0..3 {
                f[k] += -global_force[k];
                f[3 + k] += start[k];
                f[6 + k] += global_force[k];
                f[9 + k] += end[k];
            }
        }
    }

    /// End forces of the basic forces `q`, without P-Delta moments.
    #[inline(always)]
    fn end_forces<T: Real>(&self, q: &[T; B]) -> EndForces<T> {
        let [i, j] = self.arms;
        let mut all = [T::ZERO; 6];
        for k in 0..B {
            all[Self::DIRECTIONS[k]] = q[k];
        }
        let [n, vy, vz, t, my, mz] = all;
        EndForces { force: [n, vy, vz], moments: [[-t, vz * i - my, -vy * i - mz], [t, vz * j + my, mz - vy * j]] }
    }

    /// P-Delta moments at the ends per unit of axial force.
    #[inline(always)]
    fn p_delta_levers<T: Real>(&self, u: &LocalMotion<T>) -> [[T; 3]; 2] {
        let ([i, j], [start, end]) = (self.arms, &u.ends);
        // Half of the offset at each end, plus the difference from the end rotations.
        let half = [u.offset[2] * -0.5, u.offset[1] * 0.5];
        let from_rotations = [(start[1] * i - end[1] * j) * 0.5, (start[2] * i - end[2] * j) * 0.5];
        [
            [T::ZERO, half[0] + from_rotations[0], half[1] + from_rotations[1]],
            [T::ZERO, half[0] - from_rotations[0], half[1] - from_rotations[1]],
        ]
    }

    /// Basic deformations (or their rates) from global displacements (or velocities).
    #[inline(always)]
    pub fn deformation<T: Real>(&self, disp: &[T]) -> [T; B] {
        self.deformation_of(&self.local_motion(disp))
    }

    /// Basic deformations from local displacements.
    #[inline(always)]
    pub fn deformation_of<T: Real>(&self, motion: &LocalMotion<T>) -> [T; B] {
        let ([i, j], LocalMotion { offset, ends: [start, end] }) = (self.arms, motion);
        let all = [
            offset[0],
            offset[1] - start[2] * i - end[2] * j,
            offset[2] + start[1] * i + end[1] * j,
            end[0] - start[0],
            end[1] - start[1],
            end[2] - start[2],
        ];
        let mut own = [T::ZERO; B];
        for k in 0..B {
            own[k] = all[Self::DIRECTIONS[k]];
        }
        own
    }

    /// Adds the global forces of the basic forces `q`, without P-Delta moments.
    #[inline(always)]
    pub fn add_basic_force<T: Real>(&self, q: &[T; B], force: &mut [T]) {
        self.add_end_forces(&self.end_forces(q), force);
    }

    /// Adds the global forces of the basic forces `q`, with P-Delta moments.
    #[inline(always)]
    pub fn add_force<T: Real>(&self, q: &[T; B], motion: &LocalMotion<T>, force: &mut [T]) {
        let mut local = self.end_forces(q);
        if self.p_delta.is_some() {
            let p_delta_levers = self.p_delta_levers(motion);
            for end in 0..2 {
                for k in 0..3 {
                    local.moments[end][k] += q[0] * p_delta_levers[end][k];
                }
            }
        }
        self.add_end_forces(&local, force);
    }

    /// Adds the masked part of the consistent tangent of [`Link::add_force`] for the basic stiffness `k`.
    #[inline(always)]
    pub fn add_tangent<T: Real>(&self, k: &[[T; B]; B], q: &[T; B], disp: &[T], tangent: &mut [T], part: MatrixMask) {
        self.add_basic_part(k, tangent, part);
        let Some(p_delta) = &self.p_delta else { return };
        // The moments are proportional to the axial force.
        let mut axial = None;
        for i in part.rows.among(N) {
            let row = p_delta.row(i);
            if row.is_empty() {
                continue;
            }
            let to = &mut tangent[i * N..(i + 1) * N];
            for e in row {
                to[e.column] += q[0] * e.value;
            }
            if !self.axial_derivative {
                continue;
            }
            let axial = axial.get_or_insert_with(|| {
                let mut axial = [T::ZERO; N];
                self.add_basic_force(&k[0], &mut axial);
                axial
            });
            let mut lever = T::ZERO;
            for e in row {
                lever += disp[e.column] * e.value;
            }
            for (t, a) in to.iter_mut().zip(&*axial) {
                *t += lever * *a;
            }
        }
    }

    /// Adds Aᵀ k A for a basic matrix `k`.
    pub fn add_basic(&self, k: &[[f64; B]; B], tangent: &mut [f64]) {
        self.add_basic_part(k, tangent, MatrixMask::ALL);
    }

    /// Adds the masked part of Aᵀ k A for a basic matrix `k`.
    #[inline(always)]
    pub fn add_basic_part<T: Real>(&self, k: &[[T; B]; B], tangent: &mut [T], part: MatrixMask) {
        let whole = part.columns.has_all(N);
        for i in part.rows.among(N) {
            // Derivatives of the force i by the basic deformations.
            let mut by_basic = [T::ZERO; B];
            for e in self.columns.row(i) {
                for (by, k) in by_basic.iter_mut().zip(&k[e.column]) {
                    *by += *k * e.value;
                }
            }
            let to = &mut tangent[i * N..(i + 1) * N];
            if whole {
                self.add_basic_force(&by_basic, to);
                continue;
            }
            for j in part.columns.among(N) {
                let mut sum = T::ZERO;
                for e in self.columns.row(j) {
                    sum += by_basic[e.column] * e.value;
                }
                to[j] += sum;
            }
        }
    }

    /// Basic deformations by direction, in the order of the basic forces.
    pub fn basic_rows(&self) -> Vec<BasicRow> {
        let (ndm, directions): (usize, &[usize]) = if N == 6 { (2, &[1, 2, 6]) } else { (3, &[1, 2, 3, 4, 5, 6]) };
        let rows = directions.iter().zip(&self.basic).enumerate();
        rows.map(|(column, (d, row))| BasicRow::new(*d, column, row, (ndm, N / 2))).collect()
    }

    /// Local end forces from global ones, P-Delta moments included.
    pub fn local_force(&self, global: &[f64], out: &mut [f64]) {
        for (o, row) in out.iter_mut().zip(&self.local) {
            *o = dot(row, global);
        }
    }
}

/// Components of a global vector along local axes.
#[inline(always)]
fn to_local<T: Real>(axes: &[[f64; 3]; 3], v: [T; 3]) -> [T; 3] {
    let component = |a: &[f64; 3]| v[0] * a[0] + v[1] * a[1] + v[2] * a[2];
    [component(&axes[0]), component(&axes[1]), component(&axes[2])]
}

/// Components of a local vector along global axes.
#[inline(always)]
fn to_global<T: Real>(axes: &[[f64; 3]; 3], v: [T; 3]) -> [T; 3] {
    let component = |i: usize| v[0] * axes[0][i] + v[1] * axes[1][i] + v[2] * axes[2][i];
    [component(0), component(1), component(2)]
}
