//! Operator splitting that weights the forces of both ends of a step.

use super::central_difference::only_once;
use super::trapezoidal_explicit::predict;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator AlphaOS_TP` and `AlphaOSGeneralized_TP` (Combescure and Pegon, 1997): as [`AlphaOs`](super::AlphaOs), but the
/// elements are evaluated at the displacement predicted for the end of the step, and their forces there and at its begin are
/// weighted. A linear stiffness makes up for what lies between prediction and correction.
///
/// As in OpenSees the elements stay at the predicted displacement unless they are updated with the corrected one.
#[derive(Clone, Debug)]
pub struct TrapezoidalSplitting {
    name: &'static str,
    p: AlphaParameters,
    /// Elements see the corrected displacements.
    update_elements: bool,
    c: Coefficients,
    corrections: u32,
    /// Correction of the displacements at all degrees of freedom, and what the linear stiffness makes of it.
    correction: Vec<f64>,
    extra: Vec<f64>,
}

impl TrapezoidalSplitting {
    /// From its parameters.
    pub fn new(name: &'static str, p: AlphaParameters, update_elements: bool) -> Self {
        let c = Coefficients::default();
        Self { name, p, update_elements, c, corrections: 0, correction: vec![], extra: vec![] }
    }
}

impl Integrator for TrapezoidalSplitting {
    fn name(&self) -> &'static str {
        self.name
    }
    fn balances(&self) -> bool {
        false
    }
    fn multiplies_tangents(&self) -> bool {
        true
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.correction.resize(s.old.disp.len(), 0.0);
        self.extra.resize(s.work.b.len(), 0.0);
        s.hold_committed(1.0 - self.p.force, 1.0 - self.p.inertia)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, beta, gamma } = self.p;
        self.corrections = 0;
        self.c = Coefficients { k: 1.0, c: gamma / (beta * dt), m: 1.0 / (beta * dt * dt) };
        predict(s, &self.p, dt);
        s.coefficients = Coefficients { k: force * self.c.k, c: force * self.c.c, m: inertia * self.c.m };
        s.weigh_unbalance(force, inertia);
        s.apply_loads(s.old.time + dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name, &mut self.corrections, s)?;
        s.spread(correction);
        self.correction.copy_from_slice(&s.work.spread);
        // Dampers see the corrected velocity, but the displacement is still that of the prediction.
        s.add_motion(Coefficients { k: 0.0, ..self.c });
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        let share = 1.0 - self.p.force;
        s.stiffness_times(&self.correction, &mut self.extra)?;
        s.hold_unbalance(share, 1.0 - self.p.inertia);
        s.add_to_held(-share, &self.extra);
        s.new.disp.iter_mut().zip(&self.correction).for_each(|(u, d)| *u += self.c.k * d);
        if self.update_elements {
            s.moved = true;
            s.respond(false)?;
        }
        Ok(())
    }
}
