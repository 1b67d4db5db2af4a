//! Motion and force of the devices in the fitted baseline, and their ranges.

use super::inventory::Device;
use std::collections::BTreeMap;

/// Range of a device's response in one direction, over all fitted runs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ResponseRange {
    /// Largest absolute deformation, length or angle.
    pub(crate) deformation: f64,
    /// Largest absolute force, force or moment.
    pub(crate) force: f64,
    /// Largest absolute rate of deformation, 1/s.
    pub(crate) speed: f64,
    /// Absolute work over the run with most of it.
    pub(crate) work: f64,
    /// Least deformation, at most 0, and largest, at least 0.
    pub(crate) deformation_bounds: [f64; 2],
    /// Absolute force of the first sample.
    pub(crate) initial_force: f64,
    /// Least and largest force.
    pub(crate) force_bounds: [f64; 2],
}

impl ResponseRange {
    /// The smallest range that contains both.
    pub(crate) fn envelope(self, b: Self) -> Self {
        Self {
            deformation: self.deformation.max(b.deformation),
            force: self.force.max(b.force),
            speed: self.speed.max(b.speed),
            work: self.work.max(b.work),
            deformation_bounds: wider(self.deformation_bounds, b.deformation_bounds),
            initial_force: self.initial_force.max(b.initial_force),
            force_bounds: wider(self.force_bounds, b.force_bounds),
        }
    }
}

/// Sampled response of a device in one direction in one run; the three series have one length.
#[derive(Clone, Debug, Default)]
pub(crate) struct ResponseHistory {
    /// Times, s.
    pub(crate) times: Vec<f64>,
    /// Deformation, length or angle.
    pub(crate) deformation: Vec<f64>,
    /// Force or moment.
    pub(crate) force: Vec<f64>,
}

impl ResponseHistory {
    /// Its range; samples that are not finite are left out.
    pub(crate) fn range(&self) -> ResponseRange {
        let largest = |v: &[f64]| v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
        let mut range = ResponseRange {
            deformation: largest(&self.deformation),
            force: largest(&self.force),
            ..ResponseRange::default()
        };
        range.initial_force = self.force.first().filter(|q| q.is_finite()).map_or(0.0, |q| q.abs());
        let forces = || self.force.iter().copied().filter(|q| q.is_finite());
        range.force_bounds = [forces().fold(f64::INFINITY, f64::min), forces().fold(f64::NEG_INFINITY, f64::max)];
        for i in 1..self.times.len() {
            let (dt, de) = (self.times[i] - self.times[i - 1], self.deformation[i] - self.deformation[i - 1]);
            if de.is_finite() && dt > 0.0 {
                range.speed = range.speed.max((de / dt).abs());
                range.work += (0.5 * (self.force[i] + self.force[i - 1]) * de).abs();
            }
            let [low, high] = range.deformation_bounds;
            range.deformation_bounds = [low.min(self.deformation[i]), high.max(self.deformation[i])];
        }
        range
    }
}

/// Responses of a model in the fitted runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct ResponseRanges {
    /// Histories of devices by run, tag and direction.
    pub(crate) histories: BTreeMap<(usize, i32, usize), ResponseHistory>,
    /// Largest absolute bending moment at the ends of beams, by tag.
    pub(crate) end_moments: BTreeMap<i32, f64>,
    /// Motions of nodes with mass against the ground, by tag and degree of freedom.
    pub(crate) node_motions: BTreeMap<(i32, usize), NodeMotion>,
}

/// Range of the motion of a node in a translation.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct NodeMotion {
    /// Largest absolute velocity, length/s.
    pub(crate) velocity: f64,
    /// Largest absolute acceleration, length/s².
    pub(crate) acceleration: f64,
    /// Least displacement, at most 0, and largest, at least 0.
    pub(crate) displacement_bounds: [f64; 2],
}

impl NodeMotion {
    /// The smallest range that contains both.
    pub(crate) fn envelope(self, b: Self) -> Self {
        Self {
            velocity: self.velocity.max(b.velocity),
            acceleration: self.acceleration.max(b.acceleration),
            displacement_bounds: wider(self.displacement_bounds, b.displacement_bounds),
        }
    }

    /// Largest absolute displacement.
    pub(crate) fn displacement(self) -> f64 {
        self.displacement_bounds[1].max(-self.displacement_bounds[0])
    }
}

/// The smallest interval that contains both.
fn wider(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

impl ResponseRanges {
    /// Largest absolute force of any device in a translation.
    pub(crate) fn largest_force(&self) -> f64 {
        let forces = self.histories.iter().filter(|((_, _, d), _)| *d <= 3).map(|(_, h)| h.range().force);
        forces.fold(0.0, f64::max)
    }

    /// Range of the device and run with the most work in a translation.
    pub(crate) fn largest_work(&self) -> Option<ResponseRange> {
        let ranges = self.histories.iter().filter(|((_, _, d), _)| *d <= 3).map(|(_, h)| h.range());
        ranges.max_by(|a, b| a.work.total_cmp(&b.work))
    }

    /// Envelope over devices and runs in a direction; none where no device has it.
    pub(crate) fn of(&self, devices: &[&Device], direction: usize) -> Option<ResponseRange> {
        let members =
            self.histories.iter().filter(|((_, tag, d), _)| *d == direction && devices.iter().any(|g| g.tag == *tag));
        members.map(|(_, h)| h.range()).reduce(ResponseRange::envelope)
    }
}
