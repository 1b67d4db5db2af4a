//! Springs of several models side by side.

use super::{Spring, Springs};
use crate::element::{LockstepElement, LockstepMotion, LockstepOutput, MAX_DOFS};
use crate::material::{Slot, Strain, write_linear};
use crate::numeric::lanes::{Lanes, in_lanes};
use crate::numeric::wide::{Flags, WIDTH, Wide, is_set};
use std::cell::RefCell;

/// Velocities where nothing moves.
static AT_REST: [Wide; MAX_DOFS] = [Wide::all(0.0); MAX_DOFS];

/// [`Springs`] of each of several models, with the same deformations.
#[derive(Debug)]
struct SpringsSideBySide {
    springs: Vec<SpringSideBySide>,
}

/// One material in one direction, of all models.
#[derive(Debug)]
struct SpringSideBySide {
    law: Law,
    damper: Option<Law>,
    /// Nonzero derivatives of the deformation by the displacements: index and value.
    terms: Vec<(usize, f64)>,
    /// Number of displacements.
    n: usize,
    initial: f64,
    /// The next spring has the same deformation.
    shared: bool,
}

/// A material of all models, and its place in the state of the element.
#[derive(Debug)]
struct Law {
    at: usize,
    kind: LawKind,
}

#[derive(Debug)]
enum LawKind {
    /// Linear elastic, with the stiffness.
    Linear(Wide),
    /// One after the other, with room for the committed and the trial state of one.
    OneByOne(Box<[Slot; WIDTH]>, RefCell<Vec<f64>>),
}

/// Deformation and its rate.
#[derive(Clone, Copy)]
struct WideStrain {
    value: Wide,
    rate: Wide,
}

/// Force with its derivatives by deformation and rate.
#[derive(Clone, Copy, Default)]
struct WideStress {
    value: Wide,
    tangent: Wide,
    damping: Wide,
}

impl Springs {
    /// The springs of several models as one element with `n` displacements; `None` where their deformations differ.
    pub(in crate::element) fn side_by_side(all: &[&Self; WIDTH], n: usize) -> Option<Box<dyn LockstepElement>> {
        let count = all[0].springs.len();
        if all.iter().any(|s| s.springs.len() != count) {
            return None;
        }
        let mut at = 0;
        let springs = (0..count).map(|i| SpringSideBySide::new(&all.map(|s| &s.springs[i]), &mut at, n));
        let springs = springs.collect::<Option<_>>()?;
        Some(Box::new(SpringsSideBySide { springs }))
    }
}

impl SpringSideBySide {
    /// Of one spring of each model, at a place in the state that moves on behind it.
    fn new(all: &[&Spring; WIDTH], at: &mut usize, n: usize) -> Option<Self> {
        let first = all[0];
        let alike = |s: &&Spring| {
            (&s.terms, s.initial, s.shared, s.damper.is_some())
                == (&first.terms, first.initial, first.shared, first.damper.is_some())
        };
        if !all.iter().all(alike) {
            return None;
        }
        let law = Law::new(all.map(|s| &s.slot), at)?;
        let dampers = all.map(|s| s.damper.as_ref().unwrap_or(&s.slot));
        let damper = if first.damper.is_some() { Some(Law::new(dampers, at)?) } else { None };
        Some(Self { law, damper, terms: first.terms.clone(), n, initial: first.initial, shared: first.shared })
    }

    #[inline(always)]
    fn measure(&self, motion: &[Wide]) -> Wide {
        // As a sum of numbers begins.
        let mut sum = Wide::all(-0.0);
        for &(i, r) in &self.terms {
            sum += motion[i] * r;
        }
        sum
    }

    #[inline(always)]
    fn add_stiffness(&self, matrix: &mut [Wide], stiffness: Wide) {
        for &(i, ri) in &self.terms {
            for &(j, rj) in &self.terms {
                matrix[i * self.n + j] += stiffness * ri * rj;
            }
        }
    }
}

impl Law {
    fn new(all: [&Slot; WIDTH], at: &mut usize) -> Option<Self> {
        let len = all[0].len();
        if all.iter().any(|slot| slot.len() != len) {
            return None;
        }
        let place = *at;
        *at += len;
        let stiffness = all.map(Slot::stiffness);
        let kind = if stiffness.iter().all(Option::is_some) {
            LawKind::Linear(Wide(stiffness.map(Option::unwrap_or_default)))
        } else {
            let slots = all.map(|slot| Slot::new(slot.material.clone(), slot.tag, 0));
            LawKind::OneByOne(Box::new(slots), RefCell::new(vec![0.0; 2 * len]))
        };
        Some(Self { at: place, kind })
    }

    /// Evaluates the materials in some models. Those without a response have a force that is no number.
    #[inline(always)]
    fn update(&self, committed: &[Wide], at: WideStrain, trial: &mut [Wide], (lanes, dt): (Flags, f64)) -> WideStress {
        let (committed, trial) = (&committed[self.at..], &mut trial[self.at..]);
        match &self.kind {
            LawKind::Linear(k) => {
                write_linear(*k, (at.value, at.rate), committed, trial);
                WideStress { value: *k * at.value, tangent: *k, damping: Wide::all(0.0) }
            }
            LawKind::OneByOne(slots, words) => {
                one_by_one(slots, &mut words.borrow_mut(), (committed, trial), at, (lanes, dt))
            }
        }
    }
}

/// Evaluates the materials of some models, with room for the states of one.
fn one_by_one(
    slots: &[Slot; WIDTH],
    words: &mut [f64],
    (all_committed, all_trial): (&[Wide], &mut [Wide]),
    at: WideStrain,
    (lanes, dt): (Flags, f64),
) -> WideStress {
    let mut out = WideStress::default();
    let (committed, trial) = words.split_at_mut(slots[0].len());
    for (lane, slot) in slots.iter().enumerate().filter(|(lane, _)| is_set(lanes, *lane)) {
        committed.iter_mut().zip(all_committed).for_each(|(own, all)| *own = all.0[lane]);
        trial.iter_mut().zip(&*all_trial).for_each(|(own, all)| *own = all.0[lane]);
        let strain = Strain { value: at.value.0[lane], rate: at.rate.0[lane], dt };
        match slot.update(committed, strain, trial) {
            Ok(s) => {
                (out.value.0[lane], out.tangent.0[lane], out.damping.0[lane]) = (s.value, s.tangent, s.damping);
            }
            Err(_) => out.value.0[lane] = f64::NAN,
        }
        all_trial.iter_mut().zip(&*trial).for_each(|(all, own)| all.0[lane] = *own);
    }
    out
}

/// A response as a loop.
struct Response<'a> {
    springs: &'a [SpringSideBySide],
    motion: LockstepMotion<'a>,
    output: LockstepOutput<'a>,
}

impl Lanes for Response<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        let (motion, output) = (self.motion, &mut self.output);
        let vel = motion.vel.unwrap_or(&AT_REST);
        let of_models = (motion.lanes, motion.dt);
        // Sum over springs with the same deformation.
        let (mut strain, mut sum) = (None, WideStress::default());
        for s in self.springs {
            // A closure would not be compiled for vector instructions.
            let at = match strain {
                Some(at) => at,
                None => WideStrain { value: s.measure(motion.disp) - Wide::all(s.initial), rate: s.measure(vel) },
            };
            strain = Some(at);
            let stress = s.law.update(motion.committed, at, output.trial, of_models);
            sum.value += stress.value;
            sum.tangent += stress.tangent;
            sum.damping += stress.damping;
            if let Some(d) = &s.damper {
                let rate = WideStrain { value: at.rate, rate: Wide::all(0.0) };
                let c = d.update(motion.committed, rate, output.trial, of_models);
                sum.value += c.value;
                sum.damping += c.tangent;
            }
            if s.shared {
                continue;
            }
            for &(i, r) in &s.terms {
                output.force[i] += sum.value * r;
            }
            if let Some(k) = output.tangent.as_deref_mut() {
                s.add_stiffness(k, sum.tangent);
            }
            if let Some(c) = output.damping.as_deref_mut() {
                s.add_stiffness(c, sum.damping);
            }
            (strain, sum) = (None, WideStress::default());
        }
    }
}

impl LockstepElement for SpringsSideBySide {
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>) {
        in_lanes(&mut Response { springs: &self.springs, motion, output });
    }
}
