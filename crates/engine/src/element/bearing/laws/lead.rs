//! Heating of a lead core.

use crate::element::bearing::laws::rubber::PI;

/// Rise of temperature of a lead core that works, and the yield force that it leaves.
///
/// I. V. Kalpakidis and M. C. Constantinou, "Effects of heating on the behavior of lead-rubber bearings. I: Theory", Journal
/// of Structural Engineering 135 (2009) 1440-1449: work heats the lead, and heat flows out to the end plates and the shims
/// by an amount that depends on the time since the motion began, which is the domain time here. SI units: the constants of
/// the material are in metres, kilograms, seconds and degrees Celsius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadCore {
    /// Radius a.
    pub radius: f64,
    /// Area A_L.
    pub area: f64,
    /// Height h.
    pub height: f64,
    /// Thickness of all shims.
    pub shims: f64,
    /// Density ρ_L.
    pub density: f64,
    /// Specific heat c_L.
    pub heat: f64,
    /// Thermal conductivity of steel k_s.
    pub conductivity: f64,
    /// Thermal diffusivity of steel α_s.
    pub diffusivity: f64,
}

/// Decrease of the yield strength of lead with temperature, 1/°C.
const SOFTENING: f64 = 0.0069;

impl LeadCore {
    /// Heat that flows out at a time, per degree, as a rate of temperature; the square root and cube root of the time
    /// make it infinite at the beginning.
    fn loss(&self, time: f64) -> f64 {
        let tau = self.diffusivity * time / (self.radius * self.radius);
        let plates = if tau < 0.6 {
            let t = 0.25 * tau;
            2.0 * (tau / PI).sqrt() - tau / PI * (2.0 - t - t * t - 3.75 * t * t * t)
        } else {
            let t = 4.0 * tau;
            let series = 1.0 - 1.0 / (3.0 * t) + 1.0 / (6.0 * t * t) - 1.0 / (12.0 * t * t * t);
            8.0 / (3.0 * PI) - series / (2.0 * (PI * tau).sqrt())
        };
        let shims = 1.274 * self.shims / self.radius / tau.cbrt();
        self.conductivity / self.radius * (1.0 / plates + shims) / self.capacity()
    }

    /// Heat that a degree takes, per area of the core.
    fn capacity(&self) -> f64 {
        self.density * self.heat * self.height
    }

    /// Yield force over that of the cold core.
    pub fn strength(rise: f64) -> f64 {
        (-SOFTENING * rise).exp()
    }

    /// Rise of temperature after a step in which the force `strength` does work at `speed`: backward Euler, which
    /// neither overshoots nor cools below the start.
    pub fn warm(&self, rise: f64, strength: f64, speed: f64, time: f64, dt: f64) -> f64 {
        if dt <= 0.0 || time <= 0.0 {
            return rise;
        }
        let gain = strength * speed / (self.area * self.capacity());
        (rise + dt * gain) / (1.0 + dt * self.loss(time))
    }

    /// The same by OpenSees' scheme: improved Euler whose first stage never cools, and whose second stage is that of the
    /// time after the step.
    pub fn warm_as_opensees(&self, rise: f64, strength: f64, speed: f64, time: f64, dt: f64) -> f64 {
        // At the beginning OpenSees multiplies an infinite loss by no rise.
        if time <= 0.0 {
            return rise;
        }
        let gain = strength * speed / (self.area * self.capacity());
        let first = (dt * (gain - rise * self.loss(time))).max(0.0);
        let second = dt * (gain - (rise + first) * self.loss(time + dt));
        rise + 0.5 * (first + second)
    }
}
