//! OpenSees' way to the forces of the force-based beam: from the last trial state on, until the energy left over is small;
//! what does not converge is tried with the initial flexibility of the sections, then in smaller parts. Followed on demand only.

use super::force_based::{ForceBased, Point, internal_forces};
use super::member::{Basic, Member, Trace};
use crate::element::ElementInput;
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, invert, norm};

/// Choice of the section flexibility that turns unbalanced section forces into deformations.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flexibility {
    Current,
    Initial,
    InitialFirst,
}

/// Iteration schemes in the order of their use, each with its number of iterations beyond those of the command.
const WAYS: [(Flexibility, usize); 3] =
    [(Flexibility::Current, 1), (Flexibility::Initial, 10), (Flexibility::InitialFirst, 1)];

/// Parts of a step that may be found one after the other. OpenSees has no end to them.
const PARTS: usize = 1000;

impl ForceBased {
    /// Basic forces for deformations `v`, from the last trial state on. `None` if they are not found.
    ///
    /// # Errors
    /// A section that has no answer, where nothing else was found either.
    pub(super) fn go_on<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        committed: &[f64],
        trial: &mut [f64],
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let words = member.own_words()..;
        let trace = Trace::<N, B>::read(&trial[words.clone()]);
        let mut basic = Basic::read(&trial[member.head()..]);
        let mut left: [f64; B] = std::array::from_fn(|i| v[i] - trace.v[i]);
        // The nodes still have the increment that they had at the last call.
        if motion.opensees.is_some_and(|c| c.repeated) && member.is_small() {
            left = trace.dv;
        }
        let mut disp = [0.0; N];
        disp.copy_from_slice(motion.disp);
        Trace { v: *v, dv: left, disp }.write(&mut trial[words]);
        if norm(&left) <= f64::EPSILON && motion.load.iter().all(|p| *p == 0.0) {
            return Ok(Some(basic));
        }
        let (mut from, mut part, mut cuts) = (std::array::from_fn(|i| v[i] - left[i]), left, 0);
        let mut sections = member.responses(trial);
        let (mut failure, mut done) = (None, 0);
        while cuts < self.parts && done < PARTS {
            let to = std::array::from_fn(|i| from[i] + part[i]);
            let mut found = None;
            for way in WAYS {
                member.set_responses(&sections, trial);
                match self.iterate(member, (&basic, &part, &to), way, motion, (committed, trial)) {
                    Ok(None) => {}
                    Ok(converged) => {
                        found = converged;
                        break;
                    }
                    Err(e) => failure = Some(e),
                }
            }
            let Some(converged) = found else {
                part.iter_mut().for_each(|d| *d /= self.factor);
                cuts += 1;
                continue;
            };
            basic = converged;
            left.iter_mut().zip(&part).for_each(|(left, part)| *left -= part);
            if norm(&left) <= f64::EPSILON {
                return Ok(Some(basic));
            }
            (from, part, cuts, done) = (to, left, 0, done + 1);
            sections = member.responses(trial);
        }
        failure.map_or(Ok(None), Err)
    }

    /// Iterate over a part of the deformations, to `to`.
    fn iterate<const N: usize, const B: usize>(
        &self,
        member: &Member<N, B>,
        (from, part, to): (&Basic<B>, &[f64; B], &[f64; B]),
        (flexibility, times): (Flexibility, usize),
        motion: &ElementInput<'_>,
        (committed, trial): (&[f64], &mut [f64]),
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let length = member.length();
        let mut basic = *from;
        let first = from.k.map(|row| dot(&row, part));
        axpy(1.0, &first, &mut basic.q);
        for iteration in 0..times * self.max_iterations {
            let initial = match flexibility {
                Flexibility::Current => false,
                Flexibility::Initial => true,
                Flexibility::InitialFirst => iteration == 0,
            };
            let (mut f, mut gathered) = ([[0.0; B]; B], [0.0; B]);
            for (i, (section, x, weight)) in member.along().enumerate() {
                let internal = internal_forces(motion.load, i);
                let wanted = Point::new(section, (x, length), &basic.q, internal, trial, initial)?;
                section.update(committed, &wanted.e, motion.dt, trial)?;
                let p = Point::new(section, (x, length), &basic.q, internal, trial, false)?;
                p.add(section.resultants().len(), weight, &mut f, &mut gathered);
            }
            if !invert(f.as_flattened_mut(), B) {
                return Ok(None);
            }
            let missing: [f64; B] = std::array::from_fn(|i| to[i] - gathered[i]);
            let step = f.map(|row| dot(&row, &missing));
            axpy(1.0, &step, &mut basic.q);
            basic.k = f;
            let energy = dot(&step, &missing);
            if energy.abs() < self.tolerance {
                return Ok(Some(basic));
            }
            if !energy.is_finite() {
                return Ok(None);
            }
        }
        Ok(None)
    }
}
