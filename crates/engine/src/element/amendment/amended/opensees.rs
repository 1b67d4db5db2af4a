//! Amended elements whose force depends on the number of calls, as in OpenSees.

use super::Amended;
use crate::element::{CallDependent, ElementInput, ElementOutput, ElementResult, Histories, MatrixMask, SharedState};

impl Amended {
    /// Index of the first entry of the stored tangent.
    pub(super) fn tangent_at(&self) -> usize {
        self.law_at() + self.law.state_len()
    }

    /// Number of state variables for the stored tangent: 0 unless the element counts its calls.
    pub(super) fn tangent_len(&self) -> usize {
        if self.counts_calls { self.inner.dofs().pow(2) } else { 0 }
    }

    /// Force and tangent of the element at the displacements of `motion`.
    pub(super) fn respond_inner(
        &self,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
        output: &mut ElementOutput<'_>,
    ) -> ElementResult {
        let calls = if self.counts_calls { self.inner.opensees().calls } else { None };
        let own = ElementOutput {
            force: &mut *output.force,
            tangent: output.tangent.as_deref_mut().filter(|_| calls.is_none()),
            damping: output.damping.as_deref_mut(),
            part: MatrixMask::ALL,
        };
        self.inner.respond(motion, h, own)?;
        if let (Some(calls), Some(tangent)) = (calls, output.tangent.as_deref_mut()) {
            let shared = motion.opensees.map_or(&[] as &SharedState, |call| call.shared);
            calls.last_tangent(h.trial, shared, tangent, MatrixMask::ALL);
        }
        Ok(())
    }
}

impl CallDependent for Amended {
    fn shared_len(&self) -> usize {
        self.inner.opensees().calls.map_or(0, CallDependent::shared_len)
    }
    fn last_tangent(&self, history: &[f64], _: &SharedState, tangent: &mut [f64], _: MatrixMask) {
        tangent.copy_from_slice(&history[self.tangent_at()..]);
    }
}
