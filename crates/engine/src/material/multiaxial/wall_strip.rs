//! Horizontal strain of a wall from its shear strain.

use super::plain_methods::inner_methods;
use super::{Multiaxial, PLANE, STRIP, SharedMultiaxial, Tangent};
use crate::material::MultiaxialResult;
use std::sync::Arc;

/// A panel in plane stress whose horizontal strain is a function of the shear strain γ: a (1 - 3^(-800 |γ|)) |γ| (Massone, Lopez
/// and Kolozvari, 2021, Engineering Structures 242, 112509). Here a = 0.55, or 0.55 (1 + ρ)^-60 with the ratio ρ of the
/// horizontal bars.
#[derive(Clone, Debug)]
pub struct WallStrip {
    /// Law in plane stress.
    pub panel: SharedMultiaxial<PLANE>,
    /// Limit a of the horizontal strain over the shear strain.
    pub limit: f64,
}

/// Limit of the horizontal strain over the shear strain without bars.
const LIMIT: f64 = 0.55;
/// Exponent of the ratio of the horizontal bars.
const CONFINEMENT: f64 = -60.0;
/// Rate at which the limit is reached.
const RATE: f64 = 800.0;
const BASE: f64 = 3.0;

impl WallStrip {
    /// A panel whose horizontal bars have an influence, or none.
    pub fn new(panel: SharedMultiaxial<PLANE>, confined: bool) -> Self {
        let limit = if confined { LIMIT * (1.0 + panel.reinforcement()).powf(CONFINEMENT) } else { LIMIT };
        Self { panel, limit }
    }

    /// Strains of the panel, and the derivative of the horizontal one by the shear strain.
    fn strains(&self, [vertical, shear]: [f64; STRIP]) -> ([f64; PLANE], f64) {
        let size = shear.abs();
        let left = BASE.powf(-RATE * size);
        let slope = self.limit * (1.0 - left + RATE * BASE.ln() * left * size);
        ([self.limit * (1.0 - left) * size, vertical, shear], slope * shear.signum())
    }

    fn tangent(k: &Tangent<PLANE>, slope: f64) -> Tangent<STRIP> {
        [1, 2].map(|i| [k[i][1], k[i][2] + k[i][0] * slope])
    }
}

crate::watches_columns!(WallStrip => |s| in [&s.panel]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<STRIP> for WallStrip {
    inner_methods! { panel: storage properties responses }
    fn is_linear(&self) -> bool {
        false
    }
    fn is_symmetric(&self) -> bool {
        false
    }
    fn shown_stress(&self, next: &[f64], [vertical, shear]: [f64; STRIP]) -> [f64; STRIP] {
        let [_, vertical, shear] = self.panel.shown_stress(next, [0.0, vertical, shear]);
        [vertical, shear]
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<STRIP>> {
        Some(Arc::new(Self { panel: self.panel.of_length(length)?, limit: self.limit }))
    }
    fn update(&self, committed: &[f64], e: &[f64; STRIP], dt: f64, next: &mut [f64]) -> MultiaxialResult<STRIP> {
        let (strains, slope) = self.strains(*e);
        let ([_, vertical, shear], tangent) = self.panel.update(committed, &strains, dt, next)?;
        Ok(([vertical, shear], Self::tangent(&tangent, slope)))
    }
    fn initial_tangent(&self) -> Tangent<STRIP> {
        Self::tangent(&self.panel.initial_tangent(), 0.0)
    }
}
