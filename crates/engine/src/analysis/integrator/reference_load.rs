//! Load that a load factor multiplies, and the displacement under it: shared by integrators that determine the load factor.

use crate::analysis::failure::{Cause, Failure};
use crate::analysis::system::{Coefficients, System};
use crate::analysis::workspace::TangentMix;
use crate::numeric::dot;
use crate::solve::Use;

/// The reference load, the displacement under it, and the load factor as it grows.
#[derive(Clone, Debug, Default)]
pub(super) struct ReferenceLoad {
    /// Load of the equations per unit of load factor.
    pub(super) load: Vec<f64>,
    /// Revision of the model that it is of.
    revision: Option<u64>,
    /// Displacement of the equations under it.
    pub(super) unit: Vec<f64>,
    /// Load factor of the trial state.
    pub(super) factor: f64,
}

impl ReferenceLoad {
    /// The model or a part of the analysis has changed.
    pub(super) fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        let n = s.work.b.len();
        self.load.resize(n, 0.0);
        self.unit.resize(n, 0.0);
        s.renew_reference_load(&mut self.revision, &mut self.load)
    }

    /// Begin a step: tangent and displacement under the reference load at the committed state.
    pub(super) fn begin(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        s.coefficients = Coefficients { k: 1.0, c: 0.0, m: 0.0 };
        self.factor = s.old.time;
        s.apply_loads(self.factor)?;
        s.form_tangent(TangentMix::CURRENT, Use::Once).map_err(|f| f.with_code(-2))?;
        self.solve(s)
    }

    /// Displacement under the reference load with the factors at hand.
    pub(super) fn solve(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.unit.copy_from_slice(&self.load);
        s.solve_for(&mut self.unit)?;
        if dot(&self.unit, &self.unit) == 0.0 {
            let message =
                "the load that follows the load factor moves nothing (is there a load that follows its series?)";
            return Err(s.failure(Cause::Model(message.into())).with_code(-2));
        }
        Ok(())
    }

    /// Let the load factor grow, and move.
    pub(super) fn advance(&mut self, s: &mut System<'_>, factor: f64, motion: &[f64]) -> Result<(), Failure> {
        self.factor += factor;
        s.spread(motion);
        s.add_disp(1.0);
        s.work.spread.fill(0.0);
        s.apply_loads(self.factor)
    }
}
