//! Concrete of Kent, Scott and Park with debris in its cracks (Stanton and McNiven, 1979).

use crate::material::{Concrete01, MaterialResult, Strain, Strains, Stress, Stresses, UniaxialLaw, finite};
use crate::state_struct::StateStruct;

/// Concrete without tensile strength, in which cracks close before they are shut.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete01Sitc {
    /// The same concrete without debris.
    pub concrete: Concrete01,
    /// Strain at which the debris has no stress.
    pub end: f64,
}

crate::state_struct! {
    /// History of [`Concrete01Sitc`].
    pub struct History {
        /// Least strain.
        least: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Strain of zero stress after unloading.
        zero: f64,
        /// Slope of unloading.
        unloading: f64,
        /// Slope of the debris.
        debris: f64,
        /// Branch: 0 virgin, 1 envelope, 2 unloading, 3 debris, 5 open.
        branch: f64,
    }
}

const ENVELOPE: f64 = 1.0;
const UNLOADING: f64 = 2.0;
const DEBRIS: f64 = 3.0;
const OPEN: f64 = 5.0;

impl Concrete01Sitc {
    /// Slopes and strain of zero stress of unloading from the envelope (Karsan and Jirsa, 1969).
    fn unload(&self, t: &mut History) {
        t.debris = t.stress / (t.least - self.end);
        (t.zero, t.unloading) = self.concrete.unload(t.least, t.stress);
    }

    /// Branch at a strain off the envelope in compression.
    fn in_compression(&self, c: &History, e: f64) -> f64 {
        let loads = e <= c.strain;
        match c.branch {
            ENVELOPE | UNLOADING if loads => UNLOADING,
            ENVELOPE | UNLOADING => {
                if e >= c.zero {
                    OPEN
                } else {
                    UNLOADING
                }
            }
            DEBRIS => DEBRIS,
            _ if !loads => OPEN,
            _ if e <= self.end && c.strain >= self.end => DEBRIS,
            _ if e <= c.zero => UNLOADING,
            _ => OPEN,
        }
    }

    /// Branch in tension, where fibers of sections know the debris.
    fn in_tension(&self, c: &History, e: f64) -> f64 {
        let enters = e <= c.strain && c.branch == OPEN && e <= self.end && c.strain >= self.end;
        if c.branch == DEBRIS || enters { DEBRIS } else { OPEN }
    }

    /// Response. As in OpenSees, debris acts under tensile strains in fibers of sections only.
    fn respond(&self, c: &History, e: f64, fiber: bool) -> MaterialResult<(Stress, History)> {
        let d = e - c.strain;
        let mut t = History { strain: e, ..*c };
        if d.abs() < f64::EPSILON {
            let tangent = match c.branch {
                0.0 => self.concrete.modulus(),
                ENVELOPE => self.concrete.envelope(e).1,
                UNLOADING => c.unloading,
                DEBRIS => c.debris,
                _ => 0.0,
            };
            return Ok((Stress { value: c.stress, tangent, damping: 0.0 }, *c));
        }
        if e < 0.0 && e <= c.least && !(fiber && e >= self.end) {
            let (value, tangent) = self.concrete.envelope(e);
            (t.least, t.stress, t.branch) = (e, value, ENVELOPE);
            self.unload(&mut t);
            return finite(Self::NAME, e, value, tangent, t);
        }
        t.branch = if e >= self.end && (fiber || e < 0.0) {
            OPEN
        } else if e < 0.0 {
            self.in_compression(c, e)
        } else if fiber {
            self.in_tension(c, e)
        } else {
            OPEN
        };
        let (value, tangent) = match (t.branch, c.branch) {
            // A closed branch goes on from the stress; an open one begins at its strain of zero stress.
            (UNLOADING, OPEN) => (c.unloading * (e - c.zero), c.unloading),
            (DEBRIS, OPEN) => (c.debris * (e - self.end), c.debris),
            (UNLOADING, _) => (c.stress + c.unloading * d, c.unloading),
            (DEBRIS, _) => (c.stress + c.debris * d, c.debris),
            _ => (0.0, 0.0),
        };
        t.stress = value;
        finite(Self::NAME, e, value, tangent, t)
    }
}

impl UniaxialLaw for Concrete01Sitc {
    type State = History;
    const NAME: &'static str = "Concrete01WithSITC";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.respond(c, strain.value, false)
    }

    /// Fibers of sections.
    fn update_points(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let points = committed.chunks_exact(History::LEN).zip(next.chunks_exact_mut(History::LEN));
        for (i, ((old, new), e)) in points.zip(strains.value).enumerate() {
            let (s, h) = self.respond(&History::read(old), *e, true)?;
            h.write(new);
            (stresses.value[i], stresses.tangent[i], stresses.damping[i]) = (s.value, s.tangent, s.damping);
        }
        Ok(())
    }

    fn initial_tangent(&self) -> f64 {
        self.concrete.modulus()
    }
}
