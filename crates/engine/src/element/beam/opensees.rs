//! State determination of the force-based beam by OpenSees' scheme, under `--compat opensees` only.
//!
//! The iteration starts from the last trial state and ends at a small residual energy. Without convergence it is repeated
//! with the initial flexibility of the sections, and then with smaller increments.

use super::basic::Basic;
use super::force_based::{ForceBased, add_torsion, internal_forces};
use super::member::{Formulation, LoadSums, Member, Trace};
use super::per_section::PerSection;
use super::point::{Point, Stiffness, read_all};
use crate::element::{ElementInput, Histories};
use crate::material::MaterialError;
use crate::numeric::{axpy, dot, invert, norm, product};
use crate::section::SectionSlot;

/// Choice of the section flexibility that turns unbalanced section forces into deformations.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flexibility {
    Current,
    Initial,
    InitialFirst,
}

/// Iteration schemes in the order of their use. Each takes a multiple of the iterations of the command.
const SCHEMES: [(Flexibility, usize); 3] =
    [(Flexibility::Current, 1), (Flexibility::Initial, 10), (Flexibility::InitialFirst, 1)];

/// Largest number of increments that a step is divided into. OpenSees has no limit.
const MAX_INCREMENTS: usize = 1000;

/// Evaluates a virgin beam at rest: initial stresses have basic forces before the first step.
pub(super) fn settle<const N: usize, const B: usize>(
    formulation: &ForceBased,
    member: &Member<N, B>,
    state: &mut [f64],
) {
    if !formulation.compat || !is_prestressed(member, &Basic::read(&state[member.head()..]), state) {
        return;
    }
    let (still, load, virgin) =
        ([0.0; N], vec![0.0; <ForceBased as LoadSums<N, B>>::load_len(member.sections.len())], state.to_vec());
    let (disp, vel, load) = (&still[..], &still[..], &load[..]);
    let accel = &[];
    let motion =
        ElementInput { disp, vel, accel, load, still: true, opensees: None, dt: 0.0, time: 0.0, dynamic: false };
    match formulation.respond(member, &[0.0; B], &motion, &mut Histories { committed: &virgin, trial: state }) {
        Ok(basic) => basic.write(&mut state[member.head()..]),
        Err(_) => state.copy_from_slice(&virgin),
    }
}

/// Returns true for a virgin beam whose sections have initial stresses: its first state determination finds their forces.
fn is_prestressed<const N: usize, const B: usize>(member: &Member<N, B>, basic: &Basic<B>, trial: &[f64]) -> bool {
    let stressed = |s: &SectionSlot| s.parts(trial).1.iter().any(|s| *s != 0.0);
    basic.q.iter().all(|q| *q == 0.0) && member.sections.iter().any(stressed)
}

impl ForceBased {
    /// Basic forces for deformations `v`, from the last trial state. `None` without convergence.
    ///
    /// # Errors
    /// A section without a force, if no scheme converges.
    pub(super) fn iterate_from_trial<const N: usize, const B: usize, const M: usize>(
        &self,
        member: &Member<N, B>,
        v: &[f64; B],
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let mut basic = Basic::read(&h.trial[member.head()..]);
        let trace = Trace::next(member, v, motion, h.trial);
        trace.write(&mut h.trial[member.own_words()..]);
        if trace.is_at_rest(motion) && !is_prestressed(member, &basic, h.trial) {
            return Ok(Some(basic));
        }
        let mut remaining = trace.dv;
        let (mut from, mut increment, mut reductions) = (std::array::from_fn(|i| v[i] - remaining[i]), remaining, 0);
        let mut sections = member.responses(h.trial);
        let (mut failure, mut done) = (None, 0);
        while reductions < self.parts && done < MAX_INCREMENTS {
            let to = std::array::from_fn(|i| from[i] + increment[i]);
            let mut found = None;
            for scheme in SCHEMES {
                member.set_responses(&sections, h.trial);
                match self.iterate::<N, B, M>(member, (&basic, &increment, &to), scheme, motion, h) {
                    Ok(None) => {}
                    Ok(converged) => {
                        found = converged;
                        break;
                    }
                    Err(e) => failure = Some(e),
                }
            }
            let Some(converged) = found else {
                increment.iter_mut().for_each(|d| *d /= self.factor);
                reductions += 1;
                continue;
            };
            basic = converged;
            remaining.iter_mut().zip(&increment).for_each(|(remaining, increment)| *remaining -= increment);
            if norm(&remaining) <= f64::EPSILON {
                return Ok(Some(basic));
            }
            (from, increment, reductions, done) = (to, remaining, 0, done + 1);
            sections = member.responses(h.trial);
        }
        failure.map_or(Ok(None), Err)
    }

    /// Iterates over an increment of the deformations that ends at `to`.
    fn iterate<const N: usize, const B: usize, const M: usize>(
        &self,
        member: &Member<N, B>,
        (from, increment, to): (&Basic<B>, &[f64; B], &[f64; B]),
        (flexibility, times): (Flexibility, usize),
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> Result<Option<Basic<B>>, MaterialError> {
        let length = member.length();
        let mut basic = *from;
        let first = product(&from.k, increment);
        axpy(1.0, &first, &mut basic.q);
        let mut points = PerSection::new();
        for (i, (section, x, _)) in member.along().enumerate() {
            let place = ((x, length), internal_forces(motion.load, i));
            let stiffness = if flexibility == Flexibility::Current { Stiffness::Current } else { Stiffness::Virgin };
            points.push(Point::<B, M>::new(section, place, h.trial, stiffness)?);
        }
        for iteration in 0..times * self.max_iterations {
            let initial = match flexibility {
                Flexibility::Current => false,
                Flexibility::Initial => true,
                Flexibility::InitialFirst => iteration == 0,
            };
            let (mut f, mut gathered) = ([[0.0; B]; B], [0.0; B]);
            if initial && iteration > 0 {
                read_all(member, &mut points, h.trial, Stiffness::Virgin)?;
            }
            let e = (&points).into_iter().map(|point| point.deformations(&basic.q)).collect();
            member.update_sections(h, &e, motion.dt)?;
            read_all(member, &mut points, h.trial, Stiffness::Current)?;
            for ((.., weight), point) in member.along().zip(&points) {
                point.add(weight, &point.deformations(&basic.q), &mut f, &mut gathered);
            }
            add_torsion(member, &basic.q, &mut f, &mut gathered);
            if !invert(f.as_flattened_mut(), B) {
                return Ok(None);
            }
            let missing: [f64; B] = std::array::from_fn(|i| to[i] - gathered[i]);
            let step = product(&f, &missing);
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
