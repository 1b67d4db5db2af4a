//! Sections side by side.

use super::plain_methods::plain_methods;
use super::{MAX_ORDER, Resultant, Section, SectionSlot, SectionStep, SharedSection};
use crate::material::MaterialResult;
use crate::parameter::{Changed, NewValue, existing, last_of};
use crate::probe::Probe;
use std::sync::Arc;

/// Sections with the same deformations. Resultants and tangents are the sums of theirs; a section without a resultant adds
/// nothing to it.
#[derive(Clone, Debug)]
pub struct ParallelSections {
    sections: Vec<SectionSlot>,
    /// The union of the resultants of the sections.
    resultants: Vec<Resultant>,
    /// Place of each resultant of each section in the union.
    places: Vec<Vec<usize>>,
    state_len: usize,
}

impl ParallelSections {
    /// From sections with their tags.
    pub fn new(sections: Vec<(SharedSection, i32)>) -> Self {
        let has = |r: &Resultant| sections.iter().any(|(s, _)| s.resultants().contains(r));
        let resultants: Vec<Resultant> = Resultant::ALL.into_iter().filter(has).collect();
        let place = |r: &Resultant| resultants.iter().position(|other| other == r);
        let places = sections.iter().map(|(s, _)| s.resultants().iter().filter_map(place).collect()).collect();
        let mut state_len = 0;
        let slot = |(section, tag)| {
            let slot = SectionSlot::new(section, tag, state_len);
            state_len += slot.len();
            slot
        };
        let sections = sections.into_iter().map(slot).collect();
        Self { sections, resultants, places, state_len }
    }

    fn each(&self) -> impl Iterator<Item = (&SectionSlot, &[usize])> {
        self.sections.iter().zip(self.places.iter().map(Vec::as_slice))
    }

    /// Adds the matrix of a section to that of all resultants.
    fn add(&self, small: &[f64], places: &[usize], k: &mut [f64]) {
        for (row, i) in small.chunks_exact(places.len().max(1)).zip(places) {
            row.iter().zip(places).for_each(|(entry, j)| k[i * self.resultants.len() + j] += entry);
        }
    }
}

crate::watches_columns!(ParallelSections => |s| in &s.sections);

#[deny(clippy::missing_trait_methods)]
impl Section for ParallelSections {
    plain_methods! { elastic joined }
    fn class(&self) -> &'static str {
        "ParallelSection"
    }
    fn resultants(&self) -> &[Resultant] {
        &self.resultants
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.sections.iter().for_each(|s| s.init(state));
    }
    fn is_linear(&self) -> bool {
        self.sections.iter().all(|s| s.section.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.sections.iter().any(|s| s.section.depends_on_time())
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, dt, next, s, k } = step;
        for (slot, places) in self.each() {
            let mut of_section = [0.0; MAX_ORDER];
            of_section.iter_mut().zip(places).for_each(|(o, at)| *o = e[*at]);
            slot.update(committed, &of_section[..places.len()], dt, next)?;
            slot.resultant(next).iter().zip(places).for_each(|(force, at)| s[*at] += force);
            self.add(slot.stiffness(next), places, k);
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        for (slot, places) in self.each() {
            let mut small = [0.0; MAX_ORDER * MAX_ORDER];
            let small = &mut small[..places.len() * places.len()];
            slot.section.initial_stiffness(small);
            self.add(small, places, k);
        }
    }

    /// A number of one section by its tag, or of all that have it.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedSection> {
        let mut new = self.clone();
        let (tag, rest) = match words {
            ["section", tag, rest @ ..] => (Some(existing(tag.parse::<i32>().ok())?), rest),
            _ => (None, words),
        };
        let chosen = new.sections.iter_mut().filter(|s| tag.is_none_or(|t| s.tag == t));
        let old = last_of(chosen.map(|s| s.set_parameter(rest, value)))?;
        Ok((Arc::new(new), old))
    }

    /// A response of one section, by its number from 1 on.
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let ["section", number, rest @ ..] = words else { return None };
        let i = number.parse::<usize>().ok()?.checked_sub(1)?;
        Some(self.sections.get(i)?.probe(rest)?.inside(&[i as u32]))
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.sections[path[0] as usize].read(&path[1..], state, out);
    }
}
