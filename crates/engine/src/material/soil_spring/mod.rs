//! Springs between piles and soil: three springs in series, of which one yields, one may open, and one is elastic with a dashpot.
//!
//! Boulanger, Curras, Kutter, Wilson and Abghari (1999), <https://doi.org/10.1061/(ASCE)1090-0241(1999)125:9(750)>; Boulanger (2003),
//! the documentation of `PySimple1`, `TzSimple1` and `QzSimple1`.

mod branch;
mod opensees;
mod py_simple1;
mod qz_simple1;
mod tz_simple1;
mod zone;

use super::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::numeric::bracketed_root;
use opensees::Step;
use std::fmt;

use branch::Turn;
pub use py_simple1::{PyBackbone, PySimple1};
pub use qz_simple1::{QzBackbone, QzSimple1};
pub use tz_simple1::{TzBackbone, TzSimple1};

/// What counts as nothing, as a part of the ultimate force.
const TOLERANCE: f64 = 1e-12;
/// Forces that are tried at most until the displacements of the springs add up.
const ROUNDS_AT_MOST: u32 = 300;
/// The least damping, as a part of the stiffness of the far field.
const LEAST_DAMPING: f64 = 1e-12;

crate::state_struct! {
    /// A spring.
    pub struct Part {
        /// Displacement.
        y: f64,
        /// Force.
        p: f64,
        /// Tangent.
        tangent: f64,
    }
}

crate::state_struct! {
    /// The spring that yields.
    pub struct Near {
        /// It.
        spring: Part,
        /// Where it turned: the bounds of the elastic zone, the one at greater forces first, or the last turn alone.
        turns: [Turn; 2],
        /// Half the height of the elastic zone, as a part of the ultimate force.
        elastic: f64,
    }
}

crate::state_struct! {
    /// The spring that opens, of two in parallel.
    pub struct Gap {
        /// It.
        spring: Part,
        /// What is dragged along in it.
        dragged: Part,
        /// Where that turned.
        turn: Turn,
        /// Displacements at which it is closed to the left and to the right.
        closed: [f64; 2],
    }
}

crate::state_struct! {
    /// History of [`SoilSpring`].
    pub struct History {
        /// All of it.
        whole: Part,
        /// The spring that yields.
        near: Near,
        /// The spring that opens.
        gap: Gap,
        /// The elastic spring.
        far: Part,
        /// Steps so far, by which trial states of a step are known.
        steps: f64,
    }
}

/// What the kinds of springs differ in.
pub trait Soil: Clone + fmt::Debug + Send + Sync + 'static {
    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;
    /// The force on the springs never exceeds the ultimate one while it is distributed.
    const BOUNDED: bool;

    /// Ultimate force.
    fn ultimate(&self) -> f64;
    /// Displacement at half of it.
    fn y50(&self) -> f64;
    /// Stiffness of the elastic spring.
    fn far(&self) -> f64;
    /// The other two before anything has happened. A rigid one has an infinite tangent.
    fn virgin(&self) -> (Near, Gap);
    /// The spring that yields, from its committed state to a force.
    fn yields(&self, c: &Near, p: f64) -> Near;
    /// The spring that opens, from its committed state to a force, where the one that yields stands; and by how much it moves with that.
    fn opens(&self, c: &Gap, near: f64, p: f64) -> (Gap, f64);
    /// The spring that yields goes on from a trial state, as in OpenSees.
    fn yields_on(&self, c: &Near, t: &mut Near, step: Step);
    /// The spring that opens goes on from a trial state, as in OpenSees, where the one that yields stands.
    fn opens_on(&self, c: &Gap, t: &mut Gap, near: f64, step: Step);
}

/// Three springs in series, with a dashpot beside the elastic one.
#[derive(Clone, Debug, PartialEq)]
pub struct SoilSpring<S> {
    /// What kind of soil.
    pub soil: S,
    /// Coefficient of the dashpot.
    pub dashpot: f64,
    /// As in OpenSees: the force is distributed step by step from the trial state before, so often and no oftener, and the tangent does not
    /// know how the share of the dashpot changes.
    pub compat: bool,
}

/// The force that is nearer to zero than a limit.
fn below(p: f64, limit: f64) -> f64 {
    if p.abs() >= (1.0 - TOLERANCE) * limit { (1.0 - TOLERANCE) * limit.copysign(p) } else { p }
}

impl<S: Soil> SoilSpring<S> {
    fn virgin(&self) -> History {
        let (near, gap) = self.soil.virgin();
        let far = Part { tangent: self.soil.far(), ..Part::default() };
        let mut h = History { near, gap, far, ..History::default() };
        h.whole.tangent = Self::tangent(&h);
        h
    }

    fn tangent(h: &History) -> f64 {
        1.0 / (1.0 / h.gap.spring.tangent + 1.0 / h.near.spring.tangent + 1.0 / h.far.tangent)
    }

    /// The springs at one force whose displacements add up to `y`.
    fn balanced(&self, c: &History, y: f64) -> Option<History> {
        let far = self.soil.far();
        let at = |p: f64| {
            let near = self.soil.yields(&c.near, p);
            let (gap, follows) = self.soil.opens(&c.gap, near.spring.y, p);
            let slope = (1.0 + follows) / near.spring.tangent + 1.0 / gap.spring.tangent + 1.0 / far;
            (near, gap, slope)
        };
        let beyond = |p: f64| {
            let (near, gap, slope) = at(p);
            (near.spring.y + gap.spring.y + p / far - y, slope)
        };
        let limit = (1.0 - TOLERANCE) * self.soil.ultimate();
        let p = if beyond(limit).0 <= 0.0 {
            limit
        } else if beyond(-limit).0 >= 0.0 {
            -limit
        } else {
            bracketed_root(beyond, (-limit, limit), c.whole.p, limit, ROUNDS_AT_MOST)?
        };
        let (near, gap, slope) = at(p);
        let whole = Part { y, p, tangent: 1.0 / slope };
        Some(History { whole, near, gap, far: Part { y: p / far, p, tangent: far }, steps: c.steps })
    }

    /// Part of the step that the elastic spring takes, and how it changes with the step.
    fn of_far_field(c: &History, t: &History) -> (f64, f64) {
        let dy = t.whole.y - c.whole.y;
        if dy == 0.0 {
            return (t.whole.tangent / t.far.tangent, 0.0);
        }
        let part = (t.far.y - c.far.y) / dy;
        let inside = (0.0..=1.0).contains(&part);
        (part.clamp(0.0, 1.0), if inside { (t.whole.tangent / t.far.tangent - part) / dy } else { 0.0 })
    }
}

impl<S: Soil> UniaxialLaw for SoilSpring<S> {
    type State = History;
    const NAME: &'static str = S::NAME;

    fn update(&self, committed: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let virgin = self.virgin();
        let c = if c.far.tangent == 0.0 { &virgin } else { c };
        let steps = c.steps + 1.0;
        let t = if self.compat {
            self.from_trial(c, if last.steps == steps { *last } else { *c }, strain.value)
        } else {
            let none = || MaterialError(format!("{} has no force at {:.6e}", S::NAME, strain.value));
            self.balanced(c, strain.value).ok_or_else(none)?
        };
        let t = History { steps, ..t };
        let (part, more) = Self::of_far_field(c, &t);
        let force = t.whole.p + self.dashpot * strain.rate * part;
        let limited = below(force, self.soil.ultimate());
        let damping = if limited == force { (self.dashpot * part).max(LEAST_DAMPING * t.far.tangent) } else { 0.0 };
        let exact = !self.compat && limited == force;
        let tangent = t.whole.tangent + if exact { self.dashpot * strain.rate * more } else { 0.0 };
        if !force.is_finite() || !tangent.is_finite() {
            return Err(MaterialError(format!("{} has no force at {:.6e}", S::NAME, strain.value)));
        }
        Ok((Stress { value: limited, tangent, damping }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.virgin().whole.tangent
    }

    fn is_viscous(&self) -> bool {
        self.dashpot > 0.0
    }
}
