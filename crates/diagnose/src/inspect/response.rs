//! How far the devices of a model move, as the fitted baseline has it.

use crate::inspect::inventory::Device;
use std::collections::BTreeMap;

/// Extent of the motion of a device in one direction, over all fitted runs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// Largest deformation without sign.
    pub e: f64,
    /// Largest force.
    pub q: f64,
    /// Largest speed of deformation.
    pub v: f64,
    /// Work without sign over the run with most of it.
    pub work: f64,
    /// Largest deformation of the positive sign, and least.
    pub range: [f64; 2],
    /// Force at the beginning.
    pub rest: f64,
    /// Least and largest force, with its sign.
    pub forces: [f64; 2],
}

impl Extent {
    /// The larger of two in everything.
    pub fn or(self, b: Self) -> Self {
        let wider = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self {
            e: self.e.max(b.e),
            q: self.q.max(b.q),
            v: self.v.max(b.v),
            work: self.work.max(b.work),
            range: wider(self.range, b.range),
            rest: self.rest.max(b.rest),
            forces: wider(self.forces, b.forces),
        }
    }
}

/// A device in a direction in a run, sampled.
#[derive(Clone, Debug, Default)]
pub struct Watched {
    /// Times.
    pub times: Vec<f64>,
    /// Deformation.
    pub e: Vec<f64>,
    /// Force.
    pub q: Vec<f64>,
}

impl Watched {
    pub(crate) fn extent(&self) -> Extent {
        let finite = |v: &[f64]| v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
        let mut x = Extent { e: finite(&self.e), q: finite(&self.q), ..Extent::default() };
        x.rest = self.q.first().filter(|q| q.is_finite()).map_or(0.0, |q| q.abs());
        let q = || self.q.iter().copied().filter(|q| q.is_finite());
        x.forces = [q().fold(f64::INFINITY, f64::min), q().fold(f64::NEG_INFINITY, f64::max)];
        for i in 1..self.times.len() {
            let (dt, de) = (self.times[i] - self.times[i - 1], self.e[i] - self.e[i - 1]);
            if de.is_finite() && dt > 0.0 {
                x.v = x.v.max((de / dt).abs());
                x.work += (0.5 * (self.q[i] + self.q[i - 1]) * de).abs();
            }
            x.range = [x.range[0].min(self.e[i]), x.range[1].max(self.e[i])];
        }
        x
    }
}

/// All that was watched.
#[derive(Clone, Debug, Default)]
pub struct Scales {
    /// By run, tag and direction.
    pub watched: BTreeMap<(usize, i32, usize), Watched>,
    /// Largest bending moment at the ends of beams, by tag.
    pub moments: BTreeMap<i32, f64>,
}

impl Scales {
    /// Largest force of any device in a direction of displacement.
    pub fn largest_force(&self) -> f64 {
        let forces = self.watched.iter().filter(|((_, _, d), _)| *d <= 3).map(|(_, w)| w.extent().q);
        forces.fold(0.0, f64::max)
    }

    /// Extent of the motion of a group in a direction: the largest of its members, in any run.
    pub fn of(&self, group: &[&Device], direction: usize) -> Option<Extent> {
        let members =
            self.watched.iter().filter(|((_, tag, d), _)| *d == direction && group.iter().any(|g| g.tag == *tag));
        members.map(|(_, w)| w.extent()).reduce(Extent::or)
    }
}
