//! Corotational transformation in space (Crisfield, 1990; de Souza, 2000, chapter 4).
//!
//! Nodal axes rotate by the increments of the nodal rotations from the committed state, taken as spins. The axes e of
//! the chord follow the line between the ends and the mean of the nodal axes. Basic deformations are the rotations and
//! elongation relative to them. OpenSees sums increments over iterations, which converges to the same with the step
//! size; `by_trials` follows it.

use super::{Frame, Reactions, Transform};
use crate::element::ElementError;
use crate::state_struct::StateStruct;
use nalgebra::{Matrix3, Quaternion, SMatrix, UnitQuaternion, Vector3};

/// Corotational transformation in space.
#[derive(Clone, Debug)]
pub struct Corotational3d {
    frame: Frame<12, 6>,
    /// Undeformed vector from node i to node j, without the joint offsets.
    line: Vector3<f64>,
    /// Undeformed joint offsets at node i and node j.
    offsets: (Vector3<f64>, Vector3<f64>),
    /// Increments of rotation start from the last trial state, as in OpenSees.
    by_trials: bool,
}

crate::state_struct! {
    /// State variables: rotations of the nodes since the creation of the beam (quaternions i, j, k, w), and the nodal
    /// rotations they belong to.
    struct NodalRotations {
        i: [f64; 4],
        j: [f64; 4],
        rotation_i: [f64; 3],
        rotation_j: [f64; 3],
    }
}

type Rows = SMatrix<f64, 7, 12>;
type Matrix12x12 = SMatrix<f64, 12, 12>;
type Matrix12x3 = SMatrix<f64, 12, 3>;

/// Current geometry of the beam.
struct Geometry {
    /// Current and undeformed length of the chord.
    length: f64,
    undeformed: f64,
    /// Undeformed chord and its relative displacement.
    line: Vector3<f64>,
    relative_displacement: Vector3<f64>,
    /// Axes of node i, of node j, their mean, and axes of the chord; as columns.
    i: Matrix3<f64>,
    j: Matrix3<f64>,
    mean: Matrix3<f64>,
    e: Matrix3<f64>,
    /// Rotated joint offsets.
    offsets: (Vector3<f64>, Vector3<f64>),
    /// (1 - e₁e₁ᵀ)/Lₙ
    a: Matrix3<f64>,
}

/// Three entries of a vector of length 12: displacement or rotation of a node.
fn vector3(u: &[f64], at: usize) -> Vector3<f64> {
    Vector3::new(u[at], u[at + 1], u[at + 2])
}

fn turn(q: &[f64; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(q[3], q[0], q[1], q[2]))
}

/// The quaternion after an increment of the nodal rotation from `from` to `to`.
fn updated_quaternion(q: &[f64; 4], from: &[f64; 3], to: Vector3<f64>) -> [f64; 4] {
    let spin = to - Vector3::from_column_slice(from);
    let next = UnitQuaternion::from_scaled_axis(spin) * turn(q);
    let q = UnitQuaternion::new_normalize(next.into_inner());
    [q.i, q.j, q.k, q.w]
}

fn cross(v: &Vector3<f64>) -> Matrix3<f64> {
    v.cross_matrix()
}

fn column(m: &Matrix3<f64>, i: usize) -> Vector3<f64> {
    m.column(i).into_owned()
}

impl Corotational3d {
    /// Makes the transformation from the undeformed geometry; `by_trials` as in
    /// [`TransformSpec`](super::TransformSpec).
    pub fn new(frame: Frame<12, 6>, offsets: (Vector3<f64>, Vector3<f64>), by_trials: bool) -> Self {
        let along = frame.axes.row(0).transpose() * frame.length;
        Self { line: along - offsets.1 + offsets.0, frame, offsets, by_trials }
    }

    fn geometry(&self, disp: &[f64], state: &NodalRotations) -> Geometry {
        let u = self.frame.since_made(disp);
        let (qi, qj) = (turn(&state.i), turn(&state.j));
        let axes = self.frame.axes.transpose();
        let i = qi.to_rotation_matrix().matrix() * axes;
        let j = qj.to_rotation_matrix().matrix() * axes;
        // Rotation of the mean from i: half of the tangent-scaled rotation to j.
        let between = (qj * qi.inverse()).into_inner();
        let half = Quaternion::from_parts(2.0 * between.w, between.imag());
        let mean = UnitQuaternion::new_normalize(half).to_rotation_matrix().matrix() * i;

        let offsets = (qi * self.offsets.0, qj * self.offsets.1);
        let line = self.line + self.offsets.1 - self.offsets.0;
        let relative_displacement =
            vector3(&u, 6) - vector3(&u, 0) + (offsets.1 - self.offsets.1) - (offsets.0 - self.offsets.0);
        let chord = line + relative_displacement;
        let length = chord.norm();
        let e1 = chord / length;
        let (r1, r2, r3) = (column(&mean, 0), column(&mean, 1), column(&mean, 2));
        let e2 = r2 - (e1 + r1) * (0.5 * r2.dot(&e1));
        let e3 = r3 - (e1 + r1) * (0.5 * r3.dot(&e1));
        let e = Matrix3::from_columns(&[e1, e2, e3]);
        let a = (Matrix3::identity() - e1 * e1.transpose()) / length;
        Geometry { length, undeformed: self.frame.length, line, relative_displacement, i, j, mean, e, offsets, a }
    }

    /// Nodal forces from forces at the faces of the joints.
    fn to_nodes(s: &Geometry, mut f: SMatrix<f64, 12, 1>) -> SMatrix<f64, 12, 1> {
        for (at, arm) in [(0, &s.offsets.0), (6, &s.offsets.1)] {
            let moment = arm.cross(&f.fixed_rows::<3>(at).into_owned());
            let mut m = f.fixed_rows_mut::<3>(at + 3);
            m += moment;
        }
        f
    }

    /// Forces at the faces of the joints from the basic forces.
    fn face_forces(rows: &Rows, q: &[f64; 6]) -> SMatrix<f64, 12, 1> {
        rows.transpose() * SMatrix::<f64, 7, 1>::from(natural(q))
    }
}

/// Forces conjugate to the natural deformations of [`Geometry::deformation`], from basic forces.
fn natural(q: &[f64; 6]) -> [f64; 7] {
    [-q[5], q[1], -q[3], q[5], q[2], -q[4], q[0]]
}

impl Geometry {
    /// Natural deformations: twist, rotation about z and negative rotation about y at i, the same at j, elongation.
    fn deformation(&self) -> [f64; 7] {
        let (e1, e2, e3) = (column(&self.e, 0), column(&self.e, 1), column(&self.e, 2));
        let end = |r: &Matrix3<f64>| {
            let (r1, r2, r3) = (column(r, 0), column(r, 1), column(r, 2));
            let angle = |sine: f64| (0.5 * sine).clamp(-1.0, 1.0).asin();
            [angle(r2.dot(&e3) - r3.dot(&e2)), angle(r1.dot(&e2) - r2.dot(&e1)), angle(r1.dot(&e3) - r3.dot(&e1))]
        };
        let (i, j) = (end(&self.i), end(&self.j));
        // Lₙ - L without cancellation.
        let stretch = 2.0 * (self.line + 0.5 * self.relative_displacement).dot(&self.relative_displacement)
            / (self.length + self.undeformed);
        [i[0], i[1], i[2], j[0], j[1], j[2], stretch]
    }

    /// Derivative of the chord axis e_k by displacements and spins, where `r` is the mean axis r_k.
    fn chord_axis(&self, r: &Vector3<f64>) -> Matrix12x3 {
        let (e1, r1) = (column(&self.e, 0), column(&self.mean, 0));
        let re = r.dot(&e1);
        let sum = (e1 + r1).transpose();
        let l1 = self.a * (0.5 * re) + self.a * r * sum * 0.5;
        let l2 = cross(r) * 0.5 - cross(&r1) * (0.25 * re) - cross(r) * e1 * sum * 0.25;
        let mut l = Matrix12x3::zeros();
        for (at, block) in [(0, l1), (3, l2), (6, -l1), (9, l2)] {
            l.fixed_view_mut::<3, 3>(at, 0).copy_from(&block);
        }
        l
    }

    /// Derivatives of the natural deformations by displacements and spins of the faces.
    fn rows(&self, deformation: &[f64; 7]) -> Rows {
        let mut t = Rows::zeros();
        let (e1, e2, e3) = (column(&self.e, 0), column(&self.e, 1), column(&self.e, 2));
        let l2 = self.chord_axis(&column(&self.mean, 1));
        let l3 = self.chord_axis(&column(&self.mean, 2));
        for (first, spin, r) in [(0, 3, &self.i), (3, 9, &self.j)] {
            let (r1, r2, r3) = (column(r, 0), column(r, 1), column(r, 2));
            let mut twist = l3 * r2 - l2 * r3;
            let mut about_z = l2 * r1;
            let mut about_y = l3 * r1;
            for (row, of_spin, of_chord) in [
                (&mut twist, r2.cross(&e3) - r3.cross(&e2), Vector3::zeros()),
                (&mut about_z, r1.cross(&e2) - r2.cross(&e1), self.a * r2),
                (&mut about_y, r1.cross(&e3) - r3.cross(&e1), self.a * r3),
            ] {
                let mut vector3 = row.fixed_rows_mut::<3>(spin);
                vector3 += of_spin;
                let mut vector3 = row.fixed_rows_mut::<3>(0);
                vector3 += of_chord;
                let mut vector3 = row.fixed_rows_mut::<3>(6);
                vector3 -= of_chord;
            }
            for (k, row) in [twist, about_z, about_y].iter().enumerate() {
                let factor = 0.5 / deformation[first + k].cos();
                t.row_mut(first + k).copy_from(&(row * factor).transpose());
            }
        }
        for k in 0..3 {
            t[(6, k)] = -e1[k];
            t[(6, k + 6)] = e1[k];
        }
        t
    }

    /// Geometric stiffness for natural forces `p`: the derivative of the rows.
    fn geometric(&self, rows: &Rows, deformation: &[f64; 7], p: &[f64; 7]) -> Matrix12x12 {
        let mut k = Matrix12x12::zeros();
        let e = [column(&self.e, 0), column(&self.e, 1), column(&self.e, 2)];
        let i = [column(&self.i, 0), column(&self.i, 1), column(&self.i, 2)];
        let j = [column(&self.j, 0), column(&self.j, 1), column(&self.j, 2)];
        let (r2, r3) = (column(&self.mean, 1), column(&self.mean, 2));
        let (l2, l3) = (self.chord_axis(&r2), self.chord_axis(&r3));
        let m: [f64; 6] = std::array::from_fn(|n| 0.5 * p[n] / deformation[n].cos());
        let se = e.map(|v| cross(&v));
        let (si, sj) = (i.map(|v| cross(&v)), j.map(|v| cross(&v)));

        pair(&mut k, &(self.a * p[6]));

        let tall = -l2 * (si[2] * m[3] + si[0] * m[1]) + l3 * (si[1] * m[3] - si[0] * m[2]);
        mirrored(&mut k, &tall, 3);
        let tall = l2 * (sj[2] * m[3] - sj[0] * m[4]) - l3 * (sj[1] * m[3] + sj[0] * m[5]);
        mirrored(&mut k, &tall, 9);

        let bend = |s: &[Matrix3<f64>; 3], twist: f64, z: f64, y: f64| {
            (se[1] * s[2] - se[2] * s[1]) * twist
                + (se[1] * s[0] - se[0] * s[1]) * z
                + (se[2] * s[0] - se[0] * s[2]) * y
        };
        block(&mut k, 3, 3, &bend(&si, m[3], m[1], m[2]), 1.0);
        block(&mut k, 9, 9, &bend(&sj, -m[3], m[4], m[5]), 1.0);

        let v = (i[1] * m[1] + i[2] * m[2] + j[1] * m[4] + j[2] * m[5]) / self.length;
        let sway = self.a * v * e[0].transpose();
        pair(&mut k, &(self.a * e[0].dot(&v) + sway + sway.transpose()));
        for (at, s) in [(3, -self.a * (si[1] * m[1] + si[2] * m[2])), (9, -self.a * (sj[1] * m[4] + sj[2] * m[5]))] {
            let mut tall = Matrix12x3::zeros();
            tall.fixed_view_mut::<3, 3>(0, 0).copy_from(&s);
            tall.fixed_view_mut::<3, 3>(6, 0).copy_from(&-s);
            mirrored(&mut k, &tall, at);
        }

        k += self.chord_axis_change(&r2, &((i[2] - j[2]) * m[3] + i[0] * m[1] + j[0] * m[4]));
        k += self.chord_axis_change(&r3, &((j[1] - i[1]) * m[3] + i[0] * m[2] + j[0] * m[5]));

        for n in 0..6 {
            let row = rows.row(n);
            k += row.transpose() * row * (p[n] * deformation[n].tan());
        }
        k
    }

    /// Derivative of `chord_axis(r) z` by displacements and spins.
    fn chord_axis_change(&self, r: &Vector3<f64>, z: &Vector3<f64>) -> Matrix12x12 {
        let (e1, r1) = (column(&self.e, 0), column(&self.mean, 0));
        let (re, ze, zr) = (r.dot(&e1), z.dot(&e1), z.dot(&r1));
        let a = &self.a;
        let half = 0.5 / self.length;
        let u = a * z * r.transpose() * a * -0.5
            + a * z * e1.transpose() * (re * half)
            + a * r * e1.transpose() * ((ze + zr) * half);
        let k11 = u + u.transpose() + a * (re * (2.0 * ze + zr) * half);
        let (sr, sr1, sz, se1) = (cross(r), cross(&r1), cross(z), cross(&e1));
        let k12 = (-a * z * e1.transpose() * sr - a * r * z.transpose() * sr1 - a * sr * (ze + zr)) * 0.25;
        let k22 = (-sz * sr1 * re + sr1 * z * e1.transpose() * sr + sr * e1 * z.transpose() * sr1
            - se1 * sr * (ze + zr)
            + sz * sr * 2.0)
            * 0.125;
        let mut k = Matrix12x12::zeros();
        pair(&mut k, &k11);
        for (row, sign) in [(0, 1.0), (6, -1.0)] {
            for col in [3, 9] {
                block(&mut k, row, col, &k12, sign);
                block(&mut k, col, row, &k12.transpose(), sign);
            }
        }
        for row in [3, 9] {
            for col in [3, 9] {
                block(&mut k, row, col, &k22, 1.0);
            }
        }
        k
    }
}

fn block(k: &mut Matrix12x12, row: usize, col: usize, m: &Matrix3<f64>, sign: f64) {
    let mut view = k.fixed_view_mut::<3, 3>(row, col);
    view += m * sign;
}

/// Adds a stiffness between the displacements of the two faces.
fn pair(k: &mut Matrix12x12, m: &Matrix3<f64>) {
    for (row, col, sign) in [(0, 0, 1.0), (0, 6, -1.0), (6, 0, -1.0), (6, 6, 1.0)] {
        block(k, row, col, m, sign);
    }
}

/// Adds columns from `at` on, and their transpose as rows.
fn mirrored(k: &mut Matrix12x12, tall: &Matrix12x3, at: usize) {
    let mut view = k.fixed_view_mut::<12, 3>(0, at);
    view += tall;
    let mut view = k.fixed_view_mut::<3, 12>(at, 0);
    view += tall.transpose();
}

impl Transform<12, 6> for Corotational3d {
    fn length(&self) -> f64 {
        self.frame.length
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn is_small(&self) -> bool {
        false
    }
    fn is_symmetric(&self) -> bool {
        false
    }
    fn state_len(&self) -> usize {
        NodalRotations::LEN
    }
    fn init(&self, state: &mut [f64]) {
        let none = [0.0, 0.0, 0.0, 1.0];
        NodalRotations { i: none, j: none, ..NodalRotations::default() }.write(state);
    }
    fn advance(&self, disp: &[f64], committed: &[f64], trial: &mut [f64]) -> Result<(), ElementError> {
        let from = if self.by_trials { &*trial } else { committed };
        let (c, u) = (NodalRotations::read(from), self.frame.since_made(disp));
        let next = NodalRotations {
            i: updated_quaternion(&c.i, &c.rotation_i, vector3(&u, 3)),
            j: updated_quaternion(&c.j, &c.rotation_j, vector3(&u, 9)),
            rotation_i: vector3(&u, 3).into(),
            rotation_j: vector3(&u, 9).into(),
        };
        next.write(trial);
        let length = self.geometry(disp, &next).length;
        // Negated comparison, so that NaN is an error.
        if length > 0.0 { Ok(()) } else { Err(ElementError("the ends of the beam have met".into())) }
    }
    fn deformation(&self, disp: &[f64], state: &[f64]) -> [f64; 6] {
        let v = self.geometry(disp, &NodalRotations::read(state)).deformation();
        [v[6], v[1], v[4], -v[2], -v[5], v[3] - v[0]]
    }
    /// Member loads keep the direction of the undeformed beam, as in OpenSees.
    fn add_force(&self, disp: &[f64], state: &[f64], q: &[f64; 6], p0: &Reactions, force: &mut [f64]) {
        let s = self.geometry(disp, &NodalRotations::read(state));
        let rows = s.rows(&s.deformation());
        let f = Self::to_nodes(&s, Self::face_forces(&rows, q));
        force.iter_mut().zip(f.iter()).for_each(|(to, f)| *to += f);
        self.frame.add_reactions(p0, force);
    }
    fn add_tangent(&self, disp: &[f64], state: &[f64], kb: &[[f64; 6]; 6], q: &[f64; 6], tangent: &mut [f64]) {
        let s = self.geometry(disp, &NodalRotations::read(state));
        let v = s.deformation();
        let rows = s.rows(&v);
        // Combine the natural rows into basic ones.
        let mut basic = SMatrix::<f64, 6, 12>::zeros();
        for (to, from, sign) in
            [(0, 6, 1.0), (1, 1, 1.0), (2, 4, 1.0), (3, 2, -1.0), (4, 5, -1.0), (5, 3, 1.0), (5, 0, -1.0)]
        {
            let mut row = basic.row_mut(to);
            row += rows.row(from) * sign;
        }
        let kb = SMatrix::<f64, 6, 6>::from_fn(|i, j| kb[i][j]);
        let mut k = basic.transpose() * kb * basic + s.geometric(&rows, &v, &natural(q));
        if self.offsets != (Vector3::zeros(), Vector3::zeros()) {
            let f = Self::face_forces(&rows, q);
            let mut lever = Matrix12x12::identity();
            for (at, arm) in [(0, &s.offsets.0), (6, &s.offsets.1)] {
                block(&mut lever, at, at + 3, &cross(arm), -1.0);
            }
            k = lever.transpose() * k * lever;
            for (at, arm) in [(0, &s.offsets.0), (6, &s.offsets.1)] {
                // The joint offset rotates: (ω × arm) × f.
                let f = f.fixed_rows::<3>(at).into_owned();
                block(&mut k, at + 3, at + 3, &(cross(&f) * cross(arm)), 1.0);
            }
        }
        for (i, row) in tangent.chunks_exact_mut(12).enumerate() {
            row.iter_mut().enumerate().for_each(|(j, t)| *t += k[(i, j)]);
        }
    }
    fn frame(&self) -> &Frame<12, 6> {
        &self.frame
    }
}
