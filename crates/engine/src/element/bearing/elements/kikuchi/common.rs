//! What OpenSees keeps once for all Kikuchi bearings of a model, followed on demand only.
//!
//! There the displacements of ends and inner nodes and the condensed stiffness are variables of the class: every bearing
//! takes its geometry and its tangent from the one that was asked last.

use super::kinematics::{Motion, OUTER};
use std::sync::{Arc, Mutex, PoisonError};

/// The variables that the bearings of a model have in common.
#[derive(Clone, Debug, Default)]
pub struct Common(Arc<Mutex<Variables>>);

#[derive(Debug, Default)]
struct Variables {
    bearings: usize,
    /// Displacements of the last bearing at the end of a step, by number: of this step and of the one before.
    motions: [Option<(f64, Motion)>; 2],
    stiffness: Option<[[f64; OUTER]; OUTER]>,
}

impl Common {
    fn with<T>(&self, act: impl FnOnce(&mut Variables) -> T) -> T {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Number of a new bearing.
    pub(super) fn join(&self) -> usize {
        self.with(|v| {
            v.bearings += 1;
            v.bearings - 1
        })
    }

    /// Leave what the other bearings take, if this one is the last.
    pub(super) fn leave(&self, number: usize, step: f64, motion: Motion, stiffness: &[[f64; OUTER]; OUTER]) {
        self.with(|v| {
            if number + 1 == v.bearings {
                if v.motions[1].is_none_or(|(s, _)| s != step) {
                    v.motions[0] = v.motions[1];
                }
                v.motions[1] = Some((step, motion));
                v.stiffness = Some(*stiffness);
            }
        });
    }

    /// Displacements of the last bearing at the end of a step.
    pub(super) fn motion(&self, step: f64) -> Option<Motion> {
        self.with(|v| v.motions.iter().flatten().find(|(s, _)| *s == step).map(|(_, q)| *q))
    }

    /// Use the stiffness of the bearing asked last, where there is one; whether there was.
    pub(super) fn use_stiffness(&self, act: impl FnOnce(&[[f64; OUTER]; OUTER])) -> bool {
        self.with(|v| v.stiffness.as_ref().map(act).is_some())
    }
}
