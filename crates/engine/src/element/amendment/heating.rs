//! Self-heating: dissipated energy raises the temperature and lowers stiffness and strength.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementError;
use std::sync::LazyLock;

/// Number of rates in the spectrum of conduction, one a decade, in units of 1/τ_c. `LOWEST_DECADE` is the decadic exponent of
/// the lowest.
const RATE_COUNT: usize = 9;
const LOWEST_DECADE: i32 = -5;

/// Temperature rise θ by the work W of the hysteretic part, dθ = dW / C - θ dt / τ, and the factor s = exp(-b θ). The
/// form is a lumped one of Kalpakidis and Constantinou, J. Struct. Eng. 135 (2009).
///
/// With conduction, the device is in contact with a half-space. A heat pulse then decays as exp(t/τ_c) erfc(√(t/τ_c))
/// with τ_c = (C/A)² / (k ρ c). A is the contact area; k and ρ c are conductivity and heat capacity per volume of the
/// half-space. Source: Carslaw and Jaeger, Conduction of Heat in Solids, 1959, section 12.4. The spectrum of rates r of
/// this decay, 1/(π √r (1 + r)), is sampled at one rate per decade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heating {
    /// Coefficient b, 1/temperature.
    pub softening: f64,
    /// Heat capacity C, energy/temperature.
    pub capacity: f64,
    /// Cooling time τ; infinite without cooling.
    pub cooling: f64,
    /// Time τ_c of conduction; infinite without conduction.
    pub conduction: f64,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

crate::state_struct! {
    /// State variables.
    pub struct HeatingState {
        /// Temperature rise θ, one component for each rate of decay.
        rise: [f64; RATE_COUNT],
    }
}

/// Weights and rates of conduction, in 1/τ_c. With rates at equal distances of ln r the weight is √r/(1 + r),
/// normalised.
static SPECTRUM: LazyLock<[(f64, f64); RATE_COUNT]> = LazyLock::new(|| {
    let rates: [f64; RATE_COUNT] = std::array::from_fn(|k| 10f64.powi(LOWEST_DECADE + k as i32));
    let weights = rates.map(|r| r.sqrt() / (1.0 + r));
    let sum: f64 = weights.iter().sum();
    std::array::from_fn(|k| (weights[k] / sum, rates[k]))
});

impl Heating {
    /// Share of the heat and rate of decay (1/time) of each component of θ.
    fn components(&self) -> impl Iterator<Item = (f64, f64)> {
        let spectrum: &[(f64, f64)] = if self.conduction.is_finite() { &*SPECTRUM } else { &[(1.0, 0.0)] };
        spectrum.iter().map(|(weight, r)| (*weight, 1.0 / self.cooling + r / self.conduction))
    }

    /// Factor s at the temperature rise θ.
    fn factor(&self, rise: f64) -> f64 {
        (-self.softening * rise).exp()
    }
}

impl AmendmentLaw for Heating {
    type State = HeatingState;
    const NAME: &'static str = "heating";

    fn amend(
        &self,
        committed: &HeatingState,
        d: &DeformationState,
    ) -> Result<(AmendedForce, HeatingState), ElementError> {
        // Implicit cooling is stable for any step. The work is that of the force with the committed factor, so energy
        // balances to first order in the step.
        let committed_factor = self.factor(committed.rise.iter().sum());
        let heat = committed_factor * self.share.work(d) / self.capacity;
        let (mut next, mut slope) = (HeatingState::default(), 0.0);
        for ((weight, rate), (to, from)) in self.components().zip(next.rise.iter_mut().zip(&committed.rise)) {
            let decay = 1.0 / (1.0 + d.dt * rate);
            *to = decay * (from + weight * heat);
            slope += decay * weight * committed_factor / self.capacity;
        }
        let mut rise: f64 = next.rise.iter().sum();
        // Elastic unloading has negative work; θ stays at or above 0.
        if rise <= 0.0 {
            (next, rise, slope) = (HeatingState::default(), 0.0, 0.0);
        }
        let s = self.factor(rise);
        let amended = self.share.scale_by_work(d, s, -self.softening * s * slope);
        Ok((amended, next))
    }

    fn weakening(&self, committed: &HeatingState) -> Option<Weakening> {
        self.share.weakening(self.factor(committed.rise.iter().sum()))
    }

    fn depends_on_time(&self) -> bool {
        self.cooling.is_finite() || self.conduction.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::Heating;
    use crate::element::amendment::Share;

    /// Decay of a heat pulse is exp(x) erfc(√x). Reference values: tables of erfc (Abramowitz and Stegun, 1964, tables
    /// 7.1 and 7.3).
    #[test]
    fn a_pulse_spreads_in_a_half_space() {
        let share = Share::default();
        let h = Heating { softening: 0.01, capacity: 1.0, cooling: f64::INFINITY, conduction: 2.0, share };
        let pulse = |x: f64| h.components().map(|(weight, rate)| weight * (-rate * 2.0 * x).exp()).sum::<f64>();
        for (x, exact) in
            [(0.0, 1.0), (0.01, 0.89646), (0.1, 0.72358), (1.0, 0.42758), (10.0, 0.17058), (100.0, 0.05614)]
        {
            assert!((pulse(x) - exact).abs() < 0.01, "{x}: {} {exact}", pulse(x));
        }
    }
}
