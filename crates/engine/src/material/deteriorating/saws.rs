//! Nailed wood shear walls.

mod opensees;

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::rules::{Consistent, OpenSees};
use std::fmt;

/// Stiffness of a failed wall, force over displacement; the value of OpenSees.
const FAILED_STIFFNESS: f64 = 1e-8;

/// Pinched hysteresis of sheathing-to-framing connectors and of walls made with them. The envelope is exponential up
/// to the largest force and softens linearly beyond. Unloading has the stiffness r₃ S₀, the pinched line r₄ S₀ at
/// ±F_I. The reloading stiffness decreases with the largest displacement. Source: Folz and Filiatrault, 2001,
/// <https://doi.org/10.1061/(ASCE)0733-9445(2001)127:4(433)>.
#[derive(Clone, Debug, PartialEq)]
pub struct SawsParameters {
    /// Force F₀ of the envelope's asymptote at zero displacement; force.
    pub fo: f64,
    /// Force F_I of the pinched line at zero displacement; force.
    pub fi: f64,
    /// Displacement Δ_u at the largest force; length.
    pub du: f64,
    /// Initial stiffness S₀; force over length.
    pub so: f64,
    /// Stiffnesses r₁ to r₄ divided by S₀: asymptote, softening (negative), unloading, pinching.
    pub r: [f64; 4],
    /// Exponent α of the reloading stiffness.
    pub alpha: f64,
    /// Displacement at which reloading reaches the envelope divided by the largest displacement, β.
    pub beta: f64,
}

/// Rules of [`Saws`] that differ in OpenSees. A side is given by its sign.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Force tolerance of the intersection of pinched line and envelope.
    const TOLERANCE: f64 = 0.0;

    /// Slope of the curve of the envelope at `x`, where it is `slope`; at the target of reloading the force is `target.1`.
    fn curve_slope(_wall: &SawsParameters, _x: f64, _target: (f64, f64), slope: f64) -> f64 {
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

/// The law of a [`SawsParameters`], with derived constants.
#[derive(Clone, Debug, PartialEq)]
pub struct Saws<R = Consistent> {
    wall: SawsParameters,
    rules: R,
    /// Displacement at the intersection of the pinched line with the exponential envelope.
    leaves: f64,
    /// Displacement at which all strength is lost.
    ultimate: f64,
}

/// Path of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// Failed.
    Failed,
    /// On the envelope near zero, where unloading follows the loading curve.
    Virgin,
    /// On the exponential part of the envelope.
    Curve,
    /// On the softening part of the envelope.
    Softening,
    /// Unloading from the envelope.
    Unloading,
    /// On the pinched line of a side.
    Pinched,
    /// From the pinched line to the envelope.
    Reloading,
    /// Between the pinched lines of both sides.
    Between,
    /// From the reloading line to the pinched line of the other side.
    Back,
    /// Unloading from a side beyond zero displacement.
    Across,
}

/// Maximum number of bisections for an intersection; more than the bits of a double.
const MAX_BISECTIONS: usize = 200;
/// Maximum number of paths in a step.
const MAX_PATHS: usize = 10;

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

/// A path and its side as a state variable: the number of the path, negative on the negative side.
fn word(path: Path, s: f64) -> f64 {
    let number = PATHS.iter().position(|p| *p == path).map_or(0.0, |i| i as f64);
    s * number
}

fn path(word: f64) -> (Path, f64) {
    let number = PATHS.into_iter().enumerate().find(|(i, _)| *i as f64 == word.abs());
    (number.map_or(Path::Virgin, |(_, p)| p), if word < 0.0 { -1.0 } else { 1.0 })
}

crate::state_struct! {
    /// History of one side, with positive displacements and forces.
    pub struct SideHistory {
        /// 1 if the envelope has been reached.
        yielded: f64,
        /// Displacement of the last unloading from the envelope.
        strain: f64,
        /// Force at that displacement.
        stress: f64,
        /// Displacement at which reloading reaches the envelope.
        target: f64,
        /// Force at that displacement.
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
        /// Previous path and side.
        before: f64,
        /// Displacement at the end of the previous path, or the last one on the path.
        turn: f64,
        /// Reloading stiffness.
        reloading: f64,
        /// Histories of both sides.
        sides: [SideHistory; 2],
    }
}

impl Saws {
    /// Returns `None` if the pinched line does not meet the envelope within twice the displacement at the largest
    /// force.
    pub fn new(wall: SawsParameters) -> Option<Self> {
        Self::of(wall, Consistent)
    }
}

impl Saws<OpenSees> {
    /// As `new`, by the rules of OpenSees.
    pub fn as_opensees(wall: SawsParameters) -> Option<Self> {
        Self::of(wall, OpenSees)
    }
}

/// A trial displacement on a path of the law.
#[derive(Clone, Copy)]
struct Position {
    path: Path,
    /// Sign of the side.
    s: f64,
    /// Index of the side.
    i: usize,
    /// Displacement towards the side.
    x: f64,
    /// Displacement of the last reversal towards the side.
    turn: f64,
    /// Path before this one, as a state variable.
    before: f64,
}

impl<R: Rules> Saws<R> {
    fn of(wall: SawsParameters, rules: R) -> Option<Self> {
        let mut made = Self { wall, rules, leaves: 0.0, ultimate: 0.0 };
        let far = 2.0 * made.wall.du;
        if made.curve(far).0 < made.pinched(far).0 {
            return None;
        }
        (made.leaves, made.ultimate) = (made.find_leaving(), made.find_ultimate());
        Some(made)
    }

    /// Force and slope of the exponential envelope.
    fn curve(&self, x: f64) -> (f64, f64) {
        let (asymptote, left) =
            (self.wall.fo + self.wall.r[0] * self.wall.so * x, (-self.wall.so * x / self.wall.fo).exp());
        let share = 1.0 - left;
        (asymptote * share, asymptote * self.wall.so / self.wall.fo * left + self.wall.r[0] * self.wall.so * share)
    }

    /// Force and slope of the softening line.
    fn softening(&self, x: f64) -> (f64, f64) {
        let slope = self.wall.r[1] * self.wall.so;
        (self.curve(self.wall.du).0 + slope * (x - self.wall.du), slope)
    }

    /// Force and slope of the pinched line.
    fn pinched(&self, x: f64) -> (f64, f64) {
        let slope = self.wall.r[3] * self.wall.so;
        (self.wall.fi + slope * x, slope)
    }

    /// Displacement at the intersection of an unloading line with the pinched line of the other side.
    fn unloading_intersection(&self, x: f64, force: f64) -> f64 {
        (force + self.wall.fi - self.wall.r[2] * self.wall.so * x) / (self.wall.so * (self.wall.r[3] - self.wall.r[2]))
    }

    /// Displacement at which all strength is lost: the softening line meets the pinched line or zero.
    fn find_ultimate(&self) -> f64 {
        let fu = self.curve(self.wall.du).0;
        let slope = self.wall.r[1] * self.wall.so;
        let pinched = (fu + self.wall.fi - slope * self.wall.du) / (self.wall.so * (self.wall.r[3] - self.wall.r[1]));
        pinched.min(self.wall.du - fu / slope)
    }

    /// Displacement at the intersection of pinched line and exponential envelope, by bisection.
    fn find_leaving(&self) -> f64 {
        let (mut low, mut high, mut middle) = (0.0, 2.0 * self.wall.du, self.wall.du);
        for _ in 0..MAX_BISECTIONS {
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

    /// Reloading stiffness towards a target, and displacement at the intersection of its line with the pinched line.
    fn reload(&self, side: &SideHistory, old: f64) -> (f64, f64) {
        let slope = if side.yielded == 0.0 {
            self.wall.so
        } else if side.target != 0.0 {
            self.wall.so * (self.wall.fo / self.wall.so / side.target).powf(self.wall.alpha)
        } else {
            old
        };
        (slope, self.reloading_intersection(side, slope))
    }

    fn reloading_intersection(&self, side: &SideHistory, slope: f64) -> f64 {
        (self.wall.fi - side.target_stress + slope * side.target) / (slope - self.wall.r[3] * self.wall.so)
    }
}

/// Paths that a step has passed.
#[derive(Clone, Copy, Default)]
struct PassedPaths {
    /// The pinched line of the negative side.
    negative: bool,
    /// Unloading from the envelope.
    unloading: bool,
}

/// Result of one path.
enum Next {
    /// Continue on another path of a side.
    To(Path, f64),
    /// Force and slope with the signs of the side; true if the displacement is stored as the last of the path.
    At(f64, (f64, f64), bool),
}

impl<R: Rules> Saws<R> {
    fn follow(&self, now: (Path, f64), u: f64, passed: PassedPaths, t: &mut History) -> Next {
        let (path, side) = now;
        let sign = if u >= 0.0 { 1.0 } else { -1.0 };
        let s = match path {
            Path::Failed | Path::Virgin | Path::Curve | Path::Softening | Path::Unloading => sign,
            _ => side,
        };
        let i = usize::from(s < 0.0);
        let (x, turn) = (s * u, s * t.turn);
        let before = t.before;
        let unload = self.unloading_stiffness();
        let at = Position { path, s, i, x, turn, before };
        match path {
            Path::Failed => Next::At(s, (FAILED_STIFFNESS * x, FAILED_STIFFNESS), false),
            Path::Virgin => {
                if x <= 1.05 * self.leaves {
                    return Next::At(s, self.curve(x), true);
                }
                t.before = word(Path::Virgin, 1.0);
                Next::To(Path::Curve, s)
            }
            Path::Curve | Path::Softening => self.follow_envelope(&at, passed, t),
            Path::Unloading => {
                if t.turn * u <= 0.0 && t.turn != 0.0 && (t.turn > 0.0 || u >= 0.0) {
                    t.before = word(Path::Unloading, 1.0);
                    return Next::To(Path::Across, t.turn.signum());
                }
                let r = t.sides[i];
                if x < self.unloading_intersection(r.strain, r.stress) {
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
                if x <= self.unloading_intersection(r.strain, r.stress) {
                    return Next::To(Path::Pinched, -s);
                }
                let force = r.stress + unload * (x - r.strain);
                if force > r.target_stress {
                    t.path = word(Path::Virgin, s);
                }
                Next::At(s, (force, unload), true)
            }
            Path::Pinched => self.follow_pinched(&at, passed, t),
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
            Path::Between | Path::Back => self.follow_inner(&at, t),
        }
    }

    /// Stiffness of unloading from the envelope, and between two pinched lines.
    fn unloading_stiffness(&self) -> f64 {
        self.wall.r[2] * self.wall.so
    }

    /// The envelope, before and after its peak.
    fn follow_envelope(&self, at: &Position, passed: PassedPaths, t: &mut History) -> Next {
        let Position { path, s, i, x, turn, .. } = *at;
        if path == Path::Curve && x > self.wall.du {
            return Next::To(Path::Softening, s);
        }
        // A step from the other side includes the unloading.
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
        t.sides[i] = SideHistory { yielded: 1.0, strain: x, stress: at.0, target, target_stress };
        t.before = word(path, 1.0);
        Next::At(s, at, true)
    }

    /// The pinched line through the intercept.
    fn follow_pinched(&self, at: &Position, passed: PassedPaths, t: &mut History) -> Next {
        let Position { s, i, x, turn, before, .. } = *at;
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

    /// Unloading from a pinched or a reloading line, and the way back to it.
    fn follow_inner(&self, at: &Position, t: &mut History) -> Next {
        let Position { path, s, i, x, turn, before } = *at;
        let unload = self.unloading_stiffness();
        let r = t.sides[i];
        let from = if path == Path::Between {
            self.pinched(turn).0
        } else {
            t.reloading = self.wall.so * (self.wall.fo / self.wall.so / r.target).powf(self.wall.alpha);
            if before == R::before_reloading(s) && x >= self.reloading_intersection(&r, t.reloading) {
                t.before = word(path, s);
                return Next::To(Path::Reloading, s);
            }
            r.target_stress + t.reloading * (turn - r.target)
        };
        if x > self.unloading_intersection(turn, from) && x < turn {
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

impl<R: Rules> UniaxialLaw for Saws<R> {
    type State = History;
    const NAME: &'static str = "SAWS";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let u = strain.value;
        let mut t = History { strain: u, ..*c };
        if u.abs() >= self.ultimate {
            t.path = word(Path::Failed, 1.0);
        }
        let mut passed = PassedPaths::default();
        for _ in 0..MAX_PATHS {
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
                        Err(no_force_error(u))
                    };
                }
            }
        }
        Err(no_force_error(u))
    }

    fn initial_tangent(&self) -> f64 {
        self.wall.so
    }
}

fn no_force_error(u: f64) -> MaterialError {
    MaterialError(format!("SAWS has no force at a displacement of {u:.6e}"))
}
