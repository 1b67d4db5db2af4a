//! `KikuchiAikenHDR` and `KikuchiAikenLRB` by OpenSees' rules.
//!
//! The tangent on the skeleton is not the derivative of the force. The return through the elastic range is softer. The
//! force jumps where loops or formulas meet the skeleton. The parameter a has a coarse tolerance, a loop closed to the
//! last bit stays open, and the initial tangent omits R_s.

use super::{Device, ELASTIC_STRAIN, Head, Loops, Rules, Shape};
use crate::numeric::bracketed_root;
use crate::state_struct::StateStruct;

/// OpenSees' rules, with the numbers of the elastic range.
#[derive(Clone, Copy, Debug)]
pub struct ElasticRange {
    /// Force of the return divided by that of the outward path.
    back: f64,
    /// Reported stiffness after a trial beyond the range.
    tried: f64,
}

impl ElasticRange {
    /// Makes the rules for a bearing with this elastic stiffness.
    pub(super) fn of<D: Device>(device: &D, elastic: f64) -> Self {
        let Shape { u, a, .. } = device.shape(ELASTIC_STRAIN, Loops::Short);
        let end = (-2.0 * a).exp();
        Self { back: 1.0 - 2.0 * u * end, tried: elastic * (1.0 - u + u * 2.0 * a * end) }
    }
}

impl Rules for ElasticRange {
    const LOOPS: Loops = Loops::Short;

    /// OpenSees continues with values of the fitted functions outside their range of validity.
    fn accepts(x: f64) -> bool {
        x > 0.0 || x.is_finite()
    }

    fn elastic(&self, k: f64, t: &Head) -> (f64, f64) {
        let back = if t.d * t.sign < 0.0 { self.back } else { 1.0 };
        (k * t.d * back, if t.sheared == 0.0 { k } else { self.tried })
    }

    fn on_skeleton<D: Device>(device: &D, gamma: f64, t: &Head, force: f64, _: f64) -> f64 {
        let Shape { u, p, n, a } = device.shape(gamma, Loops::Short);
        force / t.max * ((1.0 - u) * (1.0 - p + p * n) + u * 2.0 * a * (-2.0 * a).exp())
    }

    fn exponent(n: f64) -> f64 {
        n
    }

    fn is_open(past: f64) -> bool {
        past <= 0.0
    }

    fn leave_trace(tried: &[f64], committed: &mut [f64]) {
        Head { sheared: Head::read(tried).sheared, ..Head::read(committed) }.write(committed);
    }

    fn initial_tangent(k: f64, _: f64) -> f64 {
        k
    }

    fn shown_strain(strain: f64, [rs, rf]: [f64; 2]) -> f64 {
        strain * rs / rf
    }
}

/// Parameter a of a loop that ends short of the skeleton: (1 - exp(-2a)) / a = 1 - π h_eq / (2u). Returns the end of
/// OpenSees' bisection from `range`.
pub(super) fn short_decay(target: f64, range: f64, limit: f64) -> f64 {
    const TOLERANCE: f64 = 1e-6;
    if !(target > 0.0 && target < 2.0) {
        return limit;
    }
    // Left side and its derivative.
    let side = |a: f64| {
        let e = (-2.0 * a).exp();
        ((1.0 - e) / a, ((2.0 * a + 1.0) * e - 1.0) / (a * a))
    };
    let falls = |a: f64| {
        let (value, slope) = side(a);
        (target - value, -slope)
    };
    let Some(root) = bracketed_root(falls, (0.0, f64::INFINITY), 1.0 / target, 1.0, 100) else { return limit };
    let slope = side(root).1;
    // The root determines the path of the bisection and its end, without evaluating it at every step.
    let (mut low, mut high) = (0.0, range);
    for _ in 0..100 {
        let a = 0.5 * (low + high);
        let near = (slope * (a - root)).abs() < 2.0 * TOLERANCE * target;
        if near && ((side(a).0 - target) / target).abs() < TOLERANCE {
            return a.min(limit);
        }
        if a > root {
            high = a;
        } else {
            low = a;
            if low > limit {
                return limit;
            }
        }
    }
    low.min(limit)
}
