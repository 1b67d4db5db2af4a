//! Flag-shaped hysteresis of self-centring braces.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// Flag-shaped law with a fuse that slips and then bears (Christopoulos, Tremblay, Kim and Lacerte, 2008).
#[derive(Clone, Debug, PartialEq)]
pub struct SelfCentering {
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
    /// As in OpenSees, a flag keeps its shift after a jump to the elastic range around zero, or after a trial on it.
    /// A step that begins to slip slips as a whole, and slip does not change the tangent.
    pub compat: bool,
}

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

impl SelfCentering {
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
            if self.compat {
                t.slip = c.slip + d;
                return (on_line(self.slip), self.k1 + t.softening);
            }
            t.slip = c.slip + (x - self.slip).copysign(d);
            t.moved[side] = self.slip - start;
            (on_line(self.slip), 0.0)
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

impl UniaxialLaw for SelfCentering {
    type State = History;
    const NAME: &'static str = "SelfCentering";

    fn update(&self, committed: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let d = strain.value - c.strain;
        let steps = c.steps + 1.0;
        let mut t = if self.compat && last.steps == steps { *last } else { History { steps, ..*c } };
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: t.stress, tangent: self.k1 + t.softening, damping: 0.0 }, t));
        }
        t.strain = strain.value;
        let x = strain.value - c.slip;
        let (side, s) = if x >= 0.0 { (0, 1.0) } else { (1, -1.0) };
        let elastic = s * x <= (1.0 - self.beta) * self.activation / self.k1;
        if !self.compat {
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
