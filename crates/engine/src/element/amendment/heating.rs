//! Self-heating: dissipated energy raises the temperature and lowers stiffness and strength.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementResult;
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
///
/// The middle of a sliding face is heated only while the slider covers it: at |e| below the half width of the slider. Source:
/// Constantinou and others, MCEER-07-0008 (2007); Kumar, Whittaker and Constantinou, Earthquake Eng. Struct. Dyn. 44 (2015).
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
    /// Half width of the sliding body; infinite where all of the work heats.
    pub half_width: f64,
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

    /// Share of a step in which the slider covers the middle of the face, on a path of uniform speed, with its derivative by
    /// the size of the trial deformation.
    fn covering(&self, d: &DeformationState) -> [f64; 2] {
        let (from, to) = (d.before[0].hypot(d.before[1]), d.amplitude());
        let (near, far) = (from.min(to), from.max(to));
        if far <= self.half_width {
            return [1.0, 0.0];
        }
        if near >= self.half_width {
            return [0.0, 0.0];
        }
        let length = far - near;
        let slope = if to > from { near - self.half_width } else { self.half_width - far };
        [(self.half_width - near) / length, slope / (length * length)]
    }

    /// Factor s at the temperature rise θ.
    fn factor(&self, rise: f64) -> f64 {
        (-self.softening * rise).exp()
    }
}

impl AmendmentLaw for Heating {
    type State = HeatingState;
    const NAME: &'static str = "heating";

    fn amend(&self, committed: &HeatingState, d: &DeformationState) -> ElementResult<(AmendedForce, HeatingState)> {
        // Implicit cooling is stable for any step. The work is that of the force with the committed factor, so energy
        // balances to first order in the step.
        let committed_factor = self.factor(committed.rise.iter().sum());
        let [covering, by_size] = self.covering(d);
        let heat = committed_factor * self.share.work(d) / self.capacity;
        let (mut next, mut slope) = (HeatingState::default(), 0.0);
        for ((weight, rate), (to, from)) in self.components().zip(next.rise.iter_mut().zip(&committed.rise)) {
            let decay = 1.0 / (1.0 + d.dt * rate);
            *to = decay * (from + covering * weight * heat);
            slope += decay * weight;
        }
        let mut rise: f64 = next.rise.iter().sum();
        // Elastic unloading has negative work; θ stays at or above 0.
        if rise <= 0.0 {
            (next, rise, slope) = (HeatingState::default(), 0.0, 0.0);
        }
        let s = self.factor(rise);
        let by_rise = -self.softening * s * slope;
        let by_deformation = match d.amplitude() {
            0.0 => [0.0; 2],
            size => d.e.map(|e| by_rise * heat * by_size * e / size),
        };
        let by_work = by_rise * covering * committed_factor / self.capacity;
        Ok((self.share.scale_by_work(d, s, by_work, by_deformation), next))
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
    use super::{Heating, HeatingState};
    use crate::element::amendment::{AmendmentLaw, DeformationState, Share};

    /// Decay of a heat pulse is exp(x) erfc(√x). Reference values: tables of erfc (Abramowitz and Stegun, 1964, tables
    /// 7.1 and 7.3).
    #[test]
    fn a_pulse_spreads_in_a_half_space() {
        let share = Share::default();
        let (cooling, half_width) = (f64::INFINITY, f64::INFINITY);
        let h = Heating { softening: 0.01, capacity: 1.0, cooling, conduction: 2.0, half_width, share };
        let pulse = |x: f64| h.components().map(|(weight, rate)| weight * (-rate * 2.0 * x).exp()).sum::<f64>();
        for (x, exact) in
            [(0.0, 1.0), (0.01, 0.89646), (0.1, 0.72358), (1.0, 0.42758), (10.0, 0.17058), (100.0, 0.05614)]
        {
            assert!((pulse(x) - exact).abs() < 0.01, "{x}: {} {exact}", pulse(x));
        }
    }

    /// Constant friction F heats over the path inside the half width alone: θ = F s / C.
    #[test]
    fn a_face_is_heated_where_the_slider_covers_it() {
        let (capacity, half_width, friction) = (1e3, 0.11, 10.0);
        let (cooling, conduction) = (f64::INFINITY, f64::INFINITY);
        let law = Heating { softening: 1e-6, capacity, cooling, conduction, half_width, share: Share::default() };
        let (mut state, mut before) = (HeatingState::default(), 0.0f64);
        let mut rise_at = |e: f64| {
            let q = friction * (e - before).signum();
            let d = DeformationState { e: [e, 0.0], before: [before, 0.0], q: [q, 0.0], dt: 0.1, ..Default::default() };
            (state, before) = (law.amend(&state, &d).expect("a response").1, e);
            state.rise.iter().sum::<f64>() * capacity / friction
        };
        for (e, inside) in
            [(0.1, 0.1), (0.13, 0.11), (0.2, 0.11), (0.0, 0.22), (-0.3, 0.33), (-0.12, 0.33), (-0.1, 0.34)]
        {
            let path = rise_at(e);
            assert!((path - inside).abs() < 1e-5, "{e}: {path} {inside}");
        }
    }
}
