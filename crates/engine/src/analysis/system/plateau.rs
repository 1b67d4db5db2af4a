//! Tangents without stiffness on the path of a load factor that follows the displacements.

use super::System;
use crate::analysis::workspace::TangentMix;
use crate::solve::{Pivots, SINGULAR, SolveError};

/// Share of the initial stiffness in the tangent of a plastic mechanism.
///
/// The tangent K of a structure at its plastic limit is singular. The equations of a path, K Δu - p Δλ = r with a constraint of
/// Δu and Δλ, are regular there. They are solved by way of (K + ε K₀)⁻¹, and ε is the relative error of a correction.
const INITIAL_SHARE: f64 = 1e-8;

impl System<'_> {
    /// Returns true if the last tangent was singular, and the integrator goes on with a share of the initial stiffness.
    pub fn is_on_plateau(&self) -> bool {
        self.work.matrix.plateau
    }

    /// The first element with a section that has no stiffness left in the trial state, in words.
    #[cold]
    pub fn exhausted(&self) -> Option<String> {
        self.model.elements.iter().find_map(|e| {
            let section = e.element.exhausted(&self.new.history[e.state.clone()])?;
            Some(format!("{section} in {} {}", e.element.class().name, e.tag))
        })
    }

    pub(super) fn is_singular(&self, result: &Result<Option<Pivots>, SolveError>) -> bool {
        match result {
            Err(SolveError::Singular { .. }) => true,
            Ok(Some(p)) => p.ratio <= SINGULAR && self.work.plan.handler.eliminates(),
            _ => false,
        }
    }

    /// Factors a singular tangent with a share of the initial stiffness, where the integrator determines the load factor. A
    /// mechanism of the virgin structure stays singular.
    pub(super) fn past_plateau(
        &mut self,
        result: Result<Option<Pivots>, SolveError>,
    ) -> Result<Option<Pivots>, SolveError> {
        let mix = self.work.matrix.mix;
        if self.elapses || self.dynamic || mix.current == 0.0 || !self.is_singular(&result) {
            return result;
        }
        let work = &mut *self.work;
        work.assemble(self.model, self.coefficients, TangentMix { initial: mix.initial + INITIAL_SHARE, ..mix });
        work.matrix.factored.copy_from_slice(&work.matrix.values);
        let factors = work.solver.factor(&work.plan.pattern, &work.matrix.values).map(Some);
        if factors.is_err() || self.is_singular(&factors) {
            self.work.solver.forget();
            return result;
        }
        self.work.matrix.plateau = true;
        Ok(None)
    }
}
