//! Steel with asymmetric kinematic and isotropic hardening, an ultimate strength and a memory of its cycles (Zsarnóczay,
//! 2013, after Menegotto and Pinto, 1973).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Strain step of the difference that is the tangent.
const TANGENT_STEP: f64 = 1e-7;
/// Differences of strains that count as none.
const NONE: f64 = 10.0 * f64::EPSILON;
/// Number of nested cycles that are remembered; of more the first are forgotten.
const MAX_CYCLES: usize = 16;

/// One side of a [`Steel4`]: tension or compression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steel4Side {
    /// Hardening ratio b.
    pub b: f64,
    /// Radius of the curve between elastic and hardening, and its coefficients r1 and r2.
    pub r: [f64; 3],
    /// Isotropic hardening: first ratio, ratio of the bound, position of the turn, radius.
    pub isotropic: [f64; 4],
    /// Ultimate strength.
    pub ultimate: f64,
    /// Radius of the curve between hardening and the ultimate strength.
    pub ultimate_radius: f64,
}

/// Steel.
#[derive(Clone, Debug, PartialEq)]
pub struct Steel4 {
    /// Yield stress.
    pub fy: f64,
    /// Elastic modulus.
    pub e0: f64,
    /// Tension and compression.
    pub sides: [Steel4Side; 2],
    /// Length of the yield plateau, in yield strains of accumulated plastic strain.
    pub plateau: f64,
    /// Cycles are remembered.
    pub remembers: bool,
    /// Initial stress.
    pub initial: f64,
}

crate::state_struct! {
    /// Origin of a half-cycle: of its curve, and of its asymptotes.
    pub struct Origin {
        /// Strain and stress of the curve.
        at: [f64; 2],
        /// Strain and stress of the asymptotes.
        asymptote: [f64; 2],
    }
}

crate::state_struct! {
    /// A half-cycle that a later one may join again.
    pub struct Cycle {
        /// Its direction.
        dir: f64,
        /// Shifts of its yield stress by isotropic and by kinematic hardening.
        shift: [f64; 2],
        /// Its origin in tension and in compression.
        origin: [Origin; 2],
    }
}

crate::state_struct! {
    /// History of [`Steel4`].
    pub struct History {
        /// 1 once the initial stress is in the state.
        begun: f64,
        /// Direction: 0 virgin, 3 unmoved, 1 tension, 2 compression.
        dir: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Least and largest strain.
        extreme: [f64; 2],
        /// Strain at which the ultimate strength is reached.
        limit: f64,
        /// Strain and stress at yielding of this half-cycle.
        yielding: [f64; 2],
        /// Origin of this half-cycle.
        origin: Origin,
        /// Yield strain at the begin of this half-cycle.
        first_yield: f64,
        /// Plastic strain of the half-cycles before, and of this one.
        plastic: [f64; 2],
        /// Shift of the origin by perfectly plastic behaviour.
        offset: f64,
        /// Shifts of the yield stress by isotropic and by kinematic hardening.
        shift: [f64; 2],
        /// Last origins in tension and in compression.
        last: [Origin; 2],
        /// Number of remembered half-cycles.
        count: f64,
        /// Remembered half-cycles.
        cycles: [Cycle; 16],
    }
}

/// What a point on a curve says of its half-cycle.
struct Point {
    stress: f64,
    yielding: [f64; 2],
    limit: f64,
    plastic: f64,
}

impl Steel4 {
    fn side(dir: f64) -> usize {
        usize::from(dir == 2.0)
    }

    fn isotropic(&self, side: usize, plastic: f64) -> f64 {
        let [b1, b2, rho, r] = self.sides[side].isotropic;
        let mu = plastic / (self.fy / self.e0) - self.plateau;
        if mu > NONE { mu * (b2 + (b1 - b2) / (1.0 + (b1 * mu / rho).powf(r)).powf(1.0 / r)) } else { 0.0 }
    }

    /// Strain and stress at yielding, and strain at the ultimate strength.
    fn breakpoints(&self, dir: f64, origin: &Origin, shift: [f64; 2], plastic: f64) -> ([f64; 2], f64) {
        let side = Self::side(dir);
        let (s, p) = (if side == 0 { 1.0 } else { -1.0 }, &self.sides[side]);
        let size = (1.0 + self.isotropic(side, plastic)) * self.fy + shift[1] + shift[0];
        let [mut strain, mut stress] = [origin.asymptote[0] + s * (size / self.e0), origin.asymptote[1] + s * size];
        if s * stress > p.ultimate {
            strain -= (stress - s * p.ultimate) / self.e0;
            stress = s * p.ultimate;
        }
        let slope = p.b * self.e0;
        let limit = if slope > NONE { (s * p.ultimate - stress) / slope + strain } else { s * f64::MAX / 2.0 };
        ([strain, stress], limit)
    }

    /// The curve of a half-cycle at a strain.
    fn curve(&self, t: &History, origin: &Origin, shift: [f64; 2], e: f64) -> Point {
        let side = Self::side(t.dir);
        let (s, p) = (if side == 0 { 1.0 } else { -1.0 }, &self.sides[side]);
        let plastic = (s * (e - t.first_yield)).max(0.0);
        let (yielding, limit) = self.breakpoints(t.dir, origin, shift, t.plastic[0] + plastic);
        let [e0, s0] = origin.at;
        let (to_yield, to_limit) = ((e - e0) / (yielding[0] - e0), (e - e0) / (limit - e0));
        let reached = if side == 0 { t.extreme[1] - t.first_yield } else { t.first_yield - t.extreme[0] };
        let xi = (reached / (self.fy / self.e0)).abs();
        let radius = p.r[0] * (1.0 - (p.r[1] * xi) / (p.r[2] + xi));
        let curved = |x: f64, r: f64| (1.0 + x.abs().powf(r)).powf(1.0 / r);
        let share = p.b / curved(to_limit, p.ultimate_radius) + (1.0 - p.b) / curved(to_yield, radius);
        Point { stress: (yielding[1] - s0) * to_yield * share + s0, yielding, limit, plastic }
    }

    /// Begin of a half-cycle in the direction `dir`.
    fn reverse(&self, c: &History, t: &mut History, dir: f64) {
        let side = Self::side(dir);
        // Signs and values of the half-cycle before.
        let (s, before) = (if side == 0 { -1.0 } else { 1.0 }, &self.sides[1 - side]);
        let (e, sig) = (c.strain, c.stress);
        if s * (e - c.limit) >= 0.0 {
            t.offset += e - c.limit;
        }
        t.plastic = [c.plastic[0] + c.plastic[1], 0.0];
        t.dir = dir;
        let delta = if s * (e - c.yielding[0]) < 0.0 {
            (c.yielding[1] - sig) / self.e0
        } else if s * (e - c.limit) < 0.0 {
            (c.yielding[1] + (e - c.yielding[0]) * self.e0 * before.b - sig) / (self.e0 * (1.0 - before.b))
        } else {
            (s * before.ultimate - sig) / self.e0
        };
        let size = c.yielding[1] - c.origin.asymptote[1] - s * c.shift[1];
        t.origin = Origin { at: [e, sig], asymptote: [e + delta - size / self.e0, sig + delta * self.e0 - size] };
        let change = self.isotropic(1 - side, t.plastic[0]) - self.isotropic(side, t.plastic[0]);
        let [bt, bc] = [self.sides[0].b, self.sides[1].b];
        let residual = t.origin.asymptote[0] - t.origin.asymptote[1] / self.e0 - t.offset;
        t.shift = [c.shift[0] + change * self.fy, self.e0 * residual * (bt - bc) / ((1.0 - bt) * (1.0 - bc))];
        t.extreme = [t.extreme[0].min(e), t.extreme[1].max(e)];
        t.last[side] = t.origin;
        t.first_yield = self.breakpoints(dir, &t.origin, t.shift, t.plastic[0]).0[0];
    }

    /// Stress and tangent on the curve of the half-cycle, which writes its point into the state.
    fn follow(&self, t: &mut History, e: f64, joined: bool) -> (f64, f64) {
        let point = self.curve(t, &t.origin, t.shift, e);
        let near = self.curve(t, &t.origin, t.shift, e - TANGENT_STEP);
        let stress = point.stress;
        let tangent = (stress - near.stress) / TANGENT_STEP;
        // As in OpenSees, a joined half-cycle keeps the point a step before.
        let kept = if joined { near } else { point };
        (t.yielding, t.limit, t.plastic[1]) = (kept.yielding, kept.limit, kept.plastic);
        (stress, tangent)
    }

    /// Joins the last half-cycle of the same direction where this one passes it.
    fn join(&self, t: &mut History, e: f64, stress: f64) -> Option<(f64, f64)> {
        let side = Self::side(t.dir);
        let s = if side == 0 { 1.0 } else { -1.0 };
        let count = t.count as usize;
        let i = (0..count).rev().find(|i| t.cycles[*i].dir == t.dir)?;
        let cycle = t.cycles[i];
        let parent = cycle.origin[side];
        let [e0, s0] = t.origin.at;
        let apart = if side == 0 {
            parent.at[0] - (e0 - (s0 - parent.at[1]) / self.e0)
        } else {
            (e0 + (parent.at[1] - s0) / self.e0) - parent.at[0]
        };
        if apart >= -NONE || s * (self.curve(t, &parent, cycle.shift, e).stress - stress) >= 0.0 {
            return None;
        }
        (t.origin, t.shift, t.count) = (parent, cycle.shift, (i + 1) as f64);
        Some(self.follow(t, e, true))
    }

    /// Remembers this half-cycle once it is inelastic.
    fn remember(&self, t: &mut History) {
        let side = Self::side(t.dir);
        let count = t.count as usize;
        let known = count.checked_sub(1).map_or_else(Cycle::default, |i| t.cycles[i]);
        let moved = |i: usize| (t.last[i].at[0] - known.origin[i].at[0]).abs() > f64::EPSILON;
        let is_new = moved(0) || moved(1) || t.dir != known.dir;
        let inelastic = (t.strain - t.origin.at[0]).abs() > 2.0 * self.fy / self.e0;
        let is_last = matches!(t.dir, 1.0 | 2.0) && t.origin.at[0] == t.last[side].at[0];
        if !(is_new && inelastic && is_last) {
            return;
        }
        if count == MAX_CYCLES {
            t.cycles.rotate_left(1);
            t.count -= 1.0;
        }
        t.cycles[t.count as usize] = Cycle { dir: t.dir, shift: t.shift, origin: t.last };
        t.count += 1.0;
    }
}

impl UniaxialLaw for Steel4 {
    type State = History;
    const NAME: &'static str = "Steel4";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let first = self.initial / self.e0;
        let begun = if c.begun == 0.0 {
            History { begun: 1.0, strain: first, stress: self.initial, ..History::default() }
        } else {
            *c
        };
        let (c, e) = (&begun, strain.value + first);
        let d = e - c.strain;
        let mut t = History { strain: e, ..*c };
        if c.dir == 0.0 || c.dir == 3.0 {
            if d.abs() < NONE {
                (t.dir, t.stress) = (3.0, self.initial);
                return Ok((Stress { value: self.initial, tangent: self.e0, damping: 0.0 }, t));
            }
            let s = d.signum();
            t.dir = if s > 0.0 { 1.0 } else { 2.0 };
            t.first_yield = s * self.fy / self.e0;
            t.yielding = [t.first_yield, s * self.fy];
            t.extreme[usize::from(s > 0.0)] = t.first_yield;
        } else if c.dir == 2.0 && d > 0.0 {
            self.reverse(c, &mut t, 1.0);
        } else if c.dir == 1.0 && d < 0.0 {
            self.reverse(c, &mut t, 2.0);
        }
        let (mut value, mut tangent) = self.follow(&mut t, e, false);
        if self.remembers
            && let Some(joined) = self.join(&mut t, e, value)
        {
            (value, tangent) = joined;
        }
        t.stress = value;
        if self.remembers {
            self.remember(&mut t);
        }
        finite(Self::NAME, strain.value, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }

    fn shown_strain(&self, strain: f64) -> f64 {
        strain + self.initial / self.e0
    }
}
