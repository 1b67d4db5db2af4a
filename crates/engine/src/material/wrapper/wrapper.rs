//! Laws around other laws.

use crate::material::roles::{LawParameters, LawResponses, ShownStrain, TrialTrace, UniaxialRoles};
use crate::material::{
    LimitCurve, Material, MaterialResult, ObservedColumns, SharedUniaxial, Slot, Strain, Stress, Uniaxial,
    UniaxialTraits, WatchesColumns, updates_each_point,
};
use crate::parameter::{Changed, NewValue, existing, last_of};
use crate::probe::Probe;
use std::fmt;
use std::sync::Arc;

/// What a law does with the laws inside it. [`Wrapped`] makes a law of it, and forwards all the rest.
pub trait Wrapper: fmt::Debug + Clone + Send + Sync + 'static {
    /// Name in the `uniaxialMaterial` command.
    const NAME: &'static str;
    /// Number of state variables in front of those of the laws inside.
    const HEADER: usize;
    /// The laws inside are named by their numbers. Without it the wrapper holds one law, and passes on what it does not know.
    const NUMBERED: bool;

    /// Writes the virgin state variables in front of those of the laws inside.
    fn init(&self, own: &mut [f64], inner: &[Slot]);
    /// Stress and next state from the committed state.
    ///
    /// # Errors
    /// A law inside has no response at this strain.
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress>;
    /// Tangent of the virgin material.
    fn initial_tangent(&self, inner: &[Slot]) -> f64;
    /// Its constant properties, from those of the laws inside in parallel.
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits;
    /// Returns true if the laws inside have ended: their histories change no more.
    fn has_failed(&self, state: &[f64]) -> bool;
    /// Strain in recorders for a strain of the material.
    fn shown_strain(&self, inner: &[Slot], strain: f64, state: &[f64]) -> f64;
    /// Response of the wrapper itself.
    fn probe(&self, inner: &[Slot], word: &str) -> Option<Probe>;
    /// Value of such a response, by the first number of its path.
    fn read(&self, inner: &[Slot], id: u32, state: &[f64], out: &mut [f64]);
}

/// First number of the path of a response of the law inside with the next number: one that every law has or its own.
const SLOT: u32 = 1000;
/// The same, of one that is specific to the law.
const LAW: u32 = 1001;

/// A law around others. Its state variables are those of the wrapper, followed by those of the laws inside.
#[derive(Clone, Debug)]
pub struct Wrapped<W> {
    wrapper: W,
    inner: Vec<Slot>,
    state_len: usize,
}

impl<W: Wrapper> Wrapped<W> {
    /// Wraps laws, each given with its tag.
    pub(super) fn around(wrapper: W, laws: impl IntoIterator<Item = (Material, i32)>) -> Self {
        let (inner, state_len) = Slot::pack(laws, W::HEADER);
        Self { wrapper, inner, state_len }
    }

    /// Law inside by the words that follow `material`, and the words after them.
    fn chosen<'a, 'b>(&self, words: &'a [&'b str]) -> Option<(usize, &'a [&'b str])> {
        if !W::NUMBERED {
            return Some((0, words));
        }
        let (number, rest) = words.split_first()?;
        let i = number.parse::<usize>().ok()?.checked_sub(1)?;
        (i < self.inner.len()).then_some((i, rest))
    }
}

impl<W: Wrapper> WatchesColumns for Wrapped<W> {
    fn limit_curves(&self) -> Vec<&LimitCurve> {
        self.inner.iter().flat_map(Slot::limit_curves).collect()
    }
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>) {
        if !self.wrapper.has_failed(committed) {
            self.inner.iter().for_each(|slot| slot.observe(committed, columns));
        }
    }
}

#[deny(clippy::missing_trait_methods)]
impl<W: Wrapper> Uniaxial for Wrapped<W> {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        W::NAME
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.wrapper.init(&mut state[..W::HEADER], &self.inner);
        self.inner.iter().for_each(|slot| slot.init(state));
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        self.wrapper.update(&self.inner, committed, strain, next)
    }
    fn initial_tangent(&self) -> f64 {
        self.wrapper.initial_tangent(&self.inner)
    }
    fn traits(&self) -> UniaxialTraits {
        self.wrapper.traits(UniaxialTraits::of(&self.inner))
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles::around(self, &self.inner)
    }
}

impl<W: Wrapper> TrialTrace for Wrapped<W> {
    fn leave_trace(&self, tried: &[f64], committed: &mut [f64]) {
        self.inner.iter().for_each(|slot| slot.leave_trace(tried, committed));
    }
}

impl<W: Wrapper> ShownStrain for Wrapped<W> {
    fn shown_strain(&self, strain: f64, state: &[f64]) -> f64 {
        self.wrapper.shown_strain(&self.inner, strain, state)
    }
}

impl<W: Wrapper> LawParameters for Wrapped<W> {
    /// Applies to the law inside that the words name, or to all that have the parameter.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        let mut new = self.clone();
        let old = match words {
            ["material" | "component", rest @ ..] => {
                let (i, rest) = existing(self.chosen(rest))?;
                existing(new.inner.get_mut(i))?.set_parameter(rest, value)?
            }
            _ => last_of(new.inner.iter_mut().map(|slot| slot.set_parameter(words, value)))?,
        };
        Ok((Arc::new(new), old))
    }
}

impl<W: Wrapper> LawResponses for Wrapped<W> {
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let (first, rest) = words.split_first()?;
        if let Some(own) = self.wrapper.probe(&self.inner, first) {
            return Some(own);
        }
        match *first {
            "material" | "component" => {
                let (i, rest) = self.chosen(rest)?;
                Some(self.inner.get(i)?.probe(rest)?.inside(&[SLOT, i as u32]))
            }
            _ if !W::NUMBERED => Some(self.inner.first()?.material.probe(words)?.inside(&[LAW])),
            _ => None,
        }
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            SLOT => self.inner[path[1] as usize].read(&path[2..], state, out),
            LAW => self.inner[0].read_own(&path[1..], state, out),
            id => self.wrapper.read(&self.inner, id, state, out),
        }
    }
}
