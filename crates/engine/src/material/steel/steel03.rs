//! Steel of Menegotto and Pinto (1973) with the isotropic hardening of `Steel01` (Mackie and Stojadinovic, 2003).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Exponent of isotropic hardening.
const HARDENING: f64 = 0.8;
/// Least radius.
const LEAST: f64 = 1e-8;

/// Steel with a curved transition to hardening.
#[derive(Clone, Debug, PartialEq)]
pub struct Steel03 {
    /// Yield stress.
    pub fy: f64,
    /// Elastic modulus.
    pub e0: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Radius of the transition.
    pub r: f64,
    /// Loss of the radius with the plastic strain: cR1 and cR2.
    pub c_r: [f64; 2],
    /// Isotropic hardening: a1, a2 in compression, a3, a4 in tension.
    pub a: [f64; 4],
}

crate::state_struct! {
    /// History of [`Steel03`].
    pub struct History {
        /// Direction, 0 in the virgin state.
        loading: f64,
        /// Least and largest strain at a turn, at first the yield strains.
        extreme: [f64; 2],
        /// Growth of the yield stress in compression and in tension.
        growth: [f64; 2],
        /// Strain and stress where the asymptotes meet.
        meet: [f64; 2],
        /// Strain and stress at the last turn.
        turn: [f64; 2],
        /// Loss of the radius at the last turn.
        loss: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
    }
}

impl Steel03 {
    /// Coefficients of the radius below which a trilinear radius stands in their place.
    pub const TRILINEAR: f64 = 0.1;
    /// OpenSees' defaults of a1 to a4: no isotropic hardening.
    pub const NO_ISOTROPIC: [f64; 4] = [0.0, 55.0, 0.0, 55.0];

    /// Radius after a plastic strain, in yield strains.
    fn radius(&self, plastic: f64) -> f64 {
        let (x, [c1, c2]) = (plastic.abs(), self.c_r);
        if c1 < Self::TRILINEAR && c2 < Self::TRILINEAR {
            let least = self.r * 2.0 / 20.0;
            // The slope of 15/7 is 2 in OpenSees.
            return least.max(-x / 7.0 + 2.0 * least).max(-4.0 * x + 6.0 * least);
        }
        let r = self.r * (1.0 - c1 * x / (c2 + x));
        if r < 0.0 { LEAST } else { r }
    }

    /// Stress, from 0 at the turn, and tangent of the curve with an initial modulus.
    fn curve(&self, modulus: f64, from_turn: f64, ratio: f64, radius: f64) -> (f64, f64) {
        let x = 1.0 + ratio.abs().powf(radius);
        let (b, linear) = (self.b, modulus * from_turn);
        (
            b * linear + (1.0 - b) * linear / x.powf(1.0 / radius),
            modulus * b + modulus * (1.0 - b) / x.powf(1.0 + 1.0 / radius),
        )
    }
}

impl UniaxialLaw for Steel03 {
    type State = History;
    const NAME: &'static str = "Steel03";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (e, mut t) = (strain.value, *c);
        let step = e - c.strain;
        let yielding = self.fy / self.e0;
        if step.abs() > f64::EPSILON {
            t.strain = e;
            let dir = step.signum();
            if c.loading == 0.0 {
                t.extreme = [-yielding, yielding];
                t.growth = [0.0; 2];
                t.meet = [dir * yielding, dir * self.fy];
                t.loading = dir;
            } else if dir != c.loading {
                t.loading = dir;
                // The side that is left, and the one that is loaded; the growth of the latter counts from its next turn on.
                let (left, side) = if dir < 0.0 { (1, 0) } else { (0, 1) };
                if dir < 0.0 {
                    t.extreme[left] = c.extreme[left].max(c.strain);
                } else {
                    t.extreme[left] = c.extreme[left].min(c.strain);
                }
                let [a1, a2] = [self.a[2 * side], self.a[2 * side + 1]];
                t.growth[side] = a1 * ((t.extreme[1] - t.extreme[0]) / (2.0 * a2 * yielding)).powf(HARDENING);
                t.turn = [c.strain, c.stress];
                let elastic = c.stress + self.e0 * step;
                let shift = dir * (1.0 + c.growth[side]) * (self.fy * (1.0 - self.b));
                let b = self.b;
                t.meet = [
                    (shift - elastic) / self.e0 / (1.0 - b) + e / (1.0 - b),
                    (b * shift - b * elastic + b * self.e0 * e) / (1.0 - b) + shift,
                ];
                t.loss = (t.meet[0] - t.extreme[side]) / yielding;
            }
        }
        let (stress, tangent) = if c.loading == 0.0 {
            self.curve(self.e0, t.strain, t.strain / yielding, self.radius(t.loss))
        } else {
            let length = t.meet[0] - t.turn[0];
            let from = t.strain - t.turn[0];
            let modulus = (t.meet[1] - t.turn[1]) / length;
            let (part, tangent) = self.curve(modulus, from, from / length, self.radius(t.loss));
            (t.turn[1] + part, tangent)
        };
        t.stress = stress;
        finite(Self::NAME, e, stress, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}
