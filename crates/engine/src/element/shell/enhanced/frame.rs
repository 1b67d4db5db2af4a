//! Axes of a shell of three or four nodes: fixed, or following the nodes (Felippa and Haugen, 2005, Computer Methods in
//! Applied Mechanics and Engineering 194, 2285-2335).

use super::super::{Geometry, MAX, NODE, Row};
use crate::element::{ElementError, ElementResult};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// Axes as rows, and the mean of the nodes.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) axes: Matrix3<f64>,
    pub(super) centre: Vector3<f64>,
}

impl Frame {
    /// Axis 1 runs along the side from node 1 to node 2, axis 3 is square to both diagonals or to the triangle.
    pub(super) fn new(nodes: &[Vector3<f64>]) -> ElementResult<Self> {
        let normal = match nodes {
            [a, b, c] => (b - a).cross(&(c - a)),
            [a, b, c, d] => (c - a).cross(&(d - b)),
            _ => return Err(ElementError("a shell has three or four nodes".into())),
        };
        let z = normal.normalize();
        let side = nodes[1] - nodes[0];
        let x = (side - z * side.dot(&z)).normalize();
        let axes = Matrix3::from_rows(&[x.transpose(), z.cross(&x).transpose(), z.transpose()]);
        if !axes.iter().all(|c| c.is_finite()) {
            return Err(ElementError("its nodes lie in a line".into()));
        }
        Ok(Self { axes, centre: nodes.iter().sum::<Vector3<f64>>() / nodes.len() as f64 })
    }

    /// Places of nodes in the axes.
    fn places(&self, nodes: &[Vector3<f64>]) -> [Vector3<f64>; 4] {
        let mut out = [Vector3::zeros(); 4];
        nodes.iter().zip(&mut out).for_each(|(n, out)| *out = self.axes * (n - self.centre));
        out
    }

    /// Corners in the plane, for formulations in these axes.
    pub(super) fn geometry(&self, nodes: &[Vector3<f64>]) -> Geometry {
        let corners = self.places(nodes)[..nodes.len()].iter().map(|p| [p.x, p.y]).collect();
        Geometry { axes: [Vector3::x(), Vector3::y(), Vector3::z()], corners }
    }

    /// The axes in the deformed state: the deformation gradient in the plane at the centre is symmetric in them.
    fn followed(&self, nodes: &[Vector3<f64>], moved: &[Vector3<f64>]) -> ElementResult<Self> {
        let mut next = Self::new(moved)?;
        let (a, b) = (tangents(&self.places(nodes), nodes.len()), tangents(&next.places(moved), nodes.len()));
        // F = B A⁻¹; the positive factor 1/det A does not change the angle.
        let f = |i: usize, j: usize| match j {
            0 => b[0][i] * a[1][1] - b[1][i] * a[0][1],
            _ => b[1][i] * a[0][0] - b[0][i] * a[1][0],
        };
        let (s, c) = (f(1, 0) - f(0, 1)).atan2(f(0, 0) + f(1, 1)).sin_cos();
        let (x, y) = (next.axes.row(0).into_owned(), next.axes.row(1).into_owned());
        next.axes.set_row(0, &(x * c + y * s));
        next.axes.set_row(1, &(y * c - x * s));
        Ok(next)
    }

    /// Turns rows of derivatives by displacements in the axes into rows by global displacements. The nodes of a warped
    /// quadrilateral lie beside the plane and move with it as if on rigid links.
    pub(super) fn to_global(&self, nodes: &[Vector3<f64>], row: &Row) -> Row {
        let places = self.places(nodes);
        let mut out = [0.0; MAX];
        for (i, place) in places.iter().enumerate().take(nodes.len()) {
            let at = NODE * i;
            let force = Vector3::from_column_slice(&row[at..at + 3]);
            let mut moment = Vector3::from_column_slice(&row[at + 3..at + 6]);
            moment.x += place.z * force.y;
            moment.y -= place.z * force.x;
            out[at..at + 3].copy_from_slice(self.axes.tr_mul(&force).as_slice());
            out[at + 3..at + 6].copy_from_slice(self.axes.tr_mul(&moment).as_slice());
        }
        out
    }
}

/// Derivatives of the place by the natural coordinates at the centre, but for a factor.
fn tangents(p: &[Vector3<f64>; 4], nodes: usize) -> [Vector3<f64>; 2] {
    if nodes == 3 { [p[1] - p[0], p[2] - p[0]] } else { [p[1] + p[2] - p[0] - p[3], p[2] + p[3] - p[0] - p[1]] }
}

crate::state_struct! {
    /// State variables of a shell that follows its nodes: the rotation of each node as a quaternion, and the rotations of
    /// the degrees of freedom it belongs to.
    pub(super) struct NodalTurns {
        quaternions: [f64; 16],
        rotations: [f64; 12],
    }
}

impl NodalTurns {
    /// No rotation.
    pub(super) fn none() -> Self {
        let quaternions = std::array::from_fn(|i| if i % 4 == 3 { 1.0 } else { 0.0 });
        Self { quaternions, rotations: [0.0; 12] }
    }

    fn quaternion(&self, node: usize) -> UnitQuaternion<f64> {
        let [i, j, k, w] = std::array::from_fn(|at| self.quaternions[4 * node + at]);
        UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, i, j, k))
    }

    /// Rotation of a node after the increment from the committed degrees of freedom to `u`, taken as a spin.
    fn turned(&self, node: usize, u: &[f64]) -> UnitQuaternion<f64> {
        let from = Vector3::from_column_slice(&self.rotations[3 * node..3 * node + 3]);
        let to = Vector3::from_column_slice(&u[NODE * node + 3..NODE * node + 6]);
        UnitQuaternion::from_scaled_axis(to - from) * self.quaternion(node)
    }

    /// The state for displacements `u`.
    pub(super) fn advanced(&self, nodes: usize, u: &[f64]) -> Self {
        let mut next = *self;
        for node in 0..nodes {
            let q = UnitQuaternion::new_normalize(self.turned(node, u).into_inner());
            next.quaternions[4 * node..4 * node + 4].copy_from_slice(&[q.i, q.j, q.k, q.w]);
            next.rotations[3 * node..3 * node + 3].copy_from_slice(&u[NODE * node + 3..NODE * node + 6]);
        }
        next
    }
}

/// Displacements in axes that follow the nodes.
pub(super) struct Following<'a> {
    pub(super) nodes: &'a [Vector3<f64>],
    pub(super) frame: &'a Frame,
    pub(super) turns: &'a NodalTurns,
}

impl Following<'_> {
    /// The axes at displacements `u`, and the deformational displacements in them.
    pub(super) fn local(&self, u: &Row) -> ElementResult<(Frame, Row)> {
        let n = self.nodes.len();
        let mut moved = [Vector3::zeros(); 4];
        for (i, place) in self.nodes.iter().enumerate() {
            moved[i] = place + Vector3::from_column_slice(&u[NODE * i..NODE * i + 3]);
        }
        let frame = self.frame.followed(self.nodes, &moved[..n])?;
        let quaternion = |m: &Matrix3<f64>| UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*m));
        let (to, from) = (quaternion(&frame.axes), quaternion(&self.frame.axes).inverse());
        let mut local = [0.0; MAX];
        for i in 0..n {
            let place = frame.axes * (moved[i] - frame.centre) - self.frame.axes * (self.nodes[i] - self.frame.centre);
            let turn = (to * self.turns.turned(i, u) * from).scaled_axis();
            local[NODE * i..NODE * i + 3].copy_from_slice(place.as_slice());
            local[NODE * i + 3..NODE * i + 6].copy_from_slice(turn.as_slice());
        }
        Ok((frame, local))
    }

    /// Derivatives of the deformational displacements `local` by a global displacement, with the axes as they are. The
    /// derivative of a rotation vector by a spin is I - Ω/2 + η Ω² (Felippa and Haugen, 2005, equation 100).
    pub(super) fn fixed_axes_column(&self, frame: &Frame, local: &Row, dof: usize) -> Row {
        let (n, mut out) = (self.nodes.len(), [0.0; MAX]);
        let (node, at) = (dof / NODE, dof % NODE);
        let direction = frame.axes.column(at % 3).into_owned();
        if at < 3 {
            for i in 0..n {
                let share = f64::from(u8::from(i == node)) - 1.0 / n as f64;
                out[NODE * i..NODE * i + 3].copy_from_slice((direction * share).as_slice());
            }
            return out;
        }
        let turn = Vector3::from_column_slice(&local[NODE * node + 3..NODE * node + 6]);
        let (angle, spin) = (turn.norm(), turn.cross_matrix());
        let half = 0.5 * angle;
        // The series for small angles, where the quotient loses its digits.
        let eta = if angle < 0.05 {
            let square = angle * angle;
            1.0 / 12.0 + square / 720.0 + square * square / 30240.0
        } else {
            (1.0 - half / half.tan()) / (angle * angle)
        };
        let by_spin = direction - spin * direction * 0.5 + spin * (spin * direction) * eta;
        out[NODE * node + 3..NODE * node + 6].copy_from_slice(by_spin.as_slice());
        out
    }

    /// Global forces of forces in the axes, of which the mean is taken off.
    pub(super) fn global_force(&self, frame: &Frame, local: &Row) -> Row {
        let n = self.nodes.len();
        let part = |i: usize, at: usize| Vector3::from_column_slice(&local[NODE * i + at..NODE * i + at + 3]);
        let mean = (0..n).map(|i| part(i, 0)).sum::<Vector3<f64>>() / n as f64;
        let mut out = [0.0; MAX];
        for i in 0..n {
            let (force, moment) = (frame.axes.tr_mul(&(part(i, 0) - mean)), frame.axes.tr_mul(&part(i, 3)));
            out[NODE * i..NODE * i + 3].copy_from_slice(force.as_slice());
            out[NODE * i + 3..NODE * i + 6].copy_from_slice(moment.as_slice());
        }
        out
    }
}
