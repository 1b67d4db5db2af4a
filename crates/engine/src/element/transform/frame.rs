//! Undeformed geometry of a beam: length, axes, joint offsets, and the linear map to the basic system.

use super::{Ends, Reactions};
use crate::element::axes::{self, AxesError};
use crate::element::dot;
use crate::probe::Probe;
use nalgebra::{Matrix3, Vector3};

/// Undeformed geometry of a beam with `N` degrees of freedom and `B` basic deformations.
#[derive(Clone, Debug)]
pub struct Frame<const N: usize, const B: usize> {
    /// Length between the faces of the joints.
    pub length: f64,
    /// Local axes as rows.
    pub axes: Matrix3<f64>,
    /// Transformation from global nodal displacements to local displacements of the joint faces.
    pub local: [[f64; N]; N],
    /// Derivatives of the basic deformations by the global displacements.
    pub basic: [[f64; N]; B],
    /// Displacements of the nodes when the beam was created.
    pub initial: [f64; N],
    /// Joint offsets at node i and node j in global axes.
    pub offsets: [f64; 6],
}

/// Paths of the local axes as responses.
const AXES: [(&str, u32); 6] = [
    ("xaxis", X_AXIS),
    ("xlocal", X_AXIS),
    ("yaxis", X_AXIS + 1),
    ("ylocal", X_AXIS + 1),
    ("zaxis", Z_AXIS),
    ("zlocal", Z_AXIS),
];
const X_AXIS: u32 = 90;
const Z_AXIS: u32 = 92;
const OFFSETS: u32 = 93;

/// A local axis of a beam, or its joint offsets, as a response by the first word of a recorder.
pub fn axis_probe(word: &str) -> Option<Probe> {
    if matches!(word, "offsets" | "rigidOffsets") {
        return Some(Probe::new(OFFSETS, ["xi", "yi", "zi", "xj", "yj", "zj"]));
    }
    AXES.iter().find(|(name, _)| *name == word).map(|(_, id)| Probe::new(*id, ["x", "y", "z"]))
}

/// Local displacements conjugate to the reactions: axial at i, y at i and j, z at i and j.
fn reaction_rows(n: usize) -> &'static [usize] {
    if n == 6 { &[0, 1, 4] } else { &[0, 1, 7, 2, 8] }
}

/// Joint offsets as a response.
fn listed((i, j): &(Vector3<f64>, Vector3<f64>)) -> [f64; 6] {
    [i.x, i.y, i.z, j.x, j.y, j.z]
}

impl Frame<6, 3> {
    /// Geometry of a beam in the plane. `offsets` are the joint offsets at node i and node j in global axes.
    ///
    /// # Errors
    /// No length.
    pub fn plane(ends: &Ends<'_>, offsets: &(Vector3<f64>, Vector3<f64>)) -> Result<Self, AxesError> {
        let mut initial = [0.0; 6];
        initial.copy_from_slice(ends.disp);
        let initial_translation = |k: usize| Vector3::new(initial[k], initial[k + 1], 0.0);
        let line =
            (ends.place.1 + initial_translation(3) + offsets.1) - (ends.place.0 + initial_translation(0) + offsets.0);
        let axes = axes::from_x_and_y(line, Vector3::new(-line.y, line.x, 0.0))?;
        let mut local = [[0.0; 6]; 6];
        for (at, offset) in [(0, &offsets.0), (3, &offsets.1)] {
            for a in 0..2 {
                local[at + a][at] = axes[(a, 0)];
                local[at + a][at + 1] = axes[(a, 1)];
                // Displacement of a joint face by the nodal rotation: θ x offset.
                local[at + a][at + 2] = axes[(a, 1)] * offset.x - axes[(a, 0)] * offset.y;
            }
            local[at + 2][at + 2] = 1.0;
        }
        let length = line.norm();
        let slope = |out: &mut [f64; 6]| {
            out[1] += 1.0 / length;
            out[4] -= 1.0 / length;
        };
        let mut from_local = [[0.0; 6]; 3];
        from_local[0][0] = -1.0;
        from_local[0][3] = 1.0;
        slope(&mut from_local[1]);
        from_local[1][2] = 1.0;
        slope(&mut from_local[2]);
        from_local[2][5] = 1.0;
        Ok(Self { length, axes, local, basic: product(&from_local, &local), initial, offsets: listed(offsets) })
    }
}

impl Frame<12, 6> {
    /// Geometry of a beam in space. `xz` lies in the local x-z plane.
    ///
    /// # Errors
    /// No length, or `xz` parallel to the beam.
    pub fn space(ends: &Ends<'_>, offsets: &(Vector3<f64>, Vector3<f64>), xz: Vector3<f64>) -> Result<Self, AxesError> {
        let mut initial = [0.0; 12];
        initial.copy_from_slice(ends.disp);
        let initial_translation = |k: usize| Vector3::new(initial[k], initial[k + 1], initial[k + 2]);
        let line =
            (ends.place.1 + initial_translation(6) + offsets.1) - (ends.place.0 + initial_translation(0) + offsets.0);
        let axes = axes::from_x_and_xz(line, xz)?;
        let mut local = [[0.0; 12]; 12];
        for (at, offset) in [(0, &offsets.0), (6, &offsets.1)] {
            // θ x offset = -[offset]ₓ θ
            let lever = axes * -offset.cross_matrix();
            for a in 0..3 {
                for b in 0..3 {
                    local[at + a][at + b] = axes[(a, b)];
                    local[at + 3 + a][at + 3 + b] = axes[(a, b)];
                    local[at + a][at + 3 + b] = lever[(a, b)];
                }
            }
        }
        let length = line.norm();
        let mut from_local = [[0.0; 12]; 6];
        from_local[0][0] = -1.0;
        from_local[0][6] = 1.0;
        // Chord rotation: v/L for rotations about z, -w/L for those about y.
        for (row, rotation, shift, sign) in [(1, 5, 1, 1.0), (2, 11, 1, 1.0), (3, 4, 2, -1.0), (4, 10, 2, -1.0)] {
            from_local[row][rotation] = 1.0;
            from_local[row][shift] += sign / length;
            from_local[row][shift + 6] -= sign / length;
        }
        from_local[5][3] = -1.0;
        from_local[5][9] = 1.0;
        Ok(Self { length, axes, local, basic: product(&from_local, &local), initial, offsets: listed(offsets) })
    }
}

/// Matrix product a b.
fn product<const N: usize, const B: usize>(a: &[[f64; N]; B], b: &[[f64; N]; N]) -> [[f64; N]; B] {
    let mut c = [[0.0; N]; B];
    for (row, out) in a.iter().zip(&mut c) {
        for (x, from) in row.iter().zip(b) {
            if *x != 0.0 {
                out.iter_mut().zip(from).for_each(|(o, f)| *o += x * f);
            }
        }
    }
    c
}

impl<const N: usize, const B: usize> Frame<N, B> {
    /// Writes a local axis or the joint offsets, if the path is that of one; returns true if it is.
    pub fn read_axis(&self, path: &[u32], out: &mut [f64]) -> bool {
        if path.first() == Some(&OFFSETS) {
            out.copy_from_slice(&self.offsets);
            return true;
        }
        let axis = path.first().filter(|id| (X_AXIS..=Z_AXIS).contains(id));
        if let Some(id) = axis {
            out.iter_mut().zip(self.axes.row((id - X_AXIS) as usize).iter()).for_each(|(o, a)| *o = *a);
        }
        axis.is_some()
    }

    /// Displacements since the creation of the beam.
    #[inline]
    pub fn since_made(&self, disp: &[f64]) -> [f64; N] {
        let mut u = [0.0; N];
        for ((u, d), i) in u.iter_mut().zip(disp).zip(&self.initial) {
            *u = d - i;
        }
        u
    }

    /// Basic deformations for small displacements.
    #[inline]
    pub fn deformation(&self, disp: &[f64]) -> [f64; B] {
        let u = self.since_made(disp);
        self.basic.each_ref().map(|row| dot(row, &u))
    }

    /// Adds Aᵀ q with A = `basic`.
    #[inline]
    pub fn add_basic_force(&self, q: &[f64; B], force: &mut [f64]) {
        for (row, q) in self.basic.iter().zip(q) {
            force.iter_mut().zip(row).for_each(|(f, r)| *f += q * r);
        }
    }

    /// Derivatives of the local displacements that the reactions to member loads do work on.
    pub fn reaction_rows(&self) -> Vec<&[f64]> {
        reaction_rows(N).iter().map(|&at| &self.local[at][..]).collect()
    }

    /// Adds the reactions to member loads.
    #[inline]
    pub fn add_reactions(&self, p0: &Reactions, force: &mut [f64]) {
        for (&at, p) in reaction_rows(N).iter().zip(p0) {
            if *p != 0.0 {
                force.iter_mut().zip(&self.local[at]).for_each(|(f, r)| *f += p * r);
            }
        }
    }

    /// Adds Aᵀ k A with A = `basic`.
    pub fn add_basic_stiffness(&self, k: &[[f64; B]; B], tangent: &mut [f64]) {
        let ka = k.map(|row| {
            let mut out = [0.0; N];
            for (kij, a) in row.iter().zip(&self.basic) {
                if *kij != 0.0 {
                    out.iter_mut().zip(a).for_each(|(o, a)| *o += kij * a);
                }
            }
            out
        });
        for (a, ka) in self.basic.iter().zip(&ka) {
            for (row, &ai) in tangent.chunks_exact_mut(N).zip(a) {
                if ai != 0.0 {
                    row.iter_mut().zip(ka).for_each(|(t, k)| *t += ai * k);
                }
            }
        }
    }

    /// Rows of the relative displacement of end i to end j, along local y and z.
    #[inline]
    pub fn across(&self) -> impl Iterator<Item = [f64; N]> + '_ {
        let pairs: &[(usize, usize)] = if N == 6 { &[(1, 4)] } else { &[(1, 7), (2, 8)] };
        pairs.iter().map(|&(i, j)| {
            let mut row = self.local[i];
            row.iter_mut().zip(&self.local[j]).for_each(|(a, b)| *a -= b);
            row
        })
    }

    /// Local end forces from basic forces and reactions, without second-order terms, as recorded.
    pub fn local_force(&self, q: &[f64; B], p0: &Reactions, out: &mut [f64]) {
        let l = self.length;
        if N == 6 {
            let v = (q[1] + q[2]) / l;
            out.copy_from_slice(&[p0[0] - q[0], v + p0[1], q[1], q[0], p0[2] - v, q[2]]);
            return;
        }
        let (vy, vz) = ((q[1] + q[2]) / l, -(q[3] + q[4]) / l);
        let i = [p0[0] - q[0], vy + p0[1], vz + p0[3], -q[5], q[3], q[1]];
        let j = [q[0], p0[2] - vy, p0[4] - vz, q[5], q[4], q[2]];
        out[..6].copy_from_slice(&i);
        out[6..].copy_from_slice(&j);
    }

    /// Tᵀ m T for a local matrix, N x N by rows.
    pub fn global_of_local(&self, m: &[[f64; N]; N]) -> Vec<f64> {
        let mt = product(m, &self.local);
        let mut out = vec![0.0; N * N];
        for (row, mt) in self.local.iter().zip(&mt) {
            for (i, &t) in row.iter().enumerate() {
                out[i * N..(i + 1) * N].iter_mut().zip(mt).for_each(|(o, m)| *o += t * m);
            }
        }
        out
    }
}
