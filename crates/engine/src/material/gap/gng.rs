//! Grip 'n' grab: a ratcheting tension device (Cook, Rodgers, MacRae and Chase, 2018,
//! <https://doi.org/10.1061/(ASCE)ST.1943-541X.0002042>).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// A device that yields in tension, has no force in compression, and grips anew at every tooth that it passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Gng {
    /// Elastic stiffness.
    pub e: f64,
    /// Yield force.
    pub yield_stress: f64,
    /// Pitch of the teeth.
    pub pitch: f64,
    /// Hardening ratio, between -1 and 1.
    pub eta: f64,
}

crate::state_struct! {
    /// History of [`Gng`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Strain at which the device grips.
        grip: f64,
        /// Strain of yield minus that of the virgin device.
        yield_shift: f64,
        /// Yield stress minus that of the virgin device.
        hardened: f64,
    }
}

impl UniaxialLaw for Gng {
    type State = History;
    const NAME: &'static str = "GNG";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let yield_stress = self.yield_stress + c.hardened;
        let first = self.yield_stress / self.e;
        let yield_strain = first + c.yield_shift;
        let mut t = History { strain: e, ..*c };
        let loads = e > c.strain;
        let (value, tangent) = if loads && e >= yield_strain {
            (yield_stress + self.eta * self.e * (e - yield_strain), self.eta * self.e)
        } else if e <= c.grip {
            (0.0, 0.0)
        } else {
            (self.e * (e - c.grip), self.e)
        };
        t.stress = value;
        if loads {
            if e >= yield_strain {
                t.grip = e - value / self.e;
            }
        } else if e <= c.grip {
            // One tooth a step.
            if e < c.grip - self.pitch {
                t.grip = c.grip - self.pitch;
                t.yield_shift = t.grip + yield_stress / self.e - first;
            }
        } else if c.stress > yield_stress {
            t.hardened = c.stress - self.yield_stress;
            t.yield_shift = c.grip + c.stress / self.e - first;
        }
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
