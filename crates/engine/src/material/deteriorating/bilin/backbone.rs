//! Backbone of a deteriorating hinge on one side.

use crate::material::deteriorating::hinge::Envelope;

/// Slope of the residual branch in intersections, as in OpenSees.
const RESIDUAL_SLOPE: f64 = 1e-10;

/// Backbone of [`Bilin`](super::Bilin) on one side; all values are positive on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BilinSide {
    /// Yield strength My.
    pub strength: f64,
    /// Hardening ratio αs: hardening stiffness over elastic stiffness.
    pub hardening: f64,
    /// Plastic deformation θp up to the cap.
    pub plastic: f64,
    /// Deformation θpc from the cap to zero strength.
    pub post_capping: f64,
    /// Residual strength κ divided by My.
    pub residual: f64,
    /// Ultimate deformation θu, at which all strength is lost.
    pub ultimate: f64,
    /// Rate of deterioration D, 0 to 1.
    pub rate: f64,
}

/// A line through a point.
#[derive(Clone, Copy)]
pub struct Line {
    pub x: f64,
    pub y: f64,
    pub slope: f64,
}

/// Intersection of two lines.
pub(super) fn meet(a: &Line, b: &Line) -> (f64, f64) {
    let x = (-b.slope * b.x + b.y + a.slope * a.x - a.y) / (a.slope - b.slope);
    (x, a.slope * x - a.slope * a.x + a.y)
}

crate::state_struct! {
    /// A deteriorated backbone, and the present path towards it.
    pub struct Backbone {
        /// Yield strength.
        strength: f64,
        /// Hardening ratio of the hinge.
        hardening: f64,
        /// Post-capping slope divided by the stiffness of the hinge, negative.
        cap_slope: f64,
        /// Initial value of `cap_slope`.
        first_cap_slope: f64,
        /// Deformation at the cap.
        cap: f64,
        /// Force at the cap.
        cap_force: f64,
        /// Force of the post-capping line at zero deformation.
        cap_intercept: f64,
        /// Largest deformation so far, or the next one to be reached.
        reach: f64,
        /// Deformation of the last reversal on the backbone.
        limit: f64,
        /// Force at that deformation.
        limit_force: f64,
        /// Deformation at the intersection of the backbone with the unloading line from the other side.
        target: f64,
        /// Force at that deformation.
        target_force: f64,
        /// Target on the hardening and the post-capping branch alone.
        target_backbone: f64,
        /// Deformation at which hardening reaches the force of the last reversal.
        level_end: f64,
        /// 1 if only the residual strength remains.
        exhausted: f64,
        /// 1 if the last step was horizontal.
        level: f64,
        /// Deformation at which the extended hardening branch of the other side has zero force.
        resume: f64,
    }
}

impl Backbone {
    /// The hardening line through the yield point.
    fn hardening_line(&self, k: f64) -> Line {
        Line { x: self.strength / k, y: self.strength, slope: k * self.hardening }
    }

    /// The post-capping line through its intercept.
    fn cap_line(&self, k: f64) -> Line {
        Line { x: 0.0, y: self.cap_intercept, slope: self.cap_slope * k }
    }

    /// Deformation at which the post-capping line reaches the residual strength.
    pub fn end_of_cap(&self, rule: &BilinSide, k: f64) -> f64 {
        (rule.residual * rule.strength - self.cap_intercept) / (self.cap_slope * k)
    }

    /// Distance behind zero at which the extended hardening line has zero force.
    pub fn hardening_from(&self, k: f64) -> f64 {
        let line = self.hardening_line(k);
        -(line.slope * line.x - line.y) / line.slope
    }

    /// Force and slope on the hardening branch from the target.
    pub fn harden(&self, x: f64, k: f64) -> (f64, f64) {
        let slope = k * self.hardening;
        (self.target_force + slope * (x - self.target), slope)
    }

    /// Force and slope on the backbone.
    pub fn at(&self, rule: &BilinSide, x: f64, k: f64) -> (f64, f64) {
        let Self { strength, hardening, cap_slope: softening, cap, .. } = *self;
        Envelope { stiffness: k, strength, hardening, softening, cap }.at(rule, x)
    }

    /// Sets the target to the intersection of an unloading line from the other side with the backbone.
    pub fn aim(&mut self, rule: &BilinSide, from: Line, k: f64) {
        let residual = rule.residual * self.strength;
        let end = self.cap + (residual - self.cap_force) / (self.cap_slope * k);
        let mut branch = self.hardening_line(k);
        if branch.x >= self.cap {
            (branch.x, branch.y) = (self.cap, self.cap_force);
        }
        let (hard, cap) = (meet(&branch, &from), meet(&self.cap_line(k), &from));
        self.target = if hard.0 < cap.0 { hard.0 } else { cap.0 };
        self.target_force = if hard.1 < cap.1 { hard.1 } else { cap.1 };
        self.target_backbone = self.target;
        if self.level != 0.0 && self.limit_force == 0.0 {
            let level = Line { x: self.limit, y: self.limit_force, slope: 0.0 };
            let met = meet(&level, &from);
            if met.0 < self.target {
                (self.target, self.target_force) = met;
            }
            self.level_end = meet(&level, &self.hardening_line(k)).0;
        }
        if self.target > end {
            let rest = Line { x: end, y: residual, slope: RESIDUAL_SLOPE };
            (self.target, self.target_force) = meet(&rest, &from);
        }
    }

    /// Deformation at the intersection of the post-capping line, or of zero force behind it, with the extended
    /// hardening branch of the other side.
    pub fn bound(&self, other: &Backbone, k: f64) -> f64 {
        let end = self.cap - self.cap_force / (self.cap_slope * k);
        let line = other.hardening_line(k);
        let back = Line { x: -line.x, y: -line.y, ..line };
        let (by_cap, by_end) =
            (meet(&back, &self.cap_line(k)).0, meet(&back, &Line { x: end, y: 0.0, slope: RESIDUAL_SLOPE }).0);
        if by_cap > by_end { by_cap } else { by_end }
    }

    /// Moves the cap to the intersection of the post-capping line, with its initial slope, and the branch before it.
    pub fn move_cap(&mut self, k: f64) {
        let (line, first) = (self.hardening_line(k), self.first_cap_slope * k);
        let elastic = self.cap_intercept / (k - first);
        let plastic = (self.cap_intercept + line.slope * line.x - line.y) / (line.slope - first);
        self.cap = if elastic > plastic { elastic } else { plastic };
        self.cap_force = self.cap_intercept + first * self.cap;
    }
}
