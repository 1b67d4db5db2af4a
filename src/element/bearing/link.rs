//! Kinematics of two-node bearings: basic deformations, and the P-Delta moments of the axial force.

use crate::element::{BasicRow, Rows, dot};
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
    /// `basic`, and transposed. Axes are mostly those of the building, and few entries are not zero.
    rows: SparseMatrix<B, N>,
    columns: SparseMatrix<N, B>,
    /// Forces in global axes per unit of axial force and displacement.
    p_delta: SparseMatrix<N, N>,
}

impl<const N: usize, const B: usize> Link<N, B> {
    /// From the rotation to local axes, the length and the place of the shear force (0 node i, 1 node j).
    pub fn new(axes: &Matrix3<f64>, length: f64, shear_dist: f64) -> Self {
        let plane = N == 6;
        let per_node = N / 2;
        let mut local = [[0.0; N]; N];
        for node in 0..2 {
            let at = node * per_node;
            if plane {
                for a in 0..2 {
                    for b in 0..2 {
                        local[at + a][at + b] = axes[(a, b)];
                    }
                }
                local[at + 2][at + 2] = axes[(2, 2)];
            } else {
                for a in 0..3 {
                    for b in 0..3 {
                        local[at + a][at + b] = axes[(a, b)];
                        local[at + 3 + a][at + 3 + b] = axes[(a, b)];
                    }
                }
            }
        }
        let (i, j) = (shear_dist * length, (1.0 - shear_dist) * length);
        let mut from_local = [[0.0; N]; B];
        for (k, row) in from_local.iter_mut().enumerate() {
            row[k] = -1.0;
            row[k + per_node] = 1.0;
        }
        // One bending plane: shear displacement v, rotation θ, with the sign of θ's share in v.
        let planes: &[(usize, usize, f64)] = if plane { &[(1, 2, -1.0)] } else { &[(1, 5, -1.0), (2, 4, 1.0)] };
        let mut geometry = [[0.0; N]; N];
        for &(v, r, sign) in planes {
            from_local[v][r] = sign * i;
            from_local[v][r + per_node] = sign * j;
            let (v2, r2) = (v + per_node, r + per_node);
            for end in [r, r2] {
                geometry[end][v] = 0.5 * sign;
                geometry[end][v2] = -0.5 * sign;
            }
            geometry[r][r] += 0.5 * i;
            geometry[r2][r] -= 0.5 * i;
            geometry[r][r2] -= 0.5 * j;
            geometry[r2][r2] += 0.5 * j;
        }
        let mut basic = [[0.0; N]; B];
        for (row, out) in from_local.iter().zip(&mut basic) {
            for (c, to) in row.iter().zip(&local) {
                for (o, t) in out.iter_mut().zip(to) {
                    *o += c * t;
                }
            }
        }
        let mut p_delta = [[0.0; N]; N];
        for a in 0..N {
            for b in 0..N {
                if geometry[a][b] != 0.0 {
                    for c in 0..N {
                        for d in 0..N {
                            p_delta[c][d] += local[a][c] * geometry[a][b] * local[b][d];
                        }
                    }
                }
            }
        }
        let rows = SparseMatrix::new(&basic);
        Self { basic, local, columns: rows.transposed(), rows, p_delta: SparseMatrix::new(&p_delta) }
    }

    /// Without P-Delta moments.
    pub fn first_order(mut self) -> Self {
        self.p_delta = SparseMatrix::new(&[[0.0; N]; N]);
        self
    }

    /// Basic deformations of global displacements (or their rates).
    #[inline]
    pub fn deformation(&self, disp: &[f64]) -> [f64; B] {
        self.rows.times(disp)
    }

    /// Add the global forces of basic forces `q` without P-Delta moments.
    #[inline]
    pub fn add_basic_force(&self, q: &[f64; B], force: &mut [f64]) {
        self.rows.add_transposed(q, force);
    }

    /// Add the global forces of basic forces `q`, P-Delta moments included.
    pub fn add_force(&self, q: &[f64; B], disp: &[f64], force: &mut [f64]) {
        self.add_basic_force(q, force);
        force.iter_mut().zip(self.p_delta.times(disp)).for_each(|(f, lever)| *f += q[0] * lever);
    }

    /// Add rows of the consistent tangent of [`Link::add_force`] for the basic stiffness `k`.
    pub fn add_tangent(&self, k: &[[f64; B]; B], q: &[f64; B], disp: &[f64], tangent: &mut [f64], rows: Rows) {
        self.add_basic_rows(k, tangent, rows);
        let moments = |i: &usize| rows.has(*i) && !self.p_delta.row(*i).is_empty();
        if !(0..N).any(|i| moments(&i)) {
            return;
        }
        // The moments grow with the axial force too.
        let mut axial = [0.0; N];
        self.add_basic_force(&k[0], &mut axial);
        for (i, to) in tangent.chunks_exact_mut(N).enumerate().filter(|(i, _)| moments(i)) {
            let row = self.p_delta.row(i);
            row.iter().for_each(|e| to[e.column] += q[0] * e.value);
            let lever: f64 = row.iter().map(|e| e.value * disp[e.column]).sum();
            to.iter_mut().zip(&axial).for_each(|(t, a)| *t += lever * a);
        }
    }

    /// Add Aᵀ k A for a basic matrix `k`.
    pub fn add_basic(&self, k: &[[f64; B]; B], tangent: &mut [f64]) {
        self.add_basic_rows(k, tangent, Rows::ALL);
    }

    /// Add rows of Aᵀ k A for a basic matrix `k`.
    pub fn add_basic_rows(&self, k: &[[f64; B]; B], tangent: &mut [f64], rows: Rows) {
        for (i, to) in tangent.chunks_exact_mut(N).enumerate().filter(|(i, _)| rows.has(*i)) {
            // Derivative of the force at i by the basic deformations.
            let mut by_basic = [0.0; B];
            for e in self.columns.row(i) {
                by_basic.iter_mut().zip(&k[e.column]).for_each(|(by, k)| *by += e.value * k);
            }
            self.rows.add_transposed(&by_basic, to);
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
