//! Kinematics of a Kikuchi bearing: deformations of its springs, and their forces on its nodes.

use crate::words;
use nalgebra::{SMatrix, SVector};

/// Degrees of freedom: x, y, z and the rotations about them at the ends i (0 to 5) and j (6 to 11); x and the rotations
/// about y and z of the inner nodes m (12 to 14, above the lower normal springs) and n (15 to 17, below the upper ones).
pub(super) const DOFS: usize = 18;
/// Degrees of freedom of the ends.
pub(super) const OUTER: usize = 12;
/// Degrees of freedom of the inner nodes.
pub(super) const INNER: usize = 6;

/// A vector over all degrees of freedom.
pub(super) type Motion = SVector<f64, DOFS>;
/// A matrix over all degrees of freedom.
pub(super) type Matrix = SMatrix<f64, DOFS, DOFS>;

words! {
    /// Forces and stiffnesses of all springs at a configuration.
    pub(super) struct Springs {
        /// Axial force and moments about y and z of the lower section.
        lower: [f64; 3],
        /// Its stiffness by rows.
        lower_stiffness: [f64; 9],
        /// Forces of the upper section.
        upper: [f64; 3],
        /// Its stiffness by rows.
        upper_stiffness: [f64; 9],
        /// Forces of the shear springs along y and z.
        shear: [f64; 2],
        /// Their stiffness by rows.
        shear_stiffness: [f64; 4],
        /// Axial deformation at mid-height.
        axial: f64,
    }
}

/// Stiff springs at mid-height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stiff {
    /// Axial.
    pub axial: f64,
    /// About x.
    pub torsion: f64,
    /// About y and z.
    pub bending: f64,
}

/// How the axial force at mid-height acts on the tilted, displaced links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Geometry {
    /// Each link by its own tilt.
    EachLink,
    /// Both links by the mean of their tilts: so the forces at the ends are in balance.
    MeanTilt,
}

/// Kinematics of two links of length `half`, from the inner nodes to the shear springs at mid-height.
#[derive(Clone, Debug)]
pub(super) struct Kinematics {
    /// Half of the height of the bearing.
    pub half: f64,
    /// Stiff springs at mid-height.
    pub stiff: Stiff,
    /// Derivative of the axial deformation at mid-height: change of its row with the displacements, as (row, column,
    /// value).
    coupling: Vec<(usize, usize, f64)>,
}

/// Where a section's forces act: with plus and with minus.
const LOWER: ([usize; 3], [usize; 3]) = ([12, 13, 14], [0, 4, 5]);
const UPPER: ([usize; 3], [usize; 3]) = ([6, 10, 11], [15, 16, 17]);

/// A bending plane: shear displacements of i and j, tilts of m and n, the sign of a tilt's share in the displacement,
/// so that the shear deformation is (u_j - u_i) - sign half (t_m + t_n).
const PLANES: [(usize, usize, usize, usize, f64); 2] = [(1, 7, 14, 17, 1.0), (2, 8, 13, 16, -1.0)];

impl Kinematics {
    /// Links of length `half`; with the tilt of the links, with the moments of the axial force.
    pub(super) fn new(half: f64, stiff: Stiff, tilt: bool, p_delta: bool, geometry: Geometry) -> Self {
        let mut coupling = vec![];
        for (ui, uj, tm, tn, sign) in PLANES {
            if tilt {
                for (u, t, own) in [(uj, tn, 1.0), (ui, tm, -1.0)] {
                    match geometry {
                        Geometry::EachLink => coupling.push((u, t, own * sign)),
                        Geometry::MeanTilt => {
                            coupling.extend([(u, tm, 0.5 * own * sign), (u, tn, 0.5 * own * sign)]);
                        }
                    }
                }
            }
            if p_delta {
                for (t, other) in [(tm, tn), (tn, tm)] {
                    coupling.extend([(t, uj, 0.5 * sign), (t, ui, -0.5 * sign)]);
                    match geometry {
                        _ if !tilt => {}
                        Geometry::EachLink => coupling.extend([(t, t, -0.5 * half), (t, other, -0.5 * half)]),
                        // The links turn about their own axes, not about that of the mean tilt.
                        Geometry::MeanTilt => coupling.push((t, other, -half)),
                    }
                }
            }
        }
        Self { half, stiff, coupling }
    }

    /// Axial deformation and rotations of the lower and of the upper section, shear deformation.
    pub(super) fn deformations(&self, q: &Motion) -> ([f64; 3], [f64; 3], [f64; 2]) {
        let of = |(plus, minus): ([usize; 3], [usize; 3])| std::array::from_fn(|k| q[plus[k]] - q[minus[k]]);
        let shear = PLANES.map(|(ui, uj, tm, tn, sign)| q[uj] - q[ui] - sign * self.half * (q[tm] + q[tn]));
        (of(LOWER), of(UPPER), shear)
    }

    /// Derivatives of the axial deformation at mid-height by the displacements, at displacements q. The force of the
    /// stiff spring there acts on the nodes by them.
    pub(super) fn axial_row(&self, q: &Motion) -> Motion {
        let mut row = Motion::zeros();
        (row[12], row[15]) = (-1.0, 1.0);
        for &(r, c, value) in &self.coupling {
            row[r] += value * q[c];
        }
        row
    }

    /// Axial deformation at mid-height after a step from `from`, where it was `axial`, to `to`, and its derivatives by
    /// the latter: the row in the middle of the step times the step. That is exact where the row is a gradient, which it
    /// is with tilt and P-Delta both.
    pub(super) fn axial(&self, axial: f64, from: &Motion, to: &Motion) -> (f64, Motion) {
        let step = to - from;
        let mut row = self.axial_row(&((from + to) * 0.5));
        let next = axial + row.dot(&step);
        for &(r, c, value) in &self.coupling {
            row[c] += 0.5 * value * step[r];
        }
        (next, row)
    }

    /// Forces of the springs on the nodes: `row` is that of the axial force.
    pub(super) fn forces(&self, q: &Motion, s: &Springs, row: &Motion) -> Motion {
        let mut f = row * (self.stiff.axial * s.axial);
        for ((plus, minus), force) in [(LOWER, s.lower), (UPPER, s.upper)] {
            for k in 0..3 {
                f[plus[k]] += force[k];
                f[minus[k]] -= force[k];
            }
        }
        for ((ui, uj, tm, tn, sign), v) in PLANES.into_iter().zip(s.shear) {
            f[uj] += v;
            f[ui] -= v;
            f[tm] -= sign * self.half * v;
            f[tn] -= sign * self.half * v;
        }
        for (a, b, k) in self.stiff_pairs() {
            let force = k * (q[b] - q[a]);
            f[b] += force;
            f[a] -= force;
        }
        f
    }

    /// Pairs of degrees of freedom that a stiff spring joins.
    fn stiff_pairs(&self) -> [(usize, usize, f64); 3] {
        [(3, 9, self.stiff.torsion), (13, 16, self.stiff.bending), (14, 17, self.stiff.bending)]
    }

    /// Stiffness of the springs: `row` is that of the axial force, `change` that of the axial deformation.
    pub(super) fn stiffness(&self, s: &Springs, row: &Motion, change: &Motion) -> Matrix {
        let mut k = Matrix::zeros();
        self.stiffness_into(s, row, change, &mut k);
        k
    }

    /// The same, into a matrix that is there.
    pub(super) fn stiffness_into(&self, s: &Springs, row: &Motion, change: &Motion, k: &mut Matrix) {
        for (column, change) in k.as_mut_slice().chunks_exact_mut(DOFS).zip(change.as_slice()) {
            column.iter_mut().zip(row.as_slice()).for_each(|(k, row)| *k = row * change * self.stiff.axial);
        }
        for ((plus, minus), c) in [(LOWER, s.lower_stiffness), (UPPER, s.upper_stiffness)] {
            for (a, c) in c.chunks_exact(3).enumerate() {
                for (b, &c) in c.iter().enumerate() {
                    k[(plus[a], plus[b])] += c;
                    k[(minus[a], minus[b])] += c;
                    k[(plus[a], minus[b])] -= c;
                    k[(minus[a], plus[b])] -= c;
                }
            }
        }
        let rows = self.shear_rows();
        for (a, c) in s.shear_stiffness.chunks_exact(2).enumerate() {
            for (b, &c) in c.iter().enumerate() {
                for (i, x) in rows[a] {
                    for (j, y) in rows[b] {
                        k[(i, j)] += c * x * y;
                    }
                }
            }
        }
        for (a, b, c) in self.stiff_pairs() {
            k[(a, a)] += c;
            k[(b, b)] += c;
            k[(a, b)] -= c;
            k[(b, a)] -= c;
        }
    }

    /// Shear deformations along y and z by the displacements.
    pub(super) fn shear_rows(&self) -> [[(usize, f64); 4]; 2] {
        PLANES.map(|(ui, uj, tm, tn, sign)| [(uj, 1.0), (ui, -1.0), (tm, -sign * self.half), (tn, -sign * self.half)])
    }

    /// Add what the turning of the axial force adds to the stiffness.
    pub(super) fn add_geometric(&self, axial_force: f64, k: &mut Matrix) {
        for &(r, c, value) in &self.coupling {
            k[(r, c)] += axial_force * value;
        }
    }
}
