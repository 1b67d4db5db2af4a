//! Nailed wood shear walls.

mod opensees;

use super::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Force of a wall that has failed, as a part of its displacement.
const FAILED: f64 = 1e-8;

/// Pinched hysteresis of sheathing-to-framing connectors and of walls made with them (Folz and Filiatrault, 2001,
/// <https://doi.org/10.1061/(ASCE)0733-9445(2001)127:4(433)>): an exponential envelope with a line that softens, unloading by r₃ S₀, a
/// pinched line r₄ S₀ at ±F_I, and reloading that is the softer the further the wall has been.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Force where the asymptote of the envelope meets zero displacement F₀; force.
    pub fo: f64,
    /// Force of the pinched line at zero displacement F_I; force.
    pub fi: f64,
    /// Displacement at the largest force Δ_u; length.
    pub du: f64,
    /// Initial stiffness S₀; force over length.
    pub so: f64,
    /// Stiffnesses as parts of S₀: asymptote, softening (negative), unloading, pinching.
    pub r: [f64; 4],
    /// Softening of the reloading stiffness α.
    pub alpha: f64,
    /// How much further than it has been reloading takes the wall to the envelope β.
    pub beta: f64,
}

/// Rules of [`Saws`] that differ in OpenSees. A side is given by its sign.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Largest difference of the forces where the pinched line leaves the envelope.
    const TOLERANCE: f64 = 0.0;

    /// Slope of the curve of the envelope at `x`, where it is `slope`; at the target of reloading the force is `target.1`.
    fn curve_slope(_wall: &Wall, _x: f64, _target: (f64, f64), slope: f64) -> f64 {
        slope
    }

    /// Displacement at which the pinched line of a side leaves the curve; true if the step has passed the pinched line of the negative side.
    fn leaves(leaves: f64, _s: f64, _passed: bool) -> f64 {
        leaves
    }

    /// The way to the envelope begins on the pinched line; `fresh` for a side that has not been on the envelope.
    fn keeps_pinched(_s: f64, _fresh: bool) -> bool {
        true
    }

    /// Path before the one from which reloading goes on.
    fn before_reloading(s: f64) -> f64 {
        word(Path::Pinched, s)
    }
}

impl Rules for Consistent {}

/// A [`Wall`] with what follows from its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Saws<R = Consistent> {
    wall: Wall,
    rules: R,
    /// Displacement at which the pinched line leaves the curve of the envelope.
    leaves: f64,
    /// Displacement at which nothing is left.
    ultimate: f64,
}

/// What the wall does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// Nothing any more.
    Failed,
    /// On the envelope where it is left along itself.
    Virgin,
    /// On its curve.
    Curve,
    /// On its line.
    Softening,
    /// Unloading from it.
    Unloading,
    /// On the pinched line of a side.
    Pinched,
    /// From there to the envelope.
    Reloading,
    /// From the pinched line of a side to that of the other one.
    Between,
    /// From the line of reloading to the pinched line of the other side.
    Back,
    /// Unloading from a side beyond zero displacement.
    Across,
}

const PATHS: [Path; 10] = [
    Path::Virgin,
    Path::Curve,
    Path::Softening,
    Path::Unloading,
    Path::Pinched,
    Path::Reloading,
    Path::Between,
    Path::Back,
    Path::Across,
    Path::Failed,
];

/// A path and the side that it belongs to, as kept in a word: the number of the path, negative on the negative side.
fn word(path: Path, s: f64) -> f64 {
    let number = PATHS.iter().position(|p| *p == path).map_or(0.0, |i| i as f64);
    s * number
}

fn path(word: f64) -> (Path, f64) {
    let number = PATHS.into_iter().enumerate().find(|(i, _)| *i as f64 == word.abs());
    (number.map_or(Path::Virgin, |(_, p)| p), if word < 0.0 { -1.0 } else { 1.0 })
}

crate::state_struct! {
    /// One side, with its displacements and forces positive.
    pub struct Reached {
        /// 1 where the envelope has been followed.
        yielded: f64,
        /// Displacement of the last unloading from the envelope.
        strain: f64,
        /// Force there.
        stress: f64,
        /// Displacement at which reloading comes to the envelope.
        target: f64,
        /// Force there.
        target_stress: f64,
    }
}

crate::state_struct! {
    /// History of [`Saws`].
    pub struct History {
        /// Displacement.
        strain: f64,
        /// Force.
        stress: f64,
        /// Path and side.
        path: f64,
        /// Path and side before.
        before: f64,
        /// Displacement at which the path was left, or the last on it.
        turn: f64,
        /// Reloading stiffness.
        reloading: f64,
        /// Both sides.
        sides: [Reached; 2],
    }
}

impl Saws {
    /// `None` where the pinched line does not leave the envelope within twice the displacement at the largest force.
    pub fn new(wall: Wall) -> Option<Self> {
        Self::of(wall, Consistent)
    }
}

impl Saws<OpenSees> {
    /// The same by the rules of OpenSees.
    pub fn as_opensees(wall: Wall) -> Option<Self> {
        Self::of(wall, OpenSees)
    }
}

impl<R: Rules> Saws<R> {
    fn of(wall: Wall, rules: R) -> Option<Self> {
        let mut made = Self { wall, rules, leaves: 0.0, ultimate: 0.0 };
        let far = 2.0 * made.wall.du;
        if made.curve(far).0 < made.pinched(far).0 {
            return None;
        }
        (made.leaves, made.ultimate) = (made.find_leaving(), made.find_ultimate());
        Some(made)
    }

    /// Force and slope of the curve of the envelope.
    fn curve(&self, x: f64) -> (f64, f64) {
        let (asymptote, left) =
            (self.wall.fo + self.wall.r[0] * self.wall.so * x, (-self.wall.so * x / self.wall.fo).exp());
        let share = 1.0 - left;
        (asymptote * share, asymptote * self.wall.so / self.wall.fo * left + self.wall.r[0] * self.wall.so * share)
    }

    /// Force and slope of the line behind it.
    fn softening(&self, x: f64) -> (f64, f64) {
        let slope = self.wall.r[1] * self.wall.so;
        (self.curve(self.wall.du).0 + slope * (x - self.wall.du), slope)
    }

    /// The pinched line.
    fn pinched(&self, x: f64) -> (f64, f64) {
        let slope = self.wall.r[3] * self.wall.so;
        (self.wall.fi + slope * x, slope)
    }

    /// Where a line of unloading through a point meets the pinched line of the other side.
    fn lands(&self, x: f64, force: f64) -> f64 {
        (force + self.wall.fi - self.wall.r[2] * self.wall.so * x) / (self.wall.so * (self.wall.r[3] - self.wall.r[2]))
    }

    /// Displacement at which nothing is left: the line of softening has come to the pinched line or to zero.
    fn find_ultimate(&self) -> f64 {
        let fu = self.curve(self.wall.du).0;
        let slope = self.wall.r[1] * self.wall.so;
        let pinched = (fu + self.wall.fi - slope * self.wall.du) / (self.wall.so * (self.wall.r[3] - self.wall.r[1]));
        pinched.min(self.wall.du - fu / slope)
    }

    /// Where the pinched line leaves the curve of the envelope.
    fn find_leaving(&self) -> f64 {
        let (mut low, mut high, mut middle) = (0.0, 2.0 * self.wall.du, self.wall.du);
        for _ in 0..200 {
            middle = 0.5 * (low + high);
            let above = self.curve(middle).0 - self.pinched(middle).0;
            if above >= 0.0 {
                high = middle;
            } else {
                low = middle;
            }
            if above.abs() <= R::TOLERANCE || middle == low && middle == high {
                break;
            }
        }
        middle
    }

    /// Reloading stiffness towards a target, and where its line leaves the pinched one.
    fn reload(&self, side: &Reached, old: f64) -> (f64, f64) {
        let slope = if side.yielded == 0.0 {
            self.wall.so
        } else if side.target != 0.0 {
            self.wall.so * (self.wall.fo / self.wall.so / side.target).powf(self.wall.alpha)
        } else {
            old
        };
        (slope, self.meets(side, slope))
    }

    fn meets(&self, side: &Reached, slope: f64) -> f64 {
        (self.wall.fi - side.target_stress + slope * side.target) / (slope - self.wall.r[3] * self.wall.so)
    }
}

/// What a step has come through.
#[derive(Clone, Copy, Default)]
struct Passed {
    /// The pinched line of the negative side.
    negative: bool,
    /// Unloading from the envelope.
    unloading: bool,
}

/// One step of the way through the paths.
enum Next {
    /// On to another path of a side.
    To(Path, f64),
    /// Force and slope, seen from the side; whether the displacement is kept as the last of the path.
    At(f64, (f64, f64), bool),
}

impl<R: Rules> Saws<R> {
    fn follow(&self, now: (Path, f64), u: f64, passed: Passed, t: &mut History) -> Next {
        let (path, side) = now;
        let sign = if u >= 0.0 { 1.0 } else { -1.0 };
        let s = match path {
            Path::Failed | Path::Virgin | Path::Curve | Path::Softening | Path::Unloading => sign,
            _ => side,
        };
        let i = usize::from(s < 0.0);
        let (x, turn) = (s * u, s * t.turn);
        let before = t.before;
        let unload = self.wall.r[2] * self.wall.so;
        match path {
            Path::Failed => Next::At(s, (FAILED * x, FAILED), false),
            Path::Virgin => {
                if x <= 1.05 * self.leaves {
                    return Next::At(s, self.curve(x), true);
                }
                t.before = word(Path::Virgin, 1.0);
                Next::To(Path::Curve, s)
            }
            Path::Curve | Path::Softening => {
                if path == Path::Curve && x > self.wall.du {
                    return Next::To(Path::Softening, s);
                }
                // A wall that comes from the other side in one step has been unloaded already.
                if x < if passed.unloading { turn } else { turn.abs() } {
                    return Next::To(Path::Unloading, s);
                }
                let on = |x: f64| if path == Path::Curve { self.curve(x) } else { self.softening(x) };
                let mut at = on(x);
                let target = self.wall.beta * x;
                let (mut target_stress, _) = on(target);
                if path == Path::Curve {
                    at.1 = R::curve_slope(&self.wall, x, (target, target_stress), at.1);
                    target_stress = target_stress.min(self.curve(self.wall.du).0);
                }
                t.sides[i] = Reached { yielded: 1.0, strain: x, stress: at.0, target, target_stress };
                t.before = word(path, 1.0);
                Next::At(s, at, true)
            }
            Path::Unloading => {
                if t.turn * u <= 0.0 && t.turn != 0.0 && (t.turn > 0.0 || u >= 0.0) {
                    t.before = word(Path::Unloading, 1.0);
                    return Next::To(Path::Across, t.turn.signum());
                }
                let r = t.sides[i];
                if x < self.lands(r.strain, r.stress) {
                    return Next::To(Path::Pinched, -s);
                }
                let force = r.stress + unload * (x - r.strain);
                if force > r.stress {
                    t.before = word(Path::Unloading, 1.0);
                    t.path = word(Path::Curve, s);
                }
                Next::At(s, (force, unload), true)
            }
            Path::Across => {
                let r = t.sides[i];
                t.before = word(Path::Across, s);
                if x <= self.lands(r.strain, r.stress) {
                    return Next::To(Path::Pinched, -s);
                }
                let force = r.stress + unload * (x - r.strain);
                if force > r.target_stress {
                    t.path = word(Path::Virgin, s);
                }
                Next::At(s, (force, unload), true)
            }
            Path::Pinched => {
                if before == word(Path::Pinched, s) && x < turn {
                    return Next::To(Path::Between, s);
                }
                let (slope, end) = self.reload(&t.sides[i], t.reloading);
                t.reloading = slope;
                let near = R::leaves(self.leaves, s, passed.negative);
                if x <= near || (t.sides[i].yielded != 0.0 && x <= end) {
                    t.before = word(Path::Pinched, s);
                    return Next::At(s, self.pinched(x), true);
                }
                let fresh = t.sides[i].yielded == 0.0;
                if R::keeps_pinched(s, fresh) {
                    t.before = word(Path::Pinched, s);
                }
                Next::To(if fresh { Path::Virgin } else { Path::Reloading }, s)
            }
            Path::Reloading => {
                if before == word(Path::Reloading, s) && x < turn {
                    return Next::To(Path::Back, s);
                }
                let r = t.sides[i];
                if x > r.target {
                    return Next::To(Path::Curve, s);
                }
                t.before = word(Path::Reloading, s);
                Next::At(s, (r.target_stress + t.reloading * (x - r.target), t.reloading), true)
            }
            Path::Between | Path::Back => {
                let r = t.sides[i];
                let from = if path == Path::Between {
                    self.pinched(turn).0
                } else {
                    t.reloading = self.wall.so * (self.wall.fo / self.wall.so / r.target).powf(self.wall.alpha);
                    if before == R::before_reloading(s) && x >= self.meets(&r, t.reloading) {
                        t.before = word(path, s);
                        return Next::To(Path::Reloading, s);
                    }
                    r.target_stress + t.reloading * (turn - r.target)
                };
                if x > self.lands(turn, from) && x < turn {
                    return Next::At(s, (from + unload * (x - turn), unload), false);
                }
                t.before = word(path, s);
                if x < turn {
                    Next::To(Path::Pinched, -s)
                } else if path == Path::Between {
                    Next::To(Path::Pinched, s)
                } else {
                    Next::To(if s < 0.0 && x >= r.target { Path::Curve } else { Path::Reloading }, s)
                }
            }
        }
    }
}

impl<R: Rules> UniaxialLaw for Saws<R> {
    type State = History;
    const NAME: &'static str = "SAWS";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let u = strain.value;
        let mut t = History { strain: u, ..*c };
        if u.abs() >= self.ultimate {
            t.path = word(Path::Failed, 1.0);
        }
        let mut passed = Passed::default();
        for _ in 0..10 {
            let now = path(t.path);
            passed.negative |= now == (Path::Pinched, -1.0);
            passed.unloading |= now.0 == Path::Unloading;
            match self.follow(now, u, passed, &mut t) {
                Next::To(path, s) => t.path = word(path, s),
                Next::At(s, (force, tangent), kept) => {
                    if kept {
                        t.turn = u;
                    }
                    t.stress = s * force;
                    let finite = t.stress.is_finite() && tangent.is_finite();
                    return if finite {
                        Ok((Stress { value: t.stress, tangent, damping: 0.0 }, t))
                    } else {
                        Err(none(u))
                    };
                }
            }
        }
        Err(none(u))
    }

    fn initial_tangent(&self) -> f64 {
        self.wall.so
    }
}

fn none(u: f64) -> MaterialError {
    MaterialError(format!("SAWS has no force at a displacement of {u:.6e}"))
}
