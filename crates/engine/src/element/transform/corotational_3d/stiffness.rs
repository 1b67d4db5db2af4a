//! First derivatives of the natural deformations, and the matrices that they give.

use super::geometry::{Geometry, column};
use crate::numeric::lanes::{Lanes, in_lanes};
use nalgebra::{Matrix3, Vector3};

/// A stiffness of a beam: displacements and rotations of i, then of j.
pub(super) type Stiffness = [[f64; 12]; 12];

/// Derivatives of the natural deformations by displacements and spins of the faces.
pub(super) struct Rows {
    rows: [[f64; 12]; 7],
    /// Tangents of the natural rotations.
    tangents: [f64; 6],
}

/// Forces at the faces of the joints, or at the nodes.
pub(super) struct Faces(pub(super) [f64; 12]);

impl Rows {
    /// The rows at a geometry.
    pub(super) fn of(s: &Geometry) -> Self {
        let mut rows = [[0.0; 12]; 7];
        let (e1, e2, e3) = (column(&s.e, 0), column(&s.e, 1), column(&s.e, 2));
        let (l2, l3) = (s.chord_axis(1), s.chord_axis(2));
        let cosines = s.cosines();
        for (first, own, r) in [(0, 3, &s.i), (3, 9, &s.j)] {
            let (r1, r2, r3) = (column(r, 0), column(r, 1), column(r, 2));
            let parts = [
                (l3.sway * r2 - l2.sway * r3, l3.spin * r2 - l2.spin * r3, r2.cross(&e3) - r3.cross(&e2)),
                (l2.sway * r1 + s.a * r2, l2.spin * r1, r1.cross(&e2) - r2.cross(&e1)),
                (l3.sway * r1 + s.a * r3, l3.spin * r1, r1.cross(&e3) - r3.cross(&e1)),
            ];
            for (k, (sway, spin, of_own)) in parts.iter().enumerate() {
                let factor = 0.5 / cosines[first + k];
                let row = &mut rows[first + k];
                for a in 0..3 {
                    (row[a], row[a + 6]) = (factor * sway[a], -factor * sway[a]);
                    (row[a + 3], row[a + 9]) = (factor * spin[a], factor * spin[a]);
                    row[own + a] = factor * (spin[a] + of_own[a]);
                }
            }
        }
        for a in 0..3 {
            (rows[6][a], rows[6][a + 6]) = (-e1[a], e1[a]);
        }
        Self { rows, tangents: std::array::from_fn(|n| s.sines[n] / cosines[n]) }
    }

    /// Forces at the faces of the joints for natural forces.
    pub(super) fn transposed_times(&self, p: &[f64; 7]) -> [f64; 12] {
        let mut f = [0.0; 12];
        for (row, p) in self.rows.iter().zip(p) {
            for (f, r) in f.iter_mut().zip(row) {
                *f += p * r;
            }
        }
        f
    }

    /// Adds the stiffness of the natural deformations: that of the basic ones, and the part of the natural forces `p` that comes
    /// with the tangents of the natural rotations.
    pub(super) fn add_stiffness(&self, kb: &[[f64; 6]; 6], p: &[f64; 7], k: &mut Stiffness) {
        // Natural deformations in the basic ones.
        const IN_BASIC: [(usize, f64); 7] = [(5, -1.0), (1, 1.0), (3, -1.0), (5, 1.0), (2, 1.0), (4, -1.0), (0, 1.0)];
        let mut natural = [[0.0; 7]; 7];
        for (row, (b, s)) in natural.iter_mut().zip(IN_BASIC) {
            for (value, (c, t)) in row.iter_mut().zip(IN_BASIC) {
                *value = s * t * kb[b][c];
            }
        }
        for n in 0..6 {
            natural[n][n] += p[n] * self.tangents[n];
        }
        in_lanes(&mut Congruence { rows: &self.rows, inner: &natural, k });
    }
}

/// Adds Rᵀ K R.
struct Congruence<'a> {
    rows: &'a [[f64; 12]; 7],
    inner: &'a [[f64; 7]; 7],
    k: &'a mut Stiffness,
}

impl Lanes for Congruence<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        for m in 0..7 {
            let mut product = [0.0; 12];
            for n in 0..7 {
                let factor = self.inner[m][n];
                if factor != 0.0 {
                    for (product, row) in product.iter_mut().zip(&self.rows[n]) {
                        *product += factor * row;
                    }
                }
            }
            for i in 0..12 {
                let factor = self.rows[m][i];
                for (k, product) in self.k[i].iter_mut().zip(&product) {
                    *k += factor * product;
                }
            }
        }
    }
}

impl Faces {
    /// The same forces at the nodes, from which the faces are an offset away.
    pub(super) fn at_nodes(mut self, offsets: &(Vector3<f64>, Vector3<f64>)) -> Self {
        for (at, arm) in [(0, &offsets.0), (6, &offsets.1)] {
            let moment = arm.cross(&Vector3::from_column_slice(&self.0[at..at + 3]));
            self.0[at + 3..at + 6].iter_mut().zip(moment.iter()).for_each(|(f, m)| *f += m);
        }
        self
    }
}

/// Stiffness at the nodes from that at the faces and the forces there.
pub(super) fn offset_stiffness(k: &Stiffness, faces: &[f64; 12], offsets: &(Vector3<f64>, Vector3<f64>)) -> Stiffness {
    let levers = [(0, -offsets.0.cross_matrix()), (6, -offsets.1.cross_matrix())];
    let mut right = *k;
    // K L, then Lᵀ K L, with L = 1 but for the levers.
    for row in &mut right {
        for (at, lever) in &levers {
            for b in 0..3 {
                row[at + 3 + b] += (0..3).map(|a| row[at + a] * lever[(a, b)]).sum::<f64>();
            }
        }
    }
    let mut out = right;
    for (at, lever) in &levers {
        for b in 0..3 {
            for a in 0..3 {
                for j in 0..12 {
                    out[at + 3 + b][j] += lever[(a, b)] * right[at + a][j];
                }
            }
        }
    }
    for (at, arm) in [(0, &offsets.0), (6, &offsets.1)] {
        // The joint offset rotates: (ω × arm) × f.
        let force = Vector3::from_column_slice(&faces[at..at + 3]);
        let turned: Matrix3<f64> = force.cross_matrix() * arm.cross_matrix();
        for a in 0..3 {
            for b in 0..3 {
                out[at + 3 + a][at + 3 + b] += turned[(a, b)];
            }
        }
    }
    out
}
