//! Changes of the state at a reversal.

use super::{History, Point, SteelDrc};

/// Relative error of the stress on a curve through a reversal, and least interval of its beginning.
const TOLERANCE: f64 = 1e-8;
/// Difference of natural strains of the far ends of both directions that is round-off.
const TIE: f64 = 1e-12;
/// Bisections for that beginning.
const MAX_BISECTIONS: usize = 200;

impl SteelDrc {
    /// Changes the history by a reversal to direction `s`; `k` is the index of that direction.
    pub(super) fn reverse(&self, t: &mut History, s: f64, k: usize) {
        let m = 1 - k;
        let here = Point { k: self.e + t.at.k, ..t.at };
        let virgin = t.shift == [0.0, 0.0];
        let (d, last) = (t.direction, usize::from(t.direction < 0.0));
        let on_line = d * t.last.e < d * here.e && d * here.e < d * t.line[last][0];
        if virgin && here.e.abs() <= (self.fy / self.e).ln_1p() || on_line {
            return;
        }
        t.last = here;
        t.direction = s;
        let far = s * (here.f / self.unloading(t) - here.e);
        if far > t.max_shift {
            t.max_shift = far;
        }
        let unloading = self.unloading(t);
        t.line[k] = [here.e + s * self.straight * self.fy / unloading, here.f + s * self.straight * self.fy];
        let permanent = here.e - here.f / unloading;
        if t.no_rejoin[m] != 1.0 {
            if t.hardened == 1.0 {
                return self.leave_plateau(t, s, k, permanent);
            }
            if s * here.e <= s * t.rejoin[m].e {
                self.reverse_on_plateau(t, s, k, permanent);
            }
            return;
        }
        let inside = s * permanent >= s * t.shift[k];
        let large = s * (t.major[k].f - here.f) > 2.0 * self.straight * self.fy;
        let beyond = s * here.e < s * t.major[m].e;
        if !inside || large || beyond && t.from_skeleton[m] == -1.0 {
            t.no_rejoin = [1.0, 1.0];
            if -s * here.e > -s * self.far(t, m).e {
                self.move_far(t, m, Point { k: here.k.max(0.0), ..here });
            }
            if !inside {
                t.shift[k] = permanent;
            }
            t.major[m] = here;
            t.major_line[k] = t.line[k];
            let (ahead, behind) = (self.far(t, k).e, self.far(t, m).e);
            if -s * (behind - t.shift[m]) > s * (ahead - t.shift[k]) + TIE {
                let e = t.shift[k] + t.shift[m] - behind;
                self.rejoin_far(t, k, e);
            }
            (t.from_skeleton[k], t.from_skeleton[m]) = (1.0, -1.0);
        } else if t.from_skeleton[m] == 1.0 || beyond {
            t.no_rejoin = [1.0, 1.0];
            t.major[m] = here;
            t.from_skeleton[m] = 0.0;
        }
    }

    fn move_far(&self, t: &mut History, k: usize, to: Point) {
        t.far[k] = to;
        t.far_moved[k] = 1.0;
    }

    /// The far end of a direction on its skeleton, which does not break the steel.
    fn rejoin_far(&self, t: &mut History, k: usize, e: f64) {
        let fractured = t.fractured;
        let (f, slope) = self.skeleton(t, e - t.shift[k]);
        t.fractured = fractured;
        self.move_far(t, k, Point { e, f, k: slope.max(0.0) });
    }

    /// A reversal on the yield plateau.
    fn reverse_on_plateau(&self, t: &mut History, s: f64, k: usize, permanent: f64) {
        let m = 1 - k;
        t.rejoin[m] = t.last;
        t.shift[k] = permanent;
        let e = s * self.ultimate_n() + t.shift[k];
        let (f, slope) = self.skeleton(t, e - t.shift[k]);
        self.move_far(t, k, Point { e, f, k: slope });
        t.hardened = 0.0;
        let e = t.shift[k] + t.shift[m] - t.last.e;
        let (f, slope) = self.skeleton(t, e - t.shift[k]);
        t.rejoin[k] = Point { e, f, k: slope };
        t.no_rejoin[k] = 0.0;
    }

    /// The first reversal after the yield plateau. The curve behind it gets a beginning that makes it pass the reversal.
    fn leave_plateau(&self, t: &mut History, s: f64, k: usize, permanent: f64) {
        let (m, here, unloading) = (1 - k, t.last, self.unloading(t));
        t.rejoin[m].e = here.e;
        t.no_rejoin[k] = 1.0;
        t.shift[k] = permanent;
        if -s * (here.e - t.shift[m]) > self.ultimate_n() {
            self.move_far(t, m, Point { k: here.k.max(0.0), ..here });
        }
        let behind = self.far(t, m);
        let e = t.shift[k] - (behind.e - t.shift[m]);
        self.rejoin_far(t, k, e);
        let (mut near, mut wide) = (t.shift[m], t.shift[m] - s * self.strength_n() / unloading);
        let line = |e: f64, t: &History| [e, unloading * (e - t.shift[m])];
        let mut begin = line(0.5 * (near + wide), t);
        let through = |begin: [f64; 2], t: &History| self.major(t, (begin, behind), (begin, t.shift[m]), -s, here.e);
        for _ in 0..MAX_BISECTIONS {
            let miss = here.f - through(begin, t).0;
            let close = here.f.abs() <= f64::EPSILON || (miss / here.f).abs() <= TOLERANCE;
            if close || miss.is_nan() || (wide - near).abs() <= TOLERANCE {
                break;
            }
            if -s * miss > 0.0 {
                near = begin[0]
            } else {
                wide = begin[0]
            }
            begin = line(0.5 * (near + wide), t);
        }
        t.major_line[m] = begin;
        let (f, slope) = through(begin, t);
        t.major[m] = Point { e: here.e, f, k: slope };
        t.major_line[k] = t.line[k];
        (t.from_skeleton[k], t.from_skeleton[m]) = (1.0, -1.0);
    }
}
