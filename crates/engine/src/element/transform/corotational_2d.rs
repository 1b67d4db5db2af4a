//! Corotational transformation in the plane (Crisfield, 1991, chapter 7; Filippou and Fenves, 2004).

use super::{Frame, Reactions, Transform};
use crate::element::{ElementError, ElementResult, Histories, add_outer, dot};

/// Corotational transformation in the plane: the basic system rotates with the chord.
#[derive(Clone, Debug)]
pub struct Corotational2d(pub Frame<6, 3>);

/// The deformed chord.
struct Chord {
    /// Length.
    length: f64,
    /// Direction cosine and sine in local axes.
    cos: f64,
    sin: f64,
    /// Local displacements.
    local: [f64; 6],
}

impl Corotational2d {
    fn chord(&self, disp: &[f64]) -> Chord {
        let u = self.0.since_made(disp);
        let local = self.0.local.each_ref().map(|row| dot(row, &u));
        let (dx, dy) = (self.0.length + local[3] - local[0], local[4] - local[1]);
        let length = dx.hypot(dy);
        Chord { length, cos: dx / length, sin: dy / length, local }
    }

    /// Derivatives of the basic deformations by the local displacements.
    fn basic_of_local(c: &Chord) -> [[f64; 6]; 3] {
        let (s, o) = (c.sin / c.length, c.cos / c.length);
        let turn = [-s, o, 0.0, s, -o, 0.0];
        let mut rows = [[-c.cos, -c.sin, 0.0, c.cos, c.sin, 0.0], turn, turn];
        rows[1][2] = 1.0;
        rows[2][5] = 1.0;
        rows
    }

    /// Global components of a row in local axes.
    fn global(&self, row: &[f64; 6]) -> [f64; 6] {
        let mut out = [0.0; 6];
        for (x, t) in row.iter().zip(&self.0.local) {
            out.iter_mut().zip(t).for_each(|(o, t)| *o += x * t);
        }
        out
    }
}

impl Transform<6, 3> for Corotational2d {
    fn length(&self) -> f64 {
        self.0.length
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn is_small(&self) -> bool {
        false
    }
    fn advance(&self, disp: &[f64], _: &mut Histories<'_>) -> ElementResult {
        // Negated comparison, so that NaN is an error.
        if self.chord(disp).length > 0.0 { Ok(()) } else { Err(ElementError("the ends of the beam have met".into())) }
    }
    fn deformation(&self, disp: &[f64], _: &[f64]) -> [f64; 3] {
        let c = self.chord(disp);
        let chord_rotation = c.sin.atan2(c.cos);
        [c.length - self.0.length, c.local[2] - chord_rotation, c.local[5] - chord_rotation]
    }
    /// Member loads keep the direction of the undeformed beam, as in OpenSees.
    fn add_force(&self, disp: &[f64], _: &[f64], q: &[f64; 3], p0: &Reactions, force: &mut [f64]) {
        let c = self.chord(disp);
        for (row, q) in Self::basic_of_local(&c).iter().zip(q) {
            force.iter_mut().zip(self.global(row)).for_each(|(f, r)| *f += q * r);
        }
        self.0.add_reactions(p0, force);
    }
    fn add_tangent(&self, disp: &[f64], _: &[f64], kb: &[[f64; 3]; 3], q: &[f64; 3], tangent: &mut [f64]) {
        let c = self.chord(disp);
        let rows = Self::basic_of_local(&c).map(|row| self.global(&row));
        for (a, k) in rows.iter().zip(kb) {
            for (b, k) in rows.iter().zip(k) {
                for (i, ai) in a.iter().enumerate() {
                    tangent[6 * i..6 * i + 6].iter_mut().zip(b).for_each(|(t, b)| *t += k * ai * b);
                }
            }
        }
        // With r for elongation and z across, the geometric stiffness is N/L z zᵀ + (M1 + M2)/L² (r zᵀ + z rᵀ).
        let r = rows[0];
        let z = self.global(&[c.sin, -c.cos, 0.0, -c.sin, c.cos, 0.0]);
        add_outer(tangent, &z, q[0] / c.length);
        let m = (q[1] + q[2]) / (c.length * c.length);
        for i in 0..6 {
            for j in 0..6 {
                tangent[6 * i + j] += m * (r[i] * z[j] + z[i] * r[j]);
            }
        }
    }
    fn frame(&self) -> &Frame<6, 3> {
        &self.0
    }
}
