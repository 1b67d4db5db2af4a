//! Limit surfaces of columns in shear and in axial load.

use super::RotationShear;
use std::f64::consts::PI;

/// Angle of the critical crack.
const CRACK: f64 = 65.0 * PI / 180.0;
/// Drift below which a column does not fail in shear.
const MIN_DRIFT: f64 = 0.01;
/// Capacity there, which no force reaches.
const UNLIMITED: f64 = 9.9e9;

/// Deformation of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitDeformation {
    /// Larger chord rotation of its ends.
    ChordRotation,
    /// Difference of the displacements of two nodes (tags) in the direction `dof`, divided by their distance along a
    /// coordinate.
    Drift {
        /// Tags of the nodes.
        nodes: [i32; 2],
        /// Degree of freedom, from 0.
        dof: usize,
        /// Coordinate, from 0.
        along: usize,
    },
    /// Difference of the rotations of two nodes.
    Rotation {
        /// Tags of the nodes.
        nodes: [i32; 2],
        /// Degree of freedom, from 0.
        dof: usize,
    },
}

/// Force of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitForce {
    /// Of the spring itself.
    Spring,
    /// Shear of the column.
    Shear,
    /// Axial load of the column, compression positive.
    Axial,
}

/// Force at which a column fails, by its deformation.
#[derive(Clone, Debug, PartialEq)]
pub enum LimitSurface {
    /// Shear of a column after flexural yielding (Elwood, 2004), kip, in. and psi.
    Shear {
        /// Ratio of hoops.
        rho: f64,
        /// Concrete strength, psi.
        fc: f64,
        /// Width, depth and effective depth, in.
        size: [f64; 3],
        /// Force of the hoops A f d / s, kip.
        hoops: f64,
        /// Shift of the drift.
        shift: f64,
    },
    /// Axial load by friction along the crack (Elwood and Moehle, 2005).
    Axial {
        /// Force of the hoops.
        hoops: f64,
        /// Shift of the drift.
        shift: f64,
    },
    /// Straight lines between three points (deformation, force), no force before the first.
    Points([[f64; 2]; 3]),
    /// A rotation or a shear force (Leborgne, 2012).
    RotationShear(RotationShear),
}

/// A limit surface with the column that it watches.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitCurve {
    /// Tag of the element.
    pub element: i32,
    /// Deformation.
    pub deformation: LimitDeformation,
    /// Force.
    pub force: LimitForce,
    /// Surface.
    pub surface: LimitSurface,
    /// Slope after failure.
    pub slope: f64,
    /// Residual force.
    pub residual: f64,
}

/// Committed response of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColumnResponse {
    /// Deformation, positive.
    pub deformation: f64,
    /// 1 divided by the height of the column, where the deformation is a drift.
    pub per_height: f64,
    /// Axial force, shear force and moment at the first end, in local axes.
    pub force: [f64; 3],
}

impl LimitCurve {
    /// State of the column after a step, and the force above the surface. `failure` takes the slope and the residual force.
    pub(super) fn check(&self, spring: f64, seen: &ColumnResponse, before: f64, failure: &mut [f64; 2]) -> (f64, f64) {
        if let LimitSurface::RotationShear(surface) = &self.surface {
            if before != 0.0 {
                return (2.0, 0.0);
            }
            if !surface.is_reached(spring.abs(), seen) {
                return (0.0, 0.0);
            }
            *failure = surface.failure(spring.abs(), self.slope, self.residual);
            return (1.0, 0.0);
        }
        let axial = matches!(self.surface, LimitSurface::Axial { .. });
        let force = match self.force {
            LimitForce::Spring if axial => spring,
            LimitForce::Spring => spring.abs(),
            LimitForce::Shear => seen.force[1].abs(),
            LimitForce::Axial if axial => seen.force[0],
            LimitForce::Axial => seen.force[0].abs(),
        };
        let limit = self.limit(seen);
        let lost = force.abs() - limit.abs();
        let reached = force >= limit;
        if before != 0.0 {
            let flag = match reached {
                true if axial && limit == self.residual => 4.0,
                true => 2.0,
                false => 3.0,
            };
            return (flag, if reached { lost } else { 0.0 });
        }
        if !reached {
            return (0.0, 0.0);
        }
        *failure = [self.failing_slope(force, seen), self.residual];
        (1.0, lost)
    }

    fn limit(&self, seen: &ColumnResponse) -> f64 {
        let x = seen.deformation;
        match &self.surface {
            LimitSurface::Shear { rho, fc, size: [b, h, d], shift, .. } => {
                if x < MIN_DRIFT {
                    return UNLIMITED;
                }
                let axial = seen.force[0].abs() / b / h / (fc / 1000.0);
                (500.0 * (0.03 + shift + 4.0 * rho - x - 0.025 * axial) * (b * d * fc.sqrt() / 1000.0)).max(0.0)
            }
            LimitSurface::Axial { hoops, shift } => {
                let d = if x - shift <= 0.0 { 1.0e-9 } else { x - shift };
                let t = CRACK.tan();
                (((1.0 + t * t) / (25.0 * d) - t) * hoops * t).max(self.residual)
            }
            LimitSurface::Points([[x1, y1], [x2, y2], [x3, y3]]) => {
                if x < *x1 {
                    0.0
                } else if x < *x2 {
                    y1 + (y2 - y1) / (x2 - x1) * (x - x1)
                } else if x < *x3 {
                    y2 + (y3 - y2) / (x3 - x2) * (x - x2)
                } else {
                    *y3
                }
            }
            LimitSurface::RotationShear(_) => f64::INFINITY,
        }
    }

    /// A positive slope of a shear surface is the unloading stiffness of the column in bending. The slope of the spring makes
    /// the column lose its shear at the drift of axial failure.
    fn failing_slope(&self, force: f64, seen: &ColumnResponse) -> f64 {
        let LimitSurface::Shear { hoops, .. } = self.surface else { return self.slope };
        if !(self.slope > 0.0 && seen.per_height > 0.0) {
            return self.slope;
        }
        let t = CRACK.tan();
        let axial = 0.04 * (1.0 + t * t) / (t + seen.force[0].abs() / hoops / t);
        let whole = -force / (axial - seen.deformation) * seen.per_height;
        1.0 / (1.0 / whole - 1.0 / self.slope)
    }
}
