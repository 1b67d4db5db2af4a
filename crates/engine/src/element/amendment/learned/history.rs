//! Memory of the motion that a law keeps, beside the values of its own parts.

use super::operators::stop;

/// Scales of the motion for which a law was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// Largest absolute deformation U.
    pub deformation: f64,
    /// Speed V: the 98 % quantile where the device moves.
    pub speed: f64,
    /// Length T of the longest motion.
    pub duration: f64,
    /// Largest work D of a stop of stiffness one and of the level below (deformation squared).
    pub work: f64,
    /// Level r of the hysteretic part.
    pub level: f64,
}

crate::state_struct! {
    /// Committed history of one direction.
    pub struct History {
        /// Deformation.
        deformation: f64,
        /// Largest deformation of each side.
        largest: [f64; 2],
        /// Stop of the law's level.
        stop: f64,
        /// Work of that stop.
        work: f64,
        /// Elapsed time.
        time: f64,
        /// Speed of the last step.
        speed: f64,
        /// Compression of the element.
        axial: f64,
        /// Number of steps.
        steps: f64,
        /// Number of steps outside the range of the law.
        outside: f64,
    }
}

impl History {
    /// History after a step of time `dt` to the deformation `u`.
    #[must_use]
    pub fn next(&self, scales: &Scales, u: f64, dt: f64) -> Self {
        let du = u - self.deformation;
        let trial = self.stop + du;
        let stop = stop(self.stop, du, scales.level);
        let speed = if dt > 0.0 { du / dt } else { 0.0 };
        let time = self.time + dt;
        let is_outside = u.abs() > RANGE_MARGIN * scales.deformation
            || speed.abs() > SPEED_MARGIN * scales.speed
            || time > RANGE_MARGIN * scales.duration;
        Self {
            deformation: u,
            largest: [self.largest[0].max(u), self.largest[1].max(-u)],
            stop,
            work: self.work + scales.level * (trial - stop).abs(),
            time,
            speed,
            axial: self.axial,
            steps: self.steps + 1.0,
            outside: self.outside + f64::from(u8::from(is_outside)),
        }
    }

    /// Largest absolute deformation over U, at least a thousandth.
    pub fn largest_of_both(&self, scales: &Scales) -> f64 {
        (self.largest[0].max(self.largest[1]) / scales.deformation).max(1e-3)
    }

    /// Middle of the extremes.
    pub fn middle(&self) -> f64 {
        0.5 * (self.largest[0] - self.largest[1])
    }
}

/// Deformation and time over those of the law from which a step is outside its range, and speed over V.
const RANGE_MARGIN: f64 = 1.0 + 1e-6;
const SPEED_MARGIN: f64 = 1.5;
