//! Engineered cementitious composite, ductile in tension (Han, Feenstra and Billington, 2003).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Exponent of the curve before the peak in compression.
const PRE_PEAK: f64 = 5.0;

/// A composite that hardens, then softens in tension.
#[derive(Clone, Debug, PartialEq)]
pub struct Ecc01 {
    /// Tensile stress and strain at cracking, then at the peak.
    pub tension: [[f64; 2]; 2],
    /// Ultimate tensile strain.
    pub ultimate: f64,
    /// Compressive strength and its strain, negative.
    pub peak: [f64; 2],
    /// Ultimate compressive strain, negative.
    pub crushed: f64,
    /// Exponents of unloading in hardening and in softening tension, and in compression.
    pub unloading: [f64; 3],
    /// Exponent of softening in compression.
    pub softening: f64,
    /// Part of the strain beyond cracking that stays, in tension and in compression.
    pub permanent: [f64; 2],
}

crate::state_struct! {
    /// History of [`Ecc01`].
    pub struct History {
        /// Least and largest strain.
        extreme: [f64; 2],
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Strain and stress at the last turn.
        turn: [f64; 2],
        /// Branch: one of the constants of [`branch`].
        branch: f64,
    }
}

/// Branches of the law; those in compression are negative, 0 is the virgin state.
mod branch {
    pub(super) const ENVELOPE: f64 = 1.0;
    pub(super) const HARDENING: f64 = 2.0;
    pub(super) const SOFTENING: f64 = 3.0;
    pub(super) const UNLOADS_HARDENING: f64 = 5.0;
    pub(super) const UNLOADS_SOFTENING: f64 = 6.0;
    pub(super) const RELOADS_HARDENING: f64 = 7.0;
    pub(super) const RELOADS_SOFTENING: f64 = 8.0;
    pub(super) const OPEN: f64 = 9.0;
    pub(super) const CRUSHING: f64 = -2.0;
    pub(super) const UNLOADS_CRUSHED: f64 = -4.0;
    pub(super) const RELOADS_CRUSHED: f64 = -5.0;
    pub(super) const CLOSED: f64 = -6.0;
}

/// A branch between the extreme strain of a side and the other side.
struct Inside {
    branch: f64,
    /// Strain and stress of the turn that it begins at.
    turn: [f64; 2],
    /// Permanent strain.
    permanent: f64,
    /// Stress at the extreme strain.
    at_end: f64,
}

impl Inside {
    /// A branch without a permanent strain, from the last turn.
    fn begun(branch: f64, c: &History) -> Self {
        Self { branch, turn: c.turn, permanent: 0.0, at_end: 0.0 }
    }
}

impl Ecc01 {
    fn envelope(&self, e: f64) -> (f64, f64) {
        let [[st0, et0], [st1, et1]] = self.tension;
        let [sc0, ec0] = self.peak;
        if e > 0.0 {
            let line = |from: (f64, f64), slope: f64| (from.1 + slope * (e - from.0), slope);
            return if e < et0 {
                line((0.0, 0.0), st0 / et0)
            } else if e < et1 {
                line((et0, st0), (st1 - st0) / (et1 - et0))
            } else if e < self.ultimate {
                line((et1, st1), -st1 / (self.ultimate - et1))
            } else {
                (0.0, 0.0)
            };
        }
        if e > ec0 {
            let x = e / ec0;
            let d = PRE_PEAK - 1.0 + x.powf(PRE_PEAK);
            (sc0 * PRE_PEAK * x * (1.0 / d), sc0 / ec0 * PRE_PEAK * (d - PRE_PEAK * x.powf(PRE_PEAK)) / (d * d))
        } else if e > self.crushed {
            let (x, length) = ((e - self.crushed) / (ec0 - self.crushed), ec0 - self.crushed);
            (sc0 * x.powf(self.softening), self.softening * sc0 * x.powf(self.softening - 1.0) / length)
        } else {
            (0.0, 0.0)
        }
    }

    /// Branch in tension below the largest strain.
    fn inside_tension(&self, c: &History, e: f64, largest: f64) -> Inside {
        use branch::*;
        let [[st0, et0], [st1, et1]] = self.tension;
        if largest <= et0 {
            return Inside::begun(ENVELOPE, c);
        }
        if largest > self.ultimate {
            return Inside::begun(if e <= self.ultimate { OPEN } else { ENVELOPE }, c);
        }
        let hardening = largest <= et1;
        let (permanent, at_end) = if hardening {
            (self.permanent[0] * (largest - et0), st0 + (st1 - st0) * (largest - et0) / (et1 - et0))
        } else {
            (self.permanent[0] * (et1 - et0), st1 * (1.0 - (largest - et1) / (self.ultimate - et1)))
        };
        if e <= permanent {
            return Inside { branch: OPEN, turn: c.turn, permanent, at_end };
        }
        let [envelope, unloads, reloads] = if hardening {
            [HARDENING, UNLOADS_HARDENING, RELOADS_HARDENING]
        } else {
            [SOFTENING, UNLOADS_SOFTENING, RELOADS_SOFTENING]
        };
        let mut turn = c.turn;
        let here = [c.strain, c.stress];
        if e <= c.strain {
            if c.branch == envelope {
                turn = [largest, at_end];
            } else if c.branch == reloads {
                turn = here;
            }
            return Inside { branch: unloads, turn, permanent, at_end };
        }
        if c.branch == unloads {
            turn = here;
        } else if c.branch == OPEN || hardening && c.branch <= -1.0 {
            turn = [permanent, 0.0];
        }
        Inside { branch: reloads, turn, permanent, at_end }
    }

    /// The same in compression above the least strain.
    fn inside_compression(&self, c: &History, e: f64, least: f64) -> Inside {
        use branch::*;
        let [sc0, ec0] = self.peak;
        if least >= ec0 {
            return Inside::begun(-ENVELOPE, c);
        }
        if least < self.crushed {
            return Inside::begun(if e >= self.crushed { CLOSED } else { -SOFTENING }, c);
        }
        let permanent = self.permanent[1] * (least - ec0);
        let at_end = sc0 * ((least - self.crushed) / (ec0 - self.crushed)).powf(self.softening);
        if e >= permanent {
            return Inside { branch: CLOSED, turn: c.turn, permanent, at_end };
        }
        let (mut turn, here) = (c.turn, [c.strain, c.stress]);
        if e >= c.strain {
            if c.branch == CRUSHING {
                turn = [least, at_end];
            } else if c.branch == RELOADS_CRUSHED {
                turn = here;
            }
            return Inside { branch: UNLOADS_CRUSHED, turn, permanent, at_end };
        }
        if c.branch == UNLOADS_CRUSHED {
            turn = here;
        } else if c.branch == CLOSED || c.branch >= 1.0 {
            turn = [permanent, 0.0];
        }
        Inside { branch: RELOADS_CRUSHED, turn, permanent, at_end }
    }

    /// Branch of the envelope at a strain.
    fn on_envelope(&self, e: f64) -> f64 {
        let [[_, et0], [_, et1]] = self.tension;
        let ends = if e > 0.0 { [et0, et1, self.ultimate] } else { [-self.peak[1], -self.crushed, f64::INFINITY] };
        let passed = ends.iter().filter(|end| e.abs() > **end).count();
        (1.0 + passed as f64).copysign(if e > 0.0 { 1.0 } else { -1.0 })
    }
}

impl UniaxialLaw for Ecc01 {
    type State = History;
    const NAME: &'static str = "ECC01";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        use branch::*;
        let e = strain.value;
        let mut t = History { strain: e, ..*c };
        t.extreme = [c.extreme[0].min(e), c.extreme[1].max(e)];
        let end = if e > 0.0 { t.extreme[1] } else { t.extreme[0] };
        let Inside { branch: now, turn, permanent, at_end } = if (e - c.strain).abs() < f64::EPSILON {
            // The branch goes on.
            let inside = if e > 0.0 { self.inside_tension(c, e, end) } else { self.inside_compression(c, e, end) };
            Inside { branch: c.branch, turn: c.turn, ..inside }
        } else if e == end {
            Inside::begun(self.on_envelope(e), c)
        } else if e > 0.0 {
            self.inside_tension(c, e, end)
        } else {
            self.inside_compression(c, e, end)
        };
        (t.branch, t.turn) = (now, turn);
        let curve = |power: f64| {
            let length = turn[0] - permanent;
            let x = (e - permanent) / length;
            (turn[1] * x.powf(power), power * turn[1] * x.powf(power - 1.0) / length, length)
        };
        let line = || {
            let length = end - turn[0];
            (turn[1] + (at_end - turn[1]) * (e - turn[0]) / length, (at_end - turn[1]) / length, length)
        };
        let (value, tangent, length) = match now {
            UNLOADS_HARDENING => curve(self.unloading[0]),
            UNLOADS_SOFTENING => curve(self.unloading[1]),
            UNLOADS_CRUSHED => curve(self.unloading[2]),
            RELOADS_HARDENING | RELOADS_SOFTENING | RELOADS_CRUSHED => line(),
            OPEN | CLOSED => (0.0, 0.0, 1.0),
            _ => {
                let (value, tangent) = self.envelope(e);
                (value, tangent, 1.0)
            }
        };
        let (value, tangent) = if length == 0.0 { (c.stress, 0.0) } else { (value, tangent) };
        // The virgin modulus is less than that of the curve, as in OpenSees.
        let tangent = if now == 0.0 { self.initial_tangent() } else { tangent };
        t.stress = value;
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.peak[0] / self.peak[1]
    }
}
