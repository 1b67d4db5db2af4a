//! An element of several models, evaluated side by side.

use super::{Element, ElementInput, ElementOutput, Histories, MAX_DOFS, MatrixMask};
use crate::numeric::wide::{Flags, WIDTH, Wide, is_set};
use std::any::Any;
use std::cell::Cell;
use std::fmt;
use std::sync::Arc;

/// Joins elements of several models, where they are of one type and made for it.
pub type LockstepMaker = fn(&[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>>;

/// An element together with its counterparts in other models, which differ from it in numbers alone.
///
/// Its force and its matrices follow from the committed history and the trial motion, and from nothing else. It has no loads
/// of its own.
pub trait LockstepElement: fmt::Debug {
    /// Force and matrices for a trial motion from the committed history, as [`Element::respond`] has them model by model. Models without an answer have forces that are no numbers.
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>);
}

/// Input of a [`LockstepElement`].
#[derive(Clone, Copy, Debug)]
pub struct LockstepMotion<'a> {
    /// Trial displacements of its degrees of freedom.
    pub disp: &'a [Wide],
    /// Its trial velocities in a transient analysis; `None` in a static one, where nothing has any.
    pub vel: Option<&'a [Wide]>,
    /// Its committed history.
    pub committed: &'a [Wide],
    /// Domain time since the committed state.
    pub dt: f64,
    /// Domain time.
    pub time: f64,
    /// Models whose answers are wanted; those of the others are free.
    pub lanes: Flags,
}

/// Output of a [`LockstepElement`].
#[derive(Debug)]
pub struct LockstepOutput<'a> {
    /// Its trial history; all of it is written.
    pub trial: &'a mut [Wide],
    /// Resisting force, length n, set to zero before.
    pub force: &'a mut [Wide],
    /// Tangent stiffness n x n by rows, of which the rows of `part` have been set to zero; `None` where it is not needed.
    pub tangent: Option<&'a mut [Wide]>,
    /// Damping matrix n x n by rows, set to zero before, of elements that are viscous.
    pub damping: Option<&'a mut [Wide]>,
    /// Rows and columns of the tangent that are read.
    pub part: MatrixMask,
}

/// The elements as those of one type; `None` where they are of several.
pub(crate) fn alike<'a, E: Element>(all: &[&'a Arc<dyn Element>; WIDTH]) -> Option<[&'a E; WIDTH]> {
    let mut own = [None; WIDTH];
    for (own, e) in own.iter_mut().zip(all) {
        let any: &'a dyn Any = &***e;
        *own = any.downcast_ref::<E>();
    }
    let first = own[0]?;
    own.iter().all(Option::is_some).then(|| own.map(|e| e.unwrap_or(first)))
}

/// Elements that are evaluated one after the other.
struct OneByOne {
    elements: [Arc<dyn Element>; WIDTH],
    /// Committed and trial history, tangent and damping matrix of one of them, kept from one evaluation to the next.
    buffer: Cell<Vec<f64>>,
}

impl fmt::Debug for OneByOne {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("OneByOne").field(&self.elements).finish()
    }
}

/// Elements of one type, to be evaluated one after the other; `None` where they are of several types or sizes.
pub(crate) fn one_by_one<E: Element>(all: &[&Arc<dyn Element>; WIDTH]) -> Option<Box<dyn LockstepElement>> {
    let own = alike::<E>(all)?;
    let sizes = |e: &E| (e.dofs(), e.state_len(), (e as &dyn Element).load_len());
    let same = own.iter().all(|e| sizes(e) == sizes(own[0])) && (own[0] as &dyn Element).load_len() == 0;
    same.then(|| {
        Box::new(OneByOne { elements: all.map(Arc::clone), buffer: Cell::default() }) as Box<dyn LockstepElement>
    })
}

/// Velocities where nothing moves.
static AT_REST: [f64; MAX_DOFS] = [0.0; MAX_DOFS];

impl LockstepElement for OneByOne {
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>) {
        let (n, words) = (motion.disp.len(), motion.committed.len());
        let (mut disp, mut vel, mut force) = ([0.0; MAX_DOFS], AT_REST, [0.0; MAX_DOFS]);
        let mut buffer = self.buffer.take();
        buffer.resize(2 * words + 2 * n * n, 0.0);
        let (committed, rest) = buffer.split_at_mut(words);
        let (trial, matrices) = rest.split_at_mut(words);
        let (matrix, damping) = matrices.split_at_mut(n * n);
        let LockstepOutput {
            trial: all_trial,
            force: all_force,
            tangent: mut all_tangent,
            damping: mut all_damping,
            part,
        } = output;
        for (lane, element) in self.elements.iter().enumerate().filter(|(lane, _)| is_set(motion.lanes, *lane)) {
            disp.iter_mut().zip(motion.disp).for_each(|(own, all)| *own = all.0[lane]);
            vel.iter_mut().zip(motion.vel.unwrap_or_default()).for_each(|(own, all)| *own = all.0[lane]);
            committed.iter_mut().zip(motion.committed).for_each(|(own, all)| *own = all.0[lane]);
            trial.iter_mut().zip(&*all_trial).for_each(|(own, all)| *own = all.0[lane]);
            force[..n].fill(0.0);
            let tangent = all_tangent.is_some().then(|| {
                part.clear(matrix, n);
                &mut *matrix
            });
            let input = ElementInput {
                disp: &disp[..n],
                vel: &vel[..n],
                accel: &[],
                load: &[],
                still: motion.vel.is_none(),
                opensees: None,
                dt: motion.dt,
                time: motion.time,
                dynamic: motion.vel.is_some(),
            };
            damping.fill(0.0);
            let viscous = all_damping.is_some().then_some(&mut *damping);
            let answer = ElementOutput { force: &mut force[..n], tangent, damping: viscous, part };
            if element.respond(&input, &mut Histories { committed, trial }, answer).is_err() {
                force[..n].fill(f64::NAN);
            }
            all_trial.iter_mut().zip(&*trial).for_each(|(all, own)| all.0[lane] = *own);
            all_force.iter_mut().zip(&force).for_each(|(all, own)| all.0[lane] = *own);
            if let Some(all) = &mut all_tangent {
                for i in part.rows.among(n) {
                    let row = i * n..(i + 1) * n;
                    all[row.clone()].iter_mut().zip(&matrix[row]).for_each(|(all, own)| all.0[lane] = *own);
                }
            }
            if let Some(all) = &mut all_damping {
                all.iter_mut().zip(&*damping).for_each(|(all, own)| all.0[lane] = *own);
            }
        }
        self.buffer.set(buffer);
    }
}
