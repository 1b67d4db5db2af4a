//! Amendments: laws that change the force of an element, for physics that its own law lacks.
//!
//! [`Amended`] evaluates the element, then passes force and deformation of one direction, or of two coupled ones, to an
//! [`Amendment`]. Softening, heating or pinching can thus be added to any spring or bearing of a script. An amendment
//! is a pure function of its committed state variables. Each law has a file of its own. [`Share`] selects the part of
//! the force that a law changes.

mod amended;
mod axial;
mod bristles;
mod cavitation;
mod coupling;
mod creep;
mod damping;
mod degradation;
mod friction;
mod gap;
mod heating;
mod hinged;
pub mod learned;
mod mullins;
mod overstress;
mod peak_oriented;
mod pinching;
mod pressure;
mod relaxation;
mod share;
mod slack;
mod sliding;
mod slip;
mod stiffening;
mod temperature;
mod yielding;

use super::{ElementResult, Histories};
use crate::state_struct::StateStruct;
use std::fmt;
use std::sync::Arc;

pub use amended::Amended;
pub use axial::Axial;
pub use bristles::Bristles;
pub use cavitation::Cavitation;
pub use coupling::Coupling;
pub use creep::Creep;
pub use damping::Damping;
pub use degradation::Degradation;
pub use friction::Friction;
pub use gap::{Gap, Sides};
pub use heating::Heating;
pub use hinged::Hinged;
pub use learned::Learned;
pub use mullins::Mullins;
pub use overstress::Overstress;
pub use peak_oriented::PeakOriented;
pub use pinching::Pinching;
pub use pressure::Pressure;
pub use relaxation::Relaxation;
pub use share::{Share, Weakening};
pub use slack::{Slack, SlackCurve, SlackShare};
pub use sliding::Sliding;
pub use slip::Slip;
pub use stiffening::Stiffening;
pub use temperature::Temperature;
pub use yielding::Yielding;

/// Values in two directions; the second is 0 if only one direction is amended.
pub type Pair = [f64; 2];

/// Input of an amendment at a trial state.
#[derive(Clone, Copy, Debug, Default)]
pub struct DeformationState {
    /// Trial deformation.
    pub e: Pair,
    /// Committed deformation.
    pub before: Pair,
    /// Force of the unamended element.
    pub q: Pair,
    /// Axial force of the element, positive in compression.
    pub axial: f64,
    /// Domain time since the committed state.
    pub dt: f64,
    /// Domain time of the trial state.
    pub time: f64,
    /// Slack of the law: `q` is the force at the deformation less the slack.
    pub slack: SlackShare,
}

impl DeformationState {
    /// Size of the deformation |e|.
    pub fn amplitude(&self) -> f64 {
        self.e[0].hypot(self.e[1])
    }

    /// Increment of deformation over the step.
    pub fn increment(&self) -> Pair {
        [self.e[0] - self.before[0], self.e[1] - self.before[1]]
    }

    /// d|e|/de; zero at rest.
    pub fn radial(&self) -> Pair {
        let r = self.amplitude();
        if r > 0.0 { self.e.map(|e| e / r) } else { [0.0; 2] }
    }
}

/// Response of an amendment: the force and its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AmendedForce {
    /// Amended force.
    pub q: Pair,
    /// ∂q'/∂q by rows, for the amended force q' and the element's force q.
    pub by_force: [Pair; 2],
    /// ∂q'/∂e at constant q, by rows.
    pub by_deformation: [Pair; 2],
    /// ∂q'/∂(axial force).
    pub by_axial: Pair,
}

impl AmendedForce {
    /// The unamended force `q` with its derivatives.
    pub fn unchanged(q: Pair) -> Self {
        Self { q, by_force: [[1.0, 0.0], [0.0, 1.0]], ..Self::default() }
    }
}

/// Steps of a law outside the range for which it was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideRange {
    /// Number of steps.
    pub steps: f64,
    /// Number of those outside.
    pub outside: f64,
}

/// An amendment with state variables of a fixed number.
pub trait AmendmentLaw: fmt::Debug + Send + Sync + 'static {
    /// State variables; `default()` must be the virgin state.
    type State: StateStruct;

    /// Name in the `amend` command.
    const NAME: &'static str;

    /// Amended force and trial state variables.
    ///
    /// # Errors
    /// The law's equation has no solution for the step.
    fn amend(&self, committed: &Self::State, demand: &DeformationState) -> ElementResult<(AmendedForce, Self::State)>;

    /// Slack in series with the element, at the end of an increment of time.
    fn slack(&self, _committed: &Self::State, _dt: f64) -> Option<Slack> {
        None
    }

    /// Loss of strength of the element, at the committed state.
    fn weakening(&self, _committed: &Self::State) -> Option<Weakening> {
        None
    }

    /// Returns true if the force depends on the increment of time.
    fn depends_on_time(&self) -> bool {
        false
    }

    /// The law for another stiffness of the element; `None` if the law does not use that stiffness.
    fn with_stiffness(&self, _stiffness: f64) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }
}

/// An amendment of any kind.
pub trait Amendment: fmt::Debug + Send + Sync {
    /// Name in the `amend` command.
    fn name(&self) -> &'static str;
    /// Number of state variables.
    fn state_len(&self) -> usize;
    /// Writes the virgin state variables.
    fn init(&self, state: &mut [f64]);
    /// Amended force; writes the whole trial history.
    ///
    /// # Errors
    /// The law's equation has no solution for the step.
    fn amend(&self, h: &mut Histories<'_>, demand: &DeformationState) -> ElementResult<AmendedForce>;
    /// Slack in series with the element, at the end of an increment of time.
    fn slack(&self, committed: &[f64], dt: f64) -> Option<Slack>;
    /// Loss of strength of the element, at the committed state.
    fn weakening(&self, committed: &[f64]) -> Option<Weakening>;
    /// Returns true if the force depends on the increment of time.
    fn depends_on_time(&self) -> bool;
    /// The law for another stiffness of the element; `None` if the law does not use that stiffness.
    fn with_stiffness(&self, stiffness: f64) -> Option<Arc<dyn Amendment>>;
    /// Steps outside the range of the law up to a committed state; `None` where there are none.
    fn outside_range(&self, committed: &[f64]) -> Option<OutsideRange>;
}

impl<L: AmendmentLaw> Amendment for L {
    fn name(&self) -> &'static str {
        L::NAME
    }
    fn state_len(&self) -> usize {
        L::State::LEN
    }
    fn init(&self, state: &mut [f64]) {
        L::State::default().write(state);
    }
    fn amend(&self, h: &mut Histories<'_>, demand: &DeformationState) -> ElementResult<AmendedForce> {
        let (amended, state) = AmendmentLaw::amend(self, &L::State::read(h.committed), demand)?;
        state.write(h.trial);
        Ok(amended)
    }
    fn slack(&self, committed: &[f64], dt: f64) -> Option<Slack> {
        AmendmentLaw::slack(self, &L::State::read(committed), dt)
    }
    fn weakening(&self, committed: &[f64]) -> Option<Weakening> {
        AmendmentLaw::weakening(self, &L::State::read(committed))
    }
    fn depends_on_time(&self) -> bool {
        AmendmentLaw::depends_on_time(self)
    }
    fn with_stiffness(&self, stiffness: f64) -> Option<Arc<dyn Amendment>> {
        Some(Arc::new(AmendmentLaw::with_stiffness(self, stiffness)?))
    }
    // These laws have no range.
    fn outside_range(&self, _: &[f64]) -> Option<OutsideRange> {
        None
    }
}
