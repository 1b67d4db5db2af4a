//! Steps of one displacement.

use super::{Adaptive, Integrator};
use crate::analysis::failure::{Cause, Failure};
use crate::analysis::system::{Coefficients, System};
use crate::analysis::workspace::TangentMix;
use crate::assembly::Handler;
use crate::model::Model;
use crate::solve::Use;

/// `integrator DisplacementControl`: one degree of freedom moves by a given increment, the load factor follows
/// (Batoz and Dhatt, 1979).
#[derive(Clone, Debug)]
pub struct DisplacementControl {
    /// Global degree of freedom.
    dof: usize,
    step: f64,
    adaptive: Adaptive,
    last_iterations: usize,
    /// Stiffness of the prediction.
    mix: TangentMix,
    /// Load factor of the trial state.
    factor: f64,
    /// Reference load of the equations.
    reference: Vec<f64>,
    /// Revision of the model that the reference load is of.
    revision: Option<u64>,
    /// Displacement of the equations under the reference load.
    unit: Vec<f64>,
    /// Share of each equation in the controlled degree of freedom.
    control: Vec<(usize, f64)>,
}

impl DisplacementControl {
    /// From the degree of freedom, the increment and how it may change, and the stiffness that predicts.
    pub fn new(dof: usize, step: f64, adaptive: Adaptive, mix: TangentMix) -> Self {
        let last_iterations = adaptive.desired_iterations;
        Self {
            dof,
            step,
            adaptive,
            last_iterations,
            mix,
            factor: 0.0,
            reference: vec![],
            revision: None,
            unit: vec![],
            control: vec![],
        }
    }

    /// Displacement of the controlled degree of freedom in a vector of the equations.
    fn controlled(&self, x: &[f64]) -> f64 {
        self.control.iter().map(|&(e, c)| c * x[e]).sum()
    }

    /// Displacement under the reference load, with the factors at hand; how much of it is controlled.
    fn solve_unit(&mut self, s: &mut System<'_>) -> Result<f64, Failure> {
        self.unit.copy_from_slice(&self.reference);
        s.solve_for(&mut self.unit)?;
        let unit = self.controlled(&self.unit);
        if unit == 0.0 || !unit.is_finite() {
            let message = format!(
                "DisplacementControl: the reference load does not move {} (is there a load that follows its series?)",
                s.model.dof_name(self.dof)
            );
            return Err(s.failure(Cause::Model(message)).with_code(-2));
        }
        Ok(unit)
    }

    /// Let the load factor follow and move by `correction`.
    fn advance(&mut self, s: &mut System<'_>, factor: f64, correction: &[f64]) -> Result<(), Failure> {
        self.factor += factor;
        s.spread(correction);
        s.add_disp(1.0);
        s.work.spread.fill(0.0);
        s.apply_loads(self.factor)
    }
}

/// Degree of freedom that OpenSees controls instead of one of a constrained node: its number counts those of the node that
/// are free, and then those of the retained node.
fn transformed(model: &Model, dof: usize) -> usize {
    let Some(node) = model.nodes.iter().position(|n| n.dofs().contains(&dof)) else { return dof };
    let Some(link) = model.multi_points.iter().find(|m| m.constrained.0 == node) else { return dof };
    let own = model.nodes[node].dofs();
    let local = dof - own.start;
    let free = own.clone().filter(|d| !link.constrained_dofs.contains(&(d - own.start)));
    let retained = model.nodes[link.retained.0].dofs();
    free.chain(link.retained_dofs.iter().map(|d| retained.start + d)).nth(local).unwrap_or(dof)
}

impl Integrator for DisplacementControl {
    fn name(&self) -> &'static str {
        "DisplacementControl"
    }
    fn is_static(&self) -> bool {
        true
    }
    fn elapses(&self) -> bool {
        false
    }
    fn divides(&self) -> bool {
        true
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        let n = s.work.b.len();
        self.reference.resize(n, 0.0);
        self.unit.resize(n, 0.0);
        let dof = if s.work.opensees.is_some() && s.work.plan.handler == Handler::Transformation {
            transformed(s.model, self.dof)
        } else {
            self.dof
        };
        self.control = s.work.plan.map.terms(dof).iter().map(|&(e, c)| (e as usize, c)).collect();
        if self.control.is_empty() {
            let message =
                format!("DisplacementControl: {} is held and cannot be controlled", s.model.dof_name(self.dof));
            return Err(s.failure(Cause::Model(message)).with_code(-1));
        }
        s.renew_reference_load(&mut self.revision, &mut self.reference)
    }

    fn begin(&mut self, s: &mut System<'_>, part: f64) -> Result<(), Failure> {
        s.coefficients = Coefficients { k: 1.0, c: 0.0, m: 0.0 };
        self.step = self.adaptive.next(self.step, self.last_iterations);
        self.factor = s.old.time;
        // The loads as they are: element loads count in the tangent of a beam with P-Delta.
        s.apply_loads(self.factor)?;
        s.form_tangent(self.mix, Use::Once).map_err(|f| f.with_code(-2))?;
        let factor = part * self.step / self.solve_unit(s)?;
        let mut unit = std::mem::take(&mut self.unit);
        unit.iter_mut().for_each(|u| *u *= factor);
        let result = self.advance(s, factor, &unit);
        self.unit = unit;
        result
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        let unit = self.solve_unit(s)?;
        let factor = -self.controlled(correction) / unit;
        correction.iter_mut().zip(&self.unit).for_each(|(x, u)| *x += factor * u);
        self.advance(s, factor, correction)
    }

    fn commit(&mut self, _: &mut System<'_>, iterations: usize) -> Result<(), Failure> {
        self.last_iterations = iterations;
        Ok(())
    }
}
