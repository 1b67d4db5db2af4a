//! Elastic cable under a uniform load: `CatenaryCable` (Thai and Kim, 2011, <https://doi.org/10.1016/j.finel.2010.10.005>).

use super::load::ElementLoad;
use super::{
    Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
};
use crate::element::roles::{ElementLoads, Inertia, Roles};
use crate::probe::Probe;
use nalgebra::{Matrix3, Vector3};

/// Number of degrees of freedom: three displacements at each end.
const DOFS: usize = 6;
/// Largest number of iterations.
const MAX_ITERATIONS: usize = 100;
/// First guesses of the sag: of a tight cable, and of one that hangs vertically.
const SAG: [f64; 2] = [0.2, 1e6];
/// Sag from which the hyperbolic cotangent is 1.
const LARGE_SAG: f64 = 10.0;

/// A cable between two points with three displacements each.
#[derive(Clone, Debug, PartialEq)]
pub struct CatenaryCable {
    /// Coordinates of both ends.
    pub ends: [Vector3<f64>; 2],
    /// Weight per length along z before a load on the element replaces it.
    pub weight: f64,
    /// Axial stiffness E A.
    pub stiffness: f64,
    /// Length without stress.
    pub length: f64,
    /// Elongation by temperature.
    pub expansion: f64,
    /// Mass per length.
    pub rho: f64,
    /// Mass matrix of a bar in place of one at the nodes.
    pub consistent: bool,
    /// Largest error of the position of end j, as a part of the length.
    pub tolerance: f64,
    /// Number of parts of each correction.
    pub parts: usize,
}

impl CatenaryCable {
    /// Load per length from the load variables.
    fn load(&self, load: &[f64]) -> Vector3<f64> {
        if load[3] == 0.0 { Vector3::new(0.0, 0.0, self.weight) } else { Vector3::new(load[0], load[1], load[2]) }
    }

    /// Vector from end i to end j of a cable with the force `f` at end i.
    fn span(&self, f: &Vector3<f64>, load: &Vector3<f64>) -> Vector3<f64> {
        let (length, w, a) = (self.length, load.norm(), f.dot(load));
        let (t1, t2) = (f.norm(), (load * length + f).norm());
        let log = ((a / w + t1) / (length * w + a / w + t2)).ln();
        let heat = (1.0 + self.expansion) / (w * w * w);
        let elastic = f * (-length / self.stiffness) - load * (length * length / (2.0 * self.stiffness));
        elastic + heat * (load * (w * (t1 - t2)) + (f * (w * w) - load * a) * log)
    }

    /// Derivatives of the span by the force.
    fn flexibility(&self, f: &Vector3<f64>, load: &Vector3<f64>) -> Matrix3<f64> {
        let (length, w, a) = (self.length, load.norm(), f.dot(load));
        let other = -f - load * length;
        let (t1, t2) = (f.norm(), other.norm());
        let log = ((a / w + t1) / (a / w + t2 + length * w)).ln();
        let heat = (1.0 + self.expansion) / (w * w * w);
        Matrix3::from_fn(|i, j| {
            let (wi, wj) = (load[i], load[j]);
            let ends = (w * f[j] + wj * (length * w + t2)) / (t2 * (length * w * w + a + w * t2))
                - (w * f[j] + wj * t1) / (t1 * (a + w * t1));
            let b1 = -w * wi * (other[j] / t2 + f[j] / t1) + (w * w * f[i] - a * wi) * ends;
            let (b0, b2) = if i == j { (-length / self.stiffness, wi * wi - w * w) } else { (0.0, wi * wj) };
            b0 - heat * (b1 + b2 * log)
        })
    }

    /// First guess of the force at end i.
    fn guess(&self, span: &Vector3<f64>, load: &Vector3<f64>) -> Vector3<f64> {
        let (length, w) = (self.length, load.z);
        let plan = span.x * span.x + span.y * span.y;
        let sag = if plan == 0.0 {
            SAG[1]
        } else if length * length <= plan + span.z * span.z {
            SAG[0]
        } else {
            (3.0 * ((length * length - span.z * span.z) / plan) - 1.0).sqrt()
        };
        let horizontal = w * plan.sqrt() / (2.0 * sag);
        let slope = if sag > LARGE_SAG { 1.0 } else { sag.cosh() / sag.sinh() };
        let angle = span.y.atan2(span.x);
        Vector3::new(angle.cos() * horizontal, angle.sin() * horizontal, -(w / 2.0) * (-span.z * slope + length))
    }

    /// Force at end i for a span.
    fn solve(&self, span: &Vector3<f64>, load: &Vector3<f64>) -> ElementResult<Vector3<f64>> {
        let failed =
            || ElementError("its shape is not found: the load is zero, or the cable far too long or short".into());
        let mut next = self.guess(span, load);
        let mut f = next;
        let mut gap = span - self.span(&f, load);
        for _ in 0..=MAX_ITERATIONS {
            let error = gap.amax() / self.length;
            if !error.is_finite() {
                return Err(failed());
            }
            if error <= self.tolerance {
                return Ok(f);
            }
            gap = span - self.span(&next, load);
            for _ in 0..self.parts {
                f = next;
                let change = self.flexibility(&f, load).lu().solve(&gap).ok_or_else(failed)?;
                next += change / self.parts as f64;
            }
        }
        Err(failed())
    }

    /// Adds the stiffness for a force at end i.
    fn add_stiffness(&self, f: &Vector3<f64>, load: &Vector3<f64>, tangent: &mut [f64]) {
        let Some(k) = self.flexibility(f, load).try_inverse() else { return };
        for i in 0..DOFS {
            for j in 0..DOFS {
                let sign = if (i < 3) == (j < 3) { -1.0 } else { 1.0 };
                tangent[i * DOFS + j] += sign * k[(i % 3, j % 3)];
            }
        }
    }

    fn span_of(&self, disp: &[f64]) -> Vector3<f64> {
        let at = |end: usize| self.ends[end] + Vector3::from_column_slice(&disp[3 * end..3 * end + 3]);
        at(1) - at(0)
    }
}

crate::watches_columns!(CatenaryCable => nothing);

impl Element for CatenaryCable {
    fn class(&self) -> Class {
        Class::new("CatenaryCable", 169)
    }
    fn dofs(&self) -> usize {
        DOFS
    }
    fn state_len(&self) -> usize {
        0
    }
    fn init(&self, _: &mut [f64]) {}
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: false, symmetric: true, viscous: false, elapses: false, rayleigh: true }
    }

    fn respond(&self, motion: &ElementInput<'_>, _: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        let load = self.load(motion.load);
        let f = self.solve(&self.span_of(motion.disp), &load)?;
        let other = -f - load * self.length;
        output.force[..3].copy_from_slice(f.as_slice());
        output.force[3..].copy_from_slice(other.as_slice());
        if let Some(tangent) = output.tangent {
            self.add_stiffness(&f, &load, tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        let load = Vector3::new(0.0, 0.0, self.weight);
        if let Ok(f) = self.solve(&(self.ends[1] - self.ends[0]), &load) {
            self.add_stiffness(&f, &load, tangent);
        }
    }

    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), loads: Some(self), ..Roles::default() }
    }

    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn probe_names(&self) -> Vec<&'static str> {
        vec![]
    }
    fn read(&self, _: &[u32], _: &Snapshot<'_>, _: &mut [f64]) {}
}

impl Inertia for CatenaryCable {
    fn mass(&self) -> Mass {
        let m = self.rho * self.length;
        if m == 0.0 {
            return Mass::None;
        }
        if !self.consistent {
            return Mass::Lumped(vec![0.5 * m; DOFS]);
        }
        let mut matrix = vec![0.0; DOFS * DOFS];
        for i in 0..DOFS {
            matrix[i * (DOFS + 1)] = m / 3.0;
            matrix[i * DOFS + (i + 3) % DOFS] = m / 6.0;
        }
        Mass::Consistent(matrix)
    }
}

impl ElementLoads for CatenaryCable {
    fn load_len(&self) -> usize {
        4
    }
    /// A uniform load replaces the weight: its parts along local y, z and x are those along global x, y and z.
    fn add_load(&self, load: &ElementLoad, factor: f64, words: &mut [f64]) -> ElementResult {
        match load {
            ElementLoad::Distributed { span: (0.0, 1.0), y, z, x } if y.0 == y.1 && z.0 == z.1 && x.0 == x.1 => {
                words.copy_from_slice(&[factor * y.0, factor * z.0, factor * x.0, 1.0]);
                Ok(())
            }
            _ => Err(ElementError("CatenaryCable takes uniform loads only".into())),
        }
    }
}
