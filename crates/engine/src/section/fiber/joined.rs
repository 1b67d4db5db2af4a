//! A fiber section at several places of an element, evaluated together: a few points of each place fill vectors of the
//! processor, which they would leave nearly empty by themselves. The numbers are those of one place after the other.

use super::runs::FEW_POINTS;
use super::{FiberSection, NO_RATE, Parts, RunBlock};
use crate::material::{MaterialResult, Strains, Stresses};
use crate::numeric::lanes::BLOCK;
use crate::section::SectionSlot;
use std::cell::RefCell;

/// Points of all places that are evaluated at once.
const AT_ONCE: usize = 2 * BLOCK;
/// Largest number of state variables of a law whose points are gathered.
pub(super) const MAX_WORDS: usize = 16;

/// Points of several places, one quantity after the other, place after place.
#[derive(Debug)]
struct Gathered {
    strain: [f64; AT_ONCE],
    value: [f64; AT_ONCE],
    tangent: [f64; AT_ONCE],
    damping: [f64; AT_ONCE],
    committed: [f64; AT_ONCE * MAX_WORDS],
    next: [f64; AT_ONCE * MAX_WORDS],
}

impl Gathered {
    const fn new() -> Self {
        Self {
            strain: [0.0; AT_ONCE],
            value: [0.0; AT_ONCE],
            tangent: [0.0; AT_ONCE],
            damping: [0.0; AT_ONCE],
            committed: [0.0; AT_ONCE * MAX_WORDS],
            next: [0.0; AT_ONCE * MAX_WORDS],
        }
    }
}

thread_local! {
    /// To fill the arrays with zeros each time takes longer than to use them.
    static GATHERED: RefCell<Gathered> = const { RefCell::new(Gathered::new()) };
}

impl FiberSection {
    /// Evaluates the section at several places of an element, whose deformations stand in `trial`, with zeros for resultants
    /// and tangents.
    ///
    /// # Errors
    /// A material has no response at these deformations.
    pub(crate) fn update_joined(
        &self,
        slots: &[SectionSlot],
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> MaterialResult {
        if self.biaxial {
            self.update_in_order::<3>(slots, committed, dt, trial)
        } else {
            self.update_in_order::<2>(slots, committed, dt, trial)
        }
    }

    fn update_in_order<const M: usize>(
        &self,
        slots: &[SectionSlot],
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> MaterialResult {
        let n = self.points.len();
        for slot in slots {
            let step = slot.step(committed, dt, trial);
            let (old, mut new) = (Parts::of(step.committed, n), Parts::of_mut(step.next, n));
            self.strain::<M>(step.e, &mut new);
            let mut alone = self.blocks.iter().filter(|b| !b.is_few(&self.runs));
            alone.try_for_each(|block| self.update_block(block, &old, dt, &mut new))?;
        }
        GATHERED.with_borrow_mut(|gathered| self.update_few(gathered, slots, committed, dt, trial))?;
        for slot in slots {
            let mut step = slot.step(committed, dt, trial);
            self.sum::<M>(&mut step);
            self.add_torsion(&mut step)?;
        }
        Ok(())
    }

    /// Evaluates the blocks of a few points at all places.
    fn update_few(
        &self,
        gathered: &mut Gathered,
        slots: &[SectionSlot],
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> MaterialResult {
        for block in self.blocks.iter().filter(|b| b.is_few(&self.runs)) {
            let update = match block.points.len() {
                1 => Self::update_gathered::<1>,
                _ => Self::update_gathered::<FEW_POINTS>,
            };
            for places in slots.chunks(AT_ONCE / block.points.len()) {
                update(self, (block, places), gathered, committed, dt, trial)?;
            }
        }
        Ok(())
    }

    /// Evaluates the `P` points of a block at some places.
    fn update_gathered<const P: usize>(
        &self,
        (block, slots): (&RunBlock, &[SectionSlot]),
        g: &mut Gathered,
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> MaterialResult {
        let (n, start, words) = (self.points.len(), block.points.start, block.words(&self.runs));
        let all = P * slots.len();
        for (slot, at) in slots.iter().zip((0..).step_by(P)) {
            let (_, next) = slot.split(trial);
            let (old, new) = (Parts::of(slot.own(committed), n), Parts::of_mut(next, n));
            copy::<P>(&new.strain[start..], &mut g.strain[at..]);
            let (own, _) = old.laws[words.clone()].as_chunks::<P>();
            let rows = g.committed[at..].chunks_mut(all);
            own.iter().zip(rows).for_each(|(own, row)| copy::<P>(own, row));
        }
        let len = words.len() * slots.len();
        let strains = Strains { value: &g.strain[..all], rate: &NO_RATE[..all], dt };
        let mut stresses =
            Stresses { value: &mut g.value[..all], tangent: &mut g.tangent[..all], damping: &mut g.damping[..all] };
        block.update(&self.runs, &g.committed[..len], &strains, &mut g.next[..len], &mut stresses)?;
        for (slot, at) in slots.iter().zip((0..).step_by(P)) {
            let (_, next) = slot.split(trial);
            let new = Parts::of_mut(next, n);
            copy::<P>(&g.value[at..], &mut new.stress[start..]);
            copy::<P>(&g.tangent[at..], &mut new.tangent[start..]);
            let (own, _) = new.laws[words.clone()].as_chunks_mut::<P>();
            let rows = g.next[at..].chunks(all);
            own.iter_mut().zip(rows).for_each(|(own, row)| copy::<P>(row, own));
        }
        Ok(())
    }
}

/// Copies the first `P` numbers.
#[inline(always)]
fn copy<const P: usize>(from: &[f64], to: &mut [f64]) {
    if let (Some(from), Some(to)) = (from.first_chunk::<P>(), to.first_chunk_mut::<P>()) {
        *to = *from;
    }
}
