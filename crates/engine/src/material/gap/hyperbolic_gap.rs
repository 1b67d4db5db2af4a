//! Backfill of an abutment: a hyperbolic envelope in compression behind a gap (Duncan and Mokwa, 2001; Wilson and Elgamal, 2010).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Force of an abutment over the displacement of its backwall.
#[derive(Clone, Debug, PartialEq)]
pub struct HyperbolicGap<R = Consistent> {
    /// Initial stiffness of the envelope.
    pub kmax: f64,
    /// Stiffness of unloading and reloading.
    pub kur: f64,
    /// Failure ratio.
    pub rf: f64,
    /// Ultimate force, negative.
    pub fult: f64,
    /// Gap, negative.
    pub gap: f64,
    /// Rules of trial states.
    pub rules: R,
}

crate::state_struct! {
    /// History of [`HyperbolicGap`].
    pub struct History {
        /// Displacement.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent; read after the first step.
        tangent: f64,
        /// Smallest displacement.
        least: f64,
        /// Displacement at which reloading begins.
        reloading: f64,
        /// Number of steps.
        steps: f64,
    }
}

/// Rules of [`HyperbolicGap`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Takes over what the last trial of a step leaves to the next one.
    fn begin(_last: &History, _t: &mut History) {}
}

impl Rules for Consistent {}

/// The smallest displacement, the start of reloading and the force of a trial state stay for the later trial states of the step.
impl Rules for OpenSees {
    fn begin(last: &History, t: &mut History) {
        if last.steps == t.steps {
            *t = History { strain: t.strain, ..*last };
        }
    }
}

impl<R: Rules> HyperbolicGap<R> {
    /// Force and slope on the envelope.
    fn envelope(&self, x: f64) -> (f64, f64) {
        if x > self.gap {
            return (0.0, 0.0);
        }
        let past = x - self.gap;
        let flexibility = 1.0 / self.kmax + self.rf * past / self.fult;
        (past / flexibility, 1.0 / (self.kmax * flexibility.powi(2)))
    }

    /// Force and tangent off the envelope.
    fn inside(&self, d: f64, c: &History, t: &mut History) -> (f64, f64) {
        let force = c.stress + self.kur * d;
        if d > 0.0 {
            if t.least == c.strain {
                t.reloading = t.least - c.stress / self.kur;
            }
            if force > 0.0 { (0.0, 0.0) } else { (force, self.kur) }
        } else if t.strain > t.reloading {
            (0.0, 0.0)
        } else if t.strain < t.reloading && c.stress == 0.0 {
            (self.kur * (t.strain - t.reloading), self.kur)
        } else {
            (force, self.kur)
        }
    }
}

impl<R: Rules> UniaxialLaw for HyperbolicGap<R> {
    type State = History;
    const NAME: &'static str = "HyperbolicGapMaterial";

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let mut t = History { strain: strain.value, steps: c.steps + 1.0, ..*c };
        if c.steps == 0.0 {
            t.tangent = self.kmax;
        }
        R::begin(last, &mut t);
        let d = strain.value - c.strain;
        if strain.value <= c.least {
            t.least = strain.value;
            (t.stress, t.tangent) = self.envelope(strain.value);
        } else if d != 0.0 {
            (t.stress, t.tangent) = self.inside(d, c, &mut t);
        }
        Ok((Stress { value: t.stress, tangent: t.tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.kmax
    }
}
