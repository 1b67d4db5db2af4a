//! Evaluation of the sections of a beam.

use super::member::Member;
use super::per_section::PerSection;
use crate::element::Histories;
use crate::material::MaterialError;
use crate::section::{FiberSection, SectionSlot};
use std::sync::Arc;

impl<const N: usize, const B: usize> Member<N, B> {
    /// The section that all places along the beam have, if it is worth evaluating them together.
    fn joined(&self) -> Option<&FiberSection> {
        let first = &self.sections.first()?.section;
        let is_one = |slot: &SectionSlot| Arc::ptr_eq(&slot.section, first);
        self.sections[1..].iter().all(is_one).then(|| first.joined()).flatten()
    }

    /// Evaluates the sections at trial deformations of each.
    ///
    /// # Errors
    /// A material has no response at these deformations.
    pub(super) fn update_sections<const M: usize>(
        &self,
        h: &mut Histories<'_>,
        e: &PerSection<[f64; M]>,
        dt: f64,
    ) -> Result<(), MaterialError> {
        let places = || self.sections.iter().zip(e);
        match self.joined() {
            Some(section) => {
                places().for_each(|(slot, e)| slot.set_deformation(e, h.trial));
                section.update_joined(&self.sections, h.committed, dt, h.trial)
            }
            None => places().try_for_each(|(slot, e)| slot.update(h.committed, e, dt, h.trial)),
        }
    }
}
