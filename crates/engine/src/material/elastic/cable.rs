//! Elastic cable that sags under its weight.

mod opensees;

use crate::material::{MaterialError, MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::bracketed_root;
use crate::rules::Consistent;
use std::fmt;

/// Maximum number of iterations for the stress; bisection alone needs fewer.
const MAX_ITERATIONS: u32 = 200;

/// Strain of a cable from its prestress P to a stress σ: ε = (σ - P)(1 + c/σ)/E + c (1/P² - 1/σ²), with c = w² L²/24 of
/// the weight per volume w and the length L. The first term is elastic, the second one is the change of the sag (Jayaraman
/// and Knudson, 1981). A slack cable has no stress.
#[derive(Clone, Debug, PartialEq)]
pub struct Cable<R = Consistent> {
    /// Prestress P.
    pub prestress: f64,
    /// Elastic modulus E.
    pub e: f64,
    /// Weight per volume w.
    pub weight: f64,
    /// Length L.
    pub length: f64,
    /// Rules that differ in OpenSees.
    pub rules: R,
}

/// Rules of [`Cable`] that differ in OpenSees.
pub trait Rules: Copy + fmt::Debug + Send + Sync + 'static {
    /// Share of the change of the sag in the strain.
    const SAG: f64 = 1.0;

    /// Tangent at a stress.
    fn tangent(cable: &Cable<Self>, stress: f64) -> f64 {
        1.0 / cable.strain(stress).1
    }
}

impl Rules for Consistent {}

impl<R: Rules> Cable<R> {
    /// w² L²/24.
    fn sag(&self) -> f64 {
        (self.weight * self.length).powi(2) / 24.0
    }

    /// Strain at a stress, and its derivative.
    fn strain(&self, stress: f64) -> (f64, f64) {
        let (c, p) = (self.sag(), self.prestress);
        let elastic = (stress - p) * (1.0 + c / stress) / self.e;
        let slope = (1.0 + c * p / (stress * stress)) / self.e;
        let change = c * (1.0 / (p * p) - 1.0 / (stress * stress));
        (elastic + R::SAG * change, slope + R::SAG * 2.0 * c / stress.powi(3))
    }

    /// Stress at a strain; 0 where the cable is slack.
    fn stress(&self, strain: f64) -> MaterialResult<f64> {
        let taut = self.prestress + self.e * strain;
        if self.sag() == 0.0 {
            return Ok(taut.max(0.0));
        }
        // Without the sag the stress is at most `taut` in tension; shortening leaves some of the prestress.
        let (top, start) = if strain > 0.0 { (taut, taut) } else { (self.prestress, self.prestress) };
        let missing = |stress: f64| {
            let (at, slope) = self.strain(stress);
            (at - strain, slope)
        };
        bracketed_root(missing, (0.0, top), start, self.prestress, MAX_ITERATIONS)
            .ok_or_else(|| MaterialError(format!("the cable has no stress at a strain of {strain:.6e}")))
    }
}

impl<R: Rules> UniaxialLaw for Cable<R> {
    type State = ();
    const NAME: &'static str = "Cable";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let value = self.stress(strain.value)?;
        let tangent = if value > 0.0 { R::tangent(self, value) } else { 0.0 };
        Ok((Stress { value, tangent, damping: 0.0 }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        R::tangent(self, self.prestress)
    }
}
