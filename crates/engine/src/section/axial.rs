//! Axial behaviour of a section, for bars.

use super::{MAX_ORDER, Resultant, SectionSlot, SharedSection};
use crate::material::roles::{LawParameters, LawResponses, UniaxialRoles};
use crate::material::{MaterialResult, SharedUniaxial, Strain, Stress, Uniaxial, UniaxialTraits, updates_each_point};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use std::sync::Arc;

/// Axial force of a section as a function of its elongation, with the other deformations zero.
#[derive(Clone, Debug)]
pub struct Axial {
    slot: SectionSlot,
    /// Index of the axial force among the resultants.
    at: usize,
}

impl Axial {
    /// Name of the law.
    pub(crate) const NAME: &'static str = "Section";

    /// From a section with its tag; `None` if it has no axial force.
    pub fn new(section: SharedSection, tag: i32) -> Option<Self> {
        let at = section.resultants().iter().position(|r| *r == Resultant::P)?;
        Some(Self { slot: SectionSlot::new(section, tag, 0), at })
    }
}

crate::watches_columns!(Axial => |s| in [&s.slot]);

#[deny(clippy::missing_trait_methods)]
impl Uniaxial for Axial {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        Self::NAME
    }
    fn state_len(&self) -> usize {
        self.slot.len()
    }
    fn init(&self, state: &mut [f64]) {
        self.slot.init(state);
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let mut e = [0.0; MAX_ORDER];
        e[self.at] = strain.value;
        self.slot.update(committed, &e, strain.dt, next)?;
        let n = self.slot.resultants().len();
        let (value, tangent) = (self.slot.resultant(next)[self.at], self.slot.stiffness(next)[self.at * (n + 1)]);
        Ok(Stress { value, tangent, damping: 0.0 })
    }
    fn initial_tangent(&self) -> f64 {
        let n = self.slot.resultants().len();
        let mut k = [0.0; MAX_ORDER * MAX_ORDER];
        self.slot.section.initial_stiffness(&mut k[..n * n]);
        k[self.at * (n + 1)]
    }
    fn traits(&self) -> UniaxialTraits {
        let section = &self.slot.section;
        UniaxialTraits { linear: section.is_linear(), viscous: false, elapses: section.depends_on_time() }
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles { parameters: Some(self), responses: Some(self), columns: Some(self), ..UniaxialRoles::default() }
    }
}

impl LawParameters for Axial {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedUniaxial> {
        let mut new = self.clone();
        let old = new.slot.set_parameter(words.strip_prefix(&["section"]).unwrap_or(words), value)?;
        Ok((Arc::new(new), old))
    }
}

impl LawResponses for Axial {
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.slot.probe(words.strip_prefix(&["section"]).unwrap_or(words))
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.slot.read(path, state, out);
    }
}
