//! Backbone of a deteriorating hinge, on one side.

use super::FLAT;

/// Slope of the residual strength, where lines are cut with it.
const RESIDUAL_SLOPE: f64 = 1e-10;

/// Backbone of [`Bilin`](super::Bilin) on one side; all numbers are positive on both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BilinSide {
    /// Yield strength My.
    pub strength: f64,
    /// Hardening αs, as a part of the elastic stiffness.
    pub hardening: f64,
    /// Plastic deformation up to the cap θp.
    pub plastic: f64,
    /// Deformation from the cap down to zero strength θpc.
    pub post_capping: f64,
    /// Residual strength κ, as a part of My.
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

/// Where two lines meet.
pub(super) fn meet(a: &Line, b: &Line) -> (f64, f64) {
    let x = (-b.slope * b.x + b.y + a.slope * a.x - a.y) / (a.slope - b.slope);
    (x, a.slope * x - a.slope * a.x + a.y)
}

crate::state_struct! {
    /// A backbone as it has deteriorated, and what the hinge does on its way to it.
    pub struct Backbone {
        /// Yield strength.
        strength: f64,
        /// Hardening, as a part of the stiffness of the hinge.
        hardening: f64,
        /// Slope beyond the cap, as a part of it, negative.
        cap_slope: f64,
        /// What it was at first.
        first_cap_slope: f64,
        /// Deformation at the cap.
        cap: f64,
        /// Force at the cap.
        cap_force: f64,
        /// Force where the line beyond the cap meets zero deformation.
        cap_intercept: f64,
        /// Largest deformation so far, or that to be reached next.
        reach: f64,
        /// Deformation of the last turn on the backbone.
        limit: f64,
        /// Force there.
        limit_force: f64,
        /// Deformation at which the line of unloading from the other side meets the backbone.
        target: f64,
        /// Force there.
        target_force: f64,
        /// The target on hardening branch and cap alone.
        target_backbone: f64,
        /// Deformation at which hardening comes to the force of the last turn.
        level_end: f64,
        /// 1 where there is residual strength only.
        exhausted: f64,
        /// 1 where the last step was level.
        level: f64,
        /// Deformation at which the hardening branch of the other side, drawn on, has no force.
        resume: f64,
    }
}

impl Backbone {
    /// The hardening branch where it begins.
    fn hardening_line(&self, k: f64) -> Line {
        Line { x: self.strength / k, y: self.strength, slope: k * self.hardening }
    }

    /// The line beyond the cap, through its intercept.
    fn cap_line(&self, k: f64) -> Line {
        Line { x: 0.0, y: self.cap_intercept, slope: self.cap_slope * k }
    }

    /// Deformation at which the line beyond the cap, from its intercept, comes down to the residual strength.
    pub fn end_of_cap(&self, rule: &BilinSide, k: f64) -> f64 {
        (rule.residual * rule.strength - self.cap_intercept) / (self.cap_slope * k)
    }

    /// How far behind zero the hardening branch, drawn back, comes to zero force.
    pub fn hardening_from(&self, k: f64) -> f64 {
        let line = self.hardening_line(k);
        -(line.slope * line.x - line.y) / line.slope
    }

    /// Force on the hardening branch from the target, and its slope.
    pub fn harden(&self, x: f64, k: f64) -> (f64, f64) {
        let slope = k * self.hardening;
        (self.target_force + slope * (x - self.target), slope)
    }

    /// Force and slope on the backbone.
    pub fn at(&self, rule: &BilinSide, x: f64, k: f64) -> (f64, f64) {
        let yielded = self.strength / k;
        let early = yielded > self.cap;
        let (slope, top) = if early {
            (k, k * self.cap)
        } else {
            (k * self.hardening, self.strength + self.hardening * k * (self.cap - yielded))
        };
        let residual = rule.residual * if early { top } else { rule.strength };
        let end = self.cap + (residual - top) / (self.cap_slope * k);
        if x < 0.0 {
            (0.0, FLAT)
        } else if x <= yielded.min(self.cap) {
            (k * x, k)
        } else if x <= self.cap {
            (self.strength + slope * (x - yielded), slope)
        } else if x <= end {
            (top + self.cap_slope * k * (x - self.cap), self.cap_slope * k)
        } else {
            (residual + x * FLAT, FLAT)
        }
    }

    /// Find where a line of unloading from the other side meets the backbone.
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

    /// Deformation at which the line beyond the cap, or zero force behind it, meets the hardening branch of the other side, drawn on.
    pub fn bound(&self, other: &Backbone, k: f64) -> f64 {
        let end = self.cap - self.cap_force / (self.cap_slope * k);
        let line = other.hardening_line(k);
        let back = Line { x: -line.x, y: -line.y, ..line };
        let (by_cap, by_end) =
            (meet(&back, &self.cap_line(k)).0, meet(&back, &Line { x: end, y: 0.0, slope: RESIDUAL_SLOPE }).0);
        if by_cap > by_end { by_cap } else { by_end }
    }

    /// Put the cap where the line beyond it, with the slope that it had at first, meets what comes before it.
    pub fn move_cap(&mut self, k: f64) {
        let (line, first) = (self.hardening_line(k), self.first_cap_slope * k);
        let elastic = self.cap_intercept / (k - first);
        let plastic = (self.cap_intercept + line.slope * line.x - line.y) / (line.slope - first);
        self.cap = if elastic > plastic { elastic } else { plastic };
        self.cap_force = self.cap_intercept + first * self.cap;
    }
}
