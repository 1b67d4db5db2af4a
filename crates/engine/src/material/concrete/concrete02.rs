//! Concrete with tension softening: Yassin.

use crate::material::concrete::yassin::{Branch, Crushing, History, Yassin};
use crate::material::lanes::{PointLaw, updates_blocks};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw};
use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;

/// The envelope of Kent, Scott and Park in compression, and linear softening in tension.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete02 {
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strength, not positive.
    pub fcu: f64,
    /// Strain at the crushing strength, negative.
    pub epscu: f64,
    /// Unloading slope at the crushing strain divided by the initial modulus.
    pub ratio: f64,
    /// Tensile strength.
    pub ft: f64,
    /// Tension softening modulus.
    pub ets: f64,
}

/// Tangent of the branches with constant stress; a positive value keeps the stiffness matrix regular.
const FLAT_TANGENT: f64 = 1.0e-10;

impl Yassin for Concrete02 {
    fn modulus(&self) -> f64 {
        2.0 * self.fc / self.epsc0
    }

    fn crushing(&self) -> Crushing {
        Crushing { fcu: self.fcu, epscu: self.epscu, ratio: self.ratio }
    }

    #[inline(always)]
    fn compression(&self, eps: f64) -> (f64, f64) {
        let eta = eps / self.epsc0;
        let slope = (self.fcu - self.fc) / (self.epscu - self.epsc0);
        let (rising, falling) = (eps >= self.epsc0, eps > self.epscu);
        let after = select(falling, self.fc + slope * (eps - self.epsc0), self.fcu);
        let stress = select(rising, self.fc * eta * (2.0 - eta), after);
        (stress, select(rising, self.modulus() * (1.0 - eta), select(falling, slope, FLAT_TANGENT)))
    }

    #[inline(always)]
    fn tension(&self, eps: f64) -> (f64, f64) {
        let modulus = self.modulus();
        let peak = self.ft / modulus;
        let (elastic, softening) = (eps <= peak, eps <= self.ft * (1.0 / self.ets + 1.0 / modulus));
        let after = select(softening, self.ft - self.ets * (eps - peak), 0.0);
        let slope = select(softening, -self.ets, FLAT_TANGENT);
        (select(elastic, modulus * eps, after), select(elastic, modulus, slope))
    }

    #[inline(always)]
    fn unloading(&self, min: f64, through: f64) -> f64 {
        select(min == 0.0, self.modulus(), through)
    }
}

impl PointLaw<{ History::LEN }> for Concrete02 {
    #[inline(always)]
    fn response(&self, c: [f64; History::LEN], eps: f64) -> ([f64; History::LEN], f64, f64) {
        let [_, _, _, min, _] = c;
        self.step(c, eps, &Branch::select(eps < min, &self.crushes(c, eps), &self.inside(c, eps)))
    }
}

impl UniaxialLaw for Concrete02 {
    type State = History;
    const NAME: &'static str = "Concrete02";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        Ok(self.respond_to(c, strain.value))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}
