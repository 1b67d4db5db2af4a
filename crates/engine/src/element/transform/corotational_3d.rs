//! Corotational transformation in space (Crisfield, 1990; de Souza, 2000, chapter 4).
//!
//! Nodal axes rotate by the increments of the nodal rotations from the committed state, taken as spins. The axes e of
//! the chord follow the line between the ends and the mean of the nodal axes. Basic deformations are the rotations and
//! elongation relative to them. OpenSees sums increments over iterations, which converges to the same with the step
//! size; `by_trials` follows it.

mod geometry;
mod stiffness;

use super::{Frame, Reactions, Transform};
use crate::element::{ElementError, ElementResult, Histories};
use crate::state_struct::StateStruct;
use geometry::Geometry;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use stiffness::{Faces, Rows, offset_stiffness};

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

impl Corotational3d {
    /// Makes the transformation from the undeformed geometry; `by_trials` as in
    /// [`TransformSpec`](super::TransformSpec).
    pub fn new(frame: Frame<12, 6>, offsets: (Vector3<f64>, Vector3<f64>), by_trials: bool) -> Self {
        let along = frame.axes.row(0).transpose() * frame.length;
        Self { line: along - offsets.1 + offsets.0, frame, offsets, by_trials }
    }

    /// Relative displacement of the faces of the joints, and the rotated offsets.
    fn chord(&self, u: &[f64; 12], turns: [&UnitQuaternion<f64>; 2]) -> (Vector3<f64>, (Vector3<f64>, Vector3<f64>)) {
        let offsets = (turns[0] * self.offsets.0, turns[1] * self.offsets.1);
        let faces = (offsets.1 - self.offsets.1) - (offsets.0 - self.offsets.0);
        (vector3(u, 6) - vector3(u, 0) + faces, offsets)
    }

    /// Undeformed vector between the faces of the joints.
    fn undeformed(&self) -> Vector3<f64> {
        self.line + self.offsets.1 - self.offsets.0
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
        let (relative_displacement, offsets) = self.chord(&u, [&qi, &qj]);
        Geometry::new(self.undeformed(), self.frame.length, relative_displacement, [i, j, mean], offsets)
    }
}

/// Forces conjugate to the natural deformations of [`Geometry::deformation`], from basic forces.
fn natural(q: &[f64; 6]) -> [f64; 7] {
    [-q[5], q[1], -q[3], q[5], q[2], -q[4], q[0]]
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
    fn advance(&self, disp: &[f64], h: &mut Histories<'_>) -> ElementResult {
        let from = if self.by_trials { &*h.trial } else { h.committed };
        let (c, u) = (NodalRotations::read(from), self.frame.since_made(disp));
        let next = NodalRotations {
            i: updated_quaternion(&c.i, &c.rotation_i, vector3(&u, 3)),
            j: updated_quaternion(&c.j, &c.rotation_j, vector3(&u, 9)),
            rotation_i: vector3(&u, 3).into(),
            rotation_j: vector3(&u, 9).into(),
        };
        next.write(h.trial);
        let (relative, _) = self.chord(&u, [&turn(&next.i), &turn(&next.j)]);
        let length = (self.undeformed() + relative).norm();
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
        let faces = Rows::of(&s).transposed_times(&natural(q));
        let Faces(nodes) = Faces(faces).at_nodes(&s.offsets);
        force.iter_mut().zip(&nodes).for_each(|(to, f)| *to += f);
        self.frame.add_reactions(p0, force);
    }
    fn add_tangent(&self, disp: &[f64], state: &[f64], kb: &[[f64; 6]; 6], q: &[f64; 6], tangent: &mut [f64]) {
        let s = self.geometry(disp, &NodalRotations::read(state));
        let p = natural(q);
        let rows = Rows::of(&s);
        let mut k = s.geometric(&p);
        rows.add_stiffness(kb, &p, &mut k);
        if self.offsets != (Vector3::zeros(), Vector3::zeros()) {
            k = offset_stiffness(&k, &rows.transposed_times(&p), &s.offsets);
        }
        tangent.iter_mut().zip(k.as_flattened()).for_each(|(t, k)| *t += k);
    }
    fn frame(&self) -> &Frame<12, 6> {
        &self.frame
    }
}
