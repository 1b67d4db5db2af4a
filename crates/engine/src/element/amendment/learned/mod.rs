//! Learned laws: a spring, hysteresis and viscous parts with factors of slow variables, found from recordings.
//!
//! f = g_E(q) E(u) + g_H(q) H(u; g_S(q)) + g_X(q) X(u, u̇) + F, each g = 1 + Σ a φ(q),
//!
//! with slow variables φ of the committed history. A law replaces the force of an element, or scales it
//! ([`Shape::Own`]). It makes no energy by construction ([`LearnedLaw::refusal`]).
//!
//! - [`operators`]: one step of stops, hysteresis and filters
//! - [`History`], [`Variable`]: what is remembered
//! - [`LearnedLaw`]: the law of one direction
//! - [`LawOption`]: the law in words

mod history;
mod law;
pub mod operators;
mod options;
mod passive;
mod variable;

use super::{AmendedForce, Amendment, DeformationState, OutsideRange, Slack, Weakening};
use crate::element::{ElementError, ElementResult, Histories};
use crate::series::Series;
use crate::state_struct::StateStruct;
use std::sync::Arc;

pub use history::{History, Scales};
pub use law::{Channel, ChannelForce, FACTOR_RANGE, Factor, LawForce, LawStep, LearnedLaw, Piece, Shape, Target};
pub use options::{LawOption, OPTIONS, OptionError, VARIABLES};
pub use passive::{Admitted, Refusal, admitted};
pub use variable::{Moment, Variable};

/// Source of a channel of a learned law in a model.
#[derive(Clone, Debug)]
pub enum Source {
    /// A function of time.
    Series(Series),
    /// The compression of the element, at the committed state.
    Axial,
}

/// Largest number of channels of a law.
pub const MAX_CHANNELS: usize = 8;

/// A learned law around an element, in each amended direction by itself.
#[derive(Clone, Debug)]
pub struct Learned {
    law: LearnedLaw,
    sources: Vec<Source>,
}

impl Learned {
    /// A law with the sources of its channels.
    ///
    /// # Errors
    /// Numbers of channels and sources that differ, or are above [`MAX_CHANNELS`].
    pub fn new(law: LearnedLaw, sources: Vec<Source>) -> ElementResult<Self> {
        if law.channels.len() != sources.len() || sources.len() > MAX_CHANNELS {
            let message = format!(
                "the law has {} channels and {} sources of them; at most {MAX_CHANNELS} are possible",
                law.channels.len(),
                sources.len()
            );
            return Err(ElementError(message.into()));
        }
        Ok(Self { law, sources })
    }

    /// The law.
    pub fn law(&self) -> &LearnedLaw {
        &self.law
    }
}

impl Amendment for Learned {
    fn name(&self) -> &'static str {
        "learned"
    }
    fn state_len(&self) -> usize {
        2 * self.law.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn amend(&self, both: &mut Histories<'_>, d: &DeformationState) -> ElementResult<AmendedForce> {
        let mut out = AmendedForce::default();
        let n = self.law.state_len();
        for i in 0..2 {
            let Histories { committed: own, trial: to } = both.part(i * n..(i + 1) * n);
            let h = History::read(own);
            let axial = if h.steps > 0.0 { h.axial } else { d.axial };
            let mut channels = [0.0; MAX_CHANNELS];
            for (k, (x, source)) in channels.iter_mut().zip(&self.sources).enumerate() {
                let value = match source {
                    Source::Series(s) => s.factor(d.time),
                    Source::Axial => axial,
                };
                *x = self.law.scaled_channel(k, value);
            }
            let channels = &channels[..self.sources.len()];
            let step = LawStep { deformation: d.e[i], dt: d.dt, own: d.q[i], channels };
            let f = self.law.step(own, &step, to);
            History { axial: d.axial, ..History::read(to) }.write(to);
            out.q[i] = f.force;
            out.by_deformation[i][i] = f.by_deformation;
            out.by_force[i][i] = f.by_own;
        }
        Ok(out)
    }
    fn slack(&self, _: &[f64], _: f64) -> Option<Slack> {
        None
    }
    fn weakening(&self, _: &[f64]) -> Option<Weakening> {
        None
    }
    fn depends_on_time(&self) -> bool {
        true
    }
    fn with_stiffness(&self, _: f64) -> Option<Arc<dyn Amendment>> {
        None
    }
    fn outside_range(&self, committed: &[f64]) -> Option<OutsideRange> {
        let n = self.law.state_len();
        let [a, b] = [History::read(committed), History::read(&committed[n..])];
        let most = if b.outside > a.outside { b } else { a };
        (most.outside > 0.0).then_some(OutsideRange { steps: most.steps, outside: most.outside })
    }
}
