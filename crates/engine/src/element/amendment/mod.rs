//! Laws that change what an element answers: physics that its own law leaves out.
//!
//! An [`Amended`] element asks the element that it stands around, and hands force and deformation of one direction,
//! or of two that act together, to an amendment. So softening, heating or pinching can be added to any spring or
//! bearing of an existing script, whatever its law. An amendment is a pure function of its committed history, one
//! file each; [`Share`] says which part of the force it concerns.

mod amended;
mod axial;
mod bristles;
mod cavitation;
mod coupling;
mod damping;
mod degradation;
mod friction;
mod gap;
mod heating;
mod hinged;
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

use super::ElementError;
use crate::state_struct::StateStruct;
use std::fmt;
use std::sync::Arc;

pub use amended::Amended;
pub use axial::Axial;
pub use bristles::Bristles;
pub use cavitation::Cavitation;
pub use coupling::Coupling;
pub use damping::Damping;
pub use degradation::Degradation;
pub use friction::Friction;
pub use gap::{Gap, Sides};
pub use heating::Heating;
pub use hinged::Hinged;
pub use mullins::Mullins;
pub use overstress::Overstress;
pub use peak_oriented::PeakOriented;
pub use pinching::Pinching;
pub use pressure::Pressure;
pub use relaxation::Relaxation;
pub use share::{Share, Weakening};
pub use slack::{Slack, SlackShare};
pub use sliding::Sliding;
pub use slip::Slip;
pub use stiffening::Stiffening;
pub use temperature::Temperature;
pub use yielding::Yielding;

/// Two directions; the second is zero where only one is amended.
pub type Pair = [f64; 2];

/// What an amendment is given.
#[derive(Clone, Copy, Debug, Default)]
pub struct DeformationState {
    /// Trial deformation.
    pub e: Pair,
    /// Committed deformation.
    pub before: Pair,
    /// Force of the element as it stands.
    pub q: Pair,
    /// Its axial force, compression positive.
    pub axial: f64,
    /// Domain time since the committed state.
    pub dt: f64,
    /// What the slack of the law has taken of the deformation: the force is that of the rest.
    pub slack: SlackShare,
}

impl DeformationState {
    /// |e|.
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

/// What an amendment answers: the force, and its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AmendedForce {
    /// Amended force.
    pub q: Pair,
    /// d(amended force)/d(force of the element), by rows.
    pub by_force: [Pair; 2],
    /// d(amended force)/d(deformation) at constant force of the element.
    pub by_deformation: [Pair; 2],
    /// d(amended force)/d(axial force).
    pub by_axial: Pair,
}

impl AmendedForce {
    /// The force as it is.
    pub fn unchanged(q: Pair) -> Self {
        Self { q, by_force: [[1.0, 0.0], [0.0, 1.0]], ..Self::default() }
    }
}

/// A law of amendment with a fixed number of history variables.
pub trait AmendmentLaw: fmt::Debug + Send + Sync + 'static {
    /// History; `default()` must be the virgin state.
    type State: StateStruct;

    /// Name in the `amend` command.
    const NAME: &'static str;

    /// Amended force and next history.
    fn amend(
        &self,
        committed: &Self::State,
        demand: &DeformationState,
    ) -> Result<(AmendedForce, Self::State), ElementError>;

    /// Slack that the element does not get of its deformation.
    fn slack(&self, _committed: &Self::State) -> Option<Slack> {
        None
    }

    /// Strength that the element has lost.
    fn weakening(&self, _committed: &Self::State) -> Option<Weakening> {
        None
    }

    /// Whether the force depends on the time that passes.
    fn depends_on_time(&self) -> bool {
        false
    }

    /// The law for another stiffness of the element; `None` if it does not use that stiffness.
    fn with_stiffness(&self, _stiffness: f64) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }
}

/// A law of amendment of any kind.
pub trait Amendment: fmt::Debug + Send + Sync {
    /// Name in the `amend` command.
    fn name(&self) -> &'static str;
    /// Number of words of history.
    fn state_len(&self) -> usize;
    /// Write the virgin state.
    fn init(&self, state: &mut [f64]);
    /// Amended force; writes every word of `next`.
    fn amend(
        &self,
        committed: &[f64],
        demand: &DeformationState,
        next: &mut [f64],
    ) -> Result<AmendedForce, ElementError>;
    /// Slack that the element does not get of its deformation.
    fn slack(&self, committed: &[f64]) -> Option<Slack>;
    /// Strength that the element has lost.
    fn weakening(&self, committed: &[f64]) -> Option<Weakening>;
    /// Whether the force depends on the time that passes.
    fn depends_on_time(&self) -> bool;
    /// The law for another stiffness of the element; `None` if it does not use that stiffness.
    fn with_stiffness(&self, stiffness: f64) -> Option<Arc<dyn Amendment>>;
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
    fn amend(
        &self,
        committed: &[f64],
        demand: &DeformationState,
        next: &mut [f64],
    ) -> Result<AmendedForce, ElementError> {
        let (amended, state) = AmendmentLaw::amend(self, &L::State::read(committed), demand)?;
        state.write(next);
        Ok(amended)
    }
    fn slack(&self, committed: &[f64]) -> Option<Slack> {
        AmendmentLaw::slack(self, &L::State::read(committed))
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
}
