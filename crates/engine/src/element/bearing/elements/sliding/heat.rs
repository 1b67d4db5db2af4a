//! Pendulum friction that depends on pressure, speed and the temperature from frictional heating.

use crate::element::Histories;
use crate::element::bearing::elements::triple::{Body, Conduction, Softening, history};
use crate::element::friction::{Coefficient, Contact, FrictionLaw};
use crate::numeric::norm;
use crate::state_struct;
use crate::state_struct::StateStruct;
use std::f64::consts::PI;

/// Initial temperature, °C.
const AMBIENT: f64 = 20.0;

/// Factors of the coefficient of friction: μ = μ₀ k_p k_T k_v. With pressures in MPa k_p = 0.7^(0.02 (p - p₀)), with T
/// in °C k_T = 0.789 (0.7^(0.02 T) + 0.4), and k_v = 1 - exp(-a v)/2. Source: M. Kumar, A. S. Whittaker and M. C.
/// Constantinou, "Characterizing friction in sliding isolation bearings", Earthquake Engineering and Structural
/// Dynamics 44 (2015).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatSetting {
    /// Coefficient μ₀ at high speed, at the reference pressure and 20 °C.
    pub mu: f64,
    /// Reference pressure p₀; `None` for k_p = 1.
    pub reference: Option<f64>,
    /// MPa per unit of pressure.
    pub mega_pascal: f64,
    /// Rate a, time/length; `None` for k_v = 1.
    pub rate: Option<f64>,
    /// False for k_T = 1.
    pub softens: bool,
    /// Contact radius of the slider.
    pub radius: f64,
    /// Thermal diffusivity (length²/time) and conductivity (power/(length °C)) of the plate, taken as a half-space.
    pub conduction: [f64; 2],
    /// OpenSees' constants, and its order of updates.
    pub compat: bool,
}

/// A surface with frictional heating. The heat flux at its centre is μ p v while the slider covers the centre, up to a
/// displacement of r √π / 2. It heats a half-space. The friction of a step has the temperature at its start, and the
/// pressure and speed at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heat {
    pub(super) setting: HeatSetting,
    conduction: Conduction,
    area: f64,
    edge: f64,
}

state_struct! {
    /// State variables of the surface besides those of the heat history.
    pub(super) struct ThermalState {
        /// Time since the start, domain time, and number of steps since then.
        clock: f64,
        time: f64,
        steps: f64,
        /// Displacement in up to two directions.
        u: [f64; 2],
        /// Temperature, °C.
        temperature: f64,
        /// Coefficient of friction.
        mu: f64,
        /// Heat flux, power/area.
        flux: f64,
        /// Factors k_p, k_T, k_v.
        factors: [f64; 3],
    }
}

impl Heat {
    /// Number of state variables.
    pub(super) const LEN: usize = ThermalState::LEN + history::LEN;

    /// Makes the surface of its parameters.
    pub fn new(setting: HeatSetting) -> Self {
        let pi = if setting.compat { 22.0 / 7.0 } else { PI };
        let [diffusivity, conductivity] = setting.conduction;
        let conduction = Conduction { body: Body::HalfSpace, diffusivity, conductivity, compat: setting.compat };
        let area = pi * setting.radius * setting.radius;
        Self { setting, conduction, area, edge: setting.radius * (0.25 * pi).sqrt() }
    }

    pub(super) fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        let factors = if self.setting.compat { [1.0; 3] } else { [1.0, self.softening(AMBIENT), self.by_speed(0.0)] };
        let mu = self.setting.mu * factors.iter().product::<f64>();
        ThermalState { temperature: AMBIENT, mu, factors, ..ThermalState::default() }.write(state);
    }

    fn by_pressure(&self, normal: f64) -> f64 {
        let s = &self.setting;
        s.reference.map_or(1.0, |p0| 0.7f64.powf(0.02 * s.mega_pascal * (normal / self.area - p0)))
    }

    fn by_speed(&self, speed: f64) -> f64 {
        self.setting.rate.map_or(1.0, |a| 1.0 - 0.5 * (-a * speed).exp())
    }

    fn softening(&self, temperature: f64) -> f64 {
        if self.setting.softens { Softening::Half.factor(temperature) } else { 1.0 }
    }

    /// Factor k_T for the temperature of a state.
    pub(super) fn share(&self, state: &[f64]) -> f64 {
        self.softening(ThermalState::read(state).temperature)
    }

    /// Heat flux at the displacement `u`.
    fn flux(&self, (mu, normal, speed): (f64, f64, f64), u: f64) -> f64 {
        if u < self.edge { mu * normal / self.area * speed } else { 0.0 }
    }

    /// Temperature from a heat history, with the age of each amount, and an additional amount.
    fn temperature_from(&self, heat: &[f64], age: impl Fn(f64) -> f64, additional: Option<(f64, f64)>) -> f64 {
        let all = history::heat(heat).map(|(t, q)| (age(t), q)).chain(additional);
        // The temperature at depth is unused.
        AMBIENT + all.map(|(tau, q)| q * self.conduction.rise(1.0, tau)[0]).sum::<f64>()
    }

    /// Update after a step: its heat is added to the history, and the temperature follows. Heat is uniform over the
    /// step. The history stores it at two Gauss points. The temperature of this step uses the one-point rule for a
    /// kernel of 1/√τ.
    pub(super) fn warm(&self, contact: &Contact, u: &[f64], dt: f64, h: &mut Histories<'_>) {
        let c = ThermalState::read(h.committed);
        let mut w = c;
        h.trial.copy_from_slice(h.committed);
        let n = u.len();
        w.u[..n].copy_from_slice(u);
        (w.mu, w.factors) = (contact.mu, [self.by_pressure(contact.normal), self.share(h.committed), 1.0]);
        let at_zero_speed = self.setting.mu * w.factors[0] * w.factors[1];
        w.factors[2] = if contact.normal > 0.0 && at_zero_speed > 0.0 {
            contact.mu / at_zero_speed
        } else {
            self.by_speed(contact.speed)
        };
        if dt > 0.0 {
            w.clock = c.clock + dt;
            let increment: [f64; 2] = std::array::from_fn(|i| w.u[i] - c.u[i]);
            w.flux = self.flux((w.mu, contact.normal, norm(&increment) / dt), norm(u));
            let heat = &mut h.trial[ThermalState::LEN..];
            let latest = (w.flux > 0.0).then_some((dt / 3.0, 2.0 / 3f64.sqrt() * dt * w.flux));
            w.temperature = self.temperature_from(heat, |t| w.clock - t, latest);
            let (middle, gauss_offset, half) = (w.clock - 0.5 * dt, dt / 12f64.sqrt(), 0.5 * dt * w.flux);
            history::push(heat, [middle - gauss_offset, half, middle + gauss_offset, half]);
        }
        w.write(h.trial);
    }

    /// Coefficient of friction by OpenSees' scheme. The factors of a step are those of its first trial state.
    ///
    /// The speed is that of the trial state, or at rest the displacement since the last step over the time. The heat
    /// has the coefficient of the last step. It lies at the end of its step, with an age of at least the step. The
    /// first step of a new domain time has factors of 1 and deletes the heat history.
    pub(super) fn warm_first(&self, (normal, speed): (f64, f64), u: &[f64], time: f64, state: &mut [f64]) -> f64 {
        let c = ThermalState::read(state);
        let mut w = c;
        let (own, heat) = state.split_at_mut(ThermalState::LEN);
        let again = (time - c.time).abs() < 1e-8 && c.steps > 0.0;
        if !again && time > c.time {
            let dt = time - c.time;
            let before = if c.steps == 0.0 { [0.0; 2] } else { c.u };
            w.u[..u.len()].copy_from_slice(u);
            let increment: [f64; 2] = std::array::from_fn(|i| w.u[i] - before[i]);
            let speed = if speed > 0.0 { speed } else { norm(&increment) / dt };
            let mu = self.setting.mu * c.factors.iter().product::<f64>();
            w.flux = self.flux((mu, normal, speed), norm(u));
            w.clock = c.clock + dt;
            history::push(heat, [w.clock, dt * w.flux, w.clock, 0.0]);
            let warms = c.steps > 1.0 && norm(u) > 0.0;
            w.temperature = if warms { self.temperature_from(heat, |t| w.clock - t + dt, None) } else { AMBIENT };
            w.factors = [self.by_pressure(normal), self.softening(w.temperature), self.by_speed(speed)];
            (w.time, w.steps) = (time, c.steps + 1.0);
        } else if !again {
            heat.fill(0.0);
            (w.clock, w.time, w.steps, w.factors) = (0.0, time, 1.0, [1.0; 3]);
        }
        w.mu = self.setting.mu * w.factors.iter().product::<f64>();
        w.write(own);
        w.mu
    }
}

/// The coefficient without k_T, which depends on the state.
impl FrictionLaw for Heat {
    fn name(&self) -> &'static str {
        "FPBearingPTV"
    }

    fn coefficient(&self, normal: f64, speed: f64) -> Coefficient {
        let s = &self.setting;
        let share = s.mu * self.by_pressure(normal);
        let mu = share * self.by_speed(speed);
        let by_normal = s.reference.map_or(0.0, |_| mu * 0.7f64.ln() * 0.02 * s.mega_pascal / self.area);
        let by_speed = s.rate.map_or(0.0, |a| share * 0.5 * a * (-a * speed).exp());
        Coefficient { mu, by_normal, by_speed }
    }

    fn depends_on_speed(&self) -> bool {
        self.setting.rate.is_some()
    }
}

const TEMPERATURE: u32 = 1;
const FACTORS: u32 = 2;
const COEFFICIENT: u32 = 3;
const FLUX: u32 = 4;

/// Responses of the surface: number and column names.
pub(super) fn probe(word: &str) -> Option<(u32, &'static [&'static str])> {
    Some(match word {
        "temperature" | "Temperature" | "temp" | "Temp" => (TEMPERATURE, &["TemperatureCenter"]),
        "MuFactors" | "mufactors" | "mufactor" | "FrictionFactors" => {
            (FACTORS, &["kPressure", "kTemperature", "kVelocity"])
        }
        "MuAdj" | "muadj" | "MuAdjusted" | "muadjusted" => (COEFFICIENT, &["MuAdjusted"]),
        "HeatFlux" | "heatflux" | "heatFlux" | "Heatflux" => (FLUX, &["HeatFluxCenter"]),
        _ => return None,
    })
}

/// Values of a response.
pub(super) fn read(id: u32, state: &[f64], out: &mut [f64]) {
    let w = ThermalState::read(state);
    match id {
        TEMPERATURE => out[0] = w.temperature,
        FACTORS => out.copy_from_slice(&w.factors),
        COEFFICIENT => out[0] = w.mu,
        _ => out[0] = w.flux,
    }
}
