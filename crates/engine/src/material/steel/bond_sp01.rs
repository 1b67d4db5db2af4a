//! Slip of an anchored bar by strain penetration (Zhao and Sritharan, 2007, ACI Structural Journal 104(2), 133-141).

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Exponent of the envelope; a value above 1 keeps its slope at the ultimate slip finite.
const ENVELOPE_EXPONENT: f64 = 1.01;
/// Exponent of a reloading branch at its end.
const LAST_EXPONENT: f64 = 1.01;
/// Slip at the friction of a virgin bond, in: the first reversal goes there on the other side. 0.04 (12/30)^2.5.
const FRICTION_SLIP: f64 = 0.004_047_715_405_015_527;

/// Bar stress over slip at the end of an anchorage.
#[derive(Clone, Debug, PartialEq)]
pub struct BondSp01<R = Consistent> {
    /// Yield strength of the bar.
    pub fy: f64,
    /// Slip at the yield strength.
    pub sy: f64,
    /// Ultimate strength of the bar.
    pub fu: f64,
    /// Slip at the ultimate strength.
    pub su: f64,
    /// Initial hardening ratio.
    pub b: f64,
    /// Pinching factor.
    pub r: f64,
    /// Rules of the tangent.
    pub rules: R,
}

crate::state_struct! {
    /// History of [`BondSp01`].
    pub struct History {
        /// Slip.
        slip: f64,
        /// Bar stress.
        stress: f64,
        /// Tangent divided by the elastic stiffness, minus one.
        softening: f64,
        /// Slip and stress at the last reversal.
        turn: [f64; 2],
        /// Largest slip on either side, positive.
        largest: [f64; 2],
        /// 1 going up, -1 going down, 0 virgin.
        loading: f64,
        /// 1 after a yield.
        yielded: f64,
    }
}

/// A branch from a point to the largest slip on the side ahead, with positive slips and stresses.
#[derive(Clone, Copy)]
struct Branch {
    /// Slip at which it starts.
    from: f64,
    /// Slip at its end.
    to: f64,
    /// Stress at its end.
    end: f64,
    /// Stress at its start.
    base: f64,
}

/// Rules of [`BondSp01`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Slope of the envelope beyond yield, from its derivative and from a share of the elastic stiffness.
    fn envelope_slope(derivative: f64, _share: f64) -> f64 {
        derivative
    }

    /// Slope of a branch, from its derivative and from a share of the elastic stiffness.
    fn branch_slope(derivative: f64, _share: f64) -> f64 {
        derivative
    }
}

impl Rules for Consistent {}

/// The tangents are shares of the elastic stiffness, without the height of the branch and the change of its exponent.
impl Rules for OpenSees {
    fn envelope_slope(_: f64, share: f64) -> f64 {
        share
    }

    fn branch_slope(_: f64, share: f64) -> f64 {
        share
    }
}

/// Sign of a side by its index.
fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

impl<R: Rules> BondSp01<R> {
    fn elastic(&self) -> f64 {
        self.fy / self.sy
    }

    /// Stress and slope on the envelope for a positive slip.
    fn envelope(&self, x: f64) -> (f64, f64) {
        let elastic = self.elastic();
        if x <= self.sy {
            return (elastic * x, elastic);
        } else if x >= self.su {
            return (self.fu, 0.0);
        }
        let (past, ultimate) = ((x - self.sy) / self.sy, (self.su - self.sy) / self.sy);
        let left = ultimate - past;
        let ratio = past / left;
        let first = (1.0 / ultimate / self.b).powf(ENVELOPE_EXPONENT);
        let sum = first + ratio.powf(ENVELOPE_EXPONENT);
        let share = ratio / sum.powf(1.0 / ENVELOPE_EXPONENT);
        // Derivative of the share with respect to the slip over the yield slip.
        let slope = first * sum.powf(-1.0 / ENVELOPE_EXPONENT - 1.0) * ultimate / left.powi(2);
        let (hardening, derivative) = (self.fu - self.fy, slope / self.sy);
        (self.fy + share * hardening, R::envelope_slope(hardening * derivative, self.fy * derivative))
    }

    /// Stress and slope on a branch for a positive slip.
    fn branch(&self, b: &Branch, x: f64) -> (f64, f64) {
        let elastic = self.elastic();
        let yields = b.end / elastic;
        let (past, ultimate) = ((x - b.from) / yields, (b.to - b.from) / yields);
        let left = ultimate - past;
        let (ratio, part) = (past / left, (x - b.from) / (b.to - b.from));
        let power = 1.0 / self.r / self.r;
        let n = self.r + (LAST_EXPONENT - self.r) * part.powf(power);
        let first = (1.0 / ultimate).powf(n);
        let last = ratio.powf(n);
        let sum = first + last;
        let share = ratio / sum.powf(1.0 / n);
        let fixed = ultimate.powf(1.0 - n) / left.powi(2) / sum.powf(1.0 / n + 1.0);
        let amplitude = b.end - b.base;
        // The exponent changes along the branch: derivative of the logarithm of the share.
        let d_n =
            if part > 0.0 { (LAST_EXPONENT - self.r) * power * part.powf(power - 1.0) / (b.to - b.from) } else { 0.0 };
        let logs = -first * ultimate.ln() + if last > 0.0 { last * ratio.ln() } else { 0.0 };
        let by_exponent = share * d_n * (sum.ln() / (n * n) - logs / (n * sum));
        let derivative = amplitude * (fixed / yields + by_exponent);
        (share * amplitude + b.base, R::branch_slope(derivative, fixed * elastic))
    }

    /// Stress and tangent after a yield.
    fn beyond_yield(&self, d: f64, c: &History, t: &mut History) -> (f64, f64) {
        let side = usize::from(d < 0.0);
        let s = sign(side);
        if t.loading != s {
            (t.loading, t.turn) = (s, [c.slip, c.stress]);
            t.largest[1 - side] = t.largest[1 - side].max(-s * c.slip);
        }
        let (x, to, elastic) = (s * t.slip, t.largest[side], self.elastic());
        let ([turn, stress], end) = (t.turn.map(|v| s * v), self.envelope(to).0);
        let zero = turn - stress / elastic;
        let (y, slope) = if x >= to {
            self.on_envelope(x, t)
        } else if zero > turn {
            if x >= zero {
                self.branch(&Branch { from: zero, to, end, base: 0.0 }, x)
            } else {
                (stress * (x - zero) / (turn - zero), elastic)
            }
        } else {
            self.branch(&Branch { from: turn, to, end, base: stress }, x)
        };
        (s * y, slope)
    }

    /// Stress and slope on the envelope; a slip beyond yield is stored.
    fn on_envelope(&self, x: f64, t: &mut History) -> (f64, f64) {
        if x.abs() > self.sy {
            t.yielded = 1.0;
        }
        let (y, slope) = self.envelope(x.abs());
        (y.copysign(x), slope)
    }

    /// Stress and tangent before a yield.
    fn before_yield(&self, d: f64, c: &History, t: &mut History) -> (f64, f64) {
        let response = self.on_envelope(t.slip, t);
        let side = usize::from(d < 0.0);
        let s = sign(side);
        if t.loading == 0.0 {
            t.loading = s;
            t.largest[1 - side] = FRICTION_SLIP;
        } else if t.loading != s {
            (t.loading, t.turn) = (s, [c.slip, c.stress]);
            t.largest[1 - side] = t.largest[1 - side].max(-s * c.slip);
        }
        response
    }
}

impl<R: Rules> UniaxialLaw for BondSp01<R> {
    type State = History;
    const NAME: &'static str = "Bond_SP01";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let mut t = History { slip: strain.value, ..*c };
        let (d, elastic) = (strain.value - c.slip, self.elastic());
        let (value, tangent) = if d.abs() <= f64::EPSILON {
            (c.stress, elastic * (1.0 + c.softening))
        } else if c.yielded == 0.0 {
            self.before_yield(d, c, &mut t)
        } else {
            self.beyond_yield(d, c, &mut t)
        };
        if !(value.is_finite() && tangent.is_finite()) {
            let message = format!("Bond_SP01 has no stress at a slip of {:.6e}", strain.value);
            return Err(MaterialError(message));
        }
        (t.stress, t.softening) = (value, tangent / elastic - 1.0);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.elastic()
    }
}
