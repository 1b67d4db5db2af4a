//! Integrators: how a step advances, in a load factor or in time.

mod alpha_os;
mod arc_length;
mod backward_euler;
mod central_difference;
mod central_difference_alternative;
mod collocation;
mod displacement_control;
mod equilibrium_path;
mod explicit_alpha;
mod explicit_bathe;
mod explicit_difference;
mod explicit_start;
mod fixed_iterations;
mod generalized_alpha;
mod gimme_mck;
mod hht;
mod houbolt;
mod kr_alpha;
mod load_control;
mod min_unbal_disp_norm;
mod multistep;
mod newmark;
mod park_lms3;
mod reference_load;
mod restrained;
mod trapezoidal;
mod trapezoidal_explicit;
mod trapezoidal_splitting;
mod trbdf2;
mod trbdf3;

use super::failure::Failure;
use super::opensees::Parts;
use super::system::System;
use dyn_clone::DynClone;
use std::fmt;

pub use alpha_os::AlphaOs;
pub use arc_length::ArcLength;
pub use backward_euler::backward_euler;
pub use central_difference::CentralDifference;
pub use central_difference_alternative::CentralDifferenceAlternative;
pub use collocation::Collocation;
pub use displacement_control::DisplacementControl;
pub use equilibrium_path::{EquilibriumPath, PathConstraint};
pub use explicit_alpha::ExplicitAlpha;
pub use explicit_bathe::ExplicitBathe;
pub use explicit_difference::ExplicitDifference;
pub use fixed_iterations::FixedIterations;
pub use generalized_alpha::{AlphaParameters, GeneralizedAlpha};
pub use gimme_mck::GimmeMck;
pub use hht::Hht;
pub use houbolt::houbolt;
pub use kr_alpha::KrAlpha;
pub use load_control::LoadControl;
pub use min_unbal_disp_norm::{MinUnbalDispNorm, Sense};
pub use newmark::{Form, Newmark};
pub use park_lms3::park_lms3;
pub use restrained::{Restrained, Restraint};
pub use trapezoidal::Trapezoidal;
pub use trapezoidal_explicit::TrapezoidalExplicit;
pub use trapezoidal_splitting::TrapezoidalSplitting;
pub use trbdf2::trbdf2;
pub use trbdf3::trbdf3;

/// Rule by which a step advances.
///
/// The calls of a step are `begin`, then `update` for each correction, then `commit`; a step that fails ends without
/// `commit`, and the next `begin` finds the committed state again.
pub trait Integrator: DynClone + fmt::Debug + Send {
    /// Name in the `integrator` command.
    fn name(&self) -> &'static str;

    /// Returns true if it serves `analysis Static`.
    fn is_static(&self) -> bool {
        false
    }

    /// Returns true if domain time is time: it is not where something else than time determines the step.
    fn elapses(&self) -> bool {
        true
    }

    /// Returns true if the unbalance of a solved step is an error of equilibrium: it is not for explicit methods.
    fn balances(&self) -> bool {
        true
    }

    /// Largest product of natural frequency and step, ω dt, at which a free oscillation without damping does not grow. `None`
    /// where there is no limit.
    fn stability_limit(&self) -> Option<f64> {
        None
    }

    /// Returns true if [`Integrator::update`] only adds the correction, times its coefficients, to the trial motion.
    fn only_adds(&self) -> bool {
        false
    }

    /// Returns true if the tangents of the elements are multiplied with displacements that are in no equation.
    fn multiplies_tangents(&self) -> bool {
        false
    }

    /// Parts of the motion that OpenSees sets at the nodes when a step begins. `None` where they are not known, or other rules
    /// hold: nodes that its handler moves late cannot be followed then.
    fn opensees_begin(&self) -> Option<Parts> {
        self.is_static().then_some([false; 3])
    }

    /// Increment of the load factor, where that is all of a step.
    fn fixed_increment(&self) -> Option<f64> {
        None
    }

    /// Itself, where it is Newmark's method.
    fn newmark(&self) -> Option<&Newmark> {
        None
    }

    /// Returns true if a step can be made in parts, by giving `begin` parts of its length.
    fn divides(&self) -> bool {
        !self.is_static()
    }

    /// The model has changed, or the integrator is new.
    fn prepare(&mut self, _system: &mut System<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// Begin a step of length `dt` (of static integrators, which know it themselves, the part of it that is made: 1 unless
    /// they [divide](Integrator::divides)): set the predicted motion, the loads and the coefficients of the tangent.
    fn begin(&mut self, system: &mut System<'_>, dt: f64) -> Result<(), Failure>;

    /// Take a correction of the equations. An integrator that rules the load factor may change it.
    fn update(&mut self, system: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure>;

    /// The step has been found: bring the trial state to the end of the step.
    fn commit(&mut self, _system: &mut System<'_>, _iterations: usize) -> Result<(), Failure> {
        Ok(())
    }
}

dyn_clone::clone_trait_object!(Integrator);

/// Steps whose size follows the number of iterations that the last step took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive {
    /// Iterations that a step should take; 0 keeps the size.
    pub desired_iterations: usize,
    /// Smallest size.
    pub min: f64,
    /// Largest size.
    pub max: f64,
}

impl Adaptive {
    /// A fixed size.
    pub fn fixed(size: f64) -> Self {
        Self { desired_iterations: 1, min: size, max: size }
    }

    /// The next size.
    #[inline]
    pub fn next(&self, size: f64, last_iterations: usize) -> f64 {
        if self.min == self.max {
            return self.min;
        }
        let next = size * self.desired_iterations as f64 / last_iterations.max(1) as f64;
        if next < self.min {
            self.min
        } else if next > self.max {
            self.max
        } else {
            next
        }
    }

    /// The size to try after a step of `size`, above the smallest, has failed: the next one where that is smaller, else half
    /// of it. A step may fail before its first iteration, or within the iterations that a step should take.
    pub fn shorter(&self, size: f64, last_iterations: usize) -> f64 {
        let next = self.next(size, last_iterations);
        if next < size { next } else { (0.5 * size).max(self.min) }
    }
}
