//! An element of several models, evaluated side by side.

use super::{Element, MatrixMask};
use crate::numeric::wide::{WIDTH, Wide};
use std::any::Any;
use std::fmt;

/// An element together with its counterparts in other models, which differ from it in numbers alone.
///
/// It is a function of the displacements: no velocities, no time, no loads of its own.
pub trait LockstepElement: fmt::Debug {
    /// Force and tangent for trial displacements from the committed history, as [`Element::respond`] has them model by
    /// model. Models without an answer have forces that are no numbers.
    fn respond(&self, motion: LockstepMotion<'_>, output: LockstepOutput<'_>);
}

/// Input of a [`LockstepElement`].
#[derive(Clone, Copy, Debug)]
pub struct LockstepMotion<'a> {
    /// Trial displacements of its degrees of freedom.
    pub disp: &'a [Wide],
    /// Its committed history.
    pub committed: &'a [Wide],
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
    /// Rows and columns of the tangent that are read.
    pub part: MatrixMask,
}

/// The elements as those of one type; `None` where they are of several.
pub(crate) fn alike<'a, E: Element>(all: &[&'a dyn Element; WIDTH]) -> Option<[&'a E; WIDTH]> {
    let mut own = [None; WIDTH];
    for (own, e) in own.iter_mut().zip(all) {
        let any: &'a dyn Any = *e;
        *own = any.downcast_ref::<E>();
    }
    let first = own[0]?;
    own.iter().all(Option::is_some).then(|| own.map(|e| e.unwrap_or(first)))
}
