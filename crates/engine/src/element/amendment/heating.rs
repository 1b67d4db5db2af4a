//! Self-heating: dissipated work warms the device and softens it.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementError;
use std::sync::LazyLock;

/// Rates over 1/τ_c by which heat is conducted away, one a decade; the lowest is 10 to this power.
const RATES: usize = 9;
const LOWEST: i32 = -5;

/// Temperature rise θ by the work of the hysteretic part, dθ = dW / C - θ dt / τ, and the factor s = exp(-b θ):
/// a lumped form of Kalpakidis and Constantinou, J. Struct. Eng. 135 (2009).
///
/// A core or a face of sliding that lies on a body much larger than itself does not cool to the temperature of its surroundings with one
/// time constant: the heat goes on spreading in that body. What is left of a heat pulse after a time t is then
/// exp(t/τ_c) erfc(√(t/τ_c)), with τ_c = (C/A)² / (k ρ c) of the area A of contact and the conductivity and heat capacity of the body
/// (Carslaw and Jaeger, Conduction of Heat in Solids, 1959, section 12.4): one half-space. Its spectrum of rates
/// r, 1/(π √r (1 + r)), is taken at one rate a decade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heating {
    /// Softening b per degree.
    pub softening: f64,
    /// Heat capacity C, work per degree.
    pub capacity: f64,
    /// Cooling time τ; infinite where no heat is lost.
    pub cooling: f64,
    /// Time τ_c of conduction; infinite where no heat is conducted away.
    pub conduction: f64,
    /// What it acts on.
    pub share: Share,
}

crate::state_struct! {
    /// History.
    pub struct Warmth {
        /// Temperature rise θ, in parts that decay by the rates of conduction.
        rise: [f64; RATES],
    }
}

/// Weights and rates of conduction, in 1/τ_c. The step from one rate to the next is even in the logarithm: the weight is √r/(1 + r).
static SPECTRUM: LazyLock<[(f64, f64); RATES]> = LazyLock::new(|| {
    let rates: [f64; RATES] = std::array::from_fn(|k| 10f64.powi(LOWEST + k as i32));
    let weights = rates.map(|r| r.sqrt() / (1.0 + r));
    let sum: f64 = weights.iter().sum();
    std::array::from_fn(|k| (weights[k] / sum, rates[k]))
});

impl Heating {
    /// Parts of the heat with their rates of decay, 1/time.
    fn parts(&self) -> impl Iterator<Item = (f64, f64)> {
        let spectrum: &[(f64, f64)] = if self.conduction.is_finite() { &*SPECTRUM } else { &[(1.0, 0.0)] };
        spectrum.iter().map(|(weight, r)| (*weight, 1.0 / self.cooling + r / self.conduction))
    }

    /// s at a temperature rise.
    fn factor(&self, rise: f64) -> f64 {
        (-self.softening * rise).exp()
    }
}

impl AmendmentLaw for Heating {
    type State = Warmth;
    const NAME: &'static str = "heating";

    fn amend(&self, committed: &Warmth, d: &DeformationState) -> Result<(AmendedForce, Warmth), ElementError> {
        // Cooling implicitly: stable for any step. The work is that of the softened force of the step before, so that
        // the energy account closes to first order in the step.
        let now = self.factor(committed.rise.iter().sum());
        let heat = now * self.share.work(d) / self.capacity;
        let (mut next, mut slope) = (Warmth::default(), 0.0);
        for ((weight, rate), (to, from)) in self.parts().zip(next.rise.iter_mut().zip(&committed.rise)) {
            let keep = 1.0 / (1.0 + d.dt * rate);
            *to = keep * (from + weight * heat);
            slope += keep * weight * now / self.capacity;
        }
        let mut rise: f64 = next.rise.iter().sum();
        // Unloading gives work back: below the surroundings it never gets.
        if rise <= 0.0 {
            (next, rise, slope) = (Warmth::default(), 0.0, 0.0);
        }
        let s = self.factor(rise);
        let amended = self.share.scale_by_work(d, s, -self.softening * s * slope);
        Ok((amended, next))
    }

    fn weakening(&self, committed: &Warmth) -> Option<Weakening> {
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

    /// What is left of a pulse is exp(x) erfc(√x): values from tables of erfc (Abramowitz and Stegun, 1964, tables 7.1 and 7.3).
    #[test]
    fn a_pulse_spreads_in_a_half_space() {
        let share = Share::default();
        let h = Heating { softening: 0.01, capacity: 1.0, cooling: f64::INFINITY, conduction: 2.0, share };
        let left = |x: f64| h.parts().map(|(weight, rate)| weight * (-rate * 2.0 * x).exp()).sum::<f64>();
        for (x, exact) in
            [(0.0, 1.0), (0.01, 0.89646), (0.1, 0.72358), (1.0, 0.42758), (10.0, 0.17058), (100.0, 0.05614)]
        {
            assert!((left(x) - exact).abs() < 0.01, "{x}: {} {exact}", left(x));
        }
    }
}
