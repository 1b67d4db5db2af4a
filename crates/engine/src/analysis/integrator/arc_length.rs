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
    constraint: Constraint,
    /// Square of the length.
    square: f64,
    /// Square of the weight of the load factor.
    weight: f64,
    /// Square of the weight of the displacements.
    scale: f64,
    reference: ReferenceLoad,
    /// Displacement of the equations since the begin of the step.
    step: Vec<f64>,
    /// Load factor since the begin of the step.
    step_factor: f64,
    /// Growth of the load factor in the last committed step: the next begins in the same sense.
    last_factor: f64,
    /// Displacement of the equations in the last committed step, where its tangent was singular.
    plateau: Option<Vec<f64>>,
}

/// Constraint that corrections keep.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Constraint {
    /// Sphere.
    Sphere,
    /// Plane through the first point (Riks, 1979).
    Plane,
    /// Sphere with the reference load in the weight of the load factor, which is this times its square.
    HyperSphere(f64),
}

impl ArcLength {
    /// From the length s and the weight α of the load factor.
    pub fn new(length: f64, alpha: f64) -> Self {
        Self {
            constraint: Constraint::Sphere,
            square: length * length,
            weight: alpha * alpha,
            scale: 1.0,
            reference: ReferenceLoad::default(),
            step: vec![],
            step_factor: 0.0,
            last_factor: 0.0,
            plateau: None,
        }
    }

    /// `ArcLength1`: corrections keep the constraint to first order.
    pub fn linearised(length: f64, alpha: f64) -> Self {
        Self { constraint: Constraint::Plane, ..Self::new(length, alpha) }
    }

    /// `integrator HSConstraint`: (ψᵤ/u)² Δu·Δu + ψ² Δλ² f·f = s² with the reference load f, from the length s, the weights
    /// ψᵤ and ψ, and the reference displacement u.
    pub fn hyper_spherical(length: f64, [displacement, load, reference]: [f64; 3]) -> Self {
        let scale = (displacement / reference).powi(2);
        Self { constraint: Constraint::HyperSphere(load * load), scale, ..Self::new(length, 0.0) }
    }

    /// Growth of the load factor that brings the step back to its length for a correction at constant load.
    fn correction(&self, s: &System<'_>, bar: &[f64]) -> Result<f64, Failure> {
        let unit = &self.reference.unit;
        if self.constraint == Constraint::Plane {
            let along = dot(&self.step, unit) + self.weight * self.step_factor;
            if along == 0.0 {
                return Err(self.lost(s));
            }
            return Ok(-dot(&self.step, bar) / along);
        }
        if let Constraint::HyperSphere(_) = self.constraint {
            return self.hyper_spherical_correction(s, bar);
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

    /// OpenSees' corrections meet another constraint, and go half of the way to it.
    fn hyper_spherical_correction(&self, s: &System<'_>, bar: &[f64]) -> Result<f64, Failure> {
        let unit = &self.reference.unit;
        let along = dot(unit, &self.step);
        let moved = self.step.iter().zip(bar).map(|(u, v)| u + v);
        let squared: f64 = moved.clone().map(|x| x * x).sum();
        let excess = self.weight * self.step_factor * self.step_factor - self.square;
        let a = self.scale * dot(unit, unit) + self.weight;
        let half = self.scale * (dot(unit, bar) + along) + self.weight * self.step_factor;
        let (b, c) = if s.work.opensees.is_some() {
            (2.0 * half, self.scale * (squared + excess * moved.sum::<f64>()))
        } else {
            (half, self.scale * squared + excess)
        };
        let d = b * b - a * c;
        if d < 0.0 {
            return Err(self.lost(s));
        }
        let roots = [(-b + d.sqrt()) / a, (-b - d.sqrt()) / a];
        Ok(if roots[0] * along > roots[1] * along { roots[0] } else { roots[1] })
    }

    fn lost(&self, s: &System<'_>) -> Failure {
        s.failure(Cause::Model(format!("{}: no point of the path at this distance: try a shorter step", self.name())))
    }
}

impl Integrator for ArcLength {
    fn name(&self) -> &'static str {
        match self.constraint {
            Constraint::Sphere => "ArcLength",
            Constraint::Plane => "ArcLength1",
            Constraint::HyperSphere(_) => "HSConstraint",
        }
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
        if let Constraint::HyperSphere(load) = self.constraint {
            self.weight = load * dot(&self.reference.load, &self.reference.load);
        }
        let size = (self.square / (self.scale * dot(unit, unit) + self.weight)).sqrt();
        let back = match &self.plateau {
            // The load factor stands still there, and its growth is round-off.
            Some(last) => dot(last, unit) < 0.0,
            None => self.last_factor < 0.0,
        };
        self.step_factor = if back { -size } else { size };
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

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.last_factor = self.step_factor;
        self.plateau = s.is_on_plateau().then(|| self.step.clone());
        Ok(())
    }
}
