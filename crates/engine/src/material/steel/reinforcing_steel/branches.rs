//! The branches of the history.
//!
//! Branch 1 is the envelope in tension. A turn from it begins branch 3, which leads to the envelope in compression; a turn from
//! that branch 5, back; from that branch 7, and so on, each a curve to where the last turn was. Even branches are the same
//! with tension and compression exchanged, so that only odd ones are written out.

use super::curve::{Backbone, Curve};
use super::{History, LEVELS, ReinforcingSteel};

/// Strain within which two strains are the same.
const SAME: f64 = 1e-14;
/// Last branch.
const LAST: usize = 20;

/// The way from the committed state to a strain.
pub(super) struct Path<'a> {
    bar: &'a ReinforcingSteel,
    /// Committed and trial state, exchanged where the branch is even.
    c: History,
    t: History,
    e: f64,
    curve: Curve,
    backbone: Backbone,
    exchanged: bool,
    tangent: f64,
    /// Derivative of the fatigue damage by the strain.
    damage_slope: f64,
}

impl<'a> Path<'a> {
    pub(super) fn new(bar: &'a ReinforcingSteel, c: &History, t: History, e: f64) -> Self {
        let backbone = Backbone::new(bar, c.shortened);
        let tangent = backbone.modulus + c.softening;
        let mut made =
            Self { bar, c: *c, t, e, curve: Curve::default(), backbone, exchanged: false, tangent, damage_slope: 0.0 };
        if t.branch % 2.0 == 0.0 {
            made.exchange();
        }
        if made.branch() > 2 {
            made.past(made.branch());
        }
        made
    }

    /// The trial state with tension and compression in place, and the derivative of its fatigue damage by the strain.
    pub(super) fn finish(mut self) -> (History, f64) {
        if self.branch() > 2 {
            self.t.curves[Self::level(self.branch())] = self.curve;
        }
        if self.exchanged {
            self.exchange();
        }
        self.t.softening = self.tangent - self.backbone.modulus;
        (self.t, self.damage_slope)
    }

    fn exchange(&mut self) {
        self.c = self.c.mirrored();
        self.t = self.t.mirrored();
        self.curve = self.curve.mirrored();
        self.e = -self.e;
        self.damage_slope = -self.damage_slope;
        self.exchanged = !self.exchanged;
    }

    fn branch(&self) -> usize {
        self.t.branch.max(0.0) as usize
    }

    fn level(branch: usize) -> usize {
        branch.div_ceil(2).min(LEVELS - 1)
    }

    /// Takes up the committed curve of a branch.
    fn past(&mut self, branch: usize) {
        self.curve = self.c.curves[Self::level(branch)];
    }

    /// Follows the branch of the trial state.
    pub(super) fn follow(&mut self) {
        match self.branch() {
            0 => {}
            1 | 2 => self.envelope(),
            3 => self.across_to_envelope(),
            5 => self.back_to_envelope(),
            7 => self.first_transition(),
            b if b % 4 == 1 => self.second_transition(),
            _ => self.third_transition(),
        }
    }

    /// Slope after a turn (Dodd and Cooke, 1994).
    fn return_slope(&self) -> f64 {
        let [own, other] = self.t.farthest;
        self.backbone.modulus * (0.82 + 1.0 / (5.55 + 1000.0 * own.max(other)))
    }

    fn exponent(&self, length: f64) -> f64 {
        let [r1, r2, r3] = self.bar.curve;
        (self.backbone.fy / self.backbone.modulus).powf(r1) * r2 * (1.0 - r3 * length)
    }

    /// A curve between two points with slopes there; `down` towards compression.
    fn between(&self, a: [f64; 3], b: [f64; 3], down: bool) -> Curve {
        let [ea, fa, ka] = a;
        let [eb, fb, kb] = b;
        let r = self.exponent(if down { ea - eb } else { eb - ea });
        Curve { r, ea, fa, ka, eb, fb, kb, ..Curve::default() }
    }

    /// The committed state as the begin of a curve.
    fn here(&self) -> [f64; 3] {
        [self.c.strain, self.c.stress, self.return_slope()]
    }

    /// Point on the envelope in tension at a strain, or with `other` in compression.
    fn on_envelope(&self, e: f64, other: bool) -> [f64; 3] {
        let x = e - if other { -self.t.origin[1] } else { self.t.origin[0] };
        [e, self.backbone.stress(x), self.backbone.slope(x)]
    }

    /// Shortens the yield plateau for a plastic strain. The plastic strain in compression is taken with the opposite sign of
    /// its elastic part, as in OpenSees.
    fn shorten(&mut self, plastic: f64) {
        let [rate, least] = self.bar.hardening;
        let b = &self.backbone;
        let [tension, compression] = if self.exchanged { [1, 0] } else { [0, 1] };
        let [t, c] = [self.t.largest[tension], self.t.largest[compression]];
        let known = (t - b.stress(t) / b.modulus).max(c + b.stress(c) / b.modulus);
        self.t.shortened = 1.0 - (1.0 - rate * (plastic - known)).max(least).min(1.0);
        self.backbone = Backbone::new(self.bar, self.t.shortened);
    }

    /// Replaces the plastic half cycle of a level by that of a strain and a stress from the begin of the cycle on.
    fn count(&mut self, taken: usize, given: Option<usize>, strain: f64, stress: f64) {
        let modulus = self.backbone.modulus;
        let plastic = (strain.abs() - (stress / modulus).abs()).max(0.0);
        let old = self.t.plastic[taken];
        self.t.damage += self.bar.damage(plastic) - self.bar.damage(old);
        self.t.accumulated += plastic - old;
        if let Some(level) = given {
            self.t.plastic[level] = plastic;
            self.damage_slope = if plastic > 0.0 {
                self.bar.damage_slope(plastic) * (strain.signum() - stress.signum() * self.tangent / modulus)
            } else {
                0.0
            };
        }
    }

    fn on_curve(&mut self) {
        (self.t.stress, self.tangent) = (self.curve.stress(self.e), self.curve.slope(self.e));
    }

    /// Branch 1.
    fn envelope(&mut self) {
        let x = self.e - self.t.origin[0];
        let turns = self.e < self.c.strain;
        if turns && x - self.backbone.esh > -SAME {
            return self.turn_in_hardening();
        } else if turns && x - self.backbone.ey > -SAME {
            return self.turn_on_plateau();
        } else if turns && x <= -SAME {
            self.t.branch = 2.0;
            self.exchange();
            return self.envelope();
        }
        (self.t.stress, self.tangent) = (self.backbone.stress(x), self.backbone.slope(x));
        if !turns {
            // Stresses are positive on their sides: the turn in compression is subtracted.
            let (strain, stress) = (self.e + self.t.farthest[1], self.t.stress + self.t.turned[1]);
            self.count(0, Some(0), strain, stress);
        }
    }

    fn leave_envelope(&mut self) {
        self.t.largest[0] = self.c.strain - self.t.origin[0];
        self.t.farthest[0] = self.t.farthest[0].max(self.c.strain);
        self.t.turned[0] = self.c.stress;
    }

    fn turn_in_hardening(&mut self) {
        self.leave_envelope();
        let (b, from, f) = (self.backbone, self.c.strain, self.c.stress);
        let mut least = if self.t.largest[1] < b.esh { -b.esh - SAME } else { -self.t.largest[1] };
        let largest = self.t.largest[0];
        let first = self.t.origin[0] + b.esh - b.fsh / b.modulus;
        let later = self.t.origin[0] + largest - f / b.modulus;
        let weight = (-largest / (5000.0 * b.ey * b.ey)).exp();
        let origin = first * weight + later * (1.0 - weight);
        if origin > -self.t.origin[1] {
            least -= origin + self.t.origin[1];
            self.t.origin[1] = -origin;
        }
        let mut to = least - self.t.origin[1];
        let slope = self.return_slope();
        self.shorten(self.t.accumulated + from - least - (f - self.backbone.stress(least)) / b.modulus);
        let (fb, kb) = (self.backbone.stress(least), self.backbone.slope(least));
        if !self.exchanged && (fb - f) / (to - from) < kb {
            self.t.origin[1] = least - (fb - f) / kb - from;
            to = least - self.t.origin[1];
        }
        self.curve = self.between([from, f, slope], [to, fb, kb], true).through();
        self.t.plastic[2] = 0.0;
        self.t.branch = 3.0;
        self.across_to_envelope();
    }

    fn turn_on_plateau(&mut self) {
        self.leave_envelope();
        let (b, from, f) = (self.backbone, self.c.strain, self.c.stress);
        let slope = self.return_slope();
        let part = (self.t.largest[0] - b.ey) / (b.esh - b.ey);
        let least = part * (b.ey - b.esh) - b.ey;
        self.t.origin[1] = f / b.modulus - from;
        self.shorten(self.t.accumulated + from - least - (f - b.stress(least)) / b.modulus);
        let b = self.backbone;
        let kb = 1.0 / (1.0 / b.modulus + part * (1.0 / b.ksh - 1.0 / b.modulus));
        let to = [least - self.t.origin[1], b.stress(least), kb];
        self.curve = self.between([from, f, slope], to, true).with_sound_slopes();
        self.t.plastic[2] = 0.0;
        self.t.branch = 3.0;
        self.across_to_envelope();
    }

    /// Branch 3.
    fn across_to_envelope(&mut self) {
        if self.e > self.c.strain {
            let (from, b) = (self.c.strain, self.backbone);
            self.t.largest[1] = self.t.largest[1].max(-(from + self.t.origin[1]));
            let beyond = (self.c.curves[2].ea - from - b.fy / (1.2 * b.modulus)).clamp(0.0, b.fy / 3.0 / b.modulus);
            let to = self.t.origin[0] + self.t.largest[0] + beyond;
            let rise = b.stress(to - self.t.origin[0]) - self.c.stress;
            self.shorten(self.t.accumulated + to - from - rise / b.modulus);
            self.curve = self.between(self.here(), self.on_envelope(to, false), false).with_sound_slopes();
            self.t.plastic[3] = 0.0;
            self.t.branch = 5.0;
            self.back_to_envelope();
        } else if self.e - self.curve.eb <= SAME {
            self.t.plastic[1] = self.t.plastic[2];
            self.t.branch = 2.0;
            self.exchange();
            self.envelope();
        } else {
            self.on_curve();
            let (strain, stress) = (self.e - self.t.farthest[0], self.t.stress - self.curve.fa);
            self.count(2, Some(2), strain, stress);
        }
    }

    /// A curve from the envelope in tension to that in compression, between a turn from branch 3 and the end of branch 5,
    /// for a present strain and stress.
    fn between_envelopes(&mut self, from: f64, (e, f): (f64, f64)) {
        let (second, third) = (self.c.curves[2], self.c.curves[3]);
        let span = third.eb - third.ea;
        let start = third.eb * (from - third.ea) / span + second.ea * (third.eb - from) / span;
        let modulus = self.backbone.modulus;
        let rise = self.backbone.stress(start - self.t.origin[0]) - f;
        self.shorten(self.t.accumulated + e - start + rise / modulus);
        let begin = self.on_envelope(start, false)[1];
        let fall = f - self.backbone.stress(second.eb + self.t.origin[1]);
        self.shorten(self.t.accumulated + e - second.eb - fall / modulus);
        let end = self.on_envelope(second.eb, true);
        self.curve = self.between([start, begin, second.ka], end, true).through();
    }

    /// Branch 5.
    fn back_to_envelope(&mut self) {
        if self.e < self.c.strain {
            let present = (self.c.strain, self.c.stress);
            self.between_envelopes(self.c.strain, present);
            let to = self.c.curves[3].ea;
            let end = [to, self.curve.stress(to), self.curve.slope(to)];
            self.curve = self.between(self.here(), end, true).with_sound_slopes();
            self.t.plastic[4] = 0.0;
            self.t.branch = 7.0;
            self.first_transition();
        } else if self.e - self.curve.eb >= -SAME {
            self.count_whole(3);
            self.t.branch = 1.0;
            self.envelope();
        } else {
            self.on_curve();
            self.count_part(3);
        }
    }

    /// Counts the whole present curve instead of a level.
    fn count_whole(&mut self, level: usize) {
        let c = self.curve;
        self.count(level, None, c.eb - c.ea, c.fb - c.fa);
    }

    /// Counts the present curve up to the strain.
    fn count_part(&mut self, level: usize) {
        let (strain, stress) = (self.e - self.curve.ea, self.t.stress - self.curve.fa);
        self.count(level, Some(level), strain, stress);
    }

    /// Begins a curve to a strain on a committed curve.
    fn turn_to(&mut self, branch: usize, to: f64, down: bool) {
        self.past(branch);
        let end = [to, self.curve.stress(to), self.curve.slope(to)];
        self.curve = self.between(self.here(), end, down).with_sound_slopes();
    }

    /// Branch 7.
    fn first_transition(&mut self) {
        if self.e > self.c.strain {
            self.turn_to(5, self.c.curves[4].ea, false);
            self.t.target = self.curve.ea;
            self.t.plastic[5] = 0.0;
            self.t.branch = 9.0;
            self.second_transition();
        } else if self.e - self.curve.eb <= SAME {
            self.count_whole(4);
            let (from, present) = (self.curve.ea, (self.curve.eb, self.curve.fb));
            self.between_envelopes(from, present);
            self.t.branch = 3.0;
            self.across_to_envelope();
        } else {
            self.on_curve();
            self.count_part(4);
        }
    }

    /// Branches 9, 13, 17.
    fn second_transition(&mut self) {
        let branch = self.branch();
        if self.e < self.c.strain {
            if branch + 4 <= LAST {
                self.t.target = self.curve.ea;
            }
            self.turn_to(branch - 2, self.t.target, true);
            self.t.branch = (branch + 2) as f64;
            self.t.plastic[Self::level(branch + 2)] = 0.0;
            self.third_transition();
        } else if self.e - self.curve.eb >= -SAME {
            self.count_whole(Self::level(branch));
            self.t.branch = (branch - 4) as f64;
            self.past(branch - 4);
            self.follow();
        } else {
            self.on_curve();
            self.count_part(Self::level(branch));
        }
    }

    /// Branches 11, 15, 19.
    fn third_transition(&mut self) {
        let branch = self.branch();
        let level = Self::level(branch);
        if self.e > self.c.strain {
            let last = branch + 2 > LAST;
            let to = if last { self.c.curves[level - 2].ea } else { self.curve.ea };
            self.turn_to(if last { branch - 6 } else { branch - 2 }, to, false);
            let next = if last { branch - 2 } else { branch + 2 };
            self.t.branch = next as f64;
            self.t.plastic[Self::level(next)] = 0.0;
            self.second_transition();
        } else if self.e - self.curve.eb <= SAME {
            self.count_whole(level - 2);
            self.t.branch = (branch - 4) as f64;
            self.past(branch - 4);
            self.follow();
        } else {
            self.on_curve();
            self.count_part(level);
        }
    }
}
