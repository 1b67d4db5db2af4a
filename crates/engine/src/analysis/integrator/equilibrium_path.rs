//! Steps along the path of equilibrium by one of several constraints.

use super::Integrator;
use super::reference_load::ReferenceLoad;
use crate::analysis::failure::{Cause, Failure};
use crate::analysis::system::System;
use crate::numeric::{axpy, dot};

/// Constraint that the corrections of a step keep to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathConstraint {
    /// Each correction is least (Chan, 1988).
    MinimumResidual,
    /// The plane at a right angle to the first increment (Riks, 1979).
    NormalPlane,
    /// The plane at a right angle to the increment so far (Ramm, 1981).
    UpdatedNormalPlane,
    /// The cylinder of the length of the step (Crisfield, 1981).
    Cylinder,
    /// Along the normal of the flow, with the displacement under the reference load taken out.
    NormalFlow,
    /// Generalised displacement control (Yang and Shieh, 1990).
    GeneralisedDisplacement,
    /// The increment so far and the correction are at right angles to each other.
    ModifiedNormalPlane,
    /// The whole increment has no part along the displacement under the reference load.
    IncrementNormal,
}

/// `integrator EQPath` (Rezaiee-Pajand, Ghalishooyan and Salehi-Ahmadabad, Structural Engineering and Mechanics 48, 2013):
/// the first increment has a given length, and corrections keep to a constraint.
#[derive(Clone, Debug)]
pub struct EquilibriumPath {
    length: f64,
    constraint: PathConstraint,
    reference: ReferenceLoad,
    /// Displacement of the equations since the begin of the step; before it, that of the last step.
    step: Vec<f64>,
    /// First increment of the step.
    first: Vec<f64>,
    /// Displacement under the reference load at the begin of this step and of the last one; empty before them.
    units: [Vec<f64>; 2],
}

impl EquilibriumPath {
    /// From the length of the first increments.
    pub fn new(length: f64, constraint: PathConstraint) -> Self {
        Self {
            length,
            constraint,
            reference: ReferenceLoad::default(),
            step: vec![],
            first: vec![],
            units: [vec![], vec![]],
        }
    }

    /// Growth of the load factor with a correction at constant load.
    fn correction(&self, s: &System<'_>, bar: &[f64]) -> Result<f64, Failure> {
        let unit = &self.reference.unit;
        let along = |direction: &[f64]| (dot(direction, bar), dot(direction, unit));
        let (above, below) = match self.constraint {
            PathConstraint::Cylinder => return self.on_cylinder(s, bar),
            PathConstraint::ModifiedNormalPlane => return Ok(self.on_modified_plane(bar)),
            PathConstraint::MinimumResidual | PathConstraint::NormalFlow => along(unit),
            PathConstraint::NormalPlane => along(&self.first),
            PathConstraint::UpdatedNormalPlane => along(&self.step),
            PathConstraint::GeneralisedDisplacement if self.units[1].is_empty() => along(unit),
            PathConstraint::GeneralisedDisplacement => along(&self.units[1]),
            PathConstraint::IncrementNormal => (dot(&self.step, unit) + dot(bar, unit), dot(unit, unit)),
        };
        if below == 0.0 { Err(lost(s)) } else { Ok(-above / below) }
    }

    fn on_cylinder(&self, s: &System<'_>, bar: &[f64]) -> Result<f64, Failure> {
        let (step, unit) = (&self.step, &self.reference.unit);
        let (a, b) = (dot(unit, unit), 2.0 * (dot(step, unit) + dot(bar, unit)));
        let c = dot(step, step) + 2.0 * dot(step, bar) + dot(bar, bar) - self.length * self.length;
        let d = b * b - 4.0 * a * c;
        if d < 0.0 { Err(lost(s)) } else { Ok(self.forward(a, b, d)) }
    }

    fn on_modified_plane(&self, bar: &[f64]) -> f64 {
        let (step, unit) = (&self.step, &self.reference.unit);
        let (a, b) = (dot(unit, unit), dot(step, unit) + 2.0 * dot(bar, unit));
        let c = dot(bar, step) + dot(bar, bar);
        let mut d = b * b - 4.0 * a * c;
        if d < 0.0 {
            // No right angle: the least possible angle, opened by a tenth of what is left.
            let least = -dot(bar, unit) / a;
            let (mut whole, mut part) = (0.0, 0.0);
            for ((u, r), x) in unit.iter().zip(bar).zip(step) {
                let v = r + least * u;
                part += v * v;
                whole += (x + v) * (x + v);
            }
            let size = (whole * part).sqrt();
            let alpha = (c - b * b / 4.0 / a) / size;
            d = b * b - 4.0 * a * (c - (alpha + 0.1 * (1.0 - alpha)) * size);
        }
        self.forward(a, b, d.max(0.0))
    }

    /// Of two roots that which goes on in the direction of the step.
    fn forward(&self, a: f64, b: f64, discriminant: f64) -> f64 {
        let root = discriminant.sqrt();
        let [first, second] = [(-b + root) / 2.0 / a, (-b - root) / 2.0 / a];
        let slope = dot(&self.step, &self.reference.unit);
        if second * slope > first * slope { second } else { first }
    }
}

fn lost(s: &System<'_>) -> Failure {
    s.failure(Cause::Model("EQPath: no point of the path at this distance: try a shorter step".into()))
}

impl Integrator for EquilibriumPath {
    fn name(&self) -> &'static str {
        "EQPath"
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
        self.units.swap(0, 1);
        self.units[0].clone_from(unit);
        let size = self.length / dot(unit, unit).sqrt();
        let factor = if dot(&self.step, unit) >= 0.0 { size } else { -size };
        self.step.iter_mut().zip(unit).for_each(|(x, u)| *x = factor * u);
        self.first.clone_from(&self.step);
        self.reference.advance(s, factor, &self.step)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        self.reference.solve(s)?;
        let factor = self.correction(s, correction)?;
        axpy(factor, &self.reference.unit, correction);
        if self.constraint == PathConstraint::NormalFlow {
            let begin = &self.units[0];
            let out = -dot(correction, &self.reference.unit) / dot(begin, begin);
            axpy(out, &self.reference.unit, correction);
        }
        axpy(1.0, correction, &mut self.step);
        self.reference.advance(s, factor, correction)
    }
}
