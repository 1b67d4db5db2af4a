//! Steps along the path of equilibrium.

use super::Integrator;
use super::reference_load::ReferenceLoad;
use crate::analysis::failure::{Cause, Failure};
use crate::analysis::system::System;
use crate::numeric::{axpy, dot};

/// `integrator ArcLength`: the length of the step in displacements and load factor is given, Δu·Δu + α² Δλ² = s²
/// (Crisfield, 1981).
#[derive(Clone, Debug)]
pub struct ArcLength {
    /// Square of the length.
    square: f64,
    /// Square of the weight of the load factor.
    weight: f64,
    reference: ReferenceLoad,
    /// Displacement of the equations since the begin of the step.
    step: Vec<f64>,
    /// Load factor since the begin of the step.
    step_factor: f64,
    /// Growth of the load factor in the last committed step: the next begins in the same sense.
    last_factor: f64,
    /// Corrections keep to the plane through the first point (Riks, 1979) instead of to the sphere.
    plane: bool,
}

impl ArcLength {
    /// From the length s and the weight α of the load factor.
    pub fn new(length: f64, alpha: f64) -> Self {
        Self {
            square: length * length,
            weight: alpha * alpha,
            reference: ReferenceLoad::default(),
            step: vec![],
            step_factor: 0.0,
            last_factor: 0.0,
            plane: false,
        }
    }

    /// `ArcLength1`: corrections keep the constraint to first order.
    pub fn linearised(length: f64, alpha: f64) -> Self {
        Self { plane: true, ..Self::new(length, alpha) }
    }

    /// Growth of the load factor that brings the step back to its length for a correction at constant load.
    fn correction(&self, s: &System<'_>, bar: &[f64]) -> Result<f64, Failure> {
        let unit = &self.reference.unit;
        if self.plane {
            let along = dot(&self.step, unit) + self.weight * self.step_factor;
            if along == 0.0 {
                return Err(self.lost(s));
            }
            return Ok(-dot(&self.step, bar) / along);
        }
        let a = self.weight + dot(unit, unit);
        let b = self.weight * self.step_factor + dot(unit, bar) + dot(&self.step, unit);
        let c = 2.0 * dot(&self.step, bar) + dot(bar, bar);
        let d = b * b - a * c;
        if d < 0.0 {
            return Err(self.lost(s));
        }
        // Of the two points on the sphere that which goes on in the direction of the step.
        let first = (-b + d.sqrt()) / a;
        let forward = dot(&self.step, &self.step) + dot(bar, &self.step) + first * dot(unit, &self.step);
        Ok(if forward > 0.0 { first } else { (-b - d.sqrt()) / a })
    }

    fn lost(&self, s: &System<'_>) -> Failure {
        s.failure(Cause::Model(format!("{}: no point of the path at this distance: try a shorter step", self.name())))
    }
}

impl Integrator for ArcLength {
    fn name(&self) -> &'static str {
        if self.plane { "ArcLength1" } else { "ArcLength" }
    }
    fn is_static(&self) -> bool {
        true
    }
    fn elapses(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.step.resize(s.work.b.len(), 0.0);
        self.reference.prepare(s)
    }

    fn begin(&mut self, s: &mut System<'_>, _: f64) -> Result<(), Failure> {
        self.reference.begin(s)?;
        let unit = &self.reference.unit;
        let size = (self.square / (dot(unit, unit) + self.weight)).sqrt();
        self.step_factor = if self.last_factor < 0.0 { -size } else { size };
        self.step.iter_mut().zip(unit).for_each(|(x, u)| *x = self.step_factor * u);
        self.reference.advance(s, self.step_factor, &self.step)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        self.reference.solve(s)?;
        let factor = self.correction(s, correction)?;
        axpy(factor, &self.reference.unit, correction);
        axpy(1.0, correction, &mut self.step);
        self.step_factor += factor;
        self.reference.advance(s, factor, correction)
    }

    fn commit(&mut self, _: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.last_factor = self.step_factor;
        Ok(())
    }
}
