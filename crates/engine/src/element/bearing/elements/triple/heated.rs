//! Friction that depends on pressure, speed and the temperature from frictional heating.

use super::chain::ChainState;
use super::conduction::{Body, Conduction};
use super::history;
use crate::element::Histories;
use crate::element::bearing::laws::rubber::PI as ROUGHLY;
use crate::element::friction::Coefficient;
use crate::state_struct;
use crate::state_struct::StateStruct;
use std::f64::consts::PI;

/// Decrease of a coefficient of friction with the temperature. Source of this and the other factors: H. Kim and M. C.
/// Constantinou, Earthquake Engineering and Structural Dynamics (2023), doi 10.1002/eqe.3797.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Softening {
    /// To 1/2 at 200 °C.
    Half,
    /// To 1/3.
    Third,
    /// To 2/3.
    TwoThirds,
}

impl Softening {
    /// Factor at a temperature in °C; 1 at about 20 °C.
    pub fn factor(self, temperature: f64) -> f64 {
        let fall = |per_degree: f64| 0.7f64.powf(temperature * per_degree);
        match self {
            Self::Half => 0.789 * (fall(0.02) + 0.4),
            Self::Third => 0.9696 * fall(0.0289) + 0.2099,
            Self::TwoThirds => 0.8383 * fall(0.00851) + 0.2099,
        }
    }
}

/// Parameters of the coefficients of friction of the three pairs of surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatedSetting {
    /// Coefficients of friction at high speed, at the reference pressure and 20 °C: inner, lower outer, upper outer
    /// surfaces.
    pub mu: [f64; 3],
    /// Reference pressures p₀, with a factor 0.7^(0.02 (p - p₀)) and pressures in MPa; `None` for a factor of 1.
    pub reference: Option<[f64; 3]>,
    /// MPa per unit of pressure.
    pub mega_pascal: f64,
    /// Rate a (time/length), with a factor 1 - exp(-a v)/2; `None` for a factor of 1.
    pub rate: Option<f64>,
    /// Temperature factor; `None` for a factor of 1.
    pub softening: Option<Softening>,
    /// Contact radius of each pair.
    pub radius: [f64; 3],
    /// Initial temperature, °C.
    pub temperature: f64,
    /// Conduction behind the outer surfaces; the inner ones have a half-space.
    pub conduction: Conduction,
    /// Thickness of the plates behind the outer surfaces.
    pub thickness: [f64; 2],
    /// Displacement of the outer surfaces per displacement of their segment.
    pub outer: [f64; 2],
}

/// Surfaces with frictional heating.
///
/// The heat flux at the centre of a surface is μ p v while the slider covers the centre. It does so up to a
/// displacement of r √π / 2 (Kim and Constantinou, 2023). The flux heats the plate behind. The friction of a step has
/// the temperature at its start, and the pressure and speed at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heated {
    setting: HeatedSetting,
    area: [f64; 3],
    edge: [f64; 3],
}

state_struct! {
    /// State variables of the surfaces besides those of the heat history.
    pub(super) struct ThermalState {
        /// Time since the start.
        clock: f64,
        /// Domain time.
        time: f64,
        /// Number of steps since the start of the domain time, as OpenSees counts them.
        steps: f64,
        /// Coefficients of friction of the last step.
        mu_before: [f64; 3],
        /// Displacements of the surfaces at the last step.
        before: [f64; 6],
        /// Displacements of the inner, lower and upper surfaces: along x, then along y.
        slide: [f64; 6],
        /// Speeds in the order of the displacements.
        speed: [f64; 6],
        /// Temperatures, °C: of the three surfaces, then at the depths of the outer two.
        temperature: [f64; 5],
        /// Coefficients of friction.
        mu: [f64; 3],
        /// Heat fluxes, power/area.
        flux: [f64; 3],
        /// Factors of the coefficients: for pressure, temperature, speed.
        factors: [f64; 9],
    }
}

/// Number of recorded state variables at the end of [`ThermalState`]: temperatures, coefficients, fluxes, factors.
pub(super) const PARAMETERS: usize = 20;
/// Column names of the recorded state variables.
pub(super) const PARAMETER_NAMES: [&str; PARAMETERS] = [
    "Temp2 and 3",
    "Temp1",
    "Temp4",
    "Temp1 at depth",
    "Temp4 at depth",
    "COF 2 and 3",
    "COF1",
    "COF4",
    "HEATFLUX 2 and 3",
    "HEATFLUX1",
    "HEATFLUX4",
    "kpF 2 and 3",
    "kpF 1",
    "kpF 4",
    "kTF 2 and 3",
    "kTF 1",
    "kTF 4",
    "kVF 2 and 3",
    "kVF 1",
    "kVF 4",
];

/// Domain time of a step, and its increment.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub(super) time: f64,
    pub(super) dt: f64,
}

/// Sizes of the displacements or speeds of the three surfaces.
fn norms(v: &[f64; 6]) -> [f64; 3] {
    std::array::from_fn(|i| v[i].hypot(v[3 + i]))
}

impl Heated {
    /// Number of state variables.
    pub(super) const LEN: usize = ThermalState::LEN + 3 * history::LEN;

    /// Makes the surfaces of their parameters.
    pub fn new(setting: HeatedSetting) -> Self {
        // OpenSees' values of π.
        let (pi, quarter) = if setting.conduction.compat { (ROUGHLY, 22.0 / 28.0) } else { (PI, 0.25 * PI) };
        let area = setting.radius.map(|r| pi * r * r);
        Self { setting, area, edge: setting.radius.map(|r| r * quarter.sqrt()) }
    }

    /// Initial coefficients of friction at zero speed and the reference pressures. OpenSees uses [`Softening::Half`]
    /// for them with every temperature model.
    pub fn at_rest(&self) -> [f64; 3] {
        let s = &self.setting;
        let softening = if s.conduction.compat { s.softening.map(|_| Softening::Half) } else { s.softening };
        let share = softening.map_or(1.0, |m| m.factor(s.temperature)) * self.by_speed(0.0);
        s.mu.map(|mu| mu * share)
    }

    pub(super) fn init(&self, state: &mut [f64]) {
        let mu = self.at_rest();
        let mut w =
            ThermalState { mu_before: mu, mu, temperature: [self.setting.temperature; 5], ..ThermalState::default() };
        w.factors = [1.0; 9];
        w.write(state);
        state[ThermalState::LEN..Self::LEN].fill(0.0);
    }

    fn by_pressure(&self, i: usize, normal: f64) -> f64 {
        let s = &self.setting;
        s.reference.map_or(1.0, |p0| 0.7f64.powf(0.02 * s.mega_pascal * (normal / self.area[i] - p0[i])))
    }

    fn by_speed(&self, speed: f64) -> f64 {
        self.setting.rate.map_or(1.0, |a| 1.0 - 0.5 * (-a * speed).exp())
    }

    fn by_temperature(&self, temperature: f64) -> f64 {
        self.setting.softening.map_or(1.0, |m| m.factor(temperature))
    }

    /// Coefficient of pair `i` at a normal force > 0 and a speed, with the temperature of the state.
    pub(super) fn coefficient(&self, w: &ThermalState, i: usize, normal: f64, speed: f64) -> Coefficient {
        let s = &self.setting;
        let share = s.mu[i] * self.by_pressure(i, normal) * self.by_temperature(w.temperature[i]);
        let mu = share * self.by_speed(speed);
        let by_normal = s.reference.map_or(0.0, |_| mu * 0.7f64.ln() * 0.02 * s.mega_pascal / self.area[i]);
        let by_speed = s.rate.map_or(0.0, |a| share * 0.5 * a * (-a * speed).exp());
        Coefficient { mu, by_normal, by_speed }
    }

    /// Displacements of the surfaces from those of the segments. The inner pair shares the difference to the total.
    fn slide(&self, d: &[f64; 6]) -> [f64; 6] {
        let mut out = [0.0; 6];
        for k in 0..2 {
            let outer: [f64; 2] = std::array::from_fn(|i| self.setting.outer[i] * d[2 * (i + 1) + k]);
            let inner = d[k] + d[2 + k] + d[4 + k] - (outer[0] + outer[1]);
            (out[3 * k], out[3 * k + 1], out[3 * k + 2]) = (0.5 * inner, outer[0], outer[1]);
        }
        out
    }

    /// Heat flux of pair `i`.
    fn flux(&self, i: usize, mu: f64, normal: f64, (displacement, speed): (f64, f64)) -> f64 {
        if displacement < self.edge[i] { mu * normal / self.area[i] * speed } else { 0.0 }
    }

    /// Temperatures at surface and depth from a heat history, with the age of each amount, and an additional amount.
    fn temperatures(
        &self,
        i: usize,
        heat: &[f64],
        age: impl Fn(f64) -> f64,
        additional: Option<(f64, f64)>,
    ) -> [f64; 2] {
        let s = &self.setting;
        let conduction = if i == 0 { Conduction { body: Body::HalfSpace, ..s.conduction } } else { s.conduction };
        let thickness = s.thickness[i.saturating_sub(1)];
        let mut out = [s.temperature; 2];
        for (tau, q) in history::heat(heat).map(|(t, q)| (age(t), q)).chain(additional) {
            let k = conduction.rise(thickness, tau);
            (out[0], out[1]) = (out[0] + q * k[0], out[1] + q * k[1]);
        }
        out
    }

    fn heat_history(state: &[f64], i: usize) -> &[f64] {
        &state[ThermalState::LEN + i * history::LEN..ThermalState::LEN + (i + 1) * history::LEN]
    }

    fn set_temperature(w: &mut ThermalState, i: usize, [surface, depth]: [f64; 2]) {
        w.temperature[i] = surface;
        if i > 0 {
            w.temperature[2 + i] = depth;
        }
    }

    /// Update after a step: displacements follow the chain, the heat is added to the history, and temperatures follow.
    /// Heat is uniform over the step. The history stores it at two Gauss points. The temperature of this step uses the
    /// one-point rule for a kernel of 1/√τ.
    pub(super) fn warm(&self, chain: &ChainState, normal: f64, step: Step, h: &mut Histories<'_>) {
        let c = ThermalState::read(h.committed);
        let mut w = ThermalState { before: c.slide, slide: self.slide(&chain.d), mu: chain.mu, mu_before: c.mu, ..c };
        h.trial[ThermalState::LEN..Self::LEN].copy_from_slice(&h.committed[ThermalState::LEN..Self::LEN]);
        if step.dt > 0.0 {
            let dt = step.dt;
            w.speed = std::array::from_fn(|i| (w.slide[i] - c.slide[i]) / dt);
            (w.clock, w.time) = (c.clock + dt, step.time);
            let (displacements, speed) = (norms(&w.slide), norms(&w.speed));
            for i in 0..3 {
                w.flux[i] = self.flux(i, w.mu[i], normal, (displacements[i], speed[i]));
                let latest = (w.flux[i] > 0.0).then_some((dt / 3.0, 2.0 / 3f64.sqrt() * dt * w.flux[i]));
                let now = self.temperatures(i, Self::heat_history(h.committed, i), |t| w.clock - t, latest);
                Self::set_temperature(&mut w, i, now);
                let (middle, gauss_offset, half) = (w.clock - 0.5 * dt, dt / 12f64.sqrt(), 0.5 * dt * w.flux[i]);
                let heat =
                    &mut h.trial[ThermalState::LEN + i * history::LEN..ThermalState::LEN + (i + 1) * history::LEN];
                history::push(heat, [middle - gauss_offset, half, middle + gauss_offset, half]);
                w.factors[i] = self.by_pressure(i, normal);
                w.factors[3 + i] = self.by_temperature(c.temperature[i]);
                let at_zero_speed = self.setting.mu[i] * w.factors[i] * w.factors[3 + i];
                w.factors[6 + i] = if at_zero_speed > 0.0 { w.mu[i] / at_zero_speed } else { 1.0 };
            }
        }
        w.write(h.trial);
    }

    /// Coefficients of friction by OpenSees' scheme, before the step. They depend on displacements, speeds and normal
    /// force at its start, and on the coefficients of two steps before. The first step of a new domain time has the
    /// reference coefficients. Heat lies at the end of its step, with an age of at least the step.
    pub(super) fn warm_first(&self, normal: f64, step: Step, h: &mut Histories<'_>) -> [f64; 3] {
        let c = ThermalState::read(h.committed);
        let mut w = ThermalState { before: c.slide, mu_before: c.mu, time: step.time, ..c };
        h.trial[ThermalState::LEN..Self::LEN].copy_from_slice(&h.committed[ThermalState::LEN..Self::LEN]);
        if step.time < c.time {
            h.trial[ThermalState::LEN..Self::LEN].fill(0.0);
            (w.clock, w.steps, w.factors) = (0.0, 1.0, [1.0; 9]);
        } else if step.time > c.time {
            w.clock = c.clock + step.dt;
            let (displacements, speed) = (norms(&c.slide), norms(&c.speed));
            for i in 0..3 {
                w.flux[i] = self.flux(i, c.mu_before[i], normal, (displacements[i], speed[i]));
                let heat =
                    &mut h.trial[ThermalState::LEN + i * history::LEN..ThermalState::LEN + (i + 1) * history::LEN];
                history::push(heat, [w.clock, step.dt * w.flux[i], w.clock, 0.0]);
                let warms = c.steps > 1.0 && displacements[i] > 1e-11;
                let now = if warms {
                    self.temperatures(i, heat, |t| w.clock - t + step.dt, None)
                } else {
                    [self.setting.temperature; 2]
                };
                Self::set_temperature(&mut w, i, now);
                w.factors[i] = self.by_pressure(i, normal);
                w.factors[3 + i] = self.by_temperature(w.temperature[i]);
                w.factors[6 + i] = self.by_speed(speed[i]);
            }
            w.steps = c.steps + 1.0;
        }
        w.mu = std::array::from_fn(|i| self.setting.mu[i] * w.factors[i] * w.factors[3 + i] * w.factors[6 + i]);
        w.write(h.trial);
        w.mu
    }

    /// Displacements and speeds of the surfaces by OpenSees' scheme, after the step. The inner displacements lag by one
    /// step; speeds are differences over two steps.
    pub(super) fn slide_late(&self, (chain, last): (&ChainState, &ChainState), step: Step, h: &mut Histories<'_>) {
        let (c, mut w) = (ThermalState::read(h.committed), ThermalState::read(h.trial));
        let (now, late) = (self.slide(&chain.d), self.slide(&last.d));
        w.slide = std::array::from_fn(|i| if i % 3 == 0 { late[i] } else { now[i] });
        if step.dt > 0.0 {
            // Outer speeds are kept if nothing moves.
            let moves = chain.u != last.u;
            for i in (0..6).filter(|i| i % 3 == 0 || moves) {
                w.speed[i] = (w.slide[i] - c.before[i]) / (2.0 * step.dt);
            }
        }
        w.write(h.trial);
    }
}
