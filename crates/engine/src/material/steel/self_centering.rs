//! Flag-shaped hysteresis of self-centring braces.

mod opensees;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::Consistent;
use std::fmt;

/// Flag-shaped law with a fuse that slips and then bears (Christopoulos, Tremblay, Kim and Lacerte, 2008).
#[derive(Clone, Debug, PartialEq)]
pub struct SelfCentering<R = Consistent> {
    /// Initial stiffness k₁.
    pub k1: f64,
    /// Stiffness after activation k₂.
    pub k2: f64,
    /// Stress at activation.
    pub activation: f64,
    /// Height of the flag divided by the activation stress, 0 to 1.
    pub beta: f64,
    /// Strain at which the fuse slips; zero for never.
    pub slip: f64,
    /// Strain at which the fuse bears; zero for never.
    pub bearing: f64,
    /// Stiffness in bearing divided by k₁.
    pub bearing_ratio: f64,
    /// Rules of the jumps off the flag and of the slip.
    pub rules: R,
}

/// Rules of [`SelfCentering`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// The elastic range that a step has left comes back to where it was.
    const COMES_BACK: bool = true;

    /// History that a trial state begins with; `steps` counts its step.
    fn begin(committed: &History, _last: &History, steps: f64) -> History {
        History { steps, ..*committed }
    }

    /// Change of the slip in a step of `d` that goes `beyond` the strain of the slip.
    fn slip(d: f64, beyond: f64) -> f64 {
        beyond.copysign(d)
    }

    /// Shift of the elastic range while the fuse slips, and the tangent. `moved` and `tangent` are the values before the step.
    fn slipping(_moved: f64, _tangent: f64, to: f64) -> (f64, f64) {
        (to, 0.0)
    }
}

impl Rules for Consistent {}

crate::state_struct! {
    /// History of [`SelfCentering`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial tangent.
        softening: f64,
        /// Slip of the fuse.
        slip: f64,
        /// Shift of the elastic range in tension and in compression, both positive.
        moved: [f64; 2],
        /// Number of steps; identifies the trial states of the current step.
        steps: f64,
    }
}

impl<R: Rules> SelfCentering<R> {
    /// Stress and tangent on one side outside the elastic range around zero, mirrored in compression. `x` is the
    /// strain minus the slip, `total` the strain.
    fn flag(&self, c: &History, x: f64, total: f64, d: f64, side: usize, t: &mut History) -> (f64, f64) {
        let start = self.activation / self.k1;
        let low = (1.0 - self.beta) * start;
        let on_line = |x: f64| self.activation + (x - start) * self.k2;
        let moved = c.moved[side];
        if self.bearing != 0.0 && total > self.bearing {
            let held = if self.slip != 0.0 && self.slip < self.bearing { self.slip } else { self.bearing };
            let k = self.bearing_ratio * self.k1;
            (on_line(held) + (total - self.bearing) * k, k)
        } else if self.slip != 0.0 && x > self.slip {
            t.slip = c.slip + R::slip(d, x - self.slip);
            let (moved, tangent) = R::slipping(t.moved[side], self.k1 + t.softening, self.slip - start);
            t.moved[side] = moved;
            (on_line(self.slip), tangent)
        } else if x > start + moved {
            t.moved[side] = x - start;
            (on_line(x), self.k2)
        } else if x < low + moved {
            t.moved[side] = x - low;
            ((1.0 - self.beta) * self.activation + (x - low) * self.k2, self.k2)
        } else {
            ((x - moved * (1.0 - self.k2 / self.k1)) * self.k1, self.k1)
        }
    }
}

impl<R: Rules> UniaxialLaw for SelfCentering<R> {
    type State = History;
    const NAME: &'static str = "SelfCentering";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let d = strain.value - c.strain;
        let steps = c.steps + 1.0;
        let mut t = R::begin(c, last, steps);
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: t.stress, tangent: self.k1 + t.softening, damping: 0.0 }, t));
        }
        t.strain = strain.value;
        let x = strain.value - c.slip;
        let (side, s) = if x >= 0.0 { (0, 1.0) } else { (1, -1.0) };
        let elastic = s * x <= (1.0 - self.beta) * self.activation / self.k1;
        if R::COMES_BACK {
            // A flag that is left returns to its initial position.
            t.moved[1 - side] = 0.0;
            if elastic {
                t.moved[side] = 0.0;
            }
        }
        let (value, tangent) = if elastic {
            (self.k1 * x, self.k1)
        } else {
            let (stress, tangent) = self.flag(c, s * x, s * strain.value, d, side, &mut t);
            (s * stress, tangent)
        };
        (t.stress, t.softening) = (value, tangent - self.k1);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.k1
    }
}
