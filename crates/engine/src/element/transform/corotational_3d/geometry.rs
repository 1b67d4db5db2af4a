//! Current geometry of a beam, its natural deformations, and their second derivatives.

use super::stiffness::Stiffness;
use nalgebra::{Matrix3, Vector3};

/// Current geometry of the beam.
pub(super) struct Geometry {
    /// Current and undeformed length of the chord.
    length: f64,
    undeformed: f64,
    /// Undeformed chord and its relative displacement.
    line: Vector3<f64>,
    relative_displacement: Vector3<f64>,
    /// Axes of node i, of node j, their mean, and axes of the chord; as columns.
    pub(super) i: Matrix3<f64>,
    pub(super) j: Matrix3<f64>,
    mean: Matrix3<f64>,
    pub(super) e: Matrix3<f64>,
    /// Rotated joint offsets.
    pub(super) offsets: (Vector3<f64>, Vector3<f64>),
    /// (1 - e₁e₁ᵀ)/Lₙ
    pub(super) a: Matrix3<f64>,
    /// Sines of the natural rotations.
    pub(super) sines: [f64; 6],
}

/// Derivative of a chord axis times a vector by the displacement of node i (that by node j is its negative) and by the spin of
/// either node.
pub(super) struct ChordAxis {
    pub(super) sway: Matrix3<f64>,
    pub(super) spin: Matrix3<f64>,
}

/// Geometric stiffness by blocks: between displacements, between displacements and spins of i and j, between spins. Those of
/// the displacements of j are the negatives of those of i.
struct Blocks {
    sway: Matrix3<f64>,
    mixed: [Matrix3<f64>; 2],
    spin: [[Matrix3<f64>; 2]; 2],
}

pub(super) fn column(m: &Matrix3<f64>, i: usize) -> Vector3<f64> {
    m.column(i).into_owned()
}

fn cross(v: &Vector3<f64>) -> Matrix3<f64> {
    v.cross_matrix()
}

impl Geometry {
    /// From the undeformed chord, its undeformed length and relative displacement, the axes of i, j and their mean, and the rotated
    /// joint offsets.
    pub(super) fn new(
        line: Vector3<f64>,
        undeformed: f64,
        relative_displacement: Vector3<f64>,
        [i, j, mean]: [Matrix3<f64>; 3],
        offsets: (Vector3<f64>, Vector3<f64>),
    ) -> Self {
        let chord = line + relative_displacement;
        let length = chord.norm();
        let e1 = chord / length;
        let (r1, r2, r3) = (column(&mean, 0), column(&mean, 1), column(&mean, 2));
        let e2 = r2 - (e1 + r1) * (0.5 * r2.dot(&e1));
        let e3 = r3 - (e1 + r1) * (0.5 * r3.dot(&e1));
        let a = (Matrix3::identity() - e1 * e1.transpose()) / length;
        let end = |r: &Matrix3<f64>| {
            let (r1, r2, r3) = (column(r, 0), column(r, 1), column(r, 2));
            let sine = |twice: f64| (0.5 * twice).clamp(-1.0, 1.0);
            [sine(r2.dot(&e3) - r3.dot(&e2)), sine(r1.dot(&e2) - r2.dot(&e1)), sine(r1.dot(&e3) - r3.dot(&e1))]
        };
        let ([i1, i2, i3], [j1, j2, j3]) = (end(&i), end(&j));
        Self {
            length,
            undeformed,
            line,
            relative_displacement,
            i,
            j,
            mean,
            e: Matrix3::from_columns(&[e1, e2, e3]),
            offsets,
            a,
            sines: [i1, i2, i3, j1, j2, j3],
        }
    }

    /// Natural deformations: twist, rotation about z and negative rotation about y at i, the same at j, elongation.
    pub(super) fn deformation(&self) -> [f64; 7] {
        // Lₙ - L without cancellation.
        let stretch = 2.0 * (self.line + 0.5 * self.relative_displacement).dot(&self.relative_displacement)
            / (self.length + self.undeformed);
        let [i1, i2, i3, j1, j2, j3] = self.sines.map(f64::asin);
        [i1, i2, i3, j1, j2, j3, stretch]
    }

    /// Cosines of the natural rotations.
    pub(super) fn cosines(&self) -> [f64; 6] {
        self.sines.map(|s| ((1.0 - s) * (1.0 + s)).sqrt())
    }

    /// Derivative of the chord axis e_k by displacements and spins, where `k` is that of the mean axis r_k.
    pub(super) fn chord_axis(&self, k: usize) -> ChordAxis {
        let r = &column(&self.mean, k);
        let (e1, r1) = (column(&self.e, 0), column(&self.mean, 0));
        let re = r.dot(&e1);
        let sum = (e1 + r1).transpose();
        ChordAxis {
            sway: self.a * (0.5 * re) + self.a * r * sum * 0.5,
            spin: cross(r) * 0.5 - cross(&r1) * (0.25 * re) - r.cross(&e1) * sum * 0.25,
        }
    }

    /// Geometric stiffness for natural forces `p` without the part of the tangents of the natural rotations: the derivative of the
    /// rows.
    pub(super) fn geometric(&self, p: &[f64; 7]) -> Stiffness {
        let e = [column(&self.e, 0), column(&self.e, 1), column(&self.e, 2)];
        let i = [column(&self.i, 0), column(&self.i, 1), column(&self.i, 2)];
        let j = [column(&self.j, 0), column(&self.j, 1), column(&self.j, 2)];
        let (l2, l3) = (self.chord_axis(1), self.chord_axis(2));
        let mut m = self.cosines();
        for (m, p) in m.iter_mut().zip(p) {
            *m = 0.5 * p / *m;
        }
        let (se, si, sj) = (e.map(|v| cross(&v)), i.map(|v| cross(&v)), j.map(|v| cross(&v)));

        let mut k = Blocks { sway: self.a * p[6], mixed: [Matrix3::zeros(); 2], spin: [[Matrix3::zeros(); 2]; 2] };
        k.add_spin(0, &l2, &-(si[2] * m[3] + si[0] * m[1]));
        k.add_spin(0, &l3, &(si[1] * m[3] - si[0] * m[2]));
        k.add_spin(1, &l2, &(sj[2] * m[3] - sj[0] * m[4]));
        k.add_spin(1, &l3, &-(sj[1] * m[3] + sj[0] * m[5]));

        let bend = |s: &[Matrix3<f64>; 3], twist: f64, z: f64, y: f64| {
            (se[1] * s[2] - se[2] * s[1]) * twist
                + (se[1] * s[0] - se[0] * s[1]) * z
                + (se[2] * s[0] - se[0] * s[2]) * y
        };
        k.spin[0][0] += bend(&si, m[3], m[1], m[2]);
        k.spin[1][1] += bend(&sj, -m[3], m[4], m[5]);

        let v = (i[1] * m[1] + i[2] * m[2] + j[1] * m[4] + j[2] * m[5]) / self.length;
        let sway = self.a * v * e[0].transpose();
        k.sway += self.a * e[0].dot(&v) + sway + sway.transpose();
        k.mixed[0] -= self.a * (si[1] * m[1] + si[2] * m[2]);
        k.mixed[1] -= self.a * (sj[1] * m[4] + sj[2] * m[5]);

        self.add_chord_axis_change(1, &((i[2] - j[2]) * m[3] + i[0] * m[1] + j[0] * m[4]), &mut k);
        self.add_chord_axis_change(2, &((j[1] - i[1]) * m[3] + i[0] * m[2] + j[0] * m[5]), &mut k);
        k.expanded()
    }

    /// Adds the derivative of the derivative of chord axis `k` times z, by displacements and spins.
    fn add_chord_axis_change(&self, k: usize, z: &Vector3<f64>, to: &mut Blocks) {
        let r = &column(&self.mean, k);
        let (e1, r1) = (column(&self.e, 0), column(&self.mean, 0));
        let (re, ze, zr) = (r.dot(&e1), z.dot(&e1), z.dot(&r1));
        let a = &self.a;
        let half = 0.5 / self.length;
        let (az, ar) = (a * z, a * r);
        let (e1t, zt) = (e1.transpose(), z.transpose());
        let u = az * ar.transpose() * -0.5 + (az * (re * half) + ar * ((ze + zr) * half)) * e1t;
        to.sway += u + u.transpose() + a * (re * (2.0 * ze + zr) * half);
        let (sr, sr1, sz, se1) = (cross(r), cross(&r1), cross(z), cross(&e1));
        let k12 = (-az * (e1t * sr) - ar * (zt * sr1) - a * sr * (ze + zr)) * 0.25;
        let k22 = (-sz * sr1 * re + (sr1 * z) * (e1t * sr) + (sr * e1) * (zt * sr1) - se1 * sr * (ze + zr)
            + sz * sr * 2.0)
            * 0.125;
        for end in 0..2 {
            to.mixed[end] += k12;
            to.spin[end].iter_mut().for_each(|spin| *spin += k22);
        }
    }
}

impl Blocks {
    /// Adds the derivative of a chord axis times a matrix in the columns of the spin of an end, and its transpose in the rows.
    fn add_spin(&mut self, end: usize, axis: &ChordAxis, matrix: &Matrix3<f64>) {
        let spin = axis.spin * matrix;
        self.mixed[end] += axis.sway * matrix;
        for other in 0..2 {
            self.spin[other][end] += spin;
            self.spin[end][other] += spin.transpose();
        }
    }

    /// All blocks: displacements and spin of i, then of j.
    fn expanded(&self) -> Stiffness {
        let mut k = [[0.0; 12]; 12];
        let mut put = |row: usize, col: usize, m: &Matrix3<f64>, sign: f64| {
            for i in 0..3 {
                for j in 0..3 {
                    k[row + i][col + j] = sign * m[(i, j)];
                }
            }
        };
        for (row, sign) in [(0, 1.0), (6, -1.0)] {
            put(row, 0, &self.sway, sign);
            put(row, 6, &self.sway, -sign);
            for (end, at) in [(0, 3), (1, 9)] {
                put(row, at, &self.mixed[end], sign);
                put(at, row, &self.mixed[end].transpose(), sign);
            }
        }
        for (end, at) in [(0, 3), (1, 9)] {
            put(at, 3, &self.spin[end][0], 1.0);
            put(at, 9, &self.spin[end][1], 1.0);
        }
        k
    }
}
