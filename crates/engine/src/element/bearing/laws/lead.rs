//! Heating of a lead core.

use crate::element::bearing::laws::rubber::PI;

/// Temperature rise of a lead core, and its yield force.
///
/// Source: I. V. Kalpakidis and M. C. Constantinou, "Effects of heating on the behavior of lead-rubber bearings. I:
/// Theory", Journal of Structural Engineering 135 (2009) 1440-1449. Work heats the lead. Heat flows to the end plates
/// and the shims. The rate depends on the time since the start of motion, here the domain time. Units are SI: metres,
/// kilograms, seconds, degrees Celsius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadCore {
    /// Radius a of the core.
    pub radius: f64,
    /// Area A_L of the core.
    pub area: f64,
    /// Height h of the core.
    pub height: f64,
    /// Total thickness of the shims.
    pub shims: f64,
    /// Density ρ_L of lead.
    pub density: f64,
    /// Specific heat c_L of lead.
    pub heat: f64,
    /// Thermal conductivity of steel k_s.
    pub conductivity: f64,
    /// Thermal diffusivity of steel α_s.
    pub diffusivity: f64,
}

/// Coefficient of the yield strength of lead with temperature, 1/°C.
const SOFTENING: f64 = 0.0069;

impl LeadCore {
    /// Heat loss per degree at a time, as a rate of temperature. It is infinite at time 0, by the square and cube root
    /// of the time.
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

    /// Heat capacity per area of the core, energy/(area °C).
    fn capacity(&self) -> f64 {
        self.density * self.heat * self.height
    }

    /// Ratio of the yield force to that of the cold core.
    pub fn strength(rise: f64) -> f64 {
        (-SOFTENING * rise).exp()
    }

    /// Temperature rise after a step with the work of the force `strength` at `speed`. Backward Euler neither
    /// overshoots nor cools below the initial temperature.
    pub fn warm(&self, rise: f64, strength: f64, speed: f64, time: f64, dt: f64) -> f64 {
        if dt <= 0.0 || time <= 0.0 {
            return rise;
        }
        let gain = strength * speed / (self.area * self.capacity());
        (rise + dt * gain) / (1.0 + dt * self.loss(time))
    }

    /// Temperature rise by OpenSees' scheme: improved Euler with a first stage that never cools, and a second stage at
    /// the time after the step.
    pub fn warm_as_opensees(&self, rise: f64, strength: f64, speed: f64, time: f64, dt: f64) -> f64 {
        // At time 0 OpenSees multiplies an infinite loss by a zero rise.
        if time <= 0.0 {
            return rise;
        }
        let gain = strength * speed / (self.area * self.capacity());
        let first = (dt * (gain - rise * self.loss(time))).max(0.0);
        let second = dt * (gain - (rise + first) * self.loss(time + dt));
        rise + 0.5 * (first + second)
    }
}
