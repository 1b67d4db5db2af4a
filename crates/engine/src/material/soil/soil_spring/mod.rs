//! Soil springs of piles: a plastic near field, a gap, and an elastic far field with a dashpot, in series.
//!
//! Sources: Boulanger, Curras, Kutter, Wilson and Abghari (1999),
//! <https://doi.org/10.1061/(ASCE)1090-0241(1999)125:9(750)>; Boulanger (2003), the documentation of `PySimple1`,
//! `TzSimple1` and `QzSimple1`.

mod branch;
mod opensees;
mod py_simple1;
mod qz_simple1;
mod tz_simple1;
mod zone;

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::bracketed_root;
use opensees::SpringIncrement;
use std::fmt;

use branch::Reversal;
pub use py_simple1::{PyBackbone, PySimple1};
pub use qz_simple1::{QzBackbone, QzSimple1};
pub use tz_simple1::{TzBackbone, TzSimple1};

/// Force tolerance divided by the ultimate force, as in OpenSees.
const TOLERANCE: f64 = 1e-12;
/// Maximum number of iterations for the common force.
const MAX_ITERATIONS: u32 = 300;
/// Smallest damping divided by the stiffness of the far field.
const MIN_DAMPING_RATIO: f64 = 1e-12;

crate::state_struct! {
    /// State of one spring.
    pub struct SpringState {
        /// Displacement.
        y: f64,
        /// Force.
        p: f64,
        /// Tangent.
        tangent: f64,
    }
}

crate::state_struct! {
    /// State of the plastic near-field spring.
    pub struct NearField {
        /// The spring.
        spring: SpringState,
        /// Bounds of the elastic zone, the one at the greater force first; or the last reversal alone.
        reversals: [Reversal; 2],
        /// Half the height of the elastic zone divided by the ultimate force.
        elastic: f64,
    }
}

crate::state_struct! {
    /// State of the gap: closure and drag in parallel.
    pub struct Gap {
        /// The spring.
        spring: SpringState,
        /// The drag spring.
        drag_spring: SpringState,
        /// Last reversal of the drag spring.
        reversal: Reversal,
        /// Displacements at which the gap closes, left and right.
        closed: [f64; 2],
    }
}

crate::state_struct! {
    /// History of [`SoilSpring`].
    pub struct History {
        /// The series of springs.
        total: SpringState,
        /// The plastic near-field spring.
        near: NearField,
        /// The gap.
        gap: Gap,
        /// The elastic far-field spring.
        far: SpringState,
        /// Number of steps; identifies the trial states of the current step.
        steps: f64,
    }
}

/// Properties that distinguish p-y, t-z and q-z springs.
pub trait Soil: Clone + fmt::Debug + Send + Sync + 'static {
    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;
    /// True if the iterations of OpenSees bound the force by the ultimate force.
    const BOUNDED: bool;

    /// Ultimate force.
    fn ultimate_force(&self) -> f64;
    /// Displacement at half the ultimate force.
    fn y50(&self) -> f64;
    /// Stiffness of the far-field spring.
    fn far_stiffness(&self) -> f64;
    /// Virgin near field and gap. A rigid spring has an infinite tangent.
    fn virgin(&self) -> (NearField, Gap);
    /// Near field at the force `p`, from its committed state.
    fn near_field_at(&self, c: &NearField, p: f64) -> NearField;
    /// Gap at the force `p`, from its committed state, for a near-field displacement `near`; and the derivative of
    /// its displacement with respect to `near`.
    fn gap_at(&self, c: &Gap, near: f64, p: f64) -> (Gap, f64);
    /// Advances the trial state of the near field by a step, as in OpenSees.
    fn advance_near_field(&self, c: &NearField, t: &mut NearField, step: SpringIncrement);
    /// Advances the trial state of the gap by a step, as in OpenSees, for a near-field displacement `near`.
    fn advance_gap(&self, c: &Gap, t: &mut Gap, near: f64, step: SpringIncrement);
}

/// Three springs in series, with a dashpot in parallel with the far field.
#[derive(Clone, Debug, PartialEq)]
pub struct SoilSpring<S> {
    /// The soil.
    pub soil: S,
    /// Dashpot coefficient, force over velocity.
    pub dashpot: f64,
    /// As in OpenSees: a bounded number of iterations distributes the force from the last trial state. The tangent
    /// omits the change of the dashpot's share.
    pub compat: bool,
}

/// The force bounded by `limit` minus the tolerance.
fn bounded(p: f64, limit: f64) -> f64 {
    if p.abs() >= (1.0 - TOLERANCE) * limit { (1.0 - TOLERANCE) * limit.copysign(p) } else { p }
}

impl<S: Soil> SoilSpring<S> {
    fn virgin(&self) -> History {
        let (near, gap) = self.soil.virgin();
        let far = SpringState { tangent: self.soil.far_stiffness(), ..SpringState::default() };
        let mut h = History { near, gap, far, ..History::default() };
        h.total.tangent = Self::tangent(&h);
        h
    }

    fn tangent(h: &History) -> f64 {
        1.0 / (1.0 / h.gap.spring.tangent + 1.0 / h.near.spring.tangent + 1.0 / h.far.tangent)
    }

    /// State of the springs at the common force whose displacements sum to `y`.
    fn balanced(&self, c: &History, y: f64) -> Option<History> {
        let far = self.soil.far_stiffness();
        let at = |p: f64| {
            let near = self.soil.near_field_at(&c.near, p);
            let (gap, follows) = self.soil.gap_at(&c.gap, near.spring.y, p);
            let slope = (1.0 + follows) / near.spring.tangent + 1.0 / gap.spring.tangent + 1.0 / far;
            (near, gap, slope)
        };
        let beyond = |p: f64| {
            let (near, gap, slope) = at(p);
            (near.spring.y + gap.spring.y + p / far - y, slope)
        };
        let limit = (1.0 - TOLERANCE) * self.soil.ultimate_force();
        let p = if beyond(limit).0 <= 0.0 {
            limit
        } else if beyond(-limit).0 >= 0.0 {
            -limit
        } else {
            bracketed_root(beyond, (-limit, limit), c.total.p, limit, MAX_ITERATIONS)?
        };
        let (near, gap, slope) = at(p);
        let total = SpringState { y, p, tangent: 1.0 / slope };
        Some(History { total, near, gap, far: SpringState { y: p / far, p, tangent: far }, steps: c.steps })
    }

    /// Share of the far field in the displacement increment, and its derivative with respect to the increment.
    fn far_field_share(c: &History, t: &History) -> (f64, f64) {
        let dy = t.total.y - c.total.y;
        if dy == 0.0 {
            return (t.total.tangent / t.far.tangent, 0.0);
        }
        let part = (t.far.y - c.far.y) / dy;
        let inside = (0.0..=1.0).contains(&part);
        (part.clamp(0.0, 1.0), if inside { (t.total.tangent / t.far.tangent - part) / dy } else { 0.0 })
    }
}

impl<S: Soil> UniaxialLaw for SoilSpring<S> {
    type State = History;
    const NAME: &'static str = S::NAME;

    fn update(&self, committed: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.update_on(committed, committed, strain)
    }

    fn update_on(&self, c: &History, last: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let virgin = self.virgin();
        let c = if c.far.tangent == 0.0 { &virgin } else { c };
        let steps = c.steps + 1.0;
        let t = if self.compat {
            self.iterated(c, if last.steps == steps { *last } else { *c }, strain.value)
        } else {
            let none = || MaterialError(format!("{} has no force at {:.6e}", S::NAME, strain.value));
            self.balanced(c, strain.value).ok_or_else(none)?
        };
        let t = History { steps, ..t };
        let (part, more) = Self::far_field_share(c, &t);
        let force = t.total.p + self.dashpot * strain.rate * part;
        let limited = bounded(force, self.soil.ultimate_force());
        let damping = if limited == force { (self.dashpot * part).max(MIN_DAMPING_RATIO * t.far.tangent) } else { 0.0 };
        let exact = !self.compat && limited == force;
        let tangent = t.total.tangent + if exact { self.dashpot * strain.rate * more } else { 0.0 };
        if !force.is_finite() || !tangent.is_finite() {
            return Err(MaterialError(format!("{} has no force at {:.6e}", S::NAME, strain.value)));
        }
        Ok((Stress { value: limited, tangent, damping }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.virgin().total.tangent
    }

    fn is_viscous(&self) -> bool {
        self.dashpot > 0.0
    }
}
