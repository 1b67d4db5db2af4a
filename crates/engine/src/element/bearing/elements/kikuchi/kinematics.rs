//! Kinematics of a Kikuchi bearing: deformations of its springs, and their forces on its nodes.

use crate::state_struct;
use nalgebra::SVector;

/// Degrees of freedom: x, y, z and the rotations about them at the ends i (0 to 5) and j (6 to 11); x and the rotations
/// about y and z of the inner nodes m (12 to 14, above the lower normal springs) and n (15 to 17, below the upper ones).
pub(super) const DOFS: usize = 18;
/// Degrees of freedom of the ends.
pub(super) const OUTER: usize = 12;
/// Degrees of freedom of the inner nodes.
pub(super) const INNER: usize = 6;

/// A vector over all degrees of freedom.
pub(super) type Motion = SVector<f64, DOFS>;
/// A matrix over all degrees of freedom, by rows.
pub(super) type Matrix = [[f64; DOFS]; DOFS];
/// A matrix over those of the inner nodes, by rows.
pub(super) type InnerMatrix = [[f64; INNER]; INNER];

state_struct! {
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

/// Action of the axial force at mid-height on the tilted, displaced links.
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
    /// Derivative of the axial deformation at mid-height: change of its row with the displacements of a bending plane, in the
    /// order of [`PLACES`]. The planes do not know of each other.
    coupling: [[[f64; 4]; 4]; 2],
}

/// Degrees of freedom at which a section's forces act: with plus and with minus.
const LOWER: ([usize; 3], [usize; 3]) = ([12, 13, 14], [0, 4, 5]);
const UPPER: ([usize; 3], [usize; 3]) = ([6, 10, 11], [15, 16, 17]);

/// Degrees of freedom of the bending planes: shear displacements of i and j, tilts of m and n.
const PLACES: [[usize; 4]; 2] = [[1, 7, 14, 17], [2, 8, 13, 16]];

/// Sign of a tilt's share in the displacement of each plane, so that the shear deformation is (u_j - u_i) - sign half (t_m + t_n).
const SIGNS: [f64; 2] = [1.0, -1.0];

/// Shear displacements of i and j, tilts of m and n, in the order of [`PLACES`].
const UI: usize = 0;
const UJ: usize = 1;
const TM: usize = 2;
const TN: usize = 3;

impl Kinematics {
    /// Links of length `half`; with the tilt of the links, with the moments of the axial force.
    pub(super) fn new(half: f64, stiff: Stiff, tilt: bool, p_delta: bool, geometry: Geometry) -> Self {
        let coupling = SIGNS.map(|sign| {
            let mut c = [[0.0; 4]; 4];
            if tilt {
                for (u, t, own) in [(UJ, TN, 1.0), (UI, TM, -1.0)] {
                    match geometry {
                        Geometry::EachLink => c[u][t] += own * sign,
                        Geometry::MeanTilt => [TM, TN].into_iter().for_each(|t| c[u][t] += 0.5 * own * sign),
                    }
                }
            }
            if p_delta {
                for (t, other) in [(TM, TN), (TN, TM)] {
                    c[t][UJ] += 0.5 * sign;
                    c[t][UI] -= 0.5 * sign;
                    match geometry {
                        _ if !tilt => {}
                        Geometry::EachLink => [t, other].into_iter().for_each(|by| c[t][by] -= 0.5 * half),
                        // The links turn about their own axes, not about that of the mean tilt.
                        Geometry::MeanTilt => c[t][other] -= half,
                    }
                }
            }
            c
        });
        Self { half, stiff, coupling }
    }

    /// Axial deformation and rotations of the lower and of the upper section, shear deformation.
    pub(super) fn deformations(&self, q: &Motion) -> ([f64; 3], [f64; 3], [f64; 2]) {
        let of = |(plus, minus): ([usize; 3], [usize; 3])| std::array::from_fn(|k| q[plus[k]] - q[minus[k]]);
        let plane = |[ui, uj, tm, tn]: [usize; 4], sign: f64| q[uj] - q[ui] - sign * self.half * (q[tm] + q[tn]);
        let shear = std::array::from_fn(|i| plane(PLACES[i], SIGNS[i]));
        (of(LOWER), of(UPPER), shear)
    }

    /// Derivatives of the axial deformation at mid-height by the displacements, at displacements q. The force of the
    /// stiff spring there acts on the nodes by them.
    pub(super) fn axial_row(&self, q: &Motion) -> Motion {
        let mut row = Motion::zeros();
        (row[12], row[15]) = (-1.0, 1.0);
        for (places, c) in PLACES.iter().zip(&self.coupling) {
            let at = places.map(|i| q[i]);
            for (&i, c) in places.iter().zip(c) {
                row[i] += c[0] * at[0] + c[1] * at[1] + c[2] * at[2] + c[3] * at[3];
            }
        }
        row
    }

    /// Axial deformation at mid-height after a step, before which it was `axial`, and its derivatives by the displacements
    /// at the end: the row in the middle of the step times the step. `rows` are those at its begin and at its end, between which
    /// the row changes in proportion. That is exact where the row is a gradient, which it is with tilt and P-Delta both.
    pub(super) fn axial(&self, axial: f64, step: &Motion, rows: [&Motion; 2]) -> (f64, Motion) {
        let mut row = (rows[0] + rows[1]) * 0.5;
        let next = axial + row.dot(step);
        for (places, c) in PLACES.iter().zip(&self.coupling) {
            let half = places.map(|i| 0.5 * step[i]);
            for (k, &i) in places.iter().enumerate() {
                row[i] += c[0][k] * half[0] + c[1][k] * half[1] + c[2][k] * half[2] + c[3][k] * half[3];
            }
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
        for (([ui, uj, tm, tn], sign), v) in PLACES.into_iter().zip(SIGNS).zip(s.shear) {
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
        let mut k = [[0.0; DOFS]; DOFS];
        self.stiffness_into(s, row, change, &mut k);
        k
    }

    /// The same, into a matrix of zeros.
    pub(super) fn stiffness_into(&self, s: &Springs, row: &Motion, change: &Motion, k: &mut Matrix) {
        for (k, row) in k.iter_mut().zip(row.as_slice()).filter(|(_, row)| **row != 0.0) {
            let by = row * self.stiff.axial;
            k.iter_mut().zip(change.as_slice()).for_each(|(k, change)| *k = by * change);
        }
        for ((plus, minus), c) in [(LOWER, s.lower_stiffness), (UPPER, s.upper_stiffness)] {
            for (a, c) in c.chunks_exact(3).enumerate() {
                for (b, &c) in c.iter().enumerate() {
                    k[plus[a]][plus[b]] += c;
                    k[minus[a]][minus[b]] += c;
                    k[plus[a]][minus[b]] -= c;
                    k[minus[a]][plus[b]] -= c;
                }
            }
        }
        let rows = self.shear_rows();
        for (a, c) in s.shear_stiffness.chunks_exact(2).enumerate() {
            for (b, &c) in c.iter().enumerate() {
                for (i, x) in rows[a] {
                    for (j, y) in rows[b] {
                        k[i][j] += c * x * y;
                    }
                }
            }
        }
        for (a, b, c) in self.stiff_pairs() {
            k[a][a] += c;
            k[b][b] += c;
            k[a][b] -= c;
            k[b][a] -= c;
        }
    }

    /// The part of the stiffness that the inner nodes have among themselves, with what the turning of the axial force adds
    /// to it: all that is needed on the way to their balance.
    pub(super) fn inner_stiffness(&self, s: &Springs, row: &Motion, change: &Motion) -> InnerMatrix {
        let mut k = [[0.0; INNER]; INNER];
        for (k, row) in k.iter_mut().zip(&row.as_slice()[OUTER..]) {
            let by = row * self.stiff.axial;
            k.iter_mut().zip(&change.as_slice()[OUTER..]).for_each(|(k, change)| *k = by * change);
        }
        for a in 0..3 {
            for b in 0..3 {
                k[a][b] += s.lower_stiffness[3 * a + b];
                k[3 + a][3 + b] += s.upper_stiffness[3 * a + b];
            }
        }
        let tilts = PLACES.map(|places| [places[TM] - OUTER, places[TN] - OUTER]);
        for (a, c) in s.shear_stiffness.chunks_exact(2).enumerate() {
            for (b, &c) in c.iter().enumerate() {
                let c = c * SIGNS[a] * SIGNS[b] * self.half * self.half;
                tilts[a].into_iter().for_each(|i| tilts[b].into_iter().for_each(|j| k[i][j] += c));
            }
        }
        for (a, b, c) in self.stiff_pairs().into_iter().filter(|(a, ..)| *a >= OUTER) {
            let (a, b) = (a - OUTER, b - OUTER);
            k[a][a] += c;
            k[b][b] += c;
            k[a][b] -= c;
            k[b][a] -= c;
        }
        let force = self.stiff.axial * s.axial;
        for (at, c) in tilts.into_iter().zip(&self.coupling) {
            for (a, &i) in at.iter().enumerate() {
                for (b, &j) in at.iter().enumerate() {
                    k[i][j] += force * c[TM + a][TM + b];
                }
            }
        }
        k
    }

    /// Shear deformations along y and z by the displacements.
    pub(super) fn shear_rows(&self) -> [[(usize, f64); 4]; 2] {
        std::array::from_fn(|plane| {
            let ([ui, uj, tm, tn], tilt) = (PLACES[plane], -SIGNS[plane] * self.half);
            [(uj, 1.0), (ui, -1.0), (tm, tilt), (tn, tilt)]
        })
    }

    /// Add what the turning of the axial force adds to the stiffness.
    pub(super) fn add_geometric(&self, axial_force: f64, k: &mut Matrix) {
        for (places, c) in PLACES.iter().zip(&self.coupling) {
            for (&i, c) in places.iter().zip(c) {
                places.iter().zip(c).for_each(|(&j, c)| k[i][j] += axial_force * c);
            }
        }
    }
}
