//! Displacements of a force-based beam between its ends, and its points of inflection.

use super::curvature_interpolation::CurvatureInterpolation;
use super::member::Member;
use crate::element::Snapshot;
use crate::numeric::dot;
use crate::probe::Probe;
use crate::section::{Resultant, SectionSlot};
use std::ops::RangeInclusive;

/// Names of the responses.
pub(super) const NAMES: [&str; 4] = ["inflectionPoint", "tangentDrift", "sectionDisplacements", "cbdiDisplacements"];

/// First numbers of the paths of the responses.
pub(super) const PATHS: RangeInclusive<u32> = INFLECTION..=AT_PLACE;
const INFLECTION: u32 = 40;
const DRIFT: u32 = 41;
const AT_SECTIONS: u32 = 42;
const AT_PLACE: u32 = 43;

/// Names of the columns of one place.
const DISPLACEMENTS: [&str; 3] = ["ux", "uy", "uz"];

/// Bending of one plane: its moment, the index of its first end moment, and the sign of the deflection from a curvature.
const PLANES: [(Resultant, usize, f64); 2] = [(Resultant::Mz, 1, 1.0), (Resultant::My, 3, -1.0)];

/// Index of the local displacements along y and z, at the first and the second end.
fn across<const N: usize>() -> &'static [(usize, usize)] {
    if N == 6 { &[(1, 4)] } else { &[(1, 7), (2, 8)] }
}

/// Distance of the point without moment from the first end of a beam with two end moments; 0 where they are equal
/// and opposite, or none.
fn inflection_point(first: f64, second: f64, length: f64) -> f64 {
    let sum = first + second;
    // As in OpenSees moments below the round-off of 1 are none.
    if sum.abs() > f64::EPSILON * (1.0 + first.abs() + second.abs()) { first / sum * length } else { 0.0 }
}

impl<const N: usize, const B: usize> Member<N, B> {
    fn planes() -> &'static [(Resultant, usize, f64)] {
        &PLANES[..if N == 6 { 1 } else { 2 }]
    }

    /// Finds a response by its words: `inflectionPoint`, `tangentDrift`, `sectionDisplacements <local>`, and `cbdiDisplacements
    /// $x` at the place x, a fraction of the length. There are no displacements where they are large, or where sections coincide.
    pub(super) fn deflection_probe(&self, words: &[&str]) -> Option<Probe> {
        let each = |names: &[&str]| -> Vec<String> {
            let suffix = if N == 6 { &[""][..] } else { &["_z", "_y"] };
            suffix.iter().flat_map(|s| names.iter().map(move |n| format!("{n}{s}"))).collect()
        };
        let interpolates = || self.is_small() && CurvatureInterpolation::new(&self.points.0).is_some();
        match *words {
            ["inflectionPoint"] => Some(Probe::new(INFLECTION, each(&["inflectionPoint"]))),
            ["tangentDrift"] => Some(Probe::new(DRIFT, each(&["tangentDrift_1", "tangentDrift_2"]))),
            ["sectionDisplacements", ref frame @ ..] if interpolates() => {
                let local = frame.first().is_some_and(|w| matches!(*w, "local" | "-local"));
                let labels = (1..=self.sections.len()).flat_map(|i| DISPLACEMENTS.map(|u| format!("{u}_{i}")));
                Some(Probe { labels: labels.collect(), path: vec![AT_SECTIONS, u32::from(local)] })
            }
            ["cbdiDisplacements", x] if interpolates() => {
                let x = x.parse::<f64>().ok().filter(|x| (0.0..=1.0).contains(x))?.to_bits();
                let path = vec![AT_PLACE, (x >> 32) as u32, x as u32];
                Some(Probe { labels: DISPLACEMENTS.map(str::to_owned).to_vec(), path })
            }
            _ => None,
        }
    }

    /// Reads a response by its path in a state with the basic forces `q`.
    pub(super) fn read_deflection(&self, path: &[u32], q: &[f64; B], s: &Snapshot<'_>, out: &mut [f64]) {
        let end_moments = |at: usize| (q[at], q[at + 1]);
        let point = |at: usize| inflection_point(end_moments(at).0, end_moments(at).1, self.length());
        match *path {
            [INFLECTION] => {
                out.iter_mut().zip(Self::planes()).for_each(|(o, (_, at, _))| *o = point(*at));
            }
            [DRIFT] => {
                for (o, (moment, at, _)) in out.chunks_exact_mut(2).zip(Self::planes()) {
                    o.copy_from_slice(&self.tangent_drift(*moment, point(*at), s.state));
                }
            }
            [AT_SECTIONS, local] => {
                for (o, x) in out.chunks_exact_mut(3).zip(&self.points.0) {
                    o.copy_from_slice(&self.displacement(*x, local == 1, s));
                }
            }
            [AT_PLACE, high, low] => {
                let x = f64::from_bits(u64::from(high) << 32 | u64::from(low));
                out.copy_from_slice(&self.displacement(x, false, s));
            }
            _ => {}
        }
    }

    /// Curvature of each section in the plane of a moment.
    fn curvatures(&self, moment: Resultant, state: &[f64]) -> Vec<f64> {
        let of_section = |section: &SectionSlot| {
            let pairs = section.resultants().iter().zip(section.deformation(state));
            pairs.filter(|(r, _)| **r == moment).map(|(_, e)| e).sum()
        };
        self.sections.iter().map(of_section).collect()
    }

    /// Distances of the point of inflection, at `point` from the first end, from the tangents at both ends: integrals of the
    /// curvature times its distance from the point.
    fn tangent_drift(&self, moment: Resultant, point: f64, state: &[f64]) -> [f64; 2] {
        let mut drift = [0.0; 2];
        for ((_, x, weight), curvature) in self.along().zip(self.curvatures(moment, state)) {
            let lever = x * self.length() - point;
            drift[usize::from(lever > 0.0)] += weight * curvature * lever;
        }
        drift
    }

    /// Displacement of the axis at the place x (a fraction of the length), in global or in local axes: the line between the ends,
    /// the elongation, and the deflection from the chord. In the plane z has none.
    fn displacement(&self, x: f64, local: bool, s: &Snapshot<'_>) -> [f64; 3] {
        let frame = self.transform.frame();
        let u = frame.since_made(s.disp);
        let elongation = self.transform.deformation(s.disp, &s.state[..self.head()])[0];
        let influence = CurvatureInterpolation::new(&self.points.0).map(|c| c.deflection(x)).unwrap_or_default();
        let mut of_point = [dot(&frame.local[0], &u) + x * elongation, 0.0, 0.0];
        let ends = across::<N>().iter().zip(Self::planes());
        for (of_point, ((i, j), (moment, _, sign))) in of_point[1..].iter_mut().zip(ends) {
            let deflection = dot(&influence, &self.curvatures(*moment, s.state)) * self.length() * self.length();
            *of_point = sign * deflection + (1.0 - x) * dot(&frame.local[*i], &u) + x * dot(&frame.local[*j], &u);
        }
        if local {
            return of_point;
        }
        let global = frame.axes.transpose() * nalgebra::Vector3::from(of_point);
        [global.x, global.y, global.z]
    }
}
