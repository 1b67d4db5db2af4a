//! Friction that depends on pressure, speed and the temperature that the sliding makes.

use super::chain::ChainState;
use super::conduction::{Body, Conduction};
use super::history;
use crate::element::bearing::rubber::PI as ROUGHLY;
use crate::element::friction::Coefficient;
use crate::state_struct;
use crate::state_struct::StateStruct;
use std::f64::consts::PI;

/// How a coefficient of friction falls as the surface warms. H. Kim and M. C. Constantinou, Earthquake Engineering and Structural
/// Dynamics (2023), doi 10.1002/eqe.3797, from which the other factors are, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Softening {
    /// To a half at 200 °C.
    Half,
    /// To a third.
    Third,
    /// To two thirds.
    TwoThirds,
}

impl Softening {
    /// Factor at a temperature in °C: 1 at about 20 °C.
    pub fn factor(self, temperature: f64) -> f64 {
        let fall = |per_degree: f64| 0.7f64.powf(temperature * per_degree);
        match self {
            Self::Half => 0.789 * (fall(0.02) + 0.4),
            Self::Third => 0.9696 * fall(0.0289) + 0.2099,
            Self::TwoThirds => 0.8383 * fall(0.00851) + 0.2099,
        }
    }
}

/// What the coefficients of friction of the three pairs of surfaces are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatedSetting {
    /// Coefficients of friction at reference pressure, at speed, at 20 °C: inner, lower outer, upper outer surfaces.
    pub mu: [f64; 3],
    /// Reference pressures p0, where the pressure counts: the factor is 0.7^(0.02 (p - p0)) with pressures in MPa.
    pub reference: Option<[f64; 3]>,
    /// MPa per unit of pressure.
    pub mega_pascal: f64,
    /// Rate a per speed, where the speed counts: the factor is 1 - exp(-a v)/2.
    pub rate: Option<f64>,
    /// Where the temperature counts.
    pub softening: Option<Softening>,
    /// Radius of contact of each pair.
    pub radius: [f64; 3],
    /// Temperature at the beginning, °C.
    pub temperature: f64,
    /// Conduction behind the outer surfaces; behind the inner ones is a half space.
    pub conduction: Conduction,
    /// Thickness of the plates behind the outer surfaces.
    pub thickness: [f64; 2],
    /// Displacement of the outer surfaces per displacement of their segment.
    pub outer: [f64; 2],
}

/// Friction of surfaces that warm.
///
/// Friction makes the heat flux μ p v at the middle of a surface while the slider covers it, which is up to a displacement of
/// r √π / 2 (Kim and Constantinou, 2023); the flux warms the plate behind. The friction of a step is that of the temperature at its
/// beginning, and of pressure and speed at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heated {
    setting: HeatedSetting,
    area: [f64; 3],
    edge: [f64; 3],
}

state_struct! {
    /// History of the surfaces besides that of their heat.
    pub(super) struct Warm {
        /// Time since the beginning.
        clock: f64,
        /// Domain time.
        time: f64,
        /// Steps since the domain time began, as far as OpenSees counts them.
        steps: f64,
        /// Coefficients of friction of the step before.
        mu_before: [f64; 3],
        /// Displacements of the surfaces at the step before.
        before: [f64; 6],
        /// Displacements of the inner, lower and upper surfaces: those along x, those along y.
        slide: [f64; 6],
        /// Their speeds.
        speed: [f64; 6],
        /// Temperatures, °C: of the three surfaces, at the depths of the outer two.
        temperature: [f64; 5],
        /// Coefficients of friction.
        mu: [f64; 3],
        /// Heat fluxes, power/area.
        flux: [f64; 3],
        /// Factors of the coefficients: by pressure, by temperature, by speed.
        factors: [f64; 9],
    }
}

/// State variables that a recorder takes from the end of [`Warm`]: temperatures, coefficients, fluxes, factors.
pub(super) const PARAMETERS: usize = 20;
/// Names of these.
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

/// The time of a step: its domain time and how much of it has passed.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub(super) time: f64,
    pub(super) dt: f64,
}

/// Displacements or speeds of the three surfaces without their direction.
fn norms(v: &[f64; 6]) -> [f64; 3] {
    std::array::from_fn(|i| v[i].hypot(v[3 + i]))
}

impl Heated {
    /// State variables of history.
    pub(super) const LEN: usize = Warm::LEN + 3 * history::LEN;

    /// From its parameters.
    pub fn new(setting: HeatedSetting) -> Self {
        // OpenSees' constants.
        let (pi, quarter) = if setting.conduction.compat { (ROUGHLY, 22.0 / 28.0) } else { (PI, 0.25 * PI) };
        let area = setting.radius.map(|r| pi * r * r);
        Self { setting, area, edge: setting.radius.map(|r| r * quarter.sqrt()) }
    }

    /// Coefficients of friction at rest at the beginning, under the reference pressures. OpenSees takes [`Softening::Half`] for them
    /// whatever the model.
    pub fn at_rest(&self) -> [f64; 3] {
        let s = &self.setting;
        let softening = if s.conduction.compat { s.softening.map(|_| Softening::Half) } else { s.softening };
        let share = softening.map_or(1.0, |m| m.factor(s.temperature)) * self.by_speed(0.0);
        s.mu.map(|mu| mu * share)
    }

    pub(super) fn init(&self, words: &mut [f64]) {
        let mu = self.at_rest();
        let mut w = Warm { mu_before: mu, mu, temperature: [self.setting.temperature; 5], ..Warm::default() };
        w.factors = [1.0; 9];
        w.write(words);
        words[Warm::LEN..Self::LEN].fill(0.0);
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

    /// Coefficient of pair `i` under a normal force > 0 at a speed, at the temperature of the history.
    pub(super) fn coefficient(&self, w: &Warm, i: usize, normal: f64, speed: f64) -> Coefficient {
        let s = &self.setting;
        let share = s.mu[i] * self.by_pressure(i, normal) * self.by_temperature(w.temperature[i]);
        let mu = share * self.by_speed(speed);
        let by_normal = s.reference.map_or(0.0, |_| mu * 0.7f64.ln() * 0.02 * s.mega_pascal / self.area[i]);
        let by_speed = s.rate.map_or(0.0, |a| share * 0.5 * a * (-a * speed).exp());
        Coefficient { mu, by_normal, by_speed }
    }

    /// Displacements of the surfaces for those of the segments; what the outer ones leave is that of the inner two.
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

    /// Temperature at the surface and at depth, from heat at the times of a history and more of it.
    fn warmth(&self, i: usize, heat: &[f64], age: impl Fn(f64) -> f64, more: Option<(f64, f64)>) -> [f64; 2] {
        let s = &self.setting;
        let conduction = if i == 0 { Conduction { body: Body::HalfSpace, ..s.conduction } } else { s.conduction };
        let thickness = s.thickness[i.saturating_sub(1)];
        let mut out = [s.temperature; 2];
        for (tau, q) in history::heat(heat).map(|(t, q)| (age(t), q)).chain(more) {
            let k = conduction.rise(thickness, tau);
            (out[0], out[1]) = (out[0] + q * k[0], out[1] + q * k[1]);
        }
        out
    }

    fn heat_of(words: &[f64], i: usize) -> &[f64] {
        &words[Warm::LEN + i * history::LEN..Warm::LEN + (i + 1) * history::LEN]
    }

    fn set_temperature(w: &mut Warm, i: usize, [surface, depth]: [f64; 2]) {
        w.temperature[i] = surface;
        if i > 0 {
            w.temperature[2 + i] = depth;
        }
    }

    /// After a step: the surfaces move with the chain, the heat of the step is added, and the surfaces warm. The heat is spread
    /// evenly over the step: by Gauss' rule, the latest by that for a kernel of 1/√τ.
    pub(super) fn warm(&self, chain: &ChainState, normal: f64, step: Step, committed: &[f64], trial: &mut [f64]) {
        let c = Warm::read(committed);
        let mut w = Warm { before: c.slide, slide: self.slide(&chain.d), mu: chain.mu, mu_before: c.mu, ..c };
        trial[Warm::LEN..Self::LEN].copy_from_slice(&committed[Warm::LEN..Self::LEN]);
        if step.dt > 0.0 {
            let dt = step.dt;
            w.speed = std::array::from_fn(|i| (w.slide[i] - c.slide[i]) / dt);
            (w.clock, w.time) = (c.clock + dt, step.time);
            let (moved, speed) = (norms(&w.slide), norms(&w.speed));
            for i in 0..3 {
                w.flux[i] = self.flux(i, w.mu[i], normal, (moved[i], speed[i]));
                let latest = (w.flux[i] > 0.0).then_some((dt / 3.0, 2.0 / 3f64.sqrt() * dt * w.flux[i]));
                let now = self.warmth(i, Self::heat_of(committed, i), |t| w.clock - t, latest);
                Self::set_temperature(&mut w, i, now);
                let (middle, aside, half) = (w.clock - 0.5 * dt, dt / 12f64.sqrt(), 0.5 * dt * w.flux[i]);
                let heat = &mut trial[Warm::LEN + i * history::LEN..Warm::LEN + (i + 1) * history::LEN];
                history::push(heat, [middle - aside, half, middle + aside, half]);
                w.factors[i] = self.by_pressure(i, normal);
                w.factors[3 + i] = self.by_temperature(c.temperature[i]);
                let still = self.setting.mu[i] * w.factors[i] * w.factors[3 + i];
                w.factors[6 + i] = if still > 0.0 { w.mu[i] / still } else { 1.0 };
            }
        }
        w.write(trial);
    }

    /// OpenSees' way, before the step: the coefficients of a step follow from the displacements, speeds and the normal force at its begin
    /// and the coefficients of two steps before; the first step of a new domain time has the reference coefficients. Heat
    /// lies at the end of each step, and is as old as the step is long at least.
    pub(super) fn warm_first(&self, normal: f64, step: Step, committed: &[f64], trial: &mut [f64]) -> [f64; 3] {
        let c = Warm::read(committed);
        let mut w = Warm { before: c.slide, mu_before: c.mu, time: step.time, ..c };
        trial[Warm::LEN..Self::LEN].copy_from_slice(&committed[Warm::LEN..Self::LEN]);
        if step.time < c.time {
            trial[Warm::LEN..Self::LEN].fill(0.0);
            (w.clock, w.steps, w.factors) = (0.0, 1.0, [1.0; 9]);
        } else if step.time > c.time {
            w.clock = c.clock + step.dt;
            let (moved, speed) = (norms(&c.slide), norms(&c.speed));
            for i in 0..3 {
                w.flux[i] = self.flux(i, c.mu_before[i], normal, (moved[i], speed[i]));
                let heat = &mut trial[Warm::LEN + i * history::LEN..Warm::LEN + (i + 1) * history::LEN];
                history::push(heat, [w.clock, step.dt * w.flux[i], w.clock, 0.0]);
                let warms = c.steps > 1.0 && moved[i] > 1e-11;
                let now = if warms {
                    self.warmth(i, heat, |t| w.clock - t + step.dt, None)
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
        w.write(trial);
        w.mu
    }

    /// OpenSees' way, after the step: displacements and speeds of the surfaces, those of the inner ones a step late; speeds over two steps.
    pub(super) fn slide_late(
        &self,
        (chain, last): (&ChainState, &ChainState),
        step: Step,
        committed: &[f64],
        trial: &mut [f64],
    ) {
        let (c, mut w) = (Warm::read(committed), Warm::read(trial));
        let (now, late) = (self.slide(&chain.d), self.slide(&last.d));
        w.slide = std::array::from_fn(|i| if i % 3 == 0 { late[i] } else { now[i] });
        if step.dt > 0.0 {
            // Outer speeds stay where nothing moves.
            let moves = chain.u != last.u;
            for i in (0..6).filter(|i| i % 3 == 0 || moves) {
                w.speed[i] = (w.slide[i] - c.before[i]) / (2.0 * step.dt);
            }
        }
        w.write(trial);
    }
}
